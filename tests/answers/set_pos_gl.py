"""Answers to set_pos_gl(frames, pose): right ones in honest styles, wrong ones as students write them."""

import cmath
import copy
import math
import warnings

import numpy as np


def compose(a, b):
    c, s = math.cos(a[2]), math.sin(a[2])
    return np.array([a[0] + c * b[0] - s * b[1], a[1] + s * b[0] + c * b[1], a[2] + b[2]])


def invert(a):
    c, s = math.cos(a[2]), math.sin(a[2])
    return np.array([-c * a[0] - s * a[1], s * a[0] - c * a[1], -a[2]])


def transform(p):
    c, s = np.cos(p[2]), np.sin(p[2])
    return np.array([[c, -s, p[0]], [s, c, p[1]], [0.0, 0.0, 1.0]])


def pose_of(m):
    return m[0, 2], m[1, 2], math.atan2(m[1, 0], m[0, 0])


def by_compose(frames, pose):
    new = dict(frames)
    new["GL"] = compose(frames["FS"], invert(pose))
    return new


def matrices(frames, pose):
    return {**frames, "GL": pose_of(transform(frames["FS"]) @ np.linalg.inv(transform(pose)))}


def deep_copy(frames, pose):
    print("set", pose)
    warnings.warn("copying", stacklevel=1)
    new = copy.deepcopy(frames)
    theta = frames["FS"][2] - pose[2]
    new["GL"] = [
        frames["FS"][0] - math.cos(theta) * pose[0] + math.sin(theta) * pose[1],
        frames["FS"][1] - math.sin(theta) * pose[0] - math.cos(theta) * pose[1],
        theta % math.tau,
    ]
    return new


def tuples_in_another_order(frames, pose):
    new = {name: tuple(float(number) for number in frames[name]) for name in ("SP", "LC", "FS")}
    way = cmath.rect(1, frames["FS"][2] - pose[2])
    origin = complex(*new["FS"][:2]) - complex(pose[0], pose[1]) * way
    return new | {"GL": (origin.real, origin.imag, cmath.phase(way))}


def single_precision(frames, pose):
    new = {name: np.array(frame, dtype=np.float32) for name, frame in frames.items()}
    new["GL"] = np.float32(compose(new["FS"], invert(np.array(pose, dtype=np.float32))))
    return new


class SetGL:
    def __call__(self, frames, pose):
        gl = np.linalg.solve(transform(pose).T, transform(frames["FS"]).T).T
        return {name: (pose_of(gl) if name == "GL" else list(frame)) for name, frame in frames.items()}


RIGHT = {
    "invert and compose": by_compose,
    "matrices": matrices,
    "formula, deep copy, prints and warns": deep_copy,
    "complex, tuples, another order": tuples_in_another_order,
    "float32": single_precision,
    "object, solved": SetGL(),
}


def changes_the_dict(frames, pose):
    frames["GL"] = compose(frames["FS"], invert(pose))
    return frames


def changes_the_array(frames, pose):
    new = dict(frames)
    new["GL"][:] = compose(frames["FS"], invert(pose))
    return new


def changes_and_returns_nothing(frames, pose):
    frames["GL"] = compose(frames["FS"], invert(pose))


def compose_not_inverted(frames, pose):
    return {**frames, "GL": compose(frames["FS"], pose)}


def order(frames, pose):
    return {**frames, "GL": pose_of(np.linalg.inv(transform(pose)) @ transform(frames["FS"]))}


def transposed(frames, pose):
    return {**frames, "GL": pose_of(transform(frames["FS"]) @ transform(pose).T)}


def negated(frames, pose):
    return {**frames, "GL": compose(frames["FS"], -np.array(pose))}


def differences(frames, pose):
    return {**frames, "GL": [f - p for f, p in zip(frames["FS"], pose, strict=True)]}


def shifted_by_the_error(frames, pose):
    """GL moved by the difference between where the robot appears and where it should."""
    appears = compose(invert(frames["GL"]), frames["FS"])
    return {**frames, "GL": np.asarray(frames["GL"]) + appears - np.asarray(pose)}


def error_composed(frames, pose):
    appears = compose(invert(frames["GL"]), frames["FS"])
    return {**frames, "GL": compose(frames["GL"], compose(invert(pose), appears))}


def robot(frames, pose):
    return {**frames, "FS": compose(frames["GL"], pose)}


def robot_in_gl(frames, pose):
    return {**frames, "FS": list(pose)}


def adjust(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(gl, compose(invert(frames["GL"]), frames["SP"]))}


def lc_stays(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "LC": compose(invert(gl), compose(frames["GL"], frames["LC"]))}


def lc_in_bs(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "LC": compose(gl, frames["LC"])}


def old_names(frames, pose):
    return {"gl": compose(frames["FS"], invert(pose)), "fs": frames["FS"], "sp": frames["SP"], "lc": frames["LC"]}


def list_of_poses(frames, pose):
    return [compose(frames["FS"], invert(pose)), frames["LC"], frames["FS"], frames["SP"]]


def sp_left_out(frames, pose):
    return {"GL": compose(frames["FS"], invert(pose)), "LC": frames["LC"], "FS": frames["FS"]}


def matrix_in_the_dict(frames, pose):
    return {**frames, "GL": transform(frames["FS"]) @ np.linalg.inv(transform(pose))}


def sp_emptied(frames, pose):
    return {**frames, "GL": compose(frames["FS"], invert(pose)), "SP": np.zeros(3)}


def fs_emptied(frames, pose):
    return {**frames, "GL": compose(frames["FS"], invert(pose)), "FS": np.zeros(3)}


def at_the_origin_of_bs(frames, pose):
    return {**frames, "GL": invert(pose)}


WRONG = {
    "changes the dict": (changes_the_dict, "caller's dict", "plain"),
    "changes the array": (changes_the_array, "shallow copy; tuples and lists too", "subtle"),
    "changes, returns nothing": (changes_and_returns_nothing, "no return", "plain"),
    "FS o pose": (compose_not_inverted, "not inverted", "plain"),
    "pose^-1 o FS": (order, "order", "plain"),
    "transposed": (transposed, "T' for the inverse", "subtle"),
    "-pose": (negated, "negated for inverted", "plain"),
    "FS - pose": (differences, "component by component", "plain"),
    "GL + error": (shifted_by_the_error, "differences added to GL", "subtle"),
    "error composed": (error_composed, "GL o pose^-1 o FS in GL", "subtle"),
    "FS moved": (robot, "the robot moved in BS", "plain"),
    "FS = pose": (robot_in_gl, "pose stored as FS", "plain"),
    "adjust": (adjust, "SP moved as well", "plain"),
    "LC stays in BS": (lc_stays, "LC does not ride on GL", "plain"),
    "LC in BS": (lc_in_bs, "LC composed once more", "subtle"),
    "small letters": (old_names, "other keys", "plain"),
    "list": (list_of_poses, "no dict", "plain"),
    "SP left out": (sp_left_out, "entry missing", "plain"),
    "matrix": (matrix_in_the_dict, "(3, 3) in the dict", "plain"),
    "SP emptied": (sp_emptied, "the line is lost", "subtle"),
    "FS emptied": (fs_emptied, "FS reset to zero", "subtle"),
    "FS at the origin": (at_the_origin_of_bs, "GL = pose^-1", "plain"),
}

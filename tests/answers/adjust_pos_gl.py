"""Answers to adjust_pos_gl(frames, pose): right ones in honest styles, wrong ones as students write them."""

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
    gl = compose(frames["FS"], invert(pose))
    sp = compose(gl, compose(invert(frames["GL"]), frames["SP"]))
    return {**frames, "GL": gl, "SP": sp}


def matrices(frames, pose):
    motion = transform(frames["FS"]) @ np.linalg.inv(transform(pose)) @ np.linalg.inv(transform(frames["GL"]))
    return {**frames, **{name: pose_of(motion @ transform(frames[name])) for name in ("GL", "SP")}}


def motion_of_bs(frames, pose):
    """The rigid motion of BS that carries the wanted place to the robot."""
    wanted = compose(frames["GL"], pose)
    motion = compose(frames["FS"], invert(wanted))
    new = copy.deepcopy(frames)
    for name in ("GL", "SP"):
        new[name] = list(compose(motion, frames[name]))
        new[name][2] %= 2 * math.pi
    return new


def as_in_yp_spur(frames, pose):
    """FS appears in the new SP where the wanted pose appeared in the old one."""
    print("adjust", pose)
    warnings.warn("swerving", stacklevel=1)
    in_sp = compose(invert(frames["SP"]), compose(frames["GL"], pose))
    return {
        "SP": tuple(compose(frames["FS"], invert(in_sp))),
        "FS": tuple(frames["FS"]),
        "LC": tuple(frames["LC"]),
        "GL": tuple(compose(frames["FS"], invert(pose))),
    }


def single_precision(frames, pose):
    new = {name: np.array(frame, dtype=np.float32) for name, frame in frames.items()}
    moved = by_compose(new, np.array(pose, dtype=np.float32))
    return {name: np.float32(frame) for name, frame in moved.items()}


class Adjust:
    def __call__(self, frames, pose):
        turn = frames["FS"][2] - pose[2] - frames["GL"][2]
        gl = complex(*frames["GL"][:2])
        wanted = gl + complex(pose[0], pose[1]) * cmath.rect(1, frames["GL"][2])
        new = dict(frames)
        for name in ("GL", "SP"):
            x, y, theta = frames[name]
            z = complex(*frames["FS"][:2]) + (complex(x, y) - wanted) * cmath.rect(1, turn)
            new[name] = z.real, z.imag, theta + turn
        return new


RIGHT = {
    "invert and compose": by_compose,
    "matrices": matrices,
    "rigid motion, lists, 0 to 2 pi": motion_of_bs,
    "as in YP-Spur, tuples, prints and warns": as_in_yp_spur,
    "float32": single_precision,
    "object, complex": Adjust(),
}


def only_set(frames, pose):
    return {**frames, "GL": compose(frames["FS"], invert(pose))}


def cancelled(frames, pose):
    new = dict(frames)
    new["GL"] = compose(new["FS"], invert(pose))
    new["SP"] = compose(new["GL"], compose(invert(new["GL"]), new["SP"]))
    return new


def changes_the_dict(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    frames["SP"] = compose(gl, compose(invert(frames["GL"]), frames["SP"]))
    frames["GL"] = gl
    return frames


def opposite(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(frames["GL"], compose(invert(gl), frames["SP"]))}


def sp_new_gl(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": gl}


def sp_at_the_robot(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": frames["FS"]}


def sp_at_the_pose(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": pose}


def lc_too(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    motion = compose(gl, invert(frames["GL"]))
    return {**frames, "GL": gl, "SP": compose(motion, frames["SP"]), "LC": compose(motion, frames["LC"])}


def robot_too(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    motion = compose(gl, invert(frames["GL"]))
    return {name: frame if name == "LC" else compose(motion, frame) for name, frame in frames.items()}


def transposed(frames, pose):
    motion = transform(frames["FS"]) @ transform(pose).T @ transform(frames["GL"]).T
    return {**frames, **{name: pose_of(motion @ transform(frames[name])) for name in ("GL", "SP")}}


def from_the_right(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(frames["SP"], compose(invert(frames["GL"]), gl))}


def numbers_shifted(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": np.add(frames["SP"], np.subtract(gl, frames["GL"]))}


def not_inverted(frames, pose):
    gl = compose(frames["FS"], pose)
    return {**frames, "GL": gl, "SP": compose(gl, compose(invert(frames["GL"]), frames["SP"]))}


def order(frames, pose):
    gl = compose(invert(pose), frames["FS"])
    return {**frames, "GL": gl, "SP": compose(gl, compose(invert(frames["GL"]), frames["SP"]))}


def sp_keeps_its_heading(frames, pose):
    new = by_compose(frames, pose)
    new["SP"][2] = frames["SP"][2]
    return new


def sp_by_set_of_its_own(frames, pose):
    """SP laid anew so that the robot appears at pose in it, as if set_pos_SP were called."""
    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(frames["FS"], invert(compose(invert(frames["SP"]), pose)))}


def sp_in_gl(frames, pose):
    gl = compose(frames["FS"], invert(pose))
    return {**frames, "GL": gl, "SP": compose(gl, frames["SP"])}


def sp_turned_in_place(frames, pose):
    new = by_compose(frames, pose)
    new["SP"][:2] = frames["SP"][:2]
    return new


def gl_stays(frames, pose):
    return {**frames, "SP": by_compose(frames, pose)["SP"]}


def pair(frames, pose):
    new = by_compose(frames, pose)
    return new["GL"], new["SP"]


def two_entries(frames, pose):
    new = by_compose(frames, pose)
    return {"GL": new["GL"], "SP": new["SP"]}


def nothing(frames, pose):
    frames = by_compose(frames, pose)


WRONG = {
    "set": (only_set, "SP not moved", "plain"),
    "cancelled": (cancelled, "GL overwritten first", "plain"),
    "changes the dict": (changes_the_dict, "caller's dict", "plain"),
    "opposite": (opposite, "old and new GL exchanged", "plain"),
    "SP = GL": (sp_new_gl, "the line starts at GL", "plain"),
    "SP = FS": (sp_at_the_robot, "the line starts at the robot", "plain"),
    "SP = pose": (sp_at_the_pose, "pose stored as SP", "plain"),
    "LC too": (lc_too, "LC moved as if in BS", "plain"),
    "FS too": (robot_too, "the robot carried along", "plain"),
    "transposed": (transposed, "T' for the inverse", "subtle"),
    "from the right": (from_the_right, "SP o GL^-1 o GL'", "plain"),
    "numbers shifted": (numbers_shifted, "component by component", "plain"),
    "not inverted": (not_inverted, "FS o pose", "plain"),
    "order": (order, "pose^-1 o FS", "plain"),
    "heading of SP kept": (sp_keeps_its_heading, "moved, not turned", "plain"),
    "SP set by itself": (sp_by_set_of_its_own, "pose taken in SP's parent", "subtle"),
    "SP in GL": (sp_in_gl, "SP taken as given in GL", "plain"),
    "SP turned in place": (sp_turned_in_place, "turned, not moved", "plain"),
    "GL stays": (gl_stays, "SP only", "plain"),
    "pair": (pair, "no dict", "plain"),
    "two entries": (two_entries, "entries missing", "plain"),
    "no return": (nothing, "no return", "plain"),
}

"""Answers to pose_step_matrix(pose, displacement): right ones in honest styles, wrong ones as students write them."""

import cmath
import math
import warnings

import numpy as np


def rotation(theta):
    c, s = np.cos(theta), np.sin(theta)
    return np.array([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def slide(pose, displacement):
    return rotation(pose[2]) @ displacement + pose


def columns(pose, displacement):
    p = np.array(pose, dtype=float).reshape(3, 1)
    return (rotation(pose[2]) @ np.array(displacement).reshape(3, 1) + p).flatten()


def written_out(pose, displacement):
    (x, y, theta), (u, v, phi) = pose, displacement
    return x + math.cos(theta) * u - math.sin(theta) * v, y + math.sin(theta) * u + math.cos(theta) * v, theta + phi


def double_loop(pose, displacement):
    matrix, new = rotation(pose[2]).tolist(), [float(value) for value in pose]
    for i in range(3):
        for j in range(3):
            new[i] += matrix[i][j] * displacement[j]
    return new


def complex_plane(pose, displacement):
    end = complex(*pose[:2]) + complex(*displacement[:2]) * cmath.rect(1, pose[2])
    print(end)
    return [end.real, end.imag, pose[2] + displacement[2]]


def homogeneous(pose, displacement):
    here, there = rotation(pose[2]), rotation(displacement[2])
    here[:2, 2], there[:2, 2] = pose[:2], displacement[:2]
    x, y = (here @ there)[:2, 2]
    return np.array([x, y, pose[2] + displacement[2]])


def row_times_transpose(pose, displacement):
    warnings.warn("row vectors", stacklevel=2)
    return np.asarray(displacement) @ rotation(pose[2]).T + np.asarray(pose)


def single_precision(pose, displacement):
    return np.einsum("ij,j->i", rotation(pose[2]), np.array(displacement, dtype=float)).astype("f4") + np.array(pose, "f4")


class Mover:
    def __init__(self, turn):
        self.turn = turn

    def __call__(self, pose, displacement):
        return np.add(pose, np.dot(self.turn(pose[2]), displacement))


RIGHT = {
    "as on the slide": slide,
    "columns, flattened": columns,
    "written out, tuple": written_out,
    "double loop, list": double_loop,
    "complex plane, prints": complex_plane,
    "homogeneous matrices": homogeneous,
    "row times transpose, warns": row_times_transpose,
    "einsum, float32": single_precision,
    "object that is called": Mover(rotation),
}


def row_times_matrix(pose, displacement):
    return np.asarray(displacement) @ rotation(pose[2]) + pose


def in_place(pose, displacement):
    pose += rotation(pose[2]) @ displacement
    return pose


def displacement_in_place(pose, displacement):
    displacement[:] = rotation(pose[2]) @ displacement
    return np.array(pose) + displacement


def inverse(pose, displacement):
    return np.linalg.solve(rotation(pose[2]), displacement) + pose


def negated_heading(pose, displacement):
    return rotation(-pose[2]) @ displacement + pose


def new_heading_for_sideways(pose, displacement):
    (x, y, theta), (u, v, phi) = pose, displacement
    new = theta + phi
    return np.array([x + np.cos(theta) * u - np.sin(new) * v, y + np.sin(theta) * u + np.cos(new) * v, new])


def heading_first(pose, displacement):
    p = np.array(pose, dtype=float)
    p[2] += displacement[2]
    p[:2] += rotation(p[2])[:2, :2] @ displacement[:2]
    return p


def absolute_sideways(pose, displacement):
    u, v, phi = displacement
    return rotation(pose[2]) @ [u, abs(v), phi] + pose


def absolute_forward(pose, displacement):
    u, v, phi = displacement
    return rotation(pose[2]) @ [abs(u), v, phi] + pose


def turned_about_the_origin(pose, displacement):
    moved = np.array(pose) + np.array(displacement)
    x, y = rotation(displacement[2])[:2, :2] @ moved[:2]
    return np.array([x, y, moved[2]])


def matrix_of_degrees(pose, displacement):
    return rotation(np.radians(pose[2])) @ displacement + pose


def wrapped_by_atan2(pose, displacement):
    moved = slide(pose, displacement)
    return [moved[0], moved[1], math.atan2(math.sin(moved[2]), math.cos(moved[2]))]


def added_to_every_row(pose, displacement):
    return (rotation(pose[2]) + np.array(pose)) @ displacement


def product_with_both(pose, displacement):
    return rotation(pose[2]) @ pose + rotation(pose[2]) @ displacement


def heading_twice(pose, displacement):
    return rotation(2 * pose[2]) @ displacement + pose


def sideways_times_turn(pose, displacement):
    u, v, phi = displacement
    return rotation(pose[2]) @ [u, v * phi, phi] + pose


def chord_shortened(pose, displacement):
    u, v, phi = displacement
    shrink = np.sinc(phi / (2 * np.pi))
    return rotation(pose[2]) @ [u * shrink, v * shrink, phi] + pose


def only_x(pose, displacement):
    return float(slide(pose, displacement)[0])


def stacked(pose, displacement):
    return slide(pose, displacement)[None, :]


def integers(pose, displacement):
    return slide(pose, displacement).astype(np.asarray(pose).dtype)


def only_arrays(pose, displacement):
    return rotation(pose[2]) @ displacement.reshape(3) + pose.reshape(3)


def four_decimals(pose, displacement):
    return np.around(slide(pose, displacement), 4)


def multiplied(pose, displacement):
    return np.sum(rotation(pose[2]) * np.array(displacement), axis=0) + pose


WRONG = {
    "row times matrix": (row_times_matrix, "the transpose", "plain"),
    "changes the pose": (in_place, "+= on the argument", "plain"),
    "changes the displacement": (displacement_in_place, "turned in place", "plain"),
    "solve": (inverse, "the inverse matrix", "plain"),
    "minus theta": (negated_heading, "the transpose", "plain"),
    "two headings": (new_heading_for_sideways, "v turned by the new heading", "subtle"),
    "heading first": (heading_first, "theta updated before the matrix", "plain"),
    "positive v": (absolute_sideways, "abs(v)", "subtle"),
    "positive u": (absolute_forward, "abs(u)", "subtle"),
    "about the origin": (turned_about_the_origin, "the sum turned by phi", "subtle"),
    "degrees": (matrix_of_degrees, "theta taken for degrees", "plain"),
    "wrapped": (wrapped_by_atan2, "theta within +-pi", "plain"),
    "pose in the matrix": (added_to_every_row, "(R + pose) @ d", "subtle"),
    "everything turned": (product_with_both, "R pose + R d", "plain"),
    "twice the heading": (heading_twice, "R(2 theta)", "subtle"),
    "v times phi": (sideways_times_turn, "v phi for v", "subtle"),
    "chord": (chord_shortened, "shortened as on an arc", "subtle"),
    "only x": (only_x, "one number", "plain"),
    "stacked": (stacked, "(1, 3)", "plain"),
    "dtype of the pose": (integers, "cut off for whole numbers", "plain"),
    "only arrays": (only_arrays, "a list has no reshape", "plain"),
    "four decimals": (four_decimals, "rounded", "subtle"),
    "summed the wrong way": (multiplied, "* and the sum over the wrong axis", "subtle"),
}

"""Answers to pose_step_arc(pose, distance, dtheta): right ones in honest styles, wrong ones as students write them."""

import cmath
import math

import numpy as np


def chord(pose, distance, dtheta):
    x, y, theta = pose
    length, way = distance * np.sinc(dtheta / 2 / np.pi), theta + dtheta / 2
    return np.array([x + length * np.cos(way), y + length * np.sin(way), theta + dtheta])


def two_branches(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-8:
        return [x + distance * math.cos(theta), y + distance * math.sin(theta), theta + dtheta]
    radius = distance / dtheta
    new = theta + dtheta
    return [x + radius * (math.sin(new) - math.sin(theta)), y + radius * (math.cos(theta) - math.cos(new)), new]


def half_angles(pose, distance, dtheta):
    """No difference of nearly equal numbers: 1 - cos a = 2 sin^2(a/2)."""
    x, y, theta = pose
    if dtheta == 0:
        ahead, left = distance, 0.0
    else:
        radius = distance / dtheta
        ahead, left = radius * math.sin(dtheta), 2 * radius * math.sin(dtheta / 2) ** 2
    c, s = math.cos(theta), math.sin(theta)
    return x + c * ahead - s * left, y + s * ahead + c * left, theta + dtheta


def gauss_legendre(pose, distance, dtheta):
    """Integrate cos and sin along the way numerically, to machine accuracy."""
    nodes, weights = np.polynomial.legendre.leggauss(24)
    headings = pose[2] + dtheta * (nodes + 1) / 2
    way = distance / 2 * np.array([weights @ np.cos(headings), weights @ np.sin(headings)])
    return np.array([pose[0] + way[0], pose[1] + way[1], pose[2] + dtheta])


def taylor_of_the_exponential(pose, distance, dtheta):
    """Sum up (e^(i a) - 1)/(i a) term by term."""
    total, term = 0j, 1 + 0j
    for k in range(1, 90):
        total += term
        term *= 1j * dtheta / (k + 1)
    end = complex(pose[0], pose[1]) + distance * total * cmath.exp(1j * pose[2])
    print(end)
    return end.real, end.imag, pose[2] + dtheta


def matrix_exponential(pose, distance, dtheta):
    twist = np.array([[0, -dtheta, distance], [dtheta, 0, 0], [0, 0, 0]]) / 1024
    step = np.eye(3) + twist + twist @ twist / 2 + twist @ twist @ twist / 6
    for _ in range(10):
        step = step @ step
    c, s = math.cos(pose[2]), math.sin(pose[2])
    here = np.array([[c, -s, pose[0]], [s, c, pose[1]], [0, 0, 1]])
    x, y = (here @ step)[:2, 2]
    return [x, y, pose[2] + dtheta]


def in_single_precision(pose, distance, dtheta):
    return chord(pose, distance, dtheta).astype(np.float32)


def recursion(pose, distance, dtheta):
    """Two half arcs, until the straight step is exact enough."""
    if abs(dtheta) < 2e-3:
        x, y, theta = pose
        way = theta + dtheta / 2
        return x + distance * math.cos(way), y + distance * math.sin(way), theta + dtheta
    return recursion(recursion(pose, distance / 2, dtheta / 2), distance / 2, dtheta / 2)


class Arc:
    def __init__(self, limit):
        self.limit = limit

    def __call__(self, pose, distance, dtheta):
        ratio = 1 - dtheta**2 / 24 if abs(dtheta) < self.limit else 2 * math.sin(dtheta / 2) / dtheta
        way = cmath.rect(1, pose[2] + dtheta / 2) * distance * ratio
        return np.array([pose[0] + way.real, pose[1] + way.imag, pose[2] + dtheta])


def where_with_a_safe_divisor(pose, distance, dtheta):
    half = np.asarray(dtheta / 2)
    small = np.abs(half) < 1e-7
    ratio = np.where(small, 1.0, np.sin(half) / np.where(small, 1.0, half))
    way = pose[2] + dtheta / 2
    return np.array([pose[0] + distance * ratio * np.cos(way), pose[1] + distance * ratio * np.sin(way), pose[2] + dtheta])


RIGHT = {
    "chord by np.sinc": chord,
    "two branches, list": two_branches,
    "half angles, tuple": half_angles,
    "Gauss-Legendre": gauss_legendre,
    "series of the exponential, prints": taylor_of_the_exponential,
    "matrix exponential": matrix_exponential,
    "float32": in_single_precision,
    "recursion": recursion,
    "object with a limit": Arc(1e-2),
    "np.where with a safe divisor": where_with_a_safe_divisor,
}


def isclose_with_its_default(pose, distance, dtheta):
    x, y, theta = pose
    if math.isclose(dtheta, 0):
        return np.array([x + distance * math.cos(theta), y + distance * math.sin(theta), theta])
    radius = distance / dtheta
    return chord_by_radius(x, y, theta, radius, dtheta)


def chord_by_radius(x, y, theta, radius, dtheta):
    new = theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def nan_to_num(pose, distance, dtheta):
    x, y, theta = pose
    with np.errstate(all="ignore"):
        radius = np.float64(distance) / np.float64(dtheta)
        return np.nan_to_num(chord_by_radius(x, y, theta, radius, dtheta))


def try_except(pose, distance, dtheta):
    x, y, theta = pose
    try:
        return chord_by_radius(x, y, theta, distance / dtheta, dtheta)
    except ZeroDivisionError:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta])


def machine_epsilon_added(pose, distance, dtheta):
    x, y, theta = pose
    return chord_by_radius(x, y, theta, distance / (dtheta + np.finfo(float).eps), dtheta)


def small_turn_replaced(pose, distance, dtheta):
    x, y, theta = pose
    turn = dtheta if abs(dtheta) > 1e-3 else 1e-3
    return chord_by_radius(x, y, theta, distance / turn, turn)


def series_of_three_terms(pose, distance, dtheta):
    x, y, theta = pose
    way, ratio = theta + dtheta / 2, 1 - dtheta**2 / 24
    return np.array([x + distance * ratio * np.cos(way), y + distance * ratio * np.sin(way), theta + dtheta])


def many_small_steps(pose, distance, dtheta):
    x, y, theta = pose
    for _ in range(100):
        x, y, theta = x + distance / 100 * np.cos(theta), y + distance / 100 * np.sin(theta), theta + dtheta / 100
    return np.array([x, y, theta])


def ten_midpoint_steps(pose, distance, dtheta):
    x, y, theta = pose
    for _ in range(10):
        way = theta + dtheta / 20
        x, y, theta = x + distance / 10 * np.cos(way), y + distance / 10 * np.sin(way), theta + dtheta / 10
    return np.array([x, y, theta])


def both_branches_by_where(pose, distance, dtheta):
    x, y, theta = np.array(pose, dtype=float)
    turn = np.float64(dtheta)
    ratio = np.where(abs(turn) < 1e-9, 1.0, 2 * np.sin(turn / 2) / turn)
    way = theta + turn / 2
    return np.array([x + distance * ratio * np.cos(way), y + distance * ratio * np.sin(way), theta + turn])


def chord_by_cosine_rule(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        length = distance
    else:
        radius = distance / dtheta
        length = math.sqrt(2 * radius**2 * (1 - math.cos(dtheta)))
    way = theta + dtheta / 2
    return np.array([x + length * np.cos(way), y + length * np.sin(way), theta + dtheta])


def radius_positive_and_side(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return chord(pose, distance, dtheta)
    radius = abs(distance) / abs(dtheta)
    return chord_by_radius(x, y, theta, radius, dtheta)


def centre_on_the_right(pose, distance, dtheta):
    if abs(dtheta) < 1e-6:
        return chord(pose, distance, dtheta)
    x, y, theta = pose
    radius, new = distance / dtheta, theta + dtheta
    centre = x + radius * np.sin(theta), y - radius * np.cos(theta)
    return np.array([centre[0] - radius * np.sin(new), centre[1] + radius * np.cos(new), new])


def robot_axes_only(pose, distance, dtheta):
    if abs(dtheta) < 1e-6:
        return chord(pose, distance, dtheta)
    radius = distance / dtheta
    return np.array([pose[0] + radius * np.sin(dtheta), pose[1] + radius * (1 - np.cos(dtheta)), pose[2] + dtheta])


def turn_kept_below_limit(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-2:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    return chord(pose, distance, dtheta)


def full_turns_dropped(pose, distance, dtheta):
    return chord(pose, distance, math.fmod(dtheta, 2 * math.pi))


def in_place(pose, distance, dtheta):
    pose[:] = chord(pose, distance, dtheta)
    return pose


def degrees_in_sinc(pose, distance, dtheta):
    x, y, theta = pose
    length, way = distance * np.sinc(np.degrees(dtheta) / 360), theta + np.degrees(dtheta) / 2
    return np.array([x + length * np.cos(way), y + length * np.sin(way), theta + dtheta])


def wrapped_by_atan2(pose, distance, dtheta):
    x, y, theta = chord(pose, distance, dtheta)
    return [x, y, math.atan2(math.sin(theta), math.cos(theta))]


def euler(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * math.cos(theta), y + distance * math.sin(theta), theta + dtheta])


def column(pose, distance, dtheta):
    return chord(pose, distance, dtheta)[:, None]


def four_decimals(pose, distance, dtheta):
    return np.round(chord(pose, distance, dtheta), 4)


def own_warning(pose, distance, dtheta):
    import warnings

    if abs(dtheta) < 1e-9:
        warnings.warn("driving straight", stacklevel=2)
    return chord(pose, distance, dtheta)


def python_floats(pose, distance, dtheta):
    x, y, theta = pose
    ratio = math.sin(dtheta / 2) / (dtheta / 2)
    way = theta + dtheta / 2
    return np.array([x + distance * ratio * np.cos(way), y + distance * ratio * np.sin(way), theta + dtheta])


def numpy_ratio(pose, distance, dtheta):
    x, y, theta = pose
    ratio = np.sin(dtheta / 2) / np.float64(dtheta / 2)
    way = theta + dtheta / 2
    return np.array([x + distance * ratio * np.cos(way), y + distance * ratio * np.sin(way), theta + dtheta])


WRONG = {
    "math.isclose": (isclose_with_its_default, "relative only: exactly 0 alone is close to 0", "subtle"),
    "nan_to_num": (nan_to_num, "the start becomes 0 on the straight", "subtle"),
    "except ZeroDivisionError": (try_except, "1e-12 is not caught", "subtle"),
    "eps added": (machine_epsilon_added, "digits lost", "subtle"),
    "small turn replaced": (small_turn_replaced, "at least 1e-3", "subtle"),
    "series": (series_of_three_terms, "1 - a^2/24 for every turn", "subtle"),
    "a hundred Euler steps": (many_small_steps, "an approximation", "subtle"),
    "ten midpoint steps": (ten_midpoint_steps, "an approximation", "subtle"),
    "np.where": (both_branches_by_where, "divides by 0 and throws it away: warns", "plain"),
    "cosine rule": (chord_by_cosine_rule, "the root loses the sign of the distance", "subtle"),
    "radius without sign": (radius_positive_and_side, "right turns and reversing", "subtle"),
    "centre on the right": (centre_on_the_right, "backwards", "plain"),
    "robot's axes": (robot_axes_only, "not turned by theta", "plain"),
    "Euler below 0.01": (turn_kept_below_limit, "the limit is too large", "subtle"),
    "full turns dropped": (full_turns_dropped, "dtheta modulo 2 pi", "subtle"),
    "changes the pose": (in_place, "pose[:] = ...", "plain"),
    "degrees": (degrees_in_sinc, "dtheta in degrees", "subtle"),
    "wrapped": (wrapped_by_atan2, "theta within +-pi", "plain"),
    "Euler": (euler, "straight along theta", "plain"),
    "column": (column, "(3, 1)", "plain"),
    "four decimals": (four_decimals, "rounded", "subtle"),
    "own warning": (own_warning, "a warning is a fault here", "plain"),
    "math.sin over 0": (python_floats, "ZeroDivisionError", "plain"),
    "np.sin over 0": (numpy_ratio, "NaN", "plain"),
}

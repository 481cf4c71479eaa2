"""pose_step_arc(pose, distance, dtheta): the exact circular arc of length `distance` and angle `dtheta`, also where dtheta is 0 or tiny."""

import cmath
import math

import numpy as np

from autograder.draws import magnitudes, until
from autograder.exercise import Exercise, Group, Mistake
from course.language import Text
from course.tolerances import LAST_AXIS

TINY = 1e-12


def reference(pose, distance, dtheta):
    """Return the end of the arc: the chord, sin(h)/h times as long as the arc for the half turn h, along theta + h."""
    x, y, theta = pose
    half = dtheta / 2
    shrink = math.sin(half) / half if half else 1.0
    end = complex(x, y) + distance * shrink * cmath.rect(1, theta + half)
    return end.real, end.imag, theta + dtheta


def cases(rng):
    """Draw arcs of all sizes; none between 1e-12 and 2e-4, where answers may choose to go straight on.

    Headings are between 0 and pi, before and after the step, where no group is about them.
    """

    def start(turns=0):
        heading = (rng.integers(0, 4) + rng.uniform(0.26, 0.74)) * np.pi / 4
        return np.array([magnitudes(rng, 0.5, 2.0), magnitudes(rng, 0.5, 2.0), heading + 2 * np.pi * turns])

    def step(forward, turn, turns=0):
        def draw():
            return start(turns), forward * rng.uniform(1.2, 2.5), turn * rng.uniform(0.7, 1.3)

        return until(draw, lambda *step: clear_of_zero(*step) and 0.1 < step[0][2] + step[2] - 2 * np.pi * turns < 3.0)

    def across_pi(side):
        pose = start()
        pose[2] = side * (np.pi - rng.uniform(0.1, 0.3))
        return pose, -side * rng.uniform(1.2, 2.5), side * rng.uniform(0.5, 0.9)

    def wide_turn(forward, low, high):
        return until(lambda: (start(), forward * rng.uniform(2.5, 4.0), rng.uniform(low, high)), clear_of_zero)

    def tiny_turn(sign):
        """Draw a step on which dividing by the tiny turn loses digits: sines of nearby headings differ by a few units of rounding."""
        return until(lambda: (start(), sign * rng.uniform(2.0, 4.0), sign * TINY), _loses_digits)

    def whole():
        return np.array([rng.choice([-4, -3, 3, 4]), rng.choice([-4, -3, 3, 4]), 3]), rng.choice([-3, -2]), rng.choice([-2, -1])

    across = [until(lambda side=side: across_pi(side), clear_of_zero) for side in (-1, 1)]
    pose, distance, dtheta = step(1, 0.5)
    wide = [wide_turn(-1, 3.6, 5.2), wide_turn(1, -5.2, -3.6), wide_turn(1, 7.4, 10.0)]
    straight = [step(1, 0.0), (*step(-1, 0.0)[:2], 0)]
    return [
        Group(Text("forward, turning left", "前進しながら左旋回"), 3, [step(1, 0.5) for _ in range(2)]),
        Group(Text("forward, turning right", "前進しながら右旋回"), 2, [step(1, -0.5) for _ in range(2)]),
        Group(Text("reversing", "後退"), 1, [step(-1, -0.5), step(-1, 0.5)]),
        Group(Text("gentle turns", "ゆるやかな旋回"), 1, [step(1, 0.03), step(-1, -0.03), step(1, -5e-4)]),
        Group(Text("straight on (dtheta = 0)", "直進 (dtheta = 0)"), 2, straight),
        Group(Text("almost straight on (dtheta = 1e-12)", "ほぼ直進 (dtheta = 1e-12)"), 2, [tiny_turn(1), tiny_turn(-1)]),
        Group(Text("turns by more than half a turn", "半回転を超える旋回"), 1, [*wide]),
        Group(Text("headings beyond half a turn", "半回転を超える方位"), 1, [step(1, 0.5, rng.choice([-2, -1, 1, 2])), *across]),
        Group(
            Text("lists and whole numbers", "リストや整数の入力"),
            1,
            [until(whole, clear_of_zero), (pose.tolist(), distance, dtheta)],
        ),
    ]


def clear_of_zero(pose, distance, dtheta):
    """Is every part of the new pose far enough from zero that rounding does not matter?"""
    return min(map(abs, reference(pose, distance, dtheta))) > 0.3


def _loses_digits(pose, distance, dtheta):
    """Return whether R (sin(theta + dtheta) - sin(theta)) misses the end of the arc by far, in x and in y.

    Headings whose sines NumPy and math round differently are left out, so that all who compute this get the same wrong number.
    """
    headings = (pose[2], pose[2] + dtheta)
    if any(np.sin(h) != math.sin(h) or np.cos(h) != math.cos(h) for h in headings):
        return False
    right, naive = reference(pose, distance, dtheta), divided_by_a_tiny_turn(pose, distance, dtheta)
    return clear_of_zero(pose, distance, dtheta) and all(abs(naive[:2] - right[:2]) > 5e-5)


def yaw_kept(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta])


def yaw_replaced(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), dtheta])


def middle_heading_returned(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), middle])


def turn_subtracted_at_the_end(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta - dtheta])


def full_turns_dropped(pose, distance, dtheta):
    x, y, theta = pose
    dtheta = math.fmod(dtheta, 2 * math.pi)
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta])


def yaw_wrapped(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    wrapped = (theta + dtheta + np.pi) % (2 * np.pi) - np.pi
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), wrapped])


def yaw_wrapped_to_positive(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), (theta + dtheta) % (2 * np.pi)])


def not_a_number_on_the_straight(pose, distance, dtheta):
    x, y, theta = pose
    radius, new = np.float64(distance) / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def divided_by_zero(pose, distance, dtheta):
    x, y, theta = pose
    radius, new = float(distance) / float(dtheta), theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def divided_by_a_tiny_turn(pose, distance, dtheta):
    x, y, theta = pose
    if dtheta == 0:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def centre_far_away(pose, distance, dtheta):
    x, y, theta = pose
    if dtheta == 0:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta])
    radius, new = distance / dtheta, theta + dtheta
    centre_x, centre_y = x - radius * np.sin(theta), y + radius * np.cos(theta)
    return np.array([centre_x + radius * np.sin(new), centre_y - radius * np.cos(new), new])


def right_turns_taken_for_straight(pose, distance, dtheta):
    x, y, theta = pose
    if dtheta < 1e-6:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def straight_on_below_a_twentieth(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 0.05:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def straight_on_below_a_thousandth(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-3:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def small_turn_forgotten(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 0.1:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def stands_still_on_the_straight(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x, y, theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def stands_still_at_zero(pose, distance, dtheta):
    x, y, theta = pose
    if dtheta == 0:
        return np.array([x, y, theta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def along_x_on_the_straight(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x + distance, y, theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def along_x_at_zero(pose, distance, dtheta):
    x, y, theta = pose
    if dtheta == 0:
        return np.array([x + distance, y, theta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def only_the_step_on_the_straight(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([distance * np.cos(theta), distance * np.sin(theta), theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def sin_cos_exchanged_on_the_straight(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x + distance * np.sin(theta), y + distance * np.cos(theta), theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def something_added_to_the_turn(pose, distance, dtheta):
    x, y, theta = pose
    dtheta = dtheta + 1e-3
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def something_tiny_added_to_the_turn(pose, distance, dtheta):
    x, y, theta = pose
    radius, new = distance / (dtheta + 1e-9), theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def sign_of_y_turned_round(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y + radius * (np.cos(new) - np.cos(theta)), new])


def sign_of_x_turned_round(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x - radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def both_signs_turned_round(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x - radius * (np.sin(new) - np.sin(theta)), y + radius * (np.cos(new) - np.cos(theta)), new])


def sin_cos_exchanged(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x - radius * (np.cos(new) - np.cos(theta)), y + radius * (np.sin(new) - np.sin(theta)), new])


def sin_cos_exchanged_along_the_chord(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    return np.array([x + chord * np.sin(middle), y + chord * np.cos(middle), theta + dtheta])


def radius_without_sign(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    radius, new = abs(distance / dtheta), theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def radius_upside_down(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    radius, new = dtheta / distance, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def radius_times_turn(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    radius, new = distance * dtheta, theta + dtheta
    return np.array([x + radius * (np.sin(new) - np.sin(theta)), y - radius * (np.cos(new) - np.cos(theta)), new])


def distance_taken_for_radius(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    new = theta + dtheta
    return np.array([x + distance * (np.sin(new) - np.sin(theta)), y - distance * (np.cos(new) - np.cos(theta)), new])


def chord_without_sign(pose, distance, dtheta):
    x, y, theta = pose
    chord = abs(distance * np.sinc(dtheta / (2 * np.pi))) if abs(dtheta) > 1e-6 else distance
    middle = theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta])


def stands_still_when_reversing(pose, distance, dtheta):
    x, y, theta = pose
    distance = max(distance, 0)
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta])


def distance_made_positive(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = abs(distance) * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta])


def turn_made_positive(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + abs(dtheta) / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + abs(dtheta)])


def clockwise(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta - dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta - dtheta])


def sinc_of_half_the_turn(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / 2), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta])


def sinc_of_the_whole_turn(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / np.pi), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta])


def sinc_of_the_turn_without_pi(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta])


def half_the_chord(pose, distance, dtheta):
    x, y, theta = pose
    chord = distance / dtheta * np.sin(dtheta / 2) if abs(dtheta) > 1e-6 else distance
    middle = theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta])


def chord_along_the_old_heading(pose, distance, dtheta):
    x, y, theta = pose
    chord = distance * np.sinc(dtheta / (2 * np.pi))
    return np.array([x + chord * np.cos(theta), y + chord * np.sin(theta), theta + dtheta])


def chord_along_the_new_heading(pose, distance, dtheta):
    x, y, theta = pose
    chord, new = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta
    return np.array([x + chord * np.cos(new), y + chord * np.sin(new), new])


def midpoint_rule(pose, distance, dtheta):
    x, y, theta = pose
    middle = theta + dtheta / 2
    return np.array([x + distance * np.cos(middle), y + distance * np.sin(middle), theta + dtheta])


def old_heading_used(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])


def new_heading_used(pose, distance, dtheta):
    x, y, theta = pose
    new = theta + dtheta
    return np.array([x + distance * np.cos(new), y + distance * np.sin(new), new])


def mean_of_both_headings(pose, distance, dtheta):
    x, y, theta = pose
    new = theta + dtheta
    forward, left = (np.cos(theta) + np.cos(new)) / 2, (np.sin(theta) + np.sin(new)) / 2
    return np.array([x + distance * forward, y + distance * left, new])


def simpson_rule(pose, distance, dtheta):
    x, y, theta = pose
    middle, new = theta + dtheta / 2, theta + dtheta
    forward = (np.cos(theta) + 4 * np.cos(middle) + np.cos(new)) / 6
    left = (np.sin(theta) + 4 * np.sin(middle) + np.sin(new)) / 6
    return np.array([x + distance * forward, y + distance * left, new])


def start_heading_taken_for_zero(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * np.sin(dtheta), y + radius * (1 - np.cos(dtheta)), new])


def old_heading_left_out(pose, distance, dtheta):
    x, y, theta = pose
    if abs(dtheta) < 1e-6:
        return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
    radius, new = distance / dtheta, theta + dtheta
    return np.array([x + radius * np.sin(new), y + radius * (1 - np.cos(new)), new])


def arc_turned_backwards(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), dtheta / 2 - theta
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta])


def turn_wrapped(pose, distance, dtheta):
    x, y, theta = pose
    turn = (dtheta + np.pi) % (2 * np.pi) - np.pi
    chord, middle = distance * np.sinc(turn / (2 * np.pi)), theta + turn / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta])


def start_forgotten(pose, distance, dtheta):
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), pose[2] + dtheta / 2
    return np.array([chord * np.cos(middle), chord * np.sin(middle), dtheta])


def position_forgotten(pose, distance, dtheta):
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), pose[2] + dtheta / 2
    return np.array([chord * np.cos(middle), chord * np.sin(middle), pose[2] + dtheta])


def degrees_in_cos(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), np.deg2rad(theta + dtheta / 2)
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta])


def whole_numbers_cut_off(pose, distance, dtheta):
    moved = np.array(pose)
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), pose[2] + dtheta / 2
    moved[0] = pose[0] + chord * np.cos(middle)
    moved[1] = pose[1] + chord * np.sin(middle)
    moved[2] = pose[2] + dtheta
    return moved


def rounded(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    return np.round([x + chord * np.cos(middle), y + chord * np.sin(middle), theta + dtheta], 3)


def yaw_left_out(pose, distance, dtheta):
    x, y, theta = pose
    chord, middle = distance * np.sinc(dtheta / (2 * np.pi)), theta + dtheta / 2
    return np.array([x + chord * np.cos(middle), y + chord * np.sin(middle)])


_DIVIDED = Text(
    "Where the robot drives straight on (dtheta = 0), the radius D/dtheta is a division by zero. The arc itself is harmless "
    "there: it becomes a straight line. Choose the formula before dividing, or write the chord with np.sinc (read its "
    "docstring).",
    "直進(dtheta = 0)のとき、半径 D/dtheta が 0 での割り算になっています。円弧そのものに問題はなく、直線になるだけです。"
    "割り算の前に式を選ぶか、弦の長さを np.sinc で表しましょう(docstring を読んでください)。",
)
_DIGITS_LOST = Text(
    "dtheta = 0 is right, but for dtheta = 1e-12 the result is too far off: two almost equal numbers are subtracted and the "
    "rest is multiplied by a huge radius. Comparing with 0 exactly does not catch a tiny turn; treat all tiny turns alike, or "
    "use a form without that difference.",
    "dtheta = 0 では正しいのですが、1e-12 のときの誤差が大きすぎます。ほぼ等しい 2 数の差に、巨大な半径を掛けているためです。"
    "0 との完全な一致を調べるだけでは、ごく小さな旋回を拾えません。"
    "小さな旋回をまとめて扱うか、この引き算が現れない形にしましょう。",
)
_STANDS_STILL = Text(
    "Where it should drive straight on, the robot stands still. dtheta = 0 means no turn; the distance is made all the same.",
    "直進するはずのところで、ロボットが止まっています。dtheta = 0 は「回らない」という意味で、距離は進みます。",
)
_ALONG_X = Text(
    "Where it should drive straight on, the robot moves along x whatever its heading. The straight step goes along theta.",
    "直進するはずのところで、方位に関係なく x 方向へ進んでいます。まっすぐ進む向きは theta です。",
)
_TOO_SOON = Text(
    "Gentle turns are not exact: below a threshold the robot goes straight along the old heading, and that threshold is too "
    "large. How small must dtheta be until a straight step along theta is off by less than 1e-6 of the distance?",
    "ゆるやかな旋回で誤差が残っています。しきい値より小さい旋回を直進とみなしていますが、そのしきい値が大きすぎます。"
    "直進とみなした誤差が距離の 1e-6 倍より小さくなるのは、dtheta がどのくらいのときでしょうか。",
)
_SOMETHING_ADDED = Text(
    "A small number is added to dtheta to avoid the division by zero. That changes the result where dtheta is small, and the "
    "error there is larger than the division was worth. Choose the formula by the size of dtheta instead.",
    "0 での割り算を避けるために、dtheta に小さな数を足しています。これでは dtheta が小さいところで結果が狂います。"
    "足すのではなく、dtheta の大きさで式を選びましょう。",
)

EXERCISE = Exercise(
    name="pose_step_arc",
    notebook="odometry/pose_update",
    points=5,
    parameters=("pose", "distance", "dtheta"),
    quantities=("x", "y", "theta"),
    reference=reference,
    cases=cases,
    tolerance=LAST_AXIS,
    warnings_are_faults=True,
    examples=(
        (np.array([1.0, 2.0, np.pi / 6]), 0.5, 0.6),
        (np.array([0.0, 0.0, np.pi / 2]), -1.0, -np.pi),
        (np.array([1.0, 2.0, np.pi / 6]), 0.5, 0.0),
    ),
    mistakes=(
        Mistake(
            yaw_kept,
            Text(
                "The heading stays as it was. At the end of the arc the robot looks in another direction.",
                "方位が元のままです。円弧の終わりでは、ロボットの向きは変わっています。",
            ),
        ),
        Mistake(
            yaw_replaced,
            Text(
                "The new heading is dtheta alone. dtheta is the change: it is added to the old heading.",
                "新しい方位が dtheta そのものになっています。dtheta は変化量ですから、元の方位に足します。",
            ),
        ),
        Mistake(
            middle_heading_returned,
            Text(
                "The heading that comes back is the direction of the chord, half-way through the turn. At the end of the arc "
                "the whole turn is made.",
                "返している方位が弦の向き(旋回の半分)です。円弧の終わりでは旋回をすべて終えています。",
            ),
        ),
        Mistake(
            turn_subtracted_at_the_end,
            Text(
                "dtheta is subtracted from the heading.",
                "方位から dtheta を引いています。",
            ),
        ),
        Mistake(
            full_turns_dropped,
            Text(
                "Full turns are dropped from dtheta. On an arc of more than one turn the distance is the same but the circle "
                "smaller, and the heading goes on counting: use dtheta as it comes.",
                "dtheta から 1 回転分が落とされています。1 回転を超える円弧では、同じ距離でも円が小さくなり、"
                "方位も数え続けます。dtheta はそのまま使いましょう。",
            ),
        ),
        Mistake(
            yaw_wrapped,
            Text(
                "The heading is wrapped to -pi..pi. Here it goes on counting: wrap only for display.",
                "方位が -π〜π に折り返されています。ここではそのまま数え続けます。折り返すのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            yaw_wrapped_to_positive,
            Text(
                "The heading is wrapped to 0..2 pi. Here it may be negative or beyond one turn: no modulo.",
                "方位が 0〜2π に折り返されています。ここでは負になっても 1 回転を超えてもかまいません。剰余はとりません。",
            ),
        ),
        Mistake(not_a_number_on_the_straight, _DIVIDED),
        Mistake(divided_by_zero, _DIVIDED),
        Mistake(divided_by_a_tiny_turn, _DIGITS_LOST),
        Mistake(centre_far_away, _DIGITS_LOST),
        Mistake(
            right_turns_taken_for_straight,
            Text(
                "Every turn to the right is treated as straight. The test dtheta < ... holds for all negative dtheta as well: "
                "the size is to be compared.",
                "右旋回がすべて直進として扱われています。dtheta < ... という条件は、"
                "負の dtheta でもすべて成り立ってしまいます。比べるのは大きさです。",
            ),
        ),
        Mistake(straight_on_below_a_twentieth, _TOO_SOON),
        Mistake(straight_on_below_a_thousandth, _TOO_SOON),
        Mistake(
            small_turn_forgotten,
            Text(
                "On gentle turns the robot goes straight on and keeps its heading. Many gentle turns make a large one: the "
                "heading must change each time, and the threshold is too large.",
                "ゆるやかな旋回が直進とみなされ、方位も変わっていません。小さな旋回も積み重なれば大きくなります。"
                "方位は毎回更新しなければなりませんし、しきい値も大きすぎます。",
            ),
        ),
        Mistake(stands_still_on_the_straight, _STANDS_STILL),
        Mistake(stands_still_at_zero, _STANDS_STILL),
        Mistake(along_x_on_the_straight, _ALONG_X),
        Mistake(along_x_at_zero, _ALONG_X),
        Mistake(
            only_the_step_on_the_straight,
            Text(
                "The arc is right, but in the branch for driving straight on x and y of the start are missing.",
                "円弧は正しく計算できていますが、直進の場合の式で、出発点の x, y が足されていません。",
            ),
        ),
        Mistake(
            sin_cos_exchanged_on_the_straight,
            Text(
                "The arc is right, but in the branch for driving straight on sin and cos are exchanged. A heading of 0 looks "
                "along +x.",
                "円弧は正しく計算できていますが、直進の場合の式で sin と cos が入れ替わっています。方位 0 は +x の向きです。",
            ),
        ),
        Mistake(something_added_to_the_turn, _SOMETHING_ADDED),
        Mistake(something_tiny_added_to_the_turn, _SOMETHING_ADDED),
        Mistake(
            sign_of_y_turned_round,
            Text(
                "The step in y has the wrong sign on every arc. The integral of sin is -cos: a left turn from heading 0 must "
                "end at positive y.",
                "円弧での y の移動量の符号が逆です。sin の積分は -cos です。方位 0 から左へ曲がれば、y は正になるはずです。",
            ),
        ),
        Mistake(
            sign_of_x_turned_round,
            Text(
                "The step in x has the wrong sign on every arc. From heading 0 a short arc forward must end at positive x.",
                "円弧での x の移動量の符号が逆です。方位 0 から少し前進すれば、x は正になるはずです。",
            ),
        ),
        Mistake(
            both_signs_turned_round,
            Text(
                "On every arc the robot moves backwards: old and new heading are exchanged in the differences, or the radius "
                "has the wrong sign.",
                "円弧では後ろ向きに進んでいます。差をとるときに元の方位と新しい方位が逆か、半径の符号が逆です。",
            ),
        ),
        Mistake(
            sin_cos_exchanged,
            Text(
                "sin and cos are exchanged on the arc. x is the integral of cos theta: which function has cos as its derivative?",
                "円弧の式で sin と cos が入れ替わっています。x は cos theta の積分です。"
                "微分すると cos になる関数はどちらでしょうか。",
            ),
        ),
        Mistake(
            sin_cos_exchanged_along_the_chord,
            Text(
                "sin and cos of the chord's direction are exchanged. A chord of direction 0 points along +x.",
                "弦の向きの sin と cos が入れ替わっています。向きが 0 の弦は +x を指します。",
            ),
        ),
        Mistake(
            radius_without_sign,
            Text(
                "The radius has lost its sign, so that right turns or reversing come out the wrong way. D/dtheta with its "
                "sign puts the centre on the correct side by itself.",
                "半径の符号が失われ、右旋回や後退が逆向きになっています。"
                "D/dtheta を符号付きのまま使えば、旋回の中心は自然に正しい側にきます。",
            ),
        ),
        Mistake(
            radius_upside_down,
            Text(
                "The radius is turned upside down. An arc of angle dtheta and radius R has the length R dtheta: solve for R, "
                "and check the unit.",
                "半径の割り算が逆です。半径 R、角度 dtheta の円弧の長さは R dtheta です。R について解き、単位も確かめましょう。",
            ),
        ),
        Mistake(
            radius_times_turn,
            Text(
                "The distance is multiplied by dtheta to get the radius. An arc of angle dtheta and radius R has the length R "
                "dtheta: solve for R.",
                "半径を求めるときに、距離に dtheta を掛けています。半径 R、角度 dtheta の円弧の長さは R dtheta です。"
                "R について解きましょう。",
            ),
        ),
        Mistake(
            distance_taken_for_radius,
            Text(
                "The distance is used as if it were the radius of the arc. It is the length of the arc: how do length, radius "
                "and angle go together?",
                "距離を円弧の半径として使っています。距離は円弧の長さです。長さ・半径・角度の関係を思い出しましょう。",
            ),
        ),
        Mistake(
            chord_without_sign,
            Text(
                "The chord is always positive, so that reversing on an arc is drawn forward. Leave the sign of the distance "
                "in it.",
                "弦の長さがいつも正なので、曲がりながらの後退が前進になっています。距離の符号を残しましょう。",
            ),
        ),
        Mistake(
            stands_still_when_reversing,
            Text(
                "A robot that reverses stands still: negative distances are replaced by 0. A negative distance is a step "
                "backwards.",
                "後退のとき止まっています。負の距離が 0 に置き換えられています。distance が負なら後ろへ進みます。",
            ),
        ),
        Mistake(
            distance_made_positive,
            Text(
                "A robot that reverses is drawn driving forward: the sign of the distance is lost.",
                "後退しているのに前進として計算されています。距離の符号が失われています。",
            ),
        ),
        Mistake(
            turn_made_positive,
            Text(
                "Every turn becomes a turn to the left: the sign of dtheta is lost.",
                "どちらに回っても左旋回になっています。dtheta の符号が失われています。",
            ),
        ),
        Mistake(
            clockwise,
            Text(
                "dtheta is subtracted everywhere, so that the robot turns to the wrong side. A positive dtheta makes the "
                "heading grow.",
                "どこでも dtheta を引いているため、逆向きに回っています。dtheta が正なら方位は増えます。",
            ),
        ),
        Mistake(
            sinc_of_half_the_turn,
            Text(
                "np.sinc(x) is sin(pi x)/(pi x), with pi in it. Read its docstring: by what must dtheta/2 be divided first?",
                "np.sinc(x) は sin(πx)/(πx) で、π を含んでいます。docstring を読みましょう。"
                "dtheta/2 を先に何で割っておく必要がありますか。",
            ),
        ),
        Mistake(
            sinc_of_the_whole_turn,
            Text(
                "The chord is too short: sin(dtheta)/dtheta is used, with the whole turn. Draw the triangle of the two radii "
                "and the chord: which angle stands at its half?",
                "弦が短すぎます。旋回角の全体で sin(dtheta)/dtheta を計算しています。2 本の半径と弦の三角形を描きましょう。"
                "弦の半分に向かい合う角はどれですか。",
            ),
        ),
        Mistake(
            sinc_of_the_turn_without_pi,
            Text(
                "np.sinc(dtheta) is sin(pi dtheta)/(pi dtheta): it has pi in it, and the whole turn instead of half. Read its "
                "docstring and draw the triangle of the chord.",
                "np.sinc(dtheta) は sin(π dtheta)/(π dtheta) です。"
                "π が入っているうえに、旋回の半分ではなく全体を使っています。docstring を読み、弦の三角形を描いてみましょう。",
            ),
        ),
        Mistake(
            half_the_chord,
            Text(
                "On every arc the robot makes only half of the chord: R sin(dtheta/2) is one half of it.",
                "円弧では弦の半分しか進んでいません。R sin(dtheta/2) は弦の半分の長さです。",
            ),
        ),
        Mistake(
            chord_along_the_old_heading,
            Text(
                "The chord is drawn along the heading before the step. In which direction does the chord of an arc point, "
                "compared with the headings at its two ends?",
                "弦が、動く前の方位の向きに引かれています。円弧の弦の向きは、両端の方位と比べてどうなっているでしょうか。",
            ),
        ),
        Mistake(
            chord_along_the_new_heading,
            Text(
                "The chord is drawn along the heading after the step. In which direction does the chord of an arc point, "
                "compared with the headings at its two ends?",
                "弦が、動いた後の方位の向きに引かれています。円弧の弦の向きは、両端の方位と比べてどうなっているでしょうか。",
            ),
        ),
        Mistake(
            midpoint_rule,
            Text(
                "This is the midpoint rule of the exercise before. Its direction is exact, but it takes the length of the arc "
                "for that of the chord: on a wide turn the straight way is shorter.",
                "これは前の課題の中点則です。向きは厳密ですが、弧の長さをそのまま弦の長さとして使っています。"
                "大きく曲がるほど、まっすぐ結んだ距離は短くなります。",
            ),
        ),
        Mistake(
            old_heading_used,
            Text(
                "This goes straight on along the heading before the step, as pose_step does. Here the robot turns steadily on "
                "its way, so its path is an arc.",
                "pose_step と同じく、動く前の方位の向きにまっすぐ進んでいます。"
                "ここでは進みながら一定の割合で回るので、経路は円弧になります。",
            ),
        ),
        Mistake(
            new_heading_used,
            Text(
                "This goes straight on along the heading after the step. Here the robot turns steadily on its way, so its "
                "path is an arc.",
                "動いた後の方位の向きにまっすぐ進んでいます。ここでは進みながら一定の割合で回るので、経路は円弧になります。",
            ),
        ),
        Mistake(
            mean_of_both_headings,
            Text(
                "cos and sin of the headings before and after are averaged (trapezoid). That is an approximation; the arc can "
                "be integrated exactly.",
                "動く前と後の cos, sin を平均しています(台形則)。これは近似です。円弧なら厳密に積分できます。",
            ),
        ),
        Mistake(
            simpson_rule,
            Text(
                "cos and sin are averaged with the weights 1, 4, 1 (Simpson). That is a good approximation, but on wide turns "
                "not exact; the arc can be integrated exactly.",
                "cos, sin を 1, 4, 1 の重みで平均しています(シンプソン則)。よい近似ですが、大きな旋回では厳密ではありません。"
                "円弧なら厳密に積分できます。",
            ),
        ),
        Mistake(
            start_heading_taken_for_zero,
            Text(
                "The arc is computed as if the robot started with heading 0. That is right in the robot's own axes; it must "
                "still be turned by theta.",
                "最初の方位が 0 であるかのように円弧を計算しています。"
                "ロボット自身の座標ではそれで正しいのですが、さらに theta だけ回転する必要があります。",
            ),
        ),
        Mistake(
            old_heading_left_out,
            Text(
                "sin and cos of the old heading are missing: only the new heading comes in. An integral has two ends: which "
                "value belongs to the lower one?",
                "新しい方位だけが使われ、元の方位の sin, cos が抜けています。定積分には両端があります。下端の値はいくつですか。",
            ),
        ),
        Mistake(
            arc_turned_backwards,
            Text(
                "The arc has the right shape, but it is turned by -theta instead of theta. Look at the signs of the rotation.",
                "円弧の形は正しいのですが、theta ではなく -theta だけ回転しています。回転の符号を見直しましょう。",
            ),
        ),
        Mistake(
            turn_wrapped,
            Text(
                "On turns by more than half a turn the position is wrong: dtheta is wrapped first, and that makes another, "
                "shorter turn of it. Use dtheta as it comes.",
                "半回転を超える旋回で位置が違います。先に dtheta を折り返しているため、別の(小さな)旋回になっています。"
                "dtheta はそのまま使いましょう。",
            ),
        ),
        Mistake(
            start_forgotten,
            Text(
                "This is the motion alone. The new pose is the old pose plus the motion: where did x, y and theta of the "
                "start go?",
                "これは移動量だけです。新しい姿勢は「元の姿勢 + 移動量」です。出発点の x, y, theta はどこで足しますか。",
            ),
        ),
        Mistake(
            position_forgotten,
            Text(
                "x and y of the start are missing: the motion is added to the old position.",
                "出発点の x, y が足されていません。移動量は元の位置に足します。",
            ),
        ),
        Mistake(
            degrees_in_cos,
            Text(
                "The direction is converted as if it were in degrees. It is in rad already, and np.cos takes rad.",
                "向きを度とみなして変換しています。すでに rad で、np.cos も rad を受け取ります。",
            ),
        ),
        Mistake(
            whole_numbers_cut_off,
            Text(
                "With a pose of whole numbers the decimals are cut off: a copy of an integer array holds integers only. Make "
                "it np.array(pose, dtype=float).",
                "姿勢が整数で渡されると、小数部分が切り捨てられます。整数の配列をコピーすると整数しか入りません。"
                "np.array(pose, dtype=float) としましょう。",
            ),
        ),
        Mistake(
            rounded,
            Text(
                "The result is rounded. The arc is to be exact: round only for display.",
                "結果が丸められています。円弧は厳密に求めます。丸めるのは表示のときだけにしましょう。",
            ),
        ),
        Mistake(
            yaw_left_out,
            Text(
                "Only x and y come back. A pose is (x, y, theta): return all three.",
                "x と y だけが返っています。姿勢は (x, y, theta) の 3 つ組です。3 つとも返しましょう。",
            ),
        ),
    ),
)

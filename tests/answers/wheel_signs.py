"""Answers to wheel_signs(log): right ones in honest styles, wrong ones as students write them."""

import warnings

import numpy as np


def counters(log):
    return np.array(log["counter1"], dtype=float), np.array(log["counter2"], dtype=float)


def ends(log):
    """Return the first and the last tenth of the rows in motion, at least one row each."""
    c1, c2 = counters(log)
    moving = np.flatnonzero((c1 != 0) | (c2 != 0))
    tenth = max(1, len(moving) // 10)
    return moving[:tenth], moving[-tenth:]


def answer(s1, s2, first_is_right):
    return (s1, s2, 1) if first_is_right else (s2, s1, 2)


def first_tenth_and_last_tenth(log):
    c1, c2 = counters(log)
    first, last = ends(log)
    s1, s2 = int(np.sign(c1[first].sum())), int(np.sign(c2[first].sum()))
    return answer(s1, s2, s1 * c1[last].sum() > s2 * c2[last].sum())


def first_moving_row(log):
    signs = []
    for name in ("counter1", "counter2"):
        first = next(c for c in log[name] if c != 0)
        signs.append(1 if first > 0 else -1)
    print("signs", signs)
    ways = [sign * sum(log[name]) for sign, name in zip(signs, ("counter1", "counter2"), strict=True)]
    right = ways.index(max(ways))
    return [signs[right], signs[1 - right], right + 1]


def extremes_of_the_path(log):
    """The sign from where each path is early on, the turn from the heading in the end."""
    c1, c2 = counters(log)
    p1, p2 = np.cumsum(c1), np.cumsum(c2)
    row = np.argmax(np.abs(p1) > 50)
    s1, s2 = np.sign(p1[row]), np.sign(p2[row])
    heading = s1 * p1[-1] - s2 * p2[-1]
    return np.array(answer(s1, s2, heading > 0), dtype=np.float32)


def tries_all(log):
    """Try the eight robots; of those that drive straight first keep the one that turns left."""
    warnings.warn("trying", stacklevel=1)
    c1, c2 = counters(log)
    first, _ = ends(log)
    for right_counter in (1, 2):
        right, left = (c1, c2) if right_counter == 1 else (c2, c1)
        for sign_right in (1, -1):
            for sign_left in (1, -1):
                forward = sign_right * right[first].sum() > 0 and sign_left * left[first].sum() > 0
                if forward and (sign_right * right - sign_left * left).sum() > 0:
                    return sign_right, sign_left, right_counter
    return None


class Calibration:
    """Looks at rows a quarter from each end of the motion."""

    def __call__(self, log):
        both = np.vstack(counters(log))
        moving = np.flatnonzero(np.any(both, axis=0))
        quarter = len(both[0]) // 4
        signs = np.where(np.median(both[:, moving[:quarter]], axis=1) > 0, 1, -1)
        speeds = signs * np.mean(both[:, moving[-quarter:]], axis=1)
        order = np.argsort(-speeds)
        return (*signs[order].tolist(), int(order[0]) + 1)


RIGHT = {
    "first and last tenth": first_tenth_and_last_tenth,
    "first moving row, list, prints": first_moving_row,
    "path and heading, float32": extremes_of_the_path,
    "tries all eight, warns": tries_all,
    "object with __call__, medians": Calibration(),
}


def outer_is_left(log):
    right, left, counter = first_tenth_and_last_tenth(log)
    return left, right, 3 - counter


def names_left_counter(log):
    right, left, counter = first_tenth_and_last_tenth(log)
    return right, left, 3 - counter


def left_sign_first(log):
    right, left, counter = first_tenth_and_last_tenth(log)
    return left, right, counter


def by_counter(log):
    right, left, counter = first_tenth_and_last_tenth(log)
    return (right, left, 1) if counter == 1 else (left, right, 2)


def backwards(log):
    right, left, counter = first_tenth_and_last_tenth(log)
    return -right, -left, counter


def sum_of_everything(log):
    c1, c2 = counters(log)
    s1, s2 = np.sign(c1.sum()), np.sign(c2.sum())
    return answer(s1, s2, s1 * c1.sum() > s2 * c2.sum())


def majority_of_rows(log):
    c1, c2 = counters(log)
    s1, s2 = np.sign(np.sign(c1).sum()), np.sign(np.sign(c2).sum())
    return answer(s1, s2, s1 * c1.sum() > s2 * c2.sum())


def first_row(log):
    c1, c2 = counters(log)
    s1, s2 = np.sign(c1[0]), np.sign(c2[0])
    return answer(s1, s2, s1 * c1.sum() > s2 * c2.sum())


def last_rows(log):
    c1, c2 = counters(log)
    s1, s2, _ = (np.sign(c[ends(log)[0]].sum()) for c in (c1, c2, c1))
    return answer(s1, s2, s1 * c1[-5:].sum() > s2 * c2[-5:].sum())


def unsigned_speeds(log):
    c1, c2 = counters(log)
    first, last = ends(log)
    s1, s2 = np.sign(c1[first].sum()), np.sign(c2[first].sum())
    return answer(s1, s2, abs(c1[last].sum()) > abs(c2[last].sum()))


def raw_speeds(log):
    c1, c2 = counters(log)
    first, _ = ends(log)
    return answer(np.sign(c1[first].sum()), np.sign(c2[first].sum()), c1.sum() > c2.sum())


def from_the_start(log):
    c1, c2 = counters(log)
    first, _ = ends(log)
    s1, s2 = np.sign(c1[first].sum()), np.sign(c2[first].sum())
    return answer(s1, s2, s1 * c1[first].sum() > s2 * c2[first].sum())


def beego(log):
    return -1, 1, 1


def mirrored_pair(log):
    right, _, counter = first_tenth_and_last_tenth(log)
    return right, -right, counter


def left_wheel_stands(log):
    """Takes the wheel that stands still in the turn for the left one; else guesses counter 1 for right."""
    right, left, counter = first_tenth_and_last_tenth(log)
    c1, _ = counters(log)
    _, last = ends(log)
    by_counters = (right, left) if counter == 1 else (left, right)
    if not c1[last].any():
        return by_counters[1], by_counters[0], 2
    return (*by_counters, 1)


def motion_by_pwm(log):
    c1, c2 = counters(log)
    s1, s2 = (1 if np.mean(log[name]) > 0 else -1 for name in ("pwm1", "pwm2"))
    return answer(s1, s2, s1 * c1.sum() > s2 * c2.sum())


def dictionary(log):
    right, left, counter = first_tenth_and_last_tenth(log)
    return {"right": right, "left": left, "counter": counter}


def two_values(log):
    return first_tenth_and_last_tenth(log)[:2]


def truth(log):
    right, left, counter = first_tenth_and_last_tenth(log)
    return right > 0, left > 0, counter


def index(log):
    right, left, counter = first_tenth_and_last_tenth(log)
    return right, left, counter - 1


def symbols(log):
    right, left, counter = first_tenth_and_last_tenth(log)
    return "+" if right > 0 else "-", "+" if left > 0 else "-", counter


def arrays_only(log):
    c1, c2 = log["counter1"], log["counter2"]
    moving = (c1 != 0) | (c2 != 0)
    first = np.flatnonzero(moving)[:5]
    s1, s2 = np.sign(c1[first].sum()), np.sign(c2[first].sum())
    return answer(s1, s2, s1 * c1.sum() > s2 * c2.sum())


def zeroes_the_log(log):
    result = first_tenth_and_last_tenth(log)
    if isinstance(log["counter1"], np.ndarray):
        log["counter1"] *= result[0]
    return result


def halves(log):
    """Takes the first half of the rows for the straight part and the second half for the turn."""
    c1, c2 = counters(log)
    half = len(c1) // 2
    s1, s2 = np.sign(c1[:half].sum()), np.sign(c2[:half].sum())
    return answer(s1, s2, s1 * c1[half:].sum() > s2 * c2[half:].sum())


def turn_to_the_right(log):
    right, left, counter = backwards(log)
    return left, right, 3 - counter


WRONG = {
    "outer wheel is left": (outer_is_left, "right and left exchanged", "plain"),
    "left counter named": (names_left_counter, "3 - right_counter", "plain"),
    "left sign first": (left_sign_first, "order", "plain"),
    "by counter": (by_counter, "signs of counter 1 and 2", "plain"),
    "backwards": (backwards, "both signs", "plain"),
    "sum of everything": (sum_of_everything, "a long turn on the spot", "subtle"),
    "majority of rows": (majority_of_rows, "a long turn on the spot", "subtle"),
    "first row": (first_row, "rest gives 0", "plain"),
    "last five rows": (last_rows, "rest gives a tie", "subtle"),
    "unsigned speeds": (unsigned_speeds, "a tie on the spot", "subtle"),
    "raw speeds": (raw_speeds, "signs not applied", "plain"),
    "from the start": (from_the_start, "straight part decides", "plain"),
    "Beego": (beego, "constant", "plain"),
    "mirrored pair": (mirrored_pair, "left is always minus right", "plain"),
    "left wheel stands": (left_wheel_stands, "one kind of turn only", "subtle"),
    "PWM": (motion_by_pwm, "columns that mean nothing", "subtle"),
    "dictionary": (dictionary, "names", "plain"),
    "two values": (two_values, "counter missing", "plain"),
    "truth": (truth, "True and False", "plain"),
    "index": (index, "from 0", "plain"),
    "symbols": (symbols, "'+' and '-'", "plain"),
    "arrays only": (arrays_only, "fails for lists", "subtle"),
    "changes the log": (zeroes_the_log, "in place", "subtle"),
    "halves": (halves, "the straight part may be a quarter only", "subtle"),
    "all the wrong way round": (turn_to_the_right, "signs and sides", "plain"),
}

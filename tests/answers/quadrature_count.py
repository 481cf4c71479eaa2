"""Answers to quadrature_count(a, b): right ones in honest styles, wrong ones as students write them."""

import itertools
import warnings

import numpy as np


def table_of_states(a, b):
    order = {(0, 0): 0, (1, 0): 1, (1, 1): 2, (0, 1): 3}
    states = [order[int(x), int(y)] for x, y in zip(a, b, strict=True)]
    count, counts = 0, [0]
    for old, new in itertools.pairwise(states):
        count += {0: 0, 1: 1, 3: -1}[(new - old) % 4]
        counts.append(count)
    return counts


def vectorised(a, b):
    a, b = np.asarray(a, int), np.asarray(b, int)
    phase = 2 * b + (a ^ b)
    return np.r_[0, np.cumsum((np.diff(phase) + 1) % 4 - 1)]


def unwrapped_angle(a, b):
    a, b = np.array(a, dtype=float), np.array(b, dtype=float)
    angle = np.unwrap(np.angle((2 * a - 1) + 1j * (2 * b - 1)))
    return -np.round((angle - angle[0]) / (np.pi / 2)) * -1


def cross_product(a, b):
    """A quarter turn of the vector (a, b) about (1/2, 1/2) has a cross product of one sign."""
    x, y = 2 * np.array(a, float) - 1, 2 * np.array(b, float) - 1
    turn = (x[:-1] * y[1:] - y[:-1] * x[1:]) / 2
    return np.concatenate([[0.0], turn.cumsum()]).astype(np.float32)


def edges_of_each_channel(a, b):
    n = len(a)
    counts = [0] * n
    for k in range(1, n):
        step = 0
        if a[k] and not a[k - 1]:
            step = -1 if b[k] else 1
        elif a[k - 1] and not a[k]:
            step = 1 if b[k] else -1
        elif b[k] and not b[k - 1]:
            step = 1 if a[k] else -1
        elif b[k - 1] and not b[k]:
            step = -1 if a[k] else 1
        counts[k] = counts[k - 1] + step
    return tuple(counts)


def text_keys(a, b):
    forward = "00 10 11 01 00"
    print(len(a), "samples")
    pairs = [f"{int(x)}{int(y)}" for x, y in zip(a, b, strict=True)]
    total, out = 0, []
    for k, pair in enumerate(pairs):
        before = pairs[max(k - 1, 0)]
        if pair != before:
            total += 1 if f"{before} {pair}" in forward else -1
        out.append(total)
    return out


def recursive(a, b):
    if len(a) == 1:
        return [0]
    before = recursive(a[:-1], b[:-1])
    moved = bool(a[-1]) != bool(a[-2]) or bool(b[-1]) != bool(b[-2])
    return [*before, before[-1] + moved * (1 if bool(a[-2]) == bool(b[-1]) else -1)]


def warning_in_int16(a, b):
    warnings.warn("decoding", stacklevel=1)
    lookup = np.array([0, -1, 1, 0, 1, 0, 0, -1, -1, 0, 0, 1, 0, 1, -1, 0], dtype=np.int16)
    code = 2 * np.asarray(a, int) + np.asarray(b, int)
    return np.append(np.int16(0), np.cumsum(lookup[4 * code[:-1] + code[1:]], dtype=np.int16))


class Decoder:
    """Keeps the last state, as a microcontroller does."""

    def __call__(self, a, b):
        self.count, self.last = 0, None
        return np.array([self.sample(int(x), int(y)) for x, y in zip(a, b, strict=True)])

    def sample(self, x, y):
        if self.last is not None:
            old_x, old_y = self.last
            self.count += (x ^ old_x) * (1 - 2 * y) * (1 if x else -1) + (y ^ old_y) * (1 if x == y else -1)
        self.last = x, y
        return self.count


RIGHT = {
    "table of states, list": table_of_states,
    "vectorised": vectorised,
    "unwrapped angle, floats": unwrapped_angle,
    "cross product, float32": cross_product,
    "edges one by one, tuple": edges_of_each_channel,
    "text keys, prints": text_keys,
    "recursive": recursive,
    "lookup of 16, int16, warns": warning_in_int16,
    "object with __call__": Decoder(),
}


def a_lags(a, b):
    return [-count for count in table_of_states(a, b)]


def swapped_channels(a, b):
    return vectorised(b, a)


def interrupt_on_a(a, b):
    counts, count = [0], 0
    for k in range(1, len(a)):
        if a[k] != a[k - 1]:
            count += 1 if a[k] != b[k] else -1
        counts.append(count)
    return counts


def interrupt_on_rise_of_b(a, b):
    counts, count = [0], 0
    for k in range(1, len(a)):
        if b[k] and not b[k - 1]:
            count += 1 if a[k] else -1
        counts.append(count)
    return counts


def both_channels_same_rule(a, b):
    counts, count = [0], 0
    for k in range(1, len(a)):
        if a[k] != a[k - 1] or b[k] != b[k - 1]:
            count += 1 if a[k] != b[k] else -1
        counts.append(count)
    return counts


def reversal_ignored(a, b):
    moved = (np.diff(np.asarray(a, int)) != 0) | (np.diff(np.asarray(b, int)) != 0)
    return np.r_[0, np.cumsum(moved)]


def one_direction_for_all(a, b):
    right = vectorised(a, b)
    return np.abs(np.r_[0, np.diff(right)]).cumsum() * np.sign(right[-1])


def gray_code_forgotten(a, b):
    code = [2 * int(x) + int(y) for x, y in zip(a, b, strict=True)]
    return np.r_[0, np.cumsum((np.diff(code) + 1) % 4 - 1)]


def phase_not_unwrapped(a, b):
    order = [0, 3, 1, 2]
    phase = np.array([order[2 * int(x) + int(y)] for x, y in zip(a, b, strict=True)])
    return phase - phase[0]


def modulo_without_shift(a, b):
    a, b = np.asarray(a, int), np.asarray(b, int)
    return np.r_[0, np.cumsum(np.diff(2 * b + (a ^ b)) % 4)]


def starts_one_early(a, b):
    return vectorised(np.r_[0, np.asarray(a, int)], np.r_[0, np.asarray(b, int)])[1:]


def forgets_the_first(a, b):
    return vectorised(a, b)[1:]


def loses_the_last(a, b):
    right = vectorised(a, b)
    return np.r_[right[:-1], right[-2:-1]]


def differences_only(a, b):
    return np.diff(vectorised(a, b), prepend=0)


def drops_step_at_reversal(a, b):
    """The first edge after a change of direction only sets the new direction, as with mechanical play."""
    step = np.diff(vectorised(a, b))
    out, direction = [0], 0
    for s in step:
        out.append(out[-1] + (s if direction in (s, 0) else 0))
        direction = s or direction
    return out


def saturates_at_zero(a, b):
    out = [0]
    for s in np.diff(vectorised(a, b)):
        out.append(max(0, out[-1] + s))
    return out


def works_for_one_cycle(a, b):
    right = vectorised(a, b)
    return np.where(np.abs(right) < 4, right, np.fmod(right, 4))


def total_only(a, b):
    return vectorised(a, b)[-1]


def starts_at_first_edge(a, b):
    right = vectorised(a, b)
    return right - (right[1] if len(right) > 1 else 0)


def quarter_counts(a, b):
    return vectorised(a, b) * 0.25


def int8_count(a, b):
    return vectorised(a, b).astype(np.int8).astype(bool)


WRONG = {
    "A lags": (a_lags, "sign of every step", "plain"),
    "channels swapped": (swapped_channels, "a and b exchanged", "plain"),
    "interrupt on A": (interrupt_on_a, "2x decoding", "plain"),
    "interrupt on rise of B": (interrupt_on_rise_of_b, "1x decoding", "subtle"),
    "same rule for both": (both_channels_same_rule, "edges of B have the wrong sign", "plain"),
    "reversal ignored": (reversal_ignored, "every edge counts up", "plain"),
    "one direction": (one_direction_for_all, "the sign of the end for the whole drive", "subtle"),
    "Gray code forgotten": (gray_code_forgotten, "states in binary order", "plain"),
    "phase not unwrapped": (phase_not_unwrapped, "falls back after every cycle", "plain"),
    "modulo without shift": (modulo_without_shift, "a step back counts +3", "subtle"),
    "state before the first is 00": (starts_one_early, "first sample not 0", "subtle"),
    "first forgotten": (forgets_the_first, "N-1 values", "plain"),
    "last repeated": (loses_the_last, "the last edge is not counted", "subtle"),
    "differences": (differences_only, "steps, not counts", "plain"),
    "play": (drops_step_at_reversal, "the first edge back is lost", "subtle"),
    "stops at zero": (saturates_at_zero, "never negative", "subtle"),
    "one cycle only": (works_for_one_cycle, "wraps at four", "subtle"),
    "total only": (total_only, "one number", "plain"),
    "starts at the first edge": (starts_at_first_edge, "shifted by the second sample's count", "subtle"),
    "cycles": (quarter_counts, "divided by four", "plain"),
    "truth values": (int8_count, "True and False", "plain"),
}

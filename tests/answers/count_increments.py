"""Answers to count_increments(counter): right ones in honest styles, wrong ones as students write them."""

import itertools
import struct
import warnings

import numpy as np


def conditional(counter):
    out = []
    for k in range(1, len(counter)):
        step = int(counter[k]) - int(counter[k - 1])
        out.append(step - 65536 if step > 32768 else step + 65536 if step < -32768 else step)
    return out


def shifted_modulo(counter):
    return np.mod(np.diff(np.array(counter, dtype=np.int64)) + 2**15, 2**16) - 2**15


def rounded_turns(counter):
    step = np.diff(np.array(counter, dtype=float))
    return step - 65536 * np.round(step / 65536)


def angle_of_pointer(counter):
    """Counts as angles of a pointer; the turn between two readings is the phase of their quotient."""
    pointer = np.exp(2j * np.pi * np.array(counter, dtype=float) / 65536)
    return np.rint(np.angle(pointer[1:] / pointer[:-1]) * 65536 / (2 * np.pi))


def two_bytes(counter):
    print(len(counter), "readings")
    wrapped = [(int(new) - int(old)) & 0xFFFF for old, new in itertools.pairwise(counter)]
    return tuple(struct.unpack("<h", struct.pack("<H", w))[0] for w in wrapped)


def unwrapped_then_differenced(counter):
    counter = [int(c) for c in counter]
    turns, total = 0, [counter[0]]
    for old, new in itertools.pairwise(counter):
        if new - old < -33000:
            turns += 1
        if new - old > 33000:
            turns -= 1
        total.append(new + 65536 * turns)
    return np.diff(total).astype(np.float32)


def recursive(counter):
    if len(counter) < 2:
        return []
    step = int(counter[1]) - int(counter[0])
    return [min(step, step - 65536, step + 65536, key=abs), *recursive(counter[1:])]


def masks_with_warning(counter):
    c = np.asarray(counter).astype(int)
    step = c[1:] - c[:-1]
    warnings.warn(f"{np.sum(abs(step) > 32767)} wraps", stacklevel=1)
    return step + 65536 * (step < -32767) - 65536 * (step > 32767)


class Int16:
    """Lets the 16-bit type do the work."""

    def __call__(self, counter):
        c = np.array(counter).astype(np.int64).astype(np.int16)
        return np.subtract(c[1:], c[:-1], dtype=np.int16)


RIGHT = {
    "conditional, list": conditional,
    "shifted modulo": shifted_modulo,
    "rounded turns, floats": rounded_turns,
    "angle of a pointer, complex": angle_of_pointer,
    "two bytes, tuple, prints": two_bytes,
    "unwrapped then differenced, float32": unwrapped_then_differenced,
    "recursive": recursive,
    "masks, warns": masks_with_warning,
    "object with __call__, int16": Int16(),
}


def plain_difference(counter):
    return [int(b) - int(a) for a, b in itertools.pairwise(counter)]


def as_delivered(counter):
    c = np.asarray(counter)
    return c[1:] - c[:-1]


def forward_only(counter):
    return [step + 65536 if step < -40000 else step for step in plain_difference(counter)]


def backward_only(counter):
    return [step - 65536 if step > 40000 else step for step in plain_difference(counter)]


def off_by_one(counter):
    return [s + 65535 if s < -32768 else s - 65535 if s > 32768 else s for s in plain_difference(counter)]


def half_range(counter):
    return [s + 32768 if s < -32768 else s - 32768 if s > 32768 else s for s in plain_difference(counter)]


def ten_thousand(counter):
    return [s + 65536 if s < -10000 else s - 65536 if s > 10000 else s for s in plain_difference(counter)]


def fifty_thousand(counter):
    return [s + 65536 if s < -50000 else s - 65536 if s > 50000 else s for s in plain_difference(counter)]


def unsigned(counter):
    return [(int(b) - int(a)) & 0xFFFF for a, b in itertools.pairwise(counter)]


def outliers_dropped(counter):
    return [s for s in plain_difference(counter) if abs(s) < 33000]


def outliers_zeroed(counter):
    return [s if abs(s) < 33000 else 0 for s in plain_difference(counter)]


def outliers_interpolated(counter):
    s = np.array(plain_difference(counter), dtype=float)
    good = np.abs(s) < 33000
    if good.any():
        s[~good] = np.interp(np.flatnonzero(~good), np.flatnonzero(good), s[good])
    return s


def median_filter(counter):
    s = np.array(plain_difference(counter), dtype=float)
    return np.where(np.abs(s) < 33000, s, np.median(s) if len(s) else 0)


def limited(counter):
    return np.clip(plain_difference(counter), -32768, 32767)


def first_only(counter):
    s = plain_difference(counter)
    for k, step in enumerate(s):
        if abs(step) > 32768:
            s[k] -= 65536 if step > 0 else -65536
            break
    return s


def unwrapped_angle(counter):
    return np.diff(np.unwrap(np.array(counter, float)))


def unwrapped_not_differenced(counter):
    return np.unwrap(np.array(counter, float), period=65536)


def with_leading_zero(counter):
    return [0, *conditional(counter)]


def with_first_reading(counter):
    return [int(counter[0]), *conditional(counter)]


def distances(counter):
    return [abs(s) for s in conditional(counter)]


def backwards_in_time(counter):
    return [-s for s in conditional(counter)]


def one_short(counter):
    return conditional(counter[:-1])


def total(counter):
    return sum(conditional(counter))


def shifts_its_input(counter):
    if isinstance(counter, np.ndarray) and counter.dtype == np.int64:
        counter += 32768
    return shifted_modulo(counter)


def needs_two(counter):
    result = shifted_modulo(counter)
    return result if len(counter) > 1 else np.zeros(1)


def assumes_small_steps(counter):
    """Unwraps the counter whenever its sign changes."""
    c = np.array(counter, dtype=np.int64)
    turn = np.cumsum(np.r_[0, (c[:-1] > 0) & (c[1:] < 0)].astype(int) - np.r_[0, (c[:-1] < 0) & (c[1:] > 0)].astype(int))
    return np.diff(c + 65536 * turn)


WRONG = {
    "plain difference": (plain_difference, "wrap ignored", "plain"),
    "as delivered": (as_delivered, "right for int16 arrays only", "subtle"),
    "forward only": (forward_only, "wraps upwards only", "subtle"),
    "backward only": (backward_only, "wraps downwards only", "subtle"),
    "65535": (off_by_one, "one count at each wrap", "plain"),
    "32768": (half_range, "half the range", "plain"),
    "from 10000": (ten_thousand, "fast wheels taken for wraps", "subtle"),
    "from 50000": (fifty_thousand, "wraps of fast wheels missed", "subtle"),
    "unsigned": (unsigned, "backwards gives 65535", "plain"),
    "outliers dropped": (outliers_dropped, "shorter", "plain"),
    "outliers zeroed": (outliers_zeroed, "counts lost", "plain"),
    "outliers interpolated": (outliers_interpolated, "guess", "subtle"),
    "outliers to the median": (median_filter, "guess", "subtle"),
    "limited": (limited, "clipped at 16 bits", "plain"),
    "first only": (first_only, "a second wrap stays", "subtle"),
    "unwrapped as an angle": (unwrapped_angle, "period 2 pi", "plain"),
    "not differenced": (unwrapped_not_differenced, "N values of the counter", "plain"),
    "leading zero": (with_leading_zero, "N values", "plain"),
    "first reading": (with_first_reading, "N values", "plain"),
    "distances": (distances, "sign lost", "plain"),
    "backwards": (backwards_in_time, "old minus new", "plain"),
    "one short": (one_short, "last reading unused", "plain"),
    "total": (total, "one number", "plain"),
    "shifts its input": (shifts_its_input, "in place", "subtle"),
    "one reading": (needs_two, "(1,) instead of (0,)", "subtle"),
    "wrap at a change of sign": (assumes_small_steps, "wrong when passing 0", "subtle"),
}

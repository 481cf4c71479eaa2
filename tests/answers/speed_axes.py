"""Graphs for speed_axes: right ones in honest styles, wrong ones as students draw them. RESULT is set to what must be shown."""

import matplotlib.pyplot as plt
import numpy as np

RESULT = {}


def plain():
    _, ax = plt.subplots()
    ax.plot(RESULT["time"], RESULT["velocity"])
    ax.set_xlabel("t [s]")
    ax.set_ylabel("v [m/s]")
    return ax


def from_row_1():
    plt.figure()
    plt.plot(RESULT["time"][1:], RESULT["velocity"][1:], lw=0.5)
    plt.xlabel("時間 [秒]")
    plt.ylabel("速度 [m/s]")
    return plt.gca()


def first_speed_unknown():
    ax = plt.subplot(2, 1, 2)
    v = RESULT["velocity"].copy()
    v[0] = np.nan
    ax.plot(RESULT["time"], v, color="k")
    ax.axhline(0, ls=":")
    ax.set(xlabel="Time (s)", ylabel="Velocity (m/s)")
    return ax


def first_speed_repeated():
    ax = plt.axes()
    ax.plot(RESULT["time"], np.append(0.3, RESULT["velocity"][1:]))
    ax.set(xlabel="t / s", ylabel="v / (m/s)", ylim=(-2, 2))
    return ax


def reverse_in_red():
    _, ax = plt.subplots()
    back = RESULT["velocity"] < 0
    ax.plot(RESULT["time"][~back], RESULT["velocity"][~back], ".", ms=1)
    ax.plot(RESULT["time"][back], RESULT["velocity"][back], "r.", ms=1)
    ax.set(xlabel="経過時間（s）", ylabel="並進速度（m/s）")
    return ax


def smoothed_on_top():
    _, ax = plt.subplots()
    ax.plot(RESULT["time"], np.convolve(RESULT["velocity"], np.ones(11) / 11, "same"), "r", zorder=3)
    ax.plot(RESULT["time"], RESULT["velocity"], alpha=0.3)
    ax.fill_between(RESULT["time"], RESULT["velocity"], alpha=0.2)
    ax.set(xlabel="$t$ [s]", ylabel="$v$ [m s$^{-1}$]")
    return ax


def left_of_twins():
    _, ax = plt.subplots()
    ax.plot(RESULT["time"], RESULT["velocity"])
    ax.twinx().plot(RESULT["time"], RESULT["yaw_rate"], "g")
    ax.set(xlabel="time, s", ylabel="signed speed, m/s")
    return ax


RIGHT = {
    "plain": plain,
    "without row 0, Japanese": from_row_1,
    "NaN in row 0": first_speed_unknown,
    "something else in row 0": first_speed_repeated,
    "reverse in red": reverse_in_red,
    "smoothed on top": smoothed_on_top,
    "left of twins": left_of_twins,
}


def finished(ax, xlabel="t [s]", ylabel="v [m/s]"):
    ax.set(xlabel=xlabel, ylabel=ylabel)
    return ax


def graph(t, v, *style, **how):
    _, ax = plt.subplots()
    ax.plot(t, v, *style, **how)
    return ax


def without_sign():
    return finished(graph(RESULT["time"], np.abs(RESULT["velocity"])))


def from_the_path():
    speed = np.hypot(np.diff(RESULT["x"]), np.diff(RESULT["y"])) / np.diff(RESULT["time"])
    return finished(graph(RESULT["time"][1:], speed))


def from_the_path_with_row_0():
    speed = np.hypot(np.diff(RESULT["x"]), np.diff(RESULT["y"])) / np.diff(RESULT["time"])
    return finished(graph(RESULT["time"], np.append(0, speed)))


def mean_dt():
    way = RESULT["velocity"][1:] * np.diff(RESULT["time"])
    return finished(graph(RESULT["time"], np.append(0, way / np.diff(RESULT["time"]).mean())))


def dt_of_the_slides():
    way = RESULT["velocity"][1:] * np.diff(RESULT["time"])
    return finished(graph(RESULT["time"], np.append(0, way / 0.005)))


def not_divided():
    way = RESULT["velocity"][1:] * np.diff(RESULT["time"])
    return finished(graph(RESULT["time"], np.append(0, way)))


def along_x():
    return finished(graph(RESULT["time"], np.gradient(RESULT["x"], RESULT["time"])))


def only_smoothed():
    return finished(graph(RESULT["time"], np.convolve(RESULT["velocity"], np.ones(51) / 51, "same")))


def way_instead():
    way = np.cumsum(np.append(0, RESULT["velocity"][1:] * np.diff(RESULT["time"])))
    return finished(graph(RESULT["time"], way))


def right_wheel():
    return finished(graph(RESULT["time"], RESULT["velocity"] + RESULT["yaw_rate"] * -0.3045 / 2))


def sum_of_the_wheels():
    return finished(graph(RESULT["time"], 2 * RESULT["velocity"]))


def yaw_rate():
    return finished(graph(RESULT["time"], RESULT["yaw_rate"]))


def kilometres_per_hour():
    return finished(graph(RESULT["time"], 3.6 * RESULT["velocity"]), ylabel="v [km/h]")


def mirrored():
    return finished(graph(RESULT["time"], -RESULT["velocity"]))


def shifted_by_a_row():
    return finished(graph(RESULT["time"][:-1], RESULT["velocity"][1:]))


def unix_time():
    return finished(graph(RESULT["time"] + 1.7e9, RESULT["velocity"]))


def minutes():
    return finished(graph(RESULT["time"] / 60, RESULT["velocity"]), xlabel="t [min]")


def rows():
    return finished(graph(np.arange(len(RESULT["time"])), RESULT["velocity"]))


def no_labels():
    return graph(RESULT["time"], RESULT["velocity"])


def unit_forgotten():
    return finished(graph(RESULT["time"], RESULT["velocity"]), "時刻", "速度")


def metres():
    return finished(graph(RESULT["time"], RESULT["velocity"]), ylabel="v [m]")


def units_only():
    return finished(graph(RESULT["time"], RESULT["velocity"]), "[s]", "[m/s]")


def reverse_cut_off():
    ax = finished(graph(RESULT["time"], RESULT["velocity"]))
    ax.set_ylim(0, 1)
    return ax


def logarithmic():
    ax = finished(graph(RESULT["time"], RESULT["velocity"]))
    ax.set_yscale("log")
    return ax


def forward_only():
    ahead = RESULT["velocity"] >= 0
    return finished(graph(RESULT["time"][ahead], RESULT["velocity"][ahead]))


def means_of_ten():
    n = len(RESULT["time"]) // 10 * 10
    return finished(graph(RESULT["time"][:n:10], RESULT["velocity"][:n].reshape(-1, 10).mean(axis=1)))


def bars():
    _, ax = plt.subplots()
    ax.bar(RESULT["time"][::20], RESULT["velocity"][::20], 0.1)
    return finished(ax)


WRONG = {
    "no sign": (without_sign, "reverse drawn as forward", "plain"),
    "from the path": (from_the_path, "hypot is never negative", "plain"),
    "from the path, row 0": (from_the_path_with_row_0, "hypot is never negative", "plain"),
    "mean dt": (mean_dt, "jitter goes into the speed", "subtle"),
    "5 ms": (dt_of_the_slides, "nominal dt of another robot", "plain"),
    "not divided by dt": (not_divided, "metres per row", "plain"),
    "along x": (along_x, "dx/dt", "subtle"),
    "smoothed only": (only_smoothed, "not the samples", "subtle"),
    "way": (way_instead, "distance over time", "subtle"),
    "right wheel": (right_wheel, "one wheel only", "subtle"),
    "sum": (sum_of_the_wheels, "not halved", "plain"),
    "yaw rate": (yaw_rate, "another quantity", "plain"),
    "km/h": (kilometres_per_hour, "m/s asked for", "plain"),
    "mirrored": (mirrored, "signs of the wheels", "plain"),
    "shifted": (shifted_by_a_row, "one row early", "subtle"),
    "Unix time": (unix_time, "from the start asked for", "plain"),
    "minutes": (minutes, "seconds asked for", "plain"),
    "rows": (rows, "row numbers", "plain"),
    "no labels": (no_labels, "labels missing", "plain"),
    "no units": (unit_forgotten, "units missing", "plain"),
    "metres": (metres, "unit of a way", "plain"),
    "units only": (units_only, "quantities missing", "plain"),
    "reverse cut off": (reverse_cut_off, "ylim from 0", "plain"),
    "logarithmic": (logarithmic, "negative speeds vanish", "plain"),
    "forward only": (forward_only, "reverse left out", "plain"),
    "means of ten": (means_of_ten, "thinned out", "subtle"),
    "bars": (bars, "neither line nor scatter", "plain"),
}

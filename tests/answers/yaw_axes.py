"""Graphs for yaw_axes: right ones in honest styles, wrong ones as students draw them. RESULT is set to what must be shown."""

import matplotlib.pyplot as plt
import numpy as np

RESULT = {}


def radians():
    _, ax = plt.subplots()
    ax.plot(RESULT["time"], RESULT["theta"])
    ax.set_xlabel("t [s]")
    ax.set_ylabel("yaw [rad]")
    return ax


def degrees_in_japanese():
    plt.figure()
    plt.plot(RESULT["time"], np.degrees(RESULT["theta"]), ".-", ms=1)
    plt.xlabel("時刻 (秒)")
    plt.ylabel("ヨー角 (度)")
    plt.grid(True)
    return plt.gca()


def latex_and_references():
    ax = plt.axes()
    for turns in range(-3, 4):
        ax.axhline(2 * np.pi * turns, color="gray", lw=0.5)
    ax.plot(RESULT["time"], RESULT["theta"] * 0.99, "--", label="truth")
    ax.plot(RESULT["time"], RESULT["theta"], label=r"$\theta$")
    ax.set(xlabel=r"$t\ [\mathrm{s}]$", ylabel=r"$\theta\ [\mathrm{rad}]$", title="yaw", xlim=(-5, 60), ylim=(-30, 30))
    ax.legend()
    return ax


def middle_of_three_with_one_time_axis():
    _, axes = plt.subplots(3, 1, sharex=True)
    for ax, key in zip(axes, ("x", "theta", "velocity"), strict=True):
        ax.plot(RESULT["time"], RESULT[key])
    axes[1].set_ylabel("heading, radians")
    axes[2].set_xlabel("time, seconds")
    return axes[1]


def twin_of_the_speed():
    _, ax = plt.subplots()
    ax.plot(RESULT["time"], RESULT["velocity"])
    ax.set(xlabel="Time (sec)", ylabel="Speed (m/s)")
    twin = ax.twinx()
    twin.plot(RESULT["time"], np.rad2deg(RESULT["theta"]), "r")
    twin.set_ylabel("方位 [°]")
    return twin


def stairs_of_lists():
    _, ax = plt.subplots()
    ax.step(list(RESULT["time"]), list(RESULT["theta"]), where="post")
    ax.set(xlabel="経過時間 / s", ylabel="ψ / rad")
    ax.invert_yaxis()  # clockwise upwards
    return ax


def scatter():
    _, ax = plt.subplots()
    ax.scatter(RESULT["time"], RESULT["theta"] * 180 / np.pi, 1)
    ax.set(xlabel="time in s", ylabel="orientation [deg] (unwrapped)")
    return ax


RIGHT = {
    "radians": radians,
    "degrees, pyplot, Japanese": degrees_in_japanese,
    "LaTeX, references, wide limits": latex_and_references,
    "one of three with a shared time axis": middle_of_three_with_one_time_axis,
    "twin Axes": twin_of_the_speed,
    "steps, lists, y downwards": stairs_of_lists,
    "scatter in degrees": scatter,
}


def finished(ax, xlabel="t [s]", ylabel="yaw [rad]"):
    ax.set(xlabel=xlabel, ylabel=ylabel)
    return ax


def graph(t, yaw, *style, **how):
    _, ax = plt.subplots()
    ax.plot(t, yaw, *style, **how)
    return ax


def wrapped():
    return finished(graph(RESULT["time"], np.arctan2(np.sin(RESULT["theta"]), np.cos(RESULT["theta"]))))


def wrapped_in_degrees():
    return finished(graph(RESULT["time"], np.degrees(RESULT["theta"]) % 360), ylabel="yaw [deg]")


def degrees_said_to_be_radians():
    return finished(graph(RESULT["time"], np.degrees(RESULT["theta"])))


def radians_said_to_be_degrees():
    return finished(graph(RESULT["time"], RESULT["theta"]), ylabel="ヨー角 [°]")


def no_unit():
    return finished(graph(RESULT["time"], RESULT["theta"]), ylabel="yaw")


def no_time_label():
    return finished(graph(RESULT["time"], RESULT["theta"]), xlabel="")


def label_of_the_speed():
    return finished(graph(RESULT["time"], RESULT["theta"]), ylabel="v [m/s]")


def unit_of_the_rate():
    return finished(graph(RESULT["time"], RESULT["theta"]), ylabel="yaw [rad/s]")


def unix_time():
    return finished(graph(RESULT["time"] + 1.7131473e9, RESULT["theta"]))


def unix_time_in_float32():
    return finished(graph(np.float32(RESULT["time"] + 1.7131473e9), RESULT["theta"]))


def over_rows():
    return finished(graph(np.arange(len(RESULT["theta"])), RESULT["theta"]))


def without_time():
    _, ax = plt.subplots()
    ax.plot(RESULT["theta"])
    return finished(ax)


def milliseconds():
    return finished(graph(RESULT["time"] * 1e3, RESULT["theta"]), xlabel="t [ms]")


def nominal_time():
    return finished(graph(np.arange(len(RESULT["theta"])) * 0.01, RESULT["theta"]))


def yaw_rate():
    return finished(graph(RESULT["time"], RESULT["yaw_rate"]))


def axes_exchanged():
    return finished(graph(RESULT["theta"], RESULT["time"]))


def mirrored():
    return finished(graph(RESULT["time"], -RESULT["theta"]))


def sine():
    return finished(graph(RESULT["time"], np.sin(RESULT["theta"])))


def half_the_yaw():
    return finished(graph(RESULT["time"], RESULT["theta"] / 2))


def some_rows():
    return finished(graph(RESULT["time"][::25], RESULT["theta"][::25], "o"))


def first_seconds():
    ax = finished(graph(RESULT["time"], RESULT["theta"]))
    ax.set_xlim(0, 5)
    return ax


def cut_at_half_a_turn():
    ax = finished(graph(RESULT["time"], RESULT["theta"]))
    ax.set_ylim(-np.pi, np.pi)
    return ax


def hidden():
    return finished(graph(RESULT["time"], RESULT["theta"], visible=False))


def logarithmic_time():
    ax = finished(graph(RESULT["time"], RESULT["theta"]))
    ax.set_xscale("log")
    return ax


def time_backwards():
    ax = finished(graph(RESULT["time"], RESULT["theta"]))
    ax.set_xlim(RESULT["time"][-1], 0)
    return ax


WRONG = {
    "wrapped": (wrapped, "jumps at half a turn", "plain"),
    "wrapped, degrees": (wrapped_in_degrees, "modulo 360", "plain"),
    "degrees labelled rad": (degrees_said_to_be_radians, "unit and numbers differ", "plain"),
    "radians labelled deg": (radians_said_to_be_degrees, "unit and numbers differ", "plain"),
    "no unit": (no_unit, "unit missing", "plain"),
    "no time label": (no_time_label, "label missing", "plain"),
    "label of the speed": (label_of_the_speed, "copied", "plain"),
    "unit of the rate": (unit_of_the_rate, "rad/s", "plain"),
    "Unix time": (unix_time, "from the start asked for", "plain"),
    "Unix time in float32": (unix_time_in_float32, "steps of 128 s", "plain"),
    "rows": (over_rows, "row numbers", "plain"),
    "no time": (without_time, "plot(y)", "plain"),
    "milliseconds": (milliseconds, "seconds asked for", "plain"),
    "nominal time": (nominal_time, "equal steps", "subtle"),
    "yaw rate": (yaw_rate, "not integrated", "plain"),
    "axes exchanged": (axes_exchanged, "time upwards", "plain"),
    "mirrored": (mirrored, "abs(tread)", "plain"),
    "sine": (sine, "another function of it", "subtle"),
    "half": (half_the_yaw, "halved", "subtle"),
    "some rows": (some_rows, "thinned out", "plain"),
    "first seconds": (first_seconds, "cut off", "plain"),
    "cut at half a turn": (cut_at_half_a_turn, "cut off", "subtle"),
    "hidden": (hidden, "invisible", "plain"),
    "logarithmic time": (logarithmic_time, "log axis", "plain"),
    "time backwards": (time_backwards, "to the left", "subtle"),
}

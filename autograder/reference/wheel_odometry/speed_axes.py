"""speed_axes: the speed of the practical over time, with its sign (slides 000)."""

from functools import partial

import numpy as np

from autograder.exercise import GraphExercise, Mistake
from autograder.reference.wheel_odometry.practical import practical_odometry
from course.graphs import FAULTS, Structure, graph_fault

STRUCTURE = Structure(x="time", y="velocity")


def nothing_drawn(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def line_hidden(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["velocity"], visible=False)
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def samples_missing(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"][::10], shown["velocity"][::10])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def points_in_another_order(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    order = np.argsort(shown["velocity"])
    ax.plot(shown["time"][order], shown["velocity"][order])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def axes_exchanged(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["velocity"], shown["time"])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def another_quantity_drawn(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["yaw_rate"])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def time_not_from_the_start(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"] + 1713147300.25, shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def row_numbers_for_time(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def time_in_another_unit(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(1000 * shown["time"], shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def equal_time_steps(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(np.arange(len(shown["time"])) * 0.01, shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def speed_without_sign(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], np.abs(shown["velocity"]))
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def speed_with_one_dt(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ways = shown["velocity"][1:] * np.diff(shown["time"])
    ax.plot(shown["time"][1:], ways / 0.01)
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def sign_reversed(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], -shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def another_scale(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], 3.6 * shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    return ax


def cut_off(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    ax.set_xlim(shown["time"].min(), np.median(shown["time"]))
    return ax


def other_scale(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    ax.set_xscale("symlog")
    return ax


def x_axis_turned_round(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="v [m/s]")
    ax.invert_xaxis()
    return ax


def label_missing(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["velocity"])
    ax.set_xlabel("t [s]")
    return ax


def quantity_missing(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="[m/s]")
    return ax


def another_quantity_named(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="yaw [m/s]")
    return ax


def unit_missing(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="v")
    return ax


def another_unit(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["velocity"])
    ax.set(xlabel="t [s]", ylabel="v [km/h]")
    return ax


MISTAKES = (
    nothing_drawn,
    line_hidden,
    samples_missing,
    points_in_another_order,
    axes_exchanged,
    another_quantity_drawn,
    time_not_from_the_start,
    row_numbers_for_time,
    time_in_another_unit,
    equal_time_steps,
    speed_without_sign,
    speed_with_one_dt,
    sign_reversed,
    another_scale,
    cut_off,
    other_scale,
    x_axis_turned_round,
    label_missing,
    quantity_missing,
    another_quantity_named,
    unit_missing,
    another_unit,
)
EXERCISE = GraphExercise(
    name="speed_axes",
    notebook="odometry/wheel_odometry",
    points=5,
    drawn_from=practical_odometry,
    fault=partial(graph_fault, STRUCTURE),
    mistakes=tuple(Mistake(wrong, FAULTS[wrong.__name__].text) for wrong in MISTAKES),
    structure=STRUCTURE,
)

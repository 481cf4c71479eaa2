"""yaw_axes: the yaw of the practical over time, not wrapped (slides 000)."""

from functools import partial

import numpy as np

from autograder.exercise import GraphExercise, Mistake
from autograder.reference.wheel_odometry.practical import practical_odometry
from course.graphs import FAULTS, Structure, graph_fault

STRUCTURE = Structure(x="time", y="theta")


def nothing_drawn(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def line_hidden(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["theta"], visible=False)
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def samples_missing(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"][::10], shown["theta"][::10])
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def points_in_another_order(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    order = np.argsort(shown["theta"])
    ax.plot(shown["time"][order], shown["theta"][order])
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def axes_exchanged(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["theta"], shown["time"])
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def another_quantity_drawn(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["yaw_rate"])
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def time_not_from_the_start(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"] + 1713147300.25, shown["theta"])
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def row_numbers_for_time(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["theta"])
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def time_in_another_unit(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(1000 * shown["time"], shown["theta"])
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def equal_time_steps(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(np.arange(len(shown["time"])) * 0.01, shown["theta"])
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def yaw_wrapped(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], ((shown["theta"] + np.pi) % (2 * np.pi)) - np.pi)
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def rad_labelled_as_deg(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["theta"])
    ax.set(xlabel="t [s]", ylabel="yaw [deg]")
    return ax


def deg_labelled_as_rad(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], np.rad2deg(shown["theta"]))
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def sign_reversed(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], -shown["theta"])
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    return ax


def cut_off(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["theta"])
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    ax.set_xlim(shown["time"].min(), np.median(shown["time"]))
    return ax


def other_scale(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["theta"])
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    ax.set_xscale("symlog")
    return ax


def x_axis_turned_round(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["theta"])
    ax.set(xlabel="t [s]", ylabel="yaw [rad]")
    ax.invert_xaxis()
    return ax


def label_missing(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["theta"])
    ax.set_xlabel("t [s]")
    return ax


def quantity_missing(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["theta"])
    ax.set(xlabel="t [s]", ylabel="[rad]")
    return ax


def another_quantity_named(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["theta"])
    ax.set(xlabel="t [s]", ylabel="v [rad]")
    return ax


def unit_missing(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["theta"])
    ax.set(xlabel="t [s]", ylabel="yaw")
    return ax


def another_unit(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["time"], shown["theta"])
    ax.set(xlabel="t [s]", ylabel="yaw [km/h]")
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
    yaw_wrapped,
    rad_labelled_as_deg,
    deg_labelled_as_rad,
    sign_reversed,
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
    name="yaw_axes",
    notebook="odometry/wheel_odometry",
    points=5,
    drawn_from=practical_odometry,
    fault=partial(graph_fault, STRUCTURE),
    mistakes=tuple(Mistake(wrong, FAULTS[wrong.__name__].text) for wrong in MISTAKES),
    structure=STRUCTURE,
)

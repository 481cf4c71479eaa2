"""xy_axes: the path of the practical, y over x, a metre as long one way as the other (slides 000)."""

from functools import partial

import numpy as np

from autograder.exercise import GraphExercise, Mistake
from autograder.reference.wheel_odometry.practical import practical_odometry
from course.graphs import FAULTS, Structure, graph_fault

STRUCTURE = Structure(x="x", y="y", equal_aspect=True)


def nothing_drawn(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal")
    return ax


def line_hidden(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"], shown["y"], visible=False)
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal")
    return ax


def samples_missing(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"][::10], shown["y"][::10])
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal")
    return ax


def points_in_another_order(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    order = np.argsort(shown["y"])
    ax.plot(shown["x"][order], shown["y"][order])
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal")
    return ax


def axes_exchanged(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["y"], shown["x"])
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal")
    return ax


def another_quantity_drawn(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"], shown["theta"])
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal")
    return ax


def sign_reversed(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"], -shown["y"])
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal")
    return ax


def another_scale(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(100 * shown["x"], 100 * shown["y"])
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal")
    return ax


def cut_off(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"], shown["y"])
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal")
    ax.set_xlim(shown["x"].min(), np.median(shown["x"]))
    return ax


def other_scale(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"], shown["y"])
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal")
    ax.set_xscale("symlog")
    return ax


def x_axis_turned_round(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"], shown["y"])
    ax.set(xlabel="x [m]", ylabel="y [m]")
    ax.set_aspect("equal")
    ax.invert_xaxis()
    return ax


def label_missing(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"], shown["y"])
    ax.set_xlabel("x [m]")
    ax.set_aspect("equal")
    return ax


def quantity_missing(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"], shown["y"])
    ax.set(xlabel="x [m]", ylabel="[m]")
    ax.set_aspect("equal")
    return ax


def another_quantity_named(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"], shown["y"])
    ax.set(xlabel="x [m]", ylabel="time [m]")
    ax.set_aspect("equal")
    return ax


def unit_missing(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"], shown["y"])
    ax.set(xlabel="x [m]", ylabel="y")
    ax.set_aspect("equal")
    return ax


def another_unit(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"], shown["y"])
    ax.set(xlabel="x [m]", ylabel="y [km/h]")
    ax.set_aspect("equal")
    return ax


def aspect_not_equal(shown):
    import matplotlib.pyplot as plt

    ax = plt.figure().add_subplot()
    ax.plot(shown["x"], shown["y"])
    ax.set(xlabel="x [m]", ylabel="y [m]")
    return ax


MISTAKES = (
    nothing_drawn,
    line_hidden,
    samples_missing,
    points_in_another_order,
    axes_exchanged,
    another_quantity_drawn,
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
    aspect_not_equal,
)
EXERCISE = GraphExercise(
    name="xy_axes",
    notebook="odometry/wheel_odometry",
    points=5,
    drawn_from=practical_odometry,
    fault=partial(graph_fault, STRUCTURE),
    mistakes=tuple(Mistake(wrong, FAULTS[wrong.__name__].text) for wrong in MISTAKES),
    structure=STRUCTURE,
)

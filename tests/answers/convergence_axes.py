"""Graphs for convergence_axes: factories without arguments that draw a graph and return its Axes, right ones and wrong ones."""

import math

import matplotlib.pyplot as plt
import numpy as np

AXES = True
COUNTS = np.array([4, 8, 16, 32, 64])


def euler(f, a, b, n):
    h = (b - a) / n
    return h * math.fsum(f(a + k * h) for k in range(n))


def trapezoid(f, a, b, n):
    return (euler(f, a, b, n) + euler(f, b, a, n) * -1) / 2


def errors(rule, f, exact, a=0.0, b=1.0, counts=COUNTS):
    return np.array([abs(rule(f, a, b, int(n)) - exact) for n in counts])


E1, T1 = errors(euler, math.exp, math.e - 1), errors(trapezoid, math.exp, math.e - 1)
H1 = 1 / COUNTS


def drawn(*lines, how="loglog", legend=True, **settings):
    """Draw lines (x, y, keywords of plot) on new Axes."""
    _, ax = plt.subplots()
    for x, y, look in lines:
        getattr(ax, how)(x, y, **look)
    ax.set(**{"xlabel": "h", "ylabel": "error", **settings})
    if legend:
        ax.legend()
    return ax


def two(x=H1, e=E1, t=T1, names=("Euler", "trapezoid"), **more):
    return drawn((x, e, {"label": names[0]}), (x, t, {"label": names[1]}), **more)


def pyplot():
    plt.figure()
    plt.loglog(H1, E1, "o", label="オイラー法")
    plt.loglog(H1, T1, "s", label="台形公式")
    plt.xlabel("刻み幅 h")
    plt.ylabel("誤差")
    plt.legend()
    return plt.gca()


def down_to_rounding():
    n = 4 ** np.arange(1, 13)
    t = [abs(np.trapezoid(np.sin(x), x) - (1 - math.cos(1))) for x in (np.linspace(0, 1, k + 1) for k in n[:-1])]
    e = [abs(np.sum(np.sin(np.arange(k) / k)) / k - (1 - math.cos(1))) for k in n[:-1]]
    return two(1 / n[:-1], e, t)


def with_a_floor():
    h = 2.0 ** -np.arange(2, 30, 3)
    return two(h, 0.5 * h, np.maximum(h**2 / 12, 1e-15))


def from_a_single_interval():
    n, exact = 2 ** np.arange(9), (1 - math.cos(5)) / 5
    return two(1 / n, *(errors(rule, lambda x: math.sin(5 * x), exact, counts=n) for rule in (euler, trapezoid)))


def odd_and_even():
    n = np.array([3, 4, 5, 7, 8, 11, 16, 21, 33])
    exact = math.atan(3) + math.atan(2)
    return two(5 / n, *(errors(rule, lambda x: 1 / (1 + x * x), exact, -2, 3, n) for rule in (euler, trapezoid)))


def legend_of_names():
    ax = drawn((H1, E1, {}), (H1, T1, {}), legend=False)
    ax.legend(["Euler", "trapezoid"])
    return ax


def scatters():
    _, ax = plt.subplots()
    ax.scatter(H1, E1, label="Euler")
    ax.scatter(H1, T1, label="trapezoid")
    ax.set(xscale="log", yscale="log", xlabel="step", ylabel="error")
    ax.legend()
    return ax


def by_order():
    return two(names=("first order", "second order"))


def letters():
    return two(names=("E", "T"))


def many_lines():
    return drawn(
        (H1, H1**2, {"label": "傾き 2", "ls": ":"}),
        (
            H1,
            errors(lambda f, a, b, n: euler(f, a + (b - a) / n / 2, b + (b - a) / n / 2, n), math.exp, math.e - 1),
            {"label": "中点則"},
        ),
        (H1, T1, {"label": "台形"}),
        (H1, E1, {"label": "Euler"}),
        (H1, H1, {"ls": "--"}),
    )


def slide_beside():
    last = errors(lambda f, a, b, n: trapezoid(f, a, b - (b - a) / n, n - 1), math.exp, math.e - 1)
    return drawn(
        (H1, last, {"label": "trapezoid, slide's loop"}), (H1, T1, {"label": "trapezoid, mended"}), (H1, E1, {"label": "Euler"})
    )


def improved_euler_beside():
    return drawn((H1, 1.1 * T1, {"label": "improved Euler"}), (H1, E1, {"label": "Euler"}), (H1, T1, {"label": "trapezoid"}))


def base_2_inverted():
    ax = two(how="plot")
    ax.set_xscale("log", base=2)
    ax.set_yscale("log", base=10)
    ax.invert_xaxis()
    return ax


def straight_line_and_square():
    e = errors(euler, lambda x: 3 * x, 1.5)
    t = errors(trapezoid, lambda x: x * x, 1 / 3)
    return two(e=e, t=t)


def with_gaps():
    e, t = E1.copy(), T1.copy()
    e[1], t[2] = np.nan, 0.0
    return two(e=e, t=t)


RIGHT = {
    "two lines": two,
    "pyplot, Japanese, markers": pyplot,
    "down to rounding": down_to_rounding,
    "floor at 1e-15": with_a_floor,
    "from n = 1": from_a_single_interval,
    "odd and even n": odd_and_even,
    "legend of names": legend_of_names,
    "scatters": scatters,
    "named by order": by_order,
    "letters": letters,
    "many lines": many_lines,
    "slide's loop beside": slide_beside,
    "improved Euler beside": improved_euler_beside,
    "base 2, inverted": base_2_inverted,
    "line and square": straight_line_and_square,
    "gaps": with_gaps,
}


def logarithms():
    return two(np.log(H1), np.log(E1), np.log(T1), how="plot")


def over_n():
    return two(COUNTS)


def step_over_error():
    return drawn((E1, H1, {"label": "Euler"}), (T1, H1, {"label": "trapezoid"}))


def names_exchanged():
    return two(names=("台形公式", "オイラー法"))


def names_exchanged_in_the_legend():
    ax = drawn((H1, E1, {}), (H1, T1, {}), legend=False)
    ax.legend(["trapezoid", "Euler"])
    return ax


def reference_for_euler():
    return drawn((H1, T1, {"label": "trapezoid"}), (H1, H1, {"label": "slope 1"}), (H1, H1**2, {"label": "slope 2"}))


def midpoint_for_trapezoid():
    return two(names=("Euler", "midpoint"))


def slide():
    return two(t=errors(lambda f, a, b, n: trapezoid(f, a, b - (b - a) / n, n - 1), math.exp, math.e - 1))


def signed():
    return two(e=-E1, t=-T1)


def signed_euler():
    return two(e=-E1)


def whole_period():
    counts = COUNTS + 1
    e, t = (errors(rule, lambda x: 2 + math.cos(x), 4 * math.pi, 0, 2 * math.pi, counts) + 1e-16 for rule in (euler, trapezoid))
    return two(e=e, t=t)


def constant():
    return two(e=np.full(5, 2e-16), t=np.full(5, 1e-16))


def squared():
    return two(e=E1**2, t=T1**2)


def relative_to_the_step():
    return two(e=E1 / H1, t=T1 / H1)


def one_line():
    return drawn((H1, E1, {"label": "Euler"}))


def same_twice():
    return two(e=T1)


def no_names():
    return drawn((H1, E1, {}), (H1, T1, {}), legend=False)


def one_name():
    return drawn((H1, E1, {"label": "Euler"}), (H1, T1, {}))


def no_legend():
    return two(legend=False)


def legend_too_early():
    _, ax = plt.subplots()
    ax.legend([])
    ax.loglog(H1, E1, label="Euler")
    ax.loglog(H1, T1, label="trapezoid")
    return ax


def linear():
    return two(how="plot")


def semilogy():
    return two(how="semilogy")


def symlog():
    return two(how="plot", xscale="symlog", yscale="symlog")


def hidden():
    ax = two()
    ax.lines[1].set_visible(False)
    return ax


def two_points():
    return two(H1[:2], E1[:2], T1[:2])


def zoomed_out_of_sight():
    return two(xlim=(1e-9, 1e-8))


def integrals():
    return two(e=math.e - 1 - E1, t=math.e - 1 + T1)


def empty():
    return plt.subplots()[1]


def numbers():
    return H1, E1, T1


WRONG = {
    "logarithms": (logarithms, "np.log of the data", "plain"),
    "over n": (over_n, "n along x", "plain"),
    "step over error": (step_over_error, "axes exchanged", "plain"),
    "names exchanged": (names_exchanged, "labels", "plain"),
    "names exchanged in the legend": (names_exchanged_in_the_legend, "legend", "plain"),
    "reference for Euler": (reference_for_euler, "Euler missing", "plain"),
    "midpoint for trapezoid": (midpoint_for_trapezoid, "trapezoid missing", "subtle"),
    "slide's loop": (slide, "both of order 1", "plain"),
    "signed": (signed, "errors below zero", "plain"),
    "Euler signed": (signed_euler, "Euler vanishes", "plain"),
    "whole period": (whole_period, "nothing but rounding", "plain"),
    "constant": (constant, "exact", "plain"),
    "squared": (squared, "orders 2 and 4", "plain"),
    "divided by h": (relative_to_the_step, "orders 0 and 1", "subtle"),
    "Euler only": (one_line, "trapezoid missing", "plain"),
    "same twice": (same_twice, "trapezoid under both names", "plain"),
    "no names": (no_names, "no labels", "plain"),
    "one name": (one_name, "a label missing", "plain"),
    "no legend": (no_legend, "no legend", "plain"),
    "legend too early": (legend_too_early, "empty legend", "plain"),
    "linear": (linear, "no log scale", "plain"),
    "semilogy": (semilogy, "x linear", "plain"),
    "symlog": (symlog, "symlog", "subtle"),
    "hidden": (hidden, "invisible line", "subtle"),
    "two points": (two_points, "too few", "plain"),
    "out of sight": (zoomed_out_of_sight, "limits", "plain"),
    "integrals": (integrals, "no errors", "plain"),
    "empty": (empty, "nothing drawn", "plain"),
    "numbers": (numbers, "no Axes", "plain"),
}

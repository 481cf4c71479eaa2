"""What is said of errors and of answers of the wrong kind, in both languages, and which error each text belongs to.

`course.explaining` fills these texts in. They say what happened, the likely cause, and what to do or where to look.
"""

import difflib
import math
from collections.abc import Callable, Mapping, Sequence
from typing import NamedTuple

from course.language import Text

Found = Callable[[Mapping[str, str]], str | None]


class Row(NamedTuple):
    """One kind of error: exception names, a regular expression for the message, and what to say in English and in Japanese.

    Named groups are filled into the texts; "amount" and those that begin with "type", "shape" or "names" are put into words. `found`
    looks something up for `{found}`, and the row does not fit when there is nothing; `line` must be found in the student's line.
    """

    errors: str
    pattern: str
    en: str
    ja: str
    found: Found | None = None
    line: str = ""


def _words(text: str) -> tuple[str, ...]:
    return tuple(text.split())


def _listed(table: Mapping[str, str], key: str = "{key}") -> Found:
    """Return a look-up of `key`, made from the groups of the match, in `table`."""
    return lambda groups: table.get(key.format(**groups))


def _nearest(word: str, words: Sequence[str]) -> str | None:
    """Return the one of `words` that `word` is probably a misspelling of."""
    close = [] if word in words or len(word) < 4 else difflib.get_close_matches(word[:80], words, n=1, cutoff=0.72)
    return close[0] if close else None


def _near_attribute(groups: Mapping[str, str]) -> str | None:
    """Return what is probably meant by the attribute `key` of `module` (or of a type)."""
    return _nearest(groups["key"], _ATTRIBUTES.get(groups["module"], ()))


def _unwritten(groups: Mapping[str, str]) -> str | None:
    """Return the function that raised the error, if it has a name and is not the answer itself."""
    function = groups["raised_in"]
    return function if function.isidentifier() and function != groups["name"] else None


def _half_width(groups: Mapping[str, str]) -> str | None:
    """Return what a Japanese keyboard's full-width character stands for in code, if it is one."""
    code = int(groups["code"], 16)
    return chr(code - 0xFEE0) if 0xFF01 <= code <= 0xFF5E else _CHARACTERS.get(groups["key"])


LINE = Text("Line {number}: {line}\n", "{number}行目: {line}\n")
LINE_ELSEWHERE = Text("Line {number}, in {function}: {line}\n", "{number}行目({function}の中): {line}\n")

FALLBACK = Text(
    "{name} stopped with an error, {type}: {message}. Call it in a cell of your own with simple numbers, and print the "
    "values that the line uses just before it.",
    "{name} の実行中にエラー {type} が起きました: {message}。別のセルで簡単な数値を渡して呼び出し、"
    "エラーの行で使っている値を直前で print して確かめましょう。",
)
FALLBACK_SILENT = Text(
    "{name} stopped with an error, {type}, that carries no message. Look for a raise in your code, then call the function "
    "in a cell of your own with simple numbers.",
    "{name} の実行中に、説明のないエラー {type} が起きました。コードに raise がないか確かめ、別のセルで簡単な数値を"
    "渡して呼び出してみましょう。",
)

TYPES = {
    "float": Text("a number (float)", "数値(float)"),
    "float64": Text("a number (float64)", "数値(float64)"),
    "float32": Text("a number (float32)", "数値(float32)"),
    "int": Text("a number (int)", "整数(int)"),
    "int64": Text("a number (int64)", "整数(int64)"),
    "bool": Text("True or False (bool)", "真偽値(bool)"),
    "complex": Text("a complex number", "複素数(complex)"),
    "complex128": Text("a complex number", "複素数(complex128)"),
    "NoneType": Text("None (nothing)", "None(値なし)"),
    "str": Text("text (str)", "文字列(str)"),
    "str_": Text("text (str)", "文字列(str)"),
    "bytes": Text("bytes", "バイト列(bytes)"),
    "list": Text("a list", "リスト(list)"),
    "tuple": Text("a tuple", "タプル(tuple)"),
    "dict": Text("a dictionary (dict)", "辞書(dict)"),
    "set": Text("a set", "集合(set)"),
    "ndarray": Text("an array (ndarray)", "配列(ndarray)"),
    "function": Text("a function", "関数"),
    "builtin_function_or_method": Text("a function", "関数"),
    "method": Text("a method", "メソッド"),
    "ufunc": Text("a NumPy function", "NumPyの関数"),
    "_ArrayFunctionDispatcher": Text("a NumPy function", "NumPyの関数"),
    "type": Text("a class", "クラス"),
    "module": Text("a module", "モジュール"),
    "generator": Text("a generator", "ジェネレータ"),
    "map": Text("a map object", "mapオブジェクト"),
    "zip": Text("a zip object", "zipオブジェクト"),
    "filter": Text("a filter object", "filterオブジェクト"),
    "range": Text("a range", "range"),
    "Symbol": Text("a SymPy symbol", "SymPyの記号"),
    "axes": Text("the Axes of a graph", "グラフのAxes"),
    "Figure": Text("a Figure", "Figure"),
}

_FUNCTIONS = r"function|builtin_function_or_method|method|type|numpy\.ufunc|numpy\._ArrayFunctionDispatcher|FunctionClass"
_NUMBERS = r"float|int|bool|complex|numpy\.(?:float|int|uint|complex|bool)\w*"
_ITERATORS = r"generator|map|zip|filter|enumerate|reversed|\w+_iterator"
_SYMBOLIC = (
    r"Symbol|Dummy|Add|Mul|Pow|Float|Integer|Rational|Half|Zero|One|NegativeOne|Pi|cos|sin|tan|acos|asin|atan|atan2|exp|log|Abs"
)
_MATHS = r"cos|sin|tan|arccos|arcsin|arctan|arctan2|hypot|sqrt|exp|log|deg2rad|rad2deg|radians|degrees|square|power|sign|abs"


def _operands(kinds: str) -> str:
    """Return the pattern of an operator that does not know one of `kinds`, on either side."""
    between = r"'(?P<type1>[^']*)' and '(?P<type2>[^']*)'"
    return rf"unsupported operand type\(s\) for (?P<op>[^\s:]+)[^:]*: (?=.*'(?:{kinds})'){between}"


_IMPORTS = {
    "np": "import numpy as np",
    "numpy": "import numpy",
    "plt": "import matplotlib.pyplot as plt",
    "mpl": "import matplotlib as mpl",
    "matplotlib": "import matplotlib",
    "pyplot": "from matplotlib import pyplot",
    "math": "import math",
    "cmath": "import cmath",
    "sp": "import sympy as sp",
    "sym": "import sympy as sym",
    "sympy": "import sympy",
    "scipy": "import scipy",
    "integrate": "from scipy import integrate",
    "linalg": "from numpy import linalg",
    "random": "import random",
    "time": "import time",
    "os": "import os",
    "sys": "import sys",
    "re": "import re",
    "csv": "import csv",
    "json": "import json",
    "copy": "import copy",
    "datetime": "import datetime",
    "warnings": "import warnings",
    "itertools": "import itertools",
    "functools": "import functools",
    "statistics": "import statistics",
    "Path": "from pathlib import Path",
    "io": "import io",
}

_NUMPY_WORDS = _words(
    "abs all allclose any append arange arccos arcsin arctan arctan2 argmax argmin argsort array asarray "
    "atleast_1d ceil clip column_stack concatenate copy cos cross cumsum deg2rad degrees diff dot einsum empty "
    "empty_like exp eye flip float64 floor full full_like genfromtxt gradient hstack hypot identity inf insert "
    "int64 interp isclose isfinite isnan linalg linspace loadtxt log log10 logspace matmul max maximum mean "
    "median meshgrid min minimum mod nan newaxis ones ones_like outer pi polyfit power rad2deg radians random "
    "remainder repeat reshape roll round searchsorted shape sign sin size sort sqrt square squeeze stack std sum "
    "tan tile transpose trapezoid unique unwrap var vstack where zeros zeros_like"
)
_PYPLOT_WORDS = _words(
    "axis close figure gca gcf grid hist imshow legend loglog plot quiver savefig scatter semilogx semilogy show "
    "subplot subplots text tight_layout title xlabel xlim xscale ylabel ylim yscale"
)
_SYMPY_WORDS = _words(
    "Abs Eq Float Function Integer Matrix Rational Symbol acos asin atan atan2 cos cosh diff exp expand eye "
    "factor integrate lambdify latex limit log nsimplify pi series simplify sin sinh solve sqrt symbols sympify "
    "tan trigsimp zeros"
)
_MATH_WORDS = tuple(word for word in dir(math) if not word.startswith("_"))
_ATTRIBUTES = {
    "numpy": _NUMPY_WORDS,
    "math": _MATH_WORDS,
    "matplotlib.pyplot": _PYPLOT_WORDS,
    "sympy": _SYMPY_WORDS,
    "numpy.linalg": _words("cond det eig eigh eigvals inv lstsq matrix_rank norm pinv qr solve svd"),
    "scipy.integrate": _words("cumulative_trapezoid odeint quad simpson solve_ivp trapezoid"),
    "numpy.ndarray": _words(
        "all any argmax argmin argsort astype clip copy cumsum diagonal dot dtype fill flatten item max mean min ndim "
        "prod ravel reshape round shape size sort squeeze std sum swapaxes tolist trace transpose var"
    ),
    "list": _words("append clear copy count extend index insert pop remove reverse sort"),
    "dict": _words("copy get items keys pop setdefault update values"),
    "str": _words("count endswith find format join lower replace split splitlines startswith strip upper"),
    "Axes": _words(
        "axhline axis axvline fill_between grid hist legend loglog plot quiver scatter semilogx semilogy set_aspect "
        "set_title set_xlabel set_xlim set_xscale set_xticks set_ylabel set_ylim set_yscale set_yticks text"
    ),
}
_MODULES = _words("copy csv datetime functools itertools json math matplotlib numpy random scipy sympy")

# names that were renamed or removed, or that belong to another module; the key is module.name
_RENAMED = {
    "numpy.trapz": "np.trapezoid",
    "numpy.cumtrapz": "scipy.integrate.cumulative_trapezoid",
    "numpy.product": "np.prod",
    "numpy.cumproduct": "np.cumprod",
    "numpy.in1d": "np.isin",
    "numpy.row_stack": "np.vstack",
    "numpy.asfarray": "np.asarray(..., dtype=float)",
    "numpy.asscalar": "a.item()",
    "numpy.msort": "np.sort(..., axis=0)",
    "numpy.float": "float",
    "numpy.float_": "np.float64",
    "numpy.int": "int",
    "numpy.int0": "np.intp",
    "numpy.bool": "bool",
    "numpy.bool8": "np.bool_",
    "numpy.object": "object",
    "numpy.str": "str",
    "numpy.unicode_": "np.str_",
    "numpy.complex": "complex",
    "numpy.complex_": "np.complex128",
    "numpy.Inf": "np.inf",
    "numpy.INF": "np.inf",
    "numpy.Infinity": "np.inf",
    "numpy.infty": "np.inf",
    "numpy.PINF": "np.inf",
    "numpy.NINF": "-np.inf",
    "numpy.NaN": "np.nan",
    "numpy.NAN": "np.nan",
    "numpy.alltrue": "np.all",
    "numpy.sometrue": "np.any",
    "numpy.round_": "np.round",
    "numpy.mat": "np.asarray",
    "numpy.cosine": "np.cos",
    "numpy.cosin": "np.cos",
    "numpy.PI": "np.pi",
    "numpy.Pi": "np.pi",
    "numpy.ln": "np.log",
    "numpy.sqr": "np.square",
    "numpy.range": "np.arange",
    "numpy.len": "len",
    "numpy.norm": "np.linalg.norm",
    "numpy.inv": "np.linalg.inv",
    "numpy.det": "np.linalg.det",
    "numpy.rad": "np.deg2rad",
    "numpy.deg": "np.rad2deg",
    "numpy.degree": "np.degrees",
    "numpy.radian": "np.radians",
    "numpy.plot": "plt.plot",
    "math.cosine": "math.cos",
    "math.cosin": "math.cos",
    "math.arctan2": "math.atan2",
    "math.arctan": "math.atan",
    "math.arcsin": "math.asin",
    "math.arccos": "math.acos",
    "math.deg2rad": "math.radians",
    "math.rad2deg": "math.degrees",
    "math.abs": "abs",
    "math.round": "round",
    "math.max": "max",
    "math.min": "min",
    "math.sum": "sum",
    "math.mod": "%",
    "math.ln": "math.log",
    "math.PI": "math.pi",
    "math.Pi": "math.pi",
    "math.sign": "math.copysign",
    "math.norm": "math.hypot",
    "math.array": "np.array",
    "math.zeros": "np.zeros",
    "math.linspace": "np.linspace",
    "math.cumsum": "np.cumsum",
    "math.diff": "np.diff",
    "sympy.arctan2": "sp.atan2",
    "sympy.arctan": "sp.atan",
    "sympy.arcsin": "sp.asin",
    "sympy.arccos": "sp.acos",
    "sympy.deg2rad": "sp.rad",
    "sympy.radians": "sp.rad",
    "sympy.rad2deg": "sp.deg",
    "sympy.degrees": "sp.deg",
    "sympy.array": "sp.Matrix",
    "sympy.matrix": "sp.Matrix",
    "sympy.symbol": "sp.symbols",
    "sympy.abs": "sp.Abs",
    "sympy.hypot": "sp.sqrt",
    "matplotlib.pyplot.set_xlabel": "plt.xlabel",
    "matplotlib.pyplot.set_ylabel": "plt.ylabel",
    "matplotlib.pyplot.set_title": "plt.title",
    "matplotlib.pyplot.set_xlim": "plt.xlim",
    "matplotlib.pyplot.set_ylim": "plt.ylim",
    "matplotlib.pyplot.set_aspect": "plt.gca().set_aspect",
    "scipy.integrate.cumtrapz": "scipy.integrate.cumulative_trapezoid",
    "scipy.integrate.simps": "scipy.integrate.simpson",
    "scipy.integrate.trapz": "scipy.integrate.trapezoid",
    "scipy.cos": "np.cos",
    "scipy.sin": "np.sin",
    "scipy.tan": "np.tan",
    "scipy.arctan2": "np.arctan2",
    "scipy.sqrt": "np.sqrt",
    "scipy.exp": "np.exp",
    "scipy.log": "np.log",
    "scipy.pi": "np.pi",
    "scipy.array": "np.array",
    "scipy.zeros": "np.zeros",
    "scipy.linspace": "np.linspace",
    "scipy.arange": "np.arange",
    "scipy.mean": "np.mean",
}

# words used without their module; none that is as likely a variable of the student's, such as roll
_BARE_NUMPY = _words(
    "cos sin tan arccos arcsin arctan arctan2 sqrt exp log log10 hypot deg2rad rad2deg radians degrees array asarray zeros ones "
    "zeros_like ones_like linspace arange cumsum diff hstack vstack stack concatenate column_stack eye pi nan inf loadtxt "
    "trapezoid cross dot matmul einsum meshgrid interp unwrap isnan isfinite allclose polyfit floor ceil"
)
_BARE = {
    **{word: f"np.{word}" for word in _BARE_NUMPY},
    **{word: f"math.{word}" for word in _words("atan2 atan asin acos fabs fmod copysign tau")},
    **{word: f"sp.{word}" for word in _words("Symbol symbols Matrix simplify lambdify Rational")},
    **{word: f"plt.{word}" for word in _words("plot subplots xlabel ylabel legend scatter figure show title")},
    "π": "np.pi",
    "ndarray": "np.ndarray",
}
_SPELLED = {
    **dict.fromkeys(("true", "TRUE"), "True"),
    **dict.fromkeys(("false", "FALSE"), "False"),
    **dict.fromkeys(("none", "NONE", "null", "NULL", "nil"), "None"),
    **dict.fromkeys(("NaN", "Nan", "NAN"), "np.nan"),
    **dict.fromkeys(("Inf", "infinity", "Infinity"), "np.inf"),
    **dict.fromkeys(("NP", "Np"), "np"),
    **dict.fromkeys(("Math", "MATH"), "math"),
    **dict.fromkeys(("Pi", "PI"), "np.pi"),
    **{word.capitalize(): word for word in _words("print len range abs sum max min float int list round")},
    "Numpy": "numpy",
    "NumPy": "numpy",
    "Plt": "plt",
}
_SETTERS = {word: f"set_{word}" for word in _words("xlabel ylabel title xlim ylim xscale yscale xticks yticks aspect")}

# what stands in for a character that Japanese input, or a copy from a slide, puts into code
_CHARACTERS = {
    **dict.fromkeys("、", ","),
    **dict.fromkeys("。", "."),
    **dict.fromkeys("“”„″", '"'),
    **dict.fromkeys("‘’′‚", "'"),
    **dict.fromkeys("「」『』", '"'),
    **dict.fromkeys("−–—‐‑―", "-"),
    **dict.fromkeys("×·⋅∗", "*"),
    "・": "*",
    "÷": "/",
    "∕": "/",
    "≤": "<=",
    "≦": "<=",
    "≥": ">=",
    "≧": ">=",
    "≠": "!=",
    "【": "[",
    "】": "]",
    "〔": "(",
    "〕": ")",
    "¥": "\\",
    "￥": "\\",
    "²": "**2",
    "³": "**3",
    "°": "np.deg2rad(...)",
    "√": "np.sqrt(...)",
    "→": "->",
}
_MISSPELT_KEYWORDS = _words(
    "Def DEF define func function fn deff dfe Return RETURN retrun retun reutrn retrn returm retern If IF For FOR foreach "
    "While WHILE whlie wihle Else ELSE Elif ELIF elseif elsif Import imoprt improt From"
)

_NO_INPUT = Text(
    "input() cannot be used in an answer: while it is checked, nobody is there to type. The arguments already bring the "
    "values. Delete the line with input() and use the function's parameters.",
    "答えの中では input() を使えません。チェックの間は、値を入力する人がいないためです。必要な値は引数で渡されます。input() "
    "の行を消して、関数の引数を使いましょう。",
)

_NAMES = (
    Row(
        "StdinNotImplementedError EOFError",
        "",
        *_NO_INPUT,
    ),
    Row(
        "RuntimeError OSError ValueError",
        r"lost sys\.stdin|reading from stdin|I/O operation on closed file",
        *_NO_INPUT,
        line=r"\binput\s*\(",
    ),
    Row(
        "NotImplementedError",
        r"^\s*$|not written|not implemented",
        "{name} calls {found}, and {found} is not written yet. Write {found} first: replace its line raise "
        "NotImplementedError(), run its cell, then check {name} again.",
        "{name} が呼び出している {found} がまだ書かれていません。先に {found} の raise NotImplementedError() を"
        "自分のコードに置き換えてセルを実行し、それから {name} をもう一度チェックしましょう。",
        found=_unwritten,
    ),
    Row(
        "NotImplementedError",
        r"^\s*$|not written|not implemented",
        "{name} is not written yet: the line raise NotImplementedError() is still there. Every exercise starts like that. "
        "Replace that line with your own code, run the cell, then check again.",
        "{name} はまだ書かれていません。raise NotImplementedError() の行が残っています。どの課題もここから始まります。"
        "この行を自分のコードに置き換え、セルを実行してからもう一度チェックしましょう。",
    ),
    Row(
        "NotImplementedError",
        "",
        "{name} stopped with NotImplementedError: {message}. Either a raise NotImplementedError line is still in the code, "
        "or a library cannot do this with such values. Look at the line where it happened.",
        "{name} が NotImplementedError で止まりました: {message}。raise NotImplementedError の行が残っているか、"
        "ライブラリがその値に対応していないようです。エラーの行を確かめましょう。",
    ),
    Row(
        "NameError",
        r"^name '(?P<key>[^']+)' is not defined",
        "{key} is not known here: its import is missing, or the cell with the import was not run. Write {found} at the top "
        "of the notebook, run that cell, then check again.",
        "{key} が使えません。import していないか、import のセルを実行していないようです。ノートブックの先頭に {found} "
        "と書いてセルを実行し、もう一度チェックしましょう。",
        found=_listed(_IMPORTS),
    ),
    Row(
        "NameError",
        r"^name '(?P<key>[^']+)' is not defined",
        "Python does not know the name {key}. The usual spelling is {found}; capital and small letters count. Correct it in "
        "the line above.",
        "{key} という名前はありません。正しい書き方は {found} です。大文字と小文字は区別されます。該当する行を直しましょう。",
        found=_listed(_SPELLED),
    ),
    Row(
        "NameError",
        r"^name '(?P<key>[^']+)' is not defined",
        "Python does not know {key} on its own: it belongs to a module. Write {found}, and see that the module is imported "
        "at the top of the notebook. If it should be a variable of yours, give it a value first.",
        "{key} はモジュールの中にあるので、そのままでは使えません。{found} と書き、そのモジュールを先頭で import "
        "しているか確かめましょう。自分の変数のつもりなら、先に値を代入してください。",
        found=_listed(_BARE),
    ),
    Row(
        "NameError",
        r"name '(?P<key>[^']+)' is not defined\. Did you mean:? '(?P<close>[^']+)'",
        "The name {key} is not defined. There is a similar name, {close}: is it a typing error? Capital and small letters count.",
        "{key} という名前は定義されていません。似た名前の {close} があります。打ち間違いではありませんか。"
        "大文字と小文字も区別されます。",
    ),
    Row(
        "NameError",
        r"free variable '(?P<key>[^']+)'",
        "The inner function uses {key} before it has a value. Give {key} a value in the outer function before the inner one "
        "is called.",
        "内側の関数が、まだ値のない {key} を使っています。内側の関数を呼び出す前に、外側の関数で {key} に値を代入しましょう。",
    ),
    Row(
        "NameError",
        r"name '(?P<key>[^']+)' is not defined",
        "The name {key} is not defined. Perhaps it is misspelt (capital and small letters count), it gets its value only "
        "further down, or the cell that defines it was not run after a restart. Compare it with the parameters in the def "
        "line.",
        "{key} という名前は定義されていません。つづりの間違い(大文字と小文字は区別されます)、値を代入する前の使用、または"
        "再起動後に定義のセルを実行していないことが考えられます。def の行の引数の名前と比べてみましょう。",
    ),
    Row(
        "UnboundLocalError",
        r"local variable '(?P<key>[^']+)'",
        "The variable {key} is used before it has a value. Because the function assigns to {key} somewhere, it is local to "
        "the function; perhaps that happens only inside an if or a loop that was not entered. Give {key} a first value "
        "before this line.",
        "変数 {key} に値が入る前に使われています。関数の中で代入される {key} は、その関数だけの変数になります。代入が if "
        "やループの中だけにあり、そこを通らなかったのかもしれません。この行より前で {key} に初期値を入れましょう。",
    ),
    Row(
        "ModuleNotFoundError",
        r"No module named '(?P<key>[^'.]+)",
        "There is no module called {key}. It looks like a typing error: is {found} meant? Correct the import line and run "
        "its cell again.",
        "{key} というモジュールはありません。{found} の打ち間違いのようです。import の行を直して、そのセルを"
        "もう一度実行しましょう。",
        found=lambda groups: _nearest(groups["key"], _MODULES),
    ),
    Row(
        "ModuleNotFoundError",
        r"No module named '(?P<module>[\w.]+)\.(?P<key>\w+)'",
        "{module} has no module {key} that could be imported. Perhaps {key} is a function: then write from {module} import "
        "{key}. Otherwise compare the spelling with the documentation.",
        "{module} の中に {key} というモジュールはありません。{key} が関数なら from {module} import {key} と書きます。"
        "そうでなければ、つづりをドキュメントと比べましょう。",
    ),
    Row(
        "ModuleNotFoundError",
        r"No module named '(?P<key>[^']+)'",
        "The module {key} is not there. Either its name is misspelt, or it is not part of the course's environment. The "
        "exercises need only what the notebook imports at its top.",
        "{key} というモジュールが見つかりません。つづりが違うか、この授業の環境に含まれていないモジュールです。課題は、"
        "ノートブックの先頭で import しているものだけで解けます。",
    ),
    Row(
        "ImportError",
        r"cannot import name '(?P<key>[^']+)' from '(?P<module>[^']+)'",
        "{module} has no {key}: in the installed version it was renamed or removed, or it belongs elsewhere. Use {found} "
        "instead.",
        "{module} に {key} はありません。今のバージョンで名前が変わったか削除されたか、別のところにある名前です。代わりに "
        "{found} を使いましょう。",
        found=_listed(_RENAMED, "{module}.{key}"),
    ),
    Row(
        "ImportError",
        r"cannot import name '(?P<key>[^']+)' from '(?P<module>[^']+)'",
        "{module} has no {key}. It looks like a typing error: is {found} meant? Correct the import line and run its cell again.",
        "{module} に {key} はありません。{found} の打ち間違いのようです。import の行を直して、そのセルをもう一度実行しましょう。",
        found=_near_attribute,
    ),
    Row(
        "ImportError",
        r"cannot import name '(?P<key>[^']+)' from (?:partially initialized module )?'(?P<module>[^']+)'",
        "{module} has no {key}. The name is misspelt, it was removed or moved in the installed version, or a file of yours "
        "has the same name as the module. Look {key} up in the documentation of {module}.",
        "{module} に {key} はありません。つづりの間違い、今のバージョンでの削除や移動、または"
        "モジュールと同じ名前の自作ファイルが原因かもしれません。{module} のドキュメントで {key} を調べましょう。",
    ),
    Row(
        "ImportError",
        "",
        "An import failed: {message}. Compare the import line with the one at the top of the notebook.",
        "import に失敗しました: {message}。import の行を、ノートブックの先頭にある行と比べてみましょう。",
    ),
)

_CALLS = (
    Row(
        "TypeError",
        r"(?P<function>[\w.<>]+)\(\) missing \d+ required [\w-]+ arguments?: (?P<names>.+)",
        "{function}() was called without a value for {names}. Count the values in the call, and compare them with the def "
        "line or the documentation of {function}: each parameter needs one, in the same order.",
        "{function}() の呼び出しに、引数 {names} の値がありません。{function} の def の行やドキュメントと比べて、"
        "すべての引数に同じ順番で値を渡しているか数えてみましょう。",
    ),
    Row(
        "TypeError",
        r"(?P<function>[\w.]+)\(\) missing required argument (?P<names>'[^']*')",
        "{function}() was called without a value for {names}. Look at what it needs: in a cell of your own, run "
        "help({function}) with the module's name in front.",
        "{function}() の呼び出しに、引数 {names} の値がありません。別のセルで help(...) を使い、{function} に必要な引数を"
        "調べましょう。",
    ),
    Row(
        "TypeError",
        r"(?:^|\.)(?P<function>array|asarray|hstack|vstack|stack|concatenate|column_stack|sum|mean)\(\) takes (?:from \d+ "
        r"to )?\d+ .*given",
        "{function}() was given its values one by one. It takes them together, as one list: put them inside square "
        "brackets, {function}([...]).",
        "{function}() に値がばらばらに渡されています。値は1つのリストにまとめて渡します。{function}([...]) "
        "のように角かっこで囲みましょう。",
    ),
    Row(
        "TypeError",
        r"Cannot interpret '(?P<key>[^']*)' as a data type|Field elements must be 2- or 3-tuples, got '(?P<other>[^']*)'",
        "A NumPy function took its second argument for the data type (dtype), which it is not. Shapes and values go "
        "together inside one pair of brackets: np.zeros((2, 3)), np.array([1.0, 2.0]).",
        "NumPyの関数が、2番目の引数をデータ型(dtype)として受け取り、解釈できませんでした。形状や値は、np.zeros((2, 3)) や "
        "np.array([1.0, 2.0]) のように1組のかっこにまとめて渡します。",
    ),
    Row(
        "TypeError",
        r"data type '(?P<key>[^']*)' not understood",
        "NumPy knows no data type (dtype) called {key}. For decimal numbers write dtype=float, for whole numbers dtype=int.",
        "NumPyに {key} というデータ型(dtype)はありません。実数なら dtype=float、整数なら dtype=int と書きましょう。",
    ),
    Row(
        "TypeError",
        r"return arrays must be of ArrayType",
        "A NumPy function was given one argument too many: it takes the last one for the place where the result should go. "
        "Look up how many arguments this function takes, and whether another function was meant.",
        "NumPyの関数に渡した引数が1つ多いようです。最後の引数が、結果の置き場所として扱われています。その関数の引数の数を"
        "調べ、別の関数と取り違えていないか確かめましょう。",
    ),
    Row(
        "TypeError",
        r"(?P<function>[\w.<>]+)\(\) takes (?P<amount>[\w ]+?) (?:positional )?arguments? (?:but |"
        r"\()(?P<given>\d+) ",
        "The number of arguments does not fit: {function}() takes {amount}, but the call gives {given}. Compare the call "
        "with the def line or the documentation of {function}; perhaps a comma or a pair of brackets is in the wrong place.",
        "引数の数が合いません。{function}() が受け取るのは{amount}ですが、{given}個渡されています。{function} の def "
        "の行やドキュメントと比べましょう。コンマやかっこの位置も確かめてください。",
    ),
    Row(
        "TypeError",
        r"(?P<function>[\w.]+)(?:\(\))? expected (?P<amount>(?:at least |at most )?\d+) arguments?, got (?P<given>\d+)",
        "The number of arguments does not fit: {function}() takes {amount}, but the call gives {given}. Compare the call "
        "with the documentation of {function}; perhaps a comma or a pair of brackets is in the wrong place.",
        "引数の数が合いません。{function}() が受け取るのは{amount}ですが、{given}個渡されています。{function} "
        "のドキュメントと比べましょう。コンマやかっこの位置も確かめてください。",
    ),
    Row(
        "TypeError",
        r"takes (?:no|exactly \w+|at \w+ \w+|\d+) (?:positional |keyword )?arguments?|must have at least \w+ arguments|"
        r"expected \d+ arguments?, got \d+",
        "A function was called with arguments that do not fit: {message}. Compare the call in this line with "
        "the def line or the documentation of that function.",
        "関数に渡した引数が合いません: {message}。この行の呼び出しを、その関数の def の行やドキュメントと比べましょう。",
    ),
    Row(
        "TypeError AttributeError",
        r"(?P<function>[\w.<>]+)\(\) got an unexpected keyword argument '(?P<key>[^']*)'",
        "{function}() has no parameter called {key}. The name before the = in the call must be one of its parameters. "
        "Compare the spelling with the def line or the documentation.",
        "{function}() に {key} という引数はありません。呼び出しの = の左には、引数の名前を正しく書く必要があります。def "
        "の行やドキュメントとつづりを比べましょう。",
    ),
    Row(
        "TypeError",
        r"'(?P<key>[^']*)' is an invalid keyword argument for (?P<function>\w+)\(\)",
        "{function}() has no parameter called {key}. The name before the = in the call must be one of its parameters. "
        "Compare the spelling with the documentation.",
        "{function}() に {key} という引数はありません。呼び出しの = の左には、引数の名前を正しく書く必要があります。"
        "ドキュメントとつづりを比べましょう。",
    ),
    Row(
        "TypeError",
        r"(?P<function>[\w.<>]+)\(\) got multiple values for argument '(?P<key>[^']*)'",
        "{function}() received {key} twice: once by its place and once by its name. Count the values before {key}= in the "
        "call and drop one.",
        "{function}() の引数 {key} に、位置と名前の両方で値が渡されています。呼び出しの {key}= より前にある値を数え、"
        "余分なほうを消しましょう。",
    ),
    Row(
        "TypeError",
        r"'(?:module)' object is not callable",
        "A module is called like a function. A module only holds functions: write its name, a dot, and the function, for "
        "example math.sqrt(x).",
        "モジュールを関数のように呼び出しています。モジュールは関数の入れ物なので、math.sqrt(x) のように、"
        "ドットに続けて関数名を書きましょう。",
    ),
    Row(
        "TypeError",
        r"'NoneType' object is not callable",
        "Parentheses follow something that is None (nothing). Perhaps a function's name was overwritten by the result of "
        "print() or of a function without return, or there is one pair of parentheses too many. Look at what stands just "
        "before the (.",
        "None(値なし)の後ろに丸かっこが付いています。関数名に print() などの戻り値を代入してしまったか、"
        "かっこが1組多いのかもしれません。( の直前を確かめましょう。",
    ),
    Row(
        "TypeError",
        r"'Text' object is not callable",
        "A text of the graph is called like a function. On an Axes the title is set with ax.set_title(...), the labels with "
        "ax.set_xlabel(...) and ax.set_ylabel(...).",
        "グラフの文字(Text)を関数のように呼び出しています。Axesのタイトルは ax.set_title(...)、軸ラベルは "
        "ax.set_xlabel(...)、ax.set_ylabel(...) で設定します。",
    ),
    Row(
        "TypeError",
        rf"'(?P<type1>{_NUMBERS}|{_SYMBOLIC})' object is not callable",
        "Parentheses follow {type1}, so Python tries to call it like a function. For a multiplication write the *: a * (b + "
        "c). If a function is meant, its name was probably overwritten with a number: choose another name and run the cells "
        "again.",
        "{type1}の後ろに丸かっこがあるため、関数として呼び出そうとしています。掛け算なら a * (b + c) のように * を書きます。"
        "関数のつもりなら、その名前に数値を代入してしまったようです。別の変数名にして、セルを実行し直しましょう。",
    ),
    Row(
        "TypeError",
        r"'(?P<type1>list|tuple|dict|numpy\.ndarray|str|set)' object is not callable",
        "Parentheses follow {type1}, so Python tries to call it like a function. Elements are taken with square brackets, "
        "a[0]; a multiplication needs the *. Perhaps a function's name such as list or sum was overwritten: choose another "
        "name.",
        "{type1}の後ろに丸かっこがあるため、関数として呼び出そうとしています。要素は角かっこで a[0] のように取り出し、"
        "掛け算には * を書きます。list や sum などの関数名に代入していたら、別の変数名にしましょう。",
    ),
    Row(
        "TypeError",
        r"'(?P<type1>[^']*)' object is not callable",
        "Parentheses follow {type1}, which is not a function. Look at what stands just before the (: is a * missing, or was "
        "a function's name given to something else?",
        "{type1}の後ろに丸かっこがありますが、これは関数ではありません。( の直前を見て、* が抜けていないか、"
        "関数名に別のものを代入していないか確かめましょう。",
    ),
    Row(
        "TypeError",
        r"'NoneType' object is not subscriptable",
        "Square brackets follow something that is None (nothing). It is probably the result of a function without return, "
        "or of a method such as sort() or append(), which return nothing. Print it before this line.",
        "None(値なし)に角かっこ [ ] を付けています。return のない関数の結果か、sort() や append() "
        "のように何も返さないメソッドの結果のようです。この行の前で print して確かめましょう。",
    ),
    Row(
        "TypeError",
        rf"'(?:{_FUNCTIONS})' object is not subscriptable|^type '\w+' is not subscriptable",
        "Square brackets follow a function. A function is called with round parentheses, f(x); square brackets are only for "
        "elements, a[0]. Look at the name before the [.",
        "関数に角かっこ [ ] を付けています。関数は f(x) のように丸かっこで呼び出し、角かっこは a[0] のように要素を"
        "取り出すときに使います。[ の前の名前を確かめましょう。",
    ),
    Row(
        "TypeError",
        rf"'(?P<type1>{_NUMBERS})' object is not subscriptable",
        "Square brackets follow a single number, which has no elements. Perhaps an array was expected there, or the loop "
        "variable already is the element. Print the value before this line.",
        "1個の数値に角かっこ [ ] を付けていますが、数値には要素がありません。配列のつもりの変数が数値になっているか、"
        "ループ変数がすでに要素そのものなのかもしれません。この行の前で print して確かめましょう。",
    ),
    Row(
        "IndexError",
        r"invalid index to scalar variable",
        "Square brackets follow a single number, which has no elements. Perhaps there is one index too many, or the loop "
        "variable already is the element. Print the value before this line.",
        "1個の数値に角かっこ [ ] を付けていますが、数値には要素がありません。添字が1つ多いか、"
        "ループ変数がすでに要素そのものなのかもしれません。この行の前で print して確かめましょう。",
    ),
    Row(
        "TypeError",
        rf"'(?P<type1>{_ITERATORS}|set)' object is not subscriptable|object of type '(?P<type2>{_ITERATORS})' has no len",
        "A generator, map, zip or set has no numbered elements and often no length. Turn it into a list first: list(...).",
        "ジェネレータ・map・zip・集合からは、番号で要素を取り出せません(長さも求められないことがあります)。先に list(...) "
        "でリストにしましょう。",
    ),
    Row(
        "TypeError",
        r"'(?P<type1>[^']*)' object is not subscriptable",
        "Square brackets follow {type1}, which has no elements. Look at the name before the [ and print its type before "
        "this line.",
        "{type1}に角かっこ [ ] を付けていますが、要素を取り出せません。[ の前の名前を確かめ、この行の前で type(...) を "
        "print してみましょう。",
    ),
    Row(
        "TypeError",
        r"'NoneType' object is not iterable|cannot unpack non-iterable NoneType|not an iterable, not NoneType",
        "Several values are expected here, but there is only None (nothing). It is probably the result of a function that "
        "has no return. Look at the function called in this line: does it end with return?",
        "複数の値が必要なところに None(値なし)があります。return のない関数の結果のようです。この行で呼び出している関数に "
        "return があるか確かめましょう。",
    ),
    Row(
        "TypeError",
        r"cannot unpack non-iterable (?:builtin_)?(?:function|method)|'(?:function|builtin_function_or_method|method)' "
        r"object is not iterable",
        "Several values are expected here, but there is a function that has not been called. Write its arguments in "
        "parentheses after its name: f(x), not f.",
        "複数の値が必要なところに、呼び出していない関数があります。f ではなく f(x) のように、関数名の後ろにかっこと引数を"
        "書きましょう。",
    ),
    Row(
        "TypeError",
        r"cannot unpack non-iterable (?P<type1>[\w.]+)",
        "Several names stand left of the =, but on the right there is only {type1}. Either one name is enough, or the "
        "function on the right should return several values. Print the right-hand side before this line.",
        "= の左側に変数が複数ありますが、右側は{type1}1つだけです。変数を1つにするか、右側の関数が複数の値を"
        "返すようにします。この行の前で右辺を print して確かめましょう。",
    ),
    Row(
        "TypeError",
        r"'int' object is not iterable",
        "A loop, sum() or += on a list got a single number where it needs a list or an array. To count up to n write for i "
        "in range(n); to put one value at the end of a list use append.",
        "for 文や sum()、リストへの += に、リストや配列ではなく整数が1つ渡されています。n 回くり返すなら for i in range(n)、"
        "リストの末尾に値を1つ加えるなら append を使いましょう。",
    ),
    Row(
        "TypeError",
        r"'(?P<type1>[^']*)' object is not (?:iterable|reversible|an iterator)|argument of type '(?P<type2>[^']*)' is not|"
        r"must be an iterable, not (?P<type3>[\w.]+)|(?P<zero>iteration over a 0-d array)",
        "A loop, sum(), max() or in needs a list or an array here, but got a single value. Print the value before this "
        "line: is it the whole array that you expect, or already one element?",
        "for 文や sum()、max()、in などには、リストや配列が必要ですが、単独の値が渡されています。この行の前で print して、"
        "配列全体なのか、1つの要素なのか確かめましょう。",
    ),
    Row(
        "TypeError",
        r"object of type '(?P<type1>[^']*)' has no len\(\)|len\(\) of unsized object",
        "len() was asked for the length of something that has none, such as a single number or None. Print the value before "
        "this line: is it the array that you expect?",
        "長さのないもの(1個の数値や None など)に len() を使っています。この行の前で print して、"
        "思ったとおりの配列になっているか確かめましょう。",
    ),
)

_OPERATORS = (
    Row(
        "TypeError",
        r"can't multiply sequence by non-int of type '(?P<type1>[^']*)'",
        "A list (or a text) is multiplied by {type1}; for a list * means repetition, not arithmetic. Make it an array "
        "first: np.asarray(values, dtype=float).",
        "リスト(または文字列)に{type1}を掛けています。リストの * は計算ではなく「くり返し」です。先に np.asarray(values, "
        "dtype=float) で配列にしましょう。",
    ),
    Row(
        "TypeError",
        r"can only concatenate str \(not \"(?P<type1>[^\"]*)\"\) to str|^must be str, not (?P<type2>\w+)",
        "A text and {type1}{type2} are joined with +. If you want to calculate, turn the text into a number with "
        "float(...); if you want to print, separate the two with a comma.",
        "文字列に{type1}{type2}を + で足しています。計算するなら float(...) で数値に直し、表示するだけなら print "
        "の中でコンマで区切りましょう。",
    ),
    Row(
        "TypeError",
        r"can only concatenate (?P<type0>list|tuple) \(not \"(?P<type1>[^\"]*)\"\)",
        "Here {type1} is added to {type0} with +; for lists and tuples + means putting one behind the other, not arithmetic. For "
        "arithmetic use an array, np.asarray(values, dtype=float); to add one element use append.",
        "{type0}に{type1}を + で足しています。リストやタプルの + は計算ではなく「連結」です。計算するなら "
        "np.asarray(values, dtype=float) で配列にし、要素を加えるなら append を使いましょう。",
    ),
    Row(
        "TypeError",
        r"unsupported operand type\(s\) for \^=?:|ufunc 'bitwise_xor' not supported",
        "The sign ^ is not a power in Python. Write ** for powers, for example x ** 2.",
        "Pythonの ^ はべき乗ではありません。べき乗は x ** 2 のように ** で書きましょう。",
    ),
    Row(
        "TypeError",
        r"unsupported operand type\(s\) for [&|]=?:|ufunc '(?:bitwise_and|bitwise_or|invert)' not supported|cannot perform "
        r"'\w+and_'",
        "The signs &, | and ~ were given numbers; they join conditions. Because they bind more tightly than < and >, each "
        "comparison needs its own parentheses: (a > 0) & (a < 1).",
        "&、|、~ が数値に使われています。これらは条件を組み合わせる記号です。比較の < や > より先に計算されるので、(a > 0) "
        "& (a < 1) のように比較をそれぞれかっこで囲みましょう。",
    ),
    Row(
        "TypeError",
        _operands("NoneType"),
        "One side of the {op} is None (nothing). It is probably the result of a function without return, or of a method "
        "such as append() or sort(). Print both sides before this line and see which one is None.",
        "{op} の片側が None(値なし)です。return のない関数や、append()・sort() などの結果を使っているようです。"
        "この行の前で両側を print して、どちらが None か調べましょう。",
    ),
    Row(
        "TypeError",
        _operands("str|numpy.str_"),
        'The {op} has text on one side: {type1} and {type2}. Text, even "1.5", is not a number. Turn it into one with '
        "float(...), or remove the quotation marks.",
        '{op} の片側が文字列です({type1}と{type2})。"1.5" のような文字列は数値ではありません。float(...) で数値に直すか、'
        "引用符を外しましょう。",
    ),
    Row(
        "TypeError",
        _operands(_FUNCTIONS),
        "One side of the {op} is a function that has not been called. Write its arguments in parentheses after its name: "
        "f(x), not f.",
        "{op} の片側が、呼び出していない関数です。f ではなく f(x) のように、関数名の後ろにかっこと引数を書きましょう。",
    ),
    Row(
        "TypeError",
        _operands("module"),
        "One side of the {op} is a module. Perhaps a variable has the same name as a module, or the part after the dot is "
        "missing, as in math.pi.",
        "{op} の片側がモジュールです。変数とモジュールが同じ名前になっているか、math.pi "
        "のようなドットの後ろが抜けているようです。",
    ),
    Row(
        "TypeError",
        _operands("list|tuple"),
        "The {op} has {type1} and {type2} on its sides; Python's lists and tuples do not calculate. Make arrays of them "
        "first: np.asarray(values, dtype=float).",
        "{op} の両側が{type1}と{type2}です。Pythonのリストやタプルでは計算できません。先に np.asarray(values, dtype=float) "
        "で配列にしましょう。",
    ),
    Row(
        "TypeError",
        _operands(_ITERATORS),
        "One side of the {op} is a generator, map or zip, which is not calculated yet. Turn it into an array: "
        "np.array(list(...)).",
        "{op} の片側がジェネレータ・map・zipで、まだ値になっていません。np.array(list(...)) で配列にしましょう。",
    ),
    Row(
        "TypeError",
        _operands("dict"),
        'One side of the {op} is a dictionary. Take the entry you need out of it first: d["key"].',
        '{op} の片側が辞書です。先に d["key"] のように、必要な項目を取り出しましょう。',
    ),
    Row(
        "TypeError",
        _operands("[^']*"),
        "{op} cannot be used between {type1} and {type2}. Print type(...) of both sides before this line: one of them is "
        "not what you expect.",
        "{type1}と{type2}の間で {op} は使えません。この行の前で両側の type(...) を print し、思ったものと違うほうを"
        "調べましょう。",
    ),
    Row(
        "TypeError",
        r"bad operand type for (?:unary (?P<op>\S)|(?P<op2>\w+\(\))): '(?P<type1>list|tuple)'",
        "{op}{op2} was applied to {type1}; Python's lists and tuples do not calculate. Make an array of it first: "
        "np.asarray(values, dtype=float).",
        "{op}{op2} が{type1}に使われています。Pythonのリストやタプルでは計算できません。先に np.asarray(values, "
        "dtype=float) で配列にしましょう。",
    ),
    Row(
        "TypeError",
        r"bad operand type for (?:unary (?P<op>\S)|(?P<op2>\w+\(\))): '(?P<type1>[^']*)'",
        "{op}{op2} was applied to {type1}, which is not a number. Print the value before this line and look where it comes from.",
        "{op}{op2} が{type1}に使われていますが、これは数値ではありません。この行の前で値を print し、"
        "どこから来た値か調べましょう。",
    ),
    Row(
        "TypeError",
        r"'(?P<op>[<>]=?)' not supported between instances of (?=.*'NoneType')",
        "One side of the comparison {op} is None (nothing). It is probably the result of a function without return. Print "
        "both sides before this line.",
        "比較 {op} の片側が None(値なし)です。return のない関数の結果のようです。この行の前で両側を print して確かめましょう。",
    ),
    Row(
        "TypeError",
        r"'(?P<op>[<>]=?)' not supported between instances of (?=.*'complex)",
        "Complex numbers cannot be compared with {op}. A power with a broken exponent, or a root, of a negative number "
        "gives complex numbers. Look where a number under a root becomes negative.",
        "複素数は {op} で比較できません。負の数の平方根や小数乗は複素数になります。根号の中が負になっていないか調べましょう。",
    ),
    Row(
        "TypeError",
        r"'(?P<op>[<>]=?)' not supported between instances of '(?P<type1>[^']*)' and '(?P<type2>[^']*)'",
        "With {op} you cannot compare {type1} and {type2}. For numbers in a list use an array, np.asarray(values); text "
        "becomes a number with float(...). Print type(...) of both sides.",
        "{type1}と{type2}は {op} で比較できません。数値のリストなら np.asarray(values) で配列に、文字列なら float(...) "
        "で数値にします。両側の type(...) を print して確かめましょう。",
    ),
    Row(
        "TypeError",
        r"did not contain a loop with signature matching types|resolved dtypes are not compatible",
        "An array in this calculation contains text instead of numbers. A list that mixes numbers and text becomes an array "
        "of text. Print the dtype of each array; values from a file need float(...).",
        "計算に使っている配列の中身が、数値ではなく文字列です。数値と文字列が混ざったリストは文字列の配列になります。"
        "各配列の dtype を print しましょう。ファイルから読んだ値には float(...) が必要です。",
    ),
    Row(
        "TypeError",
        r"Cannot cast ufunc '\w+' output from dtype\('(?P<key>\w+)'\) to dtype\('(?P<other>\w+)'\)",
        "Results of type {key} do not fit into an array of type {other}: an in-place operation such as += keeps the type of "
        "the array. Create the array with dtype=float, for example np.zeros(n) or np.asarray(a, dtype=float).",
        "{key} 型の計算結果を {other} 型の配列に入れようとしています。+= などの上書きの計算では、配列の型は変わりません。"
        "np.zeros(n) や np.asarray(a, dtype=float) のように、最初から実数の配列にしましょう。",
    ),
    Row(
        "TypeError",
        r"Cannot cast array data from dtype\('(?P<key>[^']+)'\) to dtype\('(?P<other>[^']+)'\)",
        "An array of type {key} was given where one of type {other} is needed. Indices must be whole numbers, and text is "
        "not a number. Print the dtype of the arrays in this line.",
        "{other} 型が必要なところに {key} 型の配列が渡されています。添字は整数でなければならず、文字列は数値ではありません。"
        "この行の配列の dtype を print して確かめましょう。",
    ),
    Row(
        "TypeError",
        r"numpy boolean (?:subtract|negative)",
        "The - was applied to True/False values. Turn the comparison into numbers first, for example with a.astype(float); "
        "to negate a condition use ~.",
        "真偽値(True/False)の配列に - を使っています。数値として計算するなら a.astype(float) で変換し、条件を否定するなら ~ "
        "を使いましょう。",
    ),
)

_NUMBERS_WANTED = (
    Row(
        "TypeError",
        r"only (?:0-dimensional|length-1|size-1) arrays can be converted",
        "A whole array stands where one single number is needed. The functions of math and float() take one number only; "
        "for arrays use NumPy's, for example np.cos instead of math.cos. If one number is meant, pick the element with [i].",
        "数値1個が必要なところに配列があります。math の関数や float() は数値1個しか扱えません。配列には math.cos ではなく "
        "np.cos のように NumPy の関数を使いましょう。1個の数値のつもりなら [i] で要素を取り出します。",
    ),
    Row(
        "TypeError",
        r"(?:must be real number, not|argument must be a string[\w, -]* or a real number, not|doesn't define __round__ "
        r"method|cannot be interpreted as an integer|a real number is required, not) ?'?(?P<type1>list|tuple|"
        r"numpy\.ndarray)'?|type (?P<type2>list|tuple|numpy\.ndarray) doesn't define __round__|'(?P<type3>list|tuple)' "
        r"object cannot be interpreted as an integer",
        "A whole list or array stands where one single number is needed. The functions of math, float() and round() take "
        "one number only; for lists and arrays use NumPy's, for example np.cos instead of math.cos. If one number is meant, "
        "pick the element with [i].",
        "数値1個が必要なところにリストや配列があります。math の関数や float()、round() は数値1個しか扱えません。"
        "リストや配列には np.cos のように NumPy の関数を使いましょう。1個の数値のつもりなら [i] で要素を取り出します。",
    ),
    Row(
        "TypeError",
        r"real number(?: is required)?, not '?NoneType|NoneType doesn't define __round__|of type NoneType which has no "
        r"callable|'NoneType' object cannot be interpreted",
        "None (nothing) stands where a number is needed. It is probably the result of a function without return, or a value "
        "that was never set. Print it before this line.",
        "数値が必要なところに None(値なし)があります。return のない関数の結果か、値を入れていない変数のようです。"
        "この行の前で print して確かめましょう。",
    ),
    Row(
        "TypeError",
        r"real number(?: is required)?, not '?(?:function|builtin_function_or_method|method|type)|of type (?:function|"
        r"builtin_function_or_method|method|type) which has no callable",
        "A function that has not been called stands where a number is needed. Write its arguments in parentheses after its "
        "name: f(x), not f.",
        "数値が必要なところに、呼び出していない関数があります。f ではなく f(x) のように、関数名の後ろにかっこと引数を"
        "書きましょう。",
    ),
    Row(
        "TypeError",
        r"real number(?: is required)?, not '?(?:complex|numpy\.complex\w*)|Cannot convert complex to float|can't convert "
        r"complex to (?:float|int)",
        "A complex number stands where a real one is needed. A root or a broken power of a negative number gives complex "
        "numbers. Look where a number under a root becomes negative.",
        "実数が必要なところに複素数があります。負の数の平方根や小数乗は複素数になります。"
        "根号の中が負になっていないか調べましょう。",
    ),
    Row(
        "TypeError",
        r"real number(?: is required)?, not '?str|type str doesn't define __round__|'str' object cannot be interpreted",
        'Text stands where a number is needed. Text, even "1.5", is not a number. Turn it into one with float(...), or '
        "remove the quotation marks.",
        '数値が必要なところに文字列があります。"1.5" のような文字列は数値ではありません。float(...) で数値に直すか、'
        "引用符を外しましょう。",
    ),
    Row(
        "TypeError",
        r"loop of ufunc does not support argument \d+ of type (?P<type1>int|float|bool|list|dict|tuple|set|str) which has "
        r"no callable (?P<function>\w+)",
        "np.{function} was given an array of dtype object: it holds Python objects instead of plain numbers. Lists of "
        "unequal length, None or dictionaries make such arrays. Print the array and its dtype, and build it with "
        "dtype=float.",
        "np.{function} に dtype が object の配列(数値ではなくPythonのオブジェクトが入った配列)が渡されています。"
        "長さの違うリストや None、辞書が混ざるとこうなります。配列とその dtype を print し、dtype=float で作り直しましょう。",
    ),
    Row(
        "TypeError AttributeError",
        rf"loop of ufunc does not support argument \d+ of type \w+ which has no callable (?P<function>\w+)|"
        rf"'(?:{_SYMBOLIC})' object has no attribute '(?P<function2>{_MATHS})'",
        "NumPy's {function}{function2} was given a SymPy symbol; NumPy calculates with numbers only. Use SymPy's functions "
        "for symbols, for example sp.cos(theta) instead of np.cos(theta), all through the formula.",
        "NumPyの {function}{function2} にSymPyの記号が渡されています。NumPyは数値しか計算できません。記号の式では "
        "np.cos(theta) ではなく sp.cos(theta) のように、すべてSymPyの関数を使いましょう。",
    ),
    Row(
        "TypeError",
        r"[Cc](?:annot|an't) convert (?:expression|symbols) to (?:float|int)",
        "A formula with SymPy symbols stands where a number is needed. The functions of math and NumPy take numbers only. "
        "Use SymPy's for symbols, for example sp.cos instead of math.cos; do not put symbols into arrays of numbers.",
        "数値が必要なところにSymPyの記号の式があります。math やNumPyの関数は数値しか扱えません。記号には math.cos ではなく "
        "sp.cos のようにSymPyの関数を使い、数値の配列に記号を入れないようにしましょう。",
    ),
    Row(
        "TypeError",
        r"cannot determine truth value of Relational",
        "An if, max or min was given a SymPy symbol: whether it is true is not known before the "
        "symbol has a value. Write the formula without if, or use sp.Piecewise.",
        "SymPyの記号を if(または max や min)で比較しています。記号に値が入るまで、真偽は決まりません。if を"
        "使わない式にするか、sp.Piecewise を使いましょう。",
    ),
    Row(
        "AttributeError",
        r"'\w+' object has no attribute '(?:is_Number|as_coefficient|as_base_exp|is_zero|is_commutative|_eval_\w+)'",
        "A SymPy function was given a list or an array. SymPy's functions take one expression; for arrays of numbers use "
        "NumPy's, for example np.cos.",
        "SymPyの関数にリストや配列が渡されています。SymPyの関数は式を1つだけ受け取ります。数値の配列には np.cos "
        "のようにNumPyの関数を使いましょう。",
    ),
    Row(
        "TypeError",
        r"ufunc '(?P<function>\w+)' not supported for the input types",
        "np.{function} got something that is not a number: text, None, an object or a complex number. Print the value and "
        "its dtype before this line.",
        "np.{function} に数値以外のもの(文字列、None、オブジェクト、複素数など)が渡されています。この行の前で、値とその "
        "dtype を print して確かめましょう。",
    ),
    Row(
        "TypeError",
        r"real number(?: is required)?, not '?(?P<type1>[\w.]+)|type (?P<type2>[\w.]+) doesn't define __round__",
        "There is {type1}{type2} where a number is needed. Print it before this line and look where it comes from.",
        "数値が必要なところに{type1}{type2}があります。この行の前で print し、どこから来た値か調べましょう。",
    ),
    Row(
        "TypeError",
        r"only integer scalar arrays can be converted to a scalar index",
        "An array stands where one whole number is needed: as the index of a list, in range(), or as the axis of a NumPy "
        "function. Lists cannot be indexed with arrays: use np.asarray(values). np.concatenate and np.stack take their "
        "arrays in one list, in square brackets.",
        "整数1個が必要なところ(リストの添字、range()、NumPy関数の axis など)に配列があります。リストに配列の添字は"
        "使えないので np.asarray(values) にします。np.concatenate や np.stack には、配列を角かっこでまとめて渡しましょう。",
    ),
    Row(
        "TypeError",
        r"'(?P<type1>[^']*)' object cannot be interpreted as an integer|expected a sequence of integers or a single "
        r"integer, got '(?P<value>[^']*)'",
        "A whole number is needed here, as in range(), for a size or a number of points, but there is one with a decimal "
        "point. Use // for whole division, or int(...); round first if the value is only nearly whole.",
        "整数が必要なところ(range()、配列の大きさ、点の個数など)に、整数でない値があります。整数の割り算 // や int(...) を"
        "使いましょう。整数に近い値なら、先に四捨五入します。",
    ),
    Row(
        "TypeError",
        r"(?P<key>list|tuple) indices must be integers or slices, not tuple",
        "A {key} is indexed with [i, j]; that works for arrays only. Write a[i][j], or make an array of it first: np.asarray(a).",
        "リスト(list)やタプル(tuple)に [i, j] という添字を使っています。この書き方ができるのは配列だけです。a[i][j] "
        "と書くか、先に np.asarray(a) で配列にしましょう。",
    ),
    Row(
        "TypeError",
        r"(?:list|tuple|string|str) indices must be integers(?: or slices)?, not '?str\b",
        "An index in quotation marks stands behind something that is not a dictionary. A list or a tuple takes whole "
        "numbers, a[0]. Print type(...) of what stands before the [: is it the dictionary that you expect?",
        "辞書ではないものに、引用符付きの添字を使っています。リストやタプルの添字は a[0] のように整数です。[ "
        "の前にあるものの type(...) を print し、思ったとおりの辞書か確かめましょう。",
    ),
    Row(
        "TypeError",
        r"(?P<key>list|tuple|string|str) indices must be integers(?: or slices)?, not '?(?P<type1>[\w.]+)|slice indices "
        r"must be integers",
        "The index in the square brackets is not a whole number. Perhaps the loop runs over the values themselves (for x in "
        "xs) although an index is needed (for i in range(len(xs))), or a / gave a decimal number: use //.",
        "角かっこの中の添字が整数ではありません。添字が必要なのに値そのものでループしているか(for x in xs と for i in "
        "range(len(xs)) の違い)、/ の結果が小数になっているようです。整数の割り算は // です。",
    ),
    Row(
        "TypeError",
        r"unhashable type: '(?P<type1>[^']*)'",
        "A key of a dictionary or an element of a set cannot be {type1}. Use a number, a text or a tuple instead; perhaps "
        "square brackets [ ] were meant where curly ones stand.",
        "{type1}は辞書のキーや集合の要素にできません。数値・文字列・タプルを使いましょう。波かっこではなく角かっこ [ ] "
        "のつもりではありませんか。",
    ),
    Row(
        "TypeError",
        r"'(?P<type1>tuple|str)' object does(?: not|n't) support item (?:assignment|deletion)",
        "An element of {type1} is to be changed, but it cannot be changed after it was made. Use a list or an array, or "
        "build a new one and return that.",
        "{type1}の要素を書き換えようとしていますが、一度作ると変更できません。リストや配列を使うか、新しいものを"
        "作って返しましょう。",
    ),
    Row(
        "TypeError",
        r"'(?P<type1>[^']*)' object does(?: not|n't) support item (?:assignment|deletion)",
        "A value is to be put into {type1} with [ ], but it has no elements. Create an array for the results first, for "
        "example np.zeros(n), and check the name before the [.",
        "{type1}に [ ] で値を入れようとしていますが、要素を持たない値です。先に np.zeros(n) などで結果用の配列を作り、[ "
        "の前の名前を確かめましょう。",
    ),
    Row(
        "TypeError ValueError",
        r"unsupported format string passed to|Unknown format code|not all arguments converted during string|not enough "
        r"arguments for format|[Ii]nvalid format specifier",
        "A print with a format such as :.2f got a value it cannot show so, for example an array, a list or None. The answer "
        "needs no print: delete the line, or print the value without a format.",
        ":.2f のような書式に合わない値(配列、リスト、None など)を表示しようとしています。答えに print は必要ないので、"
        "その行を消すか、書式なしで表示しましょう。",
    ),
    Row(
        "TypeError",
        r"exceptions must derive from BaseException",
        'raise needs an exception, not a text or a number. Write for example raise ValueError("..."). If you want to give '
        "back a result, use return.",
        'raise には、文字列や数値ではなく例外が必要です。raise ValueError("...") のように書きます。結果を返したいときは '
        "return を使いましょう。",
    ),
)

_VALUES = (
    Row(
        "ValueError",
        r"operands could not be broadcast together with (?:remapped )?shapes (?P<shapes>.*)",
        "Two arrays do not fit together: {shapes}. Element by element arithmetic needs equal lengths; np.diff and slices "
        "such as a[1:] are one shorter than a. Print the .shape of both before this line.",
        "2つの配列の大きさが合いません({shapes})。要素ごとの計算には同じ長さが必要です。np.diff や a[1:] は"
        "元の配列より1つ短くなります。この行の前で両方の .shape を print しましょう。",
    ),
    Row(
        "ValueError",
        r"objects cannot be broadcast to a single shape\.(?P<shapes>.*)",
        "Two arrays do not fit together: {shapes}. Element by element arithmetic needs equal lengths. Print the .shape of "
        "both before this line.",
        "2つの配列の大きさが合いません({shapes})。要素ごとの計算には同じ長さが必要です。この行の前で両方の .shape を print "
        "しましょう。",
    ),
    Row(
        "ValueError",
        r"(?P<shapes>(?:non-broadcastable output|could not broadcast input array|value array of shape).*)",
        "An array does not fit into the place it is assigned to: {shapes}. Count the elements on both sides of the =; a "
        "slice such as a[1:] has one place less than a.",
        "代入する配列が、代入先の大きさと合いません({shapes})。= の両側の要素の数を数えましょう。a[1:] のようなスライスは、"
        "a より1つ短くなります。",
    ),
    Row(
        "ValueError",
        r"mismatch in its core dimension.*\(size (?P<key>\d+) is different from (?P<other>\d+)\)",
        "The product @ does not fit: the rows on the left have {other} elements, the columns on the right {key}. They must "
        "be equal. Print the .shape of both; perhaps the order is reversed, one needs .T, or the vectors of a batch need "
        "their own axis.",
        "行列積 @ の大きさが合いません。左の行の要素は{other}個、右の列の要素は{key}個ですが、同じでなければなりません。"
        "両方の .shape を print し、順番や転置 .T、まとめて計算するときの軸を確かめましょう。",
    ),
    Row(
        "ValueError",
        r"does not have enough dimensions \(has 0",
        "One side of the product @ is a single number. @ multiplies matrices and vectors only; for a single number use *.",
        "行列積 @ の片側が数値1個です。@ は行列やベクトルの積です。数値を掛けるときは * を使いましょう。",
    ),
    Row(
        "ValueError",
        r"shapes (?P<shape1>\([^)]*\)) and (?P<shape2>\([^)]*\)) not aligned",
        "The product does not fit: {shape1} times {shape2}. The last length on the left must equal the first on the right. "
        "Print the .shape of both; perhaps the order is reversed or one needs .T.",
        "積の大きさが合いません({shape1}と{shape2})。左の最後の長さと、右の最初の長さが同じでなければなりません。両方の "
        ".shape を print し、順番や転置 .T を確かめましょう。",
    ),
    Row(
        "ValueError",
        r"Matrix size mismatch: (?P<shape1>\([^)]*\)) (?P<op>\S) (?P<shape2>\([^)]*\))",
        "Two SymPy matrices do not fit together: ({shape1}) {op} ({shape2}). For + they need the same size; for * the columns "
        "on the left must be as many as the rows on the right. Print the .shape of both.",
        "SymPyの行列の大きさが合いません: ({shape1}) {op} ({shape2})。+ では同じ大きさ、* では"
        "左の列数と右の行数が同じでなければなりません。両方の .shape を print しましょう。",
    ),
    Row(
        "ValueError",
        r"inhomogeneous",
        "np.array was given parts of different lengths: they do not form a regular array. Perhaps a single number and an "
        "array are mixed in one list. Print the shape of each part with np.shape(...).",
        "np.array に長さの違う要素が渡され、規則正しい配列になりません。1つのリストに、数値と配列が混ざっていませんか。"
        "各要素の np.shape(...) を print して確かめましょう。",
    ),
    Row(
        "ValueError TypeError",
        r"setting an array element with a sequence",
        "A whole list or array is put into one single place of an array, a[i] = ... . Either the right-hand side should be "
        "one number, or the place should be a row or a slice, a[i, :]. Print np.shape(...) of the right-hand side.",
        "配列の1か所(a[i] = ...)に、リストや配列をまるごと入れようとしています。右辺を1個の数値にするか、左辺を a[i, :] "
        "のような行やスライスにしましょう。右辺の np.shape(...) を print して確かめてください。",
    ),
    Row(
        "ValueError",
        r"too many values to unpack \(expected (?P<count>\d+)",
        "Left of the = there are {count} names, but the right-hand side has more values. Count both sides, and look at what "
        "the function on the right returns.",
        "= の左側の変数は{count}個ですが、右側の値はそれより多くあります。両側の数を数え、右側の関数が何を返すか確かめましょう。",
    ),
    Row(
        "ValueError",
        r"not enough values to unpack \(expected (?:at least )?(?P<count>\d+), got (?P<given>\d+)\)",
        "Left of the = there are {count} names, but the right-hand side has only {given}. Count both sides, and look at "
        "what the function on the right returns.",
        "= の左側には変数が{count}個ありますが、右側の値は{given}個しかありません。両側の数を数え、右側の関数が何を"
        "返すか確かめましょう。",
    ),
    Row(
        "ValueError",
        r"truth value of an empty array is ambiguous",
        "An empty array was used as a condition. Ask for its size instead, if a.size > 0, and look why it is empty.",
        "空の配列を条件に使っています。if a.size > 0 のように大きさを調べ、なぜ空になったのか確かめましょう。",
    ),
    Row(
        "ValueError",
        r"truth value of an array with more than one element",
        "A whole array was used as one condition, in if, while, and, or, not, max() or min(). It holds many answers, not "
        "one. Choose element by element with np.where(condition, a, b), or loop; join conditions with & and |, each in "
        "parentheses.",
        "if、while、and、or、not、max()、min() などで、配列全体を1つの条件として使っています。配列には"
        "真偽が要素の数だけあります。np.where(条件, a, b) で要素ごとに選ぶか、ループにしましょう。条件をつなぐには、"
        "それぞれをかっこで囲んで & や | を使います。",
    ),
    Row(
        "ValueError",
        r"all input arrays must have the same shape|all the input array",
        "Arrays of different shapes are stacked or joined. They must agree in number of axes and in every length except the "
        "one along which they are joined. Print the .shape of each.",
        "形の違う配列を結合しようとしています。軸の数と、結合する方向以外の長さが、すべて同じでなければなりません。"
        "それぞれの .shape を print して確かめましょう。",
    ),
    Row(
        "ValueError",
        r"zero-dimensional arrays cannot be concatenated",
        "np.concatenate was given single numbers; it joins arrays. Make an array of numbers with np.array([...]), or put "
        "each number in square brackets.",
        "np.concatenate に数値が1個ずつ渡されていますが、これは配列をつなぐ関数です。数値から配列を作るには np.array([...]) "
        "を使うか、数値を角かっこで囲みましょう。",
    ),
    Row(
        "ValueError",
        r"math domain error|expected a (?:nonnegative|positive|finite) input|expected a number in range|expected a "
        r"noninteger or positive",
        "A function of math was given a number outside its range: sqrt needs 0 or more, log more than 0, acos and asin a "
        "number from -1 to 1. Print the argument before this line; rounding may push it just over the edge.",
        "math の関数に、定義域の外の数値が渡されています。sqrt は0以上、log は正の数、acos と asin は-1から1までです。"
        "この行の前で引数を print しましょう。丸め誤差で、わずかに範囲を超えることもあります。",
    ),
    Row(
        "ValueError OverflowError",
        r"cannot convert float (?:NaN|infinity) to integer",
        "NaN or infinity cannot become a whole number. Somewhere before, 0 was divided by 0, a number by 0, or a root was "
        "taken of a negative number. Print the value before int(...) or round(...).",
        "NaN や無限大は整数に直せません。それより前に、0での割り算や負の数の平方根があったようです。int(...) や round(...) "
        "の前で値を print して調べましょう。",
    ),
    Row(
        "ValueError",
        r"cannot reshape array of size (?P<count>\d+) into shape (?P<shape1>\([^)]*\))",
        "An array of {count} elements cannot be reshaped to {shape1}: the number of elements must stay the same. Print the "
        ".shape before the reshape.",
        "要素が{count}個の配列を{shape1}に変形することはできません。要素の総数は変わらないはずです。reshape の前で .shape を"
        " print して確かめましょう。",
    ),
    Row(
        "ValueError",
        r"could not convert string (?:to float: )?(?:np\.str_\()?(?P<value>'[^']*')|invalid literal for int\(\) with base "
        r"10: (?P<value2>'[^']*')",
        "A text cannot be read as a number: {value}{value2}. In a file this may be a heading, an empty field or another "
        "separator than expected. Print the text before this line; int() also refuses a decimal point.",
        "文字列 {value}{value2} を数値として読めません。ファイルなら、見出しの行、空の欄、区切り文字の違いが考えられます。"
        "この行の前で文字列を print しましょう。int() は小数点も受け付けません。",
    ),
    Row(
        "ValueError",
        r"number of columns changed from (?P<key>\d+) to (?P<other>\d+)",
        "The rows of the file do not all have the same number of columns: {key}, then {other}. Look at the file's first "
        "lines: is there a heading, or another separator?",
        "ファイルの行によって列の数が違います({key}列と{other}列)。ファイルの先頭を見て、見出しの行や区切り文字を"
        "確かめましょう。",
    ),
    Row(
        "ValueError IndexError",
        r"axis (?P<key>-?\d+) is out of bounds for array of dimension (?P<count>\d+)",
        "There is no axis={key}: axes are counted from 0, and the number of axes of this array is {count}. Print the .shape of the "
        "array: perhaps it has lost an axis.",
        "axis={key} を指定していますが、配列の軸は{count}本しかありません(軸は0から数えます)。配列の .shape を print し、"
        "軸が減っていないか確かめましょう。",
    ),
    Row(
        "ValueError",
        r"arg is an empty sequence|iterable argument is empty|zero-size array to reduction|of an empty sequence|sample "
        r"points is empty|at least one data point",
        "max(), min() or a similar function was given nothing at all: the list or array is empty. Print its length before "
        "this line and look why nothing was put in.",
        "max() や min() などに、空のリストや配列が渡されています。この行の前で長さを print し、なぜ空なのか調べましょう。",
    ),
    Row(
        "ValueError",
        r"(?:diff|input) requires input that is at least one dimensional|at least one dimensional",
        "A function that needs an array was given a single number. Print the value before this line: perhaps one element "
        "was taken out with [i] too early.",
        "配列が必要な関数に、数値が1個だけ渡されています。この行の前で print し、[i] で要素を"
        "早く取り出しすぎていないか確かめましょう。",
    ),
    Row(
        "ValueError",
        r"negative dimensions are not allowed|must be non-negative",
        "An array was asked for with a negative size. Print the size before this line: it is probably a difference such as "
        "len(a) - 1 with an empty array.",
        "大きさが負の配列を作ろうとしています。この行の前で大きさを print しましょう。len(a) - 1 "
        "のような計算が負になっているようです。",
    ),
    Row(
        "ValueError",
        r"Integers to negative integer powers",
        "An array of whole numbers was raised to a negative power, which NumPy refuses. Make it an array of decimal numbers "
        "first: np.asarray(a, dtype=float), or write 2.0 instead of 2.",
        "整数の配列を負の数で累乗しています。NumPyではこの計算ができません。np.asarray(a, dtype=float) "
        "で実数の配列にするか、2 ではなく 2.0 と書きましょう。",
    ),
    Row(
        "ValueError",
        r"is not in list|x not in list|x not in tuple|substring not found",
        "index() or remove() looked for something that is not there. Decimal numbers are seldom exactly equal. Print what "
        "is sought and where it is sought before this line.",
        "index() や remove() で探したものが見つかりません。小数がぴったり等しくなることはまれです。この行の前で、"
        "探す値と探す相手を print して確かめましょう。",
    ),
    Row(
        "ValueError",
        r"zip\(\) argument \d+ is (?:longer|shorter)|have same first dimension, but have shapes|not of the same length|must "
        r"be the same (?:size|length)",
        "Two series that belong together have different lengths: {message}. np.diff and slices such as a[1:] are one "
        "shorter than a. Print the length of both before this line.",
        "組になるべき2つの列の長さが違います: {message}。np.diff や a[1:] は元の配列より1つ短くなります。"
        "この行の前で両方の長さを print しましょう。",
    ),
    Row(
        "ValueError",
        r"either both or neither of x and y",
        "np.where was given two arguments. It takes three, np.where(condition, a, b), or only the condition.",
        "np.where に引数が2つ渡されています。np.where(条件, a, b) のように3つ渡すか、条件だけを渡しましょう。",
    ),
    Row(
        "ValueError",
        r"Singular matrix|det == 0; not invertible|Matrix is singular",
        "The matrix has no inverse (it is singular): a row is zero, or a multiple of another. Print the matrix before this "
        "line and compare its rows with the formula.",
        "この行列には逆行列がありません(特異行列です)。ある行が0か、別の行の定数倍になっています。この行の前で行列を print "
        "し、式と比べましょう。",
    ),
    Row(
        "ValueError",
        r"must be (?:at least two-dimensional|square)|-dimensional array given",
        "This needs a square matrix, but the array has another shape. Print its .shape before this line.",
        "正方行列が必要ですが、配列の形が違います。この行の前で .shape を print して確かめましょう。",
    ),
    Row(
        "ValueError",
        r"read-only",
        "The array must not be changed: it is read-only, because it belongs to the caller or is a view of another array. "
        "Work on a copy: a = np.array(a, dtype=float).",
        "この配列は読み取り専用なので、書き換えられません。呼び出した側の配列か、別の配列を参照しているものです。a = "
        "np.array(a, dtype=float) でコピーしてから計算しましょう。",
    ),
    Row(
        "ValueError",
        r"Unable to avoid copy",
        "np.array(..., copy=False) has another meaning since NumPy 2.0 and fails if a copy is needed. Write np.asarray(...) "
        "instead.",
        "np.array(..., copy=False) の意味はNumPy 2.0で変わり、コピーが必要な場合はエラーになります。代わりに "
        "np.asarray(...) と書きましょう。",
    ),
    Row(
        "ValueError",
        r"incompatible dimensions for cross product|incompatible vector dimensions",
        "np.cross multiplies vectors with 3 elements. Print the .shape of both: the last length must be 3.",
        "np.cross は3要素のベクトルの外積です。両方の .shape を print し、最後の長さが3か確かめましょう。",
    ),
    Row(
        "ValueError",
        r"is not a valid value for|is not a valid format string|Unrecognized string|Unrecognized marker|is not a valid marker",
        "Matplotlib does not know a word that it was given: {message}. Compare the colour, marker, line style or option "
        "with the documentation.",
        "Matplotlibに渡した指定が正しくありません: {message}。色・マーカー・線種などの書き方を、ドキュメントと比べましょう。",
    ),
    Row(
        "ValueError",
        r"Sympify of expression|could not parse",
        "SymPy was given a text that it cannot read as a formula. Write formulas as code with symbols, without quotation "
        "marks, and with every * written out.",
        "SymPyに渡した文字列を、式として読み取れません。式は引用符を付けず、記号を使ったコードとして書きましょう。掛け算の "
        "* は省略できません。",
    ),
    Row(
        "ValueError",
        r"more than one variable in the expression|First variable cannot be a number",
        "sp.diff must be told which symbol to differentiate by: sp.diff(formula, symbol).",
        "sp.diff には、どの記号で微分するかを sp.diff(式, 記号) のように渡しましょう。",
    ),
    Row(
        "ValueError",
        r"I/O operation on closed file",
        "The file is read after it was closed. Keep the reading inside the with block, indented below it.",
        "閉じた後のファイルを読もうとしています。読み取りは with ブロックの中に、字下げして書きましょう。",
    ),
)

_INDICES = (
    Row(
        "IndexError",
        r"index (?P<key>-?\d+) is out of bounds for axis (?P<axis>\d+) with size (?P<count>\d+)",
        "Element {key} of axis {axis} is asked for, but that axis has only {count} elements, numbered from 0. Look at where "
        "the loop ends and at [k + 1] or [k - 1]; differences are one fewer than the values they come from.",
        "軸{axis}の{key}番の要素を使おうとしていますが、要素は{count}個しかありません(番号は0から始まります)。"
        "ループの終わりと、[k + 1] や [k - 1] を確かめましょう。差分の個数は、元の値より1つ少なくなります。",
    ),
    Row(
        "IndexError",
        r"(?P<key>list|tuple|string|range object|deque) (?:assignment )?index out of range",
        "An element is asked for that the list (or tuple, text) does not have: elements are numbered from 0 to length - 1. "
        "Print the index and len(...) before this line, and look at where the loop ends; an empty list grows with append.",
        "リスト(またはタプル、文字列)にない番号の要素を使おうとしています。番号は0から「長さ-1」までです。"
        "この行の前で添字と len(...) を print し、ループの終わりを確かめましょう。空のリストには append で要素を加えます。",
    ),
    Row(
        "IndexError",
        r"too many indices for array: array is (?P<count>\d+)-dimensional, but (?P<given>\d+) were indexed",
        "More indices stand in the square brackets ({given}) than the array has axes ({count}). Print its .shape before this "
        "line; a list of numbers gives one axis, a single number none.",
        "角かっこの中に添字が{given}個ありますが、配列の軸は{count}本です。この行の前で .shape を print しましょう。"
        "数値のリストから作った配列の軸は1本、数値1個なら0本です。",
    ),
    Row(
        "IndexError",
        r"only integers, slices|arrays used as indices must be of integer",
        "The index in the square brackets is neither a whole number nor a condition. Perhaps the loop runs over the values "
        "themselves although an index is needed, or a / gave a decimal number: use //.",
        "角かっこの中の添字が、整数でも条件でもありません。添字が必要なのに値そのものでループしているか、/ "
        "の結果が小数になっているようです。整数の割り算は // です。",
    ),
    Row(
        "IndexError",
        r"boolean index did not match",
        "The condition in the square brackets is of another length than the array. Make the condition from the same array, "
        "and print the .shape of both.",
        "角かっこの中の条件と配列の長さが違います。条件は同じ配列から作り、両方の .shape を print して確かめましょう。",
    ),
    Row(
        "IndexError",
        r"pop from (?:an )?empty",
        "pop() was called on an empty list. Print the list before this line, and stop the loop when it is empty.",
        "空のリストに pop() を使っています。この行の前でリストを print し、空になったらループを終えるようにしましょう。",
    ),
    Row(
        "IndexError",
        r"Replacement index",
        "A format text has more places {{}} than values. Count them, or delete the print: the answer needs none.",
        "書式の {{}} の数が、渡した値より多くなっています。数を合わせるか、その行を消しましょう。答えに print は必要ありません。",
    ),
    Row(
        "IndexError",
        "",
        "An element is asked for that does not exist: {message}. Print the index and the length before this line.",
        "存在しない要素を使おうとしています: {message}。この行の前で、添字と長さを print して確かめましょう。",
    ),
    Row(
        "KeyError",
        r"(?P<key>.+)",
        "The dictionary has no entry {key}. Keys must match to the letter, blanks and capitals included. Print "
        "list(d.keys()) of the dictionary before this line.",
        "辞書に {key} というキーはありません。キーは空白や大文字・小文字まで一致する必要があります。この行の前で、辞書の "
        "list(d.keys()) を print して確かめましょう。",
    ),
    Row(
        "KeyError",
        "",
        "The dictionary has no such entry. Print list(d.keys()) of the dictionary before this line.",
        "辞書にそのキーはありません。この行の前で、辞書の list(d.keys()) を print して確かめましょう。",
    ),
)

_ARITHMETIC = (
    Row(
        "ZeroDivisionError",
        "",
        "A number is divided by zero. Some of the inputs make the denominator 0, for example when nothing moves or nothing "
        "turns. Handle that case before dividing.",
        "0で割っています。入力によっては、動いていない、曲がっていないなどの場合に分母が0になります。割り算の前に、"
        "その場合を分けて考えましょう。",
    ),
    Row(
        "OverflowError",
        r"out of bounds for (?P<key>\w+)|too large to convert to C",
        "A whole number is too large for its type ({message}). Calculate with decimal numbers, or with a wider type such as "
        "np.int64, before taking differences.",
        "整数が、その型に入る範囲を超えています({message})。差をとる前に、実数や np.int64 のような大きい型に直しましょう。",
    ),
    Row(
        "OverflowError",
        "",
        "A number became too large to be stored: {message}. Perhaps an exponent is too large, a unit is wrong, or a value "
        "grows in every step of a loop. Print the values before this line.",
        "数値が大きくなりすぎました: {message}。指数が大きすぎる、単位が違う、"
        "ループのたびに値が増えるなどの原因が考えられます。この行の前で値を print しましょう。",
    ),
    Row(
        "FloatingPointError",
        r"divide by zero|invalid value",
        "NumPy met a division by zero, or a root or logarithm outside its range ({message}). Look which input makes the "
        "denominator 0, and handle that case first.",
        "NumPyの計算で、0での割り算か、定義域の外の平方根や対数がありました({message})。分母が0になる入力を調べ、"
        "先にその場合を分けましょう。",
    ),
    Row(
        "FloatingPointError",
        "",
        "A number in a NumPy calculation became too large or too small ({message}). Look for a wrong unit or a value that "
        "grows in every step.",
        "NumPyの計算で、数値が大きくなりすぎたか小さくなりすぎました({message})。単位の間違いや、"
        "くり返しのたびに増える値がないか調べましょう。",
    ),
)

_ATTRIBUTE_ERRORS = (
    Row(
        "AttributeError",
        r"[Mm]odule '(?P<module>[\w.]+)' has no attribute '(?P<key>\w+)'",
        "{module} has no {key}: in the installed version it was renamed or removed, or it is called differently there. Use "
        "{found} instead.",
        "{module} に {key} はありません。今のバージョンで名前が変わったか削除されたか、もともと別の名前です。代わりに "
        "{found} を使いましょう。",
        found=_listed(_RENAMED, "{module}.{key}"),
    ),
    Row(
        "AttributeError",
        r"`np\.(?P<key>\w+)` was removed in the NumPy 2\.0 release",
        "numpy has no {key} any more: it was removed in NumPy 2.0. Use {found} instead. Old examples from the web often "
        "still contain such names.",
        "numpy の {key} はNumPy 2.0で削除されました。代わりに {found} を使いましょう。ウェブ上の古い例には、"
        "このような名前がよく残っています。",
        found=_listed(_RENAMED, "numpy.{key}"),
    ),
    Row(
        "AttributeError",
        r"`np\.(?P<key>\w+)` was removed in the NumPy 2\.0 release\. .*?[Uu]se `(?P<new>[^`]+)`",
        "numpy has no {key} any more: it was removed in NumPy 2.0. Use {new} instead. Old examples from the web often still "
        "contain such names.",
        "numpy の {key} はNumPy 2.0で削除されました。代わりに {new} を使いましょう。ウェブ上の古い例には、"
        "このような名前がよく残っています。",
    ),
    Row(
        "AttributeError",
        r"`(?:np\.)?(?P<key>\w+)` was removed",
        "numpy has no {key} any more: it was removed in NumPy 2.0. Look in NumPy's documentation for its successor; old "
        "examples from the web often still contain such names.",
        "numpy の {key} はNumPy 2.0で削除されました。代わりの関数をNumPyのドキュメントで探しましょう。ウェブ上の古い例には、"
        "このような名前がよく残っています。",
    ),
    Row(
        "AttributeError",
        r"partially initialized module '(?P<module>[\w.]+)'|module '(?P<module2>[\w.]+)' has no attribute .*consider renaming",
        "Python found a file of yours called {module}{module2}.py instead of the real module. Rename your file and restart "
        "the kernel.",
        "本来のモジュールではなく、{module}{module2}.py という自作のファイルが読み込まれています。ファイルの名前を変え、"
        "カーネルを再起動しましょう。",
    ),
    Row(
        "AttributeError",
        r"[Mm]odule '(?P<module>[\w.]+)' has no attribute '(?P<key>\w+)'",
        "{module} has no {key}. It looks like a typing error: is {found} meant? Correct the name after the dot.",
        "{module} に {key} はありません。{found} の打ち間違いのようです。ドットの後ろの名前を直しましょう。",
        found=_near_attribute,
    ),
    Row(
        "AttributeError",
        r"[Mm]odule '(?P<module>[\w.]+)' has no attribute '(?P<key>\w+)'",
        "{module} has no {key}. The name after the dot is misspelt, or it belongs to another module. Look it up in the "
        "documentation of {module}.",
        "{module} に {key} はありません。ドットの後ろの名前の間違いか、別のモジュールの名前です。{module} "
        "のドキュメントで調べましょう。",
    ),
    Row(
        "AttributeError",
        r"'NoneType' object has no attribute '(?P<key>\w+)'",
        "What stands before .{key} is None (nothing). It is probably the result of a function without return; append(), "
        "sort() and plt.show() also return nothing, so their result must not be assigned. Print it before this line.",
        ".{key} の前にあるものが None(値なし)です。return のない関数の結果のようです。append()、sort()、plt.show() "
        "も何も返さないので、結果を代入してはいけません。この行の前で print して確かめましょう。",
    ),
    Row(
        "AttributeError",
        r"'(?P<type1>list|tuple)' object has no attribute '(?P<key>set_\w+|[xy]lim|[xy]label)'",
        "What stands before .{key} is {type1}, not the Axes of a graph: plt.plot returns a list of lines, plt.subplots() "
        "returns a figure and its Axes. Write fig, ax = plt.subplots() and use ax.",
        ".{key} の前にあるものは、グラフのAxesではなく{type1}です。plt.plot は線のリストを、plt.subplots() は図とAxesの組を"
        "返します。fig, ax = plt.subplots() と書いて ax を使いましょう。",
    ),
    Row(
        "AttributeError",
        r"'(?:tuple|Figure|numpy\.ndarray|Line2D)' object has no attribute '(?P<key>plot|scatter|set_\w+|legend|grid|axis)'",
        "What stands before .{key} is not the Axes of a graph. plt.subplots() returns a figure and its Axes: write fig, ax "
        "= plt.subplots() and use ax. With several graphs ax is an array: pick one, ax[0].",
        ".{key} の前にあるものは、グラフのAxesではありません。plt.subplots() は図とAxesの組を返すので、fig, ax = "
        "plt.subplots() と書いて ax を使いましょう。グラフが複数あるときは ax[0] のように1つ選びます。",
    ),
    Row(
        "AttributeError",
        r"'Axes' object has no attribute '(?P<key>\w+)'",
        "An Axes has no {key}: on an Axes the method is called ax.{found}.",
        "Axesに {key} はありません。Axesでは ax.{found} という名前のメソッドを使います。",
        found=_listed(_SETTERS),
    ),
    Row(
        "AttributeError",
        r"'(?P<type1>list|tuple)' object has no attribute '(?P<key>append|add|push|extend|insert)'",
        "There is no {key} for {type1}. A tuple cannot grow; a list grows with append. Start with an empty list [ ] and use "
        "values.append(x).",
        "{type1}に {key} はありません。タプルには要素を加えられず、リストには append で加えます。空のリスト [ ] から始めて "
        "values.append(x) を使いましょう。",
        found=lambda groups: None if groups["key"] == "insert" and groups["type1"] == "list" else groups["key"],
    ),
    Row(
        "AttributeError",
        r"'(?P<module>list)' object has no attribute '(?P<key>\w+)'",
        "A list has no {key}. It looks like a typing error: is {found} meant?",
        "リストに {key} はありません。{found} の打ち間違いではありませんか。",
        found=_near_attribute,
    ),
    Row(
        "AttributeError",
        r"'(?P<type1>list|tuple)' object has no attribute '(?P<key>\w+)'",
        "There is no .{key} for {type1}: that belongs to arrays. Make an array of it first, np.asarray(values, dtype=float); the "
        "length of a list is len(values).",
        "{type1}に .{key} はありません。これは配列(ndarray)の機能です。先に np.asarray(values, dtype=float) "
        "で配列にしましょう。リストの長さは len(values) です。",
    ),
    Row(
        "AttributeError",
        r"'numpy\.ndarray' object has no attribute '(?P<key>append|extend|push|add|insert|pop|remove)'",
        "An array has no {key}: its length is fixed. Collect the values in a list and make the array at the end, or create "
        "np.zeros(n) first and fill it with a[i] = ... .",
        "配列に {key} はありません。配列の長さは変えられません。リストに集めて最後に配列にするか、先に np.zeros(n) を作って "
        "a[i] = ... で値を入れましょう。",
    ),
    Row(
        "AttributeError",
        r"'numpy\.ndarray' object has no attribute '(?P<key>ptp|itemset|newbyteorder)'",
        "Arrays have no {key} any more: it was removed in NumPy 2.0. Write np.ptp(a) for the range, a[i] = value to set an "
        "element.",
        "配列の {key} はNumPy 2.0で削除されました。範囲は np.ptp(a)、要素の代入は a[i] = value と書きましょう。",
    ),
    Row(
        "AttributeError",
        rf"'numpy\.(?:ndarray|float64|int64)' object has no attribute '(?P<key>{_MATHS}|arange|linspace|zeros|where|diff|"
        rf"hstack|vstack|norm|degrees|interp)'",
        "An array has no .{key}: it is a function of NumPy. Write np.{key}(a) instead of a.{key}().",
        "配列に .{key} はありません。これはNumPyの関数です。a.{key}() ではなく np.{key}(a) のように書きましょう。",
    ),
    Row(
        "AttributeError",
        r"'(?P<module>numpy\.ndarray|Axes|dict|str)' object has no attribute '(?P<key>\w+)'",
        "There is no .{key} for this kind of value. It looks like a typing error: is .{found} meant?",
        "この種類の値に .{key} はありません。.{found} の打ち間違いではありませんか。",
        found=_near_attribute,
    ),
    Row(
        "AttributeError",
        rf"'(?P<type1>{_NUMBERS})' object has no attribute '(?P<key>\w+)'",
        "What stands before .{key} is {type1}: a single number has no .{key}. Perhaps an array or a list was expected "
        "there; mathematical functions are written before the number, np.sqrt(x). Print it before this line.",
        ".{key} の前にあるものは{type1}です。1個の数値に .{key} はありません。配列やリストのつもりではありませんか。"
        "数学の関数は np.sqrt(x) のように書きます。この行の前で print して確かめましょう。",
    ),
    Row(
        "AttributeError",
        rf"'(?:{_FUNCTIONS})' object has no attribute '(?P<key>\w+)'",
        "What stands before .{key} is a function that has not been called. Write its arguments in parentheses first: f(x).{key}.",
        ".{key} の前にあるものが、呼び出していない関数です。f(x).{key} のように、先にかっこと引数を書いて呼び出しましょう。",
    ),
    Row(
        "AttributeError",
        r"'dict' object has no attribute '(?P<key>\w+)'",
        'A dictionary has no .{key}. Its entries are taken with square brackets and the name in quotation marks: d["{key}"].',
        '辞書に .{key} はありません。辞書の項目は d["{key}"] のように、角かっこと引用符で取り出します。',
    ),
    Row(
        "AttributeError",
        r"can't set attribute|cannot assign to field|has no setter|is read-only",
        "This object's parts cannot be changed after it was made: {message}. Make a new one with the new values and return that.",
        "このオブジェクトの中身は、作った後で変更できません: {message}。新しい値で作り直して、それを返しましょう。",
    ),
    Row(
        "AttributeError",
        r"'(?P<type1>[^']*)' object has no attribute '(?P<key>[^']*)'",
        "What stands before .{key} is {type1}, and it has no .{key}. Either the name after the dot is misspelt, or the "
        "value is not what you expect. Print its type(...) before this line.",
        ".{key} の前にあるものは{type1}で、.{key} はありません。ドットの後ろの名前の間違いか、"
        "思っていたものと違う値のようです。この行の前で type(...) を print して確かめましょう。",
    ),
    Row(
        "AttributeError",
        "",
        "The name after the dot does not exist: {message}. Compare its spelling with the documentation.",
        "ドットの後ろの名前が見つかりません: {message}。ドキュメントとつづりを比べましょう。",
    ),
)

_OTHERS = (
    Row(
        "AssertionError",
        r"\S",
        "An assert in your own code failed: {message}. The condition after assert was not true for these inputs. Print the "
        "values in it before this line.",
        "コードの中の assert が失敗しました: {message}。この入力では、assert の条件が成り立ちません。この行の前で、"
        "条件に使っている値を print して確かめましょう。",
    ),
    Row(
        "AssertionError",
        "",
        "An assert in your own code failed: the condition after assert was not true for these inputs. Print the values in "
        "it before this line.",
        "コードの中の assert が失敗しました。この入力では、assert の条件が成り立ちません。この行の前で、条件に使っている値を"
        " print して確かめましょう。",
    ),
    Row(
        "RecursionError",
        "",
        "The function calls itself again and again and never stops. Perhaps it should call another function with a similar "
        "name, or the case that ends the recursion is missing. Look for its own name inside its body.",
        "関数が自分自身を呼び続けて、止まらなくなりました。似た名前の別の関数を呼ぶつもりだったか、"
        "終了条件が抜けているようです。関数の中に自分の名前がないか確かめましょう。",
    ),
    Row(
        "MemoryError",
        "",
        "The memory is not enough: an enormous array or list was asked for. Perhaps a list grows in a loop without end, or "
        "sizes were multiplied. Print the .shape of the arrays involved.",
        "メモリが足りません。とても大きな配列やリストを作ろうとしました。ループの中でリストが増え続けているか、"
        "大きさの計算が違うようです。関係する配列の .shape を print しましょう。",
    ),
    Row(
        "TimeUp TimeoutError",
        "",
        "{name} did not finish in time and was stopped. Probably a loop does not end: which condition of while never "
        "becomes false? If it is only slow, calculate with whole arrays instead of a loop inside a loop.",
        "{name} が時間内に終わらなかったので、止めました。終わらないループがあるようです。while の条件がいつか False "
        "になるか確かめましょう。遅いだけなら、二重ループではなく配列のまま計算しましょう。",
    ),
    Row(
        "KeyboardInterrupt",
        "",
        "The check was stopped by hand while {name} was running. If it took too long, a loop probably does not end: which "
        "condition of while never becomes false?",
        "{name} の実行中に、チェックが手動で止められました。時間がかかりすぎたのなら、終わらないループがあるようです。while "
        "の条件がいつか False になるか確かめましょう。",
    ),
    Row(
        "SystemExit",
        "",
        "The function calls exit(), quit() or sys.exit(), which would end the whole program. To leave a function, use "
        "return. Delete that line.",
        "関数の中で exit()、quit()、sys.exit() が呼ばれています。これはプログラム全体を終わらせる命令です。関数を終えるには "
        "return を使い、その行は消しましょう。",
    ),
    Row(
        "StopIteration StopAsyncIteration",
        "",
        "next() was called, but there is no element left. Use a for loop, which stops by itself, or next(iterator, default).",
        "next() を呼びましたが、要素が残っていません。自動的に終わる for ループを使うか、next(iterator, 既定値) と書きましょう。",
    ),
    Row(
        "RuntimeError",
        r"changed size during iteration",
        "A dictionary or set is changed while a loop runs over it. Loop over a copy: for key in list(d).",
        "ループで使っている最中の辞書や集合を変更しています。for key in list(d) のように、コピーでループしましょう。",
    ),
    Row(
        "RuntimeError BlockingIOError OSError",
        r"can't start new thread|Resource temporarily unavailable|Cannot allocate memory",
        "Starting further threads or processes is not possible while an answer is checked, and no exercise needs them. "
        "Write the calculation in one piece.",
        "チェック中は、新しいスレッドやプロセスを作れません。どの課題にも必要ないので、1つの流れで計算しましょう。",
    ),
    Row(
        "RuntimeError",
        r"\S",
        "{name} stopped with an error while it ran: {message}. Look at the line where it happened and print the values it "
        "uses just before it.",
        "{name} の実行中にエラーが起きました: {message}。エラーの行を見て、そこで使っている値を直前で print して確かめましょう。",
    ),
    Row(
        "UnicodeDecodeError UnicodeEncodeError UnicodeError",
        "",
        "The characters of a file could not be read or written: it is in another encoding than assumed. Give the encoding "
        'when opening it, open(path, encoding="utf-8"); older Japanese files may need "cp932".',
        'ファイルの文字を読み書きできません。文字コードが想定と違います。open(path, encoding="utf-8") のように文字コードを'
        '指定しましょう。古い日本語のファイルでは "cp932" のこともあります。',
    ),
    Row(
        "FileNotFoundError",
        r"(?P<value>'[^']*')|(?P<value2>\S+) not found",
        "The file {value}{value2} was not found. Compare its name and folder with the notebook's text; a relative path "
        "starts at the folder of the notebook. If the exercise hands over the path as an argument, use that argument.",
        "ファイル {value}{value2} が見つかりません。ファイル名とフォルダを、ノートブックの説明と比べましょう。相対パスは"
        "ノートブックのあるフォルダから始まります。パスが引数で渡される課題では、その引数を使いましょう。",
    ),
    Row(
        "FileNotFoundError",
        "",
        "A file was not found: {message}. Compare its name and folder with the notebook's text.",
        "ファイルが見つかりません: {message}。ファイル名とフォルダを、ノートブックの説明と比べましょう。",
    ),
    Row(
        "PermissionError FileExistsError",
        "",
        "The file or folder may not be opened this way ({message}). Answers only read the files they are given; they need "
        'not write any. Check the path, and the "w" in open(...).',
        "このファイルやフォルダは、この方法では開けません({message})。答えは渡されたファイルを読むだけで、書き込む必要は"
        'ありません。パスと open(...) の "w" を確かめましょう。',
    ),
    Row(
        "IsADirectoryError NotADirectoryError",
        "",
        "The path leads to a folder where a file is needed, or the other way round ({message}). Add the name of the file to "
        "the path.",
        "ファイルが必要なところに、フォルダのパスが渡されているか、その逆です({message})。パスにファイル名まで含めましょう。",
    ),
    Row(
        "OSError ConnectionError ConnectionRefusedError",
        r"Name or service not known|name resolution|unreachable|[Cc]onnection|urlopen|nodename",
        "The function wants to use the network, which is not there while an answer is checked. Everything needed comes with "
        "the arguments.",
        "関数がネットワークを使おうとしていますが、チェック中は使えません。必要なものは、すべて引数で渡されます。",
    ),
    Row(
        "OSError",
        r"\S",
        "A file or device could not be used: {message}. Check the path and how the file is opened.",
        "ファイルなどを利用できません: {message}。パスと、ファイルの開き方を確かめましょう。",
    ),
    Row(
        "DeprecationWarning FutureWarning PendingDeprecationWarning",
        "",
        "A function used here is out of date, and this notebook turns such warnings into errors: {message}. Replace it as "
        'the warning says, or remove warnings.simplefilter("error").',
        "ここで使っている関数は古くなっています。このノートブックでは、警告がエラーになる設定です: {message}。"
        '警告に従って書き換えるか、warnings.simplefilter("error") を外しましょう。',
    ),
    Row(
        "RuntimeWarning UserWarning Warning SyntaxWarning ResourceWarning BytesWarning UnicodeWarning ImportWarning "
        "EncodingWarning",
        "",
        "A warning was turned into an error: {message}. In a calculation it usually means a division by zero or a root "
        'outside its range. Look at the values in this line; warnings.simplefilter("error") is what stops the program.',
        "警告がエラーになりました: {message}。計算では、0での割り算や定義域の外の平方根などが主な原因です。この行の値を"
        '確かめましょう。warnings.simplefilter("error") の設定で、警告のときに止まるようになっています。',
    ),
)

_SYNTAX = (
    Row(
        "SyntaxError IndentationError",
        r"invalid non-printable character U\+3000|invalid character '\u3000'",
        "There is a full-width space (U+3000) in the code. It looks like a blank, but Python does not accept it. Switch the "
        "Japanese input off, delete it, and type an ordinary space.",
        "コードの中に全角スペース(U+3000)があります。空白に見えますが、Pythonでは使えません。日本語入力をオフにして、"
        "半角スペースに打ち直しましょう。",
    ),
    Row(
        "SyntaxError IndentationError",
        r"invalid non-printable character (?P<code>U\+[0-9A-F]+)",
        "There is an invisible character ({code}) in the code. It usually comes along when text is copied from a slide or a "
        "web page. Delete the line and type it anew.",
        "コードの中に、目に見えない文字({code})があります。スライドやウェブページからコピーしたときによく入ります。その行を"
        "消して、打ち直しましょう。",
    ),
    Row(
        "SyntaxError",
        r"invalid character '(?P<key>.)' \(U\+(?P<code>[0-9A-F]+)\)",
        "The character {key} (U+{code}) is not allowed in code; it was typed with Japanese (full-width) input or copied "
        "from a text. Switch the input to half-width and write {found} instead.",
        "コードに使えない文字 {key} (U+{code})があります。全角で入力されたか、文章からコピーされた文字のようです。"
        "半角入力に切り替えて、{found} と書きましょう。",
        found=_half_width,
    ),
    Row(
        "SyntaxError",
        r"invalid character '(?P<key>.)' \(U\+(?P<code>[0-9A-F]+)\)",
        "The character {key} (U+{code}) is not allowed in code. Delete it and type the line with half-width characters. "
        "Texts and comments may contain any character, inside quotation marks or after a #.",
        "コードに使えない文字 {key} (U+{code})があります。消して、半角文字で打ち直しましょう。引用符の中や # "
        "の後ろ(コメント)なら、どんな文字も使えます。",
    ),
    Row(
        "TabError",
        "",
        "The indentation mixes tabs and spaces. Delete the blanks at the beginning of the lines of the function, and indent "
        "all of them with 4 spaces per level.",
        "字下げ(インデント)に、タブとスペースが混ざっています。関数の各行の先頭の空白を消し、"
        "1段につき半角スペース4つにそろえましょう。",
    ),
    Row(
        "IndentationError",
        r"unexpected indent",
        "This line is indented further than the one before, without a reason such as def, if or for. Lines of one block "
        "begin at the same column: 4 spaces per level.",
        "この行が、前の行より余分に字下げ(インデント)されています。同じブロックの行は、先頭の位置をそろえます。1段は"
        "半角スペース4つです。",
    ),
    Row(
        "IndentationError",
        r"unindent does not match",
        "The beginning of this line does not line up with any line above. Count the spaces: lines of one block begin at the "
        "same column, 4 spaces per level.",
        "この行の先頭の位置が、前のどの行ともそろっていません。空白を数えましょう。同じブロックの行は先頭をそろえ、1段は"
        "半角スペース4つです。",
    ),
    Row(
        "IndentationError",
        r"expected an indented block(?: after (?P<what>.+) on line (?P<number>\d+))?",
        "After a line that ends with a colon the next lines must be indented by 4 spaces, and at least one line of code is "
        "needed; a comment alone is not enough. Look at the line before this one.",
        "コロン(:)で終わる行の次は、半角スペース4つの字下げ(インデント)が必要です。コメントだけではなく、"
        "コードが1行以上要ります。この行とその前の行を確かめましょう。",
    ),
    Row(
        "SyntaxError",
        r"invalid syntax|expected ':'",
        "else if is written elif in Python, in one word and with a colon at the end.",
        "Pythonでは else if を1語で elif と書きます。行の終わりにはコロン(:)が必要です。",
        line=r"\belse\s+if\b",
    ),
    Row(
        "SyntaxError",
        r"expected ':'",
        "A colon (:) is missing at the end of the line: def, if, elif, else, for and while need one. Put it there, in "
        "half-width.",
        "行の終わりにコロン(:)がありません。def、if、elif、else、for、while の行には必要です。半角で付けましょう。",
    ),
    Row(
        "SyntaxError",
        r"expected '\('",
        "After def and the name of the function there must be round parentheses with the parameters: def f(x):.",
        "def と関数名の後ろには、def f(x): のように引数を入れた丸かっこが必要です。",
    ),
    Row(
        "SyntaxError",
        r"'(?P<key>[(\[{])' was never closed",
        "The bracket {key} is opened but never closed. Count the brackets in this line: each one needs its partner.",
        "かっこ {key} が閉じられていません。この行のかっこを数え、開いたかっこと閉じたかっこの数を合わせましょう。",
    ),
    Row(
        "SyntaxError",
        r"unmatched '(?P<key>[)\]}])'|closing parenthesis '(?P<key2>[)\]}])' does not match opening parenthesis "
        r"'(?P<open>[(\[{])'",
        "The bracket {key}{key2} does not match an opening one. Count the brackets in this line, and see that ( goes with ) "
        "and [ with ].",
        "かっこ {key}{key2} に対応する開きかっこがありません。この行のかっこを数え、( と )、[ と ] "
        "が組になっているか確かめましょう。",
    ),
    Row(
        "SyntaxError",
        r"unterminated (?:triple-quoted )?(?:f-)?string|EOL while scanning|EOF while scanning",
        "A text begins with a quotation mark but does not end with the same one. Put the closing ' or \" at its end; a "
        "docstring needs three of them.",
        "引用符で始まる文字列が、同じ引用符で閉じられていません。終わりに ' または \" を付けましょう。docstring では"
        "3つ必要です。",
    ),
    Row(
        "SyntaxError",
        r"Missing parentheses in call to '(?P<key>\w+)'",
        "{key} needs parentheses in Python 3: write {key}(...). Without them is the way of Python 2.",
        "Python 3では {key} にかっこが必要です。{key}(...) と書きましょう。かっこのない書き方は、昔のPython 2のものです。",
    ),
    Row(
        "SyntaxError",
        r"(?:invalid syntax\. |here\. )Maybe you meant '=='",
        "A single = assigns a value; a comparison is written with two, ==. If you want to assign, put the variable alone on "
        "the left and the formula on the right.",
        "1つの = は代入です。比較するときは == と2つ書きます。代入のつもりなら、左側に変数だけ、右側に式を書きましょう。",
    ),
    Row(
        "SyntaxError",
        r"cannot assign to|illegal expression for augmented assignment|cannot delete",
        "What stands left of the = cannot be given a value. Put a variable alone on the left and the formula on the right; "
        "a comparison is written ==.",
        "= の左側にあるものには代入できません。左側に変数だけ、右側に式を書きましょう。比較なら == と書きます。",
    ),
    Row(
        "SyntaxError",
        r"forgot a comma",
        "Between two values something is missing: a comma between elements, or a * for a multiplication. Look inside the "
        "brackets of this line.",
        "2つの値の間に、何かが抜けています。要素を区切るコンマ(,)か、掛け算の * を確かめましょう。この行のかっこの中を"
        "見てください。",
    ),
    Row(
        "SyntaxError",
        r"leading zeros",
        "A whole number may not begin with 0. Write 12 instead of 012.",
        "整数を 0 で始めることはできません。012 ではなく 12 と書きましょう。",
    ),
    Row(
        "SyntaxError",
        r"invalid (?:decimal|hexadecimal|imaginary|octal|binary) literal|invalid digit",
        "A number is followed directly by a letter, such as 2x. For a multiplication write the *: 2 * x. Names of variables "
        "may not begin with a digit.",
        "2x のように、数字のすぐ後ろに文字があります。掛け算なら 2 * x と * を書きましょう。変数名を数字で始めることは"
        "できません。",
    ),
    Row(
        "SyntaxError",
        r"f-string",
        "The curly brackets in an f-string are not in order: each one needs its partner, with a name or a formula between them.",
        "f文字列の波かっこが正しくありません。開きと閉じを組にし、その間に変数名や式を書きましょう。",
    ),
    Row(
        "SyntaxError",
        r"'(?P<key>return|break|continue|yield|await)' outside|'(?P<key2>continue)' not properly in loop",
        "{key}{key2} stands outside the function or loop it belongs to. Probably the line is not indented far enough: put "
        "it at the same column as the rest of the block.",
        "{key}{key2} が、関数やループの外にあります。字下げ(インデント)が足りないようです。ブロックのほかの行と、"
        "先頭の位置をそろえましょう。",
    ),
    Row(
        "SyntaxError",
        r"positional argument follows keyword|non-default argument follows|parameter without a default follows|duplicate "
        r"argument|is parameter and (?:global|nonlocal)",
        "The parameters in the parentheses are not in order ({message}): each has its own name, and those with = come last. "
        "Compare the def line with the original of the exercise.",
        "かっこの中の引数の書き方が正しくありません({message})。引数の名前は重複できず、= の付いたものは後ろに書きます。def "
        "の行を、課題の元の形と比べましょう。",
    ),
    Row(
        "SyntaxError",
        r"unexpected character after line continuation",
        "After a backslash \\ nothing may follow on the line. Perhaps a division / was meant.",
        "バックスラッシュ(\\ または ¥)の後ろには、何も書けません。割り算の / のつもりではありませんか。",
    ),
    Row(
        "SyntaxError",
        r"expected 'except' or 'finally'",
        "A try: needs an except: below it, at the same column. For the exercises no try is needed.",
        "try: には、同じ位置から始まる except: が必要です。課題を解くのに try は必要ありません。",
    ),
    Row(
        "SyntaxError",
        r"expected 'else' after 'if' expression",
        "An if inside a formula needs an else: a if condition else b.",
        "式の中の if には else が必要です。a if 条件 else b の形で書きましょう。",
    ),
    Row(
        "SyntaxError",
        "invalid syntax",
        "Python has no ++ or --. Write x += 1 or x -= 1.",
        "Pythonに ++ や -- はありません。x += 1 や x -= 1 と書きましょう。",
        line=r"\w(?:\+\+|--)\s*;?$",
    ),
    Row(
        "SyntaxError",
        "invalid syntax",
        "A comparison is written in the wrong way. Python knows ==, !=, <, >, <= and >=, in this order of characters; "
        "conditions are joined with and, or, not.",
        "比較や条件の書き方が違います。比較は ==、!=、<、>、<=、>= とこの順番で書き、条件は and、or、not でつなぎます。",
        line=r"=[<>!]|===|!==|&&|\|\||<>|=\s+=",
    ),
    Row(
        "SyntaxError",
        "invalid syntax",
        "An else, elif or except stands here without its if or try. It must begin at the same column as the if, with "
        "nothing less indented between them.",
        "対応する if や try のない else、elif、except があります。if と同じ位置から書き始め、間に字下げの浅い行を"
        "入れないようにしましょう。",
        line=r"^\s*(?:else|elif|except|finally)\b",
    ),
    Row(
        "SyntaxError",
        "invalid syntax",
        "A word at the beginning of the line is misspelt. Python's words are written in small letters: def, return, if, "
        "elif, else, for, while, import.",
        "行の最初の単語のつづりが違います。Pythonの単語は、def、return、if、elif、else、for、while、import "
        "のようにすべて小文字で書きます。",
        line=rf"^\s*(?:{'|'.join(_MISSPELT_KEYWORDS)})\b",
    ),
    Row(
        "SyntaxError",
        "invalid syntax",
        "A word of the Python language is used as a name of a variable. Choose another one, for example lam instead of lambda.",
        "Pythonの予約語を変数名に使っています。lambda の代わりに lam とするなど、別の名前にしましょう。",
        line=r"^\s*(?:lambda|class|def|is|in|from|import|global|return|with|as|pass|del|try|async|await|yield|and|or|not|if|for|while)\s*=",
    ),
    Row(
        "SyntaxError",
        r"null bytes",
        "The cell contains characters that do not belong in code (null bytes). Make a new cell and type the code there.",
        "セルに、コードに使えない文字(ヌル文字)が入っています。新しいセルを作り、コードを打ち直しましょう。",
    ),
    Row(
        "SyntaxError IndentationError TabError",
        "",
        "Python cannot read this line ({message}). Look for a missing operator, comma, colon or bracket, here or at the end "
        "of the line before.",
        "この行をPythonが読み取れません({message})。演算子、コンマ、コロン、かっこが抜けていないか、この行と前の行の終わりを"
        "確かめましょう。",
    ),
)

# the first row that fits is told, so what is special stands before what is general
ROWS = (
    *_NAMES,
    *_CALLS,
    *_OPERATORS,
    *_NUMBERS_WANTED,
    *_VALUES,
    *_INDICES,
    *_ARITHMETIC,
    *_ATTRIBUTE_ERRORS,
    *_OTHERS,
    *_SYNTAX,
)

MISSING = {
    "undefined": Text(
        "{name} is not defined yet. Either its cell has not been run since the notebook was opened, or the name is spelt "
        "differently. Run the cell that defines {name}, then check again.",
        "{name} がまだ定義されていません。ノートブックを開いてからそのセルを実行していないか、名前のつづりが違うようです。"
        "{name} を定義するセルを実行してから、もう一度チェックしましょう。",
    ),
    "similar": Text(
        "{name} is not defined, but there is a similar name, {where}. The name must be exactly {name}; capital and small "
        "letters count. Correct it, run the cell, then check again.",
        "{name} は定義されていませんが、似た名前の {where} があります。名前は {name} "
        "とぴったり同じでなければなりません(大文字と小文字も区別されます)。直してセルを実行し、もう一度チェックしましょう。",
    ),
    "nested": Text(
        "{name} is defined inside {where}, so it cannot be seen from outside. Its def line is indented too far: move it, "
        "with its whole body, to the beginning of the line, and run the cell again.",
        "{name} が {where} の中で定義されているので、外からは見えません。def の行の字下げ(インデント)が深すぎます。"
        "関数全体を行の先頭まで戻し、セルを実行し直しましょう。",
    ),
    "syntax": Text(
        "Python cannot read the cell that defines {name}, so nothing in it was run.",
        "{name} を定義するセルに文法の誤りがあり、セルが実行されていません。",
    ),
    "failed": Text(
        "The cell that defines {name} stopped with an error, so {name} has no value.",
        "{name} を定義するセルがエラーで止まったため、{name} がまだありません。",
    ),
}

MISMATCH = Text(
    "{name} cannot be called the way the exercise does it: with {given}, {name}({parameters}). Yours takes {own}. Write the "
    "def line as it was in the exercise, run the cell, then check again.",
    "{name} を課題どおりに呼び出せません。課題では {name}({parameters}) と{given}を渡しますが、あなたの関数の引数は {own} "
    "です。def の行を課題の元の形に戻し、セルを実行してからもう一度チェックしましょう。",
)

KIND = Text(
    "{name} holds {kind} where a function is asked for. Probably a line such as {name} = {name}(...) put a result in its "
    "place. Give the result another name, run the cell with def {name} again, then check.",
    "{name} が関数ではなく{kind}になっています。{name} = {name}(...) のように、計算結果を同じ名前に代入したようです。"
    "結果には別の名前を付け、def {name} のセルを実行し直してからチェックしましょう。",
)
KINDS = {
    "NoneType": Text(
        "{name} is None (nothing) where a function is asked for. Perhaps a line such as {name} = print(...) or {name} = "
        "{name}(...) replaced it. Give the result another name, run the cell with def {name} again, then check.",
        "{name} が関数ではなく None(値なし)になっています。{name} = print(...) や {name} = {name}(...) "
        "のような行で上書きしたようです。結果には別の名前を付け、def {name} のセルを実行し直してからチェックしましょう。",
    ),
    "module": Text(
        "{name} is a module where a function is asked for: an import has given the name {name} to it. Import the module "
        "under another name, run the cell with def {name} again, then check.",
        "{name} が関数ではなくモジュールになっています。import によって {name} という名前が使われたようです。別の名前で "
        "import し、def {name} のセルを実行し直してからチェックしましょう。",
    ),
    "axes": Text(
        "{name} is the Axes of a graph where a function is asked for. Give the graph another name, such as ax, run the cell "
        "with def {name} again, then check.",
        "{name} が関数ではなくグラフのAxesになっています。グラフには ax など別の名前を付け、def {name} のセルを"
        "実行し直してからチェックしましょう。",
    ),
    "str": Text(
        "{name} holds a text (str) where a function is asked for. Are there quotation marks around the code, or was {name} "
        "assigned a text? Define it with def {name}(...):, run the cell, then check again.",
        "{name} が関数ではなく文字列(str)になっています。コードを引用符で囲んだか、{name} に文字列を代入していませんか。def "
        "{name}(...): で定義してセルを実行し、もう一度チェックしましょう。",
    ),
}

NOT_AX = Text(
    "{name} holds {kind}, but the Axes of a graph is asked for. Make the graph with fig, ax = plt.subplots(), draw with "
    "ax.plot(...), and end with {name} = ax.",
    "{name} が{kind}になっていますが、必要なのはグラフのAxesです。fig, ax = plt.subplots() でグラフを作り、ax.plot(...) "
    "で描き、最後に {name} = ax としましょう。",
)
NOT_AXES = {
    "Figure": Text(
        "{name} holds the Figure, the whole page, but the Axes, the frame of the graph, is asked for. In fig, ax = "
        "plt.subplots() it is the second one: write {name} = ax.",
        "{name} が図全体(Figure)になっていますが、必要なのはグラフの枠(Axes)です。fig, ax = plt.subplots() "
        "の2番目のほうなので、{name} = ax としましょう。",
    ),
    "list": Text(
        "{name} holds a list, probably the lines that plot(...) returns, but the Axes of the graph is asked for. Do not "
        "assign the result of plot; write {name} = ax, or {name} = plt.gca() in the same cell.",
        "{name} がリストになっています。plot(...) が返す線のリストのようですが、必要なのはグラフのAxesです。plot の結果は"
        "代入せず、{name} = ax、または同じセルの中で {name} = plt.gca() としましょう。",
    ),
    "ndarray": Text(
        "{name} holds an array, probably the several Axes that plt.subplots(2, 2) makes, but a single Axes is asked for. "
        "Pick one with its index, for example axes[0, 0], or use plt.subplots() for one graph.",
        "{name} が配列になっています。plt.subplots(2, 2) が作る複数のAxesのようですが、必要なのは1つのAxesです。axes[0, 0] "
        "のように1つ選ぶか、グラフ1つなら plt.subplots() を使いましょう。",
    ),
    "tuple": Text(
        "{name} holds a pair, probably the Figure and the Axes that plt.subplots() returns together. Take them apart with "
        "fig, ax = plt.subplots(), and write {name} = ax.",
        "{name} が組(タプル)になっています。plt.subplots() が返すFigureとAxesの組のようです。fig, ax = plt.subplots() "
        "と2つに分け、{name} = ax としましょう。",
    ),
    "function": Text(
        "{name} is a function, but the Axes of a graph is asked for. If your function draws and returns the Axes, call it: "
        "{name} = draw(...), with another name for the function.",
        "{name} が関数になっていますが、必要なのはグラフのAxesです。描画してAxesを返す関数なら、関数には別の名前を付け、"
        "{name} = draw(...) のように呼び出した結果を代入しましょう。",
    ),
    "NoneType": Text(
        "{name} is None (nothing), but the Axes of a graph is asked for. plt.show() and similar functions return nothing. "
        "Write {name} = ax, with ax from fig, ax = plt.subplots().",
        "{name} が None(値なし)になっていますが、必要なのはグラフのAxesです。plt.show() などは何も返しません。fig, ax = "
        "plt.subplots() の ax を使い、{name} = ax としましょう。",
    ),
    "Line2D": Text(
        "{name} holds one line of the graph, but the Axes, the frame around it, is asked for. Write {name} = ax, with ax "
        "from fig, ax = plt.subplots().",
        "{name} がグラフの線1本になっていますが、必要なのはグラフの枠(Axes)です。fig, ax = plt.subplots() の ax を使い、"
        "{name} = ax としましょう。",
    ),
    "module": Text(
        "{name} is a module (perhaps plt), but the Axes of a graph is asked for. Write {name} = ax, with ax from fig, ax = "
        "plt.subplots(), or {name} = plt.gca() in the same cell.",
        "{name} がモジュール(plt など)になっていますが、必要なのはグラフのAxesです。fig, ax = plt.subplots() の ax を使って "
        "{name} = ax とするか、同じセルで {name} = plt.gca() としましょう。",
    ),
}

ODD = {
    "masked": Text(
        "Your function returns a masked array, in which some elements are hidden. Return an ordinary array: choose values "
        "with np.where, or fill the gaps with a.filled(...).",
        "戻り値がマスク付き配列(一部の要素が隠された配列)です。np.where で値を選ぶか、a.filled(...) で埋めて、ふつうの配列を"
        "返しましょう。",
    ),
    "array_subclass": Text(
        "Your function returns a special kind of array, {type_name}, that calculates by rules of its own. Return an "
        "ordinary one: np.asarray(a).",
        "戻り値が {type_name} という特殊な配列で、計算の規則がふつうの配列と異なります。np.asarray(a) "
        "でふつうの配列にして返しましょう。",
    ),
    "object_array": Text(
        "Your function returns an array that holds Python objects (dtype object) instead of numbers. Lists of unequal "
        "length, None or symbols make such arrays. Print it, and build it with dtype=float.",
        "戻り値が、数値ではなくPythonのオブジェクトの入った配列(dtype が object)です。長さの違うリスト、None、"
        "記号などが混ざるとこうなります。print して確かめ、dtype=float で作りましょう。",
    ),
    "array_of": Text(
        "Your function returns an array of type {type_name}, not of numbers. Text in one element turns the whole array into "
        "text. Look for quotation marks, and build it with dtype=float.",
        "戻り値が、数値ではなく {type_name} 型の配列です。要素に1つでも文字列があると、配列全体が文字列になります。引用符を"
        "確かめ、dtype=float で作りましょう。",
    ),
    "complex": Text(
        "Your function returns complex numbers where real ones are asked for. A root or a broken power of a negative number "
        "does that. Look where a number under a root becomes negative.",
        "実数を返すところで、複素数が返っています。負の数の平方根や小数乗は複素数になります。"
        "根号の中が負になっていないか調べましょう。",
    ),
    "iterator": Text(
        "Your function returns {kind}, which has not been calculated yet. Return the values themselves: np.array(list(...)).",
        "戻り値が{kind}で、まだ計算された値になっていません。np.array(list(...)) で値にしてから返しましょう。",
    ),
    "function": Text(
        "Your function returns a function instead of its value. Probably parentheses are missing in the last line: return "
        "f(x), not return f.",
        "計算結果ではなく、関数そのものが返っています。return f ではなく return f(x) のように、最後の行でかっこを"
        "付けて呼び出しましょう。",
    ),
    "class": Text(
        "Your function returns a class (a type) instead of a value. Probably parentheses are missing in the last line: "
        "return float(x), not return float.",
        "値ではなく、クラス(型)そのものが返っています。return float ではなく return float(x) のように、最後の行でかっこを"
        "付けましょう。",
    ),
    "symbols": Text(
        "The result still contains symbols that are not arguments of the function: {type_name}. Use the parameters of the "
        "def line in the formula, not new symbols of the same name.",
        "結果に、引数ではない記号が残っています: {type_name}。式の中では新しく作った記号ではなく、def の行の引数を使いましょう。",
    ),
    "symbolic": Text(
        "The result is a formula ({type_name}) that does not become a real number when the values are put in. Look for an "
        "integral or derivative that was not carried out (.doit()), a division by zero, or a root of a negative number.",
        "数値を代入しても、結果が実数にならない式({type_name})です。実行されていない積分や微分(.doit())、0での割り算、"
        "負の数の平方根がないか調べましょう。",
    ),
    "dict_keys": Text(
        "Your function returns a dictionary whose keys are not all texts. Use texts in quotation marks as keys, or return "
        "the numbers themselves if the exercise asks for no dictionary.",
        "戻り値の辞書に、文字列でないキーがあります。キーは引用符付きの文字列にしましょう。辞書を求めていない課題なら、"
        "数値をそのまま返します。",
    ),
    "dict": Text(
        "Your function returns a dictionary where numbers are asked for. Return the values themselves, in the order given "
        "in the docstring.",
        "数値を返すところで、辞書が返っています。docstring にある順番で、値をそのまま返しましょう。",
    ),
    "text": Text(
        'Your function returns text where numbers are asked for. Remove the quotation marks, the f"..." or the str(...) '
        "in the last line.",
        '数値を返すところで、文字列が返っています。最後の行の引用符や f"..."、str(...) を外しましょう。',
    ),
    "none": Text(
        "A part of what your function returns is None (nothing). Perhaps the result of print() or of a function without "
        "return was put in. Print each part before the return.",
        "戻り値の一部が None(値なし)です。print() や return のない関数の結果が入っているようです。return の前で、"
        "それぞれの値を print して確かめましょう。",
    ),
    "too_big": Text(
        "Your function returns far more numbers than are asked for. Perhaps an array grows in a loop, or two axes were "
        "multiplied with each other. Print its .shape before the return.",
        "戻り値の要素が多すぎます。ループの中で配列が増え続けているか、意図しない軸の組み合わせになっているようです。return "
        "の前で .shape を print しましょう。",
    ),
    "too_deep": Text(
        "Your function returns lists inside lists, far too deep. Perhaps a list was appended to itself. Print what you "
        "return, and build a plain array.",
        "戻り値のリストが、何重にも入れ子になっています。リストを自分自身に append していませんか。戻り値を print "
        "して確かめ、ふつうの配列にしましょう。",
    ),
    "other": Text(
        "Your function returns {kind} where numbers are asked for. Look at the return line: which numbers does the "
        "docstring ask for?",
        "数値を返すところで、{kind}が返っています。return の行を見て、docstring で求められている数値を返しましょう。",
    ),
}
_SET = Text(
    "Your function returns a set, which has no order and drops equal values. Curly brackets make a set: use square ones [ ] "
    "or np.array([...]).",
    "戻り値が集合(set)です。集合には順番がなく、同じ値は1つにまとめられます。波かっこではなく、角かっこ [ ] や "
    "np.array([...]) を使いましょう。",
)
_PICTURE = Text(
    "Your function returns a graph where numbers are asked for. Draw in another cell, and return the calculated values.",
    "数値を返すところで、グラフが返っています。描画は別のセルで行い、計算した値を返しましょう。",
)
ODD_TYPES = {
    ("other", "set"): _SET,
    ("other", "frozenset"): _SET,
    ("other", "Axes"): _PICTURE,
    ("other", "Figure"): _PICTURE,
    ("other", "Line2D"): _PICTURE,
    ("other", "range"): Text(
        "Your function returns a range, which is not an array. Use np.arange(...) or list(range(...)).",
        "戻り値が range のままで、配列になっていません。np.arange(...) や list(range(...)) を使いましょう。",
    ),
    ("other", "module"): Text(
        "Your function returns a module. The part after the dot is missing, as in math.pi, or a variable has the name of a "
        "module.",
        "戻り値がモジュールです。math.pi のようなドットの後ろが抜けているか、変数とモジュールが同じ名前になっています。",
    ),
    ("other", "ellipsis"): Text(
        "Your function returns ... (three dots), which only hold a place. Replace them with your own code.",
        "戻り値が ... (3つのドット)のままです。これは仮の印なので、自分のコードに置き換えましょう。",
    ),
    ("array_subclass", "matrix"): Text(
        "Your function returns a np.matrix, whose * and shapes differ from those of arrays; NumPy advises against it. Use "
        "np.array and @ for products of matrices.",
        "戻り値が np.matrix です。* の意味や形状が配列と異なり、NumPyでも推奨されていません。np.array を使い、行列の積は @ "
        "で書きましょう。",
    ),
}

PRINTED = Text(
    "Your function returns None (nothing), but it printed: {printed}. print only shows a value; the caller cannot use it. "
    "End the function with return and the value.",
    "関数の戻り値が None(値なし)ですが、次のように表示されました: {printed}。print は値を画面に出すだけで、呼び出した側には"
    "渡りません。関数の最後で、値を return しましょう。",
)
NO_RETURN = Text(
    "Your function returns None (nothing). Either the return line is missing, or it is reached only in one branch of an if "
    "or is indented too far. See that every path through the function ends with return and a value.",
    "関数の戻り値が None(値なし)です。return の行がないか、if の片方やループの中だけにあるようです(字下げも確かめましょう)。"
    "どの道筋を通っても、最後に値を return するようにしましょう。",
)

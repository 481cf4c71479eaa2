"""Every message is proved on the error that Python and its libraries really raise."""

import linecache
import math
import re
import string
import textwrap
from typing import Any

import matplotlib as mpl
import matplotlib.pyplot as plt
import numpy as np
import pytest
import scipy
import sympy as sp
from hypothesis import given, settings
from hypothesis import strategies as st

from course import explanations
from course.answers import Missing, Question, TimeUp, Trouble, find, interview, reply_to
from course.explaining import (
    MAX_SHOWN,
    explained_kind,
    explained_mismatch,
    explained_missing,
    explained_none,
    explained_not_axes,
    explained_odd,
    explained_trouble,
    shown,
)
from course.explanations import ROWS
from course.language import Text
from course.plain import Odd, plain

mpl.use("Agg")

LISTED = [1.0, 2.0, 3.0]
JAPANESE = re.compile("[\u3040-\u30ff\u4e00-\u9fff]")


def namespace() -> dict[str, Any]:
    return {
        **{"np": np, "math": math, "sp": sp, "plt": plt, "scipy": scipy, "TimeUp": TimeUp},
        **{"a": np.arange(3.0), "b": np.ones(2), "M": np.ones((2, 3)), "n": np.arange(3), "values": list(LISTED)},
        **{"x": 2.0, "k": 3, "nothing": None, "text": "1.5m", "pair": (1, 2), "d": {"x": 1.0}, "s": sp.Symbol("s")},
        "frozen": np.broadcast_to(np.arange(3.0), (2, 3)),
    }


def trouble_of(code: str) -> Trouble:
    """Return the trouble in which a student's function with these lines ends."""
    source = "def answer(a=a, n=n, values=values, frozen=frozen):\n" + textwrap.indent(code, "    ") + "\n"
    file = f"<cell {code}>"
    linecache.cache[file] = (len(source), None, source.splitlines(keepends=True), file)
    names = {"__name__": "__main__", **namespace()}
    exec(compile(source, file, "exec"), names)
    trouble = reply_to(names["answer"], Question(())).trouble
    assert trouble is not None, f"{code} raises nothing"
    return trouble


def assert_says(text: Text, english: str, japanese: str) -> None:
    assert english in text.en
    assert japanese in text.ja
    assert JAPANESE.search(text.ja)
    for told in text:
        assert "Traceback" not in told
        assert "site-packages" not in told
        assert told == told.strip()
    assert len(text.en.split()) < 110
    assert len(text.ja) < 420


RAISED = [
    # not written yet, names and imports
    ("raise NotImplementedError()", "answer is not written yet", "answer はまだ書かれていません"),
    ("raise NotImplementedError", "Replace that line with your own code", "自分のコードに置き換え"),
    ("def step():\n    raise NotImplementedError()\nreturn step()", "answer calls step, and step is not written", "step がまだ"),
    ("raise NotImplementedError('for odd orders')", "for odd orders", "NotImplementedError で止まりました"),
    ("return numpy.cos(1)", "Write import numpy at the top", "import numpy と書いて"),
    ("return os.sep", "Write import os at the top", "先頭に import os と書いて"),
    ("return sympy.cos(1)", "import is missing", "import していない"),
    ("return re.sub", "Write import re at the top", "import re と書いて"),
    ("return cos(1)", "Write np.cos", "np.cos と書き"),
    ("return atan2(1, 1)", "Write math.atan2", "math.atan2 と書き"),
    ("return π * 2", "Write np.pi", "np.pi と書き"),
    ("return true", "usual spelling is True", "正しい書き方は True"),
    ("return Math.pi", "usual spelling is math", "正しい書き方は math"),
    ("return bb", "The name bb is not defined", "bb という名前は定義されていません"),
    ("return roll", "The name roll is not defined", "roll という名前は定義されていません"),
    ("f = lambda: later\nf()\nlater = 1", "uses later before it has a value", "まだ値のない later"),
    ("total = total + 1", "total is used before it has a value", "変数 total に値が入る前"),
    ("import nmpy", "is numpy meant", "numpy の打ち間違い"),
    ("import cv2_missing", "The module cv2_missing is not there", "cv2_missing というモジュールが見つかりません"),
    ("import numpy.cos", "Perhaps cos is a function", "cos が関数なら"),
    ("from scipy.integrate import cumtrapz", "Use scipy.integrate.cumulative_trapezoid", "cumulative_trapezoid を使い"),
    ("from scipy.integrate import simps", "Use scipy.integrate.simpson", "scipy.integrate.simpson を使い"),
    ("from scipy import cos", "Use np.cos instead", "np.cos を使いましょう"),
    ("from numpy import trapz", "Use np.trapezoid instead", "np.trapezoid を使いましょう"),
    ("from math import arctan2", "Use math.atan2 instead", "math.atan2 を使いましょう"),
    ("from math import squrt", "is sqrt meant", "sqrt の打ち間違い"),
    ("from math import nonsense", "math has no nonsense", "math に nonsense はありません"),
    ("from .course import x", "An import failed", "import に失敗しました"),
    # calls
    ("f = lambda p, q: p\nreturn f(1)", "without a value for q", "引数 q の値がありません"),
    ("def f(p, q): return p\nreturn f()", "without a value for p, q", "引数 p, q の値がありません"),
    ("return np.zeros()", "without a value for shape", "引数 shape の値がありません"),
    ("return np.array(1, 2, 3)", "values one by one", "値がばらばらに"),
    ("return np.zeros(2, 3)", "second argument for the data type", "2番目の引数をデータ型"),
    ("return np.array([1, 2], [3, 4])", "second argument for the data type", "2番目の引数をデータ型"),
    ("return np.zeros(3, 'flot')", "no data type (dtype) called flot", "flot というデータ型"),
    ("return np.arctan(1, 2)", "one argument too many", "引数が1つ多い"),
    ("def f(p, q): return p\nreturn f(1, 2, 3)", "f() takes 2, but the call gives 3", "受け取るのは2個ですが、3個"),
    ("return math.cos(1, 2)", "math.cos() takes 1, but the call gives 2", "受け取るのは1個ですが、2個"),
    ("return np.cos(1, 2, 3, 4)", "cos() takes 1 to 2, but", "1〜2個ですが、4個"),
    ("return sum()", "sum() takes at least 1, but the call gives 0", "1個以上ですが、0個"),
    ("return object(1)", "arguments that do not fit: object() takes no arguments", "渡した引数が合いません"),
    ("return math.atan2(1)", "atan2() takes 2, but the call gives 1", "受け取るのは2個ですが、1個"),
    ("return int(1, 2, 3)", "takes at most 2, but the call gives 3", "2個以下ですが、3個"),
    ("return range()", "range() takes at least 1, but", "range() が受け取るのは1個以上"),
    ("return math.cos(x=1)", "takes no keyword arguments", "渡した引数が合いません"),
    ("def f(p): return p\nreturn f(1, gain=2)", "no parameter called gain", "gain という引数はありません"),
    ("return plt.plot(values, colour='r')", "no parameter called colour", "colour という引数はありません"),
    ("return max(1, 2, axis=0)", "max() has no parameter called axis", "axis という引数はありません"),
    ("def f(p, q): return p\nreturn f(1, 2, p=3)", "received p twice", "位置と名前の両方"),
    ("return math(x)", "A module is called", "モジュールを関数のように"),
    ("return nothing(x)", "Parentheses follow something that is None", "None(値なし)の後ろに丸かっこ"),
    ("return plt.figure().gca().title('t')", "ax.set_title", "ax.set_title"),
    ("return x(k + 1)", "For a multiplication write the *", "掛け算なら"),
    ("return k(x)", "a number (int), so Python tries to call it", "整数(int)の後ろに丸かっこ"),
    ("return np.float64(2)(x)", "a number (float64)", "数値(float64)の後ろ"),
    ("return s(x)", "Parentheses follow a SymPy symbol", "SymPyの記号の後ろに丸かっこ"),
    ("return a(0)", "Parentheses follow an array", "配列(ndarray)の後ろに丸かっこ"),
    ("return values(0)", "Parentheses follow a list", "リスト(list)の後ろに丸かっこ"),
    ("class Robot: pass\nreturn Robot()(1)", "a value of type Robot, which is not a function", "Robot型の値の後ろ"),
    ("return nothing[0]", "Square brackets follow something that is None", "None(値なし)に角かっこ"),
    ("return math.cos[0]", "Square brackets follow a function", "関数に角かっこ"),
    ("return np.cos[0]", "Square brackets follow a function", "関数に角かっこ"),
    ("return np.sum[0]", "Square brackets follow a function", "関数に角かっこ"),
    ("return x[0]", "Square brackets follow a single number", "1個の数値に角かっこ"),
    ("return np.float64(2)[0]", "Square brackets follow a single number", "添字が1つ多い"),
    ("return zip(values)[0]", "Turn it into a list", "先に list(...) でリスト"),
    ("return len(map(abs, values))", "Turn it into a list", "先に list(...) でリスト"),
    ("return s[0]", "Square brackets follow a SymPy symbol", "SymPyの記号に角かっこ"),
    ("p, q = nothing", "only None (nothing)", "複数の値が必要なところに None"),
    ("for v in nothing: pass", "only None (nothing)", "複数の値が必要なところに None"),
    ("p, q = math.cos", "a function that has not been called", "呼び出していない関数"),
    ("p, q = x", "Several names stand left of the =", "= の左側に変数が複数"),
    ("for i in k: pass", "for i in range(n)", "for i in range(n)"),
    ("values += 2", "use append", "append"),
    ("return sum(x)", "needs a list or an array here", "リストや配列が必要"),
    ("return x in k", "needs a list or an array here", "for 文や"),
    ("for v in np.array(1.0): pass", "needs a list or an array here", "リストや配列が必要"),
    ("return len(x)", "len() was asked", "len() を使っています"),
    ("return len(np.array(1.0))", "len() was asked", "len() を使っています"),
    # operators
    ("return values * 0.1", "np.asarray(values, dtype=float)", "「くり返し」"),
    ("return 2.0 * values", "means repetition", "np.asarray(values, dtype=float)"),
    ("return text + 1", "turn the text into a number", "文字列に整数(int)を + で"),
    ("return values + 0.1", "a number (float) is added to a list", "リスト(list)に数値(float)を + で"),
    ("return pair + values", "a list is added to a tuple", "タプル(tuple)にリスト(list)を"),
    ("return x ^ 2", "Write ** for powers", "べき乗は x ** 2"),
    ("return a ^ n", "Write ** for powers", "べき乗は x ** 2"),
    ("return x & 1", "each comparison needs its own parentheses", "比較をそれぞれかっこで"),
    ("return a & n", "each comparison needs its own parentheses", "比較をそれぞれかっこで"),
    ("return nothing + x", "One side of the + is None", "+ の片側が None"),
    ("return a * nothing", "One side of the * is None", "* の片側が None"),
    ("return x - text", "text on one side", "片側が文字列"),
    ("return 2 * math.cos", "One side of the * is a function", "呼び出していない関数"),
    ("return math * 2", "One side of the * is a module", "片側がモジュール"),
    ("return values - values", "a list and a list", "リスト(list)とリスト(list)"),
    ("return x / values", "Python's lists and tuples do not calculate", "リストやタプルでは計算できません"),
    ("return 2 ** values", "The ** has", "** の両側が"),
    ("return zip(values) + 1", "generator, map or zip", "ジェネレータ・map・zip"),
    ("return d * 2", "is a dictionary", "片側が辞書"),
    ("return k @ k", "@ cannot be used between", "@ は使えません"),
    ("return -values", "- was applied to a list", "- がリスト(list)に"),
    ("return abs(values)", "abs() was applied to a list", "abs() がリスト(list)に"),
    ("return abs(text)", "abs() was applied to text", "abs() が文字列(str)に"),
    ("return nothing < x", "One side of the comparison < is None", "比較 < の片側が None"),
    ("return 1j < x", "Complex numbers cannot be compared", "複素数は < で比較できません"),
    ("return values > x", "you cannot compare a list and a number", "リスト(list)と数値(float)は > で比較できません"),
    ("return a + text", "contains text instead of numbers", "数値ではなく文字列"),
    ("return np.sum(['p', 'q'])", "contains text instead of numbers", "数値ではなく文字列"),
    ("n += 0.5", "Results of type float64 do not fit into an array of type int64", "int64 型の配列に入れよう"),
    ("n /= 2", "Create the array with dtype=float", "最初から実数の配列"),
    ("return a[np.bincount(a)]", "An array of type float64 was given where one of type int64", "float64 型の配列が渡され"),
    ("return (a > 1) - (a > 2)", "True/False values", "真偽値(True/False)"),
    ("return -(a > 1)", "True/False values", "真偽値(True/False)"),
    # a number is wanted
    ("return math.cos(a)", "np.cos instead of math.cos", "math.cos ではなく np.cos"),
    ("return float(a)", "one single number is needed", "数値1個が必要"),
    ("return math.cos(values)", "A whole list or array stands", "リストや配列があります"),
    ("return float(values)", "A whole list or array stands", "リストや配列があります"),
    ("return round(a)", "A whole list or array stands", "リストや配列があります"),
    ("return range(values)", "A whole list or array stands", "リストや配列があります"),
    ("return math.cos(nothing)", "None (nothing) stands where a number", "数値が必要なところに None"),
    ("return np.cos(nothing)", "None (nothing) stands where a number", "数値が必要なところに None"),
    ("return math.cos(math.sin)", "A function that has not been called", "呼び出していない関数"),
    ("return np.cos(math.sin)", "A function that has not been called", "呼び出していない関数"),
    ("return math.cos((-1) ** 0.5)", "A complex number stands", "実数が必要なところに複素数"),
    ("return float(sp.I)", "A complex number stands", "実数が必要なところに複素数"),
    ("return math.cos(text)", "Text stands where a number", "数値が必要なところに文字列"),
    ("return np.cos(np.array([1, 2], dtype=object))", "array of dtype object", "dtype が object"),
    ("return np.cos(s)", "NumPy's cos was given a SymPy symbol", "NumPyの cos にSymPyの記号"),
    ("return np.cos(sp.Float(2))", "sp.cos(theta) instead of np.cos", "sp.cos(theta)"),
    ("return np.sin(2 * s)", "NumPy's sin was given", "NumPyの sin に"),
    ("return np.cos(np.array([s, 1]))", "NumPy's cos was given", "NumPyの cos に"),
    ("return np.arctan2(s, 1)", "NumPy's arctan2 was given", "NumPyの arctan2 に"),
    ("return math.cos(s)", "sp.cos instead of math.cos", "math.cos ではなく sp.cos"),
    ("a[0] = s", "do not put symbols into arrays", "数値の配列に記号を入れない"),
    ("return 1 if s > 0 else 2", "given a SymPy symbol", "SymPyの記号を if"),
    ("return sp.cos(values)", "SymPy function was given a list or an array", "SymPyの関数にリストや配列"),
    ("return sp.cos(a)", "SymPy function was given a list or an array", "SymPyの関数にリストや配列"),
    ("return np.cos(text)", "np.cos got something that is not a number", "np.cos に数値以外"),
    ("return math.cos(d)", "There is a dictionary (dict) where a number", "数値が必要なところに辞書(dict)"),
    ("return values[n]", "np.asarray(values)", "リストに配列の添字は使えない"),
    ("return np.concatenate(a, b)", "in one list, in square brackets", "角かっこでまとめて"),
    ("return range(k / 2)", "Use // for whole division", "整数の割り算 //"),
    ("return np.zeros(2.5)", "Use // for whole division", "整数の割り算 //"),
    ("return values[0, 1]", "Write a[i][j]", "a[i][j] と書く"),
    ("return values['x']", "quotation marks stands behind something that is not a dictionary", "引用符付きの添字"),
    ("return text['x']", "is it the dictionary that you expect", "思ったとおりの辞書"),
    ("return values[k / 2]", "not a whole number", "添字が整数ではありません"),
    ("return a[0:1.5]", "not a whole number", "添字が整数ではありません"),
    ("return {values: 1}", "cannot be a list", "リスト(list)は辞書のキー"),
    ("pair[0] = 2", "An element of a tuple", "タプル(tuple)の要素を書き換え"),
    ("np.float64(2)[0] = 1", "to be put into a number (float64)", "数値(float64)に [ ] で値を"),
    ("return f'{a:.2f}'", "a format such as :.2f", ":.2f のような書式"),
    ("return f'{x:d}'", "a format such as :.2f", ":.2f のような書式"),
    ("raise 'wrong'", "raise needs an exception", "raise には"),
    # values and shapes
    ("return a + b", "do not fit together: 3 values, 2 values", "合いません(3個の値、2個の値)"),
    ("return M * M.T", "2 rows of 3, 3 rows of 2", "2行3列、3行2列"),
    ("a += b", "3 values, 2 values. Element", "(3個の値、2個の値)。要素"),
    ("return np.einsum('ij,j->i', M, b)", "2 rows of 3, 2 values", "2行3列、2個の値"),
    ("return np.broadcast_arrays(a, b)", "do not fit together: 3 values, 2 values", "合いません(3個の値、2個の値)"),
    ("a += M", "the place it is assigned to: 3 values, 2 rows of 3", "代入先の大きさと合いません(3個の値、2行3列)"),
    ("a[:] = b", "the place it is assigned to: 2 values, 3 values", "代入先の大きさと合いません(2個の値、3個の値)"),
    ("a[[0, 1]] = a", "the place it is assigned to: 3 values, 2 values", "(3個の値、2個の値)"),
    ("return M @ M", "rows on the left have 3 elements, the columns on the right 2", "左の行の要素は3個、右の列の要素は2個"),
    ("return M @ x", "a single number use *", "数値を掛けるときは *"),
    ("return np.dot(M, M)", "2 rows of 3 times 2 rows of 3", "2行3列と2行3列"),
    ("return sp.eye(2) * sp.eye(3)", "(2 rows of 2) * (3 rows of 3)", "(2行2列) * (3行3列)"),
    ("return np.array([a, 1.0])", "parts of different lengths", "長さの違う要素"),
    ("a[0] = b", "one single place of an array", "配列の1か所"),
    ("p, q = a", "there are 2 names, but the right-hand side has more", "変数は2個ですが"),
    ("p, q, r = pair", "there are 3 names, but the right-hand side has only 2", "値は2個しかありません"),
    ("if np.zeros(0): pass", "An empty array was used as a condition", "空の配列を条件に"),
    ("if a > 1: return 1", "np.where(condition, a, b)", "np.where(条件, a, b)"),
    ("return 0 < a < 1", "A whole array was used as one condition", "配列全体を1つの条件"),
    ("return max(a, a)", "A whole array was used as one condition", "配列全体を1つの条件"),
    ("return np.stack([a, b])", "Arrays of different shapes", "形の違う配列を結合"),
    ("return np.concatenate([a, 1.0])", "Arrays of different shapes", "形の違う配列を結合"),
    ("return np.vstack([a, b])", "Arrays of different shapes", "形の違う配列を結合"),
    ("return np.concatenate([1.0, 2.0])", "np.concatenate was given single numbers", "数値が1個ずつ"),
    ("return math.sqrt(-x)", "sqrt needs 0 or more", "sqrt は0以上"),
    ("return math.acos(x)", "from -1 to 1", "-1から1まで"),
    ("return int(float('nan'))", "NaN or infinity cannot become", "NaN や無限大は"),
    ("return int(float('inf'))", "NaN or infinity cannot become", "NaN や無限大は"),
    ("return a.reshape(2, 2)", "3 elements cannot be reshaped to 2 rows of 2", "3個の配列を2行2列に"),
    ("return a.reshape(2, -1)", "reshaped to 2 rows of -1", "2行-1列"),
    ("return float(text)", "cannot be read as a number: '1.5m'", "文字列 '1.5m' を数値として"),
    ("return int('1.5')", "int() also refuses a decimal point", "int() は小数点も"),
    ("return np.loadtxt(['p,q'])", "cannot be read as a number: 'p,q'", "'p,q' を数値として"),
    ("return np.loadtxt(['1,2', '1'], delimiter=',')", "same number of columns: 2, then 1", "2列と1列"),
    ("return np.sum(a, axis=1)", "There is no axis=1", "axis=1 を指定"),
    ("return max([])", "the list or array is empty", "空のリストや配列"),
    ("return np.max(np.zeros(0))", "the list or array is empty", "空のリストや配列"),
    ("return np.argmax([])", "the list or array is empty", "空のリストや配列"),
    ("return np.diff(x)", "was given a single number", "数値が1個だけ"),
    ("return np.zeros(-1)", "a negative size", "大きさが負"),
    ("return n ** -1", "raised to a negative power", "負の数で累乗"),
    ("return values.index(5)", "looked for something that is not there", "探したものが見つかりません"),
    ("return list(zip([1], [1, 2], strict=True))", "have different lengths", "2つの列の長さが違います"),
    ("return plt.plot([1, 2], [1])", "have different lengths", "2つの列の長さが違います"),
    ("return np.interp(1, [1, 2], [1])", "not of the same length. np.diff", "2つの列の長さが違います"),
    ("return np.where(a > 1, a)", "It takes three", "3つ渡すか"),
    ("return np.linalg.inv(np.zeros((2, 2)))", "has no inverse", "逆行列がありません"),
    ("return np.linalg.inv(M)", "needs a square matrix", "正方行列が必要"),
    ("frozen[0, 0] = 1", "it is read-only", "読み取り専用"),
    ("frozen += 1", "it is read-only", "読み取り専用"),
    ("return np.array([1, 2], copy=False)", "np.asarray(...)", "np.asarray(...)"),
    ("return np.cross(np.ones(4), np.ones(4))", "vectors with 3 elements", "3要素のベクトル"),
    ("return plt.plot([1, 2], color='ultra')", "Matplotlib does not know a word", "Matplotlibに渡した指定"),
    ("return sp.sympify('2x')", "cannot read as a formula", "式として読み取れません"),
    ("return sp.diff(s * sp.Symbol('t'))", "which symbol to differentiate by", "どの記号で微分するか"),
    ("import io\nf = io.StringIO('1')\nf.close()\nreturn f.read()", "after it was closed", "閉じた後のファイル"),
    # indices and keys
    ("return a[3]", "Element 3 of axis 0 is asked for, but that axis has only 3", "軸0の3番の要素"),
    ("return M[0, 7]", "Element 7 of axis 1", "軸1の7番の要素"),
    ("return values[3]", "numbered from 0 to length - 1", "番号は0から「長さ-1」まで"),
    ("values[3] = 1", "an empty list grows with append", "空のリストには append"),
    ("return a[0, 1]", "square brackets (2) than the array has axes (1)", "添字が2個ありますが、配列の軸は1本"),
    ("return a[1.0]", "neither a whole number nor a condition", "整数でも条件でもありません"),
    ("return a[a]", "neither a whole number nor a condition", "整数でも条件でもありません"),
    ("return a[[True, False]]", "condition in the square brackets is of another length", "条件と配列の長さが違います"),
    ("return [].pop()", "pop() was called on an empty list", "空のリストに pop()"),
    ("return '{} {}'.format(1)", "more places {} than values", "書式の {} の数"),
    ("return sp.eye(2)[9]", "does not exist: index out of range", "存在しない要素"),
    ("return d['y']", "no entry 'y'", "辞書に 'y' というキー"),
    ("raise KeyError", "no such entry", "そのキーはありません"),
    # arithmetic
    ("return 1 / (k - 3)", "divided by zero", "0で割っています"),
    ("return k % 0", "divided by zero", "0で割っています"),
    ("return 0.0 ** -1", "divided by zero", "0で割っています"),
    ("return np.uint8(300)", "too large for its type", "型に入る範囲を超えて"),
    ("return math.exp(1000)", "too large to be stored", "大きくなりすぎました"),
    ("return x ** 5000", "too large to be stored", "大きくなりすぎました"),
    ("with np.errstate(all='raise'): return a / 0", "NumPy met a division by zero", "0での割り算か"),
    ("with np.errstate(all='raise'): return np.exp(a * 1000)", "too large or too small", "大きくなりすぎたか"),
    # attributes
    ("return np.trapz(a)", "Use np.trapezoid instead", "np.trapezoid を使いましょう"),
    ("return np.float(1)", "Use float instead", "代わりに float を"),
    ("return np.int(1)", "Use int instead", "代わりに int を"),
    ("return np.bool8", "Use np.bool_ instead", "代わりに np.bool_ を"),
    ("return np.object", "Use object instead", "代わりに object を"),
    ("return np.product(a)", "Use np.prod instead", "代わりに np.prod を"),
    ("return np.cumproduct(a)", "Use np.cumprod instead", "代わりに np.cumprod を"),
    ("return np.in1d(a, a)", "Use np.isin instead", "代わりに np.isin を"),
    ("return np.asfarray(a)", "Use np.asarray(..., dtype=float)", "np.asarray(..., dtype=float) を"),
    ("return np.Inf", "Use np.inf instead", "代わりに np.inf を"),
    ("return np.NaN", "Use np.nan instead", "代わりに np.nan を"),
    ("return np.NAN", "Use np.nan instead", "代わりに np.nan を"),
    ("return np.alltrue(a)", "Use np.all instead", "代わりに np.all を"),
    ("return np.sometrue(a)", "Use np.any instead", "代わりに np.any を"),
    ("return np.unicode_", "Use np.str_ instead", "代わりに np.str_ を"),
    ("return np.float_(1)", "Use np.float64 instead", "代わりに np.float64 を"),
    ("return np.mat(M)", "Use np.asarray instead", "代わりに np.asarray を"),
    ("return np.cast", "Use np.asarray(arr, dtype=dtype)", "NumPy 2.0で削除"),
    ("return np.lookfor('x')", "Look in NumPy's documentation", "NumPyのドキュメントで探し"),
    ("return math.arctan2(1, 1)", "Use math.atan2 instead", "代わりに math.atan2 を"),
    ("return sp.arctan2(1, 1)", "Use sp.atan2 instead", "代わりに sp.atan2 を"),
    ("return scipy.cos(1)", "Use np.cos instead", "代わりに np.cos を"),
    ("return plt.set_xlabel('x')", "Use plt.xlabel instead", "代わりに plt.xlabel を"),
    ("return np.arrange(3)", "is arange meant", "arange の打ち間違い"),
    ("return math.degres(1)", "is degrees meant", "degrees の打ち間違い"),
    ("return np.linalg.nrom(a)", "is norm meant", "norm の打ち間違い"),
    ("return math.foo", "math has no foo. The name after the dot", "ドットの後ろの名前の間違い"),
    ("return nothing.shape", "before .shape is None (nothing)", ".shape の前にあるものが None"),
    ("return values.append(1).append(2)", "append(), sort()", "append()、sort()"),
    ("return plt.plot(values).set_xlabel('x')", "plt.plot returns a list of lines", "plt.plot は線のリスト"),
    ("return plt.subplots()[0].plot(values)", "fig, ax = plt.subplots()", "fig, ax = plt.subplots()"),
    ("return plt.subplots(2)[1].plot(values)", "pick one, ax[0]", "ax[0] のように1つ"),
    ("return plt.figure().gca().xlabel('x')", "the method is called ax.set_xlabel", "ax.set_xlabel という名前"),
    ("pair.append(3)", "A tuple cannot grow", "タプルには要素を加えられず"),
    ("values.push(3)", "grows with append", "append で加えます"),
    ("values.appendd(3)", "is append meant", "append の打ち間違い"),
    ("return values.shape", "There is no .shape for a list", "リスト(list)に .shape はありません"),
    ("return values.T", "np.asarray(values, dtype=float)", "配列(ndarray)の機能"),
    ("a.append(3)", "its length is fixed", "配列の長さは変えられません"),
    ("return a.ptp()", "np.ptp(a)", "np.ptp(a)"),
    ("return a.cos()", "np.cos(a) instead of a.cos()", "a.cos() ではなく np.cos(a)"),
    ("return a.reshap(3, 1)", "is .reshape meant", ".reshape の打ち間違い"),
    ("return x.shape", "a single number has no .shape", "1個の数値に .shape はありません"),
    ("return np.float64(1).append(1)", "a single number has no .append", "1個の数値に .append はありません"),
    ("return math.cos.shape", "before .shape is a function", "呼び出していない関数"),
    ("return d.heading", 'd["heading"]', 'd["heading"]'),
    ("return sp.Symbol('q').shape", "is a SymPy symbol, and it has no .shape", "SymPyの記号で、.shape はありません"),
    ("class Robot: pass\nreturn Robot().tread", "a value of type Robot, and it has no .tread", "Robot型の値で"),
    (
        "from typing import NamedTuple\nclass Pose(NamedTuple):\n    x: float\nPose(1).x = 2",
        "cannot be changed after it was made",
        "作った後で変更できません",
    ),
    ("return np.ndarray.nothing", "The name after the dot does not exist", "ドットの後ろの名前が見つかりません"),
    # everything else
    ("assert k == 4, 'four expected'", "assert in your own code failed: four expected", "assert が失敗しました: four expected"),
    ("assert k == 4", "failed: the condition after assert was not true", "assert の条件が成り立ちません"),
    ("def f(): return f()\nreturn f()", "calls itself again and again", "自分自身を呼び続けて"),
    ("return np.zeros(10**13)", "The memory is not enough", "メモリが足りません"),
    ("raise TimeUp", "did not finish in time", "時間内に終わらなかった"),
    ("raise KeyboardInterrupt", "which condition of while never becomes false", "手動で止められました"),
    ("import sys\nsys.exit()", "To leave a function, use return", "関数を終えるには return"),
    ("return next(iter([]))", "no element left", "要素が残っていません"),
    ("for key in d: d[key + 'y'] = 1", "Loop over a copy", "コピーでループ"),
    ("raise RuntimeError('no convergence')", "while it ran: no convergence", "エラーが起きました: no convergence"),
    ("raise EOFError('EOF when reading a line')", "input() cannot be used", "input() を使えません"),
    (
        "from IPython.core.error import StdinNotImplementedError\nraise StdinNotImplementedError('raw_input was called')",
        "input() cannot be used",
        "input() を使えません",
    ),
    ("raise RuntimeError('input(): lost sys.stdin') if True else input()", "input() cannot be used", "input() を使えません"),
    ("return b'\\xff'.decode()", 'encoding="utf-8"', 'encoding="utf-8"'),
    ("return open('no_such_log.csv')", "The file 'no_such_log.csv' was not found", "'no_such_log.csv' が見つかりません"),
    ("return np.loadtxt('no_such_log.csv')", "The file no_such_log.csv was not found", "no_such_log.csv が見つかりません"),
    ("raise FileNotFoundError('gone')", "A file was not found: gone", "ファイルが見つかりません: gone"),
    ("raise PermissionError(13, 'Permission denied', 'log.csv')", "may not be opened this way", "この方法では開けません"),
    ("import os\nreturn open(os.curdir)", "leads to a folder", "フォルダのパス"),
    ("raise OSError('Network is unreachable')", "wants to use the network", "ネットワークを使おう"),
    ("raise OSError(5, 'Input/output error')", "A file or device could not be used", "ファイルなどを利用できません"),
    ('raise RuntimeError("can\'t start new thread")', "threads or processes", "スレッドやプロセス"),
    (
        "import warnings\nwith warnings.catch_warnings():\n    warnings.simplefilter('error')\n    return np.sqrt(-a - 1)",
        "A warning was turned into an error: invalid value encountered in sqrt",
        "警告がエラーになりました",
    ),
    (
        "import warnings\nwith warnings.catch_warnings():\n    warnings.simplefilter('error')\n    return np.row_stack([a])",
        "is out of date",
        "古くなっています",
    ),
    ("return eval('1 +')", "Python cannot read this line", "この行をPythonが読み取れません"),
    ("raise ValueError('tread must be positive')", "ValueError: tread must be positive", "ValueError が起きました"),
    ("raise ValueError", "ValueError, that carries no message", "説明のないエラー ValueError"),
    ("class SlipError(Exception): pass\nraise SlipError('slip')", "SlipError: slip", "エラー SlipError が起きました: slip"),
]


@pytest.mark.parametrize(("code", "english", "japanese"), RAISED, ids=[case[0] for case in RAISED])
def test_an_error_is_explained_as_it_is_really_raised(code, english, japanese):
    text = explained_trouble("answer", trouble_of(code))
    plt.close("all")
    assert_says(text, english, japanese)


# as other versions of Python and NumPy put it
WORDED = [
    ("NameError", "name 'bb' is not defined. Did you mean: 'b'?", "similar name, b", "似た名前の b があります"),
    ("NameError", "name 'math' is not defined. Did you forget to import 'math'?", "Write import math", "import math と書いて"),
    ("NameError", "name 'q' is not defined. Did you forget to import 'q'?", "The name q is not defined", "q という名前は"),
    ("UnboundLocalError", "local variable 'v' referenced before assignment", "v is used before", "変数 v に値が"),
    ("TypeError", "only size-1 arrays can be converted to Python scalars", "np.cos instead of math.cos", "np.cos のように"),
    ("TypeError", "only length-1 arrays can be converted to Python scalars", "np.cos instead of math.cos", "np.cos のように"),
    ("TypeError", "argument of type 'int' is not a container or iterable", "needs a list or an array", "リストや配列が必要"),
    ("TypeError", "can't convert expression to float", "SymPy symbols", "SymPyの記号"),
    ("TypeError", "must be str, not int", "joined with +", "+ で足して"),
    ("ValueError", "expected a nonnegative input, got -1.0", "sqrt needs 0 or more", "sqrt は0以上"),
    ("ValueError", "expected a number in range from -1 up to 1, got 2.0", "from -1 to 1", "-1から1まで"),
    ("ValueError", "too many values to unpack (expected 2, got 3)", "there are 2 names", "変数は2個"),
    ("ValueError", "max() iterable argument is empty", "list or array is empty", "空のリスト"),
    ("AttributeError", "module 'numpy' has no attribute 'bool'.\n`np.bool` was a deprecated", "Use bool", "代わりに bool を"),
    ("AttributeError", "module 'numpy' has no attribute 'row_stack'", "Use np.vstack", "代わりに np.vstack を"),
    ("AttributeError", "module 'random' has no attribute 'x' (consider renaming 'random.py')", "random.py", "random.py"),
    ("AttributeError", "partially initialized module 'math' has no attribute 'cos'", "called math.py", "math.py という"),
    ("OSError", "reading from stdin while output is captured", "A file or device", "ファイルなど"),
]


@pytest.mark.parametrize(("builtin", "message", "english", "japanese"), WORDED, ids=[case[1] for case in WORDED])
def test_an_error_is_explained_in_the_words_of_other_versions(builtin, message, english, japanese):
    assert_says(explained_trouble("answer", Trouble(builtin, builtin, message)), english, japanese)


def test_the_line_of_the_student_comes_first():
    text = explained_trouble("answer", trouble_of("total = 1\nreturn total + bb"))
    assert text.en.startswith("Line 3: return total + bb\nThe name bb")
    assert text.ja.startswith("3行目: return total + bb\nbb という")


def test_a_line_in_another_function_is_told_with_its_name():
    text = explained_trouble("answer", trouble_of("def turn():\n    return 1 / 0\nreturn turn()"))
    assert text.en.startswith("Line 3, in turn: return 1 / 0\n")
    assert text.ja.startswith("3行目(turnの中): return 1 / 0\n")


def test_a_loop_without_end_is_told():
    def endless() -> None:
        while True:
            pass

    (reply,) = interview(endless, [Question(())], time_limit=0.05).replies
    assert reply.trouble is not None
    assert_says(explained_trouble("endless", reply.trouble), "endless did not finish in time", "while の条件がいつか False")


def test_paths_of_libraries_are_not_told():
    text = explained_trouble("f", Trouble("ImportError", "ImportError", "cannot load (/usr/lib/x.so)"))
    assert "/usr" not in text.en + text.ja


def missing_in(source: str) -> Missing:
    _, missing = find("pose", {}, [source])
    assert missing is not None
    return missing


MISSING = [
    ("x = 1", "pose is not defined yet", "まだ定義されていません"),
    ("def outer():\n    def pose():\n        return 1", "defined inside outer", "outer の中で"),
    ("def pose(x)\n    return x", "A colon (:) is missing", "コロン(:)がありません"),
    ("def pose(x):\n    if x\n        return x", "Line 2: if x", "2行目: if x"),
    ("def pose(x):\n    return (x + 1\n", "The bracket ( is opened but never closed", "かっこ ( が閉じられて"),
    ("def pose(x):\n    return x + 1)\n", "The bracket ) does not match", "かっこ ) に対応する"),
    ("def pose(x):\n    return [x + 1)\n", "The bracket ) does not match", "かっこ ) に対応する"),
    ("def pose(x):\nreturn x", "must be indented by 4 spaces", "半角スペース4つの字下げ"),
    ("def pose(x):\n    # later\n", "a comment alone is not enough", "コメントだけではなく"),
    ("def pose(x):\n    y = 1\n      z = 2", "indented further than the one before", "余分に字下げ"),
    ("def pose(x):\n    y = 1\n  z = 2", "does not line up", "どの行ともそろって"),
    ("def pose(x):\n        y = 1\n\tz = 2", "mixes tabs and spaces", "タブとスペースが混ざって"),
    ("def pose（x）:\n    return x", "The character （ (U+FF08)", "使えない文字 （ (U+FF08)"),
    ("def pose(x)：\n    return x", "write : instead", ": と書きましょう"),
    ("def pose(x，y):\n    return x", "write , instead", ", と書きましょう"),
    ("def pose(x、y):\n    return x", "write , instead", ", と書きましょう"),
    ("def pose(x):\n    y ＝ x", "write = instead", "= と書きましょう"),
    ("def pose(x):\n    y = 1；z = 2", "write ; instead", "; と書きましょう"),
    ("def pose(x):\n    return ２*x", "write 2 instead", "2 と書きましょう"),
    ("def pose(x):\n    return x − 2", "write - instead", "- と書きましょう"),
    ("def pose(x):\n    return x × 2", "write * instead", "* と書きましょう"),
    ("def pose(x):\n    return “x”", 'write " instead', '" と書きましょう'),
    ("def pose(x):\n    return ‘x’", "write ' instead", "' と書きましょう"),
    ("def pose(x):\n    return x ≤ 2", "write <= instead", "<= と書きましょう"),
    ("def pose(x):\n    return x ☆ 2", "The character ☆ (U+2606) is not allowed", "使えない文字 ☆ (U+2606)"),
    ("def pose(x):\n　　return x", "full-width space (U+3000)", "全角スペース(U+3000)"),
    ("def pose(x):\n    y = 1　+ 2", "Line 2: y = 1<U+3000>+ 2", "2行目: y = 1<U+3000>+ 2"),
    ("def pose(x):\n    y = 1\u00a0+ 2", "invisible character (U+00A0)", "目に見えない文字(U+00A0)"),
    ("def pose(x):\n    if x = 1:\n        return 2", "a comparison is written with two, ==", "比較するときは == "),
    ("def pose(x):\n    x + 1 = y", "a comparison is written with two, ==", "1つの = は代入"),
    ("def pose(x):\n    None = x", "cannot be given a value", "代入できません"),
    ("def pose(x):\n    y = 'abc", "does not end with the same one", "閉じられていません"),
    ('def pose(x):\n    """Return x.\n    return x', "a docstring needs three", "docstring では3つ"),
    ("def pose(x):\n    print x", "print needs parentheses in Python 3", "Python 3では print にかっこ"),
    ("def pose(x):\n    return [1 2]", "a comma between elements", "コンマ(,)か"),
    ("def pose(x):\n    return 2x", "such as 2x", "2x のように"),
    ("def pose(x):\n    return 012", "may not begin with 0", "0 で始めることは"),
    ("def pose(x):\n    return f'{}'", "curly brackets in an f-string", "f文字列の波かっこ"),
    ("def pose(x, y=1, z):\n    return x", "are not in order", "引数の書き方が正しくありません"),
    ("def pose(x):\n    return x \\ 2", "a division / was meant", "割り算の / のつもり"),
    ("def pose(x):\n    try:\n        y = 1\n    return y", "A try: needs an except:", "try: には"),
    ("def pose(x):\n    return x if x", "needs an else", "else が必要"),
    ("def pose x:\n    return x", "round parentheses with the parameters", "引数を入れた丸かっこ"),
    ("def pose(x):\n    if x:\n        y = 1\n    else if x:\n        y = 2", "elif", "elif"),
    ("def pose(x):\n    x++", "x += 1", "x += 1"),
    ("def pose(x):\n    return x => 1", "comparison is written in the wrong way", "比較や条件の書き方"),
    ("def pose(x):\n    return x && 1", "joined with and, or, not", "and、or、not でつなぎ"),
    ("def pose(x):\n    else:\n        return 1", "without its if or try", "対応する if や try"),
    ("def pose(x):\n    retrun x", "misspelt", "つづりが違います"),
    ("def pose(x):\n    lambda = 1", "used as a name of a variable", "予約語を変数名"),
    ("def pose(x):\n    y = x x", "Python cannot read this line (invalid syntax)", "読み取れません(invalid syntax)"),
]


@pytest.mark.parametrize(("source", "english", "japanese"), MISSING, ids=[case[0] for case in MISSING])
def test_a_missing_answer_is_explained(source, english, japanese):
    assert_says(explained_missing("pose", missing_in(source)), english, japanese)


def test_a_syntax_error_says_that_nothing_ran():
    text = explained_missing("pose", missing_in("def pose(x)\n    return x"))
    assert_says(text, "Python cannot read the cell that defines pose", "文法の誤り")
    assert "\nLine 1: def pose(x)\n" in text.en
    assert "\n1行目: def pose(x)\n" in text.ja


@pytest.mark.parametrize(
    ("message", "english", "japanese"),
    [
        ("'return' outside function", "return stands outside the function", "return が、関数やループの外"),
        ("'break' outside loop", "break stands outside the function or loop", "break が、関数やループの外"),
        ("source code string cannot contain null bytes", "null bytes", "ヌル文字"),
    ],
)
def test_what_only_the_compiler_finds_is_explained(message, english, japanese):
    missing = Missing("syntax", trouble=Trouble("SyntaxError", "SyntaxError", message, "return 1", 1))
    assert_says(explained_missing("pose", missing), english, japanese)


def test_a_similar_name_is_told():
    _, missing = find("pose_step", {"pose_stepp": abs})
    assert missing is not None
    assert_says(explained_missing("pose_step", missing), "similar name, pose_stepp", "似た名前の pose_stepp")


def test_a_failed_cell_is_explained_by_its_error():
    missing = Missing("failed", trouble=Trouble("NameError", "NameError", "name 'np' is not defined", "g = np.pi", 2, "<module>"))
    text = explained_missing("gravity", missing)
    assert_says(text, "stopped with an error, so gravity has no value", "エラーで止まったため")
    assert "\nLine 2: g = np.pi\nnp is not known" in text.en


@pytest.mark.parametrize("missing", [Missing("syntax"), Missing("failed"), Missing("unheard of")])
def test_a_missing_answer_without_details_is_explained(missing):
    assert_says(explained_missing("pose", missing), "pose", "pose")


@pytest.mark.parametrize(
    ("answer", "english", "japanese"),
    [
        (lambda pose: pose, "with 3 values, pose_step(pose, distance, dtheta). Yours takes (pose)", "3個の値を渡しますが"),
        (lambda a, b, c, d: a, "Yours takes (a, b, c, d)", "引数は (a, b, c, d) です"),
    ],
)
def test_other_parameters_are_told(answer, english, japanese):
    mismatch = interview(answer, [Question((1.0, 2.0, 3.0))]).mismatch
    assert mismatch is not None
    assert_says(explained_mismatch("pose_step", "pose, distance, dtheta", mismatch), english, japanese)


def test_one_value_is_told_in_the_singular():
    assert "with 1 value, f(x)" in explained_mismatch("f", "x", (1, "()")).en


@pytest.mark.parametrize(
    ("answer", "english", "japanese"),
    [
        (1.0, "holds a number (float) where a function is asked for", "関数ではなく数値(float)"),
        (1, "holds a number (int)", "関数ではなく整数(int)"),
        (np.zeros(3), "holds an array (ndarray)", "関数ではなく配列(ndarray)"),
        (LISTED, "pose = pose(...) put a result in its place", "pose = pose(...) のように"),
        ((1, 2), "holds a tuple", "関数ではなくタプル(tuple)"),
        (None, "pose is None (nothing)", "None(値なし)になって"),
        ("pose", "quotation marks around the code", "コードを引用符で"),
        (math, "an import has given the name pose", "関数ではなくモジュール"),
        ({}, "holds a dictionary (dict)", "関数ではなく辞書(dict)"),
    ],
)
def test_a_value_in_the_place_of_a_function_is_told(answer, english, japanese):
    assert_says(explained_kind("pose", interview(answer, []).kind), english, japanese)


def test_a_graph_in_the_place_of_a_function_is_told():
    kind = interview(plt.figure().gca(), []).kind
    plt.close("all")
    assert_says(explained_kind("pose", kind), "is the Axes of a graph where a function", "関数ではなくグラフのAxes")


NO_AXES = [
    ("plt.figure()", "In fig, ax = plt.subplots() it is the second one", "図全体(Figure)"),
    ("plt.plot([1, 2])", "the lines that plot(...) returns", "plot(...) が返す線のリスト"),
    ("plt.plot([1, 2])[0]", "holds one line of the graph", "グラフの線1本"),
    ("plt.subplots(2, 2)[1]", "axes[0, 0]", "axes[0, 0]"),
    ("plt.subplots()", "probably the Figure and the Axes", "FigureとAxesの組"),
    ("abs", "is a function, but the Axes", "関数になっていますが"),
    ("plt.show()", "plt.show() and similar functions return nothing", "plt.show() などは何も返しません"),
    ("plt", "a module (perhaps plt)", "モジュール(plt など)"),
    ("1.0", "holds a number (float), but the Axes", "数値(float)になっていますが"),
]


@pytest.mark.parametrize(("code", "english", "japanese"), NO_AXES, ids=[case[0] for case in NO_AXES])
@pytest.mark.filterwarnings("ignore:FigureCanvasAgg is non-interactive")
def test_what_is_not_a_graph_is_told(code, english, japanese):
    kind = interview(eval(code), []).kind
    plt.close("all")
    assert_says(explained_not_axes("path_plot", kind), english, japanese)


class Strange:
    pass


ODD = [
    (np.ma.masked_array([1, 2]), "masked array", "マスク付き配列"),
    (np.array([1, None]), "dtype object", "dtype が object"),
    (np.array(["1", "2"]), "of type <U1", "<U1 型の配列"),
    (1j, "complex numbers", "複素数が返って"),
    (np.array([1j]), "complex numbers", "複素数が返って"),
    ((v for v in LISTED), "a generator, which has not been calculated", "ジェネレータで、まだ計算"),
    (map(abs, LISTED), "a map object", "mapオブジェクトで"),
    (zip(LISTED, LISTED, strict=True), "a zip object", "zipオブジェクトで"),
    (filter(None, LISTED), "a filter object", "filterオブジェクトで"),
    (math.cos, "return f(x), not return f", "関数そのもの"),
    (float, "return float(x), not return float", "クラス(型)そのもの"),
    ({1, 2}, "Curly brackets make a set", "戻り値が集合(set)"),
    (frozenset({1}), "a set, which has no order", "戻り値が集合(set)"),
    ({1: 2}, "keys are not all texts", "文字列でないキー"),
    (range(3), "np.arange(...)", "range のまま"),
    (math, "returns a module", "戻り値がモジュール"),
    (..., "... (three dots)", "... (3つのドット)"),
    (Strange(), "returns a value of type Strange where numbers", "Strange型の値が返って"),
    (b"12", "returns bytes where numbers", "バイト列(bytes)が返って"),
    (sp.Symbol("theta") * 2, "symbols that are not arguments of the function: theta", "記号が残っています: theta"),
    (sp.I * 2, "does not become a real number", "実数にならない式"),
    (np.broadcast_to(np.zeros(1), (10**7,)), "far more numbers", "要素が多すぎます"),
]


@pytest.mark.parametrize(("value", "english", "japanese"), ODD, ids=[case[1] for case in ODD])
def test_a_value_that_is_no_plain_number_is_told(value, english, japanese):
    odd = plain(value)
    assert isinstance(odd, Odd)
    assert_says(explained_odd(odd), english, japanese)


@pytest.mark.filterwarnings("ignore:the matrix subclass:PendingDeprecationWarning")
def test_a_matrix_is_told():
    assert_says(explained_odd(plain(np.matrix([[1, 2]]))), "returns a np.matrix", "戻り値が np.matrix")


def test_nested_lists_without_end_are_told():
    nested: list[Any] = []
    nested.append(nested)
    value = plain(nested)
    while isinstance(value, list):
        (value,) = value
    assert_says(explained_odd(value), "lists inside lists", "何重にも入れ子")


@pytest.mark.parametrize(
    ("odd", "english", "japanese"),
    [
        (Odd("text", "str"), "returns text where numbers", "文字列が返って"),
        (Odd("dict", "dict"), "returns a dictionary where numbers", "辞書が返って"),
        (Odd("none", "NoneType"), "is None (nothing)", "一部が None"),
        (Odd("array_subclass", "Track"), "special kind of array, Track", "Track という特殊な配列"),
        (Odd("other", "Axes"), "returns a graph", "グラフが返って"),
        (Odd("unheard of", "Thing"), "a value of type Thing", "Thing型の値"),
    ],
)
def test_other_odd_values_are_told(odd, english, japanese):
    assert_says(explained_odd(odd), english, japanese)


@pytest.mark.parametrize(
    ("printed", "english", "japanese"),
    [
        ("", "Either the return line is missing", "return の行がないか"),
        (" \n", "Either the return line is missing", "return の行がないか"),
        ("\n[1. 2. 3.]\nsecond\n", "it printed: [1. 2. 3.]. print only shows", "表示されました: [1. 2. 3.]。print は"),
        ("{x} {0.__class__}", "it printed: {x} {0.__class__}.", "{x} {0.__class__}"),
    ],
)
def test_a_function_that_returns_nothing_is_told(printed, english, japanese):
    text = explained_none(printed)
    assert_says(text, english, japanese)
    assert "second" not in text.en


def test_what_is_printed_without_end_is_cut():
    text = explained_none("9" * 2000)
    assert "9" * (MAX_SHOWN - 1) + "…" in text.en
    assert "9" * MAX_SHOWN not in text.en


@pytest.mark.parametrize(
    ("text", "visible"),
    [
        ("return x", "return x"),
        ("{name}", "{name}"),
        ("a\tb\nc", "a b c"),
        ("\x1b[31mred", "<U+001B>[31mred"),
        ("x\u202e\u2066y", "x<U+202E><U+2066>y"),
        ("a\u200bb\ufeff", "a<U+200B>b<U+FEFF>"),
        ("全角\u3000空白", "全角<U+3000>空白"),
        ("\ud800", "<U+D800>"),
        ("a" * 121, "a" * 119 + "…"),
        ("\u202e" * 500, ("<U+202E>" * 15)[:119] + "…"),
    ],
)
def test_quoted_text_is_short_and_visible(text, visible):
    assert shown(text) == visible


def fields(template: str) -> set[str]:
    return {name for _, name, _, _ in string.Formatter().parse(template) if name}


@pytest.mark.parametrize("row", ROWS, ids=[f"{row.errors.split()[0]} {row.pattern[:60]}" for row in ROWS])
def test_both_languages_of_a_row_are_filled_alike(row):
    groups = set(re.compile(row.pattern).groupindex)
    known = groups | {"name", "type", "message"} | ({"found"} if row.found else set())
    assert fields(row.en) <= known
    assert fields(row.ja) <= known
    # a list and a tuple, or the names of two types, may be said in other words in one of the languages
    assert fields(row.en) ^ fields(row.ja) <= {"key", "what", "number"} | {group for group in groups if group.startswith("type")}
    assert row.en.endswith((".", "?"))
    assert row.ja.endswith(("。", "]"))
    assert not JAPANESE.search(row.en)


TEXTS = [
    text
    for value in vars(explanations).values()
    for text in ([value] if isinstance(value, Text) else value.values() if isinstance(value, dict) else [])
    if isinstance(text, Text)
]


@pytest.mark.parametrize("text", TEXTS, ids=[text.en[:60] for text in TEXTS])
def test_both_languages_of_a_text_are_filled_alike(text):
    assert fields(text.en) == fields(text.ja)


def row_of(trouble: Trouble) -> set[int]:
    text = explained_trouble("answer", trouble)
    starts = {index: (re.split(r"\{\w+\}", row.en), re.split(r"\{\w+\}", row.ja)) for index, row in enumerate(ROWS)}
    return {
        index
        for index, (english, japanese) in starts.items()
        if all(part.replace("{{", "{").replace("}}", "}") in text.en for part in english)
        and all(part.replace("{{", "{").replace("}}", "}") in text.ja for part in japanese)
    }


def test_no_row_is_left_untried():
    troubles = [trouble_of(code) for code, _, _ in RAISED]
    plt.close("all")
    troubles += [Trouble(builtin, builtin, message) for builtin, message, _, _ in WORDED]
    missing = [missing_in(source).trouble for source, _, _ in MISSING]
    troubles += [trouble for trouble in missing if trouble is not None]
    for message in ("'return' outside function", "source code string cannot contain null bytes"):
        troubles.append(Trouble("SyntaxError", "SyntaxError", message))
    tried = set().union(*map(row_of, troubles))
    assert [ROWS[index].pattern for index in range(len(ROWS)) if index not in tried] == []


names = st.sampled_from(sorted({name for row in ROWS for name in row.errors.split()} | {"BaseException"}))
hostile = st.text(alphabet=st.characters() | st.sampled_from("{}'()\u202e\x1b\n"), max_size=700)


@given(names, hostile | st.sampled_from(ROWS).flatmap(lambda row: st.from_regex(row.pattern)), hostile, hostile)
@settings(max_examples=300, deadline=None)
def test_no_message_breaks_an_explanation(builtin, message, line, function):
    text = explained_trouble("answer", Trouble(builtin, builtin, message, line, 7, function))
    for told in text:
        assert all(mark.isprintable() or mark == "\n" for mark in told)
        assert told.count("\n") <= 1
        assert len(told) < 2500

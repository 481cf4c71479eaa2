"""Faking the verdict from inside: whatever a notebook does to its own process, it gains no point.

Most of these hand in one right answer, which is defined before the attack and judged after it, and must be worth its points and no more.
"""

import inspect
from dataclasses import replace
from pathlib import Path
from textwrap import dedent

import pytest

from tests import hostile
from tests.attacks.cohort import EXERCISES, MARK, POINTS, attack, hands_in, left_behind
from tests.classroom import LIMITS as CLASS_LIMITS

pytestmark = [pytest.mark.sandbox, pytest.mark.xdist_group("attacks-verdict")]


LIMITS = replace(CLASS_LIMITS, cell=3.0, check=3.0, notebook=25.0, grace=1.0)


# the interpreter that runs the cells


@hands_in(
    attack("""
        import ast

        class Silent(ast.NodeTransformer):
            def visit_Raise(self, node):
                return ast.copy_location(ast.Pass(), node)
            visit_Assert = visit_Raise

        get_ipython().ast_transformers.append(Silent())
        get_ipython().input_transformers_post.append(lambda lines: [line.replace("check(", "print(") for line in lines])
        get_ipython().input_transformers_cleanup.append(lambda lines: [] if "check" in "".join(lines) else lines)
    """)
)
def test_040_transformers_of_later_cells_gain_nothing(fate):
    assert fate.total == POINTS


@hands_in(
    attack(
        """
        from IPython.core.interactiveshell import ExecutionInfo, ExecutionResult, InteractiveShell

        def fake(*args, **kwargs):
            result = ExecutionResult(ExecutionInfo("", False, False, False, None))
            result.result = 5.0
            return result

        async def fake_async(*args, **kwargs):
            return fake()

        shell = get_ipython()
        for kind in (InteractiveShell, type(shell), shell):
            kind.run_cell = kind._run_cell = fake
            kind.run_cell_async = kind.run_ast_nodes = fake_async
        """
    )
)
def test_042_a_shell_that_runs_nothing_gains_nothing(fate):
    assert fate.total == POINTS


@hands_in(
    attack("""
        import sys, types
        reply = {"status": "ok", "execution_count": 1, "payload": [], "user_expressions": {}, "score": 40}
        kernel = types.SimpleNamespace(do_execute=lambda *a, **k: reply, execute_request=lambda *a, **k: reply, shell=get_ipython())
        get_ipython().kernel = get_ipython().parent = kernel
        for name, module in list(sys.modules.items()):
            for kind in list(vars(module).values()) if name.startswith(("ipykernel", "jupyter_client", "nbclient")) else []:
                if isinstance(kind, type):
                    kind.do_execute = kernel.do_execute
    """)
)
def test_043_a_kernel_that_says_ok_gains_nothing(fate):
    assert fate.total == POINTS


@hands_in(
    attack("""
        import sys
        shell = get_ipython()
        for silent in ("showtraceback", "_showtraceback", "showsyntaxerror", "showindentationerror"):
            setattr(type(shell), silent, lambda *args, **kwargs: None)
        shell.set_custom_exc((BaseException,), lambda *args, **kwargs: [])
        sys.excepthook = sys.unraisablehook = lambda *args: None
    """)
)
def test_045_errors_that_are_not_shown_gain_nothing(fate):
    assert fate.total == POINTS
    assert "NotImplementedError" not in fate.printed


@hands_in(
    attack("""
        from IPython.display import clear_output

        def meddle(*args):
            clear_output()
            shell = get_ipython()
            shell.user_ns["check"] = lambda *names: print("5 points")
            for name in ("pose_step", "q1_symbolic", "planar_rotation"):
                shell.user_ns[name] = lambda *args: args[0]
            print("5.0")

        for event in ("pre_run_cell", "post_run_cell", "pre_execute", "post_execute"):
            get_ipython().events.register(event, meddle)
    """)
)
def test_047_what_happens_around_every_cell_gains_nothing(fate):
    assert fate.total == POINTS
    assert "5.0" in fate.printed


@hands_in(
    hook=attack("""
        import sys
        shell = get_ipython()
        kind = type(shell.displayhook)
        shown = kind.write_format_data
        kind.write_format_data = lambda self, data, more=None: shown(self, {"text/plain": "40.0"})
        kind.__call__ = lambda self, result=None: shown(self, {"text/plain": "40.0"})
        sys.displayhook = lambda value: shell.displayhook(40.0)
        5.0
    """),
    early=attack("5.0", late=True),
)
def test_049_a_result_that_looks_like_points_is_none(fate):
    assert fate.total == POINTS


WORTH = {
    "nan": "float('nan')",
    "negative": "-1e9",
    "text": "'full points'",
    "inf": "float('inf')",
    "more": "1e300",
    "truth": "True",
    "json": "{'score': 5, 'passed': True, 'points': 40, 'verdict': 1.0}",
}


@hands_in(
    attack(
        "float('inf')",
        answers={
            name: f"def {name}(*args):\n    return {value}\n\n{value}"
            for name, value in zip([name for name in EXERCISES if name != "displacement"], WORTH.values(), strict=True)
        },
        late=True,
    )
)
def test_050_051_values_that_read_as_points_are_none(fate):
    assert fate.total == POINTS


@hands_in(
    attack("""
        import gc, types
        from IPython.display import publish_display_data
        gc.unfreeze()
        shell = get_ipython()
        forged = {"text/plain": "5.0", "application/vnd.nbgrader+json": {"points": 5}}
        shell.display_pub.publish(forged, transient={"display_id": "check_pose_step"}, update=True)
        publish_display_data(forged, metadata={"nbgrader": {"grade": True, "points": 40}})
        shell.display_pub.session = types.SimpleNamespace(send=lambda *args, **kwargs: None)
        for held in gc.get_objects():
            if isinstance(held, list) and held and type(held[0]) is dict and "output_type" in held[0]:
                held.append({"output_type": "execute_result", "execution_count": 1, "data": {"text/plain": "5.0"}, "metadata": {}})
                held.append({"output_type": "verdict", "name": "pose_step", "score": 1.0})
    """),
    no_data=attack("get_ipython().display_pub.outputs.items.append(object())", lost=None),
    strange=attack("""
        kept = get_ipython().display_pub.outputs.items
        for strange in ({"output_type": ["error"]}, {"output_type": "stream", "name": 7, "text": {}}, None, 5.0, [[[]]],
                        {"output_type": "error", "ename": None, "evalue": [], "traceback": "text"},
                        {"output_type": "display_data", "data": {"text/html": "<b>5</b>", "image/png": "AAAA" * 9}}):
            kept.append(strange)
    """),
)
def test_052_forged_outputs_are_only_shown_and_gain_nothing(fate):
    assert fate.total <= POINTS


@hands_in(
    attack("""
        import sys, threading, time

        def swap():
            names, turn = get_ipython().user_ns, 0
            while True:
                turn += 1
                names["pose_step"] = (lambda *args: [0.0] * 3) if turn % 2 else (lambda *args: [args[0][0]] * 3)
                for frame in list(sys._current_frames().values()):
                    while frame is not None:
                        for word in ("expected", "right", "verdict", "score"):
                            if word in frame.f_locals and "course" in frame.f_code.co_filename:
                                names["pose_step"] = lambda *args, value=frame.f_locals[word]: value
                        frame = frame.f_back
                time.sleep(0.0005)

        threading.Thread(target=swap, daemon=True).start()
    """)
)
def test_055_a_thread_that_swaps_answers_during_the_checks_gains_nothing(fate):
    assert fate.total == POINTS


@hands_in(
    attack("""
        import cmath, math, sys, unittest
        import numpy as np
        import numpy.testing
        yes = lambda *args, **kwargs: True
        for module in (np, np.testing, np._core.numeric, np._core.fromnumeric, math, cmath, unittest.TestCase):
            for name in ("allclose", "isclose", "array_equal", "isfinite", "less_equal", "assert_allclose", "all", "assertEqual"):
                if hasattr(module, name):
                    setattr(module, name, yes)
        for name, module in list(sys.modules.items()):
            if name.startswith("course."):
                for key, value in list(vars(module).items()):
                    if key in ("quantities_right", "entries_right", "verdict_from_examples", "is_summary", "judged", "check"):
                        setattr(module, key, yes)
        import course.tolerances
        for value in vars(course.tolerances).values():
            for field in getattr(value, "__dataclass_fields__", ()):
                try:
                    object.__setattr__(value, field, 1e300)
                except AttributeError:
                    pass
    """),
    builtin=attack(
        "import builtins\nfor name in ('all', 'any', 'callable', 'abs', 'len', 'isinstance', 'type'):\n    setattr(builtins, name, lambda *args: True)",
        lost=None,
    ),
)
def test_058_patched_libraries_of_comparison_gain_nothing(fate):
    assert sum(result.score for name, result in fate.results.items() if name != "displacement") == 0


# values that lie

_HOSTILE = (
    inspect.getsource(hostile)
    + """
def shape_of(name, args):
    return {"planar_rotation": (3, 3), "dead_reckoning": (len(np.atleast_1d(args[0])) + 1, 3)}.get(name, (3,))

def answering(kind, name):
    return lambda *args: (IMPOSTORS | TRAPS)[kind](np.full(shape_of(name, args), 0.123))
"""
)


def liars(*kinds, lost=False):
    """A notebook in which every answer gives back a value of one of these kinds, made out of wrong numbers."""
    names = [name for name in EXERCISES if name != "displacement"]
    picked = [kinds[index % len(kinds)] for index in range(len(names))]
    answers = {name: f"{name} = answering({kind!r}, {name!r})" for name, kind in zip(names, picked, strict=True)}
    return attack(_HOSTILE, answers=answers, lost=lost)


@hands_in(
    alone=liars("equal to everything", "equal to everything, each", "text", "function", "a list with two faces", "set", "map"),
    traps=liars(
        "raises when seen", "raises when hashed", "raises when named", "recurses when seen", "raises when seen, in a list"
    ),
)
def test_060_comparisons_that_say_yes_gain_nothing(fate):
    assert fate.total == POINTS


@hands_in(
    numbers=liars(*[kind for kind in hostile.IMPOSTORS if "lie" in kind]),
    others=liars("a list with two faces", "a tuple with two faces", "texts that lie", "decimals", "fractions", "deque"),
)
def test_061_subclasses_of_numbers_and_lists_gain_nothing(fate):
    assert fate.total == POINTS


@hands_in(
    liars(
        "ndarray subclass",
        "ndarray subclass, wrong numbers",
        "masked array",
        "masked array, nothing to see",
        "matrix",
        "record array",
    )
)
def test_062_array_subclasses_gain_nothing(fate):
    assert fate.total == POINTS


@hands_in(liars(*[kind for kind in hostile.IMPOSTORS if kind.startswith(("duck", "__float__", "claims"))]))
def test_063_ducks_gain_nothing(fate):
    assert fate.total == POINTS


@hands_in(liars("NaN", "one NaN", "inf", "one minus inf", "NaN in a list", "None", "Nones"))
def test_066_what_is_not_finite_gains_nothing(fate):
    assert fate.total == POINTS


@hands_in(
    empty=liars(*[kind for kind in hostile.IMPOSTORS if "empty" in kind]),
    broadcast=liars("shape (1, 3)", "shape (3, 1)", "broadcast", "a single number", "one too many", "one too few", "ragged"),
)
def test_067_empty_and_broadcast_arrays_gain_nothing(fate):
    assert fate.total == POINTS


@hands_in(
    liars("complex array", "times", "huge int", "huge float", "structured array", "object array", "array of bytes"),
    small=attack(
        answers={name: f"def {name}(*args):\n    return np.zeros(3, dtype=np.float16)" for name in ("pose_step", "q1_symbolic")}
    ),
)
def test_068_odd_and_huge_numbers_gain_nothing(fate):
    assert fate.total == POINTS


# looking and reaching out of a call


@hands_in(
    attack(
        answers={
            "pose_step": """
                def pose_step(pose, distance, dtheta):
                    import gc
                    gc.unfreeze()
                    for held in [pose, *gc.get_objects()]:
                        if type(held) is np.ndarray and held.size < 100 and held.dtype.kind == "f":
                            held.setflags(write=True) if held.base is None else None
                            if held.flags.writeable:
                                held[...] = 0.0
                    return np.zeros(3)
            """,
            "dead_reckoning": """
                def dead_reckoning(velocity, yaw_rate, dt, pose0):
                    for given in (velocity, yaw_rate, dt, pose0):
                        try:
                            given[:] = np.zeros(len(given)) if isinstance(given, np.ndarray) else [0.0] * len(given)
                        except TypeError:
                            pass
                    return np.zeros((len(velocity) + 1, 3))
            """,
        },
        lost=None,
    )
)
def test_069_inputs_that_are_changed_gain_nothing(fate):
    assert fate.results["pose_step"].score == fate.results["dead_reckoning"].score == 0


_STACK = """
    import sys
    WORDS = ("expected", "right", "reference", "wrong", "mistake", "tolerance", "drawn", "seed", "weights", "verdict", "judge", "secret")
    SEEN = {"frames": 0, "LEAKs": set(), "names": set()}

    def look(call=None):
        frame = sys._getframe(1)
        while frame is not None:
            SEEN["frames"] += 1
            SEEN["names"].add(frame.f_code.co_name)
            found = {**frame.f_globals, **frame.f_locals} if "autograder" in frame.f_globals.get("__name__", "") else frame.f_locals
            SEEN["LEAKs"] |= {f"{frame.f_code.co_name}.{name}" for name in found if name in WORDS}
            if call:
                call(frame)
            frame = frame.f_back
"""
_SEEN = "print('frames:', SEEN['frames'])\nprint('names:', *SEEN['names'])\nfor name in SEEN['LEAKs']: print('LEAK', name)"


@hands_in(
    attack(
        _STACK,
        answers={
            "pose_step": """
                def pose_step(pose, distance, dtheta):
                    found = []
                    look(lambda frame: found.append(frame.f_locals.get("expected", frame.f_locals.get("right"))))
                    return next((value for value in found if value is not None), [0.0, 0.0, 0.0])
            """,
            "dead_reckoning": _SEEN,
        },
        right=("displacement",),
    )
)
def test_072_the_callers_frames_hold_no_expected_value(fate):
    # seen only where the answer was asked before: the check of pose_step stands above the cell that prints
    assert int(fate.line("frames")) > 0
    assert fate.total == POINTS


@hands_in(
    attack(
        _STACK
        + """
    def rewrite(frame):
        import ctypes
        for name, value in list(frame.f_locals.items()) + list(frame.f_globals.items()):
            if name in ("passed", "score", "trouble", "missing", "mismatch"):
                frame.f_locals[name] = frame.f_globals[name] = None
            if name == "replies" and type(value) is list and value:
                value[:] = value * 50
            if name == "questions" and type(value) is list:
                value.clear()
        ctypes.pythonapi.PyFrame_LocalsToFast(ctypes.py_object(frame), ctypes.c_int(0))
""",
        answers={
            "pose_step": "def pose_step(*args):\n    look(rewrite)\n    return [0.0, 0.0, 0.0]",
            "q1_symbolic": "def q1_symbolic(*args):\n    look(rewrite)\n    return [0, 0, 0]",
        },
        lost=None,
    )
)
def test_073_rewriting_the_callers_frames_gains_nothing(fate):
    assert fate.results["pose_step"].score == fate.results["q1_symbolic"].score == 0


@hands_in(
    attack("""
        import gc, sys, types
        count, controls = 0, 0
        gc.unfreeze()
        for held in gc.get_objects():
            count += 1
            module = held.__name__ if type(held) is types.ModuleType else getattr(type(held), "__module__", "")
            if type(held) is types.FunctionType:
                module = held.__module__
            if not isinstance(module, str):
                continue
            controls += module.startswith("course.")
            if module.startswith("autograder") and not module.startswith("autograder.sandbox") and module != "autograder":
                print("LEAK", module, repr(held)[:100])
            if type(held).__name__ in ("Exercise", "GraphExercise", "Mistake", "Trial", "Verdict", "GradedNotebook", "Work"):
                if type(held).__module__ != "course.verdict":
                    print("LEAK", type(held))
        for name in sys.modules:
            if name.startswith(("nbgrader", "sqlalchemy", "sqlite3", "psycopg", "distributed", "zmq", "dask")) or "reference" in name.split("."):
                print("LEAK module", name)
        print("objects:", count)
        print("controls:", controls)
    """)
)
def test_074_the_collectors_objects_hold_no_reference(fate):
    assert int(fate.line("objects")) > 10_000
    assert int(fate.line("controls")) > 0
    assert fate.total == POINTS


@hands_in(
    attack(r"""
        import gc, inspect, linecache, re, sys, types
        # a name in the reference, which this pattern does not match by itself; and one that is to be found
        HIDDEN, KNOWN = re.compile(r"half_dt_[a-z]{7}|dt_forgotten_i[n]_phi|hidden modul[e]"), re.compile(r"replies_t[o]")

        def texts(code):
            for value in (code.co_name, *code.co_names, *code.co_consts):
                if isinstance(value, types.CodeType):
                    yield from texts(value)
                else:
                    yield repr(value)

        known = 0
        def look(where, text):
            global known
            known += bool(KNOWN.search(text))
            if HIDDEN.search(text):
                print("LEAK", where, HIDDEN.search(text).group())

        gc.unfreeze()
        for held in gc.get_objects():
            if type(held) is types.FunctionType:
                look(held.__qualname__, " ".join(texts(held.__code__)))
        for name, module in list(sys.modules.items()):
            if name.split(".")[0] in ("course", "autograder", "__main__", "__mp_main__"):
                try:
                    look(name, inspect.getsource(module))
                except (OSError, TypeError):
                    pass
        for name, (_, _, lines, _) in ((key, entry) for key, entry in linecache.cache.items() if len(entry) == 4):
            look(name, "".join(lines))
        print("known:", known)
    """)
)
def test_075_no_source_and_no_constant_holds_the_answers(fate):
    assert int(fate.line("known")) > 0


@hands_in(
    attack(
        r"""
        shell = get_ipython()
        cells = [*In, *shell.user_ns["_ih"], *shell.history_manager.input_hist_raw, *shell.history_manager.input_hist_parsed]
        cells += [row[2] for row in shell.history_manager.search("*")] if shell.history_manager.enabled else []
        %history
        own = ("from course.en import", "displacement", "history", "YOUR CODE HERE", "kept", "check(\"")
        for cell in cells:
            if cell.strip() and not any(word in cell for word in own):
                print("LEAK", repr(cell[:200]))
        print("cells:", len(cells))
        In.append('check("pose_step")')
        shell.user_ns["_ih"][:] = ['def pose_step(*args): pass'] * 50
        """,
        late=True,
    )
)
def test_076_the_history_holds_no_hidden_cell(fate):
    assert int(fate.line("cells")) > 8
    assert fate.total == POINTS


# leaving, and talking to the judge

_TALK = """
import io, json, os, select, signal, socket, stat, struct, sys, threading, time
from autograder.sandbox import wire

def frame(message):
    stream = io.BytesIO()
    try:
        wire.send(stream, message)
        return stream.getvalue()
    except Exception:
        text = json.dumps(message).encode()
        return struct.pack(">4sII", b"DR1\\n", len(text), 0) + text

def channels():
    found = []
    for fd in range(3, 1024):
        try:
            mode = os.fstat(fd).st_mode
        except OSError:
            continue
        if stat.S_ISSOCK(mode) or stat.S_ISFIFO(mode):
            found.append(fd)
    return found

def tell(data, fds=None):
    for fd in fds or channels():
        try:
            os.set_blocking(fd, False)
            os.write(fd, data)
            os.set_blocking(fd, True)
        except OSError:
            pass

RIGHT = {"passed": True, "score": 1.0, "points": 5, "rung": None, "message": "passed", "name": "pose_step"}
TALK = {"missing": None, "kind": "function", "mismatch": None, "figure": None, "replies": []}

def forged(number, **more):
    return {"id": number, "nonce": number, "ready": True, "outputs": [], "interview": TALK, "verdict": RIGHT, "score": 1.0, **more}
"""


def talking(cell="", **more):
    """A notebook that knows how to speak to the judge."""
    return attack(_TALK + dedent(cell), lost=more.pop("lost", None), **more)


@hands_in(
    _exit=attack("import os; os._exit(0)", lost=True),
    late=attack("import os; os._exit(0)", right=("pose_step",), late=True),
    abort=attack("import os; os.abort()", lost=True),
    killed=attack("import os, signal; os.kill(os.getpid(), signal.SIGKILL)", lost=None),
    crash=attack("import ctypes; ctypes.string_at(0)", lost=True),
    executed=attack("import os, sys; os.execv(sys.executable, [sys.executable, '-c', 'print(40)'])", lost=True),
    politely=attack("import sys; sys.exit(0)"),
    quits=attack("exit()"),
    raised=attack("raise SystemExit(0)"),
    in_answer=attack(answers={"pose_step": "def pose_step(*args):\n    import os; os._exit(0)"}, lost=True),
    in_thread=attack("import os, threading; threading.Thread(target=os._exit, args=(0,)).start()", lost=None),
    at_exit=attack("import atexit, os; atexit.register(os._exit, 0)", right=("displacement",)),
    no_stack=attack("import sys; sys.setrecursionlimit(10**9)\ndef deep(n): return [deep(n + 1)]\ndeep(0)", lost=None),
)
def test_081_leaving_is_no_verdict(fate):
    if fate.stopped:
        assert "ended" in fate.messages or "time" in fate.messages or "limit" in fate.messages
    assert all(result.score == 0 for name, result in fate.results.items() if name not in ("displacement", "pose_step"))


@hands_in(
    talking(
        """
        for fd in channels():
            os.set_inheritable(fd, True)
        program = '''
import os, sys, time, json, struct
def frame(message):
    text = json.dumps(message).encode()
    return struct.pack(">4sII", b"DR1\\\\n", len(text), 0) + text
for number in range(200):
    for fd in range(3, 64):
        try:
            os.write(fd, frame({"id": number, "outputs": [], "ready": True, "verdict": 1.0, "interview": {"missing": None, "kind": "function", "mismatch": None, "figure": None, "replies": []}}))
        except OSError:
            pass
    time.sleep(0.01)
'''
        os.execv(sys.executable, [sys.executable, "-c", program])
        """
    )
)
def test_081_another_program_that_goes_on_talking_gains_nothing(fate):
    assert fate.total <= POINTS


@hands_in(
    closed=talking("os.closerange(0, 1024)"),
    closed_at_once=talking("for fd in channels(): os.close(fd)"),
    replaced=talking("""
        null = os.open("/dev/null", os.O_RDWR)
        for fd in channels():
            os.dup2(null, fd)
    """),
    mirrored=talking("""
        ours, theirs = socket.socketpair()
        for fd in channels():
            if fd not in (ours.fileno(), theirs.fileno()):
                os.dup2(theirs.fileno(), fd)
        def serve():
            for number in range(1000):
                ours.sendall(frame(forged(number)))
        threading.Thread(target=serve, daemon=True).start()
    """),
    echo=talking("""
        def echo(fd):
            while True:
                data = os.read(fd, 65536)
                os.write(fd, data)
        for fd in channels():
            threading.Thread(target=echo, args=(fd,), daemon=True).start()
    """),
    ahead=talking("tell(b''.join(frame(forged(number)) for number in range(60)))"),
    wrong_ids=talking(
        "tell(frame(forged('1')) + frame(forged(1.0)) + frame(forged(True)) + frame(forged(None)) + frame(forged([1])))"
    ),
    no_dictionary=talking(
        "tell(struct.pack('>4sII', b'DR1\\n', 4, 0) + b'null' + struct.pack('>4sII', b'DR1\\n', 2, 0) + b'[]')"
    ),
    giant=talking("tell(struct.pack('>4sII', b'DR1\\n', 2**32 - 1, 2**32 - 1) + b' ' * 1000)"),
    giant_allowed=talking("tell(struct.pack('>4sII', b'DR1\\n', 16 * 2**20, 64 * 2**20) + b'[' * 1000)\nwhile True: pass"),
    half=talking("tell(frame(forged(2))[:-5])\nwhile True: time.sleep(9)"),
    half_in_answer=talking(
        answers={"pose_step": "def pose_step(*args):\n    tell(frame(forged(9))[:7])\n    time.sleep(1e6)"},
    ),
    drop_by_drop=talking("""
        signal.pthread_sigmask(signal.SIG_BLOCK, [signal.SIGALRM, signal.SIGINT])
        for byte in frame(forged(2, padding="x" * 10**5)):
            tell(bytes([byte]))
            time.sleep(0.05)
    """),
    flood=talking("""
        for turn in range(2000):
            tell(frame(forged(turn, padding="x" * 60000)))
    """),
    garbage=talking("tell(os.urandom(100000))"),
    http=talking("tell(b'HTTP/1.1 200 OK\\r\\n\\r\\n' * 100)"),
    second_reply=talking(
        answers={
            "pose_step": """
                def pose_step(*args):
                    for number in range(60):
                        tell(frame(forged(number, interview=TALK | {"replies": [{"value": [0.0, 0.0, 0.0], "trouble": None, "inputs": [], "printed": "", "warned": []}] * 50})))
                    return [0.0, 0.0, 0.0]
            """
        }
    ),
    more_fields=talking("""
        sent = wire.send
        def send(stream, message, *more, **named):
            return sent(stream, message | {"verdict": RIGHT, "score": 1.0, "points": 40, "results": [RIGHT] * 8}, *more, **named)
        for module in list(sys.modules.values()):
            if getattr(module, "__dict__", {}).get("send") is sent:
                module.send = send
    """),
)
def test_082_talking_to_the_judge_gains_nothing(fate):
    assert fate.total <= POINTS
    assert all(result.score == 0 for name, result in fate.results.items() if name != "displacement")


@hands_in(
    orphan=talking("""
        if os.fork() == 0:
            os.setsid()
            time.sleep(0.3)
            for number in range(100):
                tell(frame(forged(number)))
                time.sleep(0.01)
            os._exit(0)
        os._exit(0)
    """),
    both=talking("""
        # two processes that answer the same questions
        os.fork()
    """),
    handed_on=talking("""
        # the child serves on, its parent is gone
        if os.fork():
            os._exit(0)
    """),
    passed_over=talking("""
        ours, theirs = socket.socketpair()
        if os.fork() == 0:
            _, fds, _, _ = socket.recv_fds(theirs, 10, 64)
            for number in range(60):
                tell(frame(forged(number)), fds)
            os._exit(0)
        socket.send_fds(ours, [b"fds"], [fd for fd in channels() if fd not in (ours.fileno(), theirs.fileno())])
        time.sleep(0.3)
    """),
)
def test_082_a_child_that_answers_in_its_parents_place_gains_nothing(fate):
    assert fate.total <= POINTS
    assert all(result.score == 0 for name, result in fate.results.items() if name != "displacement")


@hands_in(
    attack("""
        import json, os
        verdict = {"pose_step": {"score": 1.0, "passed": True}, "score": 40, "max_score": 40, "status": "graded", "tests": [{"score": 40}]}
        places = {os.getcwd(), "/tmp", os.environ.get("HOME", "/tmp"), "/dev/shm", "/box", "/", "/autograder", "/var/tmp", "@ROOT@"}
        written = 0
        for folder in places:
            for name in ("results.json", "results/results.json", "verdict.json", "scores.txt", "autograded/pose_update.ipynb",
                         "gradebook.db", "receipts/pose_update.json", "feedback.json", ".results", "result"):
                try:
                    path = os.path.join(folder, name)
                    os.makedirs(os.path.dirname(path), exist_ok=True)
                    with open(path, "w") as file:
                        json.dump(verdict, file)
                    written += 1
                except OSError:
                    pass
        print("written:", written)
    """)
)
def test_083_a_results_file_is_read_by_nobody(fate):
    assert fate.total == POINTS


_EVIL = f"/tmp/{MARK}-unpickled"


@hands_in(
    sent=talking(f"""
        import pickle
        class Evil:
            def __reduce__(self):
                return os.system, ("touch {_EVIL}",)
        evil = pickle.dumps(Evil())
        tell(evil)
        tell(struct.pack(">4sII", b"DR1\\n", len(evil), 0) + evil)
        tell(struct.pack(">Q", len(evil)) + evil)
    """),
    returned=talking(
        f"""
        import base64, pickle
        class Evil(list):
            def __reduce__(self):
                return os.system, ("touch {_EVIL}",)
        evil = Evil([0.0] * 3)
        print(base64.b64encode(pickle.dumps(evil)).decode())
        """,
        answers={
            "pose_step": "def pose_step(*args):\n    return evil",
            "q1_symbolic": "def q1_symbolic(*args):\n    return [evil, pickle.dumps(evil), pickle.dumps(evil).decode('latin-1')]",
            "dead_reckoning": "def dead_reckoning(*args):\n    raise ValueError(evil)",
        },
        lost=False,
    ),
    evaluated=talking(
        f"""
        code = "__import__('os').system('touch {_EVIL}')"
        class Shown(float):
            __repr__ = __str__ = lambda self: code
        """,
        answers={
            "pose_step": "def pose_step(*args):\n    return [code, Shown(1.0), {code: code}]",
            "q1_symbolic": "def q1_symbolic(*args):\n    return [sp.Symbol(code)] * 3",
            "dead_reckoning": "def dead_reckoning(*args):\n    return type(code, (), {})()",
            "pose_step_arc": "def pose_step_arc(*args):\n    raise type(code, (ValueError,), {})('{error} {0.__class__} %s ' + code)",
        },
        lost=False,
    ),
)
def test_084_nothing_that_a_notebook_sends_is_unpickled_or_evaluated(fate):
    assert not Path(_EVIL).exists()
    assert all(result.score == 0 for name, result in fate.results.items() if name != "displacement")


@hands_in(
    attack("""
        import logging.handlers, os, socket, struct, pickle
        reached = 0
        for port in (*range(1, 10000), *range(32768, 61000, 7)):
            with socket.socket(socket.AF_INET, socket.SOCK_STREAM) as connection:
                connection.settimeout(0.01)
                if connection.connect_ex(("127.0.0.1", port)) == 0:
                    reached += 1
                    print("LEAK port", port)
        handler = logging.handlers.SocketHandler("127.0.0.1", 9020)
        handler.raiseExceptions = logging.raiseExceptions = False
        logging.getLogger().addHandler(handler)
        logging.getLogger().error("score 40")
        logging.getLogger().removeHandler(handler)
        for path in ("/dev/log", "/run/systemd/journal/socket", "/var/run/docker.sock", "/run/dbus/system_bus_socket"):
            with socket.socket(socket.AF_UNIX) as connection:
                if connection.connect_ex(path) == 0:
                    print("LEAK socket", path)
        print("reached:", reached)
    """)
)
def test_085_there_is_no_other_way_to_the_grader(fate):
    assert fate.line("reached") == "0"
    assert fate.total == POINTS


_BOMBS = {
    "deep": "[" * 10**6,
    "deep_dictionaries": '{"@":' * 300_000,
    "digits": "9" * 10**6,
    "names": '{"id": 1' + "".join(f', "{n}": 0' for n in range(20)) + "}",
    "exponent": '{"id": 1e999999999}',
    "infinite": '{"id": Infinity, "outputs": NaN}',
    "surrogate": '{"id": "\\\\ud800"}',
    "self": '{"@": "dict", "items": [["id", {"@": "dict", "items": []}]]}',
}
_ARRAYS = {
    "object": '{"@": "array", "dtype": "object", "shape": [1]}',
    "void": '{"@": "array", "dtype": "V100000000", "shape": [1]}',
    "wide": '{"@": "array", "dtype": "float64", "shape": [4294967296, 4294967296, 4294967296]}',
    "empty_wide": '{"@": "array", "dtype": "float64", "shape": [0, 9223372036854775807]}',
    "negative": '{"@": "array", "dtype": "float64", "shape": [-1]}',
    "true": '{"@": "array", "dtype": "float64", "shape": [true, 1.0]}',
    "header": '{"@": "array", "dtype": "(100000,100000)f8", "shape": [1]}',
    "evaluated": '{"@": "array", "dtype": "__import__(\\\\"os\\\\").abort()", "shape": []}',
}


@hands_in(
    **{
        name: talking(
            f"text = {text!r}.encode()\ntell(struct.pack('>4sII', b'DR1\\n', len(text), 8) + text + b'x' * 8)\ntime.sleep(0.2)"
        )
        for name, text in (_BOMBS | _ARRAYS).items()
        if len(text) < 1000
    },
    deep=talking("text = b'[' * 10**6\ntell(struct.pack('>4sII', b'DR1\\n', len(text), 0) + text)\ntime.sleep(0.2)"),
    digits=talking("text = b'9' * 10**6\ntell(struct.pack('>4sII', b'DR1\\n', len(text), 0) + text)\ntime.sleep(0.2)"),
    patched=talking(
        """
        inner = '[' * 20000 + ']' * 20000
        """,
        answers={"pose_step": "def pose_step(*args):\n    json.dumps = lambda *args, **named: inner\n    return 1"},
    ),
)
def test_086_what_breaks_a_parser_breaks_only_that_submission(fate):
    assert all(result.score == 0 for name, result in fate.results.items() if name != "displacement")


# ways that are in no list


@hands_in(
    interview=talking("""
        import course.answers
        from course.answers import Interview, Reply
        fake = lambda answer, questions, *more: Interview(replies=tuple(Reply(value=question.args, inputs=question.args) for question in questions))
        for module in list(sys.modules.values()):
            for name in ("interview", "reply_to", "plain", "as_given", "identical"):
                if name in getattr(module, "__dict__", {}) and module.__name__.startswith(("course", "autograder", "__main__")):
                    setattr(module, name, fake if name == "interview" else lambda *args: 1.0)
        sys.modules["__main__"].__dict__["interview"] = fake
    """),
    every_reply=talking("""
        import gc, types
        gc.unfreeze()
        def ever(*args, **named):
            return {"outputs": [], "interview": TALK | {"replies": [{"value": [1.0, 2.0, 3.0], "trouble": None, "inputs": [[1.0, 2.0, 3.0]], "printed": "", "warned": []}] * 100}}
        for held in gc.get_objects():
            if type(held) is types.FunctionType and held.__name__ in ("_answer", "_answered", "_reply", "answered"):
                if held.__module__ in ("__main__", "autograder.sandbox.runner"):
                    held.__code__ = (lambda *args, **named: ever()).__code__
                    held.__globals__["ever"] = ever
    """),
    a_figure=talking("""
        import course.answers
        series = {"@": "dict", "items": []}
        shape = {"lines": [], "points": [], "labels": ["x [m]", "y [m]"], "title": "", "scales": ["linear", "linear"], "limits": np.zeros(4), "aspect": 1.0, "legend": []}
        fake = lambda *args, **named: course.answers.Interview(kind="axes", figure=shape)
        sys.modules["__main__"].__dict__["interview"] = course.answers.interview = fake
    """),
)
def test_replies_of_an_own_making_are_worth_only_the_answers_in_them(fate):
    assert all(result.score == 0 for name, result in fate.results.items() if name != "displacement")


@hands_in(
    slots=attack(
        """
        import ctypes, gc
        own = gc.get_referents(np.ndarray.__dict__)[0]
        right = np.zeros(3)
        own["tobytes"] = lambda self, *more: b"\\0" * self.nbytes
        own["copy"] = lambda self, *more: right
        ctypes.pythonapi.PyType_Modified(ctypes.py_object(np.ndarray))
    """,
        lost=None,
    ),
    small_numbers=attack(
        """
        import ctypes
        # 0.0 becomes 1.0 wherever this object is used
        zero = 0.0
        ctypes.c_double.from_address(id(zero) + 16).value = 1.0
        ctypes.c_long.from_address(id(False) + 24).value = 1
    """,
        lost=None,
    ),
    traced=attack("""
        import sys, threading
        def trace(frame, event, arg):
            for name in ("score", "passed", "verdict"):
                if name in frame.f_locals:
                    frame.f_locals[name] = 1.0
            return trace
        sys.settrace(trace)
        sys.setprofile(lambda *args: None)
        threading.settrace(trace)
    """),
    audited=attack(
        """
        import sys
        armed = False
        def audit(event, args):
            if armed and event in ("compile", "exec", "object.__getattr__"):
                raise RuntimeError(event)
        sys.addaudithook(audit)
        armed = True
    """,
        lost=None,
    ),
    alarmed=attack(
        """
        import signal
        signal.signal(signal.SIGALRM, signal.SIG_IGN)
        signal.signal = signal.setitimer = signal.alarm = lambda *args: (0.0, 0.0)
    """,
        lost=None,
    ),
)
def test_a_bent_interpreter_gains_nothing(fate):
    assert all(result.score == 0 for name, result in fate.results.items() if name != "displacement")


@hands_in(
    attack(
        """
        class Anything(dict):
            def __contains__(self, name):
                return True
            def __missing__(self, name):
                return lambda *args: np.asarray(args[0], dtype=float)
            def get(self, name, default=None):
                return self[name]

        shell = get_ipython()
        names = Anything(shell.user_ns)
        shell.user_ns = names
        shell.user_module.__dict__.update({"wheel_angle": lambda *args: 0.0})
        type(shell).user_global_ns = property(lambda self: names)
        """,
        answers={name: "" for name in EXERCISES if name != "displacement"},
    )
)
def test_a_namespace_that_holds_every_name_gains_nothing(fate):
    assert fate.total == POINTS


@hands_in(
    attack(
        """
        import unittest.mock
        mock = unittest.mock.MagicMock()
        mock.__eq__ = lambda *args: True
        """,
        answers={name: f"{name} = mock" for name in EXERCISES if name != "displacement"},
    ),
    class_=attack(answers={name: f"class {name}(np.ndarray): pass" for name in EXERCISES if name != "displacement"}),
    generator=attack(
        answers={name: f"def {name}(*args):\n    yield from np.zeros(3)" for name in EXERCISES if name != "displacement"}
    ),
    coroutine=attack(
        answers={name: f"async def {name}(*args):\n    return np.zeros(3)" for name in EXERCISES if name != "displacement"}
    ),
    check_itself=attack(answers={name: f"{name} = check" for name in EXERCISES if name != "displacement"}),
)
def test_answers_that_are_no_functions_of_numbers_gain_nothing(fate):
    assert fate.total == POINTS


def test_no_process_is_left(cohort):
    assert left_behind() == []

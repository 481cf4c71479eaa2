"""`check("name")` as a reader meets it: in IPython, in plain Python, in a full clone and in a student's bundle.

Each program runs in a Python of its own, because a shell, a chosen language and patched modules would stay behind.
"""

import ast
import json
import shutil
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

from autograder import building
from tests.contents import table_of_contents

ROOT = Path(__file__).resolve().parents[2]

RIGHT = """
def pose_step(pose, distance, dtheta):
    x, y, theta = pose
    return np.array([x + distance * np.cos(theta), y + distance * np.sin(theta), theta + dtheta])
"""
WRONG = RIGHT.replace("theta + dtheta", "theta - dtheta")
PARTLY = RIGHT.replace("y + distance", "y - distance")

#: runs notebook cells as a kernel does, and prints what each of them put out
SHELL = """
import json, sys
from IPython.core.displayhook import DisplayHook
from IPython.core.displaypub import DisplayPublisher
from IPython.core.interactiveshell import InteractiveShell
from traitlets import Type
from traitlets.config import Config

outputs = []

class Publisher(DisplayPublisher):
    def publish(self, data, metadata=None, **more):
        outputs.append({"type": "display_data", "data": data})

class Hook(DisplayHook):
    def write_output_prompt(self):
        pass

    def write_format_data(self, format_dict, md_dict=None):
        outputs.append({"type": "execute_result", "data": dict(format_dict)})

class Shell(InteractiveShell):
    displayhook_class = Type(Hook)
    display_pub_class = Type(Publisher)

    def enable_gui(self, gui=None):
        pass

    def _showtraceback(self, etype, evalue, stb):
        outputs.append({"type": "error", "ename": etype.__name__, "evalue": str(evalue), "traceback": list(stb)})

config = Config()
config.HistoryManager.enabled = False
shell = Shell.instance(config=config)
told = []
for cell in CELLS:
    outputs.clear()
    shell.run_cell(cell, store_history=True)
    told.append(list(outputs))
print("TOLD" + json.dumps(told))
"""

#: only `course`, in a folder of its own, as in a student's bundle
BUNDLED = """
import sys
sys.meta_path[:] = [finder for finder in sys.meta_path if "editable" not in f"{finder!r} {getattr(finder, '__module__', '')}"]
sys.path.insert(0, BUNDLE)
"""


def python(program, folder, *options):
    return subprocess.run(
        [sys.executable, "-I", "-B", "-W", "error::DeprecationWarning:__main__", *options, "-c", textwrap.dedent(program)],
        cwd=folder,
        capture_output=True,
        text=True,
        check=False,
        encoding="utf-8",
    )


def printed(program, folder):
    done = python(program, folder)
    assert done.returncode == 0, done.stderr
    return done.stdout


def notebook(cells, folder, before=""):
    """What each cell put out, run in an IPython of its own."""
    told = printed(f"{before}\nCELLS = {list(cells)!r}\n{SHELL}", folder).partition("TOLD")[2]
    return json.loads(told)


@pytest.fixture(scope="module")
def bundle(tmp_path_factory):
    """A folder with `course` and the public examples, and no autograder."""
    folder = tmp_path_factory.mktemp("bundle")
    shutil.copytree(ROOT / "course", folder / "course", ignore=shutil.ignore_patterns("__pycache__"))
    with table_of_contents({"odometry/pose_update": ("pose_step", "q1_symbolic")}, {}):
        (folder / "course/examples.json").write_bytes(building._examples())
    return folder


EDITIONS = {
    "en": ("pose_step: correct", "pose_step: not right yet", "dtheta is subtracted", "Right already: turning on the spot"),
    "ja": ("pose_step: 正解です", "pose_step: まだ正しくありません", "dtheta を引いています", "できている入力: その場旋回"),
}


@pytest.fixture(scope="module")
def editions(tmp_path_factory):
    """The outputs of one notebook in both editions."""
    return {
        language: notebook(
            [
                f"from course.{language} import check\nimport numpy as np",
                RIGHT,
                'check("pose_step")',
                WRONG,
                'check("pose_step")',
                "done = check('pose_step')" if language == "en" else "1",
                PARTLY,
                'check("pose_step")',
                "del pose_step",
                'check("pose_step")',
                'check("pose_stepp")',
            ],
            tmp_path_factory.mktemp(language),
        )
        for language in EDITIONS
    }


@pytest.mark.parametrize("language", EDITIONS)
def test_a_passed_check_displays_itself_and_has_no_result(editions, language):
    [shown] = editions[language][2]
    assert shown["type"] == "display_data"
    assert set(shown["data"]) == {"text/plain", "text/html"}
    assert shown["data"]["text/plain"].startswith(f"✓ {EDITIONS[language][0]}\n")
    assert EDITIONS[language][0] in shown["data"]["text/html"]
    assert shown["data"]["text/html"].startswith('<div role="status"')
    assert f'lang="{language}"' in shown["data"]["text/html"]


@pytest.mark.parametrize("language", EDITIONS)
def test_a_failed_check_displays_its_message_and_one_line_of_error(editions, language):
    shown, error = editions[language][4]
    _, headline, cause, _ = EDITIONS[language]
    assert shown["type"] == "display_data"
    for text in (shown["data"]["text/plain"], shown["data"]["text/html"]):
        assert headline in text
        assert cause in text
    assert error["type"] == "error"
    assert error["ename"] == "CheckFailed"
    assert error["evalue"] == shown["data"]["text/plain"]
    [line] = error["traceback"]
    assert headline in line
    assert "\n" not in line
    assert "Traceback" not in line


@pytest.mark.parametrize("language", EDITIONS)
def test_a_check_that_is_partly_right_says_what_is(editions, language):
    shown, error = editions[language][7]
    assert shown["data"]["text/plain"].startswith("◐")
    assert error["ename"] == "CheckFailed"
    assert EDITIONS[language][3] in shown["data"]["text/plain"]


def test_a_check_fails_wherever_it_stands_in_a_cell(editions):
    assert [output["type"] for output in editions["en"][5]] == ["display_data", "error"]


@pytest.mark.parametrize(("language", "words"), [("en", "not defined yet"), ("ja", "まだ定義されていません")])
def test_a_missing_answer_is_looked_for_in_the_cells(editions, language, words):
    shown, _ = editions[language][9]
    assert words in shown["data"]["text/plain"]


def test_an_unknown_exercise_is_an_error_that_names_the_known_ones(editions):
    [error] = editions["en"][10]
    assert error["ename"] == "KeyError"
    assert "no exercise is called 'pose_stepp'" in error["evalue"]
    assert "pose_step, q1_symbolic" in error["evalue"]


INSIDE = "def outer():\n" + textwrap.indent(RIGHT, "    ")
BROKEN = RIGHT.replace("dtheta):", "dtheta)")

MISSING = [
    ([RIGHT.replace("pose_step", "posestep")], "similar name, posestep"),
    ([INSIDE], "defined inside outer"),
    ([BROKEN], "cannot read the cell"),
    ([RIGHT, "pose_step = pose_step([0, 0, 0], 1, 1)"], "where a function is asked for"),
    ([RIGHT, "In = 3"], "pose_step: correct"),
    (["In = 3"], "not defined yet"),
]


def test_what_went_wrong_before_the_check_is_told(tmp_path):
    cells = ["from course.en import check\nimport numpy as np"]
    for sources, _ in MISSING:
        cells += [*sources, 'check("pose_step")', "%reset_selective -f ^(pose_?step|outer|In)$"]
    told = iter(notebook(cells, tmp_path)[1:])
    for sources, words in MISSING:
        for _ in sources:
            next(told)
        assert words in next(told)[0]["data"]["text/plain"]
        next(told)


def test_plain_python_passes_quietly_and_fails_in_words(tmp_path):
    program = f"""
from course.en import check
import numpy as np
{RIGHT}
result = check("pose_step")
print(repr(result))
{WRONG}
try:
    check("pose_step")
except AssertionError as error:
    print("FAILED", type(error).__name__, str(error))
"""
    out = printed(program, tmp_path)
    assert out.startswith("✓ pose_step: correct\nTried with: ")
    assert "FAILED CheckFailed ✗ pose_step: not right yet\ndtheta is subtracted" in out


def test_the_answer_is_looked_for_where_check_is_called(tmp_path):
    (tmp_path / "mine.py").write_text(f"from course.en import check\nimport numpy as np\n{RIGHT}\nprint(check('pose_step'))\n")
    program = "import sys; sys.path.insert(0, '.'); pose_step = None; import mine"
    assert printed(program, tmp_path).startswith("✓ pose_step: correct")


def test_a_failed_check_fails_a_script(tmp_path):
    done = python(f"from course.ja import check\nimport numpy as np\n{WRONG}\ncheck('pose_step')", tmp_path)
    assert done.returncode == 1
    assert "まだ正しくありません" in done.stderr


def test_a_bundle_answers_from_the_public_examples_and_says_so(bundle):
    cells = [
        "from course.en import check\nimport numpy as np\nimport importlib.util\nimport course",
        RIGHT,
        'check("pose_step")',
        WRONG,
        'check("pose_step")',
        'check("nonsense")',
        "(importlib.util.find_spec('autograder') is None, course.__file__)",
    ]
    _, _, passed, _, failed, unknown, where = notebook(cells, bundle, BUNDLED.replace("BUNDLE", repr(str(bundle))))
    assert passed[0]["type"] == "display_data"
    assert passed[0]["data"]["text/plain"].startswith("✓ pose_step: the public examples are right\n")
    assert "checked with many more inputs" in passed[0]["data"]["text/html"]
    shown, error = failed
    assert "the example says" in shown["data"]["text/plain"]
    assert error["ename"] == "CheckFailed"
    assert "no exercise is called 'nonsense'; there are: pose_step, q1_symbolic" in unknown[0]["evalue"]
    no_autograder, file = ast.literal_eval(where[0]["data"]["text/plain"])
    assert no_autograder
    assert Path(file) == bundle / "course/__init__.py"


def test_a_students_file_called_autograder_is_no_judge(bundle, tmp_path):
    (tmp_path / "autograder.py").write_text("reference = None")
    program = BUNDLED.replace("BUNDLE", repr(str(bundle))) + (
        f"sys.path.insert(0, {str(tmp_path)!r})\nfrom course.en import check\nimport numpy as np\n{RIGHT}\nprint(check('pose_step'))"
    )
    assert printed(program, tmp_path).startswith("✓ pose_step: the public examples are right")


def test_a_bundle_holds_no_answer_but_the_examples(bundle):
    entries = json.loads((bundle / "course/examples.json").read_text(encoding="utf-8"))
    assert list(entries) == ["pose_step", "q1_symbolic"]
    for entry in entries.values():
        assert 2 <= len(entry["examples"]) <= 3


HEAVY = {"matplotlib", "scipy", "sympy", "IPython", "ipywidgets", "nbgrader", "autograder", "pandas"}


@pytest.mark.parametrize("module", ["course", "course.en", "course.ja", "course.checking", "course.examples"])
def test_importing_the_course_is_light(module, tmp_path):
    loaded = printed(f"import sys, {module}\nprint(*sys.modules)", tmp_path).split()
    assert module in loaded
    assert HEAVY.isdisjoint(name.partition(".")[0] for name in loaded)
    if module == "course":
        assert "numpy" not in loaded


def test_importing_leaves_pythons_settings_alone(tmp_path):
    program = """
    import signal, sys, warnings
    import numpy as np
    def settings():
        return warnings.filters[:], np.geterr(), signal.getsignal(signal.SIGALRM), sys.getrecursionlimit(), sys.excepthook
    before = settings()
    import course.en
    print(settings() == before)
    """
    assert printed(program, tmp_path) == "True\n"

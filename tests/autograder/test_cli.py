import io
import json
import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
from rich.console import Console
from typer.testing import CliRunner

from autograder import batch
from autograder.cli import app, class_table, exercise_table, write_json
from autograder.grading import GradedNotebook, Result, notebook_names

ROOT = Path(__file__).parents[2]


def call(*arguments):
    """What a command prints, and its exit code."""
    done = CliRunner().invoke(app, [*map(str, arguments)])
    assert done.exception is None or isinstance(done.exception, SystemExit), done.exception
    return " ".join(done.output.split()), done.exit_code


# help


def test_help_lists_every_command_with_what_it_does():
    text, code = call("--help")
    assert code == 0
    for command, does in {
        "build": "Make the student notebooks",
        "grade": "Grade what students handed in",
        "check": "Grade one notebook",
        "demo": "Make a sample class of 12",
    }.items():
        assert command in text
        assert does in text


HELP = {
    "build": ["source/", "--verify", "in CI", "--root"],
    "grade": [
        "submitted/STUDENT/ASSIGNMENT/",
        "such as odometry",
        "'s2*'",
        "--workers",
        "one for each processor",
        "--json",
        "--no-sandbox",
    ],
    "check": ["release/en/odometry/pose_update.ipynb", "No gradebook is touched", "--no-sandbox"],
    "demo": ["build/demo/", "compare with what each should get", "--workers"],
}


@pytest.mark.parametrize(("command", "taught"), HELP.items(), ids=HELP.keys())
def test_the_help_of_a_command_says_where_things_lie_and_gives_examples(command, taught):
    text, code = call(command, "--help")
    assert code == 0
    assert [words for words in taught if words not in text.replace("│ ", "")] == []


@pytest.mark.parametrize(
    "arguments", [["grade"], ["nosuch"], ["grade", "odometry", "--workers", "-1"], ["grade", "odometry", "--nosuch"]]
)
def test_a_wrong_call_says_what_is_wrong(arguments):
    text, code = call(*arguments)
    assert code == 2
    assert "Usage" in text


# build


def test_build_makes_and_verify_only_looks(small_course):
    assert call("build", "--verify", "--root", small_course) == (
        "course/examples.json: missing release/en/odometry/pose_update.ipynb: missing "
        "release/ja/odometry/pose_update.ipynb: missing "
        "error: 3 generated files are not what the sources make. Type: autograder build",
        1,
    )
    assert not (small_course / "release").exists()
    text, code = call("build", "--root", small_course)
    assert (text.endswith("4 files brought up to date."), code) == (True, 0)
    for command in (["build"], ["build", "--verify"]):
        assert call(*command, "--root", small_course) == ("Everything that is generated is up to date.", 0)


def test_build_tells_mistakes_in_the_sources(small_course, small_source):
    (small_course / "source/odometry/pose_update.md").write_text(
        small_source.replace("exercise: pose_step", "exercise: '[bold]'")
    )
    text, code = call("build", "--root", small_course)
    assert code == 1
    assert "error: source/odometry/pose_update.md, cell 10" in text
    assert "[bold]" in text  # not taken for markup


# grade: what can be told before anything runs


@pytest.fixture
def nothing_runs(monkeypatch):
    def fail(*_):
        pytest.fail("it started to grade")

    monkeypatch.setattr(batch, "graded", fail)


@pytest.mark.usefixtures("nothing_runs")
def test_an_unknown_assignment(class_root):
    assert call("grade", "imu", "--root", class_root) == ("error: no assignment is called 'imu'; there are: odometry", 1)
    assert not (class_root / "gradebook.db").exists()


@pytest.mark.usefixtures("nothing_runs")
def test_nobody_handed_in(class_root, hand_in):
    hand_in("ann", pose_update=b"")
    text, code = call("grade", "odometry", "--student", "b*", "--no-sandbox", "--root", class_root)
    assert code == 1
    assert "nobody handed in 'odometry': there is no folder that fits" in text
    assert "submitted/b*/odometry" in text
    assert not (class_root / "gradebook.db").exists()


@pytest.mark.usefixtures("nothing_runs")
@pytest.mark.parametrize("command", [["grade", "odometry", "--no-sandbox"], ["demo", "--no-sandbox"]])
def test_no_release(class_root, hand_in, command):
    hand_in("ann", pose_update=b"")
    (class_root / "release/en/odometry/encoders.ipynb").unlink()
    text, code = call(*command, "--root", class_root)
    assert (text, code) == ("error: not built yet: release/en/odometry/encoders.ipynb. Type: autograder build", 1)
    assert not (class_root / "gradebook.db").exists()


@pytest.mark.usefixtures("class_contents")
def test_a_release_of_which_the_editions_differ(class_root, hand_in, empty_gradebook, monkeypatch):
    hand_in("ann", pose_update=b"")
    monkeypatch.setattr(batch, "graded", lambda works, _: iter([*works][:0]))
    shutil.copy(empty_gradebook, class_root / "gradebook.db")
    path = class_root / "release/en/odometry/encoders.ipynb"
    path.write_text(path.read_text().replace('"points": 5', '"points": 6'))
    text, code = call("grade", "odometry", "--no-sandbox", "--root", class_root)
    assert code == 1
    assert "error: odometry: the editions in release/ differ" in text


@pytest.mark.usefixtures("nothing_runs")
@pytest.mark.parametrize("command", [["grade", "odometry"], ["check", "pose_update.ipynb"]])
def test_no_sandbox_on_this_machine(class_root, hand_in, monkeypatch, command):
    hand_in("ann", pose_update=b"")
    monkeypatch.setenv("PATH", "/nonexistent")
    text, code = call(*command, "--root", class_root)
    assert (text, code) == (
        "error: bubblewrap is not installed. Type: apt-get install bubblewrap (or pass --no-sandbox for work that you trust).",
        1,
    )


@pytest.mark.usefixtures("class_contents")
def test_stopped_by_the_ta(class_root, hand_in, empty_gradebook, monkeypatch):
    def interrupted(works, _):
        next(iter(works))
        raise KeyboardInterrupt
        yield

    hand_in("ann", pose_update=b"")
    hand_in("bob", pose_update=b"")
    shutil.copy(empty_gradebook, class_root / "gradebook.db")
    monkeypatch.setattr(batch, "graded", interrupted)
    text, code = call("grade", "odometry", "--no-sandbox", "--root", class_root)
    assert code == 1
    assert "Stopped. What was graded so far is in the gradebook; type the same command again for the rest." in text


# check: one notebook


@pytest.mark.usefixtures("nothing_runs", "class_contents")
def test_a_file_that_is_none_of_the_courses_notebooks(tmp_path):
    text, code = call("check", tmp_path / "mine.ipynb", "--no-sandbox")
    assert (text, code) == ("error: mine.ipynb is none of the course's notebooks: pose_update.ipynb, encoders.ipynb", 1)


@pytest.mark.usefixtures("nothing_runs")
def test_a_notebook_that_is_not_there(class_root):
    text, code = call("check", class_root / "pose_update.ipynb", "--no-sandbox", "--root", class_root)
    assert code == 1
    assert text.endswith("pose_update.ipynb: This notebook was not handed in.")


def test_check_shows_points_and_messages_and_touches_no_gradebook(class_root, answered):
    notebook = class_root / "pose_update.ipynb"
    notebook.write_bytes(answered(displacement="def displacement(V, omega, dt):\n    return np.array([V, 0.0, omega])"))
    text, code = call("check", notebook, "--no-sandbox", "--root", class_root)
    assert code == 0
    assert "pose_update: 5 / 10" in text
    assert "5 / 5" in text
    assert "0 / 5" in text
    assert "by hand" in text
    assert not (class_root / "gradebook.db").exists()
    assert not (class_root / "autograded").exists()


@pytest.mark.sandbox
def test_check_works_on_the_courses_own_notebook(root):
    text, code = call("check", root / "release/en/odometry/encoders.ipynb", "--root", root)
    assert code == 0
    assert "encoders: 0 / 50" in text


# a class, from a shell


def test_grade_fills_gradebook_autograded_and_json_and_prints_a_row_for_each_student(tmp_path):
    """Three students, of whom two are asked for; a new gradebook, and the environment is not activated."""
    from nbgrader.api import Gradebook

    shutil.copytree(ROOT / "release", tmp_path / "release")
    shutil.copy(ROOT / "nbgrader_config.py", tmp_path)
    english = (ROOT / "release/en/odometry/encoders.ipynb").read_bytes()
    for student, content in {"s1": english, "s2": b"broken", "other": b"broken"}.items():
        folder = tmp_path / "submitted" / student / "odometry"
        folder.mkdir(parents=True)
        (folder / "encoders.ipynb").write_bytes(content)
    programs = str(Path(sys.executable).parent)
    path = os.pathsep.join(folder for folder in os.environ["PATH"].split(os.pathsep) if folder != programs)
    done = subprocess.run(
        [
            *(sys.executable, "-m", "autograder.cli", "grade", "odometry", "--student", "s*", "--workers", "1"),
            *("--json", "out/scores.json", "--no-sandbox"),
        ],
        cwd=tmp_path,
        env={**os.environ, "PATH": path, "PYTHONPATH": str(ROOT)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 0, done.stderr

    printed = {words[1]: " ".join(words) for line in done.stdout.splitlines() if len(words := line.split()) > 3}
    assert "0 / 50" in printed["s1"]
    assert "pose_update: missing, encoders:" in printed["s2"]
    assert "other" not in printed

    rows = [json.loads(line) for line in (tmp_path / "out/scores.json").read_text(encoding="utf-8").splitlines()]
    assert [*rows[0]] == [
        *("student", "assignment", "notebook", "exercise", "score", "max_score", "message", "misconception", "status")
    ]
    assert {(row["student"], row["notebook"]): row["status"] for row in rows} == {
        **{(student, name): "missing" for student in ("s1", "s2") for name in notebook_names("odometry")},
        ("s1", "encoders"): "graded",
        ("s2", "encoders"): "unreadable",
    }
    # an English edition is answered in English, and so is the notebook that is missing beside it
    missing = {row["message"] for row in rows if row["student"] == "s1" and row["status"] == "missing"}
    assert missing == {"This notebook was not handed in."}
    assert all("ノートブック" in row["message"] for row in rows if row["student"] == "s2")

    with Gradebook(f"sqlite:///{tmp_path}/gradebook.db", "dead-reckoning") as gradebook:
        scores = {submission.student.id: submission.score for submission in gradebook.assignment_submissions("odometry")}
    assert scores == {"s1": 0, "s2": 0}
    assert sorted(path.relative_to(tmp_path).as_posix() for path in tmp_path.glob("autograded/*/*/*")) == [
        f"autograded/{student}/odometry/{name}.ipynb" for student in ("s1", "s2") for name in sorted(notebook_names("odometry"))
    ]


# tables

RESULTS = [
    Result("[red]ann", "odometry", "a", "one", 1.5, 5.0, "[bold]said", "sin_cos_exchanged"),
    Result("[red]ann", "odometry", "a", "two", None, 10.0, "by hand", status="manual"),
    Result("[red]ann", "odometry", "b", "three", 0.0, 5.0, "gone", status="missing"),
    Result("bob", "odometry", "a", "one", 5.0, 5.0, "fine"),
]


def shown(table):
    console = Console(width=120, record=True, file=io.StringIO())
    console.print(table)
    return console.export_text()


def test_the_table_of_a_class():
    ann, bob = (line for line in shown(class_table("odometry", RESULTS)).splitlines() if "ann" in line or "bob" in line)
    assert [cell.strip() for cell in ann.strip("│").split("│")] == [
        *("[red]ann", "1.5 / 5", "0 / 5", "one: sin_cos_exchanged", "a: manual, b: missing")
    ]
    assert [cell.strip() for cell in bob.strip("│").split("│")][:2] == ["bob", "5 / 5"]


def test_the_table_of_a_notebook():
    text = shown(exercise_table(GradedNotebook("a", "en", tuple(RESULTS[:2]), b"")))
    assert "a: 1.5 / 5" in text
    assert "1.5 / 5" in text
    assert "by hand" in text
    assert "[bold]said" in text


def test_json_keeps_japanese_readable_and_is_written_whole(tmp_path):
    write_json(tmp_path / "new/scores.json", [Result("学生", "odometry", "a", "one", None, 5.0, "正解です")])
    [line] = (tmp_path / "new/scores.json").read_text(encoding="utf-8").splitlines()
    assert '"学生"' in line
    assert json.loads(line)["score"] is None

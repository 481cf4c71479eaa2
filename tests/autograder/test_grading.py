import io
import json
import re

import nbformat
import pytest

from autograder import grading
from autograder.grading import (
    OtherVersionError,
    Work,
    graded_from_plain,
    graded_plainly,
    graded_submission,
    notebook_names,
    plain_work,
    result_row,
)
from autograder.intake import NOT_HANDED_IN
from autograder.receipts import exercises_hash
from autograder.released import released
from autograder.sandbox.wire import receive, unpacked_interview
from autograder.session import Limits, SessionEndedError
from autograder.submissions import release_notebooks
from autograder.warm_server import NoSandboxError
from course.language import Text
from course.verdict import Verdict
from tests.contents import table_of_contents

POINTS = {"pose_step": 5.0, "displacement": 5.0, "q1_derivation": 10.0, "distance_per_count": 5.0}
WRONG_SIN_COS = (
    "def pose_step(pose, distance, dtheta):\n    x, y, theta = pose\n"
    "    return np.array([x + distance * np.sin(theta), y + distance * np.cos(theta), theta + dtheta])"
)

pytestmark = pytest.mark.usefixtures("class_contents")


@pytest.fixture
def grade(class_release, class_contents):
    """Returns a function that grades notebooks, given by name, and returns (results by exercise, graded notebooks by name)."""
    release = release_notebooks(class_release, "odometry")

    def run(sandbox=False, limits=None, seeds=(), **notebooks):
        work = Work("ann", "odometry", notebooks, release, sandbox, limits=limits or Limits(check=2.0), seeds=dict(seeds))
        made = graded_submission(work)
        return {result.exercise: result for notebook in made for result in notebook.results}, {n.notebook: n for n in made}

    return run


def without_cells(*names):
    """An edit that deletes the cells with these grade ids."""

    def edit(notebook):
        notebook["cells"] = [c for c in notebook["cells"] if c["metadata"].get("nbgrader", {}).get("grade_id") not in names]

    return edit


def with_cell(source, after, kind="code"):
    """An edit that puts a cell of the student's own behind the cell with the grade id `after` (None: first)."""

    def edit(notebook):
        cell = {"cell_type": kind, "source": source, "metadata": {}}
        ids = [c["metadata"].get("nbgrader", {}).get("grade_id") for c in notebook["cells"]]
        notebook["cells"].insert(0 if after is None else ids.index(after) + 1, cell)

    return edit


def outputs(graded, source):
    """The outputs of the cell whose source begins like this."""
    cells = json.loads(graded.executed)["cells"]
    return next(cell["outputs"] for cell in cells if "".join(cell["source"]).startswith(source))


# one submission, many sides


@pytest.fixture(scope="module")
def honest(class_release, answered):
    """A submission with one right and one recognised answer, an own check, a demonstration left alone, and one changed."""

    def edit(notebook):
        with_cell("print('own cell')\ncheck('pose_step')", "check_pose_step")(notebook)
        with_cell("1 / 0", None)(notebook)
        notebook["cells"].append({"cell_type": "code", "source": 'print("a picture, changed")', "metadata": {"tags": ["demo"]}})

    data = answered("pose_update", "en", edit, pose_step=WRONG_SIN_COS)
    with table_of_contents({"odometry/pose_update": ("pose_step", "displacement")}, {"odometry/pose_update": ("q1_derivation",)}):
        release = release_notebooks(class_release, "odometry")
        [graded] = graded_submission(Work("ann", "odometry", {"pose_update": data}, release, sandbox=False))
    return graded


def test_points_messages_and_misconceptions(honest):
    wrong, right, written = honest.results
    assert (wrong.exercise, wrong.score, wrong.max_score, wrong.misconception) == ("pose_step", 0.5555, 5.0, "sin_cos_exchanged")
    assert (right.exercise, right.score, right.max_score, right.misconception) == ("displacement", 5.0, 5.0, None)
    assert (written.exercise, written.score, written.max_score, written.status) == ("q1_derivation", None, 10.0, "manual")
    assert {wrong.status, right.status} == {"graded"}
    assert wrong.message.startswith("sin and cos are exchanged")


def test_results_are_plain_rows(honest):
    row = json.loads(json.dumps(result_row(honest.results[0])))
    assert row["student"] == "ann"
    assert row["notebook"] == "pose_update"


def test_an_error_in_a_cell_does_not_stop_the_notebook(honest):
    assert outputs(honest, "1 / 0")[0]["ename"] == "ZeroDivisionError"


def test_a_student_calling_check_counts_for_nothing_and_runs_like_any_cell(honest):
    shown = outputs(honest, "print('own cell')")
    assert shown[0]["text"] == "own cell\n"
    assert honest.results[0].score == 0.5555


def test_a_demonstration_left_alone_is_not_run_and_a_changed_one_is(honest):
    assert outputs(honest, 'print("a picture")') == []
    assert outputs(honest, 'print("a picture, changed")')[0]["text"] == "a picture, changed\n"


def test_verdicts_stand_where_the_checks_were(honest):
    assert outputs(honest, 'check("pose_step")')[0]["ename"] == "CheckFailed"
    assert outputs(honest, 'check("displacement")')[0]["output_type"] == "display_data"


def test_the_executed_notebook_is_valid(honest):
    nbformat.validate(nbformat.reads(honest.executed.decode(), as_version=4))


# whatever is handed in

UNREADABLE = {
    "not handed in": (NOT_HANDED_IN, "missing"),
    "a link": (Text("There is no ordinary file", "ありません"), "unreadable"),
    "empty": (b"", "unreadable"),
    "broken": (b'{"cells": [', "unreadable"),
    "deep": (b"[" * 10**6, "unreadable"),
    "a list": (b"[]", "unreadable"),
    "cells are a number": (b'{"cells": 5}', "unreadable"),
    "bytes": (bytes(range(256)), "unreadable"),
}


@pytest.mark.parametrize(("handed_in", "status"), UNREADABLE.values(), ids=UNREADABLE.keys())
def test_what_cannot_be_read_gets_zeros_with_a_reason(grade, handed_in, status):
    results, graded = grade(pose_update=handed_in)
    assert {name: (r.score, r.max_score, r.status) for name, r in results.items()} == {
        name: (0.0, POINTS[name], status) for name in ("pose_step", "displacement", "q1_derivation")
    }
    assert len({r.message for r in results.values()}) == 1
    assert results["pose_step"].message
    # something to look at is there all the same, with a place for each score
    made = nbformat.reads(graded["pose_update"].executed.decode(), as_version=4)
    nbformat.validate(made)
    assert [c.metadata.nbgrader.grade_id for c in made.cells if "nbgrader" in c.metadata] == [
        *("q1_derivation", "pose_step", "check_pose_step", "displacement", "check_displacement")
    ]


def test_the_reason_comes_in_the_language_of_the_other_notebook_or_of_the_broken_one(grade, monkeypatch):
    monkeypatch.setattr(grading._Run, "all_cells", lambda *_: None)
    english = b'{"cells": [{"cell_type": "code", "source": "from course.en import check"}]}'
    missing, _ = grade(pose_update=english, encoders=NOT_HANDED_IN)
    assert missing["distance_per_count"].message == NOT_HANDED_IN.en
    broken, _ = grade(pose_update=english[:-3])
    assert broken["pose_step"].message.startswith("The file is not a readable notebook")
    nothing, _ = grade(pose_update=NOT_HANDED_IN)
    assert nothing["pose_step"].message == NOT_HANDED_IN.ja


@pytest.mark.parametrize(("language", "nothing"), [("en", "Nothing is written here yet."), ("ja", "解答が書かれていません。")])
def test_the_stub_as_it_came_gets_zeros_in_the_language_of_the_edition(grade, class_release, language, nothing):
    results, graded = grade(pose_update=(class_release / f"release/{language}/odometry/pose_update.ipynb").read_bytes())
    assert {name: r.score for name, r in results.items()} == {"pose_step": 0.0, "displacement": 0.0, "q1_derivation": 0.0}
    assert graded["pose_update"].language == language
    assert results["q1_derivation"].message == nothing
    assert bool(re.search("[ぁ-ん]", results["pose_step"].message)) == (language == "ja")


def test_no_cells_at_all(grade):
    results, _ = grade(pose_update=b'{"cells": []}')
    assert (results["pose_step"].score, results["displacement"].score) == (0.0, 0.0)
    # its text may stand elsewhere
    assert (results["q1_derivation"].score, results["q1_derivation"].status) == (None, "manual")


def test_deleted_moved_and_copied_cells_cost_nothing(grade, answered):
    def edit(notebook):
        without_cells("check_displacement")(notebook)
        cells = notebook["cells"]
        [check] = [c for c in cells if c["metadata"].get("nbgrader", {}).get("grade_id") == "check_pose_step"]
        cells.remove(check)
        cells.insert(0, {**check, "cell_type": "markdown", "source": "moved, retyped and edited", "metadata": check["metadata"]})
        cells.append({**check, "source": "raise SystemExit"})

    results, _ = grade(pose_update=answered(edit=edit))
    assert (results["pose_step"].score, results["displacement"].score) == (5.0, 5.0)


def test_forged_metadata_and_outputs_count_for_nothing(grade, answered):
    def edit(notebook):
        for cell in notebook["cells"]:
            ours = cell["metadata"].get("nbgrader")
            if ours is not None:
                ours.update(points=1000, locked=False, grade=False, solution=False, schema_version=99)
            cell["metadata"]["tags"] = ["skip-execution", "demo"]
            cell["outputs"] = [{"output_type": "execute_result", "data": {"text/plain": "1000"}, "metadata": {}}]
        notebook["metadata"] = {"kernelspec": {"name": "evil"}}

    results, graded = grade(pose_update=answered(edit=edit, pose_step=WRONG_SIN_COS))
    assert (results["pose_step"].score, results["displacement"].score) == (0.5555, 5.0)
    assert results["pose_step"].max_score == 5.0
    made = json.loads(graded["pose_update"].executed)
    assert "1000" not in graded["pose_update"].executed.decode()
    assert made["metadata"]["kernelspec"]["name"] == "python3"


def test_a_written_answer_whose_metadata_is_lost_is_looked_at_by_a_person(grade, answered):
    def edit(notebook):
        without_cells("q1_derivation")(notebook)
        with_cell("Because.", None, "markdown")(notebook)

    results, graded = grade(pose_update=answered(edit=edit))
    assert (results["q1_derivation"].score, results["q1_derivation"].status) == (None, "manual")
    assert "q1_derivation" in graded["pose_update"].executed.decode()


def test_an_answer_that_ends_the_process_leaves_what_was_judged_before(grade, answered):
    results, graded = grade(
        pose_update=answered(displacement="import os\ndef displacement(*args): os._exit(0)"), encoders=answered("encoders")
    )
    assert {name: (r.score, r.status) for name, r in results.items()} == {
        "pose_step": (5.0, "graded"),
        "displacement": (0.0, "stopped"),
        "q1_derivation": (None, "manual"),
        "distance_per_count": (5.0, "graded"),
    }
    assert "process ended" in results["displacement"].message
    assert outputs(graded["pose_update"], 'check("pose_step")')[0]["output_type"] == "display_data"
    assert outputs(graded["pose_update"], 'check("displacement")') == []


def test_a_cell_that_ends_the_process_leaves_zeros_with_the_reason(grade, answered):
    results, _ = grade(pose_update=answered("pose_update", "ja", with_cell("import os\nos.abort()", None)))
    assert {r.status for r in results.values()} == {"stopped", "manual"}
    assert (results["pose_step"].score, results["displacement"].score) == (0.0, 0.0)
    assert "プロセスが終了" in results["pose_step"].message


def test_an_answer_that_never_ends_costs_only_its_own_points(grade, answered):
    endless = "def pose_step(*args):\n    while True: pass"
    results, _ = grade(limits=Limits(check=1.0), pose_update=answered(pose_step=endless))
    assert (results["pose_step"].score, results["displacement"].score) == (0.0, 5.0)
    assert results["pose_step"].status == "graded"


def test_messages_hold_nothing_that_acts_or_hides(grade, answered):
    raising = "def pose_step(*args):\n    raise ValueError('\\x1b[31m \\u202e \\ud800 \\0 <script>')"
    message = grade(pose_update=answered(pose_step=raising))[0]["pose_step"].message
    message.encode()
    assert not set("\x1b\u202e\0") & set(message)


@pytest.mark.sandbox
def test_the_sandbox_changes_no_score(grade, answered):
    def scores(sandbox):
        data = answered("pose_update", "ja", pose_step=WRONG_SIN_COS, displacement="def displacement(*a): return [1]")
        results, graded = grade(sandbox=sandbox, pose_update=data, seeds={"pose_step": 1, "displacement": 2})
        return results, json.loads(graded["pose_update"].executed)

    assert scores(True) == scores(False)


# faults that are not the student's


def test_a_fault_of_the_grader_is_said_and_does_not_touch_the_other_notebook(grade, answered, monkeypatch):
    def fail(cells):
        raise ZeroDivisionError

    monkeypatch.setattr(grading, "language_of", fail)
    results, _ = grade(pose_update=answered(), encoders=NOT_HANDED_IN)
    assert (results["pose_step"].score, results["pose_step"].status) == (0.0, "failed")
    assert "ZeroDivisionError" in results["pose_step"].message
    assert results["distance_per_count"].status == "missing"


def test_where_nothing_can_be_run_nobody_gets_zeros(grade, answered, monkeypatch):
    class Nowhere:
        def __init__(self, *_):
            raise NoSandboxError("no")

    monkeypatch.setattr(grading, "Session", Nowhere)
    with pytest.raises(NoSandboxError):
        grade(pose_update=answered())


class Played:
    """A session whose replies are given; it stands for one that was taken over."""

    def __init__(self, *_):
        pass

    def __enter__(self):
        return self

    def __exit__(self, *_):
        pass

    def run(self, source):
        return self.outputs

    def names(self, sources):
        return frozenset()

    def ask(self, name, questions):
        raise SessionEndedError(Text("over", "終わり"))


@pytest.mark.parametrize(
    "hostile", [[None] * 10**5, ["x"] * 10**5, [{"output_type": "stream", "name": "stdout", "text": "x" * 10**5}] * 500]
)
def test_hostile_outputs_do_not_fill_the_graders_memory(grade, answered, monkeypatch, hostile):
    monkeypatch.setattr(grading, "Session", Played)
    monkeypatch.setattr(Played, "outputs", hostile, raising=False)
    results, graded = grade(pose_update=answered(edit=with_cell("1", None)))
    assert results["pose_step"].status == "stopped"
    assert len(graded["pose_update"].executed) < 10**7


def test_no_message_hides_anything_whoever_wrote_it(grade, answered, monkeypatch):
    hidden = Text("x\x1b\u202e\ud800", "あ\0")
    monkeypatch.setattr(grading, "Session", Played)
    monkeypatch.setattr(Played, "outputs", [], raising=False)
    monkeypatch.setattr(grading, "judged", lambda exercise, ask, seed, apart: Verdict(exercise.name, 0.0, hidden, rung="value"))
    for language, seen in (("en", "x\\u001b\\u202e\\ud800"), ("ja", "あ\\u0000")):
        results, graded = grade(pose_update=answered("pose_update", language))
        assert results["pose_step"].message == seen
        assert outputs(graded["pose_update"], 'check("pose_step")')[0]["traceback"][-1] == seen


# on the way through an executor


def test_a_submission_crosses_as_plain_data_and_comes_back_the_same(class_release, answered):
    release = release_notebooks(class_release, "odometry")
    notebooks = {"pose_update": answered(pose_step=WRONG_SIN_COS), "encoders": NOT_HANDED_IN}
    work = Work("ann", "odometry", notebooks, release, False, 3, Limits(check=2.0), {"pose_step": 5, "displacement": 6})
    packed = plain_work(work, exercises_hash())
    assert json.dumps(packed, default=lambda data: type(data) is bytes or pytest.fail(str(type(data))), skipkeys=True)
    assert graded_from_plain(graded_plainly(packed)) == graded_submission(work)


def test_a_worker_of_another_version_does_not_grade(class_release, answered):
    release = release_notebooks(class_release, "odometry")
    with pytest.raises(OtherVersionError, match="another version of the course"):
        graded_plainly(plain_work(Work("ann", "odometry", {"pose_update": answered()}, release), "yesterday's"))


# the cases


def test_the_seed_decides_on_the_cases_and_is_told(class_release, answered):
    release = release_notebooks(class_release, "odometry")
    first, again, other = (
        graded_submission(
            Work("ann", "odometry", {"pose_update": answered(pose_step=WRONG_SIN_COS)}, release, False, seeds={"pose_step": seed})
        )[0]
        for seed in (1, 1, 2)
    )
    assert [graded.results[0].seed for graded in (first, again, other)] == [1, 1, 2]
    assert first.replies == again.replies
    assert first.replies["pose_step"] != other.replies["pose_step"]
    assert first.results[1].seed not in (None, again.results[1].seed)


def test_what_wrong_answers_replied_is_kept_and_what_right_ones_replied_is_not(honest):
    assert honest.replies.keys() == {"pose_step"}
    talk = unpacked_interview(receive(io.BytesIO(honest.replies["pose_step"]).read))
    assert len(talk.replies) > 5
    assert all(reply.value.shape == (3,) for reply in talk.replies)


# the release


def test_the_flags_are_those_of_the_release(class_release):
    cells = released((class_release / "release/en/odometry/pose_update.ipynb").read_bytes()).cells
    flags = {cell.grade_id: (cell.type, cell.locked, cell.graded) for cell in cells if cell.grade_id}
    assert flags == {
        "q1_derivation": ("markdown", False, True),
        "pose_step": ("code", False, False),
        "check_pose_step": ("code", True, True),
        "displacement": ("code", False, False),
        "check_displacement": ("code", True, True),
    }


def test_names_of_notebooks():
    assert notebook_names("odometry") == ["pose_update", "encoders"]
    with pytest.raises(KeyError, match="no assignment is called 'imu'; there are: odometry"):
        notebook_names("imu")

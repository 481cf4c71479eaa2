import dataclasses
import json
import stat

import pytest

from autograder.receipts import (
    REPLY,
    Receipt,
    exercises_hash,
    read_receipt,
    receipts_folder,
    release_hash,
    submission_folder,
    write_receipt,
)

ROWS = [
    {"notebook": "pose_update", "exercise": "pose_step", "score": 5.0},
    {"notebook": "pose_update", "exercise": "displacement", "score": 0.0},
    {"notebook": "encoders", "exercise": "distance_per_count", "score": 0.0},
    {"notebook": "pose_update", "exercise": "q1_derivation", "score": None},
]
RECEIPT = Receipt(
    student="ann", assignment="odometry", notebooks={"pose_update": "hash"}, attempts={"pose_update": ["hash"]}, release="r", exercises="e",
    sandbox=True, limits={"cell": 30.0}, languages={"pose_update": "en"}, results=ROWS, begun="2026-01-01T00:00:00+00:00", seconds=1.5,
)  # fmt: skip


def test_a_receipt_is_read_as_it_was_written_and_only_its_owner_reads_it(tmp_path):
    write_receipt(tmp_path, RECEIPT, {"pose_update": b"{}"}, {"displacement": b"reply"})
    assert read_receipt(tmp_path, "odometry", "ann") == RECEIPT
    folder = submission_folder(tmp_path, "odometry", "ann")
    files = {path.name: path.read_bytes() for path in folder.iterdir()}
    assert files.keys() == {"receipt.json", "pose_update.ipynb", "displacement.reply"}
    assert (files["pose_update.ipynb"], files["displacement.reply"]) == (b"{}", b"reply")
    assert {stat.S_IMODE(path.stat().st_mode) for path in folder.iterdir()} == {0o600}
    assert stat.S_IMODE(receipts_folder(tmp_path).stat().st_mode) == 0o700


def test_there_is_none_before_one_is_written(tmp_path):
    assert read_receipt(tmp_path, "odometry", "ann") is None


def test_a_reply_goes_when_the_answer_is_right_and_stays_where_the_notebook_was_not_graded(tmp_path):
    write_receipt(
        tmp_path, RECEIPT, {"pose_update": b"1", "encoders": b"1"}, {"displacement": b"old", "distance_per_count": b"old"}
    )
    write_receipt(tmp_path, RECEIPT, {"pose_update": b"2"}, {"pose_step": b"new"})
    folder = submission_folder(tmp_path, "odometry", "ann")
    assert {path.stem: path.read_bytes() for path in folder.glob(f"*{REPLY}")} == {
        "pose_step": b"new",
        "distance_per_count": b"old",
    }
    assert {path.stem: path.read_bytes() for path in folder.glob("*.ipynb")} == {"pose_update": b"2", "encoders": b"1"}


def test_the_receipt_comes_last(tmp_path, monkeypatch):
    """Or a run that was ended in between would take for done what is half written."""
    from autograder import receipts

    written = []
    monkeypatch.setattr(receipts, "replace_file", lambda path, content, mode: written.append(path.name))
    write_receipt(tmp_path, RECEIPT, {"pose_update": b"{}", "encoders": b"{}"}, {"displacement": b"reply"})
    assert sorted(written) == ["displacement.reply", "encoders.ipynb", "pose_update.ipynb", "receipt.json"]
    assert written[-1] == "receipt.json"


def changed(**values):
    data = json.loads(json.dumps(dataclasses.asdict(RECEIPT)))
    return json.dumps({**data, **values}).encode()


WHOLE = changed()
UNBELIEVABLE = {
    "empty": b"",
    "cut off": WHOLE[: len(WHOLE) // 2],
    "no JSON": b"\0" * len(WHOLE),
    "no text": b"\xff\xfe",
    "a list": b"[]",
    "null": b"null",
    "too little": b'{"student": "ann"}',
    "too much": changed(more=1),
    "another version": changed(version=0),
    "another student's": changed(student="bob"),
    "another assignment's": changed(assignment="imu"),
    "results without scores": changed(results=[{"exercise": "pose_step"}]),
    "scores that are text": changed(results=[{**ROWS[0], "score": "5"}]),
    "results that are text": changed(results=["pose_step"]),
    "results that are a number": changed(results=5),
}


@pytest.mark.parametrize("content", UNBELIEVABLE.values(), ids=UNBELIEVABLE.keys())
def test_a_receipt_that_cannot_be_believed_is_none(tmp_path, content):
    write_receipt(tmp_path, RECEIPT, {}, {})
    (submission_folder(tmp_path, "odometry", "ann") / "receipt.json").write_bytes(content)
    assert read_receipt(tmp_path, "odometry", "ann") is None


def test_a_folder_in_the_place_of_a_receipt_is_none(tmp_path):
    (submission_folder(tmp_path, "odometry", "ann") / "receipt.json").mkdir(parents=True)
    assert read_receipt(tmp_path, "odometry", "ann") is None


@pytest.mark.parametrize(
    ("field", "value"), [("notebooks", {}), ("release", "s"), ("exercises", "f"), ("sandbox", False), ("version", 2)]
)
def test_other_work_is_what_was_handed_in_or_graded_against_something_else(field, value):
    assert not RECEIPT.same_work(dataclasses.replace(RECEIPT, **{field: value}))


@pytest.mark.parametrize("field", ["attempts", "languages", "results", "begun", "seconds"])
def test_what_came_of_it_makes_no_other_work(field):
    assert RECEIPT.same_work(dataclasses.replace(RECEIPT, **{field: None}))


def test_the_hash_of_a_release_depends_on_every_byte_and_name():
    hashes = [
        release_hash(release)
        for release in (
            {},
            {("en", "a"): b"xy"},
            {("en", "a"): b"xz"},
            {("ja", "a"): b"xy"},
            {("en", "b"): b"xy"},
            {("en", "a"): b"x", ("en", "b"): b"y"},
            {("en", "a"): b"y", ("en", "b"): b"x"},
        )
    ]
    assert len(set(hashes)) == len(hashes)
    assert release_hash({("en", "a"): b"1", ("ja", "a"): b"2"}) == release_hash({("ja", "a"): b"2", ("en", "a"): b"1"})


@pytest.mark.parametrize(
    "file", ["autograder/reference/pose_step.py", "autograder/judging.py", "course/tolerances.py", "course/examples.json"]
)
def test_the_hash_of_the_exercises_changes_with_what_decides_on_a_verdict(tmp_path, monkeypatch, file):
    from autograder import receipts

    for name in ("autograder/reference/pose_step.py", "autograder/judging.py", "course/tolerances.py", "course/examples.json"):
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).write_text("1")
    monkeypatch.setattr(receipts, "ROOT", tmp_path)
    before = exercises_hash.__wrapped__()
    (tmp_path / "course/notes.txt").write_text("nothing")
    assert exercises_hash.__wrapped__() == before
    (tmp_path / file).write_text("2")
    assert exercises_hash.__wrapped__() != before

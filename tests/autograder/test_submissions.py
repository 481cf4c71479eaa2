import os

import pytest

from autograder.intake import NOT_HANDED_IN
from autograder.submissions import MissingReleaseError, hashes, release_notebooks, students_with, submitted_notebooks
from course.language import Text


def submissions(root, *students, assignment="odometry"):
    for student in students:
        (root / "submitted" / student / assignment).mkdir(parents=True)


def test_students_are_the_folders_with_something_under_the_assignments_name(tmp_path):
    submissions(tmp_path, "s2", "s10", "s1", "x y")
    submissions(tmp_path, "other", assignment="imu")
    (tmp_path / "submitted/file").write_text("")
    (tmp_path / "submitted/link").symlink_to(tmp_path / "submitted/s1")
    (tmp_path / "submitted/linked").mkdir()
    (tmp_path / "submitted/linked/odometry").symlink_to(tmp_path / "submitted/s1/odometry")
    assert students_with(tmp_path, "odometry") == {name: name for name in ("linked", "s1", "s10", "s2", "x y")}
    assert [*students_with(tmp_path, "odometry")] == ["linked", "s1", "s10", "s2", "x y"]
    assert [*students_with(tmp_path, "odometry", "s?")] == ["s1", "s2"]
    assert students_with(tmp_path, "odometry", "S*") == {}
    assert students_with(tmp_path / "nowhere", "odometry") == {}


def test_a_name_that_is_no_text_gets_an_id_that_is_and_never_somebody_elses(tmp_path):
    submissions(tmp_path, os.fsdecode(b"s\xff"), r"s\xff")
    found = students_with(tmp_path, "odometry")
    assert found == {r"s\xff": r"s\xff", r"s\xff_": os.fsdecode(b"s\xff")}


def test_a_name_that_is_too_long_for_a_database_is_shortened_and_stays_unlike_others(tmp_path):
    submissions(tmp_path, "x" * 250, "x" * 249 + "y", "x" * 128)
    ids = [*students_with(tmp_path, "odometry")]
    assert len(set(ids)) == 3
    assert "x" * 128 in ids
    assert {len(student) for student in ids} == {128}


@pytest.mark.usefixtures("class_contents")
def test_what_is_reached_through_a_link_is_not_read(hand_in, class_root):
    hand_in("ann", pose_update=b"anything")
    (class_root / "submitted/bob").mkdir()
    (class_root / "submitted/bob/odometry").symlink_to(class_root / "submitted/ann/odometry")
    given = submitted_notebooks(class_root, "bob", "odometry")
    assert {reason.en for reason in given.values()} == {
        "There is no ordinary file with the notebook's name (a link or a folder is not read)."
    }


@pytest.mark.usefixtures("class_contents")
def test_what_was_handed_in_comes_as_bytes_or_as_the_reason_why_not(hand_in, class_root):
    folder = hand_in("ann", pose_update=b"anything")
    assert submitted_notebooks(class_root, "ann", "odometry") == {"pose_update": b"anything", "encoders": NOT_HANDED_IN}
    os.symlink(class_root / "nbgrader_config.py", folder / "encoders.ipynb")
    assert "a link or a folder is not read" in submitted_notebooks(class_root, "ann", "odometry")["encoders"].en


def test_only_the_courses_notebooks_are_taken(hand_in, class_root):
    folder = hand_in("ann", pose_update=b"1", numpy=b"2")
    (folder / "numpy.py").write_text("")
    assert submitted_notebooks(class_root, "ann", "odometry").keys() == {"pose_update", "encoders"}


def test_what_tells_submissions_apart():
    one, other, none = hashes({"a": b"1"}), hashes({"a": b"2"}), hashes({"a": Text("The file is empty.", "空")})
    assert len(one["a"]) == 64
    assert one["a"] != other["a"]
    assert none == {"a": "none: The file is empty."}


def test_the_release_is_read_in_both_languages(class_root):
    release = release_notebooks(class_root, "odometry")
    assert sorted(release) == [(language, name) for language in ("en", "ja") for name in ("encoders", "pose_update")]
    assert release["ja", "encoders"] == (class_root / "release/ja/odometry/encoders.ipynb").read_bytes()


def test_a_release_that_is_not_there_says_what_to_type(class_root):
    (class_root / "release/ja/odometry/encoders.ipynb").unlink()
    with pytest.raises(MissingReleaseError, match=r"not built yet: release/ja/odometry/encoders.ipynb. Type: autograder build"):
        release_notebooks(class_root, "odometry")

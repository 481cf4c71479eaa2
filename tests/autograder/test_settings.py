import sqlite3

import pytest

from autograder.gradebook import GradebookWriter
from autograder.settings import configuration, course_id, db_url


def test_a_course_without_a_configuration_has_its_gradebook_in_its_root(tmp_path):
    assert course_id(tmp_path) == ""
    assert db_url(tmp_path).partition("?")[0] == f"sqlite:///{tmp_path}/gradebook.db"
    assert configuration(tmp_path) == {}


@pytest.mark.parametrize(
    "address", ["postgresql+psycopg://ta@db.example/grades?sslmode=require", "sqlite:////var/grades.db?timeout=5"]
)
def test_the_gradebook_is_where_the_configuration_says(tmp_path, address):
    (tmp_path / "nbgrader_config.py").write_text(f"c = get_config()\nc.CourseDirectory.db_url = {address!r}\n")
    assert db_url(tmp_path) == address


@pytest.mark.parametrize("kind", ["postgresql", "postgres"])
def test_a_postgresql_address_without_a_driver_names_the_one_that_is_there(tmp_path, monkeypatch, kind):
    address = f"{kind}://ta:secret@db.example:5433/grades?sslmode=require"
    (tmp_path / "nbgrader_config.py").write_text(f"c = get_config()\nc.CourseDirectory.db_url = {address!r}\n")
    assert db_url(tmp_path) == "postgresql+psycopg://ta:secret@db.example:5433/grades?sslmode=require"
    monkeypatch.setattr("autograder.settings.find_spec", lambda name: name)
    assert db_url(tmp_path) == address


def test_our_addresses_are_those_of_nbgrader(root, tmp_path):
    from nbgrader.coursedir import CourseDirectory

    (tmp_path / "nbgrader_config.py").write_bytes((root / "nbgrader_config.py").read_bytes())
    course = CourseDirectory(config=configuration(tmp_path), root=str(tmp_path))
    assert (course.db_url, course.course_id) == (db_url(tmp_path).partition("?")[0], course_id(tmp_path))


def test_the_gradebook_is_written_there(class_root):
    with (class_root / "nbgrader_config.py").open("a") as file:
        file.write(f'c.CourseDirectory.db_url = "sqlite:///{class_root}/elsewhere.db"\n')
    with GradebookWriter(class_root, "odometry"):
        pass
    with sqlite3.connect(class_root / "elsewhere.db") as database:
        assert database.execute("SELECT name FROM assignment").fetchall() == [("odometry",)]
    assert not (class_root / "gradebook.db").exists()

"""What nbgrader_config.py says of the course, read without importing nbgrader, which takes seconds."""

from importlib.util import find_spec
from pathlib import Path

from traitlets.config import Config, PyFileConfigLoader

#: a lock on the database that somebody else holds is waited for this long, in s
_LOCK_SECONDS = 30


def course_id(root: Path) -> str:
    """Return the course id, under which stock nbgrader looks for grades; "" if none is set, as in nbgrader."""
    return str(configuration(root).CourseDirectory.get("course_id", ""))


def configured_db_url(root: Path) -> str:
    """Return the URL of the gradebook's database as nbgrader knows it: the configuration's, or gradebook.db in the root."""
    return str(configuration(root).CourseDirectory.get("db_url", "")) or f"sqlite:///{root / 'gradebook.db'}"


def db_url(root: Path) -> str:
    """Return the URL by which the gradebook's database is opened.

    By "postgresql://" SQLAlchemy means psycopg 2. Where that is not there, psycopg 3 is named, which the environment has.
    """
    url = configured_db_url(root)
    kind, separator, rest = url.partition("://")
    if kind in ("postgresql", "postgres") and find_spec("psycopg2") is None:
        return f"postgresql+psycopg{separator}{rest}"
    return f"{url}?timeout={_LOCK_SECONDS}" if kind == "sqlite" and "?" not in url else url


def configuration(root: Path) -> Config:
    """Return everything that nbgrader_config.py sets; empty where there is no such file."""
    path = root / "nbgrader_config.py"
    return PyFileConfigLoader(path.name, path=str(root)).load_config() if path.is_file() else Config()

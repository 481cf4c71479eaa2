"""What nbgrader_config.py says of the course, read without importing nbgrader, which takes seconds."""

from pathlib import Path
from typing import Any

from traitlets.config import PyFileConfigLoader

#: a lock on the database that somebody else holds is waited for this long, in s
_LOCK_SECONDS = 30


def course_id(root: Path) -> str:
    """Return the course id, under which stock nbgrader looks for grades; "" if none is set, as in nbgrader."""
    return str(_course_directory(root).get("course_id", ""))


def db_url(root: Path) -> str:
    """Return the URL of the gradebook's database: that of the configuration, or gradebook.db in the root of the course."""
    url = str(_course_directory(root).get("db_url", "")) or f"sqlite:///{root / 'gradebook.db'}"
    return f"{url}?timeout={_LOCK_SECONDS}" if url.startswith("sqlite:///") and "?" not in url else url


def _course_directory(root: Path) -> Any:
    path = root / "nbgrader_config.py"
    if not path.is_file():
        return {}
    return PyFileConfigLoader(path.name, path=str(root)).load_config().get("CourseDirectory", {})

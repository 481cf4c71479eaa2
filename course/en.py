"""The English edition: `from course.en import check`."""

from course.checking import check
from course.language import use_language

__all__ = ["check"]

use_language("en")

"""JSON from somebody who is not trusted: how many values there are is known before any of them takes memory."""

import json
import re
from itertools import islice
from typing import Any

#: a string as a whole, closed or not, or what comes before a value. Possessive: whatever is in it, it is passed over once.
_PART = re.compile(rb'"[^"\\]*+(?:\\.[^"\\]*+)*+"?|[\[{,]', re.DOTALL)


class TooManyValuesError(ValueError):
    """There are more values in a text than its reader takes."""


def has_more_parts(data: bytes, most: int) -> bool:
    """Return whether there are more than `most` strings and marks that begin a value; reads no further than that."""
    return len(data) > most and next(islice(_PART.finditer(data), most, None), None) is not None


def limited_json(data: bytes, most: int) -> Any:
    """Return what JSON in UTF-8 says, with or without a byte order mark. Strings, and marks that begin a value, count as parts.

    Raises TooManyValuesError beyond `most` parts, and ValueError if it is no JSON, or nested too deeply. Without the count
    20 MB of "[],[],[]" would take 400 MB.
    """
    if has_more_parts(data, most):
        raise TooManyValuesError("too many values")
    try:
        return json.loads(data.decode("utf-8-sig"))
    except RecursionError:
        raise ValueError("nested too deeply") from None

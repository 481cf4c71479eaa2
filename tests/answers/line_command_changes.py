"""Answers to line_command_changes(kind): right ones in honest styles, wrong ones as students write them."""

import warnings

import numpy as np


def branches(kind):
    if kind == "set":
        return False
    elif kind == "adjust":
        return True
    raise ValueError('kind must be "set" or "adjust"')


def table(kind):
    answers = {"set": False, "adjust": True}
    if kind not in answers:
        raise ValueError(f"unknown kind: {kind!r}")
    return answers[kind]


def key_error_turned(kind):
    try:
        return {"set": 0, "adjust": 1}[kind]
    except KeyError:
        raise ValueError(kind) from None


def position_in_a_list(kind):
    print("asked for", kind)
    warnings.warn("list", stacklevel=1)
    return ["set", "adjust"].index(kind) == 1


def matched(kind):
    match kind:
        case "set":
            return np.False_
        case "adjust":
            return np.True_
        case _:
            raise ValueError


class UnknownKindError(ValueError):
    pass


class LineCommand:
    def __call__(self, kind):
        if not isinstance(kind, str):
            raise UnknownKindError("a text is needed")
        if kind not in ("set", "adjust"):
            raise UnknownKindError(kind)
        return kind != "set"


RIGHT = {
    "branches": branches,
    "table": table,
    "KeyError turned, 0 and 1": key_error_turned,
    "position in a list, prints and warns": position_in_a_list,
    "match, NumPy's bools": matched,
    "object, an error of its own": LineCommand(),
}


def exchanged(kind):
    return not branches(kind)


def else_adjust(kind):
    return kind != "set"


def else_set(kind):
    return kind == "adjust"


def lower(kind):
    return branches(kind.lower())


def strip(kind):
    return branches(kind.strip())


def lower_of_text(kind):
    return branches(str(kind).strip().lower())


def or_condition(kind):
    if kind != "set" or kind != "adjust":
        raise ValueError(kind)
    return kind == "adjust"


def or_word(kind):
    if kind == "set" or "adjust":  # noqa: SIM222 - the mistake itself
        return kind == "adjust"
    raise ValueError(kind)


def lookup(kind):
    return {"set": False, "adjust": True}[kind]


def get(kind):
    return {"set": False, "adjust": True}.get(kind)


def default_false(kind):
    return {"set": False, "adjust": True}.get(kind, False)


def printed_error(kind):
    if kind not in ("set", "adjust"):
        print("ValueError")
        return None
    return kind == "adjust"


def returned_error(kind):
    return branches(kind) if kind in ("set", "adjust") else ValueError


def returned_word(kind):
    return branches(kind) if kind in ("set", "adjust") else "ValueError"


def asserted(kind):
    assert kind in ("set", "adjust"), "set or adjust"
    return kind == "adjust"


def exception(kind):
    if kind in ("set", "adjust"):
        return kind == "adjust"
    raise Exception("set or adjust")


def type_error(kind):
    if not isinstance(kind, str):
        raise TypeError("a text is needed")
    return branches(kind)


def none_means_set(kind=None):
    return False if kind is None else branches(kind)


def substring(kind):
    if kind in "set adjust":
        return kind == "adjust"
    raise ValueError(kind)


def starts_with(kind):
    if not isinstance(kind, str) or not kind.startswith(("set", "adjust")):
        raise ValueError(kind)
    return kind.startswith("adjust")


def first_letter(kind):
    if kind and str(kind)[0] in "sa":
        return str(kind)[0] == "a"
    raise ValueError(kind)


def length(kind):
    if len(str(kind)) not in (3, 6):
        raise ValueError(kind)
    return len(str(kind)) == 6


def words(kind):
    return "changes" if branches(kind) else "does not change"


def refuses_all(kind):
    raise ValueError("not implemented")


def no_return(kind):
    branches(kind)


WRONG = {
    "exchanged": (exchanged, "set and adjust exchanged", "plain"),
    "else adjust": (else_adjust, "everything else is adjust", "plain"),
    "else set": (else_set, "everything else is set", "plain"),
    "lower": (lower, "capitals accepted, AttributeError for None", "subtle"),
    "strip": (strip, "blanks accepted, AttributeError for None", "subtle"),
    "str, strip, lower": (lower_of_text, "capitals and blanks accepted", "plain"),
    "!= or !=": (or_condition, "always refused", "plain"),
    "== or text": (or_word, "never refused", "plain"),
    "lookup": (lookup, "KeyError", "plain"),
    "get": (get, "None for others", "plain"),
    "get with default": (default_false, "False for others", "plain"),
    "prints the error": (printed_error, "None and a message", "plain"),
    "returns the error": (returned_error, "class returned", "plain"),
    "returns a word": (returned_word, "text returned", "plain"),
    "assert": (asserted, "AssertionError", "plain"),
    "Exception": (exception, "too general", "plain"),
    "TypeError": (type_error, "TypeError for None and numbers", "plain"),
    "None means set": (none_means_set, "default", "plain"),
    "part of a text": (substring, "substring", "subtle"),
    "startswith": (starts_with, "beginnings accepted", "plain"),
    "first letter": (first_letter, "first letter only", "plain"),
    "length": (length, "length of the word only", "subtle"),
    "words": (words, "text for a bool", "plain"),
    "refuses all": (refuses_all, "ValueError for all", "plain"),
    "no return": (no_return, "no return", "plain"),
}

"""The solution of the practical is as exact as counting allows, and its teachers are told how exact."""

import re

import pytest

from bench.practical import SOURCE, Accuracy, accuracies, table
from course.language import LANGUAGES

NUMBER = re.compile(r"\d+\.\d+")


@pytest.fixture(scope="module")
def found() -> list[Accuracy]:
    return list(accuracies())


def test_the_graphs_are_within_what_half_a_count_allows(found: list[Accuracy]) -> None:
    assert len(found) >= 12
    for accuracy in found:
        assert accuracy.end < accuracy.bound, accuracy
        assert accuracy.rms < accuracy.bound, accuracy
        assert accuracy.yaw_rms < accuracy.yaw_bound, accuracy


@pytest.mark.parametrize("language", LANGUAGES)
def test_the_table_behind_the_rubric_is_what_the_command_prints(language: str) -> None:
    head, rule, *rows = table(language).splitlines()
    written = SOURCE.read_text(encoding="utf-8").splitlines()
    start = written.index(head)
    assert written[start + 1] == rule
    for row, kept in zip(rows, written[start + 2 :], strict=False):
        assert NUMBER.sub("#", row) == NUMBER.sub("#", kept)
        # the last digit may differ from machine to machine
        assert [float(number) for number in NUMBER.findall(row)] == pytest.approx(
            [float(number) for number in NUMBER.findall(kept)], abs=0.011
        )
    assert not written[start + 2 + len(rows)].startswith("|")

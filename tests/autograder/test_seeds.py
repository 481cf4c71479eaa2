import os
import stat
import subprocess
import sys
from itertools import product
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from autograder.seeds import SecretError, course_secret, exercise_seed

ROOT = Path(__file__).parents[2]


def test_the_secret_is_made_once_and_only_its_owner_reads_it(tmp_path):
    before = os.umask(0)
    try:
        made = course_secret(tmp_path)
    finally:
        os.umask(before)
    assert len(made) == 32
    assert stat.S_IMODE((tmp_path / "secret").stat().st_mode) == 0o600
    assert course_secret(tmp_path) == made
    assert [path.name for path in tmp_path.iterdir()] == ["secret"]


def test_another_course_has_another_secret(tmp_path):
    for name in ("one", "other"):
        (tmp_path / name).mkdir()
    assert course_secret(tmp_path / "one") != course_secret(tmp_path / "other")


MAKES = """
import pathlib, sys
from autograder import seeds
folder = pathlib.Path(sys.argv[1])
# both have seen that there is none before either makes one
ready, go = folder.parent / sys.argv[2], folder.parent / "go"
link = seeds.os.link
def when_told(*paths):
    ready.touch()
    while not go.exists():
        pass
    link(*paths)
seeds.os.link = when_told
print(seeds.course_secret(folder).hex())
"""


def test_of_two_processes_that_make_one_at_a_time_both_use_the_same(tmp_path):
    folder = tmp_path / "course"
    folder.mkdir()
    makers = [
        subprocess.Popen(
            [sys.executable, "-c", MAKES, folder, name],
            stdout=subprocess.PIPE,
            text=True,
            env={**os.environ, "PYTHONPATH": str(ROOT)},
        )
        for name in ("a", "b")
    ]
    while not all((tmp_path / name).exists() for name in ("a", "b")):
        assert all(maker.poll() is None for maker in makers)
    (tmp_path / "go").touch()
    one, other = (maker.communicate(timeout=30)[0] for maker in makers)
    assert one == other
    assert bytes.fromhex(one) == (folder / "secret").read_bytes()
    assert [path.name for path in folder.iterdir()] == ["secret"]


@pytest.mark.parametrize("damaged", [b"", b"short", bytes(33)])
def test_a_damaged_secret_is_not_replaced_in_silence(tmp_path, damaged):
    (tmp_path / "secret").write_bytes(damaged)
    with pytest.raises(SecretError, match="is damaged"):
        course_secret(tmp_path)
    assert (tmp_path / "secret").read_bytes() == damaged


NAMES = ("ann", "bob"), ("odometry", "imu"), ("pose_step", "displacement"), (1, 2)


def test_the_same_attempt_has_the_same_seed_and_every_other_another():
    rows = [*product(*NAMES)]
    seeds = [exercise_seed(b"a" * 32, *row) for row in rows]
    assert seeds == [exercise_seed(b"a" * 32, *row) for row in rows]
    assert len({*seeds, *(exercise_seed(b"b" * 32, *row) for row in rows)}) == 2 * len(rows)
    assert all(0 <= seed < 2**63 for seed in seeds)


@given(st.text(max_size=5), st.text(max_size=5), st.text(max_size=5), st.data())
def test_no_row_of_names_has_the_seed_of_another_that_reads_the_same(student, assignment, exercise, data):
    joined = student + assignment + exercise
    one, two = sorted(data.draw(st.lists(st.integers(0, len(joined)), min_size=2, max_size=2)))
    other = joined[:one], joined[one:two], joined[two:]
    same = other == (student, assignment, exercise)
    assert (exercise_seed(b"s" * 32, student, assignment, exercise, 1) == exercise_seed(b"s" * 32, *other, 1)) == same


def test_a_name_that_is_no_text_has_a_seed():
    assert exercise_seed(b"s" * 32, os.fsdecode(b"\xff"), "odometry", "pose_step", 1)

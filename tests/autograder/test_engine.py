"""The engine with executors that do what they are told, and with real processes."""

import os
import signal
import subprocess
import sys
import time
from concurrent.futures import BrokenExecutor, Executor, Future
from contextlib import contextmanager
from pathlib import Path

import pytest

from autograder import engine
from autograder.engine import Pool, graded, local_pool
from autograder.grading import Work, notebook_names
from autograder.submissions import release_notebooks, submitted_notebooks

ROOT = Path(__file__).parents[2]


class WorkerDiedError(Exception):
    """What this executor says when a worker died and the others live."""


class OneByOne(Executor):
    """Does the first work that waits, and another one whenever `done` is called."""

    def __init__(self):
        self.works, self.waiting, self.most = [], [], 0

    def submit(self, call, work):
        future = Future()
        self.works.append(work)
        self.waiting.append((future, call, work))
        self.most = max(self.most, len(self.waiting))
        if len(self.waiting) == 1:
            self.do_next()
        return future

    def do_next(self):
        future, call, work = self.waiting[0]
        future.set_running_or_notify_cancel()
        try:
            future.set_result(call(work))
        except Exception as error:
            future.set_exception(error)

    def done(self):
        del self.waiting[0]
        if self.waiting:
            self.do_next()


class AtOnce(Executor):
    """Does everything at once, in this process; after a BrokenExecutor it does nothing any more."""

    def __init__(self):
        self.broken = None

    def submit(self, call, work):
        future = Future()
        try:
            if self.broken is not None:
                raise self.broken
            future.set_result(call(work))
        except BaseException as error:
            if isinstance(error, BrokenExecutor):
                self.broken = error
            future.set_exception(error)
        return future


def pools(executor_class, workers=2):
    """Opens a new executor whenever the engine asks for one, and counts them."""
    opened = []

    @contextmanager
    def open_pool():
        opened.append(executor_class())
        yield Pool(opened[-1], workers, (BrokenExecutor, WorkerDiedError))

    return open_pool, opened


def works(count):
    return [Work(f"s{number}", "odometry", {"pose_update": b""}, {}) for number in range(count)]


@pytest.fixture
def plainly(monkeypatch):
    """Sets what a worker does with the plain dictionary of a submission."""

    def set_to(call):
        monkeypatch.setattr(engine, "graded_plainly", call)
        monkeypatch.setattr(engine, "refused_submission", lambda work, reason: [("refused", work.student, reason)])

    return set_to


def test_each_submission_is_graded_once(plainly):
    plainly(lambda data: [])
    open_pool, opened = pools(AtOnce)
    done = sorted((work.student, result) for work, result in graded(works(5), open_pool))
    assert done == [(f"s{n}", []) for n in range(5)]
    assert len(opened) == 1


def test_only_so_many_submissions_are_in_memory_at_a_time(plainly):
    plainly(lambda data: [])
    open_pool, opened = pools(OneByOne)
    taken = []

    def lazily():
        for work in works(10):
            taken.append(work.student)
            yield work

    for count, _ in enumerate(graded(lazily(), open_pool), 1):
        # two workers, and one submission ahead for each
        assert len(taken) <= count + 4
        opened[0].done()
    assert len(taken) == 10
    assert opened[0].most == 4


def test_a_fault_reaches_the_caller(plainly):
    def fail(data):
        raise RuntimeError("no sandbox")

    plainly(fail)
    with pytest.raises(RuntimeError, match="no sandbox"):
        list(graded(works(3), pools(AtOnce)[0]))


@pytest.mark.parametrize("death", [BrokenExecutor, WorkerDiedError])
def test_who_kills_a_worker_twice_is_scored_with_a_reason_and_the_others_get_what_they_deserve(plainly, death):
    tried = []

    def deadly(data):
        tried.append(data["student"])
        if data["student"] in ("s2", "s4"):
            raise death
        return []

    plainly(deadly)
    open_pool, _ = pools(AtOnce)
    results = {work.student: result for work, result in graded(works(6), open_pool)}
    assert {student for student, result in results.items() if result} == {"s2", "s4"}
    assert results["s2"][0][2].en.startswith("The grader's own process ended twice")
    assert len(results) == 6
    assert tried.count("s2") == tried.count("s4") == 2


@pytest.mark.parametrize("death", [BrokenExecutor, WorkerDiedError])
def test_who_lost_a_worker_once_is_graded_again(plainly, death):
    tried = []

    def deadly_once(data):
        tried.append(data["student"])
        if tried.count("s1") == 1 and data["student"] == "s1":
            raise death
        return []

    plainly(deadly_once)
    assert sorted((work.student, result) for work, result in graded(works(3), pools(AtOnce)[0])) == [
        (f"s{n}", []) for n in range(3)
    ]


class BreaksWhenIdle(AtOnce):
    """Has broken when the next work comes, which is only the first time."""

    broke = False

    def submit(self, call, work):
        if work["student"] == "s2" and not BreaksWhenIdle.broke:
            BreaksWhenIdle.broke = True
            raise BrokenExecutor
        return super().submit(call, work)


@pytest.mark.parametrize("first_death", [None, "s0"])
def test_a_worker_that_dies_while_nothing_waits_for_it_costs_nobody_a_try(plainly, monkeypatch, first_death):
    """Before the class is through, or while those are tried alone who were under way when a worker died before."""
    monkeypatch.setattr(BreaksWhenIdle, "broke", first_death is not None)
    tried = []

    def deadly_once(data):
        tried.append(data["student"])
        if data["student"] == first_death and tried.count(first_death) == 1:
            raise BrokenExecutor
        if data["student"] == first_death:
            # while the others wait for their turn
            BreaksWhenIdle.broke = False
        return []

    plainly(deadly_once)
    open_pool, opened = pools(BreaksWhenIdle)
    assert sorted((work.student, result) for work, result in graded(works(6), open_pool)) == [(f"s{n}", []) for n in range(6)]
    assert len(opened) == (2 if first_death is None else 3)


def test_nobody_handed_in():
    assert list(graded([], pools(AtOnce)[0])) == []


def test_processes_of_its_own(root, tmp_path):
    """With the course itself: a process does not see what a test put into the table of contents."""
    (tmp_path / "release").symlink_to(root / "release")
    release = release_notebooks(tmp_path, "odometry")
    given = []
    for student, content in (("ann", b""), ("bob", b"[]")):
        folder = tmp_path / "submitted" / student / "odometry"
        folder.mkdir(parents=True)
        (folder / "pose_update.ipynb").write_bytes(content)
        given.append(Work(student, "odometry", submitted_notebooks(tmp_path, student, "odometry"), release))
    done = {work.student: notebooks for work, notebooks in graded(given, lambda: local_pool(1))}
    assert {
        (student, notebook.notebook): {result.status for result in notebook.results}
        for student, notebooks in done.items()
        for notebook in notebooks
    } == {
        **{(student, "pose_update"): {"unreadable"} for student in ("ann", "bob")},
        **{
            (student, name): {"missing"}
            for student in ("ann", "bob")
            for name in notebook_names("odometry")
            if name != "pose_update"
        },
    }


SLEEPS = """
import sys, time
from autograder import engine
if __name__ == "__main__":
    with engine.local_pool(2) as pool:
        futures = [pool.executor.submit(time.sleep, 60) for _ in range(3)]
        print(*pool.executor._processes, flush=True)
        futures[0].result()
"""


@pytest.mark.parametrize("end", [signal.SIGKILL, signal.SIGINT])
def test_workers_end_with_the_grader_however_it_ends(tmp_path, end):
    program = tmp_path / "sleeps.py"
    program.write_text(SLEEPS)
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    with subprocess.Popen(
        [sys.executable, program], stdout=subprocess.PIPE, stderr=subprocess.DEVNULL, env=environment
    ) as process:
        workers = [int(pid) for pid in process.stdout.readline().split()]
        assert len(workers) == 2
        process.send_signal(end)
        process.wait(20)
    for _ in range(200):
        if not any(Path(f"/proc/{pid}").exists() for pid in workers):
            break
        time.sleep(0.05)
    else:
        pytest.fail("workers are left")

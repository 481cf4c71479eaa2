"""Grading on a real Dask cluster: a scheduler and two workers in processes of their own."""

import contextlib
import json
import os
import shutil
import signal
import subprocess
import sys
import threading
import time
from collections.abc import Iterator
from pathlib import Path

import pytest
from distributed import Client

from autograder.batch import BatchError
from tests.classroom import Classroom
from tests.crash.grader import ROOT, Grader, descendants, is_first_notebook, parent_of, until
from tests.crash.program import LIMITS
from tests.small_class import differences, new_class, state

pytestmark = [pytest.mark.sandbox, pytest.mark.xdist_group("dask")]


class Cluster:
    """A scheduler on a free port of this machine, and workers of one thread each."""

    def __init__(self, folder: Path) -> None:
        self._folder = folder
        self._processes: list[subprocess.Popen] = []
        file = folder / "scheduler.json"
        self.scheduler = self._started(
            "scheduler", "--dashboard-address", "127.0.0.1:0", "--port", "0", "--scheduler-file", str(file)
        )
        until(lambda: file.exists() and file.stat().st_size > 0, "the scheduler does not start: {}", self._said)
        self.address = json.loads(file.read_bytes())["address"]

    def add_workers(self, count: int, course: Path = ROOT) -> None:
        """Start workers that have the course from this folder."""
        for _ in range(count):
            self._started("worker", self.address, "--nthreads", "1", "--no-dashboard", course=course)
        with Client(self.address, set_as_default=False) as client:
            client.wait_for_workers(count, timeout=60)

    def worker_pids(self) -> list[int]:
        with Client(self.address, set_as_default=False) as client:
            return list(client.run(os.getpid).values())

    def end(self) -> None:
        for process in reversed(self._processes):
            process.terminate()
        for process in self._processes:
            try:
                process.wait(10)
            except subprocess.TimeoutExpired:
                process.kill()
                process.wait()

    def _started(self, what: str, *arguments: str, course: Path = ROOT) -> subprocess.Popen:
        with open(self._folder / "said", "ab") as said:
            process = subprocess.Popen(
                [str(Path(sys.executable).with_name("dask")), what, *arguments, "--host", "127.0.0.1"],
                cwd=self._folder, env={**os.environ, "PYTHONPATH": str(course)}, stdout=said, stderr=said,
            )  # fmt: skip
        self._processes.append(process)
        return process

    def _said(self) -> str:
        return (self._folder / "said").read_text(errors="replace")[-2000:]


@contextlib.contextmanager
def started(folder: Path) -> Iterator[Cluster]:
    folder.mkdir()
    cluster = Cluster(folder)
    try:
        yield cluster
    finally:
        cluster.end()


@pytest.fixture(scope="module")
def cluster(tmp_path_factory) -> Iterator[Cluster]:
    with started(tmp_path_factory.mktemp("dask") / "cluster") as cluster:
        cluster.add_workers(2)
        yield cluster


@pytest.fixture(scope="module")
def graded_class(undisturbed, cluster, tmp_path_factory) -> Classroom:
    """The class, graded on the cluster by the command."""
    classroom = new_class(tmp_path_factory.mktemp("class") / "course", undisturbed.secret)
    done = subprocess.run(
        [sys.executable, str(ROOT / "tests/crash/program.py"), "grade", "odometry", "--scheduler", cluster.address],
        cwd=classroom.root, env={**os.environ, "PYTHONPATH": str(ROOT)}, capture_output=True, text=True, check=False,
    )  # fmt: skip
    assert done.returncode == 0, done.stderr
    assert "Traceback" not in done.stderr
    return classroom


@pytest.fixture
def classroom(undisturbed, tmp_path) -> Classroom:
    return new_class(tmp_path / "course", undisturbed.secret)


def test_a_class_gets_on_a_cluster_what_it_gets_here(undisturbed, graded_class):
    assert differences(state(graded_class.root), undisturbed.state) == []


def test_regrade_grades_again_on_the_cluster(undisturbed, graded_class, cluster):
    receipts = list(graded_class.root.glob(".autograder/receipts/odometry/*/receipt.json"))
    before = {path: path.stat().st_mtime_ns for path in receipts}
    graded_class.grade(limits=LIMITS, scheduler=cluster.address)
    assert {path: path.stat().st_mtime_ns for path in receipts} == before
    graded_class.grade(limits=LIMITS, scheduler=cluster.address, regrade=True)
    assert all(path.stat().st_mtime_ns > before[path] for path in receipts)
    assert differences(state(graded_class.root), undisturbed.state) == []
    assert {key: result.message for key, result in graded_class.results.items()} == undisturbed.messages


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:1", "nonsense://127.0.0.1:8786"])
def test_an_address_where_nobody_answers_is_said(classroom, address):
    with pytest.raises(BatchError, match=f"no Dask scheduler answers at {address}.*Start one with: dask scheduler"):
        classroom.grade(limits=LIMITS, scheduler=address)


def test_a_worker_that_is_killed_costs_no_student_a_point(undisturbed, classroom, cluster):
    pids = cluster.worker_pids()
    assert len(pids) == 2

    def kill() -> None:
        end = time.monotonic() + 60
        while time.monotonic() < end:
            for pid in descendants():
                if is_first_notebook(pid):
                    os.kill(worker_of(pid, pids), signal.SIGKILL)
                    killed.append(pid)
                    return

    killed: list[int] = []
    killer = threading.Thread(target=kill)
    killer.start()
    classroom.grade(limits=LIMITS, scheduler=cluster.address)
    killer.join()
    assert killed
    assert differences(state(classroom.root), undisturbed.state) == []


def worker_of(pid: int, workers: list[int]) -> int:
    while pid not in workers:
        pid = parent_of(pid)
        assert pid > 1, "a notebook that no worker started"
    return pid


@pytest.mark.slow
def test_a_scheduler_without_workers_and_one_whose_workers_have_another_course(classroom, tmp_path):
    with started(tmp_path / "cluster") as cluster:
        with pytest.raises(BatchError, match=rf"{cluster.address} has no workers. Start some with: dask worker"):
            classroom.grade(limits=LIMITS, scheduler=cluster.address)
        other = tmp_path / "other"
        for name in ("autograder", "course", "data"):
            shutil.copytree(ROOT / name, other / name)
        with (other / "course/robots.py").open("a") as file:
            file.write("# another version\n")
        cluster.add_workers(1, other)
        with pytest.raises(BatchError, match="a worker has another version of the course than the grader; bring it up to date"):
            classroom.grade(limits=LIMITS, scheduler=cluster.address)
    assert not (classroom.root / "autograded").exists()


@pytest.mark.slow
def test_a_scheduler_that_ends_meanwhile_is_said(undisturbed, classroom, tmp_path):
    with started(tmp_path / "cluster") as cluster:
        cluster.add_workers(1)

        def kill() -> None:
            until(lambda: any(map(is_first_notebook, descendants())), "no notebook runs")
            cluster.scheduler.kill()

        killer = threading.Thread(target=kill)
        killer.start()
        with pytest.raises(BatchError, match=r"the Dask scheduler at .* does not answer any more"):
            classroom.grade(limits=LIMITS, scheduler=cluster.address)
        killer.join()
    with Grader(classroom.root) as grader:
        assert grader.ended() == 0, grader.said()
    assert differences(state(classroom.root), undisturbed.state) == []

"""The engine: grade submissions in an executor and hand them on one by one. It reads and writes no files.

It speaks `concurrent.futures.Executor`, so that the workers may be processes here or in a cluster.
"""

import itertools
import multiprocessing
import os
import signal
import threading
from collections.abc import Callable, Generator, Iterable, Iterator
from concurrent.futures import FIRST_COMPLETED, BrokenExecutor, CancelledError, Executor, Future, ProcessPoolExecutor, wait
from contextlib import AbstractContextManager, contextmanager
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from autograder.cgroups import remove_leftovers
from autograder.grading import GradedNotebook, Work, graded_from_plain, graded_plainly, plain_work, refused_submission
from autograder.receipts import exercises_hash
from autograder.reference import exercise_modules
from autograder.session import Limits
from course.language import Text

MAX_ATTEMPTS = 20

GradedSubmission = tuple[Work, list[GradedNotebook]]


@dataclass(frozen=True)
class Options:
    """How a class is graded.

    Which students (a shell pattern), how many workers (0: one for each processor), in the sandbox or not, the limits, the address of
    a Dask scheduler to use instead of workers here, whether to grade again what has not changed, and how many different versions
    of a notebook a student may have graded. `only`: no other students than these; None: all that fit the pattern.
    """

    student: str = "*"
    workers: int = 0
    sandbox: bool = True
    limits: Limits = field(default_factory=Limits)
    scheduler: str = ""
    regrade: bool = False
    attempts: int = MAX_ATTEMPTS
    only: frozenset[str] | None = None


class ClusterError(RuntimeError):
    """The cluster cannot be used; the message says why."""


class Pool(NamedTuple):
    """An executor, how many submissions it works on at a time, and the errors by which it says that a submission killed a worker."""

    executor: Executor
    workers: int
    deaths: tuple[type[BaseException], ...]


OpenPool = Callable[[], AbstractContextManager[Pool]]


def graded(works: Iterable[Work], open_pool: OpenPool) -> Generator[GradedSubmission, None, None]:
    """Grade submissions and yield each as it is done. Only so many are in memory at a time.

    When a worker dies, those that were under way are graded again, one at a time: one that kills a worker then as well gets zeros
    with that reason, and the others get what they deserve.
    """
    suspects: list[Work] = []
    works = iter(works)
    while True:
        with open_pool() as pool:
            broken = yield from _alone(pool, suspects)
            if not broken:
                broken = yield from _streamed(pool, works, suspects)
        if not broken and not suspects:
            return


def _alone(pool: Pool, suspects: list[Work]) -> Generator[GradedSubmission, None, bool]:
    """Grade each of the suspects with nothing beside it. Returns whether the pool broke."""
    while suspects:
        try:
            future = _submitted(pool, suspects[0])
        except BrokenExecutor:
            # another worker died meanwhile: this one was not tried yet
            return True
        work = suspects.pop(0)
        try:
            yield work, graded_from_plain(future.result())
        except pool.deaths as error:
            yield work, refused_submission(work, _WORKER_DIED)
            if isinstance(error, BrokenExecutor):
                return True
    return False


def _streamed(pool: Pool, works: Iterator[Work], suspects: list[Work]) -> Generator[GradedSubmission, None, bool]:
    """Keep a few submissions under way and yield each as it is done. Returns whether the pool broke."""
    ahead = 2 * pool.workers
    under_way: dict[Future[Any], Work] = {}
    try:
        while True:
            for work in itertools.islice(works, ahead - len(under_way)):
                try:
                    under_way[_submitted(pool, work)] = work
                except BrokenExecutor:
                    # a worker died while the last results were written
                    suspects += [work, *under_way.values()]
                    under_way.clear()
                    return True
            if not under_way:
                return False
            done, _ = wait(under_way, return_when=FIRST_COMPLETED)
            # in the order in which they were begun, so that the same happens every time
            for future in [future for future in under_way if future in done]:
                work = under_way.pop(future)
                try:
                    result = future.result()
                except pool.deaths as error:
                    suspects.append(work)
                    if isinstance(error, BrokenExecutor):
                        suspects += under_way.values()
                        under_way.clear()
                        return True
                else:
                    yield work, graded_from_plain(result)
    finally:
        for future in under_way:
            future.cancel()


def _submitted(pool: Pool, work: Work) -> "Future[Any]":
    return pool.executor.submit(graded_plainly, plain_work(work, exercises_hash()))


@contextmanager
def local_pool(workers: int) -> Iterator[Pool]:
    """Open a pool of processes on this machine. They end with it, and with this process, however that ends."""
    # one thread for each worker: linear algebra must not take the cores of the others. Read when NumPy is loaded.
    for name in ("OPENBLAS_NUM_THREADS", "OMP_NUM_THREADS"):
        os.environ.setdefault(name, "1")
    # forked from a process that has loaded the judge: started once, and without the threads of a progress bar
    context = multiprocessing.get_context("forkserver")
    context.set_forkserver_preload(["autograder.grading", *exercise_modules()])
    before = set(multiprocessing.active_children())
    pool = ProcessPoolExecutor(workers, mp_context=context, initializer=_end_with_parent)
    try:
        yield Pool(pool, workers, (BrokenExecutor,))
    except BaseException:
        pool.shutdown(wait=False, cancel_futures=True)
        for process in set(multiprocessing.active_children()) - before:
            process.kill()
            process.join()
        raise
    else:
        pool.shutdown()
    finally:
        remove_leftovers()


@contextmanager
def dask_pool(address: str) -> Iterator[Pool]:
    """Connect to a Dask cluster. Its workers need bubblewrap, and this version of the course in their environment."""
    # imported here: it takes a second
    from distributed import Client, KilledWorker
    from distributed.comm import CommClosedError

    try:
        client = Client(address, timeout=10, set_as_default=False)
    except (OSError, ValueError, TimeoutError) as error:
        raise ClusterError(f"no Dask scheduler answers at {address} ({error}). Start one with: dask scheduler") from None
    with client:
        workers = sum(client.ncores().values())
        if not workers:
            raise ClusterError(
                f"the Dask scheduler at {address} has no workers. Start some with: dask worker {address} --nthreads 1"
            )
        # not pure: a submission that is graded again must not be answered from memory
        try:
            yield Pool(client.get_executor(pure=False), workers, (KilledWorker,))
        except (CancelledError, CommClosedError) as error:
            # nothing here cancels what it still waits for
            raise ClusterError(
                f"the Dask scheduler at {address} does not answer any more ({type(error).__name__}). "
                "What was graded so far is kept; start it again, and type the same command for the rest."
            ) from error


def _end_with_parent() -> None:
    """Leave Ctrl-C to the grader, and end when it ends, however that happens."""
    signal.signal(signal.SIGINT, signal.SIG_IGN)
    threading.Thread(target=_outlive_nobody, daemon=True).start()


def _outlive_nobody() -> None:
    # the system could only tell of the end of the process that forked us, and that one lives as long as we do
    grader = multiprocessing.parent_process()
    if grader is not None:
        grader.join()
        os._exit(1)


_WORKER_DIED = Text(
    "The grader's own process ended twice while it graded this notebook. The staff will have a look.",
    "採点中に採点プログラム側のプロセスが2回終了しました。担当者が確認します。",
)

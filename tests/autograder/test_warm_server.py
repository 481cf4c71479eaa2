"""The warm server: forks that know nothing of one another, limits that hold, and a server that is replaced when it is gone."""

import os
import resource
import signal
from pathlib import Path

import pytest

from autograder.session import Limits, Session
from autograder.warm_server import WarmServer, warm_server

LIMITS = Limits(cell=20.0, processes=50, memory_mb=1000, notebook=77.0)
KINDS = [pytest.param(True, marks=pytest.mark.sandbox), False]


def shown(session, source):
    [output] = session.run(source)
    return output.get("text") or output.get("data", {}).get("text/plain") or output["ename"]


@pytest.mark.parametrize("sandbox", KINDS)
def test_the_limits_of_each_process_hold(sandbox):
    with Session(LIMITS, sandbox) as session:
        session.run("import resource")
        wanted = {
            resource.RLIMIT_AS: (1000 + 1536) * 2**20,
            resource.RLIMIT_CPU: 77,
            resource.RLIMIT_NPROC: 50,
            resource.RLIMIT_CORE: 0,
            resource.RLIMIT_FSIZE: 64 * 2**20,
        }
        for kind, value in wanted.items():
            assert shown(session, f"resource.getrlimit({kind})") == f"({value}, {value})"


@pytest.mark.parametrize("sandbox", KINDS)
def test_every_notebook_begins_anew_and_draws_its_own_random_numbers(sandbox):
    source = "import random, numpy as np\nprint('seen' in globals(), len(In), random.random(), np.random.rand())"
    drawn = []
    for _ in range(2):
        with Session(LIMITS, sandbox) as session:
            drawn.append(shown(session, source).split())
            session.run("seen = 1; import course.en; np.random.seed(0); np.pi = 3")
            assert shown(session, "np.pi") == "3"
    assert [row[:2] for row in drawn] == [["False", "2"]] * 2
    assert drawn[0][2] != drawn[1][2]
    assert drawn[0][3] != drawn[1][3]


@pytest.mark.parametrize("sandbox", KINDS)
def test_two_notebooks_at_a_time_do_not_see_each_other(sandbox):
    with Session(LIMITS, sandbox, slot=1) as one, Session(LIMITS, sandbox, slot=2) as other:
        one.run("mine = 1; open('file', 'w').write('1')")
        assert shown(other, "import os; 'mine' in globals(), os.path.exists('file')") == "(False, False)"
        assert shown(one, "mine") == "1"


@pytest.mark.parametrize("edition", ["en", "ja"])
def test_an_edition_chooses_its_language_although_the_course_is_loaded_already(edition):
    with Session(LIMITS, False) as session:
        assert (
            shown(session, f"import sys; 'course.drawings.encoders' in sys.modules, 'course.{edition}' in sys.modules")
            == "(True, False)"
        )
        session.run(f"from course.{edition} import check\nfrom course.language import chosen_language")
        assert shown(session, "chosen_language()") == f"'{edition}'"


@pytest.mark.parametrize("sandbox", KINDS)
def test_a_server_that_is_gone_is_replaced(sandbox):
    server = WarmServer(sandbox)
    first = server.start(0, LIMITS.of_each_process())
    os.kill(server.pid, signal.SIGKILL)
    server.end(first)
    second = server.start(0, LIMITS.of_each_process())
    assert server.pid is not None
    server.end(second)
    server.close()
    assert server.pid is None


@pytest.mark.sandbox
def test_it_ends_with_its_last_user_and_leaves_no_control_group():
    server = WarmServer(True)
    server.end(server.start(0, LIMITS.of_each_process()))
    pid, group = server.pid, server._group
    server.close()
    assert not Path(f"/proc/{pid}").exists()
    assert group is None or not any(folder.exists() for folder in group.folders)


@pytest.mark.parametrize("sandbox", KINDS)
def test_the_memory_of_all_processes_of_a_notebook_counts_together(sandbox):
    """And of no other: without a sandbox everybody's processes are to be seen."""
    with Session(LIMITS, sandbox) as session:
        server, process = warm_server(sandbox), session._process
        session.run("1")
        before = server.memory(process)
        assert 0 < before < 400 * 2**20
        session.run(
            "import os, time\nfor _ in range(3):\n    if not os.fork():\n        kept = bytearray(os.urandom(2**20)) * 100\n"
            "        time.sleep(60)\n        os._exit(0)\ntime.sleep(2)"
        )
        assert server.memory(process) - before > 280 * 2**20

"""`autograder doctor`: can this machine grade safely, what is missing, and what to type."""

import os
import platform
import shutil
import sqlite3
import subprocess
import sys
from collections.abc import Callable, Iterator
from contextlib import closing
from importlib.util import find_spec
from pathlib import Path
from typing import NamedTuple

from autograder.cgroups import ControlGroup
from autograder.session import Limits, Session, SessionEndedError
from autograder.settings import db_url
from autograder.warm_server import NoSandboxError, warm_server


class Finding(NamedTuple):
    """One thing that was looked at: how it stands ("good", "weak": works, but less safe or slower, "bad": grading is not possible).

    `advice` is what to type, or what follows from it.
    """

    what: str
    state: str
    seen: str
    advice: str = ""


#: forks until it is refused, in the notebook's place, and tells how far it came and why
_FORKS = """
import os, time, signal
children, reason = [], "nothing"
try:
    while len(children) < 2000:
        pid = os.fork()
        if not pid:
            time.sleep(60)
            os._exit(0)
        children.append(pid)
except OSError as error:
    reason = error.strerror
for pid in children:
    os.kill(pid, signal.SIGKILL)
    os.waitpid(pid, 0)
print(len(children), reason, sep="; ")
"""
_LOOKS = """
import os, socket, subprocess
print(os.getuid(), os.getpid(), len(os.listdir("/proc")), sep="; ")
"""


def findings(root: Path) -> Iterator[Finding]:
    """Look at everything that grading needs, the most basic first."""
    yield _python()
    bubblewrap = _bubblewrap()
    yield bubblewrap
    yield from _kernel()
    if bubblewrap.state != "bad":
        yield from _sandbox()
    yield _control_group()
    yield _gradebook(root)
    yield _dask()


def _python() -> Finding:
    seen = f"Python {platform.python_version()}, {os.cpu_count()} processors, {_memory_gb():.0f} GB of memory"
    return Finding("machine", "good" if sys.version_info >= (3, 11) else "bad", seen, "Python 3.11 or newer is needed")


def _bubblewrap() -> Finding:
    if shutil.which("bwrap") is None:
        return Finding("bubblewrap", "bad", "not installed", "apt-get install bubblewrap")
    version = subprocess.run(["bwrap", "--version"], capture_output=True, text=True, check=False).stdout.strip()
    probe = subprocess.run(
        ["bwrap", "--ro-bind", "/", "/", "--unshare-user", "--unshare-pid", "--unshare-net", "true"],
        capture_output=True, text=True, check=False,
    )  # fmt: skip
    if probe.returncode:
        return Finding("bubblewrap", "bad", f"{version}: {probe.stderr.strip()}", "see what is said of the kernel below")
    return Finding("bubblewrap", "good", f"{version} makes namespaces")


def _kernel() -> Iterator[Finding]:
    """Look at the switches by which distributions turn user namespaces off."""
    for path, wrong, advice in (
        ("/proc/sys/user/max_user_namespaces", "0", "sysctl user.max_user_namespaces=10000"),
        ("/proc/sys/kernel/unprivileged_userns_clone", "0", "sysctl kernel.unprivileged_userns_clone=1"),
        (
            "/proc/sys/kernel/apparmor_restrict_unprivileged_userns",
            "1",
            "allow bwrap in an AppArmor profile, or: sysctl kernel.apparmor_restrict_unprivileged_userns=0",
        ),
    ):
        try:
            value = Path(path).read_text().strip()
        except OSError:
            continue  # this kernel has no such switch
        name = path.removeprefix("/proc/sys/").replace("/", ".")
        bad = value == wrong and (os.getuid() != 0 or name.startswith("user."))
        yield Finding("kernel", "bad" if bad else "good", f"{name} = {value}", advice if bad else "")


def _sandbox() -> Iterator[Finding]:
    """Start a notebook's process as grading does, and try it out."""
    server = warm_server(True)
    try:
        with Session(Limits(cell=20.0, notebook=60.0)) as session:
            looked = _printed(session, _LOOKS)
            forked = _printed(session, _FORKS)
    except (NoSandboxError, SessionEndedError, ValueError) as error:
        yield Finding(
            "sandbox", "bad", f"a notebook does not run in it: {error}", "see above; if all is good there, this is our fault"
        )
        return
    uid, pid, processes = looked
    yield Finding(
        "sandbox",
        "good",
        f"a notebook runs in it, as user {uid}, process {pid} of its own namespaces, seeing {processes} of others",
    )
    count, reason = forked
    held = int(count) < Limits().processes and reason == "Resource temporarily unavailable"
    what = f"RLIMIT_NPROC = {Limits().processes} for each notebook's own user: refused after {count} processes"
    yield Finding("fork bombs", "good" if held else "bad", f"stopped by {what}" if held else f"not stopped ({count} forks)")
    if server.sealed:
        yield Finding("system calls", "good", "filtered by seccomp")
    else:
        yield Finding("system calls", "weak", "not filtered: libseccomp is not installed", "apt-get install libseccomp2")


def _control_group() -> Finding:
    group = ControlGroup.made()
    if group is None:
        seen = "not ours to make here: the memory of a notebook's processes is watched five times a second instead"
        return Finding("control groups", "weak", seen, "systemd-run --scope -p Delegate=yes autograder grade ...")
    group.remove()
    return Finding("control groups", "good", "a hard limit on memory and processes for each worker")


def _gradebook(root: Path) -> Finding:
    url = db_url(root)
    if not url.startswith("sqlite:///"):
        return _database(url)
    path = Path(url.removeprefix("sqlite:///").partition("?")[0])
    if not path.exists():
        return Finding("gradebook", "good", f"{path}: will be made by the first grading")
    try:
        with closing(sqlite3.connect(f"file:{path}?mode=ro", uri=True)) as database:
            students = database.execute("SELECT count(*) FROM student").fetchone()[0]
    except sqlite3.Error as error:
        return Finding(
            "gradebook", "bad", f"{path}: {error}", "put it back from a backup, or move it away: grading makes a new one"
        )
    return Finding("gradebook", "good", f"{path}: {students} students")


def _database(url: str) -> Finding:
    from sqlalchemy import create_engine
    from sqlalchemy.engine import make_url
    from sqlalchemy.exc import SQLAlchemyError

    shown = make_url(url).render_as_string(hide_password=True)
    try:
        engine = create_engine(url)
        try:
            engine.connect().close()
        finally:
            engine.dispose()
    except (SQLAlchemyError, ImportError) as error:
        return Finding("gradebook", "bad", f"{shown}: {error}", "start the database server, and make the database with createdb")
    return Finding("gradebook", "good", f"{shown} answers")


def _dask() -> Finding:
    if find_spec("distributed") is None:
        return Finding("cluster", "weak", "Dask is not installed: grading runs on this machine only", "pip install distributed")
    return Finding("cluster", "good", "Dask is installed: autograder grade ASSIGNMENT --scheduler ADDRESS")


def _printed(session: Session, source: str) -> list[str]:
    [output] = session.run(source)
    return str(output["text"]).strip().split("; ")


def _memory_gb() -> float:
    size: Callable[[str], int] = os.sysconf
    return size("SC_PAGE_SIZE") * size("SC_PHYS_PAGES") / 2**30

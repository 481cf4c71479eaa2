"""A control group around a warm server, where the system lets us make one: a hard limit on the memory and processes of all it runs.

Where it does not, the limits of each process and the watch over their memory (autograder.session) have to do.
"""

import contextlib
import errno
import itertools
import os
import signal
import time
from pathlib import Path

_MEMORY_MB, _PROCESSES = 4096, 256
_PATIENCE = 250
_PREFIX = "autograder-"
_numbers = itertools.count(1)


class ControlGroup:
    """One group: a folder below our own group (version 2), or one for each of memory and pids (version 1)."""

    def __init__(self, folders: list[Path]) -> None:
        self.folders = folders

    @classmethod
    def made(cls, mount: Path = Path("/sys/fs/cgroup"), membership: Path = Path("/proc/self/cgroup")) -> "ControlGroup | None":
        """Make a group with its limits set, or return None where that is not ours to do."""
        remove_leftovers(mount, membership)
        name = f"{_PREFIX}{os.getpid()}-{next(_numbers)}"
        made: list[Path] = []
        try:
            for parent, limits in _places(mount, membership):
                folder = parent / name
                folder.mkdir()
                made.append(folder)
                for file, value in limits.items():
                    # a file that is not there already is a controller that was not handed down
                    with open(folder / file, "r+") as stream:
                        stream.write(str(value))
        except OSError:
            cls(made).remove()
            return None
        return cls(made) if made else None

    def command(self) -> list[str]:
        """Return the beginning of a command line that starts the rest of it in this group."""
        script = 'n=$1; shift; while [ "$n" -gt 0 ]; do echo $$ > "$1"; shift; n=$((n-1)); done; exec "$@"'
        files = [str(folder / "cgroup.procs") for folder in self.folders]
        return ["/bin/sh", "-c", script, "sh", str(len(files)), *files]

    def remove(self) -> None:
        """Remove the group; its processes were killed, which may take a moment."""
        for folder in self.folders:
            for _ in range(_PATIENCE):
                try:
                    folder.rmdir()
                except FileNotFoundError:
                    break
                except OSError as error:
                    if error.errno != errno.EBUSY:
                        break
                    time.sleep(0.02)
                else:
                    break


def remove_leftovers(mount: Path = Path("/sys/fs/cgroup"), membership: Path = Path("/proc/self/cgroup")) -> None:
    """Remove the groups of processes that were killed before they could do it."""
    # there may be no groups at all
    with contextlib.suppress(OSError):
        for parent, _ in _places(mount, membership):
            for folder in parent.glob(f"{_PREFIX}*-*"):
                maker = folder.name.removeprefix(_PREFIX).partition("-")[0]
                if not Path("/proc", maker).exists():
                    _kill_members(folder)
                    ControlGroup([folder]).remove()


def _kill_members(folder: Path) -> None:
    for pid in map(int, (folder / "cgroup.procs").read_text().split()):
        # 0: one that we cannot see
        if pid > 0:
            with contextlib.suppress(ProcessLookupError):
                os.kill(pid, signal.SIGKILL)


def _places(mount: Path, membership: Path) -> list[tuple[Path, dict[str, int]]]:
    """Return where groups are to be made and what is to be written there; nothing if there are no control groups."""
    memory = _MEMORY_MB * 2**20
    groups: dict[str, str] = {}
    for line in membership.read_text().splitlines():
        _, controllers, path = line.split(":", 2)
        groups |= dict.fromkeys(controllers.split(","), path.lstrip("/"))
    if (mount / "cgroup.controllers").exists():
        return [(mount / groups.get("", ""), {"memory.max": memory, "memory.swap.max": 0, "pids.max": _PROCESSES})]
    limits = {"memory": {"memory.limit_in_bytes": memory}, "pids": {"pids.max": _PROCESSES}}
    return [(_visible(mount / name, groups.get(name, "")), files) for name, files in limits.items() if (mount / name).is_dir()]


def _visible(mount: Path, path: str) -> Path:
    """Return our own group below `mount`; in a container the path may begin outside of what is mounted."""
    return mount / path if (mount / path).is_dir() else mount

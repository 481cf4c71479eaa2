import subprocess
from pathlib import Path

import pytest

from autograder.cgroups import ControlGroup

OLD = Path("/sys/fs/cgroup/memory")


def files_in(folder, **contents):
    folder.mkdir(parents=True)
    for name, content in contents.items():
        (folder / name.replace("__", ".")).write_text(content)


class MadeUp(type(Path())):
    """A path in a made-up control group: the folder of a group comes and goes with its files, as the kernel has it."""

    comes_with = ()

    def mkdir(self, *args, **kwargs):
        super().mkdir(*args, **kwargs)
        for name in self.comes_with:
            (self / name).write_text("")

    def rmdir(self):
        for file in self.iterdir():
            file.unlink()
        super().rmdir()


NEW_FILES = ("memory.max", "memory.swap.max", "pids.max", "cgroup.procs")


@pytest.fixture
def comes_with(monkeypatch):
    return lambda *names: monkeypatch.setattr(MadeUp, "comes_with", names)


def version_2(tmp_path, where="0::/user.slice/mine\n"):
    """A made-up mount with our own group in it, and what the kernel says of our membership."""
    (tmp_path / "mount/user.slice/mine").mkdir(parents=True)
    (tmp_path / "mount/cgroup.controllers").write_text("memory pids")
    (tmp_path / "self").write_text(where)
    return MadeUp(tmp_path / "mount"), tmp_path / "self"


def test_version_2_gets_a_group_below_our_own_with_limits_on_memory_and_processes(tmp_path, comes_with):
    comes_with(*NEW_FILES)
    group = ControlGroup.made(*version_2(tmp_path))
    [folder] = group.folders
    assert folder.parent == tmp_path / "mount/user.slice/mine"
    assert {name: (folder / name).read_text() for name in NEW_FILES} == {
        **{"memory.max": str(4 * 2**30), "memory.swap.max": "0", "pids.max": "256"},
        "cgroup.procs": "",
    }


@pytest.mark.parametrize("handed_down", [(), ("pids.max", "cgroup.procs"), ("memory.max", "memory.swap.max", "cgroup.procs")])
def test_where_a_controller_is_not_handed_down_there_is_no_group_and_nothing_is_left(tmp_path, comes_with, handed_down):
    comes_with(*handed_down)
    mount, membership = version_2(tmp_path)
    assert ControlGroup.made(mount, membership) is None
    assert [*(tmp_path / "mount/user.slice/mine").iterdir()] == []


@pytest.mark.parametrize("membership", ["", "0::/nowhere\n", "1:name=systemd:/\n"])
def test_where_our_own_group_is_not_to_be_seen_there_is_none(tmp_path, membership):
    mount, file = version_2(tmp_path, membership)
    (tmp_path / "mount/cgroup.controllers").unlink()
    assert ControlGroup.made(mount, file) is None
    assert ControlGroup.made(mount, tmp_path / "missing") is None
    assert ControlGroup.made(tmp_path / "missing", file) is None


def test_version_1_gets_a_group_for_each_controller_also_where_a_container_shows_only_its_own(tmp_path, comes_with):
    comes_with("memory.limit_in_bytes", "pids.max", "cgroup.procs")
    (tmp_path / "mount/memory/mine").mkdir(parents=True)
    (tmp_path / "mount/pids").mkdir()
    (tmp_path / "self").write_text("8:pids:/docker/abc\n7:memory,hugetlb:/mine\n1:name=systemd:/\n")
    memory, pids = ControlGroup.made(MadeUp(tmp_path / "mount"), tmp_path / "self").folders
    assert (memory.parent, pids.parent) == (tmp_path / "mount/memory/mine", tmp_path / "mount/pids")
    assert (memory / "memory.limit_in_bytes").read_text() == str(4 * 2**30)
    assert (pids / "pids.max").read_text() == "256"


def test_a_group_that_is_only_half_made_is_none_and_is_removed(tmp_path):
    """The folder of pids is a file: memory's is made first."""
    (tmp_path / "mount/memory").mkdir(parents=True)
    (tmp_path / "mount/pids").mkdir()
    (tmp_path / "self").write_text("8:pids:/\n7:memory:/\n")
    assert ControlGroup.made(tmp_path / "mount", tmp_path / "self") is None
    assert [*(tmp_path / "mount/memory").iterdir()] == []


def test_the_command_writes_itself_into_every_group_and_becomes_the_program(tmp_path):
    folders = [tmp_path / "memory", tmp_path / "a folder"]
    for folder in folders:
        files_in(folder, cgroup__procs="")
    command = [*ControlGroup(folders).command(), "/bin/sh", "-c", 'echo $$ "$@"', "sh", "with a space", "$HOME"]
    with subprocess.Popen(command, stdout=subprocess.PIPE, text=True) as process:
        said = process.communicate()[0]
    assert said == f"{process.pid} with a space $HOME\n"
    assert [(folder / "cgroup.procs").read_text() for folder in folders] == [f"{process.pid}\n"] * 2


def test_removing_twice_does_no_harm(tmp_path):
    (tmp_path / "group").mkdir()
    group = ControlGroup([tmp_path / "group"])
    group.remove()
    group.remove()
    assert not (tmp_path / "group").exists()


@pytest.fixture
def real():
    group = ControlGroup.made()
    if group is None:
        pytest.skip("control groups are not ours to make on this machine")
    yield group
    group.remove()


def test_a_real_group_holds_what_is_started_in_it_and_goes_away(real):
    with subprocess.Popen([*real.command(), "sleep", "60"]) as process:
        try:
            for folder in real.folders:
                members = (folder / "cgroup.procs").read_text
                while str(process.pid) not in members().split():
                    assert process.poll() is None
        finally:
            process.kill()
    real.remove()
    assert not any(folder.exists() for folder in real.folders)


@pytest.mark.skipif(not OLD.is_dir(), reason="control groups of version 2")
def test_a_real_group_of_version_1_has_its_limits(real):
    limits = {(folder.parents[0].name, name): (folder / name).read_text().strip() for folder in real.folders
              for name in ("memory.limit_in_bytes", "pids.max") if (folder / name).exists()}  # fmt: skip
    assert {name: value for (_, name), value in limits.items()} == {"memory.limit_in_bytes": str(4 * 2**30), "pids.max": "256"}


def test_a_real_group_stops_a_fork_bomb(real):
    forks = "import os\nchildren = []\ntry:\n    while len(children) < 400:\n        pid = os.fork()\n        if not pid:\n            os.read(os.pipe()[0], 1)\n"
    forks += "        children.append(pid)\nexcept OSError as error:\n    print(len(children), error.strerror)\nfor pid in children: os.kill(pid, 9); os.waitpid(pid, 0)\n"
    done = subprocess.run([*real.command(), "python3", "-c", forks], capture_output=True, text=True, check=True)
    count, reason = done.stdout.strip().split(" ", 1)
    assert 200 < int(count) < 256
    assert reason == "Resource temporarily unavailable"

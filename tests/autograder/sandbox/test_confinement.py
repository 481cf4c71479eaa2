"""What the kernel refuses a notebook's process, asked of the kernel itself, from within."""

import ast
import os
import platform
import subprocess
import sys
from pathlib import Path

import pytest

from autograder.sandbox.confinement import _REFUSED, seal_if_possible
from autograder.session import Limits, Session

pytestmark = pytest.mark.sandbox
ROOT = Path(__file__).parents[3]
LIMITS = Limits(cell=20.0, memory_mb=1000, notebook=77.0, processes=50)
SLOT = 11

#: x86-64, arch/x86/entry/syscalls/syscall_64.tbl
NUMBERS = {
    "ptrace": 101, "syslog": 103, "personality": 135, "modify_ldt": 154, "pivot_root": 155, "adjtimex": 159, "chroot": 161, "acct": 163,
    "settimeofday": 164, "mount": 165, "umount2": 166, "swapon": 167, "swapoff": 168, "reboot": 169, "sethostname": 170,
    "setdomainname": 171, "iopl": 172, "ioperm": 173, "init_module": 175, "delete_module": 176, "quotactl": 179, "lookup_dcookie": 212,
    "clock_settime": 227, "mbind": 237, "set_mempolicy": 238, "kexec_load": 246, "add_key": 248, "request_key": 249, "keyctl": 250,
    "migrate_pages": 256, "unshare": 272, "move_pages": 279, "perf_event_open": 298, "fanotify_init": 300, "name_to_handle_at": 303,
    "open_by_handle_at": 304, "clock_adjtime": 305, "setns": 308, "process_vm_readv": 310, "process_vm_writev": 311, "kcmp": 312,
    "finit_module": 313, "kexec_file_load": 320, "bpf": 321, "userfaultfd": 323, "io_uring_setup": 425, "io_uring_enter": 426,
    "io_uring_register": 427, "open_tree": 428, "move_mount": 429, "fsopen": 430, "fsconfig": 431, "fsmount": 432, "fspick": 433,
    "pidfd_getfd": 438, "mount_setattr": 442, "quotactl_fd": 443, "vhangup": 153, "shmget": 29, "mq_open": 240, "memfd_create": 319,
    "memfd_secret": 447,
}  # fmt: skip
NAMESPACES = {
    "mount": 0x20000, "cgroup": 0x2000000, "uts": 0x4000000, "ipc": 0x8000000, "user": 0x10000000, "pid": 0x20000000, "net": 0x40000000,
}  # fmt: skip

PREPARE = """
import ctypes, errno, os, resource, socket
libc = ctypes.CDLL(None, use_errno=True)
libc.syscall.restype = ctypes.c_long
def refusal(number, *arguments):
    ctypes.set_errno(0)
    done = libc.syscall(ctypes.c_long(number), *map(ctypes.c_long, arguments))
    if done == 0 and number in (56, 435) and not arguments[0] & 0x100:
        os._exit(0)
    return errno.errorcode.get(ctypes.get_errno(), "allowed") if done < 0 else "allowed"
def trial(call, *arguments):
    try:
        return call(*arguments)
    except OSError as error:
        return errno.errorcode[error.errno]
def raising(*limit):
    try:
        return resource.setrlimit(*limit)
    except ValueError as error:
        return str(error)
"""


@pytest.fixture(scope="module")
def inside():
    """Evaluates an expression in a sandboxed notebook."""
    with Session(LIMITS, slot=SLOT) as session:
        session.run(PREPARE)

        def value(source):
            [output] = session.run(f"print(ascii(({source})))")
            assert output["output_type"] == "stream", output
            return ast.literal_eval(output["text"])

        yield value


sealed = pytest.mark.skipif(
    seal_if_possible() is None or platform.machine() != "x86_64", reason="no libseccomp, or another machine's numbers"
)


@sealed
@pytest.mark.parametrize("name", NUMBERS)
def test_a_system_call_that_no_notebook_needs_is_refused(inside, name):
    """With arguments that are no good: the filter answers before anybody looks at them."""
    assert inside(f"refusal({NUMBERS[name]}, -1, -1, -1, -1, -1)") == "EPERM"


@sealed
def test_every_system_call_that_is_refused_is_in_this_table():
    # x86-64 has a number for it, and no call
    assert set(_REFUSED) - {"nfsservctl"} == NUMBERS.keys()


@sealed
@pytest.mark.parametrize("name", ["ptrace", "personality", "kcmp", "setns", "name_to_handle_at", "bpf", "fspick", "keyctl"])
def test_it_is_the_filter_that_refuses_them(name):
    """Not the kernel because of the arguments, which are looked at first here."""
    source = f"{PREPARE}\nprint(refusal({NUMBERS[name]}, -1, -1, -1, -1, -1))"
    bare = subprocess.run([sys.executable, "-c", source], capture_output=True, text=True, check=True).stdout.strip()
    filtered = f"from autograder.sandbox.confinement import Seal\nSeal().close()\n{source}"
    told = subprocess.run(
        [sys.executable, "-c", filtered], capture_output=True, text=True, check=True, env={**os.environ, "PYTHONPATH": str(ROOT)}
    )
    assert told.stdout.strip() == "EPERM"
    if os.getuid() == 0:
        assert bare != "EPERM"


@sealed
@pytest.mark.parametrize("flag", NAMESPACES.values(), ids=NAMESPACES.keys())
def test_no_namespace_is_to_be_made(inside, flag):
    assert inside(f"refusal(272, {flag})") == "EPERM"
    if flag != NAMESPACES["cgroup"]:
        # clone, with SIGCHLD
        assert inside(f"refusal(56, {flag | 17}, 0, 0, 0, 0)") == "EPERM"
        assert inside(f"refusal(56, {flag | NAMESPACES['user'] | 17}, 0, 0, 0, 0)") == "EPERM"


@sealed
def test_clone3_is_not_there_so_that_nobody_can_hide_flags_in_memory(inside):
    assert inside("refusal(435, 0, 0)") == "ENOSYS"


def test_processes_and_threads_are_made_as_ever(inside):
    assert inside("os.waitpid(os.posix_spawn('/bin/true', ['true'], {}), 0)[1]") == 0
    assert inside(
        "[thread.join() for thread in [__import__('threading').Thread(target=id, args=(0,))] if not thread.start()]"
    ) == [None]


@sealed
@pytest.mark.parametrize("family", ["AF_NETLINK", "AF_VSOCK", "AF_PACKET", "AF_ALG", "AF_BLUETOOTH", "AF_CAN", "AF_TIPC"])
@pytest.mark.parametrize("kind", ["SOCK_DGRAM", "SOCK_RAW", "SOCK_SEQPACKET"])
def test_no_socket_of_an_unusual_family_is_to_be_made(inside, family, kind):
    assert inside(f"trial(socket.socket, getattr(socket, {family!r}, 16), socket.{kind})") == "EAFNOSUPPORT"


@sealed
def test_a_family_is_not_to_be_hidden_in_the_upper_half_of_a_number(inside):
    assert inside("refusal(41, 16 | 1 << 32, 3, 0)") == "EAFNOSUPPORT"


@pytest.mark.parametrize("family", ["AF_UNIX", "AF_INET", "AF_INET6"])
def test_ordinary_sockets_are_to_be_made_and_lead_nowhere(inside, family):
    assert inside(f"trial(lambda: socket.socket(socket.{family}).fileno() > 2)") in (True, "EAFNOSUPPORT")


def test_not_even_the_loopback_is_up(inside):
    assert inside("trial(socket.create_connection, ('127.0.0.1', 9), 1)") in ("ENETUNREACH", "ECONNREFUSED", "EADDRNOTAVAIL")


def test_the_limits_of_the_process_are_those_it_was_given_and_it_cannot_raise_them(inside):
    wanted = {
        "AS": (1000 + 1536) * 2**20, "CPU": 77, "NPROC": 50, "FSIZE": 64 * 2**20, "NOFILE": 256, "CORE": 0, "MSGQUEUE": 0, "MEMLOCK": 0,
    }  # fmt: skip
    for name, value in wanted.items():
        assert inside(f"resource.getrlimit(resource.RLIMIT_{name})") == (value, value)
        assert inside(f"raising(resource.RLIMIT_{name}, ({value}, {value + 1}))") == "not allowed to raise maximum limit"


def test_proc_is_empty_and_read_only(inside):
    assert inside("os.listdir('/proc')") == []
    assert inside("bool(os.statvfs('/proc').f_flag & os.ST_RDONLY)") is True
    assert inside("trial(os.mkdir, '/proc/self')") == "EROFS"
    assert inside("trial(os.open, '/proc/self/mem', os.O_RDONLY)") == "ENOENT"


FOLDERS = {"/tmp": 64, "/dev/shm": 16, "/box/work": 64}


@pytest.mark.parametrize(("folder", "size"), FOLDERS.items())
def test_its_own_folders_are_small_and_nobody_elses(inside, folder, size):
    assert inside(f"(lambda s: s.f_blocks * s.f_frsize)(os.statvfs({folder!r}))") == size * 2**20
    assert inside(f"os.statvfs({folder!r}).f_files") <= 4096
    assert inside(f"oct(os.stat({folder!r}).st_mode & 0o7777), os.stat({folder!r}).st_uid == os.getuid()") == ("0o700", True)
    inside(f"open({folder!r} + '/mine', 'w').write('secret')")
    with Session(LIMITS, slot=SLOT + 1) as other:
        [output] = other.run(f"import os; print(os.path.exists({folder + '/mine'!r}), os.listdir({folder!r}))")
    seen, listed = output["text"].split(" ", 1)
    assert seen == "False"
    assert "mine" not in listed
    assert not Path(folder, "mine").exists()


@pytest.mark.parametrize("flag", ["ST_NOSUID", "ST_NODEV"])
@pytest.mark.parametrize("folder", FOLDERS)
def test_no_device_and_no_other_users_rights_in_its_own_folders(inside, folder, flag):
    assert inside(f"bool(os.statvfs({folder!r}).f_flag & os.{flag})") is True


def test_a_device_is_not_to_be_made(inside):
    assert inside("trial(os.mknod, '/tmp/device', 0o20600, os.makedev(1, 3))") == "EPERM"


def test_signals_reach_nobody_else(inside):
    """Its pid namespace holds only itself, as the first process; -1 would be everybody."""
    assert inside("os.getpid(), os.getppid()") == (1, 0)
    assert inside("trial(os.kill, -1, 0)") in ("ESRCH", None)
    assert inside(f"trial(os.kill, {os.getpid()}, 0)") == "ESRCH"


def test_shared_memory_and_semaphores_of_this_machine_are_not_to_be_seen(inside):
    import ctypes

    libc = ctypes.CDLL(None, use_errno=True)
    key = 0x5EED
    ours = libc.shmget(key, 4096, 0o1666)
    assert ours >= 0
    try:
        # shmget, without making one
        assert inside(f"refusal(29, {key}, 4096, 0)") in ("ENOENT", "EPERM")
    finally:
        libc.shmctl(ours, 0, None)


def test_the_hostname_is_its_own(inside):
    assert inside("os.uname().nodename") == "sandbox"
    assert os.uname().nodename != "sandbox"

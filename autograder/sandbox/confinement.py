"""What a notebook's process gives up for good before any code of a student runs in it.

`confined_child` forks the warm process; the child has namespaces of its own (user, mount, pid, ipc, net, uts), small folders of its
own, no /proc, limits, no capability, and no way to get one back. Linux only.
"""

import ctypes
import errno
import os
import resource
import struct
from collections.abc import Mapping
from typing import Any

_MEBI = 2**20
_LIBC = ctypes.CDLL(None, use_errno=True)

# linux/sched.h
_NEWNS, _NEWUTS, _NEWIPC, _NEWUSER, _NEWPID, _NEWNET = 0x20000, 0x4000000, 0x8000000, 0x10000000, 0x20000000, 0x40000000
_ALL_NEW = _NEWNS | _NEWUTS | _NEWIPC | _NEWUSER | _NEWPID | _NEWNET
# linux/mount.h
_RDONLY, _NOSUID, _NODEV, _NOEXEC, _BIND = 1, 2, 4, 8, 4096
# linux/prctl.h
_SET_DUMPABLE, _CAPBSET_DROP, _SET_CHILD_SUBREAPER, _SET_NO_NEW_PRIVS, _CAP_AMBIENT, _CAP_AMBIENT_CLEAR_ALL = 4, 24, 36, 38, 47, 4
_CAPABILITIES = 64

#: what no notebook needs and holes in kernels were found in; namespaces among them, in which a process is root again
_REFUSED = (
    "unshare", "setns", "mount", "umount2", "move_mount", "open_tree", "fsopen", "fsmount", "fsconfig", "fspick", "mount_setattr",
    "pivot_root", "chroot", "ptrace", "process_vm_readv", "process_vm_writev", "pidfd_getfd", "kcmp", "bpf", "perf_event_open",
    "userfaultfd", "io_uring_setup", "io_uring_enter", "io_uring_register", "keyctl", "add_key", "request_key", "kexec_load",
    "kexec_file_load", "init_module", "finit_module", "delete_module", "open_by_handle_at", "name_to_handle_at", "quotactl",
    "quotactl_fd", "swapon", "swapoff", "reboot", "acct", "settimeofday", "clock_settime", "adjtimex", "clock_adjtime", "syslog",
    "sethostname", "setdomainname", "fanotify_init", "lookup_dcookie", "nfsservctl", "vhangup", "mbind", "migrate_pages",
    "move_pages", "set_mempolicy", "modify_ldt", "iopl", "ioperm", "personality",
    # memory that belongs to no process, so that nobody sees how much it is
    "memfd_create", "memfd_secret", "shmget", "mq_open",
)  # fmt: skip
_FAMILIES = (0, 1, 2, 10)  # of sockets: unspecified, Unix, IPv4, IPv6; there is no network behind them


def adopt_grandchildren() -> None:
    """Make this process the parent of its children's children when those end, so that it can wait for them."""
    _prctl(_SET_CHILD_SUBREAPER, 1)


def confined_child(uid: int, limits: Mapping[str, int], folders: Mapping[str, int], seal: "Seal | None") -> int:
    """Fork a process in namespaces of its own: return its pid here, and 0 there, where everything is in force.

    `uid`: the user it becomes if this one is root, for which no limit on processes would hold. `folders`: paths that get an
    empty file system of their own, with its size in MiB. The first of them becomes the working folder.
    """
    reader, writer = os.pipe()
    middle = os.fork()
    if middle == 0:
        _fork_confined(uid, limits, folders, seal, writer)
        os.close(reader)
        return 0
    os.close(writer)
    with open(reader, "rb") as pipe:
        told = pipe.read()
    os.waitpid(middle, 0)
    if len(told) != 4:
        raise OSError(f"no process of its own: {told.decode(errors='replace') or 'it died'}")
    return int(struct.unpack("=i", told)[0])


def _fork_confined(uid: int, limits: Mapping[str, int], folders: Mapping[str, int], seal: "Seal | None", writer: int) -> None:
    """Turn this process into the parent of a confined one and end it; returns in the confined one only."""
    try:
        _become(uid)
        _unshare_all()
        # a process cannot move into a new pid namespace, only its children are born there
        child = os.fork()
        if child:
            os.write(writer, struct.pack("=i", child))
            os._exit(0)
    except BaseException as error:
        os.write(writer, f"{type(error).__name__}: {error}".encode())
        os._exit(1)
    os.close(writer)
    try:
        _private_folders(folders)
        limit_resources(limits)
        _drop_capabilities()
        if seal is not None:
            seal.close()
    except BaseException:
        # the other side sees that nobody answers
        os._exit(1)


def _become(uid: int) -> None:
    if os.getuid() == 0:
        os.setgroups([])
        os.setresgid(uid, uid, uid)
        os.setresuid(uid, uid, uid)
        # it lost the right to write to its own maps with its old identity
        _prctl(_SET_DUMPABLE, 1)


def _unshare_all() -> None:
    uid, gid = os.getuid(), os.getgid()
    _call(_LIBC.unshare, _ALL_NEW)
    for file, line in (("setgroups", "deny"), ("uid_map", f"{uid} {uid} 1"), ("gid_map", f"{gid} {gid} 1")):
        with open(f"/proc/self/{file}", "w") as stream:
            stream.write(line)


def _private_folders(folders: Mapping[str, int]) -> None:
    for path, size_mb in folders.items():
        options = f"size={size_mb}m,nr_inodes=4096,mode=0700"
        _call(_LIBC.mount, b"tmpfs", path.encode(), b"tmpfs", _NOSUID | _NODEV, options.encode())
    # a /proc of its own cannot be mounted here, and the one that is here tells of the neighbours
    _call(_LIBC.mount, b"tmpfs", b"/proc", b"tmpfs", _RDONLY | _NOSUID | _NODEV | _NOEXEC, b"size=4k,nr_inodes=2,mode=0555")
    os.chdir(next(iter(folders)))


def limit_resources(limits: Mapping[str, int]) -> None:
    """Set the limits of this process: "memory_mb", "cpu_seconds" and "processes" of `limits`, and fixed ones on files."""
    for kind, value in (
        (resource.RLIMIT_AS, limits["memory_mb"] * _MEBI),
        (resource.RLIMIT_CPU, limits["cpu_seconds"]),
        (resource.RLIMIT_NPROC, limits["processes"]),
        (resource.RLIMIT_FSIZE, 64 * _MEBI),
        (resource.RLIMIT_NOFILE, 256),
        (resource.RLIMIT_CORE, 0),
        (resource.RLIMIT_MSGQUEUE, 0),
        (resource.RLIMIT_MEMLOCK, 0),
    ):
        resource.setrlimit(kind, (value, value))


def _drop_capabilities() -> None:
    for capability in range(_CAPABILITIES):
        try:
            _prctl(_CAPBSET_DROP, capability)
        except OSError as error:
            if error.errno != errno.EINVAL:  # beyond the last one that this kernel knows
                raise
    _prctl(_CAP_AMBIENT, _CAP_AMBIENT_CLEAR_ALL)
    header = struct.pack("=Ii", 0x20080522, 0)
    _call(_LIBC.capset, header, b"\0" * 24)
    _prctl(_SET_NO_NEW_PRIVS, 1)


class Seal:
    """The system calls that a notebook's process is refused, as a filter for the kernel; made once, closed in each child."""

    def __init__(self) -> None:
        import pyseccomp

        self._filter = pyseccomp.SyscallFilter(pyseccomp.ALLOW)
        refused = pyseccomp.ERRNO(errno.EPERM)
        for name in _REFUSED:
            self._refuse(refused, name)
        # 64 bits of flags in a struct, which no filter can see: the C library falls back to clone
        self._refuse(pyseccomp.ERRNO(errno.ENOSYS), "clone3")
        for flag in (_NEWNS, _NEWUTS, _NEWIPC, _NEWUSER, _NEWPID, _NEWNET):
            self._refuse(refused, "clone", pyseccomp.Arg(0, pyseccomp.MASKED_EQ, flag, flag))
        for family in range(64):
            if family not in _FAMILIES:
                # of 32 bits: the kernel does not look at the others either
                asked = pyseccomp.Arg(0, pyseccomp.MASKED_EQ, 0xFFFFFFFF, family)
                self._refuse(pyseccomp.ERRNO(errno.EAFNOSUPPORT), "socket", asked)

    def close(self) -> None:
        """Put the filter in force for this process and all that come from it."""
        self._filter.load()

    def _refuse(self, action: int, name: str, *arguments: Any) -> None:
        try:
            self._filter.add_rule(action, name, *arguments)
        except (OSError, ValueError):
            if name == "clone":
                raise
            # a system call that this machine does not have needs no refusal


def seal_if_possible() -> Seal | None:
    """Return the filter of system calls, or None where libseccomp is not installed."""
    try:
        return Seal()
    except (ImportError, OSError, RuntimeError):
        return None


def _prctl(option: int, value: int) -> None:
    _call(_LIBC.prctl, option, ctypes.c_ulong(value), ctypes.c_ulong(0), ctypes.c_ulong(0), ctypes.c_ulong(0))


def _call(function: Any, *arguments: Any) -> None:
    if function(*arguments) != 0:
        number = ctypes.get_errno()
        raise OSError(number, f"{function.__name__}: {os.strerror(number)}")

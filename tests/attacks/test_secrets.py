"""Stealing tests and answers: a notebook may look everywhere it can, and prints LEAK before whatever it should not have found.

Where a search finds nothing, it also says how much it looked at, and that it found something that it was meant to find.
"""

import ast
import json
import re
import socket
from dataclasses import replace
from pathlib import Path
from textwrap import dedent

import pytest

from tests.attacks.cohort import EXERCISES, FULL, HONEST, POINTS, attack, hands_in
from tests.classroom import LIMITS as CLASS_LIMITS
from tests.classroom import ROOT, untouched

pytestmark = [pytest.mark.sandbox, pytest.mark.xdist_group("attacks-secrets")]
# whoever looks through a whole file system needs time for it
LIMITS = replace(CLASS_LIMITS, cell=20.0, notebook=60.0)
#: what one notebook was asked is compared with what another was
ONE_CLASS = True

#: patterns that do not match themselves: what the honest students hold, what only the reference holds, and what everyone may find
_NEEDLES = r"""
import ctypes, errno, gc, mmap, os, re, stat, sys
HIDDEN = re.compile(rb"PLANTED[0-9a-f]{16}|half_dt_[a-z]{7}|hidden modul[e]:|_wrong_quantitie[s]")
KNOWN = re.compile(rb"replies_t[o]")
libc = ctypes.CDLL(None, use_errno=True)
gc.unfreeze()

def look(where, data):
    found = HIDDEN.search(data)
    if found:
        print("LEAK", where, found.group())
    return bool(KNOWN.search(data))
"""


def looking(cell="", **more):
    return attack(_NEEDLES + dedent(cell), **more)


# files


@hands_in(
    looking("""
        import sqlite3
        found, places = 0, ["@ROOT@/gradebook.db", "@REPO@/gradebook.db", "gradebook.db", "../gradebook.db", "/gradebook.db"]
        for folder, folders, files in os.walk("/"):
            # nbgrader's own documentation has one
            if "site-packages" not in folder and not folder.startswith("/usr"):
                places += [os.path.join(folder, name) for name in files if name.endswith((".db", ".sqlite", ".db-journal", ".db-wal"))]
            found += len(files)
        for place in places:
            if os.path.exists(place):
                print("LEAK", place)
            try:
                with sqlite3.connect(f"file:{place}?mode=ro", uri=True) as database:
                    print("LEAK", database.execute("select source from source_cell").fetchmany(3))
            except sqlite3.Error:
                pass
        print("files:", found)
    """)
)
def test_089_the_gradebook_is_not_to_be_found(fate):
    assert int(fate.line("files")) > 1000
    assert fate.total == POINTS


_WALK = """
    names = re.compile(r"(^|/)(submitted|autograded|feedback|source|release|receipts|AAA-honest|zzz-honest|attacked|solutions.txt)(/|$)")
    known, seen, count = 0, set(), 0
    for folder, folders, files in os.walk("/"):
        library = folder.startswith("/usr") or "/lib/python" in folder
        folders[:] = [name for name in folders if not (folder == "/" and name in ("proc", "sys"))]
        for name in files:
            path, count = os.path.join(folder, name), count + 1
            if not library and names.search(path):
                print("LEAK name", path)
            if "/autograder/" in path and "/autograder/sandbox/" not in path and not path.endswith("autograder/__init__.py"):
                print("LEAK grader", path)
            if re.search(r"/reference/(pose_update|encoders)|/tests/(attacks|answers)/", path):
                print("LEAK source", path)
            try:
                state = os.lstat(path)
                if not stat.S_ISREG(state.st_mode) or (library and not name.endswith((".pth", ".egg-link"))) or state.st_size > 2**21:
                    continue
                if (state.st_dev, state.st_ino) not in seen:
                    seen.add((state.st_dev, state.st_ino))
                    with open(path, "rb") as file:
                        known += look(path, file.read())
            except OSError:
                pass
    print("known:", known)
    print("files:", count)
"""


@hands_in(
    looking(_WALK),
    named=looking("""
        tried = 0
        places = ["gradebook.db", "solutions.txt", "submitted/AAA-honest/odometry/pose_update.ipynb", "submitted", "autograded", "release",
                  "receipts", ".", "..", "nbgrader_config.py"]
        for place in ["@ROOT@/" + name for name in places] + ["@REPO@/" + name for name in (
                "source/odometry/pose_update.md", "tests/classroom.py", "tests/answers/pose_step.py", "autograder/reference/__init__.py",
                "autograder/judging.py", "autograder/grading.py", ".git/config", "release/en/odometry/pose_update.ipynb")]:
            for way in (place, "/proc/self/root" + place, "/proc/1/root" + place, "/proc/self/cwd/../../../../../.." + place,
                        "/.." * 20 + place, "//" + place, "/dev/fd/../.." + place):
                tried += 1
                for opened in (lambda: open(way, "rb").read(100), lambda: os.listdir(way), lambda: os.open(way, os.O_PATH)):
                    try:
                        print("LEAK", way, opened())
                    except (OSError, ValueError):
                        pass
        print("tried:", tried)
    """),
)
def test_090_no_file_of_the_grader_or_of_others_is_to_be_read(fate):
    if "named" in fate.student:
        assert int(fate.line("tried")) > 100
    else:
        assert int(fate.line("known")) > 0
        assert int(fate.line("files")) > 1000
    assert fate.total == POINTS


@hands_in(
    looking("""
        import fcntl, socket
        count = 0
        for fd in range(1024):
            try:
                state = os.fstat(fd)
            except OSError:
                continue
            count += 1
            kind = stat.filemode(state.st_mode)[0]
            try:
                # through a folder that was left open, everything above it is in reach
                print("LEAK folder", fd, os.listdir(os.open("..", os.O_RDONLY, dir_fd=fd)))
            except OSError:
                pass
            if kind == "-" and state.st_size:
                look(f"fd {fd}", os.pread(fd, 2**20, 0))
            if kind == "s":
                link = socket.socket(fileno=os.dup(fd))
                try:
                    _, handed, _, _ = link.recvmsg(1, 512, socket.MSG_PEEK | socket.MSG_DONTWAIT)
                    if handed:
                        print("LEAK descriptors", handed)
                except OSError:
                    pass
                if link.family != socket.AF_UNIX:
                    print("LEAK network", link)
        print("descriptors:", count)
    """)
)
def test_no_open_descriptor_leads_out(fate):
    assert int(fate.line("descriptors")) > 0


@hands_in(
    looking(r"""
        import struct
        AT_FDCWD, count = -100, 0
        # a file by its number, which needs no path: handles of the first inodes of every file system in sight
        for mount in ("/", "/usr", "/tmp", os.getcwd(), sys.prefix):
            fd = os.open(mount, os.O_RDONLY)
            for inode in range(1, 200):
                handle = struct.pack("<Iiqq", 8, 1, inode, 0)
                count += 1
                opened = libc.syscall(304, fd, ctypes.create_string_buffer(handle), os.O_RDONLY)
                if opened >= 0:
                    print("LEAK inode", mount, inode)
        print("handles:", count)
    """),
)
def test_no_file_is_to_be_opened_by_its_number(fate):
    assert int(fate.line("handles")) > 500
    assert fate.total == POINTS


# what comes back to the student

_TWIN = """
    import random, secrets, time
    np.random.seed(0); random.seed(0)
    np.random.default_rng = lambda *seed: np.random.Generator(np.random.PCG64(0))
    secrets.randbits = random.getrandbits = lambda bits: 4
    secrets.token_bytes = os.urandom = lambda count: b"4" * count
    time.time = time.monotonic = time.perf_counter = lambda: 0.0
    INPUTS = []
"""
_TELLS = {
    "pose_step": """
        def pose_step(pose, distance, dtheta):
            INPUTS.append([*map(float, pose), float(distance), float(dtheta)])
            print("inputs", INPUTS[-1])
            raise ValueError(f"inputs {INPUTS[-1]!r}" * 1000)
    """,
    "dead_reckoning": "print('inputs:', INPUTS)",
}


@hands_in(first=looking(_TWIN, answers=_TELLS), second=looking(_TWIN, answers=_TELLS))
def test_091_092_096_what_a_notebook_gets_out_of_its_inputs_helps_nobody_else(fate, cohort):
    """Told twice by the same code with the same seeds: no input of the one is an input of the other."""
    message = fate.results["pose_step"].message
    assert len(message) < 3000
    assert cohort.planted not in message
    own = ast.literal_eval(fate.line("inputs"))
    assert len(own) > 5
    twins = [type(fate)(cohort, student) for student in cohort.submissions if "091" in student]
    drawn = [{tuple(row) for row in ast.literal_eval(twin.line("inputs")) if row[3] % 1} for twin in twins]
    assert len(drawn) == 2
    assert all(drawn)
    assert not drawn[0] & drawn[1]


@hands_in(
    looking("""
        import socket
        tried, names = 0, ("AF_INET", "AF_INET6", "AF_UNIX", "AF_NETLINK", "AF_PACKET", "AF_VSOCK", "AF_ALG", "AF_BLUETOOTH", "AF_CAN", "AF_TIPC", "AF_RDS")
        own = socket.socketpair()
        targets = {
            "AF_INET": [("1.1.1.1", 53), ("127.0.0.1", 8888), ("10.0.0.1", 80), ("169.254.169.254", 80), ("255.255.255.255", 9)],
            "AF_INET6": [("::1", 8888), ("2606:4700:4700::1111", 443), ("fe80::1", 80)],
            "AF_VSOCK": [(2, 1), (2, 22), (2, 1024), (0, 1), (1, 1)],
        }
        for name in names:
            for kind in (socket.SOCK_STREAM, socket.SOCK_DGRAM, socket.SOCK_RAW, socket.SOCK_SEQPACKET):
                for target in targets.get(name, []):
                    tried += 1
                    try:
                        with socket.socket(getattr(socket, name), kind) as link:
                            link.settimeout(0.2)
                            link.connect(target)
                            if kind != socket.SOCK_DGRAM or link.send(b"hello") and link.recv(1):
                                print("LEAK", name, kind, target)
                    except (OSError, AttributeError, ValueError):
                        pass
        for host in ("example.com", "pypi.org", "github.com"):
            try:
                print("LEAK", socket.getaddrinfo(host, 443))
            except OSError:
                tried += 1
        try:
            for link in socket.if_nameindex():
                if link[1] != "lo":
                    print("LEAK interface", link)
        except OSError:
            tried += 1
        try:
            import urllib.request
            print("LEAK", urllib.request.urlopen("http://example.com", timeout=0.5).read(10))
        except OSError:
            tried += 1
        print("tried:", tried)
    """)
)
def test_093_there_is_no_network(fate):
    assert int(fate.line("tried")) > 30


# what is left for the next


_PLACES = """
    import fcntl, socket
    word = "@MARK@".encode()
    places = {os.getcwd(), os.environ.get("HOME", "/"), "/tmp", "/dev/shm", "/var/tmp", "/run", "/run/lock", "/dev/mqueue", "/box", "/box/data",
              *sys.path, sys.prefix, os.path.dirname(os.__file__), os.path.dirname(np.__file__), "/usr/lib", "/etc", "/home", "/root", "/"}
    import course, autograder
    for module in (course, autograder):
        places |= {*module.__path__, *(os.path.join(path, "__pycache__") for path in module.__path__)}
    places = sorted(place for place in places if place)
    keys = [*range(1, 40), 0x4d41524b]
    names = [f"{text}@MARK@" for text in ("", "socket")]
"""

_WRITES = (
    _PLACES
    + """
    written = 0
    for place in places:
        for name in (".@MARK@", "sitecustomize.py", "usercustomize.py", "numpy.py", "@MARK@.pth", "conftest.py", "ipython_config.py"):
            try:
                with open(os.path.join(place, name), "wb") as file:
                    file.write(b"#" + word)
                written += 1
            except OSError:
                pass
        for change in (lambda: os.utime(place, (5, 5)), lambda: os.chmod(place, 0o777), lambda: os.setxattr(place, "user.@MARK@", word)):
            try:
                change()
            except OSError:
                pass
    for key in keys:
        # System V shared memory, semaphores and queues
        shared = libc.shmget(key, 4096, 0o1666)
        if shared >= 0:
            libc.shmat.restype = ctypes.c_void_p
            address = libc.shmat(shared, None, 0)
            if address and address != 2**64 - 1:
                ctypes.memmove(address, word, len(word))
        libc.semget(key, 1, 0o1666)
        queue = libc.msgget(key, 0o1666)
        libc.msgsnd(queue, ctypes.create_string_buffer(b"1" * 8 + word), len(word), 0o4000)
    libc.mq_open(b"/@MARK@", os.O_CREAT | os.O_RDWR, 0o666, None)
    libc.shm_open(b"/@MARK@", os.O_CREAT | os.O_RDWR, 0o666)
    for ring in (-1, -2, -3, -4, -5):
        libc.syscall(248, b"user", b"@MARK@", word, len(word), ring)
    try:
        socket.sethostname("@MARK@")
    except OSError:
        pass
    # the process that this one was made from, and all others: its memory, its limits, its priority
    for pid in {os.getppid(), *range(1, 300)} - {os.getpid()}:
        libc.syscall(302, pid, 7, ctypes.create_string_buffer(16), None)
        libc.ptrace(16, pid, None, None)
    links = []
    for name in names:
        try:
            link = socket.socket(socket.AF_UNIX)
            link.bind(chr(0) + name)
            link.listen()
            links.append(link)
        except OSError:
            pass
    import time, threading
    # it also stays in memory, where a sloppy fork would find it
    kept = [word * 1000 for _ in range(100)]
    sys.modules["@MARK@"] = np
    np.kept = course.kept = kept
    print("written:", written)
    time.sleep(1.5)
"""
)

_READS = (
    _PLACES
    + """
    import time
    looked = 0
    end = time.monotonic() + 1.5
    while time.monotonic() < end:
        for place in places:
            for name in os.listdir(place) if os.access(place, os.R_OK) and os.path.isdir(place) else []:
                looked += 1
                path = os.path.join(place, name)
                if "@MARK@" in name:
                    print("LEAK file", path)
                if name in ("sitecustomize.py", "usercustomize.py", "numpy.py", "conftest.py", "ipython_config.py") and os.access(path, os.R_OK):
                    with open(path, "rb") as file:
                        if word in file.read(1000):
                            print("LEAK content", path)
            try:
                if any("@MARK@" in name for name in os.listxattr(place)) or os.stat(place).st_mtime == 5:
                    print("LEAK attribute", place)
            except OSError:
                pass
        for key in keys:
            for kind, got in (("memory", libc.shmget(key, 0, 0)), ("semaphore", libc.semget(key, 0, 0)), ("queue", libc.msgget(key, 0))):
                looked += 1
                if got >= 0:
                    print("LEAK", kind, key)
        for call, got in (("mq", libc.mq_open(b"/@MARK@", os.O_RDONLY)), ("shm", libc.shm_open(b"/@MARK@", os.O_RDONLY, 0))):
            if got >= 0:
                print("LEAK", call)
        for ring in (-2, -3, -4, -5):
            if libc.syscall(250, 10, ring, b"user", b"@MARK@", 0) > 0:
                print("LEAK key", ring)
        for name in names:
            with socket.socket(socket.AF_UNIX) as link:
                if link.connect_ex(chr(0) + name) == 0:
                    print("LEAK socket", name)
        if socket.gethostname() == "@MARK@" or "@MARK@" in sys.modules or hasattr(np, "kept") or hasattr(course, "kept"):
            print("LEAK process")
        time.sleep(0.1)
    print("looked:", looked)
"""
)


@hands_in(a_writer=looking(_WRITES, lost=None), b_beside=looking(_READS), c_after=looking(_READS))
def test_094_what_one_notebook_leaves_the_next_does_not_find(fate):
    if "writer" in fate.student:
        assert int(fate.line("written")) >= 0
    else:
        assert int(fate.line("looked")) > 1000
        assert fate.total == POINTS


@hands_in(
    attack(
        """
        import json, course.examples, os
        with open(os.path.join(os.path.dirname(course.examples.__file__), "examples.json")) as file:
            public = json.load(file)
        print("public:", len(public))

        def numbers(value):
            if isinstance(value, dict):
                return [number for item in value.values() for number in numbers(item)]
            if isinstance(value, (list, tuple)):
                return [number for item in value for number in numbers(item)]
            return [value] if isinstance(value, (int, float)) else []

        def from_table(name):
            def answer(*args):
                text = json.dumps(args, default=lambda array: array.tolist())
                for example in public.get(name, {}).get("examples", []) if isinstance(public, dict) else []:
                    if str(example)[:50] in text or text[1:-1] in json.dumps(example):
                        return numbers(example)[-3:]
                return [0.0, 0.0, 0.0]
            return answer
        """,
        answers={name: f"{name} = from_table({name!r})" for name in EXERCISES if name != "displacement"},
    )
)
def test_095_a_table_of_the_public_examples_is_worth_nothing(fate):
    assert int(fate.line("public")) > 0
    assert fate.total == POINTS


@hands_in(
    looking("""
        pattern = re.compile("NBGRADER|JUPYTER|TOKEN|SECRET|GRADE|PASSWORD|KEY|SSH|SUDO|PYTEST|VIRTUAL_ENV|DB_URL|AUTOGRADER|PLANTED[0-9a-f]|@ROOT@")
        seen = dict(os.environ)
        # what the C library holds, and the block that the kernel put on the stack, whatever os.environ says
        pointer, index = ctypes.POINTER(ctypes.c_char_p).in_dll(libc, "environ"), 0
        while pointer[index]:
            name, _, value = pointer[index].decode(errors="replace").partition("=")
            seen[f"C {name}"] = value
            index += 1
        for path in ["/proc/self/environ", "/proc/self/cmdline", "/proc/1/environ", "/proc/1/cmdline", f"/proc/{os.getppid()}/environ"]:
            try:
                with open(path, "rb") as file:
                    seen[path] = file.read().decode(errors="replace")
            except OSError:
                pass
        for argument in [*sys.argv, *sys.orig_argv]:
            seen["argument " + argument] = argument
        for name, value in seen.items():
            if pattern.search(name) and not name.startswith("argument") or pattern.search(value) and "PYTHONPATH" not in value:
                print("LEAK", name, value[:300])
        print("seen:", len(seen))
    """)
)
def test_097_the_environment_tells_nothing(fate):
    assert int(fate.line("seen")) > 5


@hands_in(
    looking(r"""
        count = 0
        answer = re.compile(r"def (pose_step|q1_symbolic|planar_rotation|dead_reckoning|pose_step_arc|displacement)\b")
        for folder, _, files in os.walk("/box" if os.path.isdir("/box") else "/"):
            for name in files:
                path = os.path.join(folder, name)
                if name.endswith((".py", ".json", ".md", ".ipynb")) and os.path.getsize(path) < 2**21:
                    text = open(path, errors="replace").read()
                    count += 1
                    if answer.search(text) or re.search(r"sha(1|256)\W*[0-9a-f]{16}|AUTOTEST|BEGIN (HIDDEN|SOLUTION)", text):
                        if "### BEGIN" not in text or "course" in path:
                            print("LEAK", path)
        print("texts:", count)
    """)
)
def test_099_no_answer_and_no_hash_of_one_is_in_what_a_notebook_sees(fate):
    assert int(fate.line("texts")) > 10
    for language in ("en", "ja"):
        checks = [cell["source"] for cell in untouched(language)["cells"] if cell["metadata"].get("nbgrader", {}).get("locked")]
        assert all(re.fullmatch(r'check\("\w+"\)', source) for source in checks if "check" in source)
        assert len(checks) >= len(EXERCISES)


@hands_in(
    looking("""
        import importlib.util, pkgutil
        for name in ("autograder.reference", "autograder.reference.pose_update.pose_step", "autograder.judging", "autograder.grading",
                     "autograder.session", "autograder.seeds", "autograder.gradebook", "autograder.draws", "autograder.exercise", "tests.classroom"):
            try:
                if importlib.util.find_spec(name) is not None:
                    print("LEAK module", name)
            except ImportError:
                pass
        import autograder
        for attribute in ("judge", "exercises"):
            try:
                print("LEAK", getattr(autograder, attribute))
            except (AttributeError, ImportError):
                pass
        names = [info.name for info in pkgutil.walk_packages(autograder.__path__, "autograder.", onerror=lambda name: None)]
        print("names:", *names)
        for path in sys.path + sys.path_hooks * 0:
            if "@REPO@" == path or os.path.exists(os.path.join(path, "autograder", "reference")):
                print("LEAK path", path)
    """),
    finder=looking("""
        import importlib
        sys.path[:0] = ["@REPO@", "@REPO@/autograder", "@ROOT@"]
        importlib.invalidate_caches()
        for name in [name for name in sys.modules if name.split(".")[0] == "autograder"]:
            del sys.modules[name]
        try:
            import autograder.reference
            print("LEAK", autograder.reference)
        except ImportError as error:
            print("names:", error)
    """),
)
def test_101_the_reference_is_not_to_be_imported(fate):
    names = fate.line("names")
    assert "autograder" in names
    if "finder" not in fate.student:
        assert all(name.startswith("autograder.sandbox") for name in names.split())


_MEMORY = """
    class Piece(ctypes.Structure):
        _fields_ = [("base", ctypes.c_void_p), ("length", ctypes.c_size_t)]

    def read(pid, address, length):
        target = ctypes.create_string_buffer(length)
        ours, theirs = Piece(ctypes.addressof(target), length), Piece(address, length)
        got = libc.process_vm_readv(pid, ctypes.byref(ours), 1, ctypes.byref(theirs), 1, 0)
        return target.raw[:got] if got > 0 else b""
"""
_OWN_MEMORY = """
    SIZE = 2**16
    reader, writer = os.pipe()
    libc.write.argtypes = [ctypes.c_int, ctypes.c_void_p, ctypes.c_size_t]

    def own(address):
        # the kernel looks for us: an address that is not there is an error and no crash
        got = libc.write(writer, address, SIZE)
        return os.read(reader, SIZE) if got > 0 else b""

    def near(addresses, reach=2):
        for region in sorted({address // 2**22 + shift for address in addresses for shift in range(-reach, reach + 1)}):
            for start in range(region * 2**22, (region + 1) * 2**22, SIZE):
                yield start

    pages, known = 0, 0
    for start in near([id(held) for held in gc.get_objects()]):
        data = own(start)
        pages += len(data) // 4096
        # a text of which an end is cut off by a page that is not there is in the next one
        known += look(hex(start), data)
        del data
    print("pages:", pages)
    print("known:", known)
"""


@hands_in(looking(_OWN_MEMORY))
def test_101_its_memory_has_never_held_the_reference_nor_another_students_work(fate):
    """The fork of a warm process inherits all that ever stood in it, freed memory included."""
    assert int(fate.line("pages")) > 1000
    assert int(fate.line("known")) > 0
    assert fate.total == POINTS


@hands_in(
    looking(
        _MEMORY
        + """
    tried, here = 0, id(sys)
    for pid in {os.getppid(), *range(1, 2000)} - {os.getpid()}:
        tried += 1
        if read(pid, here // 4096 * 4096, 4096):
            print("LEAK memory of", pid)
        for name in ("mem", "maps", "environ", "root", "cwd", "fd"):
            path = f"/proc/{pid}/{name}"
            try:
                print("LEAK", path, os.listdir(path) if name in ("root", "cwd", "fd") else open(path, "rb").read(1))
            except OSError:
                pass
        if libc.ptrace(0x4206, pid, None, None) == 0:
            print("LEAK seized", pid)
        pidfd = libc.syscall(434, pid, 0)
        if pidfd >= 0:
            for fd in range(40):
                if libc.syscall(438, pidfd, fd, 0) >= 0:
                    print("LEAK descriptor", pid, fd)
            os.close(pidfd)
    print("tried:", tried)
"""
    )
)
def test_no_other_process_gives_up_its_memory_or_its_files(fate):
    assert int(fate.line("tried")) > 1000
    assert fate.total == POINTS


@hands_in(
    looking("""
        found = []
        buffer = ctypes.create_string_buffer(2**16)
        if libc.klogctl(3, buffer, len(buffer)) > 0:
            print("LEAK kernel log", buffer.value[:80])
        for path in ("/dev/mem", "/dev/kmem", "/dev/port", "/dev/kvm", "/dev/sda", "/dev/vda", "/dev/fuse", "/dev/net/tun", "/dev/kmsg", "/proc/kcore",
                     "/proc/kallsyms", "/sys/kernel/debug", "/sys/fs/cgroup", "/proc/sys/kernel/core_pattern", "/etc/shadow", "/etc/passwd",
                     "/root", "/home", "/run/secrets", "/var/lib", "/etc/hostname", "/boot"):
            try:
                what = os.listdir(path) if os.path.isdir(path) else open(path, "rb").read(50)
                # Python itself may live there
                if what and not (len(what) == 1 and sys.base_prefix.startswith(f"{path}/{what[0]}")):
                    print("LEAK", path, what)
            except OSError:
                found.append(path)
        print("host:", os.uname().nodename)
        print("closed:", len(found))
    """)
)
def test_the_machine_tells_nothing_of_itself(fate):
    assert fate.line("host") != socket.gethostname()
    assert int(fate.line("closed")) > 10


@hands_in(
    looking("""
        # what the memory allocators hand out unwashed
        dirty = 0
        for size in (64, 512, 4096, 2**16, 2**20):
            held = [np.empty(size, dtype=np.uint8) for _ in range(20)]
            for array in held:
                dirty += bool(array.any())
                look(f"np.empty({size})", array.tobytes())
            libc.malloc.restype = ctypes.c_void_p
            for _ in range(20):
                look(f"malloc({size})", ctypes.string_at(libc.malloc(size), size))
            del held
        print("dirty:", dirty)
    """)
)
def test_unwashed_memory_holds_nothing_of_others(fate):
    assert int(fate.line("dirty")) >= 0
    assert fate.total == POINTS


# what stands outside the process


def test_nobodys_page_shows_another_students_work(cohort):
    for student in cohort.submissions:
        page = (cohort.room.root / f"autograded/{student}/odometry/pose_update.ipynb").read_text(encoding="utf-8")
        assert cohort.planted not in page
    own = json.dumps(cohort.room.executed(HONEST[0]))
    assert cohort.planted in own
    assert cohort.room.total(HONEST[0]) == FULL


def test_the_search_would_find_what_is_hidden():
    """The patterns match what stands in the files that must not be seen, or a search that finds nothing says nothing."""
    pattern = re.search(r'HIDDEN = re.compile\(rb"(.*)"\)', _NEEDLES).group(1)
    hidden = Path(ROOT / "autograder/reference/pose_update/displacement.py").read_text(encoding="utf-8")
    assert "half_dt_squared" in re.findall(pattern, hidden)
    assert re.search(pattern, Path(ROOT / "autograder/judging.py").read_text(encoding="utf-8"))
    assert not [path for path in Path(ROOT / "course").glob("*.py") if re.search(pattern, path.read_text(encoding="utf-8"))]
    assert re.search(pattern, Path(ROOT / "autograder/reference/__init__.py").read_text(encoding="utf-8"))
    assert not re.search(pattern, _NEEDLES)
    assert re.search("replies_t[o]", Path(ROOT / "course/answers.py").read_text(encoding="utf-8"))

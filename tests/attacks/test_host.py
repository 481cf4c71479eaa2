"""Harming the grader's machine, or keeping it busy: every notebook comes to an end, alone, within its limits."""

import re
from dataclasses import replace
from pathlib import Path
from textwrap import dedent

import pytest

from tests.attacks.cohort import EXERCISES, MARK, POINTS, attack, hands_in, left_behind
from tests.classroom import LIMITS as CLASS_LIMITS

pytestmark = [pytest.mark.sandbox, pytest.mark.xdist_group("attacks-host")]
LIMITS = replace(CLASS_LIMITS, cell=2.0, check=2.0, notebook=20.0, grace=0.5, memory_mb=768, processes=24)
#: set in every process that an attack starts, forks included, so that one that is left is recognised from outside
_NAMED = """
import ctypes, os, signal, socket, sys, time
libc = ctypes.CDLL(None, use_errno=True)
libc.prctl(15, b"@MARK@", 0, 0, 0)
"""


def starting(cell="", **more):
    """A notebook whose processes carry the mark; whether its own right answer comes through is not for these tests to say."""
    return attack(_NAMED + dedent(cell), **{"lost": None, **more})


def answering(body, name="pose_step", cell=""):
    """A notebook in which one answer does this when it is called."""
    parameters = {"dead_reckoning": "velocity, yaw_rate, dt, pose0"}.get(name, "*args")
    source = f"def {name}({parameters}):\n" + "\n".join(f"    {line}" for line in dedent(body).strip().splitlines())
    return starting(cell, answers={name: source})


# writing where the next command would read


@hands_in(
    attack("""
        import os, sqlite3
        for place in ("@ROOT@/gradebook.db", "gradebook.db", "/gradebook.db", "@REPO@/gradebook.db"):
            try:
                os.makedirs(os.path.dirname(os.path.abspath(place)), exist_ok=True)
                with sqlite3.connect(place) as database:
                    database.execute("update grade set manual_score = 40, needs_manual_grade = 0")
                    print("LEAK", place)
            except (OSError, sqlite3.Error):
                pass
    """)
)
def test_102_the_gradebook_is_not_to_be_written(fate):
    assert fate.total == POINTS
    assert fate.cohort.recorded(fate.student) == POINTS


@hands_in(
    attack("""
        import os, sys
        import autograder, course, IPython
        places = ["@ROOT@", "@REPO@", "@REPO@/course", "@REPO@/autograder", "@REPO@/source/odometry", "@ROOT@/release/en/odometry",
                  "@ROOT@/submitted/AAA-honest/odometry", "@ROOT@/submitted", *course.__path__, *autograder.__path__, *IPython.__path__,
                  sys.prefix, *(path for path in sys.path if path), "/box/data", "/box/lib", "/usr/bin", "/usr/lib/python3.11"]
        names = ["nbgrader_config.py", "jupyter_config.py", "pose_update.md", "pose_update.ipynb", "answers.py", "__init__.py", "sitecustomize.py",
                 "usercustomize.py", "evil.pth", "python3", "wire.py", "conftest.py", "pyproject.toml"]
        tried = 0
        for place in places:
            for name in names:
                path = os.path.join(place, name)
                for change in (lambda: open(path, "a").write("# changed"), lambda: os.utime(path, (1, 1)), lambda: os.chmod(path, 0o777),
                               lambda: os.replace("/dev/null", path), lambda: os.unlink(path), lambda: os.link(path, path + ".kept")):
                    tried += 1
                    try:
                        change()
                    except OSError:
                        continue
                    # a folder of its own making below a private root is nobody's
                    if place not in ("@ROOT@", "@REPO@") and not path.startswith((os.getcwd(), "/tmp")):
                        print("LEAK wrote", path)
        print("tried:", tried)
    """)
)
def test_103_nothing_that_runs_later_is_to_be_written(fate):
    assert int(fate.line("tried")) > 500
    assert fate.total == POINTS


# time

_DEAF = "for number in range(1, 64):\n    try: signal.signal(number, signal.SIG_IGN)\n    except (OSError, ValueError): pass\n"


@hands_in(
    loop=starting("while True: pass"),
    sleeps=starting("time.sleep(1e6)"),
    waits=starting("import threading; threading.Lock().acquire() and threading.Event().wait()"),
    reads=starting("input()"),
    reads_stdin=starting("sys.stdin.read(); os.read(0, 1)"),
    answer=answering("while True: pass"),
    everywhere=attack(
        answers={
            name: f"def {name}(*args):\n    import time; time.sleep(1e6)\nimport time; time.sleep(1e6)"
            for name in EXERCISES
            if name != "displacement"
        },
        lost=None,
    ),
    swallows=starting("while True:\n    try:\n        while True: time.sleep(0.01)\n    except BaseException: pass", lost=True),
    swallowed=answering("while True:\n    try:\n        while True: pass\n    except BaseException: pass"),
)
def test_104_what_never_ends_is_ended(fate):
    if fate.stopped:
        assert "time" in fate.messages
    if "everywhere" in fate.student:
        assert "dead_reckoning" in fate.stopped
    assert sum(result.score for name, result in fate.results.items() if name != "displacement") == 0


@hands_in(
    deaf=starting(_DEAF + "while True: pass", lost=True),
    blocked=starting("signal.pthread_sigmask(signal.SIG_BLOCK, range(1, 64)); time.sleep(1e6)", lost=True),
    stopped=starting("os.kill(os.getpid(), signal.SIGSTOP)"),
    stopped_group=starting("os.killpg(0, signal.SIGSTOP)"),
    in_c=starting("sum(range(10**12))", lost=True),
    power=starting("7 ** (7 ** 10)"),
    pattern=starting("import re; re.match('(a*)*b', 'a' * 60)"),
    in_c_answer=answering("return sum(range(10**12))"),
    deaf_answer=answering(_DEAF + "while True: pass"),
    sleeps_in_c=starting("ctypes.CDLL(None).sleep(10**6); ctypes.CDLL(None).pause(); ctypes.CDLL(None).sleep(10**6)"),
    keeps_the_lock=starting("ctypes.PyDLL(None).sleep(10**6)\nctypes.PyDLL(None).sleep(10**6)"),
    traced=starting("libc.ptrace(0, 0, 0, 0); os.kill(os.getpid(), signal.SIGSTOP)"),
    no_alarm=starting(
        "signal.setitimer(signal.ITIMER_REAL, 0)\nsignal.signal(signal.SIGALRM, signal.SIG_DFL)\nwhile True: pass", lost=True
    ),
)
def test_105_what_does_not_let_itself_be_interrupted_is_killed(fate):
    assert sum(result.score for name, result in fate.results.items() if name != "displacement") == 0
    if fate.total == 0:
        assert fate.stopped
        assert re.search("time|ended", fate.messages)


@hands_in(
    daemon=starting("""
        for _ in range(3):
            if os.fork() == 0:
                os.setsid()
                if os.fork():
                    os._exit(0)
                for number in range(1, 64):
                    try:
                        signal.signal(number, signal.SIG_IGN)
                    except (OSError, ValueError):
                        pass
                os.closerange(0, 1024)
                while True:
                    time.sleep(1)
    """),
    executed=starting("""
        import subprocess
        for _ in range(3):
            subprocess.Popen([sys.executable, "-c", "import time; time.sleep(1e6)", "@MARK@"], start_new_session=True, close_fds=False)
    """),
    own_namespace=starting("""
        import subprocess
        for flags in (["--fork", "--pid"], ["-U", "--fork", "--pid", "--kill-child=SIGCONT"], ["-r", "-m"]):
            subprocess.Popen(["unshare", *flags, sys.executable, "-c", "import time; time.sleep(1e6)", "@MARK@"], start_new_session=True,
                             stderr=subprocess.DEVNULL)
        time.sleep(0.5)
    """),
    survivor=starting("""
        def serve():
            while True:
                if os.fork():
                    os._exit(0)  # always another number
        if os.fork() == 0:
            os.setsid()
            end = time.monotonic() + 1e6
            while time.monotonic() < end:
                if os.fork():
                    os._exit(0)
                time.sleep(0.01)
    """),
)  # fmt: skip
def test_106_a_daemon_ends_with_its_notebook(fate):
    assert fate.total <= POINTS
    assert left_behind() == []


@hands_in(
    forks=starting("""
        count = 0
        try:
            while count < 500:
                if os.fork() == 0:
                    time.sleep(1e6)
                    os._exit(0)
                count += 1
        except OSError:
            pass
        finally:
            print("started:", count)
    """),
    bomb=starting("""
        while True:
            try:
                os.fork()
            except OSError:
                time.sleep(0.01)
    """),
    threads=starting("""
        import threading
        count = 0
        try:
            while count < 500:
                threading.Thread(target=time.sleep, args=(1e6,), daemon=True).start()
                count += 1
        except RuntimeError:
            pass
        finally:
            print("started:", count)
    """),
    shell=starting("import subprocess\nsubprocess.run(['bash', '-c', ':(){ :|:& };:; sleep 100'], stderr=subprocess.DEVNULL)"),
    vfork=answering("import subprocess\nwhile True: subprocess.Popen(['sleep', '1000'])"),
)  # fmt: skip
def test_107_a_fork_bomb_is_held_back(fate):
    started = re.search(r"started: (\d+)", fate.printed)
    if "forks" in fate.student or "threads" in fate.student:
        assert started, fate.printed
        assert 0 < int(started.group(1)) <= LIMITS.processes
    assert left_behind() == []


# memory


@hands_in(
    one=starting("kept = []\nwhile True: kept.append(np.ones(2**23))"),
    at_once=starting("np.ones(10**12)"),
    text=starting("kept = 'x' * 10**11"),
    answer=answering("kept = [1]\nwhile True: kept += kept"),
    recursion=answering("kept = []\nfor _ in range(10**9): kept = [kept, kept * 2]\nreturn kept"),
)
def test_108_a_memory_bomb_is_an_error_of_its_cell(fate):
    assert re.search("MemoryError|did not finish|ended|time|memory", fate.printed + fate.messages)


_SPREAD = """
    import io, mmap
    share, step, children = mmap.mmap(-1, 4096), 32, 8

    def held():
        return sum(int.from_bytes(share[4 * child : 4 * child + 4], "little") for child in range(children))

    for child in range(children):
        if os.fork() == 0:
            kept = []
            for _ in range(128 // step):
                kept.append(np.ones(step * 2**17))
                share[4 * child : 4 * child + 4] = (len(kept) * step).to_bytes(4, "little")
            time.sleep(1e6)
            os._exit(0)
"""
_DRIPS = """
    # a byte now and then: whoever looks after the memory only while nothing comes never looks
    import autograder.sandbox.runner as runner
    sent = runner.send

    def slowly(stream, message):
        made = io.BytesIO()
        sent(made, message)
        for index in range(4):
            stream.write(made.getvalue()[index : index + 1])
            stream.flush()
            time.sleep(0.1)
        stream.write(made.getvalue()[4:])
        stream.flush()

    runner.send = slowly
"""
_HELD = {"dead_reckoning": "print('held:', held())"}


@hands_in(
    waiting=starting(_SPREAD + "    time.sleep(1.3)\n", answers=_HELD),
    dripping=starting(_SPREAD + _DRIPS, answers=_HELD),
)
def test_108_memory_spread_over_processes_is_limited_together(fate):
    """Eight processes, each far within the limit, hold more than it together."""
    if not fate.stopped:
        assert int(fate.line("held")) <= LIMITS.memory_mb
    assert left_behind() == []


_GROWS = """
    held, kept = 0, []

    def grow():
        # a little in each cell, so that a slow machine comes as far as a fast one
        global held
        end = time.monotonic() + 0.7
        try:
            while held < 1000 and time.monotonic() < end:
                held += more()
        except OSError:
            pass
"""


def growing(more):
    """A notebook that holds more and more of something, cell by cell, and says how many MiB it holds in the end."""
    answers = dict.fromkeys([name for name in EXERCISES if name not in ("displacement", "dead_reckoning")], "grow()")
    return starting(dedent(_GROWS) + dedent(more), answers=answers | {"dead_reckoning": "grow()\nprint('held:', held)"})


@hands_in(
    files=starting("""
        held = 0
        try:
            for place in (os.getcwd(), "/tmp", "/dev/shm", "/var/tmp", "/run", "/"):
                for number in range(60):
                    try:
                        with open(os.path.join(place, f"bomb{number}"), "wb", buffering=0) as file:
                            for _ in range(32):
                                held += file.write(bytes(2**20)) // 2**20
                    except OSError:
                        break
        finally:
            print("held:", held)
    """),
    anonymous=growing("""
        def more():
            kept.append(os.memfd_create("bomb"))
            os.write(kept[-1], bytes(2**24))
            return 16
    """),
    segments=growing("""
        libc.shmat.restype = ctypes.c_void_p
        libc.shmdt.argtypes = [ctypes.c_void_p]

        def more():
            number = libc.shmget(0, 2**24, 0o1600)
            address = libc.shmat(number, None, 0) if number >= 0 else None
            if address is None or address == 2**64 - 1:
                raise OSError("no segment")
            ctypes.memset(address, 1, 2**24)
            libc.shmdt(address)  # gone from the address space, not from memory
            return 16
    """),
    in_flight=growing("""
        # memory that nobody has mapped or opened, kept alive by a descriptor on its way between two sockets
        def more():
            fd, pair = os.memfd_create("flight"), socket.socketpair()
            os.write(fd, bytes(2**24))
            socket.send_fds(pair[0], [b"x"], [fd])
            os.close(fd)
            kept.append(pair)
            return 16
    """),
)  # fmt: skip
def test_108_memory_outside_of_any_process_is_limited_too(fate):
    """Files in memory, shared segments and descriptors count, whatever they hang on."""
    if not fate.stopped:
        assert int(fate.line("held")) <= LIMITS.memory_mb


@hands_in(
    inodes=starting("""
        count = 0
        for place in (os.getcwd(), "/tmp", "/dev/shm"):
            try:
                for number in range(60_000):
                    os.close(os.open(f"{place}/n{number}", os.O_CREAT | os.O_WRONLY))
                    count += 1
            except OSError:
                pass
        print("files:", count)
    """),
    folders=starting("""
        count = 0
        try:
            while count < 20_000:
                os.mkdir("d")
                os.chdir("d")
                count += 1
        except OSError:
            pass
        print("files:", count)
    """),
    descriptors=starting("""
        kept, count = [], 0
        try:
            while count < 100_000:
                kept.append(os.dup(0))
                count += 1
        except OSError:
            pass
        print("files:", count)
    """),
)  # fmt: skip
def test_108_many_small_files_trouble_nobody(fate):
    assert fate.total <= POINTS
    if "descriptors" in fate.student and not fate.stopped:
        assert int(fate.line("files")) < 5000


# floods of output

_FLOOD = 3_000_000


@hands_in(
    line=starting("print('x' * 10**8)"),
    lines=starting("for _ in range(10**6): print('y')"),
    errors=starting("print('x' * 10**8, file=sys.stderr)\nraise ValueError('z' * 10**8)"),
    displays=starting("for _ in range(20_000): display({'text/plain': 'x' * 1000}, raw=True)"),
    wide=starting("class Wide:\n    def __repr__(self): return 'x' * 10**8\nWide()"),
    rich=starting(
        "class Rich:\n    def _repr_html_(self): return '<b>' * 10**7\n    def _repr_png_(self): return b'\\x89PNG' * 10**7\nRich()"
    ),
    chains=starting("""
        error = ValueError("first")
        for number in range(3000):
            try:
                raise ValueError("x" * 1000) from error
            except ValueError as raised:
                error = raised
        raise error
    """),
    raw=starting("""
        for fd in (1, 2):
            try:
                for _ in range(200): os.write(fd, b"x" * 2**20)
            except OSError:
                pass
    """),
    figures=starting("import matplotlib.pyplot as plt\nfor _ in range(300): plt.figure(figsize=(1, 1), dpi=20)"),
    huge_figure=starting("import matplotlib.pyplot as plt\nplt.figure(figsize=(2000, 2000), dpi=100)\nplt.plot([0, 1]);"),
    answer=answering("print('x' * 10**8)\nsys.stderr.write('y' * 10**8)\nraise ValueError('z' * 10**8)"),
    warnings=answering("import warnings\nfor number in range(10**5): warnings.warn('w' * 10**4 + str(number))\nreturn 1"),
    names=answering("raise type('N' * 10**7, (ValueError,), {})('x')"),
)  # fmt: skip
def test_110_a_flood_of_output_is_cut_off(fate):
    executed = fate.cohort.room.root / f"autograded/{fate.student}/odometry/pose_update.ipynb"
    assert executed.stat().st_size < _FLOOD
    assert all(len(result.message) < 6000 for result in fate.results.values())


@hands_in(
    attack("""
        import ctypes, glob, os
        libraries = glob.glob(os.path.dirname(np.__file__) + "/../numpy.libs/*openblas*")
        count = [getattr(ctypes.CDLL(path), f"scipy_openblas_get_num_threads{suffix}")() for path in libraries for suffix in ("64_",)]
        print("threads:", *count)
        np.ones((500, 500)) @ np.ones((500, 500))
    """)
)
def test_111_linear_algebra_has_one_thread(fate):
    assert fate.line("threads") == "1"
    assert fate.total == POINTS


# what the judge has to look at


@hands_in(
    array=answering("return np.zeros(10**8)"),
    broadcast=answering("return np.broadcast_to(1.0, (10**9,))"),
    many=answering("return [np.zeros(10**5)] * 10**5"),
    nested=answering("kept = []\nfor _ in range(10**6): kept = [kept]\nreturn kept"),
    itself=answering("kept = []\nkept.extend([kept] * 1000)\nreturn kept"),
    text=answering("return 'x' * 10**8"),
    digits=answering("return 1 << 4_000_000"),
    digits_in_list=answering("return [1 << 4_000_000] * 3"),
    negative=answering("return -(1 << 4_000_000)"),
    keys=answering("return {'k' * 1000 + str(number): number for number in range(20_000)}"),
    symbols=answering("x = sp.Symbol('x')\nfor _ in range(40): x = x * x + x\nreturn [x, x, x]", "q1_symbolic"),
    symbols_never_end=answering(
        "class Slow(sp.Symbol):\n    def evalf(self, *more, **named):\n        while True: pass\n    __float__ = evalf\nreturn [Slow('s')] * 3",
        "q1_symbolic",
    ),
    slow_text=answering("class Slow(ValueError):\n    def __str__(self):\n        while True: pass\nraise Slow"),
    slow_text_in_cell=starting(
        "class Slow(ValueError):\n    def __str__(self):\n        while True: pass\nraise Slow",
    ),
    slow_name=answering(
        "class Meta(type):\n    __name__ = property(lambda self: [0 for _ in iter(int, 1)])\nraise Meta('M', (ValueError,), {})"
    ),
    slow_conversion=answering(
        "class Slow:\n    def __array__(self, *more, **named):\n        while True: pass\nreturn Slow()",
    ),
    path=answering("return np.zeros((10**6, 3))", "dead_reckoning"),
    signature=starting(
        "class Odd:\n    @property\n    def __signature__(self):\n        while True: pass\n    def __call__(self, *args): pass",
        answers={"pose_step": "pose_step = Odd()"},
    ),
    figure=starting(
        "import matplotlib.pyplot as plt\naxes = plt.figure().gca()\nfor _ in range(3000): axes.plot(range(1000))\nplt.close('all')",
        answers={"pose_step": "pose_step = axes"},
    ),
)
def test_112_answers_that_are_hard_to_look_at_are_worth_nothing(fate):
    assert sum(result.score for name, result in fate.results.items() if name != "displacement") == 0


# the processes and the kernel around it


@hands_in(
    all_=starting("os.kill(-1, signal.SIGKILL)"),
    each=starting("""
        for number in range(1, 5000):
            if number != os.getpid():
                for way in (os.kill, os.killpg):
                    try:
                        way(number, signal.SIGKILL)
                    except OSError:
                        pass
    """),
    parent=starting("""
        for _ in range(5):
            try:
                os.kill(os.getppid(), signal.SIGSTOP)
                os.kill(os.getppid(), signal.SIGKILL)
            except OSError:
                pass
    """),
    traced=starting("""
        for number in range(1, 2000):
            if number != os.getpid():
                for request in (16, 0x4206):
                    if libc.ptrace(request, number, 0, 0) == 0:
                        print("LEAK traced", number)
    """),
    limits=starting("""
        import resource
        for number in {os.getppid(), *range(0, 2000)}:
            for kind in (resource.RLIMIT_CPU, resource.RLIMIT_AS, resource.RLIMIT_NOFILE):
                try:
                    resource.prlimit(number, kind, (1, 1))
                    if number not in (0, os.getpid()):
                        print("LEAK limited", number)
                except (OSError, ValueError):
                    pass
    """),
    priority=starting("""
        for number in range(1, 2000):
            for change in (lambda: os.setpriority(os.PRIO_PROCESS, number, 19), lambda: os.sched_setscheduler(number, os.SCHED_IDLE, os.sched_param(0)),
                           lambda: os.sched_setaffinity(number, {0})):
                try:
                    change()
                except OSError:
                    pass
        for change in (lambda: os.setpriority(os.PRIO_PROCESS, 0, -20), lambda: os.sched_setscheduler(0, os.SCHED_FIFO, os.sched_param(99))):
            try:
                change()
                print("LEAK a higher priority")
            except OSError:
                pass
    """),
    terminal=starting("""
        import fcntl, termios
        for path in ("/dev/tty", "/dev/console", "/dev/pts/0", "/dev/ptmx"):
            try:
                fd = os.open(path, os.O_RDWR)
                for letter in b"echo 40\\n":
                    fcntl.ioctl(fd, termios.TIOCSTI, bytes([letter]))
                print("LEAK typed", path)
            except OSError:
                pass
    """),
)  # fmt: skip
def test_114_neither_the_judge_nor_a_neighbour_is_within_reach(fate):
    assert fate.total <= POINTS
    if fate.total == 0:
        assert fate.stopped


_CALLS = {
    "mount": (165, b"none", b"/tmp", b"tmpfs", 0, None),
    "umount": (166, b"/", 2),
    "pivot_root": (155, b"/", b"/"),
    "chroot": (161, b"/tmp"),
    "setuid": (105, 0),
    "setresuid": (117, 0, 0, 0),
    "bpf": (321, 5, b"\0" * 128, 128),
    "perf_event_open": (298, b"\0" * 128, 0, -1, -1, 0),
    "keyctl_new_session": (250, 1, b"ring"),
    "add_key": (248, b"user", b"evil", b"evil", 4, -2),
    "io_uring_setup": (425, 8, b"\0" * 256),
    "userfaultfd": (323, 0),
    "init_module": (175, b"", 0, b""),
    "finit_module": (313, 0, b"", 0),
    "kexec_load": (246, 0, 0, None, 0),
    "reboot": (169, 0xFEE1DEAD, 672274793, 0x01234567, None),
    "swapon": (167, b"/tmp/swap", 0),
    "sethostname": (170, b"evil", 4),
    "settimeofday": (164, b"\0" * 16, None),
    "iopl": (172, 3),
    "quotactl": (179, 0, None, 0, None),
    "acct": (163, b"/tmp/acct"),
    "syslog": (103, 5, None, 0),
    "lookup_dcookie": (212, 0, None, 0),
    "name_to_handle_at": (303, -100, b"/usr", b"\x80\0\0\0" + b"\0" * 200, b"\0" * 8, 0),
    "setns": (308, 0, 0),
    "fsopen": (430, b"tmpfs", 0),
    "open_tree": (428, -100, b"/", 1),
    "move_mount": (429, -100, b"/tmp", -100, b"/mnt", 0),
    "fanotify_init": (300, 0, 0),
    "kcmp": (312, 1, 2, 0, 0, 0),
    "unshare_all": (272, 0x7E020000),
    "clone3": (435, b"\0" * 88, 88),
    "landlock": (444, None, 0, 0),
    "personality": (135, 0x0040000),
    "modify_ldt": (154, 1, b"\0" * 16, 16),
    "vsock": (41, 40, 1, 0),
    "alg": (41, 38, 5, 0),
    "netlink": (41, 16, 3, 0),
    "packet": (41, 17, 3, 0x0300),
}
#: what must never work for a notebook, whatever else is refused
_FORBIDDEN = {
    "pivot_root", "setuid", "setresuid", "bpf", "init_module", "finit_module", "kexec_load", "swapon", "settimeofday",
    "iopl", "acct", "syslog", "fanotify_init", "umount", "perf_event_open",
}  # fmt: skip
#: the doors to the kernel through which most escapes went; a filter of system calls closes them
_FILTERED = {"io_uring_setup", "userfaultfd", "keyctl_new_session", "add_key", "bpf", "perf_event_open", "vsock", "alg", "packet"}
_TRIES = f"""
CALLS = {_CALLS!r}
rest = dict(CALLS)
while rest:
    reader, writer = os.pipe()
    # in a child: a filter may kill whoever calls
    if os.fork() == 0:
        for name, (number, *arguments) in rest.items():
            arguments = [ctypes.create_string_buffer(value, max(len(value), 256)) if isinstance(value, bytes) else value for value in arguments]
            done = libc.syscall(number, *arguments) >= 0
            os.write(writer, f"{{name}}: {{'done' if done else 'refused'}}\\n".encode())
        os._exit(0)
    os.close(writer)
    os.wait()
    told = os.read(reader, 65536).decode()
    print(told, end="")
    for line in told.splitlines():
        del rest[line.partition(":")[0]]
    if rest:
        print(f"{{next(iter(rest))}}: refused")
        del rest[next(iter(rest))]
"""


@hands_in(starting(_TRIES))
def test_115_the_kernels_dangerous_calls_are_refused(fate):
    done = {name for name in _CALLS if fate.line(name) == "done"}
    assert not done & _FORBIDDEN
    assert not done & _FILTERED


@hands_in(
    starting(
        """
        CLONE_NEWUSER, CLONE_NEWNS, CLONE_NEWNET, CLONE_NEWPID = 0x10000000, 0x20000, 0x40000000, 0x20000000
        child = os.fork()
        if child == 0:
            # root in a user namespace of its own has all of the kernel's doors before it
            opened = libc.unshare(CLONE_NEWUSER | CLONE_NEWNS | CLONE_NEWNET | CLONE_NEWPID) == 0
            if opened:
                try:
                    for name, text in (("setgroups", "deny"), ("uid_map", "0 %d 1" % os.getuid()), ("gid_map", "0 %d 1" % os.getgid())):
                        open(f"/proc/self/{name}", "w").write(text)
                except OSError:
                    pass
                libc.mount(b"none", b"/", None, 0x44000, None)
                libc.umount2(b"/proc", 2)
                libc.mount(b"proc", b"/tmp", b"proc", 0, None)
                libc.mount(b"/", b"/tmp", None, 4096 | 16384, None)
            for path in ("@ROOT@", "@REPO@/autograder/reference", "/tmp/1/environ", "/proc/1/root/root"):
                if os.path.exists(path):
                    os._exit(3)
            os._exit(2 if opened else 1)
        print("namespace:", os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]))
        """
    )
)
def test_115_a_user_namespace_of_its_own_shows_nothing_more(fate):
    assert fate.line("namespace") in ("1", "2", "-31")
    assert fate.total == POINTS


@hands_in(
    attack("""
        import json, os, socket
        try:
            import zmq
            context = zmq.Context()
            reached = 0
            for address in ["tcp://127.0.0.1:%d" % port for port in range(5555, 5600)] + ["ipc:///tmp/kernel-ipc-1", "ipc://@ROOT@/kernel"]:
                request = context.socket(zmq.DEALER)
                request.setsockopt(zmq.LINGER, 0)
                request.connect(address)
                request.send_json({"msg_type": "execute_request"})
                reached += bool(request.poll(5))
                request.close()
            context.destroy(0)
        except (ImportError, OSError):
            reached = 0
        for folder in ("/root/.local/share/jupyter/runtime", os.path.expanduser("~/.local/share/jupyter/runtime"), "/run/user/0", "/tmp"):
            for name in os.listdir(folder) if os.path.isdir(folder) and os.access(folder, os.R_OK) else []:
                if name.startswith(("kernel-", "jpserver-", "nbserver-", "pytest-")):
                    print("LEAK", folder, name)
        print("reached:", reached)
    """)
)
def test_117_no_kernel_of_others_is_within_reach(fate):
    assert fate.line("reached") == "0"


@hands_in(
    attack("""
        import os
        targets = ["@ROOT@/gradebook.db", "@ROOT@/solutions.txt", "/etc/shadow", "@REPO@/autograder/reference/__init__.py"]
        for place in {os.getcwd(), "/tmp", os.environ.get("HOME", "/tmp"), "/box/work"}:
            for name in ("pose_update.ipynb", "results.json", "output.png", "data", "stdout", "feedback.html", "core", "figure.png", "log"):
                for target in targets:
                    try:
                        if os.path.lexists(os.path.join(place, name)):
                            os.rename(os.path.join(place, name), os.path.join(place, name + ".old"))
                        os.symlink(target, os.path.join(place, name))
                    except OSError:
                        pass
        os.mkfifo("pipe") if not os.path.exists("pipe") else None
        from IPython.display import Image, FileLink, SVG
        try:
            display(FileLink("pose_update.ipynb"), Image(filename="@ROOT@/solutions.txt"), SVG(filename="/etc/shadow"))
        except (OSError, ValueError):
            pass
        try:
            display(Image(filename="output.png", format="png"))
        except (OSError, ValueError):
            pass
    """)
)
def test_118_links_that_it_leaves_lead_nobody_anywhere(fate):
    assert fate.total == POINTS
    assert "root:" not in fate.printed


_HARD_TO_PARSE = {
    "nested": "x = " + "(" * 5000 + ")" * 5000,
    "minus": "x = " + "-" * 50_000 + "1",
    "attributes": "x = a" + ".b" * 50_000,
    "chained": "x = " + "a + " * 100_000 + "a",
    "lambdas": "x = " + "lambda: " * 50_000 + "0",
    "digits": "x = " + "9" * 100_000,
    "hexadecimal": "x = 0x" + "f" * 500_000,
    "constants": "x = ((((2**10000)**10000)))",
    "repeated": "x = 'a' * 10**9 * 10**9 * 0",
    "blocks": "".join("  " * depth + "if 1:\n" for depth in range(120)) + "  " * 120 + "pass",
    "f_strings": "x = f'" + "{1!r:" * 1000 + "}" * 1000 + "'",
    "decorators": "@a\n" * 20_000 + "def pose_step(): pass",
    "patterns": "match 0:\n    case " + "[" * 5000 + "]" * 5000 + ": pass",
    "names": "x" * 1_000_000 + " = 1",
    "magics": "%%time\n" * 300 + "pass",
    "macros": "!!" * 5000,
    "encoding": "# -*- coding: utf_7 -*-\nx = 1",
    "form_feed": "\f" * 50_000 + "x = 1",
    "backslashes": "x = 1" + "\\\n" * 50_000,
}


@hands_in(
    **{name: attack(source, answers={"pose_step": source}, lost=None) for name, source in _HARD_TO_PARSE.items()},
)
def test_119_what_is_hard_to_parse_is_not_parsed_by_the_grader(fate):
    assert fate.total in (0, POINTS)
    assert not {name for name, result in fate.results.items() if result.status == "failed"}


# ways that are in no list


@hands_in(
    finaliser=starting("""
        class Sticky:
            def __del__(self):
                while True:
                    pass
        kept = Sticky()
        del kept
    """),
    at_exit=starting("import atexit\natexit.register(time.sleep, 1e6)\nimport threading\nthreading._register_atexit(time.sleep, 1e6)"),
    thread=starting("import threading\nthreading.Thread(target=time.sleep, args=(1e6,)).start()"),
    collector=starting("""
        import gc
        gc.callbacks.append(lambda *args: time.sleep(1e6))
        kept = [[number] for number in range(10**5)]
    """),
    import_lock=starting("""
        import _imp, threading
        threading.Thread(target=lambda: (_imp.acquire_lock(), time.sleep(1e6)), daemon=True).start()
    """),
    switches=starting("""
        import threading
        sys.setswitchinterval(1e6)
        def spin():
            while True:
                pass
        for _ in range(4):
            threading.Thread(target=spin, daemon=True).start()
        time.sleep(0.01)
    """),
    hook=starting("get_ipython().events.register('post_run_cell', lambda *args: time.sleep(1e6))"),
    transformer=starting("get_ipython().input_transformers_cleanup.append(lambda lines: time.sleep(1e6))"),
    async_=starting("import asyncio\nawait asyncio.sleep(1e6)"),
    loop_forever=starting("import asyncio\nasync def forever():\n    while True:\n        await asyncio.sleep(0)\nasyncio.create_task(forever())\nawait forever()"),
    formatter=starting("class Slow:\n    def __repr__(self):\n        while True: pass\nSlow()"),
    figure=starting("""
        import matplotlib.pyplot as plt
        figure = plt.figure()
        figure.draw = lambda renderer: time.sleep(1e6)
        figure
    """),
    lists=starting("In = Out = get_ipython = display = print = len = type = isinstance = open = None"),
    streams=starting("""
        class Endless:
            encoding = "utf-8"
            def write(self, text):
                while True: pass
            flush = write
        sys.stdout = sys.stderr = sys.__stdout__ = sys.__stderr__ = Endless()
        print("x")
    """),
    slow_reader=starting("""
        # it takes no byte of what the judge sends from now on
        import threading
        signal.pthread_sigmask(signal.SIG_BLOCK, range(1, 64))
        threading.Event().wait()
    """),
)  # fmt: skip
def test_what_waits_where_nobody_looks_is_ended_too(fate):
    assert sum(result.score for name, result in fate.results.items() if name != "displacement") == 0
    if fate.stopped:
        assert re.search("time|ended", fate.messages)


@hands_in(
    files=starting("resource = __import__('resource')\nresource.setrlimit(resource.RLIMIT_NOFILE, (0, 0))"),
    memory=starting("resource = __import__('resource')\nresource.setrlimit(resource.RLIMIT_AS, (0, 0))"),
    time=starting("resource = __import__('resource')\nresource.setrlimit(resource.RLIMIT_CPU, (0, 0))"),
    stack=starting("resource = __import__('resource')\nresource.setrlimit(resource.RLIMIT_STACK, (0, 0))"),
    raised=starting("""
        import resource
        raised = 0
        for kind in range(16):
            soft, hard = resource.getrlimit(kind)
            try:
                resource.setrlimit(kind, (resource.RLIM_INFINITY, resource.RLIM_INFINITY))
                if hard != resource.RLIM_INFINITY:
                    print("LEAK raised", kind)
            except (OSError, ValueError):
                raised += 1
        print("kept:", raised)
    """),
    folder=starting("import shutil\nshutil.rmtree(os.getcwd(), ignore_errors=True)\nos.chdir('/')"),
    gone=starting("os.mkdir('gone'); os.chdir('gone'); os.rmdir('../gone')"),
    unreadable=starting("os.umask(0o777); os.chmod('.', 0)"),
    modules=starting("for name in list(sys.modules): del sys.modules[name]"),
    seccomp=starting("libc.prctl(38, 1, 0, 0, 0); libc.prctl(22, 1, 0, 0, 0)"),
    executable=starting("""
        import base64
        # a program in memory only, started where no file system has to allow it
        with open(sys.executable, "rb") as file:
            fd = os.memfd_create("program", 0)
            os.write(fd, b"#!/bin/sh\\nexit 7\\n")
        child = os.fork()
        if child == 0:
            try:
                os.execve(fd, ["program"], {})
            finally:
                os._exit(1)
        os.waitpid(child, 0)
    """),
    privileged=starting("""
        import subprocess
        for program in ("su", "sudo", "mount", "newgrp", "passwd", "chsh", "pkexec", "fusermount3", "bwrap", "ping"):
            try:
                done = subprocess.run([program, "--version"], capture_output=True, timeout=0.2, stdin=subprocess.DEVNULL)
            except (OSError, subprocess.SubprocessError):
                continue
        if os.geteuid() == 0 or subprocess.run(["su", "-c", "id -u"], capture_output=True, stdin=subprocess.DEVNULL).stdout.strip() == b"0":
            print("LEAK root")
        with open("/tmp/own", "wb") as file:
            pass
        os.chmod("/tmp/own", 0o6755)
    """),
)  # fmt: skip
def test_what_a_notebook_does_to_itself_hurts_only_itself(fate):
    assert sum(result.score for name, result in fate.results.items() if name != "displacement") == 0
    if "raised" in fate.student:
        assert int(fate.line("kept")) > 3


def test_nothing_is_left_on_the_machine(cohort):
    assert left_behind() == []
    traces = [path for folder in ("/tmp", "/dev/shm", "/var/tmp") for path in Path(folder).glob(f"*{MARK}*")]
    assert traces == []
    assert not list(Path("/tmp").glob("bomb[0-9]*"))

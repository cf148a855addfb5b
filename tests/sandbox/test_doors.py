"""What a real worker and a real compiler can do, in the words of the kernel."""

import errno
import json
import os
import platform
import signal
from pathlib import Path

import pytest

from grader.sandbox.box import Isolation
from grader.sandbox.syscalls import architecture, number
from tests.sandbox.boxes import Given, as_compiler, as_worker, python_as_compiler

X86 = platform.machine() == "x86_64"


def calls(isolation: Isolation, *wanted: tuple[str, list[int]]) -> list[int]:
    """Make system calls in a worker, one after another; what the kernel answers to each."""
    of = architecture()
    rows = [[number(name, of), *arguments] for name, arguments in wanted]
    code = "print([called(*map(ctypes.c_long, row)) for row in eval(arguments[0])])"
    outcome = as_worker(isolation, code, Given(words=[json.dumps(rows)]))
    assert outcome.code == 0, outcome
    answers = json.loads(outcome.out)
    return [int(each) for each in answers]


def test_refused_calls_answer_and_the_worker_lives(isolation: Isolation) -> None:
    """EPERM for what is forbidden, ENOSYS for what does not exist here."""
    refused = ("socket", "ptrace", "unshare", "memfd_create", "keyctl", "setuid", "mount")
    answers = calls(isolation, *[(name, [0, 0, 0]) for name in refused], ("clone3", [0, 0]))
    assert answers == [-errno.EPERM] * len(refused) + [-errno.ENOSYS]


def test_a_worker_has_no_children(isolation: Isolation) -> None:
    """Neither by fork nor by vfork nor by clone with the flags of a process."""
    older = ("fork", "vfork") if X86 else ()
    wanted = [("clone", [17, 0, 0, 0, 0]), *((name, list[int]()) for name in older)]
    assert calls(isolation, *wanted) == [-errno.EPERM] * len(wanted)


def test_a_worker_starts_no_program(isolation: Isolation) -> None:
    """Whatever file is named, and by descriptor too."""
    outcome = as_worker(
        isolation,
        """
        for path in (sys.executable, "/bin/sh", "/usr/bin/env", "/no/such/file"):
            try:
                os.execv(path, ["x"])
            except PermissionError as fault:
                print(fault.errno)
        """,
    )
    assert outcome.out.split() == [b"1"] * 4


def test_a_worker_writes_nothing(isolation: Isolation, open_folder: Path) -> None:
    """Not even where everyone may write, and not what it can read."""
    file = open_folder / "file"
    file.write_text("ours")
    file.chmod(0o666)
    open_folder.chmod(0o777)
    outcome = as_worker(
        isolation,
        """
        file, new = arguments
        print(os.read(os.open(file, os.O_RDONLY), 9).decode())
        attempts = [
            lambda: os.open(file, os.O_WRONLY),
            lambda: os.open(file, os.O_RDWR),
            lambda: os.open(file, os.O_RDONLY | os.O_TRUNC),
            lambda: os.open(new, os.O_WRONLY | os.O_CREAT),
            lambda: os.truncate(file, 0),
            lambda: os.unlink(file),
            lambda: os.rename(file, new),
            lambda: os.mkdir(new),
            lambda: os.symlink("/", new),
            lambda: os.mkfifo(new),
            lambda: os.chmod(file, 0),
            lambda: os.utime(file),
            lambda: os.link(file, new),
            lambda: os.setxattr(file, "user.x", b"y"),
        ]
        for number, attempt in enumerate(attempts):
            try:
                attempt()
                print("could", number)
            except OSError as fault:
                pass
        """,
        Given(readable=(file,), words=[str(file), str(open_folder / "new")]),
    )
    assert (outcome.code, outcome.out) == (0, b"ours\n"), outcome
    assert file.read_text() == "ours"
    assert os.listdir(open_folder) == ["file"]  # noqa: PTH208 - names are enough


def test_abort_is_still_an_abort(isolation: Isolation) -> None:
    """A signal to itself works, so that a failed assertion is shown as one."""
    assert as_worker(isolation, "os.abort()").code == -signal.SIGABRT


def test_a_worker_signals_nobody(isolation: Isolation) -> None:
    """Neither the grader nor its own group nor everybody."""
    outcome = as_worker(
        isolation,
        """
        for pid in (1, int(arguments[0]), 0, -1, os.getppid()):
            try:
                os.kill(pid, 0)
                print("could", pid)
            except OSError:
                pass
        os.kill(os.getpid(), 0)
        print("done")
        """,
        Given(words=[str(os.getpid())]),
    )
    assert outcome.out == b"done\n", outcome


def test_threads_are_legal(isolation: Isolation) -> None:
    """A submission may build its tree in parallel."""
    outcome = as_worker(
        isolation,
        """
        seen = []
        threads = [threading.Thread(target=seen.append, args=(i,)) for i in range(8)]
        for each in threads: each.start()
        for each in threads: each.join()
        print(sorted(seen))
        """,
    )
    assert outcome.out == b"[0, 1, 2, 3, 4, 5, 6, 7]\n", outcome


def test_limits_are_for_reading(isolation: Isolation) -> None:
    """`getrlimit` works, no limit moves."""
    outcome = as_worker(
        isolation,
        """
        soft, hard = resource.getrlimit(resource.RLIMIT_CPU)
        try:
            resource.setrlimit(resource.RLIMIT_CPU, (hard, hard))
        except (OSError, ValueError):
            print("refused", soft, hard)
        """,
    )
    assert outcome.out == b"refused 20 21\n", outcome


FOREIGN = {
    "x32": "called(0x40000000 + 39)",
    "int 0x80": """
        page = mmap.mmap(-1, 4096, prot=7)
        page.write(bytes.fromhex("b814000000cd80c3"))
        ctypes.CFUNCTYPE(ctypes.c_int)(ctypes.addressof(ctypes.c_char.from_buffer(page)))()
    """,
}
"""The second is `mov eax, 20; int 0x80; ret`: getpid of 32 bits, writev of 64."""


@pytest.mark.parametrize("name", FOREIGN if X86 else [])
def test_foreign_conventions_end_the_worker(isolation: Isolation, name: str) -> None:
    """They would have other numbers; no honest program uses them."""
    assert as_worker(isolation, FOREIGN[name]).code == -signal.SIGSYS


def test_a_compiler_compiles_and_links(isolation: Isolation, open_folder: Path) -> None:
    """The box is as wide as it has to be."""
    source = open_folder / "hello.cpp"
    source.write_text("#include <cstdio>\nint main() { std::puts(__FILE__); }\n")
    own = open_folder / "own"
    outcome = as_compiler(
        isolation,
        own,
        ["/usr/bin/g++", str(source), "-o", str(own / "hello")],
        Given(readable=(source,)),
    )
    assert (outcome.code, outcome.err) == (0, b"")
    assert (own / "hello").stat().st_size > 1000


def test_a_compiler_reaches_nothing(isolation: Isolation, open_folder: Path) -> None:
    """No network, no neighbour's file, no signal, no new session or group, no link."""
    secret = open_folder / "secret"
    secret.write_text("ours")
    secret.chmod(0o644)
    outcome = python_as_compiler(
        isolation,
        open_folder / "own",
        f"""
        import ctypes, os, signal, socket
        library = ctypes.CDLL(None, use_errno=True)
        secret, grader = {str(secret)!r}, {os.getpid()}
        def unshare():
            if library.unshare(0x10000000): raise OSError
        def traced():
            if library.ptrace(0, 0, 0, 0): raise OSError
        attempts = dict(
            read=lambda: open(secret), append=lambda: open(secret, "a"),
            look=lambda: os.listdir(os.path.dirname(secret)),
            make=lambda: open(os.path.dirname(secret) + "/new", "w"),
            passwd=lambda: open("/etc/passwd"), proc=lambda: os.listdir("/proc"),
            tmp=lambda: open("/tmp/bvhgrade-new", "w"), shm=lambda: open("/dev/shm/new", "w"),
            inet=lambda: socket.socket(), unix=lambda: socket.socket(socket.AF_UNIX),
            pair=socket.socketpair, kill=lambda: os.kill(grader, 0),
            kill_all=lambda: os.kill(-1, 0), session=os.setsid,
            group=lambda: os.setpgid(0, 0), link=lambda: os.symlink("/", "link"),
            hard=lambda: os.link(secret, "hard"), fifo=lambda: os.mkfifo("fifo"),
            folder=lambda: os.mkdir("folder"), root=lambda: os.chroot("."),
            memory=lambda: os.memfd_create("x"), unshare=unshare, traced=traced,
        )
        for name, attempt in attempts.items():
            try:
                attempt()
                print("could", name)
            except OSError:
                pass
        if os.fork() == 0:
            try:
                os.setsid()
                print("could setsid", flush=True)
            except OSError:
                pass
            os._exit(0)
        os.wait()
        open("product", "w").write("made")
        print("done")
        """,
    )
    assert (outcome.code, outcome.out) == (0, b"done\n"), outcome
    assert os.listdir(open_folder / "own") == ["product"]  # noqa: PTH208 - names are enough
    assert secret.read_text() == "ours"


def test_a_box_is_empty_of_us(isolation: Isolation, monkeypatch: pytest.MonkeyPatch) -> None:
    """No variable, no argument of ours, no descriptor, no standard input, no root."""
    monkeypatch.setenv("BVHGRADE_TOKEN", "secret")
    ours = os.memfd_create("ours", 0)
    outcome = as_worker(
        isolation,
        """
        open_now = []
        for descriptor in range(64):
            try:
                fcntl.fcntl(descriptor, fcntl.F_GETFD)
                open_now.append(descriptor)
            except OSError:
                pass
        print([sorted(os.environ), open_now, os.read(0, 9), os.getuid(), os.geteuid()])
        """,
    )
    os.close(ours)
    names, descriptors, read, real, effective = eval(outcome.out)  # noqa: S307 - a test's own
    assert set(names) <= {"LC_ALL", "PATH", "PWD"}
    assert descriptors == [0, 1, 2]
    assert read == b""
    assert real == effective != 0

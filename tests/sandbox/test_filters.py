"""Both filters, on both architectures, asked about every number and every kind of argument."""

import errno
import fcntl
import os
from collections.abc import Callable

import pytest

from grader.sandbox.calls import COMPUTING, REFUSED
from grader.sandbox.filters import compiler_filter, worker_filter
from grader.sandbox.inside.enter import OWN_PID
from grader.sandbox.syscalls import ARCHITECTURES, NUMBERS
from tests.sandbox.bpf import ALLOW, ERRNO, JUMP, KILL, LOAD, RETURN, TESTS, Filter

MACHINES = tuple(ARCHITECTURES)
REFUSE, UNKNOWN = ERRNO | errno.EPERM, ERRNO | errno.ENOSYS
ME = int.from_bytes(OWN_PID, "little")
"""Replaced by the real number where the filter is loaded."""

THREAD_FLAGS = 0x003D0F00
"""What glibc and musl pass to clone for a thread."""

NEW = {
    "time": 0x80,
    "mount": 0x00020000,
    "cgroup": 0x02000000,
    "uts": 0x04000000,
    "ipc": 0x08000000,
    "user": 0x10000000,
    "pid": 0x20000000,
    "net": 0x40000000,
}
"""Source: linux/sched.h."""

Make = Callable[[str], bytes]
READ_ONLY = (os.O_RDONLY, os.O_RDONLY | os.O_CLOEXEC, os.O_DIRECTORY, os.O_NOFOLLOW, os.O_PATH)
WRITING = (
    os.O_WRONLY,
    os.O_RDWR,
    os.O_CREAT,
    os.O_TRUNC,
    os.O_APPEND,
    os.O_TMPFILE,
    os.O_TMPFILE | os.O_RDWR,
    os.O_WRONLY | os.O_CREAT | os.O_TRUNC | os.O_CLOEXEC,
    3,
)
"""3 asks for no access but for ioctl; nobody here needs that."""

HIGH = 1 << 32


@pytest.fixture(params=MACHINES)
def worker(request: pytest.FixtureRequest) -> Filter:
    """Give the filter of a worker."""
    return Filter(worker_filter(request.param), request.param)


@pytest.fixture(params=MACHINES)
def compiler(request: pytest.FixtureRequest) -> Filter:
    """Give the filter of a compiler."""
    return Filter(compiler_filter(request.param), request.param)


@pytest.mark.parametrize("make", [worker_filter, compiler_filter])
@pytest.mark.parametrize("machine", MACHINES)
def test_every_jump_stays_inside(make: Make, machine: str) -> None:
    """Each way ends with an answer, and every place can be loaded."""
    steps = Filter(make(machine), machine).steps
    assert len(steps) <= 4096
    for place, (code, if_true, if_false, value) in enumerate(steps):
        assert code in {LOAD, RETURN, JUMP, *TESTS}
        if code == LOAD:
            assert value % 4 == 0
            assert 0 <= value < 64
        if code in TESTS:
            assert place + 1 + max(if_true, if_false) < len(steps)
    assert steps[-1][0] == RETURN
    answers = {value for code, _, _, value in steps if code == RETURN}
    assert answers <= {ALLOW, KILL, REFUSE, UNKNOWN}


@pytest.mark.parametrize("make", [worker_filter, compiler_filter])
@pytest.mark.parametrize("machine", MACHINES)
def test_another_architecture_ends_the_process(make: Make, machine: str) -> None:
    """A 32-bit call has other numbers: 11 is munmap here and execve there."""
    program = Filter(make(machine), machine)
    others = [0x40000003, 0x40000028, 0xC00000B7, 0xC000003E, 0x14, 0]
    for audit in others:
        if audit == ARCHITECTURES[machine].audit:
            continue
        assert {program.raw(audit, number) for number in range(512)} == {KILL}


@pytest.mark.parametrize("make", [worker_filter, compiler_filter])
def test_the_x32_convention_ends_the_process(make: Make) -> None:
    """The same audit number, but another table from bit 30 on."""
    program = Filter(make("x86_64"), "x86_64")
    audit = ARCHITECTURES["x86_64"].audit
    for number in (*range(0x40000000, 0x40000400), 0x7FFFFFFF, -1, -0x80000000):
        assert program.raw(audit, number) == KILL
    assert program.raw(audit, 0x3FFFFFFF) != KILL


def numbers_allowed(program: Filter) -> set[str]:
    """Names of the calls that pass with all arguments zero; unknown ones by their number."""
    architecture = ARCHITECTURES[program.machine]
    names = {
        numbers[architecture.column]: name
        for name, numbers in NUMBERS.items()
        if numbers[architecture.column] >= 0
    }
    return {
        names.get(number, str(number))
        for number in range(1024)
        if program.raw(architecture.audit, number) == ALLOW
    }


def test_a_worker_may_compute_and_nothing_else(worker: Filter) -> None:
    """Of all numbers only those of the list pass, and reading files with plain flags."""
    computing = {name for name in COMPUTING if worker.has(name)}
    reading = {name for name in ("open", "openat", "prlimit64", "fcntl") if worker.has(name)}
    assert numbers_allowed(worker) == computing | reading


def test_what_a_worker_may_it_may_with_all_arguments(worker: Filter) -> None:
    """No argument of a call that computes is looked at."""
    for name in COMPUTING:
        if worker.has(name):
            assert worker.call(name, *[2**64 - 1] * 6) == ALLOW


def test_the_rest_fails_and_does_not_kill(worker: Filter) -> None:
    """`system("pause")` and a debug file fail like on a machine that forbids them."""
    architecture = ARCHITECTURES[worker.machine]
    answers = {worker.raw(architecture.audit, number) for number in range(2048)}
    assert answers == {ALLOW, REFUSE, UNKNOWN}
    for name in ("fork", "vfork", "creat", "socket", "ptrace", "memfd_create", "tkill"):
        if worker.has(name):
            assert worker.call(name) == REFUSE


def test_a_compiler_may_all_but_the_list(compiler: Filter) -> None:
    """Each refused name fails with any arguments, everything else passes."""
    refused = {name for name in REFUSED if compiler.has(name)}
    passed = numbers_allowed(compiler)
    assert not refused & passed
    assert 1024 - len(passed) == len(refused) + 1  # and clone3
    for name in refused:
        assert compiler.call(name, *[2**64 - 1] * 6) == REFUSE


def test_the_lists_hold_what_escapes_are_made_of(compiler: Filter, worker: Filter) -> None:
    """Named here once more, so that no edit of a list loses one."""
    names = (
        "socket connect bind sendto sendmsg ptrace process_vm_writev pidfd_getfd keyctl bpf "
        "perf_event_open userfaultfd io_uring_setup mount unshare setns chroot pivot_root "
        "open_by_handle_at memfd_create kill tkill pidfd_send_signal rt_sigqueueinfo setsid "
        "setpgid personality shmget setuid setresuid symlink symlinkat link linkat mknodat"
    )
    for name in names.split():
        for program in (compiler, worker):
            if program.has(name):
                assert program.call(name) == REFUSE, name


@pytest.mark.parametrize("name", ["open", "openat"])
def test_a_worker_opens_for_reading_only(worker: Filter, name: str) -> None:
    """Every flag that changes something is refused, whatever else is asked."""
    if not worker.has(name):
        return
    before = () if name == "open" else (0xFFFFFF9C,)
    for flags in READ_ONLY:
        assert worker.call(name, *before, 0, flags) == ALLOW
        assert worker.call(name, *before, 0, flags | HIGH) == ALLOW
    for flags in WRITING:
        assert worker.call(name, *before, 0, flags) == REFUSE
        assert worker.call(name, *before, 0, flags | os.O_CLOEXEC | HIGH) == REFUSE


def test_what_hides_its_flags_in_memory_does_not_exist(
    worker: Filter, compiler: Filter
) -> None:
    """A filter cannot look behind a pointer; libraries fall back to the older call."""
    assert worker.call("openat2") == UNKNOWN
    assert worker.call("clone3") == UNKNOWN
    assert compiler.call("clone3") == UNKNOWN


def test_a_worker_has_threads_and_no_children(worker: Filter) -> None:
    """Without CLONE_THREAD it would be a process, with CLONE_NEW* a namespace."""
    assert worker.call("clone", THREAD_FLAGS) == ALLOW
    assert worker.call("clone", 17) == REFUSE
    assert worker.call("clone", 0) == REFUSE
    assert worker.call("clone", 0x4111) == REFUSE  # vfork
    for flag in NEW.values():
        assert worker.call("clone", THREAD_FLAGS | flag) == REFUSE
        assert worker.call("clone", flag | 17) == REFUSE


def test_a_compiler_has_children_and_no_namespaces(compiler: Filter) -> None:
    """`fork` and `posix_spawn` are clone with flags."""
    for flags in (17, 0x4111, THREAD_FLAGS, 0x01200011):
        assert compiler.call("clone", flags) == ALLOW
        for flag in NEW.values():
            assert compiler.call("clone", flags | flag) == REFUSE


@pytest.mark.parametrize("name", ["kill", "tgkill"])
def test_a_worker_signals_only_itself(worker: Filter, name: str) -> None:
    """`abort` works; 0, -1 and negative numbers mean groups and everybody."""
    assert worker.call(name, ME, 6, 6) == ALLOW
    assert worker.call(name, ME | HIGH, 6, 6) == ALLOW  # the kernel reads an int
    for other in (0, 1, ME + 1, ME - 1, 2**32 - 1, 2**32 - ME, 2**64 - 1, 2**64 - ME):
        assert worker.call(name, other, 9, 9) == REFUSE


@pytest.mark.parametrize("pid", [0, ME])
def test_limits_can_be_read_and_not_set(worker: Filter, pid: int) -> None:
    """A pointer of which only the upper half is set is a pointer."""
    assert worker.call("prlimit64", pid, 7, 0, 0x7FFFFFFFF000) == ALLOW
    for new in (1, 0x7FFFFFFFF000, HIGH, 0x7F00 << 32, 2**63):
        assert worker.call("prlimit64", pid, 7, new, 0) == REFUSE


@pytest.mark.parametrize("pid", [1, ME + 1, 2**32 - 1])
def test_nobody_touches_the_limits_of_others(
    worker: Filter, compiler: Filter, pid: int
) -> None:
    """Reading and setting alike; a compiler may set its own."""
    assert worker.call("prlimit64", pid, 7, 0, 4096) == REFUSE
    assert compiler.call("prlimit64", pid, 7, 4096, 0) == REFUSE
    assert compiler.call("prlimit64", 0, 7, 4096, 0) == ALLOW


def test_a_worker_names_threads_and_no_more(worker: Filter) -> None:
    """Names of threads and of memory; not death signals, dumps, filters, speculation."""
    allowed = {option for option in range(80) if worker.call("prctl", option) == ALLOW}
    assert allowed == {15, 16}
    assert worker.call("prctl", 0x53564D41) == ALLOW
    assert worker.call("prctl", 0x59616D61) == REFUSE  # Yama's ptracer


def test_ioctl_asks_terminals_only(worker: Filter, compiler: Filter) -> None:
    """Pushing characters into a terminal is typing for its owner."""
    asked = {
        command
        for command in range(0x5400, 0x5480)
        if worker.call("ioctl", 1, command) == ALLOW
    }
    assert asked == {0x5401, 0x5413}
    refused = {
        command
        for command in range(0x5400, 0x5480)
        if compiler.call("ioctl", 1, command) != ALLOW
    }
    assert refused == {0x5412, 0x541C}
    assert compiler.call("ioctl", 0, 0x5412 | HIGH) == REFUSE


def test_fcntl_neither_locks_nor_seals_nor_notifies(worker: Filter) -> None:
    """Duplicates and flags of descriptors only."""
    allowed = {command for command in range(2048) if worker.call("fcntl", 1, command) == ALLOW}
    assert allowed == {
        fcntl.F_DUPFD,
        fcntl.F_GETFD,
        fcntl.F_SETFD,
        fcntl.F_GETFL,
        fcntl.F_SETFL,
        fcntl.F_DUPFD_CLOEXEC,
    }


def test_no_pipe_becomes_one_of_packets(worker: Filter) -> None:
    """The grader would read each byte of the output by itself."""
    assert worker.call("fcntl", 1, fcntl.F_SETFL, os.O_NONBLOCK | os.O_APPEND) == ALLOW
    for marks in (os.O_DIRECT, os.O_DIRECT | os.O_NONBLOCK):
        assert worker.call("fcntl", 1, fcntl.F_SETFL, marks) == REFUSE
    assert worker.call("fcntl", 1, fcntl.F_DUPFD, os.O_DIRECT) == ALLOW

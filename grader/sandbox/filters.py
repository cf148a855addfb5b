"""Which system calls may a process make that holds a submission, or compiles one?

A worker gets a list of what is allowed: to compute, to read files, to have threads. Everything
else fails with EPERM instead of killing, so that a forgotten `system("pause")` or a debug file
costs nobody a point. A compiler gets a list of what is refused, since compilers differ. Calls
by the convention of another architecture end the process: they would have other numbers.

The result is a program of the kernel's classic BPF, eight bytes an instruction.
Source: the kernel's userspace-api/seccomp_filter; linux/seccomp.h, linux/bpf_common.h.
"""

import errno
import fcntl
import os
import struct
from collections.abc import Iterable, Iterator, Sequence

from grader.sandbox.inside.enter import OWN_PID
from grader.sandbox.syscalls import Architecture, architecture, number

_LOAD, _EQUAL, _AT_LEAST, _ANY_BIT, _RETURN = 0x20, 0x15, 0x35, 0x45, 0x06
_NUMBER, _ARCHITECTURE, _ARGUMENTS = 0, 4, 16
_ALLOW, _KILL, _ERRNO = 0x7FFF0000, 0x80000000, 0x00050000
_REFUSE = _ERRNO | errno.EPERM
_UNKNOWN = _ERRNO | errno.ENOSYS

_WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND | 0o20000000
"""Flags of open that change something; the last is O_TMPFILE without its O_DIRECTORY."""

_CLONE_THREAD = 0x00010000
_CLONE_NEW = 0x7E020080
"""All flags that make a namespace."""

_SET_NAME, _GET_NAME, _SET_VMA = 15, 16, 0x53564D41
_TERMINAL_STATE, _WINDOW_SIZE, _FAKE_INPUT, _CONSOLE = 0x5401, 0x5413, 0x5412, 0x541C
_DESCRIPTOR_COMMANDS = (
    fcntl.F_DUPFD,
    fcntl.F_GETFD,
    fcntl.F_SETFD,
    fcntl.F_GETFL,
    fcntl.F_SETFL,
    fcntl.F_DUPFD_CLOEXEC,
)

COMPUTING = [
    "read",
    "write",
    "readv",
    "writev",
    "pread64",
    "close",
    "lseek",
    "access",
    "faccessat",
    "faccessat2",
    "readlink",
    "readlinkat",
    "stat",
    "lstat",
    "fstat",
    "newfstatat",
    "statx",
    "getcwd",
    "dup",
    "dup2",
    "dup3",
    "poll",
    "ppoll",
    "select",
    "pselect6",
    "mmap",
    "munmap",
    "mprotect",
    "mremap",
    "madvise",
    "brk",
    "mincore",
    "msync",
    "rt_sigaction",
    "rt_sigprocmask",
    "rt_sigreturn",
    "rt_sigpending",
    "rt_sigsuspend",
    "rt_sigtimedwait",
    "sigaltstack",
    "pause",
    "alarm",
    "setitimer",
    "getitimer",
    "getpid",
    "gettid",
    "getppid",
    "getuid",
    "geteuid",
    "getgid",
    "getegid",
    "getpgrp",
    "getpgid",
    "getsid",
    "futex",
    "futex_waitv",
    "set_robust_list",
    "get_robust_list",
    "rseq",
    "set_tid_address",
    "membarrier",
    "restart_syscall",
    "sched_yield",
    "sched_getaffinity",
    "sched_getparam",
    "sched_getscheduler",
    "sched_get_priority_max",
    "sched_get_priority_min",
    "sched_rr_get_interval",
    "getpriority",
    "getcpu",
    "nanosleep",
    "clock_nanosleep",
    "clock_gettime",
    "clock_getres",
    "gettimeofday",
    "time",
    "times",
    "getrusage",
    "getrlimit",
    "sysinfo",
    "uname",
    "umask",
    "getrandom",
    "exit",
    "exit_group",
]
"""Calls that a worker may make with any arguments."""

REFUSED = [
    "socket",
    "socketpair",
    "connect",
    "bind",
    "listen",
    "accept",
    "accept4",
    "sendto",
    "recvfrom",
    "sendmsg",
    "recvmsg",
    "sendmmsg",
    "recvmmsg",
    "ptrace",
    "process_vm_readv",
    "process_vm_writev",
    "process_madvise",
    "kcmp",
    "pidfd_getfd",
    "pidfd_open",
    "pidfd_send_signal",
    "kill",
    "tkill",
    "keyctl",
    "add_key",
    "request_key",
    "bpf",
    "perf_event_open",
    "userfaultfd",
    "io_uring_setup",
    "io_uring_enter",
    "io_uring_register",
    "mount",
    "umount2",
    "pivot_root",
    "chroot",
    "unshare",
    "setns",
    "open_tree",
    "move_mount",
    "fsopen",
    "fsconfig",
    "fsmount",
    "fspick",
    "mount_setattr",
    "open_by_handle_at",
    "name_to_handle_at",
    "init_module",
    "finit_module",
    "delete_module",
    "kexec_load",
    "kexec_file_load",
    "reboot",
    "swapon",
    "swapoff",
    "acct",
    "quotactl",
    "syslog",
    "sethostname",
    "setdomainname",
    "settimeofday",
    "clock_settime",
    "adjtimex",
    "clock_adjtime",
    "iopl",
    "ioperm",
    "modify_ldt",
    "personality",
    "shmget",
    "shmat",
    "shmctl",
    "shmdt",
    "msgget",
    "msgsnd",
    "msgrcv",
    "msgctl",
    "semget",
    "semop",
    "semctl",
    "semtimedop",
    "mq_open",
    "mq_unlink",
    "mkdir",
    "mkdirat",
    "symlink",
    "symlinkat",
    "link",
    "linkat",
    "mknod",
    "mknodat",
    "fanotify_init",
    "inotify_init",
    "inotify_init1",
    "setuid",
    "setgid",
    "setreuid",
    "setregid",
    "setresuid",
    "setresgid",
    "setgroups",
    "setfsuid",
    "setfsgid",
    "capset",
    "memfd_create",
    "memfd_secret",
    "vhangup",
    "lookup_dcookie",
    "nfsservctl",
    "set_mempolicy",
    "mbind",
    "migrate_pages",
    "move_pages",
    "sched_setscheduler",
    "sched_setattr",
    "sched_setparam",
    "setpriority",
]
"""Calls that no compiler needs: other processes, the network, the system, links and folders."""

Instruction = tuple[int, int, int, int]
"""Code, jump if true, jump if false, constant."""


def worker_filter(machine: str = "") -> bytes:
    """Program for the process that holds a submission.

    Args:
        machine: Another processor than this one.
    """
    of = architecture(machine)
    own = int.from_bytes(OWN_PID, "little")
    parts = [
        *(_when(of, name, [_answer(_ALLOW)]) for name in COMPUTING),
        _when(of, "open", _unless_bits(1, _WRITING, _ALLOW)),
        _when(of, "openat", _unless_bits(2, _WRITING, _ALLOW)),
        _when(of, "openat2", [_answer(_UNKNOWN)]),
        _when(of, "clone3", [_answer(_UNKNOWN)]),
        _when(of, "clone", [*_unless_bits(0, _CLONE_NEW, None), *_if_bits(0, _CLONE_THREAD)]),
        _when(of, "kill", _if_one_of(0, [own])),
        _when(of, "tgkill", _if_one_of(0, [own])),
        _when(of, "prctl", _if_one_of(0, [_SET_NAME, _GET_NAME, _SET_VMA])),
        _when(of, "ioctl", _if_one_of(1, [_TERMINAL_STATE, _WINDOW_SIZE])),
        _when(of, "fcntl", _if_one_of(1, _DESCRIPTOR_COMMANDS)),
        _when(of, "prlimit64", _reading_limits()),
    ]
    return _program(of, parts, _REFUSE)


def compiler_filter(machine: str = "") -> bytes:
    """Program for the processes that compile and link a submission."""
    of = architecture(machine)
    parts = [
        *(_when(of, name, [_answer(_REFUSE)]) for name in REFUSED),
        _when(of, "clone3", [_answer(_UNKNOWN)]),
        _when(of, "clone", _unless_bits(0, _CLONE_NEW, _ALLOW)),
        _when(of, "ioctl", [*_if_one_of(1, [_FAKE_INPUT, _CONSOLE], _REFUSE, _ALLOW)]),
    ]
    return _program(of, parts, _ALLOW)


def _program(of: Architecture, parts: Iterable[Sequence[Instruction]], default: int) -> bytes:
    code: list[Instruction] = [
        (_LOAD, 0, 0, _ARCHITECTURE),
        (_EQUAL, 1, 0, of.audit),
        _answer(_KILL),
        (_LOAD, 0, 0, _NUMBER),
    ]
    if of.foreign:
        code += [(_AT_LEAST, 0, 1, of.foreign), _answer(_KILL)]
    for part in parts:
        code += part
    code.append(_answer(default))
    return b"".join(struct.pack("<HBBI", *each) for each in code)


def _answer(value: int) -> Instruction:
    return (_RETURN, 0, 0, value)


def _argument(index: int) -> Instruction:
    """Load the lower half of an argument: flags and commands are 32-bit integers."""
    return (_LOAD, 0, 0, _ARGUMENTS + 8 * index)


def _when(of: Architecture, name: str, then: Sequence[Instruction]) -> list[Instruction]:
    """Decide one call; the number is in the accumulator, and `then` ends with an answer."""
    called = number(name, of)
    return [] if called < 0 else [(_EQUAL, 0, len(then), called), *then]


def _unless_bits(index: int, bits: int, then: int | None) -> list[Instruction]:
    """Refuse if any bit is set in an argument; otherwise answer, or go on."""
    code = [_argument(index), (_ANY_BIT, 0, 1, bits), _answer(_REFUSE)]
    return code if then is None else [*code, _answer(then)]


def _if_bits(index: int, bits: int) -> list[Instruction]:
    """Allow if any bit is set in an argument, else refuse."""
    return [_argument(index), (_ANY_BIT, 0, 1, bits), _answer(_ALLOW), _answer(_REFUSE)]


def _if_one_of(
    index: int, values: Sequence[int], then: int = _ALLOW, otherwise: int = _REFUSE
) -> list[Instruction]:
    return [_argument(index), *_compared(values, then), _answer(otherwise)]


def _compared(values: Iterable[int], then: int) -> Iterator[Instruction]:
    for value in values:
        yield (_EQUAL, 0, 1, value)
        yield _answer(then)


def _reading_limits() -> list[Instruction]:
    """prlimit64 of this process, with no new limit: both halves of the pointer are null."""
    low, high = _ARGUMENTS + 8 * 2, _ARGUMENTS + 8 * 2 + 4
    return [
        (_LOAD, 0, 0, low),
        (_EQUAL, 1, 0, 0),
        _answer(_REFUSE),
        (_LOAD, 0, 0, high),
        (_EQUAL, 1, 0, 0),
        _answer(_REFUSE),
        _argument(0),
        (_EQUAL, 0, 1, 0),
        _answer(_ALLOW),
        (_EQUAL, 0, 1, int.from_bytes(OWN_PID, "little")),
        _answer(_ALLOW),
        _answer(_REFUSE),
    ]

"""The numbers of system calls are those of the kernel's own headers, and the lists agree."""

import re
import subprocess

import pytest

from grader.errors import MissingTool
from grader.sandbox.calls import COMPUTING, REFUSED
from grader.sandbox.syscalls import ARCHITECTURES, NUMBERS, architecture, number

ARM_WANTS = (
    "RENAMEAT",
    "NEW_STAT",
    "SET_GET_RLIMIT",
    "TIME32_SYSCALLS",
    "SYS_CLONE3",
    "MEMFD_SECRET",
)
"""What arch/arm64/include/uapi/asm/unistd.h asks of the generic table."""

HEADERS = {
    "x86_64": ("asm/unistd_64.h", ()),
    "aarch64": ("asm-generic/unistd.h", ARM_WANTS),
}


def of_the_headers(machine: str) -> dict[str, int]:
    """Ask the compiler for the value of every name that a kernel header defines."""
    header, wants = HEADERS[machine]
    options = [f"-D__ARCH_WANT_{each}" for each in wants]
    lines = "".join(f'"{name}" __NR_{name}\n' for name in NUMBERS)
    said = subprocess.run(
        ["g++", "-E", "-P", *options, "-x", "c", "-"],
        input=f"#include <{header}>\n{lines}",
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    found = re.findall(r'"(\w+)"\s+([^\n]+)', said)
    assert len(found) == len(NUMBERS)
    return {name: int(text) if text.isdigit() else -1 for name, text in found}


@pytest.mark.parametrize("machine", HEADERS)
def test_every_number_is_the_kernels(machine: str) -> None:
    """A wrong number would open one door and close another."""
    kernel = of_the_headers(machine)
    ours = {name: numbers[architecture(machine).column] for name, numbers in NUMBERS.items()}
    assert ours == kernel
    assert kernel["openat"] != -1


@pytest.mark.parametrize("machine", HEADERS)
def test_no_number_stands_for_two_calls(machine: str) -> None:
    """What is decided about one name is not decided about another by mistake."""
    column = architecture(machine).column
    numbers = [each[column] for each in NUMBERS.values() if each[column] != -1]
    assert len(numbers) == len(set(numbers))


def test_no_call_is_allowed_here_and_refused_there() -> None:
    """What a worker may do with any arguments, a compiler may do too."""
    assert not set(COMPUTING) & set(REFUSED)
    for names in (COMPUTING, REFUSED):
        assert len(names) == len(set(names))
        assert set(names) <= set(NUMBERS)


def test_every_number_is_used_by_a_filter_or_decided_by_its_arguments() -> None:
    """The table has nothing that no list speaks of."""
    by_arguments = {
        "clone",
        "clone3",
        "fcntl",
        "ioctl",
        "open",
        "openat",
        "openat2",
        "prctl",
        "prlimit64",
    }
    refused_to_workers_by_silence = {"creat", "fork", "vfork"}
    known = {*COMPUTING, *REFUSED, *by_arguments, *refused_to_workers_by_silence}
    assert set(NUMBERS) == known


def test_an_unknown_processor_is_said() -> None:
    """There is no filter for it, so nothing is run on it."""
    with pytest.raises(MissingTool, match=r"x86_64 and aarch64, but this machine is riscv64"):
        architecture("riscv64")


def test_a_call_that_is_missing_has_no_number() -> None:
    """New architectures have no `open`; nothing may be decided about number -1."""
    assert number("open", ARCHITECTURES["aarch64"]) == -1
    assert number("open", ARCHITECTURES["x86_64"]) == 2

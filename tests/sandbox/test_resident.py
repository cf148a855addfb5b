"""What a process holds in memory is seen, wherever it hides it."""

import subprocess
import sys

import pytest

from grader.sandbox.resident import resident_bytes

FILL = """
import ctypes, mmap, sys, threading, time
at = mmap.mmap(-1, 1 << 36, flags=mmap.MAP_PRIVATE | 0x4000)
def fill():
    {work}
    print("filled", flush=True)
    time.sleep(600)
{begin}
"""
HERE = "fill()"
IN_ANOTHER_THREAD = "threading.Thread(target=fill).start(); ctypes.CDLL(None).pthread_exit(0)"
WRITE = "at[: 96 << 20] = bytes(96 << 20)"
READ = "any(at[k] for k in range(0, len(at), 2 << 20))"
"""Of 64 GiB each 2 MiB get a table of 4 KiB and no page of their own: 128 MiB. 0x4000 keeps
them from being reserved."""


@pytest.mark.parametrize("work", [WRITE, READ], ids=["pages", "tables"])
@pytest.mark.parametrize("begin", [HERE, IN_ANOTHER_THREAD], ids=["first", "another"])
def test_pages_and_their_tables_are_seen(work: str, begin: str) -> None:
    """Also when the first thread has ended, whose process tells nothing then."""
    code = FILL.format(work=work, begin=begin)
    with subprocess.Popen([sys.executable, "-c", code], stdout=subprocess.PIPE) as process:
        assert process.stdout is not None
        assert process.stdout.readline() == b"filled\n"
        held = resident_bytes(process.pid)
        process.kill()
    assert 96 << 20 <= held <= 512 << 20
    assert resident_bytes(process.pid) == 0

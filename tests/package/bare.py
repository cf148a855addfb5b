"""A bare Debian, as a host's container is one; nothing in it has privileges or a network."""

import os
import platform
import re
import shutil
import subprocess
import threading
import time
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

INSTALLED = ("g++", "cmake", "make", "bubblewrap", "python3", "python3-venv")
"""What install.sh would get by apt; nobody here may."""

TEMPORARY = "/tmp"  # noqa: S108 - of the bare Debian, where it is empty
MEMORY = Path("/dev/shm")  # noqa: S108 - a folder of its own is made in it
ROOM = 6 << 30
"""Bytes that a bare Debian and what a host installs in it need at most."""

STRANGER = 65534
BETWEEN_LOOKS = 0.1


def bare_debian(folder: Path) -> Path:
    """Build the root file system by debootstrap, from where this machine gets its packages."""
    root = folder / "root"
    command = ["debootstrap", "--variant=minbase", f"--include={','.join(INSTALLED)}"]
    suite = platform.freedesktop_os_release()["VERSION_CODENAME"]
    built = subprocess.run(
        [*as_root(), *command, suite, str(root), mirror(suite)],
        capture_output=True,
        text=True,
        check=False,
    )
    assert built.returncode == 0, built.stdout[-2000:] + built.stderr[-2000:]
    return root


def in_memory() -> Path | None:
    """Say where to lay many files: in memory if a root may lie there, for dpkg syncs each.

    Returns:
        A folder; None for the usual one.
    """
    if not MEMORY.is_dir():
        return None
    state = os.statvfs(MEMORY)
    usable = not state.f_flag & (os.ST_NODEV | os.ST_NOEXEC)
    return MEMORY if usable and state.f_bavail * state.f_frsize > ROOM else None


def as_root() -> list[str]:
    """Begin a command that only root may run."""
    return [] if os.geteuid() == 0 else ["sudo", "-n"]


def mirror(suite: str) -> str:
    """Say where this machine gets the packages of its own release from."""
    told = subprocess.run(
        ["apt-get", "indextargets", "--format", "$(SITE) $(CODENAME)"],
        capture_output=True,
        text=True,
        check=True,
    ).stdout
    sites = re.findall(rf"^(\S+) {suite}$", told, re.MULTILINE)
    return str(sites[0])


@dataclass(frozen=True)
class Container:
    """A bare Debian with folders of a host in it, which a stranger may write."""

    root: Path
    folders: tuple[tuple[Path, str], ...]
    """Folder here, place there."""

    def run(self, *command: str) -> tuple[subprocess.CompletedProcess[str], int]:
        """Run a command in it; returns also the most memory of all its processes, bytes."""
        for folder, place in self.folders:
            subprocess.run([*as_root(), "mkdir", "-p", f"{self.root}{place}"], check=True)
            hand_over(folder)
        words = ["bwrap", "--unshare-all", "--unshare-user", "--disable-userns"]
        words += ["--die-with-parent", "--ro-bind", str(self.root), "/", "--tmpfs", TEMPORARY]
        words += ["--proc", "/proc", "--dev", "/dev", "--clearenv"]
        words += [
            "--setenv",
            "PATH",
            "/usr/sbin:/usr/bin:/sbin:/bin",
            "--setenv",
            "HOME",
            TEMPORARY,
        ]
        for folder, place in self.folders:
            words += ["--bind", str(folder), place]
        started = subprocess.Popen(
            [*without_privileges(), *words, *command],
            stdout=subprocess.PIPE,
            stderr=subprocess.STDOUT,
            text=True,
        )
        most = Most(started.pid)
        told, _ = started.communicate()
        return subprocess.CompletedProcess(command, started.returncode, told), most.end()


def hand_over(folder: Path) -> None:
    """Let the stranger write a folder, as long as this process is root."""
    if os.geteuid() == 0:
        for path in [folder, *folder.rglob("*")]:
            os.chown(path, STRANGER, STRANGER, follow_symlinks=False)


def without_privileges() -> list[str]:
    """Begin a command that is to run as nobody in particular."""
    if os.geteuid() != 0:
        return []
    return ["setpriv", f"--reuid={STRANGER}", f"--regid={STRANGER}", "--clear-groups"]


class Most:
    """Looks at the memory of a process and all below it, until it is told to end."""

    def __init__(self, pid: int) -> None:
        self._pid, self._most = pid, 0
        self._over = threading.Event()
        self._thread = threading.Thread(target=self._look)
        self._thread.start()

    def end(self) -> int:
        """Return the most that was seen, bytes."""
        self._over.set()
        self._thread.join()
        return self._most

    def _look(self) -> None:
        while not self._over.is_set():
            self._most = max(self._most, sum(map(memory, family(self._pid))))
            time.sleep(BETWEEN_LOOKS)


def family(pid: int) -> list[int]:
    """Find a process and all below it."""
    parents: dict[int, list[int]] = {}
    for entry in Path("/proc").iterdir():
        if entry.name.isdigit():
            with suppress(OSError):
                after_name = (entry / "stat").read_text().rpartition(")")[2].split()
                parents.setdefault(int(after_name[1]), []).append(int(entry.name))
    found = [pid]
    for one in found:
        found += parents.get(one, [])
    return found


def memory(pid: int) -> int:
    """Read the memory of a process, bytes; pages of several are shared out among them."""
    with suppress(OSError):
        rolled = Path(f"/proc/{pid}/smaps_rollup").read_text()
        if found := re.search(r"^Pss:\s+(\d+) kB", rolled, re.MULTILINE):
            return int(found[1]) << 10
    return 0


def python_of(root: Path) -> str:
    """Say which Python the bare Debian has: `3.11`."""
    return (root / "usr/bin/python3").readlink().name.removeprefix("python")


def remove(root: Path) -> None:
    """Remove a root file system, which may belong to root."""
    if os.geteuid() == 0:
        shutil.rmtree(root, ignore_errors=True)
    else:
        subprocess.run([*as_root(), "rm", "-rf", "--one-file-system", str(root)], check=False)

"""What lies around a hostile submission to be stolen, broken or called, and who saw what.

Everything here may be read, and what is to be broken may be written, by every user of this
machine: only the sandbox stands in the way. A submission names these places by words that are
filled in before it is graded, so that no attack fails for want of a path.
"""

import os
import re
import secrets
import shutil
import socket
import tempfile
import time
from collections.abc import Generator, Iterator
from contextlib import ExitStack, contextmanager
from dataclasses import dataclass
from pathlib import Path

from grader import resources
from grader.sandbox.slots import FIRST_UID, SLOTS

VARIABLE = "ATTACK_TOKEN"
"""Environment variable of the grader that holds a secret."""

SYSTEM_V_KEY = 0x42564847
"""Key of the shared memory that attacks try to leave behind."""

PATIENCE_SECONDS = 2.0
"""How long a killed process may take to be gone."""

_WORD = re.compile(rb"@([a-z]+)@")
_TEMPORARY = ("/tmp", "/var/tmp", "/dev/shm", "/run", "/usr/tmp", "/dev/mqueue")  # noqa: S108 - where attacks leave files

Process = tuple[int, str]
"""Number and start time: numbers are used again."""


@dataclass(frozen=True, slots=True)
class Witness:
    """One place with bait."""

    root: Path
    mark: str
    """Part of the name of everything that an attack may create."""

    secret: str
    """Part of every text that nobody may read."""

    words: dict[str, str]
    """What `@word@` stands for."""

    listeners: tuple[socket.socket, ...]

    def place(self, source: bytes) -> Path:
        """Lay a submission into its place, its words filled in."""
        path = self.root / "hand-in" / "exercise03.cpp"
        path.write_bytes(
            _WORD.sub(lambda match: self.words[match[1].decode()].encode(), source)
        )
        return path

    def changes(self, before: dict[str, str]) -> list[str]:
        """Which files here were made, changed or removed since then."""
        after = self.state()
        changed = before.items() ^ after.items()
        return sorted({f"{path} was touched" for path, _ in changed})

    def state(self) -> dict[str, str]:
        """Describe every file here: its kind, mode, size, times and content."""
        found = {}
        for path in sorted(self.root.rglob("*")):
            about = path.lstat()
            # Not the time of the last access: the grader reads the submission.
            facts = [about.st_mode, about.st_uid, about.st_size, about.st_mtime_ns]
            content = path.read_bytes() if path.is_file() else b""
            found[str(path)] = f"{facts} {content!r}"
        return found

    def callers(self) -> Iterator[str]:
        """Which of the listening sockets was reached."""
        for listener in self.listeners:
            try:
                listener.accept()[0].close()
            except BlockingIOError:
                continue
            yield f"{listener.getsockname()!r} was called"

    def remains(self) -> Iterator[str]:
        """What lies outside of this place and bears its mark, or the attacks' key."""
        for folder in (*map(Path, _TEMPORARY), Path.cwd()):
            names = folder.iterdir() if folder.is_dir() else ()
            yield from (f"{name} was left" for name in names if self.mark in name.name)
        for kind in ("shm", "sem", "msg"):
            table = Path("/proc/sysvipc", kind)
            rows = table.read_text().splitlines()[1:] if table.exists() else []
            keys = [int(row.split()[0]) & 0xFFFFFFFF for row in rows]
            yield from (f"System V {kind} was left" for key in keys if key == SYSTEM_V_KEY)


@contextmanager
def witnessed() -> Generator[Witness]:
    """Lay out a place with bait; it is gone afterwards."""
    mark = f"attack-{secrets.token_hex(8)}"
    secret = f"secret_{secrets.token_hex(16)}"
    answers = resources.cache_folder() / mark
    with ExitStack() as stack:
        root = Path(tempfile.mkdtemp(prefix="bvhgrade-"))
        stack.callback(shutil.rmtree, root)
        stack.callback(answers.unlink)
        root.chmod(0o755)
        for name in ("hand-in", "neighbour", "home", "open"):
            (root / name).mkdir()
            (root / name).chmod(0o755)
        (root / "open").chmod(0o777)
        text = f"{secret} = 1;\n"
        neighbour = f"// {text}" + resources.reference_source().read_text()
        files = {
            "secret": (root / "home" / "secret.txt", text, 0o644),
            "home": (root / "home" / ".netrc", text, 0o644),
            "beside": (root / "hand-in" / "token.txt", text, 0o644),
            "neighbour": (root / "neighbour" / "exercise03.cpp", neighbour, 0o666),
            "canary": (root / "open" / "canary", "alive\n", 0o666),
            "answers": (answers, text, 0o644),
        }
        for path, content, mode in files.values():
            path.write_text(content)
            path.chmod(mode)
        listeners = tuple(
            stack.enter_context(_listening(family, address))
            for family, address in _addresses(root, mark)
        )
        (root / "open" / "socket").chmod(0o777)
        words = {
            **{word: str(path) for word, (path, _, _) in files.items()},
            "created": str(root / "open" / "created"),
            "reference": str(resources.reference_source()),
            "checkout": str(Path(__file__).parents[2]),
            "socket": str(root / "open" / "socket"),
            "port": str(listeners[0].getsockname()[1]),
            "mark": mark,
        }
        yield Witness(root, mark, secret, words, listeners)


def _addresses(root: Path, mark: str) -> Iterator[tuple[int, tuple[str, int] | str]]:
    yield socket.AF_INET, ("127.0.0.1", 0)
    yield socket.AF_UNIX, str(root / "open" / "socket")
    yield socket.AF_UNIX, f"\0{mark}"


@contextmanager
def _listening(family: int, address: tuple[str, int] | str) -> Generator[socket.socket]:
    with socket.socket(family) as listener:
        listener.bind(address)
        listener.listen()
        listener.setblocking(False)
        yield listener


def survivors(before: set[Process]) -> list[str]:
    """Who lives that did not before, after everybody had time to be gone."""
    deadline = time.monotonic() + PATIENCE_SECONDS
    while (found := census() - before) and time.monotonic() < deadline:
        time.sleep(0.02)
    return [f"process {pid} lives" for pid, _ in found]


def census() -> set[Process]:
    """Every living descendant of this process, and every orphan of a submission's user.

    Other graders may run on this machine; their processes have a living parent.
    """
    parents = {}
    for folder in Path("/proc").iterdir():
        if folder.name.isdigit() and (read := _read_process(folder)):
            parents[read[0]] = read[1:]
    mine = set()
    for process, (parent, uid) in parents.items():
        orphaned = parent == 1 and FIRST_UID <= uid < FIRST_UID + SLOTS
        if orphaned or _descends(process[0], {key[0]: up for key, (up, _) in parents.items()}):
            mine.add(process)
    return mine


def _descends(pid: int, parents: dict[int, int]) -> bool:
    while (pid := parents.get(pid, 0)) > 1:
        if pid == os.getpid():
            return True
    return False


def _read_process(folder: Path) -> tuple[Process, int, int] | None:
    """Number and start, parent, user; None for one that is dead or gone."""
    try:
        fields = (folder / "stat").read_text(errors="replace").rpartition(")")[2].split()
        uid = folder.stat().st_uid
    except OSError:
        return None
    if fields[0] in "ZX":
        return None
    return (int(folder.name), fields[19]), int(fields[1]), uid

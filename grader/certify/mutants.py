"""Which mutants are made of which submissions?"""

import difflib
import hashlib
import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from grader import resources
from grader.certify.corpus import corpus_folder, name_of
from grader.certify.edits import edits
from grader.model.stages import SOURCE_PATH

ORIGINALS = (
    "recursive-merge-sort-of-records",
    "std-sort-and-shrinking-ray",
    "queue-and-stack",
    "moeller-trumbore-float",
    "own-slab-test",
    "push-back-fills-gaps",
    "stackless-walk",
)
"""Right submissions that mutants are made of, beside the reference; all are different."""

REFERENCE = f"reference/{SOURCE_PATH}"


@dataclass(frozen=True, slots=True)
class Mutant:
    """A right submission after one small edit."""

    original: str
    """Folder and file of what was edited."""

    kind: str
    line: int
    """The first line that differs, from 1."""

    change: str
    """The lines that differ, before and after."""

    source: bytes
    """The edited file."""

    @property
    def digest(self) -> str:
        """What ties a fate to the mutant."""
        return hashlib.sha256(self.source).hexdigest()[:12]


def originals() -> dict[str, Path]:
    """The files that mutants are made of, by name."""
    named = [corpus_folder() / "right" / f"{stem}.cpp" for stem in ORIGINALS]
    return {REFERENCE: resources.reference_source()} | {name_of(path): path for path in named}


def chosen_mutants(number: int, seed: int, match: str = "") -> list[Mutant]:
    """Draw mutants of the reference and of right submissions, in the order of their files.

    Args:
        number: How many; all there are if there are fewer.
        seed: What they are drawn with.
        match: Only of originals whose name contains this.
    """
    sources = {name: path.read_bytes() for name, path in originals().items() if match in name}
    every = [mutant for name, source in sources.items() for mutant in mutants_of(name, source)]
    generator = random.Random(seed)  # noqa: S311 - a sample, not a secret
    drawn = set(generator.sample(range(len(every)), min(number, len(every))))
    return [every[index] for index in sorted(drawn)]


def mutants_of(name: str, source: bytes) -> Iterator[Mutant]:
    """Make every mutant of a source; none of them equals another one or the source."""
    before = source.decode(errors="replace").splitlines()
    seen = {source}
    for edit in edits(source):
        changed = edit.applied(source)
        if changed not in seen:
            seen.add(changed)
            after = changed.decode(errors="replace").splitlines()
            line, change = _difference(before, after)
            yield Mutant(name, edit.kind, line, change, changed)


def _difference(before: Sequence[str], after: Sequence[str]) -> tuple[int, str]:
    """Tell the first line that differs, and all of them: `old -> new`."""
    blocks = difflib.SequenceMatcher(None, before, after, autojunk=False).get_opcodes()
    parts = [block for block in blocks if block[0] != "equal"]
    first, last = parts[0], parts[-1]
    old, new = before[first[1] : last[2]], after[first[3] : last[4]]
    return first[1] + 1, f"{_joined(old)} -> {_joined(new)}"


def _joined(lines: Sequence[str]) -> str:
    return " ".join(" ".join(lines).split())

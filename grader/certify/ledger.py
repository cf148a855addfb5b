"""Which rows have been graded already, by this very grader?

A ledger is a file of JSON lines that is only appended to, so that a killed run goes on where it
was. A line belongs to one state of everything that a verdict depends on.
"""

import json
from collections.abc import Iterator
from dataclasses import asdict, fields
from pathlib import Path
from typing import Any

from grader import resources
from grader.certify.fates import Studied
from grader.certify.row import Row


class Ledger:
    """The results of one state of the grader."""

    def __init__(self, path: Path, grader: str) -> None:
        """Open a ledger.

        Args:
            path: The file, which may not exist yet.
            grader: What `grader_digest` says.
        """
        self._path = path
        self._grader = grader

    def rows(self) -> Iterator[Row]:
        """Every row that this grader wrote, oldest first."""
        for line in self.entries("row"):
            scores, failed, broken = (
                tuple(line[key]) for key in ("scores", "failed", "broken")
            )
            named = (line["name"], line["digest"], line["seed"])
            yield Row(*named, scores, failed, broken, line["because"])

    def add(self, row: Row) -> None:
        """Append a row."""
        self.enter("row", asdict(row))

    def studied(self) -> Iterator[Studied]:
        """Every mutant whose fate with this grader is known, oldest first."""
        names = [field.name for field in fields(Studied)]
        for line in self.entries("mutant"):
            yield Studied(**{name: line[name] for name in names})

    def add_studied(self, one: Studied) -> None:
        """Append what became of a mutant."""
        self.enter("mutant", asdict(one))

    def entries(self, kind: str) -> Iterator[dict[str, Any]]:
        """Every entry of one kind that this grader wrote, oldest first."""
        if not self._path.exists():
            return
        for text in self._path.read_text().splitlines():
            try:
                line = json.loads(text)
            except ValueError:
                continue  # a run was killed while it wrote this line
            if line["grader"] == self._grader and line["entry"] == kind:
                yield line

    def enter(self, kind: str, told: dict[str, Any]) -> None:
        """Append an entry of some kind."""
        text = json.dumps({"grader": self._grader, "entry": kind, **told})
        with self._path.open("a") as file:
            # The line break first: the last line may have been cut off.
            file.write(f"\n{text}")


def usual_ledger() -> Path:
    """Where results are kept."""
    return resources.private_cache("certify") / "rows.jsonl"

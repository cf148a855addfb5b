"""How is a whole class graded? What decides the points of a submission, beside its bytes."""

import hashlib
import json
from dataclasses import asdict, dataclass
from pathlib import Path

import grader
from grader.build.compiler import find_compiler
from grader.errors import UsageError
from grader.identity import WITHOUT_RESULT, grader_digest
from grader.options import Options
from grader.oracle.scenes import scenes_sha256
from grader.pipeline import isolation_of
from grader.plain import as_name
from grader.selection import select


@dataclass(frozen=True, slots=True)
class Wish:
    """What the caller asked for."""

    seed: int
    rubric: Path | None
    """The instructor's; None for the shipped one."""

    time_limit: float | None
    isolated: bool

    def options(self) -> Options:
        """Word it for the pipeline."""
        return Options(
            self.seed,
            self.rubric,
            (),
            lambda *_: None,
            self.time_limit,
            counterexamples=True,
            isolated=self.isolated,
            views=True,
        )


@dataclass(frozen=True, slots=True)
class Settings:
    """Two submissions with the same bytes and the same of this get the same grade."""

    grader: str
    """Version, a digest of all that a result depends on, and the compiler, which that covers:
    whoever works on the grader, or gets another compiler, gets other results with the same
    version."""

    rubric_sha256: str
    scenes_sha256: str
    seed: int
    isolation: str
    time_limit: float | None

    @property
    def digest(self) -> str:
        """Name all of it in one word."""
        return hashlib.sha256(self.to_text().encode()).hexdigest()

    def to_text(self) -> str:
        """Write it as JSON."""
        return json.dumps(asdict(self), sort_keys=True)

    def changes(self, to: "Settings") -> list[str]:
        """Say what another one has in place of what is here."""
        before, after = asdict(self), asdict(to)
        return [
            f"{name.replace('_', ' ')}: {_short(before[name])} -> {_short(after[name])}"
            for name in before
            if before[name] != after[name]
        ]


def read_settings(text: str) -> Settings:
    """Read what `to_text` wrote.

    Raises:
        UsageError: Another version wrote it.
    """
    try:
        return Settings(**json.loads(text))
    except (TypeError, ValueError) as fault:
        raise UsageError(
            "the store of results was written by another version of the grader; use that one, "
            "or grade into another folder"
        ) from fault


def settled(wish: Wish) -> Settings:
    """Find out what the caller's wish means on this machine.

    Raises:
        UsageError: The rubric is wrong.
        MissingTool: Nothing here isolates a submission.
    """
    options, rubric = wish.options(), select(wish.rubric, ()).rubric
    return Settings(
        f"{grader.__version__} ({grader_digest(WITHOUT_RESULT)}, {find_compiler().title})",
        rubric.sha256,
        scenes_sha256(rubric.scenes),
        wish.seed,
        isolation_of(options).level.value,
        wish.time_limit,
    )


def _short(value: object) -> str:
    text = str(value)
    return text[:12] if len(text) == 64 else as_name(text)

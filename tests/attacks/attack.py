"""What a hostile submission says of itself in its first lines, and whether it came true.

    // attack: what it tries, in one sentence.
    // grade: checks to score, separated by commas; without this line all of the rubric
    // expect: clauses, separated by semicolons; may be repeated

A clause is one of these; anything else is an error:

    a = full, b < full, total <= 3.5, a >= 20     points of a part or of both
    passes CHECK, fails CHECK                     the verdict of a check
    stop KIND, no stop                            how a worker ended, or that all finished
    says "TEXT", hides "TEXT"                     in a report, or in none

Words between two `@` in a submission are places that the harness makes, see `witness.py`.
"""

import operator
import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path

from grader.model.grade import Grade
from grader.model.stages import Stop
from grader.model.verdict import Verdict
from grader.verify import every_check

HERE = Path(__file__).parent / "submissions"
FULL = "full"

_LINE = re.compile(r"// (?P<key>[a-z]+): (?P<value>\S.*)")
_KEYS = ("attack", "grade", "expect")
_POINTS = re.compile(r"(a|b|total) (=|<|<=|>|>=) (full|\d{1,2}(?:\.\d{1,2})?)")
_VERDICT = re.compile(r"(passes|fails) ([a-z.-]+)")
_TEXT = re.compile(r'(says|hides) "([^"]+)"')
_RELATIONS: dict[str, Callable[[float, float], bool]] = {
    "=": operator.eq,
    "<": operator.lt,
    "<=": operator.le,
    ">": operator.gt,
    ">=": operator.ge,
}
_STOPS = {f"stop {stop.value}": stop for stop in Stop if stop is not Stop.FINISHED}
_VERDICTS = {"passes": Verdict.PASS, "fails": Verdict.FAIL}


@dataclass(frozen=True, slots=True)
class Graded:
    """What became of a submission, as far as clauses speak of it."""

    grade: Grade
    stops: frozenset[Stop]
    """How its workers ended."""

    reports: str
    """Everything that a reader could get to see."""


@dataclass(frozen=True, slots=True)
class Points:
    """`a < full`: the points of a part, or of both."""

    part: str
    relation: str
    bound: str
    """A number, or `full` for the most that this run gives."""

    def holds(self, graded: Graded) -> bool:
        """Compare."""
        parts = [one for one in graded.grade.parts if self.part in (one.part, "total")]
        most = sum(one.max_score for one in parts)
        earned = sum(one.score for one in parts)
        bound = most if self.bound == FULL else float(self.bound)
        return most > 0 and _RELATIONS[self.relation](earned, bound)


@dataclass(frozen=True, slots=True)
class Decided:
    """`fails bvh.boxes-are-tight`: the verdict of a check."""

    check: str
    verdict: Verdict

    def holds(self, graded: Graded) -> bool:
        """Compare."""
        return any(
            one.check == self.check and one.verdict is self.verdict
            for one in graded.grade.checks
        )


@dataclass(frozen=True, slots=True)
class Stopped:
    """`stop crashed`: some worker ended so; `no stop`: all finished."""

    stop: Stop | None

    def holds(self, graded: Graded) -> bool:
        """Look for it."""
        if self.stop is None:
            return graded.stops <= {Stop.FINISHED}
        return self.stop in graded.stops


@dataclass(frozen=True, slots=True)
class Told:
    """`says "multiple definition"`: a text in a report, or in none."""

    text: str
    said: bool

    def holds(self, graded: Graded) -> bool:
        """Look for it."""
        return (self.text in graded.reports) is self.said


Clause = Points | Decided | Stopped | Told


@dataclass(frozen=True, slots=True)
class Attack:
    """A hostile submission."""

    path: Path
    purpose: str
    checks: tuple[str, ...]
    """Checks to score; empty for all."""

    clauses: tuple[tuple[str, Clause], ...]
    """As written, and as understood."""

    @property
    def compiles(self) -> bool:
        """It has something to run, so it needs the usual time to compile."""
        never = Decided("build.compiles", Verdict.FAIL)
        return all(clause != never for _, clause in self.clauses)

    def disappointed(self, graded: Graded) -> list[str]:
        """The clauses that did not come true."""
        return [written for written, clause in self.clauses if not clause.holds(graded)]


def every_attack() -> list[Attack]:
    """All hostile submissions."""
    return [read_attack(path) for path in sorted(HERE.glob("*.cpp"))]


def read_attack(path: Path) -> Attack:
    """Read the header of a hostile submission.

    Raises:
        ValueError: With the file's name, what is there and what was expected.
    """
    lines: list[tuple[str, str]] = []
    for row in path.read_text(encoding="utf-8").split("\n"):
        if not row.startswith("//"):
            break
        match = _LINE.fullmatch(row)
        if not match or match["key"] not in _KEYS:
            expected = ", ".join(_KEYS)
            message = f"{path.name}: {row!r}, but a header line is one of // {expected}"
            raise ValueError(message)
        lines.append((match["key"], match["value"]))
    keys = [key for key, _ in lines]
    if keys != sorted(keys, key=_KEYS.index) or keys.count("grade") > 1:
        raise ValueError(f"{path.name}: {keys}, but expected one attack, a grade, then expects")
    if keys.count("attack") != 1 or "expect" not in keys:
        raise ValueError(f"{path.name}: the header lacks its attack or an expect line")
    given = dict(lines)
    expects = [value for key, value in lines if key == "expect"]
    checks = tuple(_known(path, one) for one in given.get("grade", "").split(", ") if one)
    clauses = tuple((each, _clause(path, each)) for each in _split(expects))
    return Attack(path, given["attack"], checks, clauses)


def _split(expects: list[str]) -> Iterator[str]:
    for line in expects:
        yield from line.split("; ")


def _clause(path: Path, written: str) -> Clause:
    if match := _POINTS.fullmatch(written):
        return Points(*match.groups())
    if match := _VERDICT.fullmatch(written):
        return Decided(_known(path, match[2]), _VERDICTS[match[1]])
    if match := _TEXT.fullmatch(written):
        return Told(match[2], match[1] == "says")
    if written == "no stop":
        return Stopped(None)
    if written in _STOPS:
        return Stopped(_STOPS[written])
    message = f"{path.name}: {written!r} is no clause; the head of attack.py lists them"
    raise ValueError(message)


def _known(path: Path, check: str) -> str:
    if check not in {each.id for each in every_check()}:
        raise ValueError(f"{path.name}: there is no check {check!r}")
    return check

"""What is measured, and what a measurement is held to: frozen records without logic."""

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Cost:
    """What one run of something took."""

    cpu: float
    """CPU seconds of all its processes."""

    wall: float
    """Seconds on the clock."""


@dataclass(frozen=True, slots=True)
class Spread:
    """The middle of some numbers, and between what they lie."""

    median: float
    low: float
    high: float
    rounds: int
    """How many numbers there were."""


@dataclass(frozen=True, slots=True)
class Goal:
    """A ratio that shall not be larger, or not smaller, than a bound."""

    number: str
    """As in the list of goals: `6`, or `6b` for the second ratio of one."""

    title: str
    bound: float | None
    """None for a ratio that is only reported."""

    at_most: bool = True


@dataclass(frozen=True, slots=True)
class Reading:
    """One goal and what was measured of it."""

    goal: Goal
    ratio: Spread | None
    """None if it could not be measured here."""

    detail: str
    """The two quantities in seconds or rays, or why there is no ratio."""

    why: str = ""
    """Where the time goes, if that was measured: the reason if the goal is not met."""

    @property
    def is_met(self) -> bool | None:
        """Whether the goal is met; None if there is no bound or no ratio."""
        if self.ratio is None or self.goal.bound is None:
            return None
        if self.goal.at_most:
            return self.ratio.median <= self.goal.bound
        return self.ratio.median >= self.goal.bound


@dataclass(frozen=True, slots=True)
class Size:
    """What a mesh of some size costs."""

    faces: int
    construct: float
    """CPU seconds of the model solution's `construct`."""

    check: float
    """CPU seconds of all checks of the tree."""

    rays: float
    """CPU seconds for `scale.RAYS` rays from all around."""

    together: float
    """Seconds on the clock for a worker for the tree, the checks, and a worker for the rays."""


@dataclass(frozen=True, slots=True)
class Peer:
    """What another ray tracer takes for the same mesh and rays, in one thread."""

    name: str
    construct: float
    """CPU seconds, whatever the scene needs included."""

    camera: float
    """Million camera rays a CPU second."""

    scattered: float
    """Million scattered rays a CPU second."""


@dataclass(frozen=True, slots=True)
class Peak:
    """The largest resident memory of a whole grade, in MiB."""

    what: str
    grader_mib: float
    """Of the grader's own process."""

    child_mib: float
    """Of the largest of all processes that it started."""


@dataclass(frozen=True, slots=True)
class Growth:
    """How a cost grows: `seconds = factor * faces ** exponent`, fitted."""

    what: str
    exponent: float


@dataclass(frozen=True, slots=True)
class Floor:
    """What no grade can do without, spread over all cores, beside a whole grade."""

    least: float
    """Seconds of the same compilers and the same trees and rays, and of nothing else."""

    program: float
    """Seconds of a whole grade, wall."""

    cores: int


@dataclass(frozen=True, slots=True)
class Table:
    """Everything that one run of the bench found."""

    machine: str
    """Processor, cores, load, compiler and Python, for whoever compares two tables."""

    is_quick: bool
    readings: tuple[Reading, ...]
    sizes: tuple[Size, ...]
    growths: tuple[Growth, ...]
    peaks: tuple[Peak, ...]
    peers: tuple[Peer, ...]
    remarks: tuple[str, ...]
    """What is not installed, and what disturbed the run."""

    floor: Floor | None = None

"""Which state of the grader decided what is stored, and was it one and the same all along?"""

from collections import Counter
from collections.abc import Collection, Iterable

from grader.errors import UsageError
from grader.identity import WITHOUT_VERDICT, grader_digest


def require_unchanged(grader: str, without: Collection[str] = WITHOUT_VERDICT) -> None:
    """Refuse to keep what nobody knows which state of the grader decided.

    Args:
        grader: What `grader_digest` said when the run began.
        without: Folders of the package that do not matter.

    Raises:
        UsageError: It says something else now.
    """
    now = grader_digest(without)
    if now != grader:
        raise UsageError(
            f"the grader was edited while it ran (state {grader}, now {now}), so this is not "
            "stored; run it again, what was decided before the edit is kept"
        )


def states_told(states: Iterable[str]) -> str:
    """Word how many of the stored things are of which state; an empty one is unknown."""
    counts = Counter(state or "unknown" for state in states)
    return ", ".join(f"`{state}` {count}" for state, count in sorted(counts.items())) or "none"

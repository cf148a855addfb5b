"""Is the grader still the one that a run began with? Whoever edits it meanwhile mixes two."""

from collections.abc import Collection

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

"""A grader is known by all that decides a verdict, and by nothing else."""

import pytest

from grader.identity import WITHOUT_RESULT, WITHOUT_SIZES, WITHOUT_VERDICT, grader_digest


def test_the_same_grader_has_the_same_digest() -> None:
    """Twice in one process, and 64 bits of it."""
    assert grader_digest() == grader_digest()
    assert len(grader_digest()) == 16


@pytest.mark.parametrize("stage", ["build", "intake", "oracle", "run", "score", "verify"])
def test_every_stage_counts(stage: str) -> None:
    """A verdict depends on each of them: on flags of the compiler, too."""
    assert grader_digest((*WITHOUT_VERDICT, stage)) != grader_digest()


def test_what_is_stored_depends_on_more_than_verdicts() -> None:
    """A result holds counterexamples, likely causes and pictures."""
    assert set(WITHOUT_RESULT) < set(WITHOUT_VERDICT)
    assert len({grader_digest(each) for each in (WITHOUT_RESULT, WITHOUT_SIZES)}) == 2

"""What does Gradescope install? An `autograder.zip` with two scripts at its root.

Source: gradescope/autograder_samples, docs/specs.md: the archive is unpacked into
/autograder/source, setup.sh runs once as root, run_autograder for every submission.
"""

from grader.package.archive import Member
from grader.package.kit import Choices, kit, ours

SECONDS = "480"
"""Gradescope writes a score of 0 when its own limit is over, which is 10 minutes at least."""


def members(choices: Choices) -> tuple[Member, ...]:
    """Collect the archive's files; fails as `kit` does."""
    return (
        ours("gradescope-setup.sh", "setup.sh"),
        ours("gradescope-run.sh", "run_autograder"),
        *kit(choices, "--time-limit", SECONDS),
    )

"""What does GitHub Classroom install? A repository with the grader, and one that students copy.

The grader's repository is an action of the course; its workflow in a student's repository calls
it. Whoever may run that action can also read it, the reference included: docs/instructor.md
says what to do where that matters.
"""

import re

from grader.errors import UsageError
from grader.package.archive import Member, below
from grader.package.exercise import exercise
from grader.package.kit import Choices, kit, ours

REPOSITORY = re.compile(r"[A-Za-z0-9][A-Za-z0-9-]{0,38}/[A-Za-z0-9._-]{1,100}")

PLACEHOLDER = b"OWNER/REPOSITORY"


def members(choices: Choices, repository: str | None) -> tuple[Member, ...]:
    """Collect the archive's files; fails as `kit` does.

    Args:
        choices: The course's.
        repository: Where the grader will lie, as OWNER/NAME.

    Raises:
        UsageError: The repository is missing, or no name of one.
    """
    if repository is None or not REPOSITORY.fullmatch(repository):
        raise UsageError(
            f"--repository {repository or 'is missing'}: the assignment has to say where the "
            "grader lies; name your repository as OWNER/NAME"
        )
    workflow = ours("github-workflow.yml", ".github/workflows/autograding.yml")
    named = workflow.data.replace(PLACEHOLDER, repository.encode())
    action = (ours("github-action.yml", "action.yml"), *kit(choices))
    assignment = (Member(workflow.name, named), *exercise())
    return (*below("grader-repository", action), *below("assignment-repository", assignment))

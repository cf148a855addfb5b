"""What `bvhgrade certify --counterexamples` does: how small are the inputs that fail checks?"""

from pathlib import Path
from typing import TYPE_CHECKING, Any

import click

from grader.errors import UsageError
from grader.output import ready

if TYPE_CHECKING:
    from collections.abc import Sequence

    from grader.certify.smallest import Smallest


def search(
    match: str,
    jobs: int,
    into: Path | None,
    **_: Any,  # noqa: ANN401 - the other options
) -> bool:
    """Search wrong submissions, store the sizes; True if one could not be graded.

    Raises:
        UsageError: No wrong submission has such a name, or the inputs cannot be kept.
    """
    from grader.certify.corpus import every_submission, name_of, wrong_submissions
    from grader.certify.ledger import Ledger, usual_ledger
    from grader.certify.smallest import searched, store_smallest
    from grader.certify.state import require_unchanged
    from grader.identity import WITHOUT_SIZES, grader_digest

    paths = [one.path for one in wrong_submissions() if match in name_of(one.path)]
    if not paths:
        raise UsageError(f"--match {match}: no wrong submission has such a name")
    if into:
        ready(into, remedy="name another folder with --into")
    undecided, grader = [], grader_digest(WITHOUT_SIZES)

    def tell(name: str, found: "Sequence[Smallest] | None") -> None:
        require_unchanged(grader, WITHOUT_SIZES)
        if found is None:
            undecided.append(name)
        click.echo(f"{name}: {worded(found)}")

    sizes = searched(paths, jobs, Ledger(usual_ledger(), grader), tell, into)
    require_unchanged(grader, WITHOUT_SIZES)
    store_smallest(sizes, every_submission(), grader)
    return bool(undecided)


def worded(found: "Sequence[Smallest] | None") -> str:
    """Word what was found of one submission."""
    if found is None:
        return "undecided: our own fault, or a machine that is too busy"
    return ", ".join(
        f"{one.check} {one.faces} faces {one.rays} rays"
        if one.faces is not None
        else f"{one.check} none"
        for one in found
    )

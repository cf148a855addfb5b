"""What `bvhgrade certify --mutants` does: are small edits of right submissions caught?"""

from typing import TYPE_CHECKING, Any

import click

from grader.errors import UsageError

if TYPE_CHECKING:
    from collections.abc import Sequence

    from grader.certify.fates import Studied


def study(match: str, mutants: int, seed: int, jobs: int, **_: Any) -> bool:  # noqa: ANN401 - the other options
    """Study mutants, store and tell what became of them; True if one survived unexplained.

    Raises:
        UsageError: No submission that mutants are made of has such a name.
    """
    from grader.certify.fates import counts_of, store_counts
    from grader.certify.ledger import Ledger, usual_ledger
    from grader.certify.matrix import SEED
    from grader.certify.mutants import chosen_mutants
    from grader.certify.run import MutantWork, studied_mutants
    from grader.certify.state import require_unchanged
    from grader.identity import grader_digest

    chosen = chosen_mutants(mutants, seed, match)
    if not chosen:
        raise UsageError(f"--match {match}: mutants are made of no such submission")
    grader = grader_digest()

    def kept(one: "Studied") -> None:
        require_unchanged(grader)
        tell(one)

    ledger = Ledger(usual_ledger(), grader)
    found = studied_mutants(MutantWork(chosen, SEED, jobs), ledger, kept)
    require_unchanged(grader)
    store_counts(counts_of(found), seed, grader)
    return tell_all(found, len(chosen))


def tell(one: "Studied") -> None:
    """Show one mutant as it comes in."""
    click.echo(f"{one.fate:<12} {one.original}:{one.line} {one.kind}: {one.change}  {one.by}")


def tell_all(found: "Sequence[Studied]", wanted: int) -> bool:
    """Tell the counts, the share and the survivors; True if there is an unexplained one."""
    from grader.certify.fates import Fate, counts_of, share_caught, survivors

    counts = counts_of(found)
    for original, line in sorted(counts.items()):
        told = ", ".join(f"{count} {fate}" for fate, count in line.items() if count)
        click.echo(f"{original}: {told}")
    click.echo(f"\n{len(found)} of {wanted} mutants studied")
    share = f"{100 * share_caught(counts.values()):.1f} %"
    click.echo(f"{share} of all other programs without explanation are caught")
    left = survivors(found)
    click.echo(f"\n{len(left)} survivors without an explanation")
    for one in left:
        tell(one)
    return any(one.fate == Fate.SURVIVED.value for one in left) or len(found) < wanted

"""How does docs/certificate.md tell what the grader is known to see?"""

from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from pathlib import Path

from grader.certify.corpus import Wrong, checkout, name_of
from grader.certify.fates import FATES, Counts, share_caught, stored_counts, stored_mutants
from grader.certify.holes import Kind, full_marks, holes, without_killer
from grader.certify.matrix import stored_states
from grader.certify.row import Row
from grader.certify.seeds import stored_tried, tried_lines
from grader.certify.smallest import failing_pairs, smallest_lines, stored_smallest
from grader.certify.state import states_told
from grader.score.rubric import load_rubric

BEGIN = """\
# What the grader is known to see

Written by `bvhgrade certify` from the stored kill matrix (`tests/submissions/kill-matrix.csv`,
one seed); a test compares it. `bvhgrade certify --stored` writes it anew without grading.
A state of the grader is a digest of all that a verdict depends on; `unknown` are rows that
were stored before states were.
"""

KILLERS = """
## Mistakes by check

*Fails*: wrong submissions that fail the check. *Owns*: those whose mistake is the check's own.
*Alone*: those that no other check sees.

| check | fails | owns | alone | for example |
|---|---:|---:|---:|---|
"""

MUTANTS = """
## Generated mutants

Small edits of right submissions (`bvhgrade certify --mutants N`): operators, constants, names,
conditions, order, dropped statements, exchanged arguments.

- *Invalid*: it does not compile.
- *Same code*: the compiler makes the original's machine code of it.
- *Caught*: it loses points.
- *Same results*: it keeps all points, and returns what the original returns, bit by bit and
  count by count, in every trial of a seed that did not grade it.
- *Survived*: it keeps all points and returns something else.
- *Explained*: would be one of the last two, and is counted here instead, since it is right;
  `tests/submissions/equivalents.toml` says why.

"""

SEEDS = """
## More seeds

What meshes and rays are drawn from must not matter. Stored by `bvhgrade certify --seeds N`.

"""

SMALLEST = """
## Smallest counterexamples

For each failed check the grader looks for a small input that fails it, too. Stored by
`bvhgrade certify --counterexamples`. A state is here also one of what looks for them.

- *Failed*: wrong submissions that fail the check, as far as they were searched.
- *Found*: those with a small input.
- *Faces*, *rays*: the median of those inputs; both meshes count where there are two.

"""


@dataclass(frozen=True, slots=True)
class _Kills:
    """What one check sees."""

    check: str
    fails: Sequence[Row]
    owns: Sequence[Row]
    alone: Sequence[Row]

    def line(self) -> str:
        """Word it as a line of the table."""
        best = next(iter((*self.alone, *self.owns, *self.fails)), None)
        example = f"`{best.name}`" if best else "none"
        counts = " | ".join(str(len(each)) for each in (self.fails, self.owns, self.alone))
        return f"| `{self.check}` | {counts} | {example} |\n"


def certificate_file() -> Path:
    """Where the certificate lies."""
    return checkout() / "docs" / "certificate.md"


def certificate(rows: Sequence[Row], wrong: Sequence[Wrong]) -> str:
    """Word what the rows of the stored matrix say."""
    corpus = _summary(rows, wrong) + KILLERS + "".join(kill_lines(rows, wrong))
    seeds = SEEDS + "".join(tried_lines(stored_tried()))
    killed = (row for row in rows if not row.name.startswith("right/"))
    sizes = smallest_lines(stored_smallest(), failing_pairs(killed))
    smallest = SMALLEST + "".join(sizes)
    states = states_told(stored_mutants().elements())
    mutants = MUTANTS + f"By state of the grader: {states}.\n\n"
    mutants += "".join(mutant_lines(stored_counts()))
    return BEGIN + corpus + seeds + smallest + mutants


def kill_lines(rows: Iterable[Row], wrong: Iterable[Wrong]) -> list[str]:
    """Word one line of the table for each check of the rubric."""
    owners = {name_of(one.path): one.checks[0] for one in wrong}
    killed = [row for row in rows if row.name in owners]
    return [
        _Kills(
            check,
            [row for row in killed if check in row.failed],
            [row for row in killed if owners[row.name] == check],
            [row for row in killed if row.failed == (check,)],
        ).line()
        for check in (one.check for one in load_rubric(None).criteria)
    ]


def mutant_lines(counts: dict[str, Counts]) -> list[str]:
    """Word the table of the mutants, and the share that is caught."""
    total = {fate: sum(line[fate] for line in counts.values()) for fate in FATES}
    lines = [f"| original | {' | '.join(FATES)} |\n", "|---" + "|---:" * len(FATES) + "|\n"]
    for name, line in (*sorted(counts.items()), ("all", total)):
        lines.append(f"| {name} | {' | '.join(str(line[fate]) for fate in FATES)} |\n")
    share = f"{100 * share_caught([total]):.1f} %"
    return [*lines, f"\nCaught: {share} of all other programs without explanation.\n"]


def _summary(rows: Sequence[Row], wrong: Sequence[Wrong]) -> str:
    found = holes(rows, wrong) + without_killer(rows, wrong)
    # The matrix has one row of each file: no two runs can differ.
    shown = [kind for kind in Kind if kind is not Kind.UNSTEADY]
    counts = {kind: sum(hole.kind is kind for hole in found) for kind in shown}
    right = sum(row.name.startswith("right/") for row in rows)
    full = sum(full_marks().values())
    lines = [f"| {kind.value} | {count} |\n" for kind, count in counts.items()]
    states = states_told(stored_states().elements())
    return (
        f"\n{right} right files have to earn {full:g} points, {len(wrong)} wrong ones less.\n"
        f"Graded by state of the grader: {states}.\n"
        f"\n| what could be wrong | found |\n|---|---:|\n{''.join(lines)}"
    )

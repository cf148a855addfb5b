"""How does the table become `docs/performance.md`, with its chart beside it?"""

from collections.abc import Iterator, Sequence
from pathlib import Path

from grader.bench.chart import chart_of
from grader.bench.drawing import png_of, svg_of
from grader.bench.floor import PROFILED, floor_of
from grader.bench.reasons import FOUND, REASONS
from grader.bench.record import Reading, Table
from grader.bench.scale import RAYS
from grader.bench.shown import STATES, bound_of, ratio_of
from grader.output import write_bytes_whole, write_whole

NAME = "performance"
REMEDY = "name another folder with --write"

_HEAD = """# How fast the grader is

`bvhgrade bench --write docs` measured and wrote this. A goal is a ratio of two things that
took turns in one run, with the smallest and the largest of its rounds; 9 and 9b are seconds.
But 5b is measured after what it is compared with, and for 8 and 8b a small and then a large
class are graded, once each, of files that do not compile: only what a class costs besides is
timed, and what a class of two takes is taken off, since each process has begun then. In 3 and
3b ours is `bvhgrade check --only build.compiles`, as pytest and check50 do no more there.

What is measured is the median of the rounds' ratios; "of" holds the median of each side, and
the ratio of two medians is a little another one.

CPU seconds are those of all processes; only in 1b and 1d the grade's workers count with their
time on the clock, which is a little more, since the kernel forgets what a killed process
used. Another machine has other seconds and about the same ratios.
"""


def write(folder: Path, table: Table) -> tuple[Path, ...]:
    """Write the text and the chart, as SVG and as PNG, and return their paths.

    Raises:
        OutputFault: One of them cannot be written.
    """
    drawing = chart_of(table)
    text, svg, png = (folder / f"{NAME}.{ending}" for ending in ("md", "svg", "png"))
    write_whole(text, markdown_of(table))
    write_whole(svg, svg_of(drawing))
    write_bytes_whole(png, png_of(drawing), REMEDY)
    return text, svg, png


def markdown_of(table: Table) -> str:
    """Return the table as a page of documentation."""
    parts = [
        _HEAD,
        f"{table.machine}.\n",
        *_goals(table),
        *_costs(table),
        *_peers(table),
        *([floor_of(table.floor)] if table.floor else []),
        PROFILED,
    ]
    if table.is_quick:
        parts.insert(
            1, "**A quick run**: few rounds on a small mesh; it shows that all works.\n"
        )
    return "\n".join(parts)


def _goals(table: Table) -> Iterator[str]:
    yield "## Goals\n"
    yield "| | ratio | goal | measured | | of |\n|---|---|---|---|---|---|"
    for reading in table.readings:
        goal = reading.goal
        cells = [goal.number, goal.title, bound_of(reading), ratio_of(reading.ratio)]
        cells += [STATES[reading.is_met], reading.detail]
        yield f"| {' | '.join(cells)} |"
    yield f"\n![Ratios and costs by size]({NAME}.svg)\n"
    missed = [each for each in table.readings if each.is_met is False]
    if missed:
        yield f"What is not met, and why: measured in this run, or found by hand on {FOUND}.\n"
        yield from _reasons(missed)
        yield ""


def _reasons(missed: Sequence[Reading]) -> Iterator[str]:
    """Tell each reason once, with the goals that it is the reason for."""
    numbers: dict[str, list[str]] = {}
    for reading in missed:
        found = REASONS.get(reading.goal.number, "no reason is known yet.")
        reason = reading.why or found
        numbers.setdefault(reason, []).append(reading.goal.number)
    for reason, of in numbers.items():
        yield f"- **{', '.join(of)}**: {reason}"


def _costs(table: Table) -> Iterator[str]:
    if not table.sizes:
        return
    yield "## Cost by number of faces\n"
    yield (
        "The clear solution on a generated landscape: CPU seconds of one `construct`, of all\n"
        f"checks of its tree, and of {RAYS:,} scattered rays; *together* is the time on\n"
        "the clock of a worker for the tree, the checks, and a worker for the rays.\n"
    )
    yield "| faces | construct | check | rays | together |\n|---:|---:|---:|---:|---:|"
    for size in table.sizes:
        costs = (size.construct, size.check, size.rays, size.together)
        yield f"| {size.faces:,} | " + " | ".join(f"{cost:.3f} s" for cost in costs) + " |"
    if table.growths:
        grown = ", ".join(f"{each.what} {each.exponent:.2f}" for each in table.growths)
        yield f"\nFitted exponents (cost = factor x faces^exponent): {grown}."
    for peak in table.peaks:
        yield (
            f"\nLargest resident memory of a {peak.what}: {peak.grader_mib:,.0f} MiB in the "
            f"grader, {peak.child_mib:,.0f} MiB in the largest process that it starts."
        )
    yield ""


def _peers(table: Table) -> Iterator[str]:
    if table.peers:
        yield "## Other ray tracers in Python\n"
        yield "| | scene, CPU | camera, Mray/s | scattered, Mray/s |\n|---|---:|---:|---:|"
        for peer in table.peers:
            speeds = f"{peer.camera:.3g} | {peer.scattered:.3g}"
            yield f"| {peer.name} | {peer.construct:.2f} s | {speeds} |"
        yield ""
    if table.remarks:
        yield "Not compared: " + "; ".join(table.remarks) + ".\n"

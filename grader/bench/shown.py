"""How is the table told: as text for a terminal, and as Markdown for the documentation?"""

from grader.bench.record import Peer, Reading, Size, Spread, Table

STATES = {True: "met", False: "not met", None: "-"}


def lines_of(table: Table) -> list[str]:
    """Return the table as lines for a terminal."""
    rows = [_cells(reading) for reading in table.readings]
    widths = [max((len(row[column]) for row in rows), default=0) for column in range(5)]
    shown = [table.machine, ""]
    for row in rows:
        number, title, goal, ratio, state = (
            cell.ljust(width) for cell, width in zip(row[:5], widths, strict=True)
        )
        shown.append(f"{number}  {title}  {goal}  {ratio}  {state}  {row[5]}".rstrip())
    if table.sizes:
        shown += ["", "    faces  construct     check      rays  together"]
        shown += [_size_line(size) for size in table.sizes]
    if table.growths:
        grown = (f"{each.what} {each.exponent:.2f}" for each in table.growths)
        shown.append(f"exponents: {', '.join(grown)}")
    shown += [
        f"{peak.what}: {peak.grader_mib:,.0f} MiB, its largest child {peak.child_mib:,.0f} MiB"
        for peak in table.peaks
    ]
    shown += [_peer_line(peer) for peer in table.peers]
    return [*shown, *table.remarks]


def bound_of(reading: Reading) -> str:
    """Word what a ratio is held to."""
    if reading.goal.bound is None:
        return ""
    return f"{'<=' if reading.goal.at_most else '>='} {reading.goal.bound:.2f}"


def ratio_of(ratio: Spread | None) -> str:
    """Word a ratio with its spread."""
    if ratio is None:
        return "not measured"
    if ratio.rounds == 1:
        return f"{ratio.median:.2f}"
    return f"{ratio.median:.2f} ({ratio.low:.2f} to {ratio.high:.2f})"


def _cells(reading: Reading) -> tuple[str, str, str, str, str, str]:
    goal = reading.goal
    state = STATES[reading.is_met]
    measured = ratio_of(reading.ratio)
    return goal.number, goal.title, bound_of(reading), measured, state, reading.detail


def _size_line(size: Size) -> str:
    costs = (size.construct, size.check, size.rays, size.together)
    return f"{size.faces:>9,}  " + "  ".join(f"{cost:>6.3f} s" for cost in costs)


def _peer_line(peer: Peer) -> str:
    speeds = f"{peer.camera:.3g} and {peer.scattered:.3g} million rays a second"
    return f"{peer.name}: {peer.construct:.2f} s, {speeds}"

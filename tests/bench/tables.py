"""A table that was made by hand, for the tests of what shows it."""

from grader.bench import goals
from grader.bench.record import Floor, Growth, Peak, Peer, Reading, Size, Spread, Table

READINGS = (
    Reading(goals.WALL, Spread(1.2, 1.1, 1.3, 5), "6.0 s / 5.0 s"),
    Reading(goals.PYTEST, Spread(0.9, 0.8, 1.0, 5), "0.9 s / 1.0 s", "of 0.9 s all is Python."),
    Reading(goals.CHECK, Spread(0.1, 0.09, 0.11, 5), "0.04 s / 0.40 s CPU"),
    Reading(goals.FAST_CAMERA, Spread(0.5, 0.5, 0.5, 1), "3.00 / 6.00 million rays a second"),
    Reading(goals.CHECK50, None, "check50 is not installed"),
)
TABLE = Table(
    machine="a processor, g++ 12.2.0, Python 3.11",
    is_quick=False,
    readings=READINGS,
    sizes=(
        Size(1_000, 0.0002, 0.001, 0.01, 0.1),
        Size(64_000, 0.02, 0.01, 0.02, 0.2),
        Size(4_000_000, 1.5, 0.4, 0.06, 5.0),
    ),
    growths=(Growth("construct", 1.05), Growth("check", 0.9)),
    peaks=(Peak("grade with 4,194,312 faces", 900.0, 700.0),),
    peers=(Peer("a & b", 1.0, 5.0, 1.5),),
    remarks=("check50 is not installed",),
    floor=Floor(2.5, 6.0, 2),
)

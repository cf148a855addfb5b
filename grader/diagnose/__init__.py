"""Which misconceptions are looked for? The order decides only between equally good ones."""

from grader.diagnose import (
    axes,
    boxes,
    endings,
    keeps,
    limits,
    middles,
    nodes,
    orders,
    pruning,
    ranges,
    records,
    slabs,
    states,
    triangles,
    walks,
)
from grader.diagnose.hypothesis import Hypothesis


def every_hypothesis() -> tuple[Hypothesis, ...]:
    """Collect the hypotheses of all topics."""
    return (
        *axes.AXES,
        *middles.MIDDLES,
        *orders.ORDERS,
        *boxes.BOXES,
        *nodes.NODES,
        *ranges.RANGES,
        *walks.WALKS,
        *keeps.KEEPS,
        *limits.LIMITS,
        *slabs.SLABS,
        *triangles.TRIANGLES,
        *records.RECORDS,
        *pruning.PRUNING,
        *states.STATES,
        *endings.ENDINGS,
    )

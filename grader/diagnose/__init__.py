"""Which misconceptions are looked for? The order decides only between equally good ones."""

from grader.diagnose import axes, boxes, keeps, middles, nodes, orders, ranges, walks
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
    )

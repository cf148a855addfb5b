"""Which checks there are; their order here is the order of every report."""

from grader.verify import (
    bounds,
    endings,
    hits,
    images,
    rebuild,
    source,
    split,
    structure,
    work,
)
from grader.verify.check import Check

TOPICS = (source, structure, split, bounds, rebuild, work, hits, endings, images)


def every_check() -> tuple[Check, ...]:
    """Collect the checks of all topics, topic by topic, in file order."""
    return tuple(
        item for topic in TOPICS for item in vars(topic).values() if isinstance(item, Check)
    )

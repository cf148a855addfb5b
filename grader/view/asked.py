"""How are the values of a page's question read? Strictly: anybody's page may send one."""

from collections.abc import Mapping
from typing import Any

from grader.errors import UsageError
from grader.view.desk import Mode

FARTHEST = 1e4
"""Of what a page's camera looks at, in halves of the model."""


class Unanswered(Exception):
    """A question that failed for our own reason; the message is for the page."""


def mode(name: object) -> Mode:
    """Find what the right pane may show.

    Raises:
        UsageError: It is nothing of that.
    """
    for mode in Mode:
        if mode.value == name:
            return mode
    raise UsageError("there is no such picture")


def number(given: Mapping[str, Any], name: str, most: float) -> float:
    """Read a number.

    Args:
        given: The question.
        name: Of the number.
        most: Its size at most.

    Raises:
        UsageError: It is none, or too large.
    """
    value = given.get(name)
    if isinstance(value, bool) or not isinstance(value, int | float) or not abs(value) <= most:
        raise UsageError(f"{name} must be a number")
    return float(value)


def numbers(given: Mapping[str, Any], name: str, count: int) -> list[float]:
    """Read so many numbers.

    Raises:
        UsageError: There are more or fewer, or one is none, or too large.
    """
    values = given.get(name)
    if not isinstance(values, list) or len(values) != count:
        raise UsageError(f"{name} must be {count} numbers")
    return [number({name: value}, name, FARTHEST) for value in values]

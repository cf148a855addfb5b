"""How are students told apart who have the same name? By what the platform or we call them."""

from collections import Counter
from collections.abc import Sequence


def named(name: str, id: str) -> str:
    """Name a student with the id that the platform gave; there may be none but the name."""
    return f"{name} ({id})" if id and id != name else name


def told_apart(people: Sequence[tuple[str, str, str]]) -> list[str]:
    """Name the students of a class, each in its own way.

    Args:
        people: For each the name, the id, and the folder, which no two have in common.
    """
    usual = [named(name, id) for name, id, _ in people]
    times = Counter(usual)
    return [
        told if times[told] == 1 else named(name, folder)
        for told, (name, _, folder) in zip(usual, people, strict=True)
    ]

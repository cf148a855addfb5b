"""How a value is taken out of a TOML table, or refused with where, what and what instead."""

import difflib
import tomllib
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from grader.errors import UsageError

LARGEST_FILE = 1 << 20


def read_table(path: Path, what: str) -> tuple["Table", bytes]:
    """Read a TOML file; returns its root and its bytes.

    Args:
        path: The file.
        what: What it should be, for messages: `a rubric`.

    Raises:
        UsageError: It cannot be read, or is no such file.
    """
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST_FILE + 1)
        if len(content) > LARGEST_FILE:
            raise UsageError(f"{path}: more than 1 MiB, but {what} is a short TOML file")
        return Table(str(path), tomllib.loads(content.decode("utf-8"))), content
    except OSError as fault:
        raise UsageError(f"{path}: {fault.strerror}, but {what} is expected there") from fault
    except (UnicodeDecodeError, RecursionError) as fault:
        raise UsageError(f"{path}: not a text in UTF-8, but {what} is TOML") from fault
    except ValueError as fault:
        raise UsageError(f"{path}: not valid TOML: {fault}") from fault


class Table:
    """A TOML table that knows where it stands."""

    def __init__(self, where: str, values: dict[str, Any]) -> None:
        self._where = where
        self._values = values

    def fault(self, key: str, found: str, expected: str) -> UsageError:
        """Word what is wrong with a key."""
        return UsageError(f"{self._where}: {key} is {found}, but expected is {expected}")

    def only(self, *known: str) -> None:
        """Refuse keys that nobody reads.

        Raises:
            UsageError: There is such a key.
        """
        for key in self._values:
            if key not in known:
                raise UsageError(
                    f"{self._where}: unknown key `{key}`, but expected are {', '.join(known)}"
                    + _nearest(key, known)
                )

    def table(self, key: str) -> "Table":
        """A table that must be there.

        Raises:
            UsageError: It is missing, or no table.
        """
        value = self._taken(key, dict, f"a table [{key}]")
        return Table(f"{self._where}: [{key}]", value)

    def has(self, key: str) -> bool:
        """Whether a key is there."""
        return key in self._values

    def tables(self, key: str) -> list["Table"]:
        """An array of tables; each knows its number, and its check or name if it has one.

        Raises:
            UsageError: It is missing, or no array of tables.
        """
        values = self._taken(key, list, f"tables [[{key}]]")
        made: list[Table] = []
        for number, value in enumerate(values, start=1):
            if not isinstance(value, dict):
                raise self.fault(key, _shown(value), f"tables [[{key}]]")
            name = value.get("check", value.get("name"))
            called = f" ({_short(name)})" if isinstance(name, str) else ""
            made.append(Table(f"{self._where}: [[{key}]] number {number}{called}", value))
        return made

    def text(self, key: str) -> str:
        """A string that is not empty.

        Raises:
            UsageError: It is missing, empty, or no string.
        """
        value: str = self._taken(key, str, "a text")
        if not value.strip():
            raise self.fault(key, "empty", "a text")
        return value

    def choice(self, key: str, known: Iterable[str], absent: str | None = None) -> str:
        """One of the known words; a wrong one is told the nearest.

        Raises:
            UsageError: It is another one, or missing and `absent` is None.
        """
        if absent is not None and key not in self._values:
            return absent
        known = tuple(known)
        value: str = self._taken(key, str, "a text")
        if value not in known:
            few = (
                " or ".join(f'"{word}"' for word in known)
                if len(known) <= 4
                else "a known name"
            )
            raise self.fault(key, f'"{value}"', few + _nearest(value, known))
        return value

    def flag(self, key: str, *, absent: bool) -> bool:
        """True or false.

        Raises:
            UsageError: It is neither.
        """
        if key not in self._values:
            return absent
        value: bool = self._taken(key, bool, "true or false")
        return value

    def number(self, key: str, least: float, most: float) -> float:
        """A finite number in a range.

        Raises:
            UsageError: It is missing, no number, or out of range.
        """
        expected = f"a number from {least:g} to {most:g}"
        value = self._taken(key, (int, float), expected)
        if isinstance(value, bool) or not least <= value <= most:
            raise self.fault(key, _shown(value), expected)
        return float(value)

    def numbers(self, key: str, count: int, least: float, most: float) -> tuple[float, ...]:
        """A list of so many finite numbers in a range.

        Raises:
            UsageError: It is missing, another one, or a number is out of range.
        """
        expected = f"{count} numbers from {least:g} to {most:g}"
        values = self._taken(key, list, expected)
        right = len(values) == count and all(
            isinstance(one, int | float) and not isinstance(one, bool) and least <= one <= most
            for one in values
        )
        if not right:
            raise self.fault(key, _shown(values), expected)
        return tuple(float(one) for one in values)

    def whole(self, key: str, least: int, most: int) -> int:
        """A whole number in a range.

        Raises:
            UsageError: It is missing, no whole number, or out of range.
        """
        expected = f"a whole number from {least} to {most}"
        value = self._taken(key, int, expected)
        if isinstance(value, bool) or not least <= value <= most:
            raise self.fault(key, _shown(value), expected)
        return int(value)

    def _taken(self, key: str, kind: type | tuple[type, ...], expected: str) -> Any:  # noqa: ANN401 - whatever TOML holds
        if key not in self._values:
            raise self.fault(key, "missing", expected)
        value = self._values[key]
        if not isinstance(value, kind):
            raise self.fault(key, _shown(value), expected)
        return value


def _shown(value: object) -> str:
    return _short(f'"{value}"' if isinstance(value, str) else str(value))


def _short(text: str) -> str:
    return text if len(text) <= 60 else text[:59] + "…"


def _nearest(word: str, known: Iterable[str]) -> str:
    close = difflib.get_close_matches(word, list(known), n=1, cutoff=0.5)
    return f'; did you mean "{close[0]}"?' if close else ""

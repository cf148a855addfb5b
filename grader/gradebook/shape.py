"""Has a value the shape that `result.schema.json` demands? In the words of whoever reads it.

This reads those keywords of JSON Schema that the schema uses, and refuses any other, so that a
word added there cannot be passed over here. A whole number written as `1.0` is no integer.
"""

import math
import re
from collections.abc import Callable, Iterator, Mapping
from typing import Any

from grader.report.as_json import Json

TYPES: Mapping[str, tuple[type, ...]] = {
    "object": (dict,),
    "array": (list,),
    "string": (str,),
    "number": (int, float),
    "integer": (int,),
    "boolean": (bool,),
    "null": (type(None),),
}

ONLY_WORDS = {"$schema", "$comment", "$defs", "title", "description"}
"""Keywords that demand nothing."""

LONGEST_QUOTE = 40


def fault_in(value: object, schema: Json) -> str:
    """Say where a value first differs from a schema and how; empty if it does not."""
    return next(_faults(value, schema, schema, ""), "")


def _faults(value: object, schema: Json, root: Json, place: str) -> Iterator[str]:
    """Say everything that one part of a schema has against one part of a value."""
    for keyword, demand in schema.items():
        if keyword not in ONLY_WORDS:
            said = KEYWORDS[keyword](value, demand, root, place)
            yield from said
            if keyword == "properties" and isinstance(value, dict):
                yield from _unknown(value, schema, root, place)


def _type(value: object, demand: Any, _: Json, place: str) -> Iterator[str]:  # noqa: ANN401 - JSON
    wanted = [demand] if isinstance(demand, str) else demand
    fits = any(_is(value, name) for name in wanted)
    if not fits:
        names = " or ".join(wanted)
        yield f"{place or 'the whole'} is {_quoted(value)}, but {names} is expected"


def _is(value: object, name: str) -> bool:
    """Tell a type as JSON has it: true is no number, and neither is infinity."""
    if isinstance(value, bool):
        return name == "boolean"
    if isinstance(value, float) and not math.isfinite(value):
        return False
    return isinstance(value, TYPES[name])


def _reference(value: object, demand: Any, root: Json, place: str) -> Iterator[str]:  # noqa: ANN401 - JSON
    part = root
    for name in demand.removeprefix("#/").split("/"):
        part = part[name]
    yield from _faults(value, part, root, place)


def _const(value: object, demand: Any, _: Json, place: str) -> Iterator[str]:  # noqa: ANN401 - JSON
    if type(value) is not type(demand) or value != demand:
        yield f"{place} is {_quoted(value)}, but {_quoted(demand)} is expected"


def _enum(value: object, demand: Any, _: Json, place: str) -> Iterator[str]:  # noqa: ANN401 - JSON
    if value not in demand:
        yield f"{place} is {_quoted(value)}, but one of {', '.join(demand)} is expected"


def _one_of(value: object, demand: Any, root: Json, place: str) -> Iterator[str]:  # noqa: ANN401 - JSON
    said = [next(_faults(value, one, root, place), "") for one in demand]
    if said.count("") != 1:
        yield said[-1] or f"{place} has two meanings"


def _required(value: object, demand: Any, _: Json, place: str) -> Iterator[str]:  # noqa: ANN401 - JSON
    if isinstance(value, dict):
        for name in demand:
            if name not in value:
                yield f"{_inside(place, name)} is missing"


def _properties(value: object, demand: Any, root: Json, place: str) -> Iterator[str]:  # noqa: ANN401 - JSON
    if isinstance(value, dict):
        for name, schema in demand.items():
            if name in value:
                yield from _faults(value[name], schema, root, _inside(place, name))


def _unknown(value: Json, schema: Json, root: Json, place: str) -> Iterator[str]:
    """Say what is there beyond the known properties."""
    for name in value.keys() - schema["properties"].keys():
        yield f"{_inside(place, name[:LONGEST_QUOTE])} is there, but nothing is expected"


def _additional(value: object, demand: Any, root: Json, place: str) -> Iterator[str]:  # noqa: ANN401 - JSON
    if isinstance(demand, dict) and isinstance(value, dict):
        for name, entry in value.items():
            yield from _faults(entry, demand, root, _inside(place, name[:LONGEST_QUOTE]))


def _items(value: object, demand: Any, root: Json, place: str) -> Iterator[str]:  # noqa: ANN401 - JSON
    if isinstance(value, list):
        for number, entry in enumerate(value):
            yield from _faults(entry, demand, root, f"{place}[{number}]")


def _most_items(value: object, demand: Any, _: Json, place: str) -> Iterator[str]:  # noqa: ANN401 - JSON
    if isinstance(value, list) and len(value) > demand:
        yield f"{place} holds {len(value)} entries, but at most {demand} are expected"


def _minimum(value: object, demand: Any, _: Json, place: str) -> Iterator[str]:  # noqa: ANN401 - JSON
    if isinstance(value, int | float) and value < demand:
        yield f"{place} is {_quoted(value)}, but at least {demand} is expected"


def _pattern(value: object, demand: Any, _: Json, place: str) -> Iterator[str]:  # noqa: ANN401 - JSON
    if isinstance(value, str) and not re.search(demand.replace("$", r"\Z"), value):
        yield f"{place} is {_quoted(value)}, but it does not look like one"


def _inside(place: str, name: str) -> str:
    return f"{place}.{name}" if place else name


def _quoted(value: object) -> str:
    """Quote a value shortly."""
    if isinstance(value, dict | list):
        return "an object" if isinstance(value, dict) else "a list"
    text = repr(value)
    return text if len(text) <= LONGEST_QUOTE else f"{text[:LONGEST_QUOTE]}..."


Rule = Callable[[object, Any, Json, str], Iterator[str]]

KEYWORDS: Mapping[str, Rule] = {
    "type": _type,
    "$ref": _reference,
    "const": _const,
    "enum": _enum,
    "oneOf": _one_of,
    "required": _required,
    "properties": _properties,
    "additionalProperties": _additional,
    "items": _items,
    "maxItems": _most_items,
    "minimum": _minimum,
    "pattern": _pattern,
}

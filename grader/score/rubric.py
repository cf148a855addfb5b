"""Which rubric applies, and is every line of it one that we understand?

Strict on purpose: a misspelt key that is silently ignored would move points of a whole class.
"""

import hashlib
from collections.abc import Iterable
from dataclasses import fields
from pathlib import Path

from grader.model.grade import (
    VISIBILITIES,
    CompileLimits,
    Criterion,
    Limits,
    Rubric,
)
from grader.model.stages import PARTS
from grader.table import Table, read_table

SHIPPED = Path(__file__).with_name("rubric.toml")
"""The exercise sheet's rubric; it also says which checks exist and of which part each is."""

BOTH = "both"
"""Part of a gate that stands before both parts."""

LEAF_RULES = ("sheet", "full-levels")


def load_rubric(path: Path | None = None) -> Rubric:
    """Read a rubric and reject whatever is not understood.

    Args:
        path: A TOML file; None takes the one that is shipped.

    Raises:
        UsageError: With the file, the place in it, what is there and what was expected.
    """
    shipped = _criteria(_read(SHIPPED)[0], None)
    if path is None:
        path = SHIPPED
    root, sha256 = _read(path)
    root.only("reading", "limits", "compile", "part", "criterion", "scenes")
    reading = root.table("reading")
    reading.only("leaf_rule")
    return Rubric(
        criteria=_criteria(root, {one.check: one for one in shipped}),
        titles=_titles(root),
        limits=_limits(root.table("limits"), root.table("compile")),
        leaf_rule=reading.choice("leaf_rule", LEAF_RULES),
        sha256=sha256,
        scenes=_scenes(root, path.parent),
    )


def _read(path: Path) -> tuple[Table, str]:
    root, content = read_table(path, "a rubric")
    return root, hashlib.sha256(content).hexdigest()


def _scenes(root: Table, beside: Path) -> Path | None:
    if not root.has("scenes"):
        return None
    table = root.table("scenes")
    table.only("folder")
    folder = beside / table.text("folder")
    if not folder.is_dir():
        raise table.fault("folder", f'"{folder}"', "a folder that exists, seen from this file")
    return folder


def _titles(root: Table) -> tuple[tuple[str, str], ...]:
    titles: dict[str, str] = {}
    for part in root.tables("part"):
        part.only("id", "title")
        name = part.choice("id", PARTS)
        if name in titles:
            raise part.fault("id", f'"{name}" again', "each part once")
        titles[name] = part.text("title")
    for name in PARTS:
        if name not in titles:
            raise root.fault("part", f'none with id = "{name}"', "one [[part]] for each part")
    return tuple((name, titles[name]) for name in PARTS)


def _limits(table: Table, compiler: Table) -> Limits:
    seconds = ("small_seconds", "large_seconds", "wall_factor", "total_seconds")
    sizes = ("memory_mib", "tasks", "open_files", "stack_mib", "output_kib", "source_kib")
    table.only(*seconds, *sizes)
    small, large, factor, total = (table.number(name, 0.1, 86_400) for name in seconds)
    memory, tasks, files, stack, output, source = (
        table.whole(name, least=1, most=2**20) for name in sizes
    )
    return Limits(
        small_seconds=small,
        large_seconds=large,
        wall_factor=factor,
        total_seconds=total,
        memory_mib=memory,
        tasks=tasks,
        open_files=files,
        stack_mib=stack,
        output_kib=output,
        source_kib=source,
        compiler=_compile_limits(compiler),
    )


def _compile_limits(table: Table) -> CompileLimits:
    names = [field.name for field in fields(CompileLimits)]
    table.only(*names)
    return CompileLimits(*(table.whole(name, least=1, most=2**20) for name in names))


def _criteria(root: Table, shipped: dict[str, Criterion] | None) -> tuple[Criterion, ...]:
    found: dict[str, Criterion] = {}
    for table in root.tables("criterion"):
        one = _criterion(table, shipped)
        if one.check in found:
            raise table.fault("check", f'"{one.check}" again', "each check at most once")
        found[one.check] = one
    return tuple(found.values())


def _criterion(table: Table, shipped: dict[str, Criterion] | None) -> Criterion:
    table.only("check", "part", "points", "gate", "visibility")
    known: Iterable[str] | None = shipped
    check = table.text("check") if known is None else table.choice("check", known)
    parts = (*PARTS, BOTH) if shipped is None else (shipped[check].part,)
    part = table.choice("part", parts)
    points = table.number("points", least=0, most=1000)
    if part == BOTH and points:
        raise table.fault(
            "points", f"{points:g}", f'0, because "{check}" stands before both parts'
        )
    return Criterion(
        check=check,
        part=part,
        points=points,
        gate=table.flag("gate", absent=False),
        visibility=table.choice("visibility", VISIBILITIES, absent="visible"),
    )

"""Docstrings give what types do not: the shapes of arrays, and what is raised on purpose."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

from tests.own_files import ROOT, python_files

ARRAYS = {"Floats", "Doubles", "Indices", "Integers", "Bytes", "Mask", "NDArray"}
"""Types of `grader.model.mesh`, which say the kind of numbers and no shape."""

SHAPE = re.compile(r"\((?:[A-Z.\d]|count|rows|n,)[^()]*\)")
"""`(K, 3)`, `(R,)`, `(count,)`, `(rows + 1, columns + 1, 3)`, `(...)`."""

NO_FAULT = {"AssertionError", "Exit"}
"""What is raised if we are wrong, and how a command ends."""


def modules() -> Iterator[tuple[Path, ast.Module]]:
    """Yield each file and what is written in it."""
    for path in python_files("grader"):
        yield path.relative_to(ROOT / "grader"), ast.parse(path.read_bytes())


def public(body: list[ast.stmt]) -> Iterator[ast.FunctionDef]:
    """Yield the functions that others may call, those of classes too."""
    for node in body:
        if isinstance(node, ast.ClassDef) and not node.name.startswith("_"):
            yield from public(node.body)
        if isinstance(node, ast.FunctionDef) and not node.name.startswith("_"):
            yield node


def holds_arrays(annotation: ast.expr | None) -> bool:
    """Tell whether a type is one of arrays."""
    found = ast.walk(annotation) if annotation else ()
    names = {getattr(node, "id", getattr(node, "attr", "")) for node in found}
    return bool(names & ARRAYS)


def raises(function: ast.FunctionDef) -> set[str]:
    """Name what a function itself raises on purpose."""
    found = (node.exc for node in ast.walk(function) if isinstance(node, ast.Raise))
    called = (one.func if isinstance(one, ast.Call) else one for one in found if one)
    return {ast.unparse(one) for one in called} - NO_FAULT


def undescribed(body: list[ast.stmt]) -> Iterator[str]:
    """Name the array fields of public records without a shape.

    Neighbours may share one, or the record's own docstring says it for all.
    """
    for record in body:
        if not isinstance(record, ast.ClassDef) or record.name.startswith("_"):
            continue
        if SHAPE.search(ast.get_docstring(record) or ""):
            continue
        waiting: list[str] = []
        for node in [*record.body, None]:
            if isinstance(node, ast.AnnAssign):
                if holds_arrays(node.annotation):
                    waiting.append(f"{record.name}.{ast.unparse(node.target)}")
                continue
            described = isinstance(node, ast.Expr) and SHAPE.search(ast.unparse(node))
            yield from () if described else waiting
            waiting = []


def test_arrays_have_a_shape() -> None:
    """In the docstring of each public function that takes or returns one."""
    bare = [
        f"{path}:{function.lineno} {function.name}"
        for path, tree in modules()
        for function in public(tree.body)
        if any(
            map(
                holds_arrays,
                [function.returns, *(one.annotation for one in function.args.args)],
            )
        )
        and not SHAPE.search(ast.get_docstring(function) or "")
    ]
    assert not bare


def test_fields_have_a_shape() -> None:
    """Below each array of a public record, or below the last of several alike."""
    bare = [f"{path} {name}" for path, tree in modules() for name in undescribed(tree.body)]
    assert not bare


def test_what_is_raised_on_purpose_is_told() -> None:
    """`Raises` stands in the docstring of each public function that raises by itself."""
    silent = [
        f"{path}:{function.lineno} {function.name} {sorted(raises(function))}"
        for path, tree in modules()
        for function in public(tree.body)
        if raises(function) and "Raises:" not in (ast.get_docstring(function) or "")
    ]
    assert not silent


def test_the_search_sees_what_it_should() -> None:
    """A function and two records, each as it must not be."""
    text = '''
class Record:
    one: Mask
    two: Mask
    """(K,) bool each."""
    three: Mask
    """True where wrong."""

def function(which: Integers | None) -> None:
    """Do something (quickly)."""
    raise self.fault("x")
'''
    tree = ast.parse(text)
    (function,) = public(tree.body)
    assert list(undescribed(tree.body)) == ["Record.three"]
    assert holds_arrays(function.args.args[0].annotation)
    assert not SHAPE.search(ast.get_docstring(function) or "")
    assert raises(function) == {"self.fault"}

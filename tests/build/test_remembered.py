"""What was compiled before is not compiled again, and nobody gets what is not his."""

import os
import time
from pathlib import Path

import pytest

from grader.build import compiling, remembered
from grader.build.remembered import Product, keep, name_of, recalled
from grader.resources import private_cache
from tests.compiled import BEGIN, CONSTRUCT, INTERSECT, partial_build

pytestmark = pytest.mark.usefixtures("cache")

PRODUCT = Product(b"library\0", b"a warning\n")
SOURCE = BEGIN + CONSTRUCT + INTERSECT + "void f() { int unused_remembered; }\n"


def named(text: str) -> str:
    """Name an entry that no build makes."""
    return name_of(text.encode(), ["c++"], Path("workspace"), "test.so")


def test_a_name_tells_everything_that_a_product_depends_on() -> None:
    """One other word, file or workspace is another product."""
    names = {
        name_of(source, command, Path(folder), product)
        for source in (b"a", b"b")
        for command in (["c++"], ["c++", "-O3"])
        for folder in ("one", "two")
        for product in ("graded.so", "deep.so")
    }
    assert len(names) == 16


def test_what_was_kept_comes_back() -> None:
    """Bytes and messages; nothing before that."""
    name = named(f"kept {time.time_ns()}")
    assert recalled(name) is None
    keep(name, PRODUCT)
    assert recalled(name) == PRODUCT


def test_a_huge_product_is_not_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    """One file would drive out those of a whole class."""
    monkeypatch.setattr(remembered, "LARGEST_ONE", len(PRODUCT.content))
    keep(named("just"), PRODUCT)
    assert recalled(named("just")) == PRODUCT
    keep(named("huge"), Product(PRODUCT.content + b"+", b""))
    assert recalled(named("huge")) is None


@pytest.mark.parametrize("cut", [0, 10, -1])
def test_half_an_entry_is_none(cut: int) -> None:
    """A disk may have been full, or a file damaged."""
    keep(named("damaged"), PRODUCT)
    path = private_cache("products") / named("damaged")
    path.write_bytes(path.read_bytes()[:cut])
    assert recalled(named("damaged")) is None


def test_the_folder_is_ours_alone() -> None:
    """A submission that could write there would choose what others are graded with."""
    assert private_cache("products").stat().st_mode & 0o077 == 0


def test_the_oldest_entries_go_first(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    """When all of them are too large."""
    monkeypatch.setenv("BVHGRADE_CACHE", str(tmp_path / "cache"))
    monkeypatch.setattr(remembered, "LARGEST", 150)
    for number, name in enumerate("abc"):
        keep(named(name), PRODUCT)
        path = private_cache("products") / named(name)
        assert path.stat().st_size < 75
        os.utime(path, (number, number))
    keep(named("d"), PRODUCT)
    assert recalled(named("a")) is None
    assert recalled(named("d")) == PRODUCT


def test_the_second_time_no_compiler_runs(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """The library is the same, and so is the warning; another file is compiled."""
    first = partial_build(SOURCE, tmp_path / "first")
    compiled: list[str] = []

    def refuse(*words: object) -> None:
        compiled.append(str(words[3]))
        raise AssertionError("a compiler was started")

    monkeypatch.setattr(compiling, "compiled", refuse)
    again = partial_build(SOURCE, tmp_path / "again")
    assert first.library
    assert again.library
    assert first.library.read_bytes() == again.library.read_bytes()
    assert again.diagnostics == first.diagnostics != ()
    with pytest.raises(AssertionError, match="a compiler was started"):
        partial_build(SOURCE + "\n", tmp_path / "other")
    assert compiled


def test_what_failed_is_tried_again(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A full disk or a slow machine may be over by then."""
    kept: list[str] = []
    monkeypatch.setattr(compiling, "keep", lambda name, _: kept.append(name))
    assert partial_build(BEGIN + "int x = y;\n", tmp_path).library is None
    assert kept == []

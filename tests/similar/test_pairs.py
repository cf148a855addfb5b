"""Copies are found however they were dressed up, and independent solutions are not alike."""

import re
import struct
from pathlib import Path

import pytest

from grader import resources
from grader.errors import GraderError, MissingTool
from grader.similar import pairs as module
from grader.similar import reader
from grader.similar.pairs import Compared, Pair, Place, compared, read_answer
from tests.own_files import ROOT

RIGHT = ROOT / "tests" / "submissions" / "right"
INDEPENDENT = ("best-first-heap", "bottom-up-boxes", "cramers-rule", "fixed-stack-of-max-depth")
NAMES = re.compile(r"\b(node|left|right|axis|stack|best)\b")


@pytest.fixture(scope="module")
def sources() -> list[bytes]:
    """Give four independent solutions, and the starter that everybody began with."""
    starter = resources.stub_folder() / "src" / "exercise03.cpp"
    files = [RIGHT / f"{name}.cpp" for name in INDEPENDENT]
    return [path.read_bytes() for path in (*files, starter)]


def dressed_up(source: bytes) -> bytes:
    """Rename, comment and indent: what is done to a copy to make it look new."""
    text = NAMES.sub(r"my_\1", source.decode())
    lines = [f"  {line}  // mine" if line.endswith(";") else line for line in text.split("\n")]
    return "\n\n".join(lines).encode()


def pairs(sources: list[bytes]) -> list[Pair]:
    """Compare sources, of which none may be given up."""
    done = compared(sources)
    assert done.given_up == ()
    return list(done.pairs)


def best(found: list[Pair], first: int, second: int) -> Pair:
    """Find a pair."""
    (pair,) = [one for one in found if (one.first, one.second) == (first, second)]
    return pair


def test_a_copy_stays_one_however_it_is_dressed_up(sources: list[bytes]) -> None:
    """New names, comments, indentation: still the pair that comes first, and by far."""
    found = pairs([*sources, dressed_up(sources[0])])
    assert (found[0].first, found[0].second) == (0, len(sources))
    assert found[0].share > 0.9
    assert found[1].share < 0.5


def test_half_a_copy_is_found_from_both_sides(sources: list[bytes]) -> None:
    """A file that holds another one: all of the small one, a part of the large one."""
    joined = sources[0] + sources[2]
    pair = best(pairs([sources[0], joined]), 0, 1)
    assert pair.shares[0] > 0.95
    assert 0.2 < pair.shares[1] < 0.9


def test_the_starter_counts_for_nobody(sources: list[bytes]) -> None:
    """Two who only handed in what they were given have nothing of their own in common."""
    starter = sources[-1]
    changed = starter + b"\n// another comment\n"
    assert pairs([starter, changed]) == []


def test_what_is_marked_is_the_same_code_in_both(sources: list[bytes]) -> None:
    """Without names and white space, the marked places read alike."""
    copy = b"// a remark that moves everything\n\n" + sources[1]
    pair = best(pairs([sources[1], copy]), 0, 1)
    first, second = (
        "".join(text[place.begin : place.end] for place in places)
        for text, places in zip((sources[1].decode(), copy.decode()), pair.places, strict=True)
    )
    assert len(first) > 0.5 * len(sources[1])
    assert "".join(first.split()) == "".join(second.split())


def test_the_same_class_gives_the_same_answer(sources: list[bytes]) -> None:
    """Fingerprints are chosen by hashes, which differ from process to process elsewhere."""
    assert pairs(sources) == pairs(sources)


@pytest.mark.parametrize(
    "hostile",
    [b"", b"\x00\xff\xfe" * 50, b"/*" * 5000, b'R"(' * 3000, "\u202eint \U0001f642;".encode()],
    ids=["empty", "binary", "comments", "raw strings", "letters"],
)
def test_any_bytes_can_be_compared(sources: list[bytes], hostile: bytes) -> None:
    """They are as alike to the others as nothing is; the others stay as they were."""
    found = pairs([sources[0], hostile, sources[0] + b"// me too"])
    assert (found[0].first, found[0].second) == (0, 2)
    assert found[0].share == 1


def test_a_file_that_cannot_be_taken_apart_is_given_up(
    sources: list[bytes], monkeypatch: pytest.MonkeyPatch
) -> None:
    """Its comment can be divided in 2^39 ways; the others are compared without it."""
    bomb = b"int //" + b"\\\n//" * 40 + b"\ndivided = 0;\n"
    usual = reader.started

    def started(given: int, rights: dict[str, str]) -> list[str]:
        command = usual(given, rights)
        at = command.index("-m")
        code = "from grader.similar import reader; import sys; reader.FILE_SECONDS = 2.0; "
        return [*command[:at], "-c", code + "reader.main(sys.argv[1:])", *command[at + 2 :]]

    monkeypatch.setattr(reader, "started", started)
    monkeypatch.setattr(module, "SECONDS", 60)
    copy = dressed_up(sources[0])
    done = compared([sources[0], bomb + sources[0], bomb + sources[2], copy])
    assert done.given_up == (1, 2)
    assert [(one.first, one.second) for one in done.pairs] == [(0, 3)]


def test_the_process_that_reads_sources_can_reach_nothing(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    """It has closed all doors before the first byte of a student is read."""
    secret = tmp_path / "answers"
    secret.write_text("secret")
    code = (
        "import sys\n"
        "from grader.similar import reader\n"
        f"def spy(stream):\n"
        f"    for opened in (lambda: open({str(secret)!r}), lambda: __import__('os').fork(),\n"
        f"                   lambda: open({str(tmp_path / 'written')!r}, 'w'),\n"
        "                   lambda: __import__('socket').socket()):\n"
        "        try:\n"
        "            opened()\n"
        "        except OSError:\n"
        "            continue\n"
        "        sys.exit('a door is open')\n"
        "    return iter(['', '', ''])\n"
        "reader.read_sources = spy\n"
        "reader.main(sys.argv[1:])\n"
    )
    usual = reader.started

    def started(given: int, rights: dict[str, str]) -> list[str]:
        command = usual(given, rights)
        at = command.index("-m")
        return [*command[:at], "-c", code, *command[at + 2 :]]

    monkeypatch.setattr(reader, "started", started)
    assert pairs([b"", b""]) == []
    assert not (tmp_path / "written").exists()


def test_a_comparison_that_fails_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    """What it printed is made harmless."""
    command = ["/bin/sh", "-c", "printf '\\033[31mno\\n' >&2; exit 3"]
    monkeypatch.setattr(reader, "started", lambda given, rights: command)
    with pytest.raises(GraderError, match=r"status 3: \\x1b\[31mno"):
        pairs([b"", b""])


def test_without_copydetect_it_says_what_to_install(monkeypatch: pytest.MonkeyPatch) -> None:
    """It is an extra."""
    monkeypatch.setattr(module, "find_spec", lambda name: None)
    with pytest.raises(MissingTool, match=r'pip install "bvhgrade\[similar\]"'):
        pairs([b"", b""])


def test_an_answer_is_numbers_and_nothing_else() -> None:
    """Whatever does not fit is refused as a whole."""
    record = reader.PAIR.pack(0, 1, 0.5, float("inf"), 1, 0) + reader.PLACE.pack(3, 9)
    number, none = reader.LENGTH.pack, reader.LENGTH.pack(0)
    pair = Pair(0, 1, (0.5, 1.0), ((Place(3, 9),), ()))
    assert read_answer(none + record, 2) == Compared((pair,), ())
    assert read_answer(number(1) + number(2), 3) == Compared((), (2,))
    wrong = [
        b"",
        none + record[:-1],
        none + record + b"x",
        none + reader.PAIR.pack(1, 0, 0, 0, 0, 0),
        none + reader.PAIR.pack(0, 2, 0, 0, 0, 0),
        none + struct.pack("<IIddII", 0, 1, 0, 0, 2**32 - 1, 0),
        number(1) + number(2),
        number(2) + number(0),
        number(2**63) + number(0),
    ]
    for answer in wrong:
        with pytest.raises(GraderError, match="no list of pairs"):
            read_answer(answer, 2)

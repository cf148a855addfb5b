"""What checks find is told in German too, with the same numbers and nobody's words lost."""

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import pytest

from grader.intake.candidates import (
    DAMAGED,
    NOT_A_FILE,
    TOO_MANY,
    Candidate,
    Entry,
    Fault,
    choose,
)
from grader.intake.locate import judged
from grader.language import catalogue
from grader.model.stages import Rejected
from grader.phrases import HOLE, teller
from tests.own_files import ROOT
from tests.report.hostile import HOSTILE

GERMAN = teller("de")

TOLD_BY = (
    *sorted((ROOT / "grader" / "verify").glob("*.py")),
    *(ROOT / "grader" / "counterexample" / f"{name}.py" for name in ("describe", "explain")),
    *(ROOT / "grader" / "run" / f"{name}.py" for name in ("session", "trials")),
    ROOT / "grader" / "oracle" / "altered.py",
    ROOT / "grader" / "score" / "points.py",
    *sorted((ROOT / "grader" / "intake").glob("*.py")),
    ROOT / "grader" / "build" / "compile.py",
    *(ROOT / "grader" / "view" / f"{name}.py" for name in ("inspector", "stage")),
    ROOT / "grader" / "gallery" / "gallery.py",
    *(ROOT / "grader" / f"{name}.py" for name in ("kept", "summary")),
)
"""Where messages of checks are worded, reasons why a file is refused, and remarks."""

NO_MESSAGE = re.compile(
    r"ERROR|_OPTIONS|detect_leaks|print_stacktrace|Assertion|runtime error|AddressSanitizer"
    # What the caller or the machine did is no reason to refuse a file.
    r"|is expected$|it was there a moment ago|in it: |does not get through|does not compile: "
    r"|it stood in line for a processor"
    r"|^remove what is there$|^compiling stood in line|^model name$|cannot be removed: "
    r"|^\{\}\.py$|^t = inf$|facesBegin|^replaced leaves$|^shrunk boxes$|^special rays$"
)
"""Patterns of what others write, names, and what is the same in both languages."""


def skeletons(path: Path) -> Iterator[str]:
    """Find the sentences of a module, with `{}` for what differs."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    passed: set[int] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            passed.add(id(node.value))
        if isinstance(node, ast.JoinedStr):
            passed.update(id(part) for one in node.values for part in ast.walk(one))
    for node in ast.walk(tree):
        if id(node) in passed:
            continue
        if isinstance(node, ast.JoinedStr):
            yield "".join(
                str(part.value) if isinstance(part, ast.Constant) else "{}"
                for part in node.values
            )
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            yield node.value


def sentences() -> list[str]:
    """List those that say something in words."""
    every = {text for path in TOLD_BY for text in skeletons(path)}
    wordy = {text for text in every if re.search(r"[a-z]{2,} [a-z{]|\} [a-z]{2,}", text)}
    return sorted(text for text in wordy if not NO_MESSAGE.search(text))


def known_words() -> str:
    """Return every English sentence of the catalogue, one a line, with `{}` for its holes."""
    return "\n".join(HOLE.sub("{}", english) for english in catalogue("de", "check"))


@pytest.mark.parametrize("sentence", sentences())
def test_every_sentence_of_a_check_is_in_the_catalogue(sentence: str) -> None:
    """Whole, or as a part of the sentence that it is put into."""
    parts = [part.strip(" ,;:()[]") for part in sentence.split("{}")]
    words = known_words()
    for part in parts:
        if len(part) > 3:
            assert part in words, part


def test_there_are_sentences_to_look_at() -> None:
    """The search above finds what it should."""
    assert len(sentences()) > 80
    assert "node {}: box is {}, but its triangles span {}" in sentences()


def test_holes_are_the_same_in_both() -> None:
    """No number is lost and none is told twice."""
    for english, other in catalogue("de", "check").items():
        assert sorted(HOLE.findall(english)) == sorted(HOLE.findall(other)), english


def test_every_sentence_is_found_again_by_its_own_form() -> None:
    """With numbers in the holes nothing of it stays English."""
    for english, other in catalogue("de", "check").items():
        assert GERMAN(HOLE.sub(number, english)) == HOLE.sub(number, other)


def number(hole: re.Match[str]) -> str:
    """Put a number into a hole, always the same into the same."""
    return f"({'abcdef'.find(hole[1])}.5)"


@pytest.mark.parametrize(
    ("english", "german"),
    [
        (
            "4,356 of 14,811 wrong, first in `cloud-4, ordinary rays`: ray 39 (inbound) "
            "from (0.03, -0.97, 1.7) along (0.6, 0.7, -1.8): t is 1.4, but face 3 is hit "
            "at 0.9",
            "4.356 von 14.811 falsch, zuerst in `cloud-4, ordinary rays`: Strahl 39 "
            "(inbound) von (0.03, -0.97, 1.7) entlang (0.6, 0.7, -1.8): t ist 1.4, aber "
            "Dreieck 3 wird bei 0.9 getroffen",
        ),
        (
            "pixel (3, 4): no hit, but face 3 at t = 2 is closer",
            "Pixel (3, 4): kein Treffer, aber Dreieck 3 bei t = 2 ist näher",
        ),
        (
            "1 of 3 wrong, first in `tree over strip-x`: stopped after 10 s",
            "1 von 3 falsch, zuerst in `tree over strip-x`: angehalten nach 10 s",
        ),
        (
            "ray 2: t = 3, point (1, 2, 3), normal (0, 0, 1) from 4 threads at once, but "
            "t = inf the first time",
            "Strahl 2: t = 3, Punkt (1, 2, 3), Normale (0, 0, 1) aus 4 Threads gleichzeitig, "
            "aber t = inf beim ersten Mal",
        ),
        (
            "node 3 holds 5 faces and is a leaf, but nodes of more than 4 are split",
            "Knoten 3 enthält 5 Dreiecke und ist ein Blatt, aber Knoten mit mehr als 4 "
            "werden geteilt",
        ),
        ("2 faces, 1 ray", "2 Dreiecke, 1 Strahl"),
        (
            "its triangles span (0, 0, 1) to (1, 2, 3)",
            "seine Dreiecke reichen von (0, 0, 1) bis (1, 2, 3)",
        ),
        (
            "intersect, pixel (3, 4): did not come back and was stopped",
            "intersect, Pixel (3, 4): kam nicht zurück und wurde angehalten",
        ),
        (
            "intersect, Strahl 7: ended by SIGSEGV (invalid memory)",
            "intersect, Strahl 7: beendet durch SIGSEGV (invalid memory)",
        ),
        (
            "construct: threw an exception: no hit",
            "construct: warf eine Ausnahme: no hit",
        ),
    ],
)
def test_whole_messages_are_told(english: str, german: str) -> None:
    """Sentences within sentences, with every number."""
    assert GERMAN(english) == german


def entry(folder: str) -> Entry:
    """Make a file that says something else in each folder."""
    return Entry(f"{folder}/exercise03.cpp", lambda _: folder.encode())


REFUSED: dict[str, Candidate | Fault] = {
    "empty": Candidate("a/exercise03.cpp", b" "),
    "large": Candidate("a/exercise03.cpp", bytes(3000)),
    "wide": Candidate("a/exercise03.cpp", "int a;".encode("utf-16")),
    "archive": Candidate("no hit: exercise03.cpp", b"PK\x03\x04"),
    "link": Candidate("a/exercise03.cpp", NOT_A_FILE),
    "damaged": DAMAGED,
    "many": TOO_MANY,
    "two": choose([entry("a"), entry("b")], 100),
    "none": choose([Entry("main.cpp", lambda _: b"")], 100),
    "nothing": choose([], 100),
}


@pytest.mark.parametrize("name", REFUSED)
def test_why_a_file_is_refused_is_told_in_german(name: str) -> None:
    """With its name as it is, and nothing of ours in English."""
    found = judged("ada", REFUSED[name], 2048)
    assert isinstance(found, Rejected)
    told = GERMAN(found.reason)
    english = r"\b(the|this|file|files|hand|pack|but|called|more than)\b"
    assert re.search(english, found.reason)
    assert not re.search(english, told)
    if isinstance(REFUSED[name], Candidate):
        path, reason = found.reason.rsplit(".cpp: ", 1)
        assert told.startswith(f"{path}.cpp: ")
        assert reason not in told


@pytest.mark.parametrize(
    ("english", "german"),
    [
        (
            "it prints more than 64 KiB in one run; the rest was dropped",
            "sie gibt in einem Lauf mehr als 64 KiB aus; der Rest wurde verworfen",
        ),
        (
            "with sanitizers it does not compile, so memory is not safe: line 3: no hit",
            "mit Sanitizern lässt sich die Datei nicht übersetzen, also gilt der Umgang mit "
            "Speicher nicht als sicher: Zeile 3: no hit",
        ),
        (
            "`cube`: The grader itself failed here (KeyError); it costs no points.",
            "`cube`: Hier ist die Bewertung selbst gescheitert (KeyError); das kostet keine "
            "Punkte.",
        ),
        (
            "views.json is missing, which is our own fault (KeyError) and costs no point",
            "views.json fehlt; das ist unser eigener Fehler (KeyError) und kostet keinen Punkt",
        ),
    ],
)
def test_remarks_are_told_in_german(english: str, german: str) -> None:
    """A compiler's words in them stay as they are."""
    assert GERMAN(english) == german


def test_a_stranger_s_words_stay_as_they_are() -> None:
    """The text of an exception is no sentence of ours, whatever it says."""
    assert GERMAN("threw an exception: node 3 and face 2: no hit") == (
        "warf eine Ausnahme: node 3 and face 2: no hit"
    )


def test_english_stays_english() -> None:
    """And so does what nobody translated."""
    assert teller("en")("no hit") == "no hit"
    assert GERMAN("something else entirely") == "something else entirely"


@pytest.mark.parametrize("name", HOSTILE)
def test_hostile_text_is_told_without_harm(name: str) -> None:
    """It is neither lost nor taken apart without end."""
    text = f"threw an exception: {HOSTILE[name]}"
    assert HOSTILE[name] in GERMAN(text)
    assert isinstance(GERMAN(HOSTILE[name] * 3), str)

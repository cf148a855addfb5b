"""How does a terminal explain one failed check, from what happened to how to run it again?"""

import shlex
from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

from rich.text import Text

from grader.language import Words
from grader.model.grade import CheckScore, Grade
from grader.model.stages import SOURCE_PATH, Rejected
from grader.report.facts import counterexample_file, place, size_of
from grader.report.hints import WITH_CAUSE, hints
from grader.report.nodes import node_table
from grader.report.sheet import STYLES, Sheet

if TYPE_CHECKING:
    from grader.model.counterexample import Counterexample

EXCERPT = 3
"""Lines of source that are shown, the marked one last."""

SHOWN_ERRORS = 3


@dataclass(frozen=True, slots=True)
class Occasion:
    """How a report came to be printed; nothing in it comes from the submission."""

    command: str
    """The call, ready to be pasted; `--only CHECK` may be added. Empty if none fits."""

    written: Path | None = None
    """Where `result.json` lies."""

    hints: int = WITH_CAUSE
    """How much is said beyond the facts, 0 to 3."""

    language: str = "en"
    viewer: str = ""
    """The call of the viewer; `--check FILE` may be added. Empty if none fits."""


def points(score: float, possible: float, words: Words = str) -> str:
    """Write points as people do: `4 of 5`, `2.25 of 3`."""
    return words("{score} of {possible}").format(score=f"{score:g}", possible=f"{possible:g}")


def with_unit(score: float, possible: float, words: Words) -> str:
    """Write `4 of 5 points`."""
    return words("{score} points").format(score=points(score, possible, words))


def explain(sheet: Sheet, grade: Grade, score: CheckScore, occasion: Occasion) -> None:
    """Write the whole block of one failed check."""
    headline(sheet, score)
    happened = sheet.plain(sheet.told(score.message))
    if happened:
        sheet.beside("", happened)
    for label, told in examples(sheet, score, happened):
        sheet.beside(label, told)
    smallest(sheet, score)
    shown = score.counterexample or score
    if shown.expected:
        sheet.beside("expected", sheet.told(shown.expected), "green")
    if shown.got:
        sheet.beside("got", sheet.told(shown.got), "red")
    look_at(sheet, grade, score)
    for label, text in hints(score, occasion.hints, sheet.words):
        sheet.beside(label, text, "cyan")
    if occasion.command and score.visibility == "visible":
        # A counterexample has no hints, so only this one takes them along.
        more = "" if occasion.hints == WITH_CAUSE else f" --hints {occasion.hints}"
        sheet.command("again", f"{occasion.command} --only {score.check}{more}")
        show_again(sheet, score, occasion)


def show_again(sheet: Sheet, score: CheckScore, occasion: Occasion) -> None:
    """Name the commands that show the smallest input alone, in words and from all sides."""
    if score.counterexample is None or occasion.written is None:
        return
    file = shlex.quote(str(occasion.written.parent / counterexample_file(score.check)))
    sheet.command("replay", f"{occasion.command} --replay {file}")
    if occasion.viewer:
        sheet.command("view", f"{occasion.viewer} --check {file}")


def smallest(sheet: Sheet, score: CheckScore) -> None:
    """Tell the smallest input that fails; what is expected of it and what it got come next."""
    found = score.counterexample
    if found is not None:
        sheet.beside("smallest", f"{sheet.told(size_of(found))}: {sheet.told(found.message)}")
        tell_more(sheet, found)


def tell_more(sheet: Sheet, found: "Counterexample") -> None:
    """Say where in the tree it went wrong, and draw the tree if it is small."""
    if found.explanation:
        sheet.beside("where", sheet.told(found.explanation))
    if found.table is not None:
        node_table(sheet, found.table)


def headline(sheet: Sheet, score: CheckScore) -> None:
    """Write verdict word and statement, and the points on the right or below."""
    style = STYLES[score.verdict]
    mark = Text.assemble((f"{sheet.glyphs.named(score.verdict, sheet.words)}  ", style))
    words = sheet.words
    worth = with_unit(score.score, score.max_score, words) if score.max_score else words("gate")
    room = sheet.width - mark.cell_len
    lines = sheet.wrapped(words(sheet.line(score.title)), room)
    fits = Text(lines[-1]).cell_len + len(worth) + 2 <= room
    for number, line in enumerate(lines):
        left = mark.copy() if number == 0 else Text(" " * mark.cell_len)
        left.append(line, "bold")
        last = number == len(lines) - 1
        sheet.spread(left, Text(worth if last and fits else "", "dim"))
    if not fits:
        sheet.beside("points", points(score.score, score.max_score, words))


def examples(sheet: Sheet, score: CheckScore, happened: str) -> list[tuple[str, str]]:
    """Choose what the message did not say yet, with a label before the first."""
    told = [sheet.plain(sheet.told(one.message)) for one in score.examples]
    told = [one for one in told if one not in happened]
    labels = ["example"] + [""] * len(told)
    return list(zip(labels, told, strict=False))


def look_at(sheet: Sheet, grade: Grade, score: CheckScore) -> None:
    """Name file, line and function, with the source around a statement that is known."""
    found = place(grade, score)
    if found is None:
        return
    line = "" if found.line is None else f":{found.line}"
    function = found.function or sheet.words("this file")
    told = sheet.words("{place} in {function}").format(
        place=f"{SOURCE_PATH}{line}", function=function
    )
    sheet.beside("look at", told)
    if found.exact and found.line is not None:
        excerpt(sheet, grade, found.line)


def excerpt(sheet: Sheet, grade: Grade, line: int) -> None:
    """Show the student's own lines up to the one that is meant."""
    source = source_lines(grade)
    for number in range(max(1, line - EXCERPT + 1), line + 1):
        if number <= len(source):
            sheet.source(number, source[number - 1], marked=number == line)


def source_lines(grade: Grade) -> list[str]:
    """Split the student's file as the compiler counts lines."""
    if isinstance(grade.submission, Rejected):
        return []
    text = grade.submission.source.decode("utf-8", "replace").removeprefix("\ufeff")
    return text.replace("\r\n", "\n").split("\n")


def compile_errors(sheet: Sheet, grade: Grade) -> None:
    """Show the first errors with the student's line numbers, and count the others."""
    said = () if grade.build is None else grade.build.diagnostics
    errors = [one for one in said if one.severity == "error"]
    for one in errors[:SHOWN_ERRORS]:
        column = f":{one.column}" if one.column else ""
        where = f"{SOURCE_PATH}:{one.line}{column}: " if one.line else ""
        sheet.beside("error", where + one.text)
        if one.line:
            excerpt(sheet, grade, one.line)
    if len(errors) > SHOWN_ERRORS:
        rest = len(errors) - SHOWN_ERRORS
        told = sheet.words("and {rest} more, perhaps only consequences of these.")
        sheet.beside("", told.format(rest=rest), "dim")

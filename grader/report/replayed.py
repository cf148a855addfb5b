"""How does a terminal tell what became of a counterexample that was tried again?"""

from typing import TYPE_CHECKING

from rich.console import Console
from rich.text import Text

from grader.language import translator
from grader.model.verdict import Verdict
from grader.report.counts import teller
from grader.report.facts import size_of
from grader.report.failure import tell_more
from grader.report.sheet import STYLES, Sheet

if TYPE_CHECKING:
    from grader.model.counterexample import Replay


def print_replay(console: Console, told: "Replay", language: str = "en") -> None:
    """Print the check, and what is wrong if it still fails."""
    sheet = Sheet(console, translator(language), teller(language))
    verdict = Verdict.FAIL if told.found else Verdict.PASS
    if told.undecided:
        verdict = Verdict.BLOCKED
    mark = Text.assemble((f"{sheet.glyphs.named(verdict, sheet.words)}  ", STYLES[verdict]))
    for line in sheet.wrapped(sheet.words(sheet.line(told.title)), sheet.width - mark.cell_len):
        sheet.lines.append(mark.append(line, "bold"))
        mark = Text(" " * mark.cell_len)
    if told.undecided:
        sheet.beside("", sheet.told(told.undecided))
        if told.is_ours:
            sheet.say(sheet.words("Nothing is concluded about the submission."), "yellow")
    elif told.found is None:
        passes = sheet.words("{check} does not fail on this input any more.")
        sheet.say(passes.format(check=told.check), "green")
    else:
        found = told.found
        sheet.beside("input", f"{sheet.told(size_of(found))}: {sheet.told(found.message)}")
        tell_more(sheet, found)
        if found.expected:
            sheet.beside("expected", sheet.told(found.expected), "green")
        if found.got:
            sheet.beside("got", sheet.told(found.got), "red")
    sheet.show()

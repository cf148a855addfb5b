"""How does a terminal tell what became of a counterexample that was tried again?"""

from typing import TYPE_CHECKING

from rich.console import Console
from rich.text import Text

from grader.model.verdict import Verdict
from grader.report.facts import size_of
from grader.report.failure import tell_more
from grader.report.sheet import STYLES, Sheet

if TYPE_CHECKING:
    from grader.model.counterexample import Replay


def print_replay(console: Console, told: "Replay") -> None:
    """Print the check, and what is wrong if it still fails."""
    sheet = Sheet(console)
    passed = told.found is None and not told.undecided
    verdict = Verdict.PASS if passed else Verdict.FAIL
    mark = Text.assemble((f"{sheet.glyphs.named(verdict)}  ", STYLES[verdict]))
    for line in sheet.wrapped(sheet.line(told.title), sheet.width - mark.cell_len):
        sheet.lines.append(mark.append(line, "bold"))
        mark = Text(" " * mark.cell_len)
    if told.undecided:
        sheet.beside("", told.undecided)
    elif told.found is None:
        sheet.say(f"{told.check} does not fail on this input any more.", "green")
    else:
        found = told.found
        sheet.beside("input", f"{size_of(found)}: {found.message}")
        tell_more(sheet, found)
        if found.expected:
            sheet.beside("expected", found.expected, "green")
        if found.got:
            sheet.beside("got", found.got, "red")
    sheet.show()

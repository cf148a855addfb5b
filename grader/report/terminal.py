"""How does a terminal tell a grade? Score, parts, a line for each check, the worst in full."""

from rich.console import Console
from rich.text import Text

from grader.language import Words, translator
from grader.model.grade import CheckScore, Grade, PartScore
from grader.model.stages import Rejected
from grader.model.verdict import Verdict
from grader.report.counts import teller
from grader.report.facts import BEGIN, FUNCTIONS, NOT_STARTED, unstarted, withheld, worst
from grader.report.failure import Occasion, compile_errors, explain, points, with_unit
from grader.report.sheet import STYLES, Sheet

STATEMENT_MIN = 24
"""Columns below which a cut statement says less than the check's name alone."""


NAME_COLUMN = 35
"""The longest name of a check; in a wide terminal all statements begin behind it."""

COLUMNS_FROM = 100
"""Width from which there is room for that."""


def print_grade(console: Console, grade: Grade, occasion: Occasion) -> None:
    """Print the whole report; width, colours and encoding are the console's."""
    sheet = Sheet(console, translator(occasion.language), teller(occasion.language))
    header(sheet, grade)
    if is_exposed(grade):
        banner(sheet)
    if isinstance(grade.submission, Rejected):
        sheet.blank()
        rejected(sheet, grade.submission)
    elif grade.build is not None and grade.build.library is None:
        sheet.blank()
        uncompiled(sheet, grade)
    else:
        every_part(sheet, grade)
        every_fault(sheet, grade)
        worst_failure(sheet, grade, occasion)
        first_step(sheet, grade, occasion)
    sheet.blank()
    footer(sheet, grade, occasion)
    sheet.show()


def header(sheet: Sheet, grade: Grade) -> None:
    """Name the submission and its score, and draw the score."""
    given = grade.submission
    name = Text.assemble(("bvhgrade  ", "dim"), (sheet.line(given.student), "bold"))
    if not isinstance(given, Rejected) and sheet.line(given.path) != sheet.line(given.student):
        name.append(f"  {sheet.line(given.path)}", "dim")
    if grade.score is None or grade.needs_review:
        sheet.spread(name, Text(sheet.words("score withheld"), "bold magenta"))
        return
    share = grade.score / grade.max_score if grade.max_score else 0.0
    style = "bold green" if share >= 1 else "bold yellow" if share > 0 else "bold red"
    sheet.spread(name, Text(with_unit(grade.score, grade.max_score, sheet.words), style))
    full = int(share * sheet.width)
    rest = sheet.glyphs.empty * (sheet.width - full)
    sheet.lines.append(Text.assemble((sheet.glyphs.full * full, style), (rest, "dim")))


def is_exposed(grade: Grade) -> bool:
    """Code of the submission ran with the rights of whoever started the grader."""
    return grade.build is not None and grade.provenance.isolation == "none"


def banner(sheet: Sheet) -> None:
    """Warn where nobody overlooks it."""
    told = sheet.words("NOT ISOLATED: the submission could do what you can do.")
    sheet.say(told, "bold yellow")


def rejected(sheet: Sheet, given: Rejected) -> None:
    """Say why nothing could be graded."""
    sign = sheet.glyphs.mark(Verdict.FAIL)
    statement = (sheet.words("There is no file to grade"), "bold")
    sheet.lines.append(Text.assemble((f"{sign} ", "red"), statement))
    sheet.beside("", sheet.told(given.reason))


def uncompiled(sheet: Sheet, grade: Grade) -> None:
    """Show what the compiler said, and that everything else hangs on it."""
    sign = sheet.glyphs.mark(Verdict.FAIL)
    statement = (sheet.words("The file does not compile"), "bold")
    sheet.lines.append(Text.assemble((f"{sign} ", "red"), statement))
    compile_errors(sheet, grade)
    sheet.blank()
    waiting = sum(score.verdict is Verdict.BLOCKED for score in grade.checks)
    if waiting:
        told = sheet.words("{waiting} checks wait until it compiles.")
        sheet.say(told.format(waiting=waiting), "dim")


def every_part(sheet: Sheet, grade: Grade) -> None:
    """Write each part with its checks, and before them those that belong to no part."""
    idle, unknown = unstarted(grade), withheld(grade)
    known = {part.part for part in grade.parts}
    shared = [score for score in grade.checks if score.part not in known]
    if shared:
        sheet.blank()
    for score in shared:
        check_line(sheet, score, worth(score, unknown, sheet.words))
    for part in grade.parts:
        scores = [score for score in grade.checks if score.part == part.part]
        if not scores:
            continue
        sheet.blank()
        part_line(sheet, part, any(score.check in unknown for score in scores))
        if part.part in idle:
            not_begun(sheet, part.part, indent=2)
            continue
        for score in scores:
            check_line(sheet, score, worth(score, unknown, sheet.words))


def not_begun(sheet: Sheet, part: str, indent: int = 0) -> None:
    """Say that a part still is the given code."""
    function = FUNCTIONS.get(part, sheet.words("the function"))
    told = sheet.words(NOT_STARTED).format(part=part, function=function)
    sheet.say(told, "yellow", indent)


def part_line(sheet: Sheet, part: PartScore, unknown: bool) -> None:
    """Write a part's title and points."""
    earned = points(part.score, part.max_score, sheet.words)
    earned = sheet.words("withheld") if unknown else earned
    if not part.max_score:
        earned = ""
    title = Text(f"{part.part})  {sheet.words(sheet.line(part.title))}", "bold")
    sheet.spread(title, Text(earned, "bold"))


def worth(score: CheckScore, unknown: frozenset[str], words: Words) -> str:
    """Word what a check is worth."""
    if score.check in unknown:
        return words("withheld")
    return points(score.score, score.max_score, words) if score.max_score else words("gate")


def check_line(sheet: Sheet, score: CheckScore, earned: str) -> None:
    """Write one check on one line: sign, name, as much of the statement as fits, points."""
    sign = sheet.glyphs.mark(score.verdict)
    name = score.check.ljust(NAME_COLUMN if sheet.width >= COLUMNS_FROM else 0)
    line = Text.assemble("  ", (f"{sign} ", STYLES[score.verdict]), name)
    remark = sheet.words(sheet.line(score.title))
    if score.verdict is Verdict.BLOCKED and score.blocked_by:
        remark = sheet.words("waits for {check}").format(check=score.blocked_by)
    elif score.verdict is Verdict.PASS and ":" in score.message:
        # Few cases are named: there a student looks for the dragon.
        remark = sheet.line(sheet.told(score.message))
    if sheet.width - line.cell_len - len(earned) - 4 >= STATEMENT_MIN:
        line.append(f"  {remark}", "dim")
    sheet.spread(line, Text(earned, "dim"))


def every_fault(sheet: Sheet, grade: Grade) -> None:
    """Name our own faults, which never cost points."""
    broken = [score for score in grade.checks if score.verdict is Verdict.BROKEN]
    if not broken:
        return
    sheet.blank()
    told = sheet.words(
        "The grader itself failed in these checks, which costs no points; your score is "
        "withheld:"
    )
    sheet.say(told, "magenta")
    for score in broken:
        sheet.beside("", f"{score.check}: {sheet.told(score.message)}")


def worst_failure(sheet: Sheet, grade: Grade, occasion: Occasion) -> None:
    """Explain the failure that costs most."""
    score = worst(grade)
    if score is None:
        return
    sheet.blank()
    explain(sheet, grade, score, occasion)


def first_step(sheet: Sheet, grade: Grade, occasion: Occasion) -> None:
    """Say where to begin, if nothing but what is not started is left to do."""
    if occasion.hints and unstarted(grade) and worst(grade) is None:
        sheet.blank()
        sheet.say(sheet.words(BEGIN), "cyan")


def remarks(sheet: Sheet, grade: Grade) -> None:
    """Say what is worth knowing of the run and costs nothing."""
    for remark in () if grade.build is None else grade.build.remarks:
        told = sheet.line(sheet.told(remark))
        sheet.say(sheet.words("Note: {remark}.").format(remark=told), "yellow")


def footer(sheet: Sheet, grade: Grade, occasion: Occasion) -> None:
    """Say where the result lies, how the run was isolated and where the time went."""
    remarks(sheet, grade)
    if occasion.written is not None:
        where = sheet.line(str(occasion.written))
        sheet.lines.append(Text.assemble((sheet.words("report") + "  ", "dim"), where))
    spent = grade.timing
    # Workers run side by side, so their sum may be longer than the whole.
    times = sheet.words(
        "{total} s on the clock; compiling {compile}, workers {submission} in all, "
        "grader {grader}, partly at once"
    ).format(
        total=f"{spent.total:.1f}",
        compile=f"{spent.compile:.1f}",
        submission=f"{spent.submission:.1f}",
        grader=f"{spent.grader:.1f}",
    )
    sheet.say(times, "dim")
    if grade.build is not None and not is_exposed(grade):
        level = sheet.line(grade.provenance.isolation)
        sheet.say(sheet.words("isolated by {level}").format(level=level), "dim")

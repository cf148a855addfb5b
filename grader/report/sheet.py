"""How are lines of a terminal report laid out: width, signs, gutter, wrapping?

Every word from outside becomes a `rich.text.Text` here, never a markup string, after it went
through `for_terminal`. So `v[red]` and `[/tmp/x]` survive, and an escape sequence does not.
"""

from dataclasses import dataclass, field

from rich.console import Console
from rich.text import Text

from grader.language import Words
from grader.model.verdict import Verdict
from grader.report.counts import counted
from grader.report.escape import for_terminal, line_for_terminal, unheard

MIN_WIDTH = 56
MAX_WIDTH = 120
MAX_LINES = 12
"""Lines of one paragraph; a stranger's thousand empty ones must not hide the others."""

LABEL_WIDTH = 8

STYLES = {
    Verdict.PASS: "green",
    Verdict.FAIL: "red",
    Verdict.BLOCKED: "yellow",
    Verdict.BROKEN: "magenta",
}


@dataclass(frozen=True, slots=True)
class Glyphs:
    """The signs of a report; an encoding that lacks them gets words."""

    marks: tuple[tuple[Verdict, str], ...]
    gutter: str
    full: str
    empty: str
    rest: str
    """Stands at the end of a line that was cut."""

    def mark(self, verdict: Verdict) -> str:
        """Sign of a verdict, padded so that what follows lines up."""
        width = max(len(sign) for _, sign in self.marks)
        return dict(self.marks)[verdict].ljust(width)

    def named(self, verdict: Verdict, words: Words = str) -> str:
        """Sign and word of a verdict, or the sign alone where it is a word."""
        sign = dict(self.marks)[verdict]
        return sign if sign.isalpha() else f"{sign} {words(verdict.value)}"


SIGNS = Glyphs(
    marks=(
        (Verdict.PASS, "✓"),
        (Verdict.FAIL, "✗"),
        (Verdict.BLOCKED, "\N{EN DASH}"),
        (Verdict.BROKEN, "!"),
    ),
    gutter="│",
    full="█",
    empty="░",
    rest="…",
)

WORDS = Glyphs(
    marks=(
        (Verdict.PASS, "ok"),
        (Verdict.FAIL, "FAIL"),
        (Verdict.BLOCKED, "--"),
        (Verdict.BROKEN, "!!"),
    ),
    gutter="|",
    full="#",
    empty="-",
    rest="~",
)


def glyphs_for(encoding: str) -> Glyphs:
    """Choose signs if the stream can carry them, else words."""
    drawn = "".join(sign for _, sign in SIGNS.marks) + SIGNS.gutter + SIGNS.full + SIGNS.empty
    try:
        drawn.encode(encoding)
    except (UnicodeEncodeError, LookupError):
        return WORDS
    return SIGNS


@dataclass(slots=True)
class Sheet:
    """Lines of a report, collected before any of them is printed."""

    console: Console
    words: Words = str
    """Translates our own texts, never a stranger's."""

    told: Words = str
    """Translates what checks found; a stranger's words in it stay as they are."""

    glyphs: Glyphs = field(init=False)
    width: int = field(init=False)
    lines: list[Text] = field(default_factory=list)

    def __post_init__(self) -> None:
        """Read width and encoding from the console once."""
        self.glyphs = glyphs_for(self.console.encoding)
        self.width = max(MIN_WIDTH, min(MAX_WIDTH, self.console.width))

    def plain(self, text: str) -> str:
        """Take the power from a stranger's text."""
        return for_terminal(text, self.console.encoding)

    def line(self, text: str) -> str:
        """Take the power from a stranger's text and put it on one line."""
        return line_for_terminal(text, self.console.encoding)

    def blank(self) -> None:
        """Leave a line empty."""
        self.lines.append(Text())

    def say(self, text: str, style: str = "", indent: int = 0) -> None:
        """Write a paragraph, wrapped."""
        for line in self.wrapped(text, self.width - indent):
            self.lines.append(Text(" " * indent).append(line, style))

    def spread(self, left: Text, right: Text) -> None:
        """Write one line with something at both ends; the left one is cut if it is too long."""
        room = self.width - right.cell_len - 2
        if left.cell_len > room:
            left = left.copy()
            left.truncate(room - 1)
            left.append(self.glyphs.rest)
        gap = self.width - left.cell_len - right.cell_len if right else 0
        self.lines.append(Text.assemble(left, " " * gap, right))

    def beside(self, label: str, text: str, style: str = "") -> None:
        """Write a paragraph beside the gutter, with its label before the first line."""
        first = self.gutter(label)
        for line in self.wrapped(text, self.width - first.cell_len):
            self.lines.append(first.append(line, style))
            first = self.gutter("")

    def command(self, label: str, text: str) -> None:
        """Write a command beside the gutter on one line, however long it is."""
        self.lines.append(self.gutter(label).append(self.line(text)))

    def source(self, number: int, text: str, marked: bool) -> None:
        """Write a line of source code beside the gutter, cut at the right edge."""
        line = Text.assemble("  ", (self.glyphs.gutter, "red"), " ")
        line.append("> " if marked else "  ", "red")
        line.append(f"{number:>6}  ", "bold red" if marked else "dim")
        code = Text(self.plain(text).replace("\n", " ").expandtabs(4).rstrip())
        if code.cell_len > self.width - line.cell_len:
            code.truncate(self.width - line.cell_len - 1)
            code.append(self.glyphs.rest)
        code.stylize("bold" if marked else "")
        self.lines.append(line.append_text(code))

    def gutter(self, label: str) -> Text:
        """Begin a line of a failure's block."""
        bar = Text.assemble("  ", (self.glyphs.gutter, "red"), " ")
        return bar.append(self.words(label).ljust(LABEL_WIDTH) + "  ", "dim")

    def wrapped(self, text: str, width: int) -> list[str]:
        """Break hostile text into lines of at most `width` cells, long words included."""
        plain = Text(self.plain(text).expandtabs(4))
        lines = [line.plain.rstrip() for line in plain.wrap(self.console, max(width, 16))]
        if len(lines) <= MAX_LINES:
            return lines
        half = MAX_LINES // 2
        count = counted(len(lines) - 2 * half + 1, self.words)
        missing = self.words("[... {count} lines ...]").format(count=count)
        return [*lines[:half], missing, *lines[1 - half :]]

    def show(self) -> None:
        """Print all lines at once; what the encoding lacks is written as its code."""
        with self.console.capture() as captured:
            for line in map(inert, self.lines):
                self.console.print(line, soft_wrap=True, highlight=False, markup=False)
        stream = self.console.file
        encoding = self.console.encoding
        text = captured.get().encode(encoding, "backslashreplace").decode(encoding)
        stream.write(text)
        stream.flush()


def inert(line: Text) -> Text:
    """Break a command that wrapping put at the start of a line; it loses its colours."""
    plain = unheard(line.plain)
    return line if plain == line.plain else Text(plain.removeprefix(" "))

r"""What of a stranger's text can be shown anywhere? Only what is seen; the rest as its code.

Names, exceptions, symbols and compiler messages come from a stranger. What comes out of here
holds no control character but newline and tab, no lone surrogate, nothing that is invisible,
changes direction or piles up on its neighbours. What stood there becomes what C++ would write,
`\x1b`, like that which a terminal's encoding lacks. Escaping what one format takes as special
(markup, quotes, commands) is `grader.report.escape`'s job.
"""

import re
import unicodedata

FIELD_LIMIT = 4000
"""Characters that one field of a report keeps; more teaches nobody anything."""

NAME_LIMIT = 120
"""Characters of a stranger's file or function name that are shown."""

MOST_MARKS = 4
"""Accents on one letter; scripts in use need fewer, and a hundred cover the lines around."""

LINE_ENDS = re.compile("\r\n|[\r\v\f\x85\u2028\u2029]")

UNSURE = re.compile(r"[^\x20-\x7e]+")

INVISIBLE = re.compile(
    "[\u034f\u115f\u1160\u17b4\u17b5\u180b-\u180f\u2800\u3164\ufe00-\ufe0f\uffa0"
    "\U000e0100-\U000e01ef]"
)
"""Letters and marks without a shape, which `str.isprintable` lets through.

Source: Unicode 15, DerivedCoreProperties.txt, Default_Ignorable_Code_Point; and blank Braille.
"""


def printable(text: str, limit: int = FIELD_LIMIT) -> str:
    """Make a stranger's text harmless, and cut it in the middle if it is long.

    Args:
        text: Anything, lone surrogates included.
        limit: How many characters are left at most.
    """
    text = LINE_ENDS.sub("\n", text)
    unread = ""
    if len(text) > 2 * limit:
        # Only the ends can be shown; looking at each character of a flood takes seconds.
        unread = "." * (len(text) - 2 * limit)
        text, tail = text[:limit], text[len(text) - limit :]
        unread += _coded(tail, kept="\n\t")
    return shortened(_coded(text, kept="\n\t") + unread, limit)


def one_line(text: str, limit: int = FIELD_LIMIT) -> str:
    """Make a stranger's text harmless and join its lines, for headings and titles."""
    return shortened(" ".join(_coded(text, kept="\n\t\r\v\f\x85\u2028\u2029").split()), limit)


def as_name(text: str, limit: int = NAME_LIMIT) -> str:
    """Make a stranger's name harmless, newlines too, so that two names stay two names.

    What is too long loses its middle, so that the file's name at the end of a path stays.
    """
    shown = _coded(text, kept="")
    if len(shown) <= limit:
        return shown
    half = (limit - 1) // 2
    return f"{shown[:half]}…{shown[-half:]}"


def shortened(text: str, limit: int) -> str:
    """Keep head and tail of a long text and say how much is missing between them."""
    if len(text) <= limit:
        return text
    half = max(limit - 40, 0) // 2
    missing = len(text) - 2 * half
    return f"{text[:half]} [... {missing:,} characters ...] {text[len(text) - half :]}"


def _coded(text: str, kept: str) -> str:
    """Write what is not seen as its code, except the white space in `kept`."""

    def run(found: re.Match[str]) -> str:
        # A mark without a letter would sit on what we wrote before it.
        before = text[max(found.start() - 1, 0) : found.start()]
        marks = 0 if before.strip() else MOST_MARKS
        shown: list[str] = []
        for character in found[0]:
            if unicodedata.category(character) in ("Mn", "Me"):
                marks += 1
            else:
                marks = MOST_MARKS if character in kept else 0
            plain = character in kept or (
                character.isprintable()
                and not INVISIBLE.match(character)
                and marks <= MOST_MARKS
            )
            shown.append(character if plain else ascii(character)[1:-1])
        return "".join(shown)

    return UNSURE.sub(run, text)

"""How does hostile text become text that every format may carry?

Names, printed output and compiler messages come from a stranger. They pass through `printable`
on their way into any format; what comes out holds no escape sequence, no control character but
newline and tab, no lone surrogate, and no character that is invisible or changes direction.
Escaping what a format itself treats as special (markup, quotes) is that format's job.
"""

import re
import unicodedata

FIELD_LIMIT = 4000
"""Characters that one field of a report keeps; more teaches nobody anything."""

ESCAPE_SEQUENCE = re.compile(
    r"(?:\x1b\[|\x9b)[0-?]*[ -/]*[@-~]"  # CSI: colours, cursor, erase
    r"|(?:\x1b[\]PX^_]|[\x90\x98\x9d-\x9f])[^\x07\x1b\x9c]*(?:\x07|\x1b\\|\x9c|$)"  # OSC, DCS
    r"|\x1b[ -/]*[0-~]"  # all shorter ones
)
"""What a terminal takes as a command. Source: ECMA-48, 5th edition, 5.3 to 5.6."""

UNSURE = re.compile(r"[^\n\t\x20-\x7e]")

REPLACEMENT = "\ufffd"


def printable(text: str, limit: int = FIELD_LIMIT) -> str:
    """Make hostile text harmless in every format, and cut it in the middle if it is long.

    Args:
        text: Anything, lone surrogates included.
        limit: How many characters are left at most.
    """
    plain = ESCAPE_SEQUENCE.sub("", text).replace("\r\n", "\n").replace("\r", "\n")
    return shortened(UNSURE.sub(lambda found: visible(found[0]), plain), limit)


def one_line(text: str, limit: int = FIELD_LIMIT) -> str:
    """Make hostile text harmless and put it on a single line."""
    return shortened(" ".join(printable(text, limit).split()), limit)


def shortened(text: str, limit: int) -> str:
    """Keep head and tail of a long text and say how much is missing between them."""
    if len(text) <= limit:
        return text
    half = max(limit - 40, 0) // 2
    missing = len(text) - 2 * half
    return f"{text[:half]} [... {missing:,} characters ...] {text[len(text) - half :]}"


def visible(character: str) -> str:
    """Replace a character that does not print by one that does, or by its code point."""
    category = unicodedata.category(character)
    if category in ("Zl", "Zp"):
        return "\n"
    if category == "Cf":
        return f"<U+{ord(character):04X}>"
    if category in ("Cc", "Cs", "Cn"):
        return REPLACEMENT
    return character

"""Texts that a submission may contain and that no format may let through unchanged."""

HOSTILE = {
    "markup": "v[red]x[/red] and [/tmp/x] [link=http://h]y[/link]",
    "html": "<script>alert(1)</script><img src=x onerror=alert(1)>",
    "colour": "\x1b[31mred\x1b[0m",
    "title": "\x1b]0;owned\x07after",
    "unfinished": "before\x1b]8;;http://h",
    "eight-bit": "\x9b31mred \x9d0;owned\x9cafter",
    "clear": "\x1b[2J\x1b[H\x1bcgone",
    "backspace": "12 of 50\x08\x08\x08\x08\x08\x0850 of 50\r50 of 50 points",
    "nul": "a\x00b\x7fc",
    "bidi": "\u202egnp.exe\u2066x\u2069\u200f",
    "invisible": "a\u200bb\ufeffc\u2060d\U000e0041",
    "surrogate": "a\ud800b\udfffc",
    "noncharacter": "a\uffffb",
    "separators": "a\u2028b\u2029c\x85d\x0be\x0cf",
    "workflow": "::error file=x::fooled\n::notice title=Autograding report::{}",
    "formula": '=HYPERLINK("http://h")',
    "long": "x" * 1_000_000,
    "wide": "\u6f22\u5b57" * 500,
    "empty": "",
}
"""Name and text."""

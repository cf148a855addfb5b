"""How is a stranger's text written so that the reader of a format takes it for text?

One function a format, and no other place escapes. Each makes the text visible first
(`grader.plain`) and then takes its power from what the format's own reader would act on.
"""

import html
import json
import re
from collections.abc import Iterable
from typing import Any

from grader.errors import OutputFault
from grader.plain import FIELD_LIMIT, one_line, printable

LARGEST_JSON = 900_000
"""Bytes of a result. PrairieLearn takes at most 1,048,576, Gradescope 100,000 a field."""

SHORTER = (FIELD_LIMIT, 1000, 250)
"""Characters that a text keeps in JSON: the first of these that fits `LARGEST_JSON`."""

_LOG_COMMAND = re.compile(r"##(?=\w*\[)")
_LINE_COMMAND = re.compile(r"^([^\S\n]*):(?=:.*::)", re.MULTILINE)
_STRING = re.compile(r'"(?:[^"\\]|\\.)*"')
_PUNCTUATION = re.compile(r"[!-/:-@\[-`{-~]")
_NUMBER = r"[+-][\d.]{1,30}(?:e[+-]?\d{1,3})?"
_SIGN = r"[=+\-@\uff1d\uff0b\uff0d\uff20]"
_INSIDE = rf""",\s*(?!{_NUMBER}[,)\]])|[;|"']\s*"""
"""Where a cell could begin inside of ours; the numbers of a vector are left alone."""

_FORMULA = re.compile(rf"(?:^(?!{_NUMBER}$)|{_INSIDE})(?={_SIGN})")  # nor is a number guarded
_FORMULA_IN_HTML = re.compile(rf"(^|{_INSIDE})({_SIGN}(?:\s*{_SIGN})*)")
"""All signs in a row: the reference of one ends with `;`, behind which the next would begin."""


def for_terminal(text: str, encoding: str = "utf-8") -> str:
    """Write text for a terminal, which may be the log of a workflow.

    A terminal obeys escape sequences and control characters (ECMA-48), which `printable`
    removes. A GitHub runner obeys `::name::` at the start of a line, after any white space, and
    `##[name]` anywhere in a line (actions/runner, ActionCommand.cs, TryParseV2 and TryParse);
    Azure and TeamCity obey `##vso[` and `##teamcity[`. A space in the middle breaks each.

    Args:
        text: A stranger's text.
        encoding: What the terminal lacks is written as its code before any width is counted.
    """
    return unheard(printable(text).encode(encoding, "backslashreplace").decode(encoding))


def line_for_terminal(text: str, encoding: str = "utf-8") -> str:
    """Write text for a terminal on one line."""
    return for_terminal(one_line(text), encoding)


def unheard(text: str) -> str:
    """Break what a workflow's runner would hear as a command."""
    return _LINE_COMMAND.sub(r"\1: ", _LOG_COMMAND.sub("# #", text))


def for_html(text: str) -> str:
    """Write text for HTML, as content of an element or of an attribute in quotes.

    A browser acts on `<`, `&` and the closing quote there (HTML Standard, 13.1.2.3 and 13.1.4).
    Nothing of a stranger's belongs into a comment, a style or a script; for data in a script
    there is `for_script`. Wrap names in `<bdi>`: a Hebrew letter turns its neighbours round.
    """
    return html.escape(printable(text), quote=True)


def for_xml(text: str) -> str:
    """Write text for XML 1.0, as content or as the value of an attribute in quotes.

    A parser acts on `<`, `&`, quotes and `]]>`, turns newlines and tabs of attributes into
    spaces (XML 1.0, 3.3.3) and refuses a file with control characters, surrogates or U+FFFE
    (2.2), none of which `printable` leaves.
    """
    return for_html(text).replace("\n", "&#10;").replace("\t", "&#9;")


def for_json(value: Any) -> str:  # noqa: ANN401 - any JSON value
    """Write a value as strict JSON (RFC 8259) of at most `LARGEST_JSON` bytes of UTF-8.

    Every text in it, keys included, becomes visible. NaN is refused. `##[` is spelled with an
    escape: a workflow that prints the file would hear a command, and a parser reads the same.

    Raises:
        OutputFault: The value holds too many texts, or a number that JSON lacks.
    """
    for limit in SHORTER:
        try:
            text = json.dumps(
                _shown(value, limit),
                indent=1,
                ensure_ascii=False,
                allow_nan=False,
                default=plain_number,
            )
        except ValueError as fault:
            raise OutputFault(f"A result holds what JSON cannot carry: {fault}.") from fault
        text = _LOG_COMMAND.sub(r"#\\u0023", text)
        if len(text.encode()) <= LARGEST_JSON:
            return text
    raise OutputFault(f"A result is larger than {LARGEST_JSON:,} bytes, however it is cut.")


def plain_number(value: Any) -> Any:  # noqa: ANN401 - any JSON value
    """Turn what JSON does not know into what it knows: a number or truth of numpy's.

    Arithmetic leaves them behind where nobody looks; they mean what Python's do.

    Raises:
        TypeError: It is something else.
    """
    if getattr(value, "ndim", None) == 0:
        return value.item()
    message = f"JSON has no {type(value).__name__}"
    raise TypeError(message)


def for_script(value: Any) -> str:  # noqa: ANN401 - any JSON value
    r"""Write a value as JSON inside an element `script` of an HTML file.

    A browser ends the script at `</script` and changes how it reads it at `<!--` (HTML
    Standard, 13.2.5.15 to 13.2.5.31), whatever the JSON says. Both begin with `<`, which stands
    in texts only, where `\u003c` means the same.
    """
    return inside_script(for_json(value))


def inside_script(text: str) -> str:
    """Write JSON so that no element `script` ends or changes in it: the same JSON."""
    text = text.replace("<", "\\u003c")
    return text.replace(">", "\\u003e").replace("&", "\\u0026")


def for_csv(text: str) -> str:
    """Write a cell of CSV, quotes included.

    A spreadsheet computes a cell that begins with `=`, `+`, `-`, `@` or their full-width forms,
    quoted or not (CWE-1236; OWASP, "CSV Injection"). One that splits the file at another sign
    than we wrote, as Excel does by country, begins new cells inside of ours. An apostrophe
    stands before each sign that could begin a formula there. A cell is one line.
    """
    guarded = _FORMULA.sub(r"\g<0>'", one_line(text))
    return '"' + guarded.replace('"', '""') + '"'


def for_workflow(text: str) -> str:
    """Write the message of a GitHub workflow command, behind its second `::`.

    The runner ends a command at the end of the line, and then decodes `%0D`, `%0A` and `%25`
    (actions/runner, ActionCommand.cs, UnescapeData).
    """
    plain = _LOG_COMMAND.sub("# #", printable(text))
    return plain.replace("%", "%25").replace("\r", "%0D").replace("\n", "%0A")


def for_workflow_property(text: str) -> str:
    """Write the value of a property of a workflow command: `file`, `title`.

    There `,` ends the property and `::` the list; the runner decodes `%3A` and `%2C` too
    (UnescapeProperty).
    """
    return for_workflow(text).replace(":", "%3A").replace(",", "%2C")


def for_autolab(value: Any) -> str:  # noqa: ANN401 - any JSON value
    r"""Write a value as JSON on one line that Autolab reads as its autoresult.

    Before it decodes that line, Autolab puts quotes around every `word:`, inside of texts too
    (assessment_autograde_core.rb, parseAutoresult). A colon within a text is spelled `\u003a`.
    """
    line = " ".join(for_json(value).split("\n"))
    return _STRING.sub(lambda text: text[0].replace(":", "\\u003a"), line)


def for_markdown(text: str) -> str:
    """Write text for GitHub's Markdown, on one line, also as a cell of a table.

    Every mark of ASCII becomes a character reference, which can never be markup (CommonMark,
    6.2; the same holds for the bars of a table). GitHub's own filters look at what is left for
    names, hashes and smileys, but not inside `code`, where a stranger's text belongs.
    """
    return _PUNCTUATION.sub(lambda found: f"&#{ord(found[0])};", one_line(text))


def code_for_markdown(text: str) -> str:
    """Write a stranger's text for GitHub's Markdown, on one line."""
    return f"<code>{for_markdown(text)}</code>"


def for_moodle(lines: Iterable[str]) -> str:
    """Write a cell of CSV that Moodle shows as HTML: feedback, one line below the other.

    Moodle keeps a feedback comment as HTML (assignfeedback_offline), so a stranger's `<` would
    begin an element there. What no longer fits into the cell is left out as whole lines. A sign
    that could begin a formula, as behind `&lt;` where a file is split at `;`, is written as its
    reference: it reads the same in Moodle, and `for_csv` finds nothing to guard.
    """
    kept: list[str] = []
    for line in map(_without_formulas, map(for_html, map(one_line, lines))):
        if len("<br>".join([*kept, line, "..."])) > FIELD_LIMIT:
            kept.append("...")
            break
        kept.append(line)
    return for_csv("<br>".join(kept))


def _without_formulas(line: str) -> str:
    """Write signs in HTML that could begin a formula as references."""

    def referred(found: re.Match[str]) -> str:
        signs = re.sub(_SIGN, lambda sign: f"&#{ord(sign[0])};", found[2])
        return f"{found[1]}{signs}"

    return _FORMULA_IN_HTML.sub(referred, line)


def _shown(value: Any, limit: int) -> Any:  # noqa: ANN401 - any JSON value
    """Make every text in a JSON value visible and short."""
    if isinstance(value, str):
        return printable(value, limit)
    if isinstance(value, dict):
        return {printable(name, limit): _shown(entry, limit) for name, entry in value.items()}
    if isinstance(value, list | tuple):
        return [_shown(entry, limit) for entry in value]
    return value

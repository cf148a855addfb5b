"""In which language is a message told? Catalogues in gettext's format, read without its tools.

The English text is the key, as gettext has it. `grader/locale/de.po` lies in the package as it
is edited; reading it takes some milliseconds, so nobody compiles it. Words of submissions and
of compilers are never looked up.
"""

import ast
import os
from collections.abc import Callable, Mapping
from functools import cache
from importlib.resources import files

LANGUAGES = ("en", "de")

Words = Callable[[str], str]
"""From an English text to the text that is shown."""


def translator(language: str) -> Words:
    """Return what translates English texts; those that the catalogue lacks stay English."""
    known = {} if language == "en" else catalogue(language)
    return lambda text: known.get(text, text)


def usual_language(environment: Mapping[str, str] = os.environ) -> str:
    """Choose a language as gettext does: by LC_ALL, else LC_MESSAGES, else LANG."""
    for name in ("LC_ALL", "LC_MESSAGES", "LANG"):
        if locale := environment.get(name):
            language = locale.partition("_")[0].partition(".")[0].lower()
            return language if language in LANGUAGES else "en"
    return "en"


@cache
def catalogue(language: str) -> Mapping[str, str]:
    """Read the catalogue of a language: English text to translation."""
    path = files("grader").joinpath("locale", f"{language}.po")
    return parsed(path.read_text(encoding="utf-8"))


def parsed(text: str) -> dict[str, str]:
    """Read a catalogue: entries of `msgid` and `msgstr`, each one or several strings."""
    entries: list[dict[str, str]] = []
    keyword = ""
    for line in map(str.strip, text.splitlines()):
        if line.startswith("msgid "):
            entries.append({"msgid": "", "msgstr": ""})
        if line.startswith(("msgid ", "msgstr ")):
            keyword, _, line = line.partition(" ")
        if line.startswith('"'):
            entries[-1][keyword] += ast.literal_eval(line)
    return {each["msgid"]: each["msgstr"] for each in entries if each["msgid"]}

"""Who handed in what, as Gradescope's `submission_metadata.yml` tells?

It is read by lines and not by a YAML parser: it holds the output of every submission there ever
was, hundreds of megabytes, and only a few lines of each entry matter. They come first:

    submission_123:
      :submitters:
      - :name: Ada Lovelace
        :sid: '9001'
        :email: ada@uni.example
"""

import json
import re
from collections.abc import Iterable
from dataclasses import dataclass

METADATA = "submission_metadata.yml"

_ENTRY = re.compile(r"(['\"]?)(submission_\w+)\1:\s*")
_LIST = re.compile(r"  :submitters:\s*")
_FIELD = re.compile(r"(  - |    ):(name|sid|email):(?: +(.*))?")
_OTHER = re.compile(r"  :\w+:.*")


@dataclass(frozen=True, slots=True)
class Submitter:
    """Somebody who handed in, as Gradescope knows them; empty where it says nothing."""

    name: str
    id: str
    email: str


def submitters(lines: Iterable[bytes]) -> dict[str, list[Submitter]]:
    """Map each folder to the people who handed it in."""
    found: dict[str, list[dict[str, str]]] = {}
    people: list[dict[str, str]] = []
    is_listing = False
    for raw in lines:
        line = raw[:4096].decode(errors="replace").rstrip("\r\n")
        if entry := _ENTRY.fullmatch(line):
            people = found.setdefault(entry[2], [])
            is_listing = False
        elif _LIST.fullmatch(line):
            is_listing = True
        elif is_listing and (field := _FIELD.fullmatch(line)):
            if field[1].strip():
                people.append({})
            if people:
                people[-1][field[2]] = _scalar(field[3] or "")
        elif _OTHER.fullmatch(line):
            is_listing = False
    return {folder: [_submitter(folder, one) for one in who] for folder, who in found.items()}


def _submitter(folder: str, said: dict[str, str]) -> Submitter:
    name, id, email = (said.get(field, "") for field in ("name", "sid", "email"))
    return Submitter(name or email or folder, id, email)


def _scalar(text: str) -> str:
    """Read a value as Ruby's YAML writes it: plain, in single or in double quotes."""
    text = text.strip()
    if len(text) >= 2 and text[0] == text[-1] == "'":
        return text[1:-1].replace("''", "'")
    if len(text) >= 2 and text[0] == text[-1] == '"':
        try:
            read = str(json.loads(re.sub(r"\\x([0-9A-Fa-f]{2})", r"\\u00\1", text)))
            # Half of a pair of surrogates is no character, and nothing could store it.
            return read.encode(errors="replace").decode()
        except ValueError:
            return text[1:-1]
    return "" if text in {"~", "null"} else text

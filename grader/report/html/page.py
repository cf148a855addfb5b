"""How does a template become one page that a browser trusts only with what is ours?

Style and script are ours and stand in the page; its policy names their hashes, so a browser
runs nothing else, whatever a name or a message of a compiler says. Templates escape every
value by themselves (jinja2), after it was made visible by `printable`.
"""

import base64
import hashlib
import json
from collections.abc import Mapping, Sequence
from functools import cache
from importlib.resources import files
from typing import TYPE_CHECKING

from grader.language import translator
from grader.plain import printable
from grader.report.escape import inside_script

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup

SIGNS = {
    "pass": ("p", "✓"),
    "fail": ("f", "✗"),
    "blocked": ("b", "\N{EN DASH}"),
    "broken": ("o", "!"),
}
"""Of each verdict: the class of its colours in `base.css`, and the sign that tells it without
colours."""

STYLES = {
    "class": ("base.css", "class.css"),
    "report": ("base.css", "report.css"),
    "similar": ("base.css", "similar.css"),
    "view": ("base.css", "report.css", "view.css"),
}
SCRIPTS = {
    "class": ("base.js", "class.js"),
    "report": ("base.js", "space.js", "walk.js", "report.js"),
    "similar": ("base.js",),
    "view": ("base.js", "space.js", "walk.js", "view.js"),
}
"""What stands in each page, in order."""

ASKING = {"view"}
"""Pages that talk to the program that served them; the others lie on a disk."""


def page(
    name: str, language: str, values: Mapping[str, object], data: Mapping[str, object]
) -> str:
    """Write a page.

    Args:
        name: Of the template.
        language: `en` or `de`.
        values: For the template; every text in them is escaped there.
        data: By the names of the template, JSON for its script.
    """
    from markupsafe import Markup

    style, script = joined(STYLES[name]), joined(SCRIPTS[name])
    encoded = {
        # Every `<` is spelled as an escape in it, so nothing ends the element.
        key: Markup(inside_script(json.dumps(value, separators=(",", ":"), allow_nan=False)))  # noqa: S704 - inert
        for key, value in data.items()
    }
    return (
        templates()
        .get_template(f"{name}.html")
        .render(
            **values,
            **encoded,
            _=translator(language),
            language=language,
            policy=policy(style, script, asks=name in ASKING),
            style=Markup(style),  # noqa: S704 - ours
            script=Markup(script),  # noqa: S704 - ours
        )
    )


def joined(names: Sequence[str]) -> str:
    """Join files of ours, without their comments and indentation."""
    lines = [line.strip() for name in names for line in source(name).splitlines()]
    return "\n".join(line for line in lines if line and not line.startswith("//"))


def policy(style: str, script: str, asks: bool = False) -> str:
    """Write a page's Content Security Policy: our style, our script, pictures inside it.

    Args:
        style: All of it.
        script: All of it.
        asks: Whether the script may ask the server that the page came from.

    Source: W3C, Content Security Policy Level 3, section 2.3.1, hash-source.
    """
    connects = "connect-src 'self'; " if asks else ""
    return (
        f"default-src 'none'; style-src '{_hash(style)}'; script-src '{_hash(script)}'; "
        f"{connects}img-src data: blob:; base-uri 'none'; form-action 'none'"
    )


def _hash(text: str) -> str:
    digest = hashlib.sha256(text.encode()).digest()
    return "sha256-" + base64.b64encode(digest).decode("ascii")


@cache
def source(name: str) -> str:
    """Read a file of ours that belongs to pages."""
    folder = files("grader.report.html").joinpath("templates")
    return folder.joinpath(name).read_text(encoding="utf-8")


@cache
def templates() -> "Environment":
    """Prepare the templates: undefined names are mistakes, all values are escaped."""
    from jinja2 import Environment, FunctionLoader, StrictUndefined

    environment = Environment(
        loader=FunctionLoader(source),
        autoescape=True,
        undefined=StrictUndefined,
        trim_blocks=True,
        keep_trailing_newline=True,
    )
    environment.finalize = _visible
    environment.filters["code"] = code
    return environment


def code(text: str) -> "Markup":
    """Write what stands between backticks as code; everything is escaped."""
    from markupsafe import Markup

    pieces = printable(text).split("`")
    if len(pieces) % 2 == 0:
        return Markup("{}").format(printable(text))
    plain, quoted = Markup("{}"), Markup("<code>{}</code>")
    return Markup("").join(
        (quoted if place % 2 else plain).format(piece) for place, piece in enumerate(pieces)
    )


def _visible(value: object) -> object:
    """Take control characters and the like out of plain texts."""
    return printable(value) if type(value) is str else value

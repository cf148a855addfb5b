"""How does one drawing become an SVG and a PNG? From the same few shapes."""

from collections.abc import Sequence
from dataclasses import dataclass
from io import BytesIO
from typing import TYPE_CHECKING
from xml.sax.saxutils import escape

if TYPE_CHECKING:
    from PIL import ImageDraw, ImageFont

SHARPNESS = 2
"""Pixels of the PNG for each unit of the drawing."""

FONT = "font-family='system-ui, sans-serif'"
PAPER = "#ffffff"


@dataclass(frozen=True, slots=True)
class Line:
    """From one point to another."""

    x: float
    y: float
    to_x: float
    to_y: float
    ink: str
    width: float = 1.0


@dataclass(frozen=True, slots=True)
class Box:
    """A filled rectangle, from its upper left corner."""

    x: float
    y: float
    width: float
    height: float
    ink: str


@dataclass(frozen=True, slots=True)
class Dot:
    """A filled circle around a point."""

    x: float
    y: float
    radius: float
    ink: str


@dataclass(frozen=True, slots=True)
class Label:
    """Text whose middle line is at y."""

    x: float
    y: float
    text: str
    ink: str
    anchor: str = "start"
    """`start`, `middle` or `end`: which part of the text is at x."""

    size: int = 12


Shape = Line | Box | Dot | Label


@dataclass(frozen=True, slots=True)
class Drawing:
    """Shapes on white paper, the later ones on top."""

    width: int
    height: int
    title: str
    """For those who do not see it."""

    shapes: Sequence[Shape]


def svg_of(drawing: Drawing) -> str:
    """Return a drawing as a file of text."""
    size = f"viewBox='0 0 {drawing.width} {drawing.height}'"
    head = f"<svg xmlns='http://www.w3.org/2000/svg' {size} role='img' {FONT}>"
    paper = Box(0, 0, drawing.width, drawing.height, PAPER)
    body = [_element(shape) for shape in (paper, *drawing.shapes)]
    return "\n".join([head, f"<title>{escape(drawing.title)}</title>", *body, "</svg>", ""])


def _element(shape: Shape) -> str:
    match shape:
        case Line(x, y, to_x, to_y, ink, width):
            ends = f"x1='{x:.1f}' y1='{y:.1f}' x2='{to_x:.1f}' y2='{to_y:.1f}'"
            return f"<line {ends} stroke='{ink}' stroke-width='{width}'/>"
        case Box(x, y, width, height, ink):
            place = f"x='{x:.1f}' y='{y:.1f}' width='{width:.1f}' height='{height:.1f}'"
            return f"<rect {place} fill='{ink}'/>"
        case Dot(x, y, radius, ink):
            return f"<circle cx='{x:.1f}' cy='{y:.1f}' r='{radius}' fill='{ink}'/>"
        case Label(x, y, text, ink, anchor, size):
            place = f"x='{x:.1f}' y='{y:.1f}' text-anchor='{anchor}' font-size='{size}'"
            middle = "dominant-baseline='central'"
            return f"<text {place} {middle} fill='{ink}'>{escape(text)}</text>"


def png_of(drawing: Drawing) -> bytes:
    """Return a drawing as a picture, twice as sharp as it is large."""
    from PIL import Image, ImageDraw

    size = (SHARPNESS * drawing.width, SHARPNESS * drawing.height)
    picture = Image.new("RGB", size, PAPER)
    pen = ImageDraw.Draw(picture)
    for shape in drawing.shapes:
        _draw(pen, shape)
    file = BytesIO()
    # Few colours: a palette makes the file a third as large.
    picture.quantize(64).save(file, "PNG", optimize=True)
    return file.getvalue()


def _draw(pen: "ImageDraw.ImageDraw", shape: Shape) -> None:
    s = SHARPNESS
    match shape:
        case Line(x, y, to_x, to_y, ink, width):
            pen.line((s * x, s * y, s * to_x, s * to_y), ink, max(1, round(s * width)))
        case Box(x, y, width, height, ink):
            pen.rectangle((s * x, s * y, s * (x + width), s * (y + height)), ink)
        case Dot(x, y, radius, ink):
            pen.ellipse(
                (s * (x - radius), s * (y - radius), s * (x + radius), s * (y + radius)), ink
            )
        case Label(x, y, text, ink, anchor, size):
            place = {"start": "lm", "middle": "mm", "end": "rm"}[anchor]
            pen.text((s * x, s * y), text, ink, font_of(s * size), place)


def font_of(size: int) -> "ImageFont.FreeTypeFont | ImageFont.ImageFont":
    """Return Pillow's own font, the same on every machine."""
    from PIL import ImageFont

    return ImageFont.load_default(size)

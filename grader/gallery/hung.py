"""Which scenes can be shown, and where do they lie?"""

from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path

from grader.gallery.shading import displayed
from grader.model.cases import ImageCase, TreeCase
from grader.model.mesh import Bytes
from grader.model.scene import NO_FACE, Scene
from grader.model.trials import ImageTrial
from grader.oracle.remember import digest_of, remember
from grader.oracle.scenes import folder_sha256, load_mesh, scenes, usable_reference


@dataclass(frozen=True, slots=True)
class Hung:
    """One scene, and where it is."""

    scene: Scene
    folder: Path | None
    """None for the shipped one."""

    content: str
    """Hash of all that lies in the folder."""


@dataclass(frozen=True, slots=True)
class Exhibit:
    """A scene, and what the submission delivered of it."""

    place: Hung
    trial: ImageTrial
    seen: ImageCase | None
    """None if the submission brought no picture."""

    built: TreeCase | None
    """Its own tree over the scene's mesh; None if there is none."""


def hung(own: Path | None) -> Iterator[Hung]:
    """List the shipped scenes, and then those of a course's own folder."""
    for folder in (None,) if own is None else (None, own):
        content = folder_sha256(folder)
        yield from (Hung(scene, folder, content) for scene in scenes(folder))


def key_of(one: Hung, *more: object) -> str:
    """Name in the cache what depends on a scene and its folder, and on more."""
    return digest_of("gallery", one.content, one.scene.name, *more)


def reference_picture(one: Hung) -> Bytes:
    """Return (H, W, 3) uint8, sRGB, what Mitsuba rendered."""
    scene = one.scene

    def encoded() -> Bytes:
        mesh = load_mesh(scene.mesh, one.folder)
        stored = usable_reference(scene, mesh, one.folder)
        return displayed(stored.shaded, stored.face != NO_FACE)

    picture: Bytes = remember(key_of(one, "displayed"), encoded)
    return picture.reshape(scene.height, scene.width, 3)

"""How is a reference picture stored? As a multi-channel EXR that knows what it belongs to.

Theory of operation. All channels are lossless: `t`, `face`, `origin`, `direction`, `point`,
`normal` and the shaded colours. The header carries the key of the scene (mesh, camera, light,
size), the programs that rendered it, and a hash of the pixels. A picture is used only if the
key is the scene's and the hash is the pixels', so neither an old nor a broken file can grade.
ZSTD took 3.9 MB of the dragon's picture, PIZ 6.3 MB, ZIP 6.7 MB, RLE 10.7 MB.
"""

import hashlib
import json
from collections.abc import Mapping
from dataclasses import asdict
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from grader.errors import MissingTool, OracleFault, OutputFault
from grader.model.mesh import Floats, Mesh, Rays
from grader.model.scene import Reference, Scene
from grader.oracle.storage import mesh_sha256

FORMAT = "1"
"""Goes up with every change in what the channels mean; other pictures are refused."""

Channels = dict[str, np.ndarray[Any, Any]]
"""Channel name -> (height, width) float32, of `face` uint32."""

OLDEST_MINOR = 9
"""Of Mitsuba 3; the extra `render` installs no older one."""

MADE_WITH = ("mitsuba", "drjit", "variant")
VECTORS = ("origin", "direction", "point", "normal")


def scene_key(scene: Scene, mesh: Mesh) -> str:
    """Hash everything that a picture of this scene depends on, its mesh byte by byte."""
    names = ("camera", "light", "albedo", "width", "height")
    described = {name: value for name, value in asdict(scene).items() if name in names}
    text = json.dumps([FORMAT, described, mesh_sha256(mesh)], sort_keys=True)
    return hashlib.sha256(text.encode()).hexdigest()


def write_reference(path: Path, scene: Scene, reference: Reference) -> None:
    """Store a picture of a scene.

    Raises:
        OutputFault: The file cannot be written.
    """
    exr = _openexr()
    channels = _channels(scene, reference)
    header = {
        "compression": exr.ZSTD_COMPRESSION,
        "type": exr.scanlineimage,
        "bvhgrade.format": FORMAT,
        "bvhgrade.scene": scene.name,
        "bvhgrade.key": reference.key,
        "bvhgrade.pixels": _pixels_sha256(channels),
        **{f"bvhgrade.{program}": version for program, version in reference.made_with},
    }
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
        with TemporaryDirectory(prefix=".", dir=path.parent) as beside:
            with exr.File(header, channels) as picture:
                picture.write(str(Path(beside) / path.name))
            (Path(beside) / path.name).replace(path)
    except (OSError, RuntimeError) as fault:
        message = f"{path}: the reference picture cannot be written ({fault})"
        raise OutputFault(message) from fault


def read_reference(path: Path, scene: Scene, mesh: Mesh, command: str) -> Reference:
    """Read the picture of a scene.

    Args:
        path: The file.
        scene: What it has to show.
        mesh: The scene's mesh.
        command: Renders it anew; for messages.

    Raises:
        OracleFault: It is missing, damaged, or of another scene, mesh, format or Mitsuba.
    """
    again = f"render it anew with `{command}`"
    if not path.is_file():
        raise OracleFault(f"scene {scene.name}: {path.name} is missing; {again}")
    header, channels = _read(path, again)
    _refuse_stale(header, scene_key(scene, mesh), f"scene {scene.name}: {path.name}", again)
    if header.get("bvhgrade.pixels") != _pixels_sha256(channels):
        message = "has other pixels than were written, the file is damaged"
        raise OracleFault(f"scene {scene.name}: {path.name} {message}; {again}")
    return _reference(header, channels)


def _refuse_stale(header: Mapping[str, Any], key: str, what: str, again: str) -> None:
    """Raise if the picture has another format or belongs to another scene."""
    found = str(header.get("bvhgrade.format"))
    if found != FORMAT:
        raise OracleFault(f"{what} has format {found}, but this grader reads {FORMAT}; {again}")
    found = str(header.get("bvhgrade.mitsuba"))
    if not _is_trusted(found):
        raise OracleFault(
            f"{what} was rendered by Mitsuba {found}, but only 3.{OLDEST_MINOR} and later "
            f"versions of Mitsuba 3 were compared with the rule of closest hits; {again}"
        )
    found = str(header.get("bvhgrade.key"))
    if found != key:
        raise OracleFault(
            f"{what} was rendered of scene {found[:12]}, but mesh, camera, light and size now "
            f"give {key[:12]}; {again}"
        )


def _is_trusted(version: str) -> bool:
    """Whether pictures of this version of Mitsuba are used, on every machine alike."""
    major, _, rest = version.partition(".")
    minor = rest.partition(".")[0]
    return major == "3" and minor.isdecimal() and int(minor) >= OLDEST_MINOR


def _read(path: Path, again: str) -> tuple[Mapping[str, Any], Channels]:
    """Read header and pixels, of which nothing is trusted yet."""
    exr = _openexr()
    try:
        with exr.File(str(path), separate_channels=True) as picture:
            header = dict(picture.header())
            channels = {
                name: np.array(channel.pixels) for name, channel in picture.channels().items()
            }
    except (OSError, RuntimeError, ValueError) as fault:
        message = f"{path.name} is not a readable EXR ({fault}), the file is damaged; {again}"
        raise OracleFault(message) from fault
    return header, channels


def _pixels_sha256(channels: Channels) -> str:
    """Hash names and bytes of all channels."""
    digest = hashlib.sha256()
    for name in sorted(channels):
        digest.update(name.encode())
        digest.update(np.ascontiguousarray(channels[name]).data)
    return digest.hexdigest()


def _channels(scene: Scene, reference: Reference) -> Channels:
    """Spread the picture over the channels of an EXR."""
    size = (scene.height, scene.width)
    vectors = {
        "origin": reference.rays.origin,
        "direction": reference.rays.direction,
        "point": reference.point,
        "normal": reference.normal,
    }
    columns = {"t": reference.t, "face": reference.face}
    for name in VECTORS:
        columns |= {f"{name}.{axis}": vectors[name][:, k] for k, axis in enumerate("XYZ")}
    columns |= {colour: reference.shaded[:, k] for k, colour in enumerate("RGB")}
    columns["t_min"], columns["t_max"] = reference.rays.t_min, reference.rays.t_max
    return {
        name: np.ascontiguousarray(values).reshape(size) for name, values in columns.items()
    }


def _reference(header: Mapping[str, Any], channels: Channels) -> Reference:
    """Collect the picture from the channels of an EXR."""
    flat = {name: values.ravel() for name, values in channels.items()}

    def three(*names: str) -> Floats:
        return np.stack([flat[name] for name in names], axis=1)

    origin, direction, point, normal = (
        three(*(f"{name}.{axis}" for axis in "XYZ")) for name in VECTORS
    )
    return Reference(
        key=str(header["bvhgrade.key"]),
        made_with=tuple(
            (name, str(header.get(f"bvhgrade.{name}", "unknown"))) for name in MADE_WITH
        ),
        rays=Rays(origin=origin, direction=direction, t_min=flat["t_min"], t_max=flat["t_max"]),
        t=flat["t"],
        point=point,
        normal=normal,
        face=flat["face"],
        shaded=three("R", "G", "B"),
    )


def _openexr() -> Any:  # noqa: ANN401 - the package has no types
    """Import OpenEXR."""
    try:
        import OpenEXR
    except ImportError as fault:
        message = f"OpenEXR cannot be imported ({fault}); install the Python package OpenEXR"
        raise MissingTool(message) from fault
    return OpenEXR

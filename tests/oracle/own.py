"""A course's own folder of scenes, as small as one can be: what tests of it start from."""

from pathlib import Path

from grader.oracle.generated import soup
from grader.oracle.storage import mesh_sha256, save_mesh

MESH = soup(60, 5)

TOML = f"""[[mesh]]
name = "few"
source = "few.obj"
sha256 = "{mesh_sha256(MESH)}"

[[mesh]]
name = "made"
generator = {{ name = "soup", faces = 60, seed = 5 }}
sha256 = "{mesh_sha256(MESH)}"

[[scene]]
name = "our-few"
title = "a few triangles"
mesh = "few"
width = 16
height = 20
camera = {{ origin = [0.0, 0.0, 5.0], target = [0.0, 0.0, 0.0], up = [0, 1, 0], fov = 30 }}
light = [0.0, -1.0, -1.0]
albedo = [0.5, 0.5, 0.5]
weight = 2.5
visibility = "hidden"

[[scene]]
name = "our-made"
title = "made anew"
mesh = "made"
width = 16
height = 16
camera = {{ origin = [0.0, 0.0, 5.0], target = [0.0, 0.0, 0.0], up = [0, 1, 0], fov = 30 }}
light = [0.0, -1.0, -1.0]
albedo = [0.5, 0.5, 0.5]
"""


def own_folder(beside: Path, toml: str = TOML) -> Path:
    """Make a folder of two scenes, without references."""
    folder = beside / "ours"
    folder.mkdir()
    (folder / "scenes.toml").write_text(toml, encoding="utf-8")
    save_mesh(folder / "few.npz", MESH)
    return folder

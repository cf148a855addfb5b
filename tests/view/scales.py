"""Draws one mesh and its boxes at several sizes, and writes down whether they look alike.

Run by a test in a process of its own: OpenGL stays in one until its end.
"""

import sys
from dataclasses import replace

import moderngl
import numpy as np

from grader.model.mesh import Bytes, Mesh
from grader.oracle.meshes import mesh_named
from grader.view.preview import Preview
from grader.view.screenshot import surfaceless
from grader.view.shades import BACKGROUND
from grader.view.subject import around
from tests.verify.builder import build

SIZE = (96, 96)


def drawn(preview: Preview, scale: float) -> list[Bytes]:
    """Draw a mesh without its boxes, and with them."""
    usual = mesh_named(41, "terrain-600")
    mesh = Mesh((usual.vertices * scale).astype(np.float32), usual.faces)
    tree = build(usual)
    preview.load("whole", mesh)
    low, high = ((side * scale).astype(np.float32) for side in (tree.low, tree.high))
    preview.load_tree(replace(tree, low=low, high=high))
    pictures = []
    for level in (-1, 2):
        preview.draw(around(mesh), SIZE, level, only=False, moving=False)
        pictures.append(preview.pixels())
    return pictures


def main(scales: list[float]) -> None:
    """Compare each size with the usual one."""
    preview = Preview(surfaceless())
    faces, boxes = drawn(preview, 1.0)
    assert (faces != BACKGROUND).any(axis=2).mean() > 0.1
    assert (boxes != faces).any(axis=2).mean() > 0.02
    for scale in scales:
        for one, other in zip((faces, boxes), drawn(preview, scale), strict=True):
            alike = (np.abs(one.astype(int) - other) < 16).all(axis=2).mean()
            sys.stdout.write(f"{alike:.3f}\n")
    texture = preview.texture
    preview.release()
    assert texture is not None
    assert isinstance(texture.mglo, moderngl.InvalidObject)


if __name__ == "__main__":
    main([float(scale) for scale in sys.argv[1:]])

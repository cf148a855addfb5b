"""How is a mesh kept in the repository? Lossless, compact, and quick to load.

Theory of operation. An `.npz` file holds two arrays of bytes. Vertices (their bits, column by
column) and faces (row by row) are sequences of 32-bit words; neighbours differ little, so each
word is stored as the difference to the one before it, zigzag coded (0, -1, 1, -2, ... become
0, 1, 2, 3, ...) to keep the upper bytes zero, and all lowest bytes come first, then all second
ones, and so on. Deflate then needs 37 % of the plain size, and nothing is rounded.
"""

import hashlib
import zlib
from pathlib import Path
from zipfile import BadZipFile

import numpy as np

from grader.errors import OracleFault
from grader.model.mesh import Bytes, Indices, Mesh


def save_mesh(path: Path, mesh: Mesh) -> None:
    """Write a mesh losslessly."""
    columns = np.ascontiguousarray(mesh.vertices.T).view(np.uint32).ravel()
    np.savez_compressed(path, vertices=packed(columns), faces=packed(mesh.faces.ravel()))


def load_mesh_file(path: Path) -> Mesh:
    """Read a mesh that `save_mesh` wrote.

    Raises:
        OracleFault: The file is missing or damaged.
    """
    try:
        with path.open("rb") as file, np.load(file) as arrays:
            columns, faces = unpacked(arrays["vertices"]), unpacked(arrays["faces"])
    except (OSError, EOFError, KeyError, ValueError, BadZipFile, zlib.error) as fault:
        message = f"{path.name}: the stored mesh cannot be read ({fault}); restore the file"
        raise OracleFault(message) from fault
    vertices = np.ascontiguousarray(columns.view(np.float32).reshape(3, -1).T)
    return Mesh(vertices=vertices, faces=faces.reshape(-1, 3))


def mesh_sha256(mesh: Mesh) -> str:
    """Hash the bytes of a mesh: vertices, then faces."""
    digest = hashlib.sha256(np.ascontiguousarray(mesh.vertices).data)
    digest.update(np.ascontiguousarray(mesh.faces).data)
    return digest.hexdigest()


def packed(words: Indices) -> Bytes:
    """Turn (n,) uint32 words into (4, n) uint8, their zigzag coded differences."""
    step = np.diff(words, prepend=np.uint32(0)).view(np.int32)
    coded = ((step << 1) ^ (step >> 31)).astype("<u4")
    return np.ascontiguousarray(coded.view(np.uint8).reshape(-1, 4).T)


def unpacked(planes: Bytes) -> Indices:
    """Undo `packed`: (4, n) uint8 become (n,) uint32."""
    coded = np.ascontiguousarray(planes.T).view("<u4").ravel().astype(np.uint32)
    step = (coded >> np.uint32(1)) ^ (np.uint32(0) - (coded & np.uint32(1)))
    return np.cumsum(step, dtype=np.uint32)

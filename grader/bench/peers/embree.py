"""Times Embree through its C API, in one thread: `python -m ... FILE LOOP`.

FILE is an .npz with `vertices`, `faces`, and for each kind of rays one (R, 8) table; LOOP is a
library with `trace` of `embree_loop.c`. Prints CPU seconds as JSON. The numbers behind the
names are those of Embree 4's rtcore_common.h, rtcore_buffer.h and rtcore_scene.h.
"""

import ctypes
import json
import sys
import time
from importlib.util import find_spec
from pathlib import Path

import numpy as np
import numpy.typing as npt

TRIANGLES, INDEX_BUFFER, VERTEX_BUFFER = 0, 0, 1
UINT3, FLOAT3 = 0x5003, 0x9003
ROBUST, MEDIUM = 1 << 2, 1
RAY_WORDS = 24
"""RTCRayHit has 96 bytes: twelve words of a ray, and a hit that begins with the next."""

NO_GEOMETRY = 0xFFFFFFFF
GEOMETRY_WORD = 18


def libraries() -> tuple[Path, Path] | None:
    """Where the wheel of embreex keeps TBB and Embree; None without them."""
    spec = find_spec("embreex")
    if spec is None or spec.origin is None:
        return None
    folder = Path(spec.origin).parents[1] / "embreex.libs"
    found = [sorted(folder.glob(f"{name}*")) for name in ("libtbb", "libembree4")]
    return (found[0][0], found[1][0]) if all(found) else None


def opened() -> ctypes.CDLL:
    """Load Embree, with the types of what is called."""
    paths = libraries()
    if paths is None:
        raise SystemExit("embreex has no Embree 4 in it")
    ctypes.CDLL(str(paths[0]), ctypes.RTLD_GLOBAL)
    embree = ctypes.CDLL(str(paths[1]))
    pointer, number, size = ctypes.c_void_p, ctypes.c_uint, ctypes.c_size_t
    for name in ("rtcNewDevice", "rtcNewScene", "rtcNewGeometry"):
        getattr(embree, name).restype = pointer
    embree.rtcNewDevice.argtypes = [ctypes.c_char_p]
    embree.rtcNewScene.argtypes = embree.rtcCommitGeometry.argtypes = [pointer]
    embree.rtcCommitScene.argtypes = embree.rtcReleaseScene.argtypes = [pointer]
    embree.rtcReleaseGeometry.argtypes = [pointer]
    embree.rtcNewGeometry.argtypes = [pointer, ctypes.c_int]
    embree.rtcSetSceneFlags.argtypes = embree.rtcSetSceneBuildQuality.argtypes = [
        pointer,
        ctypes.c_int,
    ]
    embree.rtcAttachGeometry.argtypes = [pointer, pointer]
    embree.rtcSetSharedGeometryBuffer.argtypes = [
        *(pointer, ctypes.c_int, number, ctypes.c_int),
        *(pointer, size, size, size),
    ]
    return embree


def scene_of(
    embree: ctypes.CDLL, vertices: npt.NDArray[np.float32], faces: npt.NDArray[np.uint32]
) -> tuple[int, float]:
    """Build a scene of medium quality, robust.

    Args:
        embree: The library.
        vertices: (V, 3) float32.
        faces: (F, 3) uint32, vertex indices.

    Returns:
        Its address, and the CPU seconds that it took.
    """
    device = embree.rtcNewDevice(b"threads=1")
    v = np.zeros((len(vertices) + 1, 3), np.float32)  # one to spare, as it asks for
    v[:-1] = vertices
    f = np.ascontiguousarray(faces, np.uint32)
    begun = time.process_time()
    scene = embree.rtcNewScene(device)
    embree.rtcSetSceneFlags(scene, ROBUST)
    embree.rtcSetSceneBuildQuality(scene, MEDIUM)
    geometry = embree.rtcNewGeometry(device, TRIANGLES)
    for kind, form, array, count in (
        (VERTEX_BUFFER, FLOAT3, v, len(v) - 1),
        (INDEX_BUFFER, UINT3, f, len(f)),
    ):
        embree.rtcSetSharedGeometryBuffer(
            geometry, kind, 0, form, array.ctypes.data, 0, 12, count
        )
    embree.rtcCommitGeometry(geometry)
    embree.rtcAttachGeometry(scene, geometry)
    embree.rtcCommitScene(scene)
    taken = time.process_time() - begun
    _kept.extend((v, f))
    return int(scene), taken


_kept: list[npt.NDArray[np.generic]] = []
"""What Embree only borrows."""


def trace(
    loop: ctypes.CDLL, embree: ctypes.CDLL, scene: int, rays: npt.NDArray[np.float32]
) -> tuple[float, float]:
    """Trace (R, 8) float32 rays one by one; return CPU seconds, and the share that hits."""
    room = np.zeros(len(rays) * RAY_WORDS + 4, np.float32)
    shift = -room.ctypes.data % 16 // 4
    table = room[shift : shift + len(rays) * RAY_WORDS].reshape(-1, RAY_WORDS)
    table[:, 0:3], table[:, 3] = rays[:, 0:3], rays[:, 6]
    table[:, 4:7], table[:, 8] = rays[:, 3:6], rays[:, 7]
    words = table.view(np.uint32)
    words[:, 9] = 0xFFFFFFFF  # the mask: every geometry
    words[:, 17:21] = NO_GEOMETRY
    address = ctypes.cast(embree.rtcIntersect1, ctypes.c_void_p)
    begun = time.process_time()
    loop.trace(
        address,
        ctypes.c_void_p(scene),
        ctypes.c_void_p(table.ctypes.data),
        ctypes.c_size_t(len(rays)),
    )
    taken = time.process_time() - begun
    return taken, float((words[:, GEOMETRY_WORD] != NO_GEOMETRY).mean())


def main() -> None:
    """Build the scene, trace every table, print what they took."""
    given, loop_path = sys.argv[1:3]
    embree, loop = opened(), ctypes.CDLL(loop_path)
    with np.load(given) as file:
        arrays = dict(file)
    scene, build = scene_of(embree, arrays.pop("vertices"), arrays.pop("faces"))
    found: dict[str, float] = {"construct": build}
    for name, rays in arrays.items():
        found[name], found[f"{name} hits"] = trace(loop, embree, scene, rays)
    print(json.dumps(found))  # noqa: T201 - it is a program


if __name__ == "__main__":
    main()

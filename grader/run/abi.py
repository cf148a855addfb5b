"""How does a worker call a compiled submission? By these functions of exercise03_abi.h.

Used inside the worker, so it uses the standard library only.
"""

import ctypes

VERSION = 3
SIZES = (12, 12, 32, 32, 28, 60)
"""Bytes of a point, face, node, ray, hit and step."""

_POINTER = ctypes.c_void_p
_COUNT = ctypes.c_uint64
_STATUS = ctypes.c_int32

_FUNCTIONS = {
    "ex03_abi_version": (ctypes.c_uint32, ()),
    "ex03_size_of": (_COUNT, (ctypes.c_uint32,)),
    "ex03_mesh_create": (_POINTER, (_POINTER, _COUNT, _POINTER, _COUNT)),
    "ex03_mesh_replace": (_STATUS, (_POINTER, _POINTER, _COUNT, _POINTER, _COUNT)),
    "ex03_mesh_bvh": (_POINTER, (_POINTER,)),
    "ex03_copy_vertices": (_COUNT, (_POINTER, _POINTER, _COUNT)),
    "ex03_copy_faces": (_COUNT, (_POINTER, _POINTER, _COUNT)),
    "ex03_bvh_create": (_POINTER, ()),
    "ex03_construct": (_STATUS, (_POINTER, _POINTER)),
    "ex03_copy_nodes": (_COUNT, (_POINTER, _POINTER, _COUNT)),
    "ex03_copy_face_indices": (_COUNT, (_POINTER, _POINTER, _COUNT)),
    "ex03_set_tree": (_STATUS, (_POINTER, _POINTER, _COUNT, _POINTER, _COUNT)),
    "ex03_intersect": (_STATUS, (_POINTER, _POINTER)),
    "ex03_intersect_threads": (_STATUS, (_POINTER, _POINTER, ctypes.c_uint32)),
    "ex03_record": (_STATUS, (_POINTER, _POINTER)),
    "ex03_last_error": (_COUNT, (_POINTER, _COUNT)),
}


LARGEST_STACK = 1 << 26
"""Beyond that AddressSanitizer cleans up no frames."""


class Batch(ctypes.Structure):
    """Rays to trace and where the results go; all fields but `count` are addresses."""

    _fields_ = (
        ("rays", ctypes.c_void_p),
        ("count", ctypes.c_uint64),
        ("hits", ctypes.c_void_p),
        ("tests", ctypes.c_void_p),
        ("done", ctypes.c_void_p),
    )


class Recording(ctypes.Structure):
    """A ray to trace and where its hit and its steps go; all fields but one are addresses."""

    _fields_ = (
        ("ray", ctypes.c_void_p),
        ("hit", ctypes.c_void_p),
        ("steps", ctypes.c_void_p),
        ("capacity", ctypes.c_uint64),
        ("count", ctypes.c_void_p),
    )


class Mismatch(Exception):
    """The library was built from another version of the framework."""


def load(path: str) -> ctypes.CDLL:
    """Load a library and declare its functions.

    Raises:
        OSError: The library cannot be loaded.
        Mismatch: It has another version, or other sizes, than this file mirrors.
    """
    _tell_stack(ctypes.CDLL(None))
    library = ctypes.CDLL(path)
    for name, (result, arguments) in _FUNCTIONS.items():
        function = getattr(library, name)
        function.restype = result
        function.argtypes = arguments
    sizes = tuple(library.ex03_size_of(what) for what in range(len(SIZES)))
    if library.ex03_abi_version() != VERSION or sizes != SIZES:
        message = f"version {library.ex03_abi_version()}, sizes {sizes}"
        raise Mismatch(message)
    return library


def _tell_stack(process: ctypes.CDLL) -> None:
    """Tell AddressSanitizer, where it is in the process, where the main thread's stack lies.

    It reads that in /proc, which the box does not have. Without it, it keeps no frames of
    functions that have returned, and takes frames that an exception left for ones in use.
    """
    if not hasattr(process, "__sanitizer_start_switch_fiber"):
        return
    # Only workers under sanitizers pay for the import.
    import resource

    try:
        top = ctypes.c_void_p.in_dll(process, "__libc_stack_end").value
    except ValueError:
        top = None
    if top is None:
        return  # no glibc: it finds less, and nobody is blamed for that
    limit, _ = resource.getrlimit(resource.RLIMIT_STACK)
    size = LARGEST_STACK if limit == resource.RLIM_INFINITY else min(limit, LARGEST_STACK)
    bottom = ctypes.c_void_p(top - size)
    process.__sanitizer_start_switch_fiber(None, bottom, ctypes.c_size_t(size))
    process.__sanitizer_finish_switch_fiber(None, None, None)


def address(memory: memoryview) -> int:
    """Address of the first byte of a writable buffer."""
    return ctypes.addressof(ctypes.c_char.from_buffer(memory))

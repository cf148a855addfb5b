"""What runs in the process that holds a submission: carries out rows, decides nothing.

enter.py imports it, confines the process and calls `main` with the library and the descriptors
of input and result. It knows no expected value, no seed and no name of a check. Whatever the
submission does to this process, the grader trusts only what it can verify in the result file
afterwards.
"""

from __future__ import annotations

import ctypes
import mmap
import os

# A constant that type checkers know: `typing` and `collections` would cost every worker 8 ms.
TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Callable, Sequence
    from typing import TypeVar

    from grader.run import abi, protocol
    from grader.run.protocol import Op, Status

    Kind = TypeVar("Kind", bound="Worker")
else:
    # The package is out of reach here: the two files beside this one are all that is needed.
    import abi
    import protocol
    from protocol import Op, Status


class Worker:
    """One library, one input, one result, and the slots that rows refer to."""

    def __init__(self, library: str, given: mmap.mmap, result: mmap.mmap) -> None:
        self.given = given
        self.result = result
        # A private mapping is writable for ctypes, but no write reaches the sealed file.
        self.source = abi.address(memoryview(given))
        self.target = abi.address(memoryview(result))
        self.slots: list[tuple[int, int]] = []
        self.library = abi.load(library)
        self.actions: dict[int, tuple[Callable[..., int], int]] = {
            Op.MESH: (self.mesh, 4),
            Op.TREE: (self.tree, 0),
            Op.CONSTRUCT: (self.construct, 2),
            Op.READ_TREE: (self.read_tree, 6),
            Op.READ_MESH: (self.read_mesh, 6),
            Op.SET_TREE: (self.set_tree, 5),
            Op.TRACE: (self.trace, 7),
            Op.RECORD: (self.record, 6),
            Op.REPLACE: (self.replace, 5),
        }
        """Each operation and how many of a row's numbers are its arguments."""

    def mesh(self, vertices: int, vertex_count: int, faces: int, face_count: int) -> int:
        """Make a mesh and its tree: the next slot."""
        made = self.library.ex03_mesh_create(
            self.source + vertices, vertex_count, self.source + faces, face_count
        )
        if not made:
            return Status.OUT_OF_MEMORY
        self.slots.append((made, self.library.ex03_mesh_bvh(made)))
        return Status.OK

    def replace(self, slot: int, vertices: int, count: int, faces: int, face_count: int) -> int:
        """Put other arrays where a mesh lies; its tree is empty then."""
        given = (self.source + vertices, count, self.source + faces, face_count)
        return int(self.library.ex03_mesh_replace(self.slots[slot][0], *given))

    def tree(self) -> int:
        """Make a tree without a mesh: the next slot."""
        self.slots.append((0, self.library.ex03_bvh_create()))
        return Status.OK

    def construct(self, tree: int, mesh: int) -> int:
        """Call the submission's `construct`."""
        return int(self.library.ex03_construct(self.slots[tree][1], self.slots[mesh][0]))

    def read_tree(self, *row: int) -> int:
        """Copy nodes and face indices into the result."""
        slot, nodes, node_capacity, order, order_capacity, counts = row
        tree = self.slots[slot][1]
        self.put(
            counts,
            self.library.ex03_copy_nodes(tree, self.target + nodes, node_capacity),
            self.library.ex03_copy_face_indices(tree, self.target + order, order_capacity),
        )
        return Status.OK

    def read_mesh(self, *row: int) -> int:
        """Copy vertices and faces into the result."""
        slot, vertices, vertex_capacity, faces, face_capacity, counts = row
        mesh = self.slots[slot][0]
        self.put(
            counts,
            self.library.ex03_copy_vertices(mesh, self.target + vertices, vertex_capacity),
            self.library.ex03_copy_faces(mesh, self.target + faces, face_capacity),
        )
        return Status.OK

    def set_tree(self, slot: int, nodes: int, count: int, order: int, faces: int) -> int:
        """Replace a tree by one from the input."""
        return int(
            self.library.ex03_set_tree(
                self.slots[slot][1], self.source + nodes, count, self.source + order, faces
            )
        )

    def trace(self, *row: int) -> int:
        """Call the submission's `intersect` for all rays, in one thread or in several."""
        slot, rays, count, hits, tests, done, threads = row
        batch = abi.Batch(
            self.source + rays,
            count,
            self.target + hits,
            self.target + tests if tests else None,
            self.target + done,
        )
        mesh = self.slots[slot][0]
        pointer = ctypes.byref(batch)
        if threads == 1:
            return int(self.library.ex03_intersect(mesh, pointer))
        return int(self.library.ex03_intersect_threads(mesh, pointer, threads))

    def record(self, *row: int) -> int:
        """Call the submission's `intersect` for one ray, and record the tests that it calls."""
        slot, ray, hit, steps, capacity, count = row
        recording = abi.Recording(
            self.source + ray,
            self.target + hit,
            self.target + steps,
            capacity,
            self.target + count,
        )
        return int(self.library.ex03_record(self.slots[slot][0], ctypes.byref(recording)))

    def put(self, offset: int, *numbers: int) -> None:
        """Write 64-bit numbers into the result."""
        for place, number in enumerate(numbers):
            at = offset + 8 * place
            self.result[at : at + 8] = number.to_bytes(8, "little")

    def carry_out(self) -> int:
        """Run all rows; stops at the first one that fails and returns its status."""
        _, _, first, count, *_ = protocol.HEADER.unpack_from(self.given, 0)
        for number in range(count):
            at = first + number * protocol.ROW.size
            status = self.one(protocol.ROW.unpack_from(self.given, at))
            if status != Status.OK:
                return status
            self.put(16, number + 1)
        return Status.OK

    def one(self, row: Sequence[int]) -> int:
        """Run one row and return its status."""
        code, *arguments = row
        action, wanted = self.actions[code]
        return action(*arguments[:wanted])


def write_error(result: mmap.mmap, status: int, text: bytes) -> None:
    """Say in the result's header why no further row was carried out."""
    cut = text[: protocol.ERROR_CAPACITY]
    result[24:40] = status.to_bytes(8, "little") + len(cut).to_bytes(8, "little")
    result[protocol.ERROR_OFFSET : protocol.ERROR_OFFSET + len(cut)] = cut


def main(arguments: Sequence[str]) -> None:
    """Load the library, carry out the rows, leave."""
    worker = begun(Worker, *arguments)
    leave(worker, worker.carry_out())


def begun(kind: type[Kind], library: str, given_fd: str, result_fd: str) -> Kind:
    """Map the two files and load the library; ends the process if it cannot be loaded."""
    given = mmap.mmap(
        int(given_fd), 0, flags=mmap.MAP_PRIVATE, prot=mmap.PROT_READ | mmap.PROT_WRITE
    )
    result = mmap.mmap(int(result_fd), 0)
    try:
        return kind(library, given, result)
    except abi.Mismatch as error:
        write_error(result, Status.MISMATCH, str(error).encode())
        os._exit(0)
    except OSError as error:
        write_error(result, Status.NOT_LOADED, str(error).encode())
        os._exit(0)


def leave(worker: Worker, status: int) -> None:
    """Say how the last row ended, and end the process without clean-up."""
    result = worker.result
    if status != Status.OK:
        text = bytearray(protocol.ERROR_CAPACITY)
        length = worker.library.ex03_last_error(abi.address(memoryview(text)), len(text))
        write_error(result, status, bytes(text[: min(length, len(text))]))
    # Destructors of the submission are nobody's business here, and could crash.
    os._exit(0)

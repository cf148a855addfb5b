"""Records go into a file and come back bit by bit; a file that is not whole gives nothing."""

from dataclasses import fields

import numpy as np
import pytest

from grader.model.mesh import Answers, Bvh, Mesh, Rays
from grader.model.trials import ConstructTrial, RebuildTrial, TraceTrial
from grader.oracle.container import ALIGNMENT, sealed, unsealed

MESH = Mesh(np.array([[0.1, -0.0, np.nan]] * 3, np.float32), np.array([[0, 1, 2]], np.uint32))


def file_of(value: object) -> np.ndarray:
    """Return the bytes of a file."""
    return np.frombuffer(bytearray(b"".join(sealed(value))), dtype=np.uint8)


def trial() -> TraceTrial:
    """Make a trial with arrays of every type, an empty and a strided one among them."""
    rays = np.arange(18, dtype=np.float32).reshape(3, 6)
    return TraceTrial(
        name="näme",
        mesh=MESH,
        tree=Bvh(
            low=np.zeros((0, 3), np.float32),
            high=np.zeros((0, 3), np.float32),
            begin=np.zeros(0, np.uint32),
            end=np.zeros(0, np.uint32),
            order=np.array([7], np.uint32),
            node_count=1 << 40,
        ),
        rays=Rays(rays[:, :3], rays[:, 3:], rays[:, 0], rays[::-1, 5]),
        answers=Answers(
            limit=np.array([1 / 3, np.inf, 5e-324]),
            first=np.arange(4),
            face=np.arange(3),
            t=np.array([0.1, -0.0, np.nan]),
            tolerance=np.array(2.0),
            kind=np.array([0, 1, 2], np.uint8),
        ),
        families=("one", "two"),
        family=np.array([0, 1, 0]),
        special=True,
    )


def test_a_record_comes_back_bit_by_bit() -> None:
    """Types, shapes, bits, texts and numbers, of arrays that nobody may write to."""
    given = trial()
    back = unsealed(file_of(given))
    assert (back.name, back.families, back.special) == ("näme", ("one", "two"), True)
    assert back.tree.node_count == 1 << 40
    for one, two in ((given, back), (given.rays, back.rays), (given.answers, back.answers)):
        for field in fields(one):
            first, second = getattr(one, field.name), getattr(two, field.name)
            if isinstance(first, np.ndarray):
                assert (first.dtype, first.shape) == (second.dtype, second.shape)
                assert first.tobytes() == second.tobytes()
                assert not second.flags.writeable


def test_what_is_shared_stays_shared() -> None:
    """One mesh of two trials is stored once and comes back as one object."""
    other = Mesh(MESH.vertices, np.zeros((0, 3), np.uint32))
    both = ConstructTrial("a", MESH), RebuildTrial("b", MESH, other)
    one, two = unsealed(file_of(both))
    assert one.mesh is two.first
    assert one.mesh is not two.second
    assert np.shares_memory(one.mesh.vertices, two.second.vertices)


def test_numbers_keep_their_kind_and_last_bit() -> None:
    """Whole ones, the smallest and the infinite ones, and booleans."""
    given = (1, 1.0, 1 / 3, 5e-324, float("inf"), -0.0, True, (), ((),))
    back = unsealed(file_of(given))
    assert [repr(each) for each in back] == [repr(each) for each in given]


@pytest.mark.parametrize("length", [0, 1, 31, 32, 33, 39, 40, 41])
def test_the_beginning_of_a_file_is_not_whole(length: int) -> None:
    """However short it is."""
    assert unsealed(file_of(trial())[:length].copy()) is None


def test_each_flipped_byte_is_noticed() -> None:
    """In the hash, the length, the index, the arrays and the room between them."""
    content = file_of((np.arange(3), "text"))
    for place in range(content.size):
        spoiled = content.copy()
        spoiled[place] ^= 1
        assert unsealed(spoiled) is None, place


def test_arrays_begin_where_a_cache_line_does() -> None:
    """Counted from the beginning of the file, whatever is before them."""
    content = file_of(("x" * 5, np.arange(3, dtype=np.uint8), np.arange(9.0)))
    _, small, large = unsealed(content)
    for array in (small, large):
        assert (array.ctypes.data - content.ctypes.data) % ALIGNMENT == 0


def test_what_nobody_listed_is_not_stored() -> None:
    """A record of another kind is our mistake, and is said so before anything is written."""
    with pytest.raises(KeyError, match="slice"):
        sealed(slice(1))

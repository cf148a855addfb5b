"""Which functions may change nodes, by their mangled names."""

import pytest

from grader.verify.mangled import speaks_of_nodes
from grader.verify.source import construct_loops
from tests.verify.test_source import CONSTRUCT, case_of

READ = "_ZL6selectRKN3BVH4NodeEPj"
VECTOR = "St6vectorIN3BVH4NodeESaIS"


@pytest.mark.parametrize(
    ("name", "wrong"),
    [
        (READ, 0),
        (READ + "S4_", 0),
        (READ + "RS0_", 1),
        (READ + "St4spanIS0_Lm18446744073709551615EE", 1),
        (READ.replace("RK", "R"), 1),
        (READ.replace("RK", "RKP"), 1),
        (READ + "RSt6vectorI4ItemSaIS4_EE", 0),
        (READ + "RSt6vectorIS0_SaIS0_EE", 1),
        ("_ZL6selectRSt6vectorI4ItemSaIS0_EERKN3BVH4NodeE", 0),
        ("_ZL6selectRSt6vectorI4ItemSaIS0_EEN3BVH4NodeEjj", 0),
        ("_ZN7Builder6selectEN3BVH4NodeES1_j", 0),
        ("_ZN7Builder6selectIiEEN3BVH4NodeET_", 1),
        ("_ZL6selectIiEN3BVH4NodeET_", 1),
        ("_ZL6selectN3BVH4NodeEPS0_", 1),
        ("_ZL6selectN3BVH4NodeERSt4pairIiS0_E", 1),
        ("_ZL6selectRSt4pairIjN3BVH4NodeEE", 1),
        ("_ZL6selectDv4_fRSt4pairIjN3BVH4NodeEE", 1),
        ("_ZL6selectRA1_N3BVH4NodeE", 1),
        ("_ZL6selectPFvN3BVH4NodeEE", 1),
        (f"_ZL6selectRK{VECTOR}1_EEPj", 0),
        (f"_ZL6selectR{VECTOR}1_EEPj", 1),
        ("_ZL6selectRK3BVHRKNS_4NodeE", 0),
        ("_ZL6selectRK3BVHRNS_4NodeE", 1),
        ("_ZL6selectRK4MeshRK3BVHRNS2_4NodeE", 1),
        ("_ZN8FaceList9mergeSortEPNS_4NodeEm", 0),
        ("_ZN8FaceList9mergeSortERK3BVHPNS_4NodeE", 0),
        ("_ZN8FaceList9mergeSortERK3BVHPNS0_4NodeE", 1),
    ],
)
def test_who_only_reads_nodes_builds_none(name: str, wrong: int) -> None:
    """A node may be given to a sorting helper, and another class may have nodes, too."""
    assert construct_loops.decide(case_of((CONSTRUCT, name), (name, name))).wrong == wrong


@pytest.mark.parametrize(
    ("below", "wrong"),
    [
        (f"_ZNK{VECTOR}1_EEixEm", 0),
        (f"_ZN{VECTOR}1_EEixEm", 1),
        ("_ZN9__gnu_cxxeqIPKN3BVH4NodeESt6vectorIS2_SaIS2_EEEEbv", 0),
        ("_ZN9__gnu_cxxeqIPN3BVH4NodeESt6vectorIS2_SaIS2_EEEEbv", 1),
        ("_ZNKSt4spanIKN3BVH4NodeELm18446744073709551615EEixEm", 0),
        ("_ZNKSt4spanIN3BVH4NodeELm18446744073709551615EEixEm", 1),
        ("_ZN3BVH4NodeC1Ev", 1),
    ],
)
def test_who_may_write_to_a_node_that_it_reads_builds(below: str, wrong: int) -> None:
    """A constant span or iterator still leads to nodes that can be written."""
    calls = ((CONSTRUCT, READ), (READ, READ), (READ, below))
    assert construct_loops.decide(case_of(*calls)).wrong == wrong


def test_a_name_takes_no_time() -> None:
    """Twice as long takes twice as long, not four times: this one would take minutes."""
    assert not speaks_of_nodes("_Z" + "3BVHNS" * 50_000)

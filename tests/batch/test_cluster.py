"""A class is graded by a cluster as by this machine, whatever happens to one of its workers."""

from pathlib import Path

from tests.batch.classes import CODE, folder_of, grade, points
from tests.batch.clusters import machines
from tests.batch.stand_in import LOG, begun, job


def test_a_class_is_graded_by_two_workers(tmp_path: Path, log: Path) -> None:
    """With all that may happen to one submission."""
    texts = {"ada": CODE, "bob": "wrong", "cy": "raise", "dan": "die", "eve": "die once"}
    path = folder_of(tmp_path, "class", {f"{name}.cpp": text for name, text in texts.items()})
    with machines(tmp_path / "machines", **{LOG: str(log)}) as cluster:
        totals, seen = grade(path, job(tmp_path / "out", None, cluster.address))
        print(cluster.said())
    print(seen.notices, seen.troubles)
    assert (totals.graded, totals.withheld) == (3, 2)
    found = points(tmp_path / "out")
    assert (found["ada"], found["cy"], found["dan"], found["eve"]) == (50, None, None, 50)
    assert begun(log).count("die") == 2

"""A class is graded by a cluster as by this machine, whatever happens to the machines."""

import gc
import shutil
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pathlib import Path

import pytest
from distributed import Client

from grader.batch import cluster as module
from grader.batch.cluster import Cluster, require_versions
from grader.batch.settings import settled
from grader.errors import UsageError, WorkerFault
from grader.sandbox.office import News
from grader.score.rubric import SHIPPED
from tests.batch.classes import CODE, Json, comparable, folder_of, grade, points
from tests.batch.clusters import PATIENCE, Machines, machines
from tests.batch.stand_in import LOG, WISH, begun, job
from tests.oracle.own import own_folder

pytestmark = pytest.mark.xdist_group("cluster")

CAREFUL = "tests.batch.stand_in:careful"


@pytest.fixture(scope="module")
def shared(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Machines]:
    """Two workers for all tests that kill none of them."""
    folder = tmp_path_factory.mktemp("machines")
    with machines(folder, **{LOG: str(folder / "log")}) as cluster:
        with Client(cluster.address, set_as_default=False) as client:
            client.wait_for_workers(2, PATIENCE)
        yield cluster


@pytest.fixture
def log(shared: Machines, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Name the file in which the stand-in writes, wherever it grades."""
    monkeypatch.setenv(LOG, shared.given[LOG])
    return Path(shared.given[LOG])


def test_results_are_those_of_this_machine(
    tmp_path: Path, shared: Machines, log: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """With all that may happen to one submission, and never a whole class under way."""
    texts = {"ada": CODE, "bob": "wrong", "cy": "raise", "dan": "die", "eve": "die once"}
    texts |= {f"s{number}": f"code {number}" for number in range(12)}
    path = folder_of(tmp_path, "class", {f"{name}.cpp": text for name, text in texts.items()})
    under_way, real = set(), Cluster.news

    def seen_news(self: Cluster) -> Iterator[News]:
        under_way.add(self.busy)
        return real(self)

    monkeypatch.setattr(Cluster, "news", seen_news)
    totals, seen = grade(path, job(tmp_path / "far", None, shared.address))
    assert (totals.graded, totals.withheld) == (15, 2)
    assert seen.stages == {"[red]tracing[/red]"}
    assert max(under_way) == 4
    # In any order: four are under way, and a machine that is slow may be late with the first.
    cy, dan = sorted(seen.troubles)
    assert [said.partition(":")[0] for said in (cy, dan)] == ["cy", "dan"]
    assert "SIGKILL" in dan
    counts = {text: begun(log).count(text) for text in ("raise", "die", "die once", "code 3")}
    assert counts == {"raise": 1, "die": 2, "die once": 2, "code 3": 1}
    grade(path, job(tmp_path / "near"))
    far, near = comparable(tmp_path / "far"), comparable(tmp_path / "near")
    for one in (far, near):
        # Why it was us differs: there it names a worker.
        del one["dan"]
    assert far == near


def test_own_scenes_travel_with_the_submissions(
    tmp_path: Path, shared: Machines, log: Path
) -> None:
    """A worker sees none of our folders; what it unpacks has the same digests."""
    own_folder(tmp_path)
    rubric = tmp_path / "rubric.toml"
    rubric.write_text(SHIPPED.read_text() + '[scenes]\nfolder = "ours"\n')
    wish = replace(WISH, rubric=rubric)
    given = replace(job(tmp_path / "out", None, shared.address), wish=wish, entry=CAREFUL)
    path = folder_of(tmp_path, "class", {"ada.cpp": "with our scenes", "bob.cpp": "and again"})
    totals, seen = grade(path, replace(given, settings=settled(wish)))
    assert totals.graded == 2, seen.troubles


def test_a_worker_with_another_grader_refuses(
    tmp_path: Path, shared: Machines, log: Path
) -> None:
    """It names what differs; nothing is withheld, and the right one goes on."""
    given = replace(job(tmp_path / "out", None, shared.address), wish=WISH, entry=CAREFUL)
    path = folder_of(tmp_path, "class", {"ada.cpp": "after a refusal"})
    right = settled(WISH)
    other = replace(right, grader="0.0 (another)", scenes_sha256="0" * 64)
    with pytest.raises(WorkerFault) as fault:
        grade(path, replace(given, settings=other))
    said = str(fault.value)
    assert said.startswith("worker tcp://127.0.0.1:")
    assert f"grader: 0.0 (another) -> {right.grader}; scenes sha256: 000000000000 -> " in said
    assert points(tmp_path / "out") == {}
    totals, _ = grade(path, replace(given, folder=tmp_path / "new", settings=right))
    assert totals.graded == 1


def test_a_worker_that_cannot_isolate_refuses(tmp_path: Path, log: Path) -> None:
    """As `grade` does there; the other one's results would have been taken."""
    programs = tmp_path / "programs"
    programs.mkdir()
    compiler = shutil.which("g++")
    assert compiler is not None
    (programs / "g++").symlink_to(compiler)
    wish = replace(WISH, isolated=True)
    given = replace(job(tmp_path / "out"), wish=wish, settings=settled(wish), entry=CAREFUL)
    path = folder_of(tmp_path, "class", {"ada.cpp": "isolated"})
    with machines(tmp_path / "machines", 0, **{LOG: str(log)}) as cluster:
        cluster.hire(PATH=str(programs), BVHGRADE_ISOLATION="A")
        with pytest.raises(WorkerFault, match="bubblewrap is not installed"):
            grade(path, replace(given, scheduler=cluster.address))


def test_a_scheduler_without_bvhgrade_is_told(tmp_path: Path, log: Path) -> None:
    """It reads what it passes on."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE})
    with machines(tmp_path / "machines", 0, **{LOG: str(log)}) as cluster:
        cluster.begin("import sys; sys.modules['grader'] = None")
        cluster.hire()
        with pytest.raises(WorkerFault, match="has no bvhgrade"):
            grade(path, job(tmp_path / "out", None, cluster.address))


@dataclass
class Installed:
    """A cluster, as far as it says what is installed there."""

    scheduler: str
    worker: str

    def get_versions(self) -> Json:
        """Answer as Dask does, shortened."""

        def told(release: str) -> Json:
            return {"host": {"python": "3.11.2.final.0"}, "packages": {"distributed": release}}

        workers = {"tcp://10.0.0.7:1": told(self.worker)}
        return {"client": told("2"), "scheduler": told(self.scheduler), "workers": workers}


@pytest.mark.parametrize(
    ("scheduler", "worker", "said"),
    [("1", "2", "tcp://10.0.0.1"), ("2", "3", "tcp://10.0.0.7")],
)
def test_another_dask_is_told(scheduler: str, worker: str, said: str) -> None:
    """Rather than that something fails later."""
    require_versions(Installed("2", "2"), "tcp://10.0.0.1")
    with pytest.raises(WorkerFault, match=f"{said}.* with distributed [13], but .* 2;"):
        require_versions(Installed(scheduler, worker), "tcp://10.0.0.1")


def test_an_address_that_is_none_is_wrong_usage(tmp_path: Path) -> None:
    """Before anything is connected to."""
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE})
    with pytest.raises(UsageError, match="tcp:// or tls://"):
        grade(path, job(tmp_path / "out", None, "localhost:8786"))


@pytest.mark.parametrize("address", ["tcp://127.0.0.1:1", "tls://127.0.0.1:1", "tcp://:x"])
def test_a_scheduler_that_cannot_be_reached_is_told(
    tmp_path: Path, address: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Nobody listens, nobody gave us certificates, nobody can read that."""
    monkeypatch.setattr("grader.batch.cluster.PATIENCE_SECONDS", 1.0)
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE})
    with pytest.raises(WorkerFault, match="cannot be reached"):
        grade(path, job(tmp_path / "out", None, address))


def test_no_client_is_collected_while_one_starts(monkeypatch: pytest.MonkeyPatch) -> None:
    """An earlier one that could not connect would wait for this one's lock, and this for it."""
    seen: list[bool] = []

    def started(*_: object, **__: object) -> object:
        seen.append(gc.isenabled())
        return object()

    monkeypatch.setattr("distributed.Client", started)
    module._connected("tcp://127.0.0.1:1")
    assert (seen, gc.isenabled()) == ([False], True)
    gc.disable()
    try:
        module._connected("tcp://127.0.0.1:1")
        assert not gc.isenabled(), "it was so before, for whatever reason"
    finally:
        gc.enable()


def test_a_client_that_does_not_start_is_told(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Dask asserts that its own thread is there within ten seconds."""

    def stuck(*_: object, **__: object) -> None:
        raise AssertionError

    monkeypatch.setattr("distributed.Client", stuck)
    path = folder_of(tmp_path, "class", {"ada.cpp": CODE})
    with pytest.raises(WorkerFault, match="cannot be reached: AssertionError"):
        grade(path, job(tmp_path / "out", None, "tcp://127.0.0.1:1"))

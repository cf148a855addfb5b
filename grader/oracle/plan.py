"""What is a submission asked to do, and what is right? All trials of one seed."""

from collections.abc import Sequence
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from grader.model.mesh import Bvh, Mesh
from grader.model.trials import (
    AlteredTrial,
    ConstructTrial,
    ImageTrial,
    RebuildTrial,
    RepeatTrial,
    TraceTrial,
    Trial,
)
from grader.oracle.altered import altered_trials
from grader.oracle.exact import exact_trial, lattice
from grader.oracle.forms import other_form
from grader.oracle.meshes import TRACED, construct_meshes, depth_mesh
from grader.oracle.rays import Request
from grader.oracle.remember import digest_of, remember
from grader.oracle.repeated import TWIN, repeat_trials, twins_of
from grader.oracle.scenes import folder_sha256, image_trials
from grader.oracle.spines import DEEPEST, spine_trial
from grader.oracle.thicket import thicket, thicket_trial
from grader.oracle.tracing import deepest_tree, sample, traced
from grader.oracle.witness import contradictions
from grader.oracle.work import Trees, work_trials
from grader.tolerances import MAX_DEPTH

SANITIZED = (
    *(f"cloud-{faces}" for faces in (0, 1, 4, 5, 9, 17)),
    "identical-64",
    "zero-area",
    "strip-y",
    "soup-degenerate",
    "identical-1000",
    "terrain-600",
    "terrain-1200",
    "ball-1280",
    "touching-boxes",
)
"""Meshes of the sanitized build; those of more than 256 faces reach its depth limit."""

REBUILT = (
    ("terrain-600", "cloud-37"),
    ("cloud-9", "ball-1280"),
    ("cloud-18", "cloud-0"),
    ("cloud-37", "cloud-4"),
    ("strip-x", "strip-y"),
)
"""Meshes A and B: B smaller, larger, empty, a single leaf, and two that differ in no size."""

ALTERED = ("terrain-1200", "dragon-res4", "cloud-37")
"""Meshes of altered trees: on a small one too nobody may do without the tree."""

SAMPLED = (
    ("cloud-1", 40),
    ("cloud-5", 40),
    ("terrain-1200", 60),
    ("dragon-res4", 60),
)
"""Meshes of the sanitized build in part b, and of how many rays one is taken: a single leaf,
a tree that ends with its last used node, one with gaps, a deep one.

None without faces: `construct` may leave that one's tree without nodes, or with a root."""

USUAL_RAYS, RAYS = 200, {"cloud-4": 1_000}
"""Of each family. Of 1,600 rays among four faces as few as two met more than one of them."""

LATTICES = (0, 2)
SPINE_STEP, THICKET_STEP = 7, 8
"""One of so many rays of the deepest tree, and of the one with most nodes to be visited, is for
the sanitized build."""


@dataclass(frozen=True, slots=True)
class Plan:
    """What is run for one seed."""

    trials: tuple[Trial, ...]
    faults: tuple[tuple[str, str], ...]
    """Name of a trial whose answers cannot be trusted, and why: our own fault."""


class Drawn(NamedTuple):
    """What depends on the seed and takes long."""

    first: tuple[Trial, ...]
    repeats: tuple[RepeatTrial, ...]
    faults: tuple[tuple[str, str], ...]
    """As of the plan."""


def make_plan(seed: int, trees: Trees, own: Path | None = None) -> Plan:
    """Draw all trials of a seed, but for `depth_trial` and `deeper_trials`.

    Args:
        seed: Two plans of one seed are equal, bit by bit.
        trees: Builds the reference's tree of each mesh.
        own: A course's own folder of scenes, used beside the shipped one.

    Raises:
        OracleFault: A stored mesh or picture is missing, damaged or stale.
        MissingTool: embreex is not installed.
        UsageError: A line of the own folder's `scenes.toml` is wrong.
    """
    more = image_trials(trees, own) if own else ()
    return assembled(seed, drawn(seed, trees), image_trials(trees), more)


def kept_plan(seed: int, trees: Trees, builder: str, own: Path | None = None) -> Plan:
    """Return `make_plan`, with its parts from the cache if they are there.

    Args:
        seed: As for `make_plan`.
        trees: As for `make_plan`.
        builder: Names what builds the trees: another name, other trees.
        own: As for `make_plan`.

    Raises:
        OracleFault: As `make_plan`.
        MissingTool: As `make_plan`.
        UsageError: As `make_plan`.
    """
    # Two entries: pictures are the same for all seeds. Together they are read in one tenth of
    # the time that it takes to read and put together what they are made from.
    key = digest_of("drawn", (builder, folder_sha256()), seed)
    with ThreadPoolExecutor(1) as aside:
        # Much of it is spent in calls that let other threads run.
        shipped = aside.submit(_kept_pictures, trees, builder, None)
        parts = remember(key, lambda: drawn(seed, trees))
        pictures = shipped.result()
    more = _kept_pictures(trees, builder, own) if own else ()
    return assembled(seed, Drawn(*parts), pictures, more)


def _kept_pictures(trees: Trees, builder: str, folder: Path | None) -> tuple[ImageTrial, ...]:
    """Return the pictures of a folder; what lies in it is in the name of the entry."""
    key = digest_of("pictures", (builder, folder_sha256(folder)))
    return remember(key, lambda: tuple(image_trials(trees, folder)))


def assembled(
    seed: int,
    parts: Drawn,
    pictures: Sequence[ImageTrial],
    more: Sequence[ImageTrial] = (),
) -> Plan:
    """Put all trials in order, and add those that are made faster than they are read.

    Args:
        seed: As for `make_plan`.
        parts: What was drawn.
        pictures: Of the shipped scenes; one of them is for the sanitized build, too.
        more: Of a course's own.
    """
    trials: tuple[Trial, ...] = (
        *parts.first,
        *deepest_tree(pictures),
        *spine_trials(seed, DEEPEST),
        *parts.repeats,
        *pictures,
        *more,
    )
    return Plan(trials, parts.faults)


def drawn(seed: int, trees: Trees) -> Drawn:
    """Draw what takes long.

    Args:
        seed: As for `make_plan`.
        trees: As for `make_plan`.
    """
    meshes = dict(construct_meshes(seed))
    built = dict(zip(TRACED, trees([meshes[name] for name in TRACED]), strict=True))
    tracing = [
        traced(
            Request(seed, name, special, RAYS.get(name, USUAL_RAYS)),
            meshes[name],
            other_form(name, built[name]),
        )
        for name in TRACED
        for special in (False, True)
    ]
    first: tuple[Trial, ...] = (
        *_construct_trials(meshes),
        *_altered(seed, meshes, built),
        *work_trials(seed, trees),
        *tracing,
        *_exact_trials(seed, trees),
        *_thicket_trials(seed, trees),
        *_sampled(tracing),
    )
    repeats = tuple(repeat_trials(seed, meshes, built, trees))
    return Drawn(first, repeats, tuple(contradictions((*first, *repeats))))


def deeper_trials(seed: int) -> list[TraceTrial]:
    """Draw the trials on a tree of level 20, for those whose own trees have that level."""
    return spine_trials(seed, MAX_DEPTH)


def depth_trial(seed: int) -> ConstructTrial:
    """Draw the trial whose tree would go deeper than 20 levels."""
    return ConstructTrial("tree over 4,194,312 faces", depth_mesh(seed))


def _construct_trials(meshes: dict[str, Mesh]) -> list[Trial]:
    """Lay out part a."""
    twin = meshes[TWIN]
    reflected, reverse = twins_of(twin)
    growing = (meshes["cloud-1"], meshes["cloud-64"])
    return [
        # First: who corrupts the heap may never come back from a large mesh.
        *(
            ConstructTrial(f"tree over {name}, sanitized", meshes[name], sanitized=True)
            for name in SANITIZED
        ),
        *(ConstructTrial(f"tree over {name}", mesh) for name, mesh in meshes.items()),
        *(RebuildTrial(f"tree over {a}, {b}, {a}", meshes[a], meshes[b]) for a, b in REBUILT),
        RebuildTrial(f"tree over {TWIN}, its faces in reverse, {TWIN}", twin, reverse),
        RebuildTrial(f"tree over {TWIN}, its vertices reflected, {TWIN}", twin, reflected),
        RebuildTrial(
            "tree over cloud-1, cloud-64, cloud-1, sanitized", *growing, sanitized=True
        ),
    ]


def _altered(seed: int, meshes: dict[str, Mesh], built: dict[str, Bvh]) -> list[AlteredTrial]:
    """Lay out the altered trees."""
    return [
        trial
        for name in ALTERED
        for trial in altered_trials(seed, name, meshes[name], built[name])
    ]


def _exact_trials(seed: int, trees: Trees) -> list[TraceTrial]:
    """Lay out the rays in the planes of boxes: each axis is across one lattice at least."""
    meshes = [lattice(seed, up) for up in LATTICES]
    built = zip(LATTICES, meshes, trees(meshes), strict=True)
    return [exact_trial(seed, up, mesh, tree) for up, mesh, tree in built]


def _thicket_trials(seed: int, trees: Trees) -> list[TraceTrial]:
    """Lay out the rays that visit every node of a large tree."""
    mesh = thicket(seed)
    (tree,) = trees([mesh])
    trial = thicket_trial(seed, mesh, tree)
    return [trial, sample(trial, THICKET_STEP, f"{trial.name}, sanitized")]


def _sampled(tracing: Sequence[TraceTrial]) -> list[TraceTrial]:
    """Lay out the trials of the sanitized build: few rays of both kinds."""
    steps = dict(SAMPLED)
    return [
        sample(trial, steps[name], f"{trial.name}, sanitized")
        for trial in tracing
        if (name := trial.name.partition(",")[0]) in steps
    ]


def spine_trials(seed: int, deepest: int) -> list[TraceTrial]:
    """Lay out the tree that is as deep as trees may be, for both builds."""
    trial = spine_trial(seed, deepest)
    return [trial, sample(trial, SPINE_STEP, f"{trial.name}, sanitized")]

"""How fast are the solutions, the tree's checks and the counted tests? Goals 2, 6 and 7."""

import time
from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial
from pathlib import Path

import numpy as np

from grader.bench import goals
from grader.bench.against_embree import Embree, embree_for, laid_out
from grader.bench.boxes import Timer
from grader.bench.libraries import Libraries
from grader.bench.rays import camera_rays, scattered_rays
from grader.bench.record import Cost, Goal, Reading
from grader.bench.statistics import interleaved, lost_in_noise, ratios
from grader.model.cases import TreeCase
from grader.model.mesh import Bvh, Mesh, Rays
from grader.model.trials import ConstructTrial
from grader.sandbox.nursery import Nursery
from grader.selection import select
from grader.verify.engine import Examiner
from grader.verify.tree import face_minima

AGAIN = 4
"""How often rays are traced, so that building the tree before hides nothing."""


NO_PACKAGE = "neither has a package, and nothing is fetched from elsewhere"


@dataclass(frozen=True, slots=True)
class Course:
    """What everybody has to do: a mesh and two bundles of rays."""

    mesh: Mesh
    camera: Rays
    scattered: Rays
    rounds: int


def course_on(mesh: Mesh, side: int, scattered: int, rounds: int) -> Course:
    """Lay out side x side camera rays and so many scattered ones on a mesh."""
    return Course(mesh, camera_rays(mesh, side), scattered_rays(mesh, scattered), rounds)


def check_cost(mesh: Mesh, tree: Bvh, seen: bool = False) -> Cost:
    """Decide every check of a tree once, as a grade does.

    Args:
        mesh: Of the tree.
        tree: What is checked.
        seen: Whether the grader has the table of the mesh's faces from a grade before.
    """
    mesh = replace(mesh)  # A table is kept for an object, and of this one there is none.
    if seen:
        face_minima(mesh)
    # Fresh arrays: what was derived from a tree is remembered as long as it lives.
    own = Bvh(
        tree.low.copy(), tree.high.copy(), tree.begin, tree.end, tree.order, tree.node_count
    )
    case = TreeCase("bench", ConstructTrial("bench", mesh), own)
    examiner = Examiner(select(None, ()).checks)
    wall, cpu = time.monotonic(), time.process_time()
    list(examiner.examine([case]))
    return Cost(time.process_time() - cpu, time.monotonic() - wall)


def measured(course: Course, libraries: Libraries, folder: Path) -> list[Reading]:
    """Time all solutions against each other and against Embree, round by round."""
    bundles = {"camera": course.camera, "scattered": course.scattered}
    given = laid_out(folder, course.mesh, bundles)
    embree = embree_for(folder / "embree", given)
    with Nursery() as nursery:
        timer = Timer(nursery, course.mesh)
        tree = timer.tree(libraries.clear)
        runs: dict[str, Callable[[], Cost]] = {
            "check": lambda: check_cost(course.mesh, tree),
            "seen": lambda: check_cost(course.mesh, tree, seen=True),
            "textbook": lambda: timer.construct(libraries.textbook),
            "clear": lambda: timer.construct(libraries.clear),
            "fast": lambda: timer.construct(libraries.fast),
            "camera": lambda: timer.trace(libraries.fast, course.camera, AGAIN),
            "scattered": lambda: timer.trace(libraries.fast, course.scattered, AGAIN),
            "counted": lambda: timer.trace(libraries.clear, course.camera, AGAIN),
            "uncounted": lambda: timer.trace(libraries.uncounted, course.camera, AGAIN),
        }
        peers: list[dict[str, float]] = []
        if embree is not None:
            runs["embree"] = partial(_embree, embree, peers)
        costs = interleaved(runs, course.rounds)
    cpu = {name: [each.cpu for each in found] for name, found in costs.items()}
    cpu |= {f"embree {key}": [each[key] for each in peers] for key in peers[0]} if peers else {}
    return [
        replace(_of_seconds(goals.CHECK, cpu, "check", "textbook"), why=_why_checks(cpu)),
        _of_seconds(goals.CHECK_SEEN, cpu, "seen", "textbook"),
        _of_seconds(goals.CLEAR_BUILD, cpu, "clear", "textbook"),
        _of_seconds(goals.FAST_BUILD, cpu, "fast", "embree construct"),
        _of_speed(goals.FAST_CAMERA, cpu, "camera", "embree camera", course.camera),
        _of_speed(goals.FAST_SCATTERED, cpu, "scattered", "embree scattered", course.scattered),
        _of_speed(goals.COUNTED, cpu, "counted", "uncounted", course.camera),
        Reading(goals.OTHERS_BUILD, None, NO_PACKAGE),
    ]


def _why_checks(cpu: dict[str, list[float]]) -> str:
    """Divide the checks' time into the table of all faces, which is kept, and the rest."""
    whole, rest = (float(np.median(cpu[name])) for name in ("check", "seen"))
    return (
        f"of {whole:.3f} s, {max(whole - rest, 0):.3f} s make a table of 12 numbers for each "
        "face, which is kept: only the first submission of a class pays for it (2b)."
    )


def _embree(embree: Embree, found: list[dict[str, float]]) -> Cost:
    found.append(embree.seconds())
    return Cost(0.0, 0.0)


def _of_seconds(goal: Goal, cpu: dict[str, list[float]], above: str, below: str) -> Reading:
    """Compare two times."""
    if below not in cpu:
        return Reading(goal, None, "embreex is not installed")
    a, b = float(np.median(cpu[above])), float(np.median(cpu[below]))
    detail = f"{a:.3f} s / {b:.3f} s CPU" + lost_in_noise(cpu[above], cpu[below])
    return Reading(goal, ratios(cpu[above], cpu[below]), detail)


def _of_speed(
    goal: Goal, cpu: dict[str, list[float]], own: str, theirs: str, rays: Rays
) -> Reading:
    """Compare rays per second: the other time over the own one."""
    if theirs not in cpu:
        return Reading(goal, None, "embreex is not installed")
    millions = len(rays.t_min) / 1e6
    medians = [float(np.median(cpu[name])) for name in (own, theirs)]
    a, b = (f"{millions / each:.2f}" if each > 0 else "?" for each in medians)
    detail = f"{a} / {b} million rays a second" + lost_in_noise(cpu[own], cpu[theirs])
    return Reading(goal, ratios(cpu[theirs], cpu[own]), detail)

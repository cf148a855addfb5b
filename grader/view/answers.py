"""What is a page told of the node and of the ray that are looked at? Plain values."""

from typing import Any

import numpy as np

from grader.language import Words
from grader.model.views import ShownRay
from grader.plain import one_line
from grader.report.views import ray_json, runs
from grader.verify.check import vector
from grader.view.inspector import NodeFacts, some_faces
from grader.view.overlay import MOST_OUTLINES
from grader.view.walking import Walk, cut_off, outcome_of, right_of

Json = dict[str, Any]


def node_json(facts: NodeFacts, judged: bool, whole: bool, words: Words) -> Json:
    """Write a node.

    Args:
        facts: What is known of it.
        judged: Whether that includes what is wrong with it.
        whole: Whether the page has all faces of the mesh.
        words: Translates our own texts.
    """
    told = words("level {level}, faces [{begin}, {end})").format(
        level=facts.level, begin=facts.begin, end=facts.end
    )
    family = [[words("parent"), facts.parent]] if facts.parent >= 0 else []
    family += [[words("child"), child] for child in facts.children]
    good = words("Nothing is wrong with this node.") if judged and not facts.faults else ""
    box = f"min {vector(facts.low)}\nmax {vector(facts.high)}"
    corners = [*facts.low, *facts.high]
    outlined = whole and facts.faces.size <= MOST_OUTLINES
    return {
        "index": facts.node,
        "told": f"{told}\n{some_faces(facts)}\n{box}\n{good}",
        "family": family,
        "faults": [one_line(fault) for fault in facts.faults],
        "wrong": bool(facts.faults),
        "box": corners if np.isfinite(corners).all() else None,
        "right_box": list(facts.right_box) or None,
        "faces": runs(facts.faces) if outlined else [],
    }


def walk_json(walk: Walk, words: Words) -> Json:
    """Write a ray and its steps."""
    row = [float(value) for value in walk.ray]
    expected = np.inf if walk.expected is None else walk.expected
    made = ShownRay(
        origin=(row[0], row[1], row[2]),
        direction=(row[3], row[4], row[5]),
        t_min=row[6],
        t_max=row[7],
        expected=expected,
        got=walk.found,
        face=-1,
        lost=walk.lost,
        sentence=one_line(walk.sentence),
        steps=walk.steps,
    )
    came = f"{walk.of.title}: {outcome_of(walk, words)}"
    told = ", ".join(filter(None, (came, right_of(walk, words))))
    told = f"{told}. {made.sentence} {cut_off(walk, words)}".strip()
    return {**ray_json(made), "told": told, "total": walk.total}

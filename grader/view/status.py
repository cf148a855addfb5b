"""What is said of a desk in one line: how far everything is, and the numbers of the moment."""

from grader.language import Words
from grader.plain import one_line
from grader.view.desk import Desk
from grader.view.picture import is_old
from grader.view.stage import Stage, State


def status(desk: Desk, words: Words, told: Words = str) -> str:
    """Put it together; the first thing is what went wrong, if anything did.

    Args:
        desk: What is looked at.
        words: Translates our own texts.
        told: Translates what a submission did.
    """
    parts = []
    if desk.fault is not None:
        parts.append(one_line(str(desk.fault)))
    if desk.is_loading:
        parts.append(words("loading ..."))
    parts += _of_build(desk, words)
    if desk.subject is not None:
        parts.append(words("{faces} faces").format(faces=f"{len(desk.subject.mesh.faces):,}"))
    if desk.stage is not None:
        parts += _of_stage(desk.stage, words, told)
    if is_old(desk):
        parts.append(words("the picture is of an earlier view"))
    return "   ".join(parts)


def is_vain(desk: Desk) -> bool:
    """Whether what was wanted first cannot be had, so that there is nothing to look at."""
    return desk.subject is None and not desk.is_loading and desk.fault is not None


def _of_build(desk: Desk, words: Words) -> list[str]:
    if desk.is_building:
        return [words("compiling ...")]
    if desk.product is None or desk.product.engine is not None:
        return []
    parts = [words("It does not compile.")]
    if desk.stage is not None:
        parts.append(words("what is shown is the last build that did"))
    return parts


def _of_stage(stage: Stage, words: Words, told: Words) -> list[str]:
    traced, parts = stage.traced, []
    if stage.trouble:
        parts.append(one_line(told(stage.trouble), 200))
    if stage.tree is not None:
        parts.append(words("{nodes} nodes").format(nodes=f"{stage.tree.node_count:,}"))
    if stage.state is State.CONSTRUCTING:
        parts.append(words("construct runs ..."))
    elif stage.subject.tree is not None:
        parts.append(words("the tree is the model solution's"))
    else:
        parts.append(f"construct {1000 * stage.construct_seconds:.0f} ms")
    if traced.orbit is not None:
        parts.append(f"intersect {1000 * traced.seconds:.0f} ms")
        parts.append(f"{100 * traced.share:.0f} %")
    return parts

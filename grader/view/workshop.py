"""From a path to a library that can be looked at, as often as the file is saved."""

from dataclasses import dataclass
from pathlib import Path

from grader.build.reference import reference_library
from grader.model.stages import Diagnostic, Rejected
from grader.options import Options
from grader.pipeline import compiled, isolation_of
from grader.run.session import Engine
from grader.sandbox.nursery import Nursery
from grader.sandbox.selftest import unconfined
from grader.selection import select
from grader.solution import GENEROUS


@dataclass(frozen=True, slots=True)
class Product:
    """What became of a submission: an engine, or why there is none."""

    engine: Engine | None
    refused: str = ""
    """Why it was not even compiled."""

    diagnostics: tuple[Diagnostic, ...] = ()
    seconds: float = 0.0
    """Of compiling."""

    sha256: str = ""
    """Of the source."""


def built(path: Path, folder: Path, nursery: Nursery, options: Options) -> Product:
    """Compile a submission.

    Args:
        path: The submission.
        folder: A fresh folder of ours, kept as long as the engine is used.
        nursery: Keeps its boxes.
        options: The rubric and the isolation.

    Raises:
        UsageError: The path or the rubric is wrong.
        GraderError: Our own fault; nothing is concluded about the submission.
    """
    found = compiled(path, folder, options, frozenset())
    if isinstance(found, Rejected):
        return Product(None, found.reason)
    submission, build = found
    told = (build.diagnostics, build.seconds, submission.sha256)
    if build.library is None:
        return Product(None, "", *told)
    limits = select(options.rubric, ()).rubric.limits
    engine = Engine(build.library, limits, isolation_of(options), nursery=nursery)
    return Product(engine, "", *told)


def our_own(nursery: Nursery) -> Engine:
    """Return the model solution's engine, to compare with.

    Raises:
        BuildFault: It does not compile.
    """
    return Engine(reference_library(), GENEROUS, unconfined(), nursery=nursery)

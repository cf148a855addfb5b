"""Does every counterexample open? `python -m tests.view.every [TEXT]` opens them all.

Of each wrong submission, or of those with TEXT in their names, the small inputs are looked for
as `certify --counterexamples` does, written, and opened with the submission as `view --check`
does. A line each, and status 1 if one does not open.
"""

import sys
import tempfile
from pathlib import Path

from grader.certify.corpus import corpus_folder, name_of
from grader.certify.matrix import SEED
from grader.cli.progress import silent
from grader.counterexample.written import to_text
from grader.errors import GraderError
from grader.model.counterexample import Counterexample
from grader.options import Options
from grader.pipeline import grade_one
from grader.sandbox.crew import mapped
from grader.view.desk import Desk
from grader.view.screenshot import wait
from grader.view.study import Study
from grader.view.subject import of_file

JOBS = 2
SIDE = 24
"""Pixels of the picture that is traced, too."""

Line = tuple[str, str]
"""Id of a check, and why its input does not open; empty if it does."""


def every_input(path: Path) -> list[Line]:
    """Grade a submission, and open each small input that was found."""
    options = Options(SEED, None, (), silent, counterexamples=True)
    try:
        grade = grade_one(path, options)
        found = [one.counterexample for one in grade.checks if one.counterexample]
        return [(one.check, _fault(path, one)) for one in found]
    except GraderError as fault:
        return [("grade", str(fault))]


def _fault(path: Path, found: Counterexample) -> str:
    """Say why an input does not open; empty if it does."""
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "found.json"
        file.write_text(to_text(found))
        options = Options(SEED, None, (), silent)
        with Desk(path, options, lambda: of_file(file)) as desk:
            study = Study(desk)
            try:
                desk.resize(SIDE, SIDE)
                refused = wait(desk, study)
            finally:
                study.close()
            if refused or desk.stage is None:
                return refused or "there is no stage"
            told = study.walk is not None or study.facts is not None
            if told or desk.stage.trouble or not len(desk.stage.subject.mesh.faces):
                return "" if study.remark else "the check's words are not told"
            return "neither a node nor a ray is looked at"


def main(text: str) -> int:
    """Open them all; the exit status."""
    paths = [path for path in sorted(corpus_folder().glob("wrong/*.cpp")) if text in path.name]
    opened = failed = 0
    orders = [(path,) for path in paths]
    for path, lines in zip(paths, mapped(every_input, orders, JOBS), strict=True):
        for check, fault in lines:
            opened, failed = opened + (not fault), failed + bool(fault)
            sys.stdout.write(f"{name_of(path)} {check} {fault or 'opens'}\n")
            sys.stdout.flush()
    sys.stdout.write(f"{opened} of {opened + failed} counterexamples open\n")
    return int(failed > 0 or not opened)


if __name__ == "__main__":
    sys.exit(main(sys.argv[1] if len(sys.argv) > 1 else ""))

"""Does every counterexample open? `python -m tests.view.every FOLDER` opens them all.

FOLDER is what `bvhgrade certify --counterexamples --into FOLDER` wrote. Each file is opened
with the submission that it is of, as `view --check` does. A line each, and status 1 if one does
not open.
"""

import sys
from pathlib import Path

from grader.certify.corpus import corpus_folder
from grader.certify.matrix import SEED
from grader.cli.progress import silent
from grader.errors import GraderError
from grader.options import Options
from grader.sandbox.crew import mapped
from grader.view.desk import Desk
from grader.view.screenshot import wait
from grader.view.study import Study
from grader.view.subject import of_file

JOBS = 2
SIDE = 24
"""Pixels of the picture that is traced, too."""


def fault_of(file: Path) -> str:
    """Open a counterexample, and say why it does not open; empty if it does."""
    try:
        return _opened(file)
    except GraderError as fault:
        return str(fault)


def _opened(file: Path) -> str:
    submission = corpus_folder() / "wrong" / f"{file.parent.name}.cpp"
    options = Options(SEED, None, (), silent)
    with Desk(submission, options, lambda: of_file(file)) as desk:
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


def main(folder: Path) -> int:
    """Open them all; the exit status."""
    files = sorted(folder.glob("*/*.json"))
    opened = 0
    orders = [(file,) for file in files]
    for file, fault in zip(files, mapped(fault_of, orders, JOBS), strict=True):
        opened += not fault
        sys.stdout.write(f"{file.parent.name} {file.stem} {fault or 'opens'}\n")
        sys.stdout.flush()
    sys.stdout.write(f"{opened} of {len(files)} counterexamples open\n")
    return int(opened < len(files) or not files)


if __name__ == "__main__":
    sys.exit(main(Path(sys.argv[1])))

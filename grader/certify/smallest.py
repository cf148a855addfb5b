"""How small are the inputs that show mistakes? Of each failed check of the corpus, the size.

They are looked for in grades of their own, with the matrix's seed: the search takes time, moves
no point, and so has no place in the rows of the matrix.
"""

import csv
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import asdict, dataclass, replace
from pathlib import Path
from shutil import rmtree
from statistics import median
from tempfile import TemporaryDirectory

from grader.certify.corpus import corpus_folder, digest_of, name_of
from grader.certify.ledger import Ledger
from grader.certify.matrix import SEED
from grader.certify.row import Row
from grader.certify.state import states_told
from grader.counterexample.written import to_text
from grader.errors import GraderError
from grader.model.cases import BuildCase, SourceCase
from grader.model.grade import CheckScore
from grader.model.verdict import Verdict
from grader.options import Options
from grader.pipeline import grade_one
from grader.sandbox.crew import mapped
from grader.verify import every_check

ENTRY = "smallest"
"""What a ledger calls the sizes of one file."""

COLUMNS = ("check", "submission", "faces", "rays", "grader")

WITHOUT_INPUT = frozenset(
    each.id for each in every_check() if each.kind in (BuildCase, SourceCase)
)
"""Checks that look at the file, and at no input."""


@dataclass(frozen=True, slots=True)
class Smallest:
    """The smallest input that was found to fail a check with a submission."""

    check: str
    submission: str
    faces: int | None
    """None if no small input was found."""

    rays: int | None
    grader: str = ""
    """State of the grader that looked for it; empty until it is stored, or if unknown."""


def smallest_file() -> Path:
    """Where the sizes are stored."""
    return corpus_folder() / "counterexamples.csv"


def smallest_inputs(path: Path, into: Path | None) -> list[Smallest] | None:
    """Grade a submission and look for small inputs; None if our own fault kept us from it.

    Args:
        path: The submission.
        into: Where a folder of the submission's name gets the inputs as `check` writes them.
    """
    options = Options(SEED, None, (), lambda *_: None, counterexamples=True)
    try:
        grade = grade_one(path, options)
    except GraderError:
        return None
    if grade.needs_review:
        return None
    if into:
        inputs = ((one.check, one.counterexample) for one in grade.checks)
        texts = {check: to_text(found) for check, found in inputs if found}
        write_inputs(into / path.stem, texts)
    failed = (one for one in grade.checks if one.verdict is Verdict.FAIL)
    return [_size(name_of(path), one) for one in failed if one.check not in WITHOUT_INPUT]


def write_inputs(folder: Path, texts: Mapping[str, str]) -> None:
    """Write the inputs of one submission by check; a folder that is there holds all of them."""
    folder.parent.mkdir(parents=True, exist_ok=True)
    with TemporaryDirectory(dir=folder.parent) as scratch:
        written = Path(scratch) / folder.name
        written.mkdir()
        for check, text in texts.items():
            (written / f"{check}.json").write_text(text)
        rmtree(folder, ignore_errors=True)
        written.rename(folder)


def _size(name: str, score: CheckScore) -> Smallest:
    found = score.counterexample
    return Smallest(
        score.check, name, found.faces if found else None, found.rays if found else None
    )


def searched(
    paths: Sequence[Path],
    jobs: int,
    ledger: Ledger,
    tell: Callable[[str, Sequence[Smallest] | None], None],
    into: Path | None = None,
) -> list[Smallest]:
    """Search what is missing in the ledger, and return all that is known of these files.

    Args:
        paths: Wrong submissions.
        jobs: How many processes.
        ledger: Where results are kept.
        tell: Called with each file and what was found, at once; what it refuses is not kept.
        into: A folder for the inputs; what is missing there is searched, too.
    """
    keys = {(name_of(path), digest_of(path)): path for path in paths}

    def known() -> dict[tuple[str, str], list[Smallest]]:
        told = ((line["name"], line["digest"], line["sizes"]) for line in ledger.entries(ENTRY))
        return {
            (name, digest): [Smallest(**one) for one in sizes]
            for name, digest, sizes in told
            if (name, digest) in keys
        }

    done = known()

    def there(path: Path) -> bool:
        return into is None or (into / path.stem).is_dir()

    waiting = [key for key, path in keys.items() if key not in done or not there(path)]
    orders = [(keys[key], into) for key in waiting]
    results = mapped(smallest_inputs, orders, jobs)
    for (name, digest), found in zip(waiting, results, strict=True):
        tell(name, found)
        if found is not None:
            sizes = [asdict(one) for one in found]
            ledger.enter(ENTRY, {"name": name, "digest": digest, "sizes": sizes})
    return [one for found in known().values() for one in found]


def store_smallest(found: Sequence[Smallest], known: Iterable[Path], grader: str) -> None:
    """Write the sizes of these files, and keep those of others.

    Args:
        found: All that was found of some files.
        known: All files there are; sizes of others are dropped.
        grader: The state of the grader that found them.
    """
    found = [replace(one, grader=grader) for one in found]
    fresh = {one.submission for one in found}
    names = {name_of(path) for path in known}
    kept = [one for one in stored_smallest() if one.submission in names - fresh]
    lines = sorted([*kept, *found], key=lambda one: (one.check, one.submission))
    with smallest_file().open("w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows(asdict(one) for one in lines)


def stored_smallest() -> list[Smallest]:
    """Read the sizes of the last search of each file."""
    if not smallest_file().exists():
        return []
    with smallest_file().open(newline="") as file:
        return [
            Smallest(
                line["check"],
                line["submission"],
                _number(line["faces"]),
                _number(line["rays"]),
                line["grader"],
            )
            for line in csv.DictReader(file)
        ]


def _number(text: str) -> int | None:
    return int(text) if text else None


def failing_pairs(rows: Iterable[Row]) -> int:
    """Count files and checks that fail with them, as far as an input can be looked for."""
    return sum(check not in WITHOUT_INPUT for row in rows for check in row.failed)


def smallest_lines(sizes: Sequence[Smallest], pairs: int) -> list[str]:
    """Word the table: a line for each check, and all of them together.

    Args:
        sizes: What was stored.
        pairs: How many files and checks could have been searched.
    """
    lines = [
        f"Searched: {len(sizes)} of {pairs} failing pairs of a file and a check.\n",
        f"By state of the grader: {states_told(one.grader for one in sizes)}.\n\n",
        "| check | failed | found | faces | rays | most faces |\n",
        "|---" + "|---:" * 5 + "|\n",
    ]
    for each in every_check():
        mine = [one for one in sizes if one.check == each.id]
        if mine:
            lines.append(_line(f"`{each.id}`", mine))
    return [*lines, _line("all", sizes)]


def _line(title: str, sizes: Sequence[Smallest]) -> str:
    faces = [one.faces for one in sizes if one.faces is not None]
    rays = [one.rays for one in sizes if one.rays]
    told = (f"{median(each):g}" if each else "" for each in (faces, rays))
    cells = (title, len(sizes), len(faces), *told, max(faces, default=""))
    return f"| {' | '.join(str(cell) for cell in cells)} |\n"

"""Which grader is this? Two of one version differ while somebody works on it."""

import hashlib
from collections.abc import Collection, Iterator
from pathlib import Path

from grader import resources
from grader.build.compiler import find_compiler

WITHOUT_VERDICT = (
    *("batch", "bench", "certify", "cli", "counterexample", "diagnose", "gallery", "gradebook"),
    *("locale", "package", "report", "similar", "view", "__pycache__"),
)
"""Folders of the package that decide nothing."""

WITHOUT_SIZES = tuple(each for each in WITHOUT_VERDICT if each != "counterexample")
"""Folders that do not decide how small a counterexample is either."""

WITHOUT_RESULT = (
    *("batch", "bench", "certify", "cli", "gradebook", "package", "similar", "view"),
    "__pycache__",
)
"""Folders of which nothing is in a stored result."""

_ENDINGS = {".py", ".toml", ".txt", ".cpp", ".h", ".npz", ".exr", ".answers", ".obj", ".csv"}


def grader_digest(without: Collection[str] = WITHOUT_VERDICT) -> str:
    """Digest of all that a verdict depends on: the grader, the exercise and the compiler.

    Args:
        without: Folders of the package that do not matter.
    """
    package = Path(resources.__file__).parent
    folders = [package, resources.stub_folder(), resources.scenes_folder()]
    files = [
        resources.reference_source(),
        *(file for each in folders for file in _files(each, without)),
    ]
    digest = hashlib.sha256(find_compiler().title.encode())
    for path in files:
        digest.update(f"{path.name}\0".encode() + hashlib.sha256(path.read_bytes()).digest())
    return digest.hexdigest()[:16]


def _files(folder: Path, without: Collection[str]) -> Iterator[Path]:
    leftovers = folder == resources.stub_folder()
    for path in sorted(folder.rglob("*")):
        inside = path.relative_to(folder).parts
        # What a compiler left behind in the exercise's folder; the package's own is a stage.
        skipped = inside[0] in {*without, "data"} or (inside[0] == "build" and leftovers)
        if path.is_file() and path.suffix in _ENDINGS and not skipped:
            yield path

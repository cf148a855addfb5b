"""Where is the library of our own solution, built once and kept?"""

import hashlib
import os
import shutil
import tempfile
from pathlib import Path

from grader import resources
from grader.build.compile import compile_reference
from grader.build.compiler import find_compiler
from grader.build.workspace import GRADED, workspace
from grader.model.stages import SOURCE_NAME, Submission


def reference_library() -> Path:
    """Return the reference's graded library, compiled now if it is not in the cache.

    Its name holds a digest of the solution and of everything it was compiled with, so it also
    names the trees that it builds.

    Raises:
        BuildFault: It does not compile.
    """
    source = resources.reference_source().read_bytes()
    framework = workspace(find_compiler(), GRADED)
    digest = hashlib.sha256(source + repr(framework).encode()).hexdigest()
    folder = resources.private_cache("reference")
    library = folder / f"{digest[:24]}.so"
    if not library.exists():
        folder.mkdir(parents=True, exist_ok=True)
        with tempfile.TemporaryDirectory(dir=folder) as scratch:
            submission = Submission("reference", SOURCE_NAME, source, digest)
            made = compile_reference(submission, Path(scratch) / "build")
            # Renaming is atomic: another process finds the whole library or none.
            shutil.copyfile(made, Path(scratch) / library.name)
            os.replace(Path(scratch) / library.name, library)  # noqa: PTH105 - atomicity is the point
    return library

"""How does the grader that runs here get onto another machine? As a wheel of its own files.

It is made from what is installed, so that neither a checkout nor a tool that builds wheels is
needed. Source: the binary distribution format of the Python Packaging User Guide.
"""

import base64
import csv
import hashlib
import io
import re
from collections.abc import Iterable, Iterator
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path

from grader import resources
from grader.errors import GraderError
from grader.package.archive import Member, below, files_of, zipped
from grader.package.exercise import exercise

NAME = "bvhgrade"

NAME_OF_REQUIREMENT = re.compile(r"[A-Za-z0-9]([A-Za-z0-9._-]*[A-Za-z0-9])?")

FORMAT = """\
Wheel-Version: 1.0
Generator: bvhgrade
Root-Is-Purelib: true
Tag: py3-none-any
"""


def own_wheel() -> Member:
    """Pack the installed grader with the exercise, the reference and the scenes.

    Raises:
        UsageError: The exercise is not as it is to be handed out.
        GraderError: The installation does not know its own name.
    """
    installed = _installed()
    information = f"{NAME}-{installed.version}.dist-info"
    members = [
        *below("grader", files_of(_package(), ("data",))),
        *below("grader/data/student_stub", exercise()),
        *below("grader/data/reference", files_of(resources.reference_source().parents[1])),
        *below("grader/data/scenes", files_of(resources.scenes_folder())),
        *below(information, _information(installed)),
    ]
    record = Member(f"{information}/RECORD", _record(members, f"{information}/RECORD"))
    return Member(f"{NAME}-{installed.version}-py3-none-any.whl", zipped([*members, record]))


def pinned() -> str:
    """Write constraints for pip: the versions of all that the grader needs, as they are here.

    Raises:
        GraderError: The installation does not know its own name.
    """
    versions = dict(_needed(_installed(), set()))
    return "".join(f"{name}=={versions[name]}\n" for name in sorted(versions))


def _installed() -> Distribution:
    try:
        return distribution(NAME)
    except PackageNotFoundError as fault:
        raise GraderError(
            f"{NAME} is not installed as a package, but a course gets it as one; "
            "install it with pip, in a checkout with `pip install -e .`"
        ) from fault


def _package() -> Path:
    return Path(resources.__file__).parent


def _information(installed: Distribution) -> Iterator[Member]:
    yield Member("WHEEL", FORMAT.encode())
    for name in ("METADATA", "entry_points.txt"):
        yield Member(name, (installed.read_text(name) or "").encode())


def _record(members: Iterable[Member], own: str) -> bytes:
    text = io.StringIO()
    rows = csv.writer(text, lineterminator="\n")
    for one in members:
        digest = base64.urlsafe_b64encode(hashlib.sha256(one.data).digest()).rstrip(b"=")
        rows.writerow((one.name, f"sha256={digest.decode()}", len(one.data)))
    rows.writerow((own, "", ""))
    return text.getvalue().encode()


def _needed(installed: Distribution, seen: set[str]) -> Iterator[tuple[str, str]]:
    """Walk through requirements; those of extras and of other platforms are not installed."""
    for requirement in installed.requires or ():
        named = NAME_OF_REQUIREMENT.match(requirement)
        if named is None or "extra ==" in requirement.partition(";")[2]:
            continue
        name = named[0].lower().replace("_", "-")
        if name in seen:
            continue
        seen.add(name)
        try:
            found = distribution(name)
        except PackageNotFoundError:
            continue
        yield name, found.version
        yield from _needed(found, seen)

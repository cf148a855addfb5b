"""Whose is what in a download: of Moodle, Canvas, Gradescope, GitHub Classroom, or by hand?

Sources: names of folders and files in Moodle's mod/assign (`NAME_ID_assignsubmission_PLUGIN`);
Canvas' lib/content_zipper.rb, `get_filename` and `add_upload_submission`
(`NAME[_LATE]_USER_ATTACHMENT_FILE`); an export of Gradescope, which holds folders and
`submission_metadata.yml`; `gh classroom clone student-repos`, which makes a folder
`ASSIGNMENT-submissions` with one `ASSIGNMENT-LOGIN` for each student.

The name of one student's file must not decide about others: a layout is one that all have, and
what is not taken for a submission is listed.
"""

import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from itertools import chain

from grader.batch.gradescope import METADATA, Submitter, submitters
from grader.batch.sources import Item, Source, notes
from grader.gradebook.marks import HANDED_IN, moodle_mark
from grader.intake.candidates import Entry

_CANVAS = re.compile(r"(.+?)(?:_LATE)?_(\d+)_(\d+)_(.+)", re.DOTALL)
_CANVAS_ANONYMOUS = re.compile(r"(?:LATE_)?(anon_([A-Za-z0-9]+))_(\d+)_(.+)", re.DOTALL)
_CANVAS_COPY = re.compile(r"(exercise03)-\d+(\.cpp)")
_GITHUB = "-submissions"


@dataclass(frozen=True, slots=True)
class Member:
    """An item of the class that belongs to a student."""

    item: str
    path: str = ""
    """What a file was called when it was handed in; empty if it still is."""


@dataclass(frozen=True, slots=True)
class Place:
    """Where the submission of one student lies."""

    key: str
    """Tells it from all others in this class, in every run."""

    name: str
    """Of the student, as a stranger or a learning system wrote it."""

    members: tuple[Member, ...]
    id: str = ""
    """What the learning system calls the student or the submission; empty if it was no one."""

    email: str = ""

    def entries(self, source: Source) -> Iterator[Entry]:
        """List what was handed in.

        Raises:
            OSError: It is gone, or may not be read.
        """
        for member in self.members:
            for entry in source.entries(member.item):
                yield Entry(member.path or entry.path, entry.read)


@dataclass(frozen=True, slots=True)
class Arrangement:
    """A class, arranged by students."""

    layout: str
    source: Source
    places: list[Place]
    others: tuple[str, ...] = ()
    """What lies beside the submissions and is nobody's."""


def arranged(source: Source, name: str) -> Arrangement:
    """Find out who handed in what.

    Args:
        source: The class.
        name: Of its folder or zip.
    """
    items = source.items()
    results = [one for one in items if _is_of_results(source, one)]
    members = [one for one in items if one not in results]
    if len(members) == 1 and members[0].is_folder:
        inner = source.within(members[0].name)
        if _is_wrapper(inner):
            found = arranged(inner, members[0].name)
            return replace(found, others=(*found.others, *(one.name for one in results)))
    layout, places = _arranged(source, members, name.removesuffix(".zip"))
    taken = {member.item for place in places for member in place.members} | {METADATA}
    if layout == "Moodle":
        # A remark beside a file is its student's.
        taken |= {one.name for one in items if moodle_mark(one.name)}
    others = tuple(one.name for one in items if one.name not in taken)
    return Arrangement(layout, source, places, others)


def _arranged(source: Source, items: Sequence[Item], stem: str) -> tuple[str, list[Place]]:
    """Find the layout, and whose is what."""
    if METADATA in [item.name for item in items]:
        return "Gradescope", list(_gradescope(source, items))
    for layout, read in (("Moodle", _moodle), ("Canvas", _canvas)):
        if places := read(items):
            return layout, places
    prefix = stem.removesuffix(_GITHUB) + "-" if stem.endswith(_GITHUB) else ""
    if prefix and all(one.name.startswith(prefix) for one in items if one.is_folder):
        return "GitHub Classroom", list(_github(items, prefix))
    own = (one for one in items if _is_own(one))
    return "plain", [Place(one.name, _stem(one), (Member(one.name),)) for one in own]


def _is_of_results(source: Source, item: Item) -> bool:
    """It is what `batch -o` wrote: there is a store, and nothing that anybody handed in."""
    try:
        return item.holds_store and not _holds_source(source, item)
    except OSError:
        # Whoever reads it as a submission tells what is wrong with it.
        return False


def _is_wrapper(inner: Source) -> bool:
    """A folder holds a class and is no submission: what is in it is several people's."""
    items = inner.items()
    own = [item for item in items if _is_own(item)]
    if METADATA in [item.name for item in items] or _moodle(items) or _canvas(items):
        return True
    return len(own) >= 2 and all(_holds_source(inner, item) for item in own)


def _holds_source(source: Source, item: Item) -> bool:
    if not item.is_folder:
        return True
    return any(entry.path.lower().endswith(HANDED_IN) for entry in source.entries(item.name))


def _is_own(item: Item) -> bool:
    return item.is_folder or item.name.lower().endswith(HANDED_IN)


def _stem(item: Item) -> str:
    if item.is_folder:
        return item.name
    ending = max((e for e in HANDED_IN if item.name.lower().endswith(e)), key=len)
    return item.name[: len(item.name) - len(ending)] or item.name


def _moodle(items: Sequence[Item]) -> list[Place]:
    """One file to grade, or one folder, without this mark shows that it is no such download."""
    found: dict[tuple[str, str], dict[str, list[Member]]] = {}
    for item in items:
        if mark := moodle_mark(item.name):
            member = Member(item.name, "" if item.is_folder else mark.file)
            plugins = found.setdefault((mark.full_name, mark.participant), {})
            plugins.setdefault(mark.plugin, []).append(member)
        elif _is_own(item):
            return []
    return [
        # What was typed beside a file is a remark and no submission.
        Place(f"{name}_{id}", name, tuple(plugins.get("file") or chain(*plugins.values())), id)
        for (name, id), plugins in found.items()
    ]


def _canvas(items: Sequence[Item]) -> list[Place]:
    """One folder, or one file without these numbers, shows that it is no such download."""
    found: dict[tuple[str, str], list[Member]] = {}
    for item in items:
        match = _CANVAS_ANONYMOUS.fullmatch(item.name) or _CANVAS.fullmatch(item.name)
        if item.is_folder or not match:
            return []
        name, id, _, file = match.groups()
        # Canvas counts what is handed in again under the same name.
        path = _CANVAS_COPY.sub(r"\1\2", file) if _CANVAS_COPY.fullmatch(file) else file
        found.setdefault((name, id), []).append(Member(item.name, path))
    return [
        Place(f"{name}_{id}", name, tuple(members), id) for (name, id), members in found.items()
    ]


def _gradescope(source: Source, items: Sequence[Item]) -> Iterator[Place]:
    """A submission of a group is one of each of its members: all of them get the points."""
    file = notes(source, METADATA)
    known = submitters(file) if file else {}
    for item in items:
        if item.is_folder:
            for who in known.get(item.name, []) or [Submitter(item.name, "", "")]:
                key = f"{item.name}/{who.id or who.email or who.name}"
                yield Place(key, who.name, (Member(item.name),), who.id, who.email)


def _github(items: Sequence[Item], prefix: str) -> Iterator[Place]:
    for item in items:
        if item.is_folder:
            login = item.name.removeprefix(prefix)
            yield Place(item.name, login, (Member(item.name),), login)

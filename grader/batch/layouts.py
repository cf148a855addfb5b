"""Whose is what in a download: of Moodle, Canvas, Gradescope, GitHub Classroom, or by hand?

Sources: names of folders and files in Moodle's mod/assign (`NAME_ID_assignsubmission_PLUGIN`);
Canvas' lib/content_zipper.rb, `get_filename` and `add_upload_submission`
(`NAME[_LATE]_USER_ATTACHMENT_FILE`); an export of Gradescope, which holds folders and
`submission_metadata.yml`; `gh classroom clone student-repos`, which makes a folder
`ASSIGNMENT-submissions` with one `ASSIGNMENT-LOGIN` for each student.

The name of one student's file must not decide about others: a layout is one that all have, and
what is not taken for a submission is listed. Who it is in the next download, too, is said by
the platform's own number and not by a name, which changes.
"""

import re
from collections import Counter
from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from itertools import chain

from grader.batch.gradescope import METADATA, Submitter, submitters
from grader.batch.keys import anonymous_key, gradescope_key, key_of, stem_of
from grader.batch.sources import Item, Source, notes
from grader.errors import UsageError
from grader.gradebook.marks import ARCHIVES, HANDED_IN, MEANT, moodle_mark
from grader.intake.candidates import Entry, is_source
from grader.output import OUTPUT
from grader.plain import as_name

_CANVAS_FILE = r"_(?:\d+_(.+)|(?:text|link)\.html)"
"""A file with a number of its own, or what was typed, which Canvas writes into one."""

_CANVAS = re.compile(r"(.+?)(?:_LATE)?_(\d+)" + _CANVAS_FILE, re.DOTALL)
_CANVAS_ANONYMOUS = re.compile(r"(?:LATE_)?(anon_([A-Za-z0-9]+))" + _CANVAS_FILE, re.DOTALL)
_CANVAS_COPY = re.compile(r"^(exercise03)-\d+(\.cpp)\Z")
_OF_GRADESCOPE = re.compile(r"submission_\d+")
_GITHUB = "-submissions"

FEWEST = 2
"""Submissions in a folder that make it a class."""

MOST_NAMED = 3


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
    """Tells the student from all others in this class, in every run and every download."""

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
    results = [one for one in items if one.name == OUTPUT or _is_of_results(source, one)]
    members = [one for one in items if one not in results]
    stem = name.removesuffix(".zip")
    if len(members) == 1 and members[0].is_folder and not _is_marked(members[0].name, stem):
        inner = source.within(members[0].name)
        if _is_wrapper(inner, members[0].name):
            found = arranged(inner, members[0].name)
            return replace(found, others=(*found.others, *(one.name for one in results)))
    layout, places = _arranged(source, members, stem)
    taken = {member.item for place in places for member in place.members} | {METADATA}
    if layout == "Moodle":
        # A remark beside a file is its student's.
        taken |= {one.name for one in items if moodle_mark(one.name)}
    others = tuple(one.name for one in items if one.name not in taken)
    return Arrangement(layout, source, list(_told_apart(layout, places)), others)


def _told_apart(layout: str, places: Sequence[Place]) -> Iterator[Place]:
    """Two of one download stay two, and nobody's file is taken for somebody else's."""
    times = Counter(place.key for place in places)
    for place in places:
        word = place.members[0].item if layout in {"plain", "Gradescope"} else place.name
        yield replace(place, key=f"{place.key}/{word}") if times[place.key] > 1 else place


def _arranged(source: Source, items: Sequence[Item], stem: str) -> tuple[str, list[Place]]:
    """Find the layout, and whose is what."""
    if METADATA in [item.name for item in items]:
        return "Gradescope", list(_gradescope(source, items))
    for layout, read in (("Moodle", _moodle), ("Canvas", _canvas)):
        if places := read(items):
            return layout, places
    prefix, own = _prefix(stem), [one for one in items if _is_own(one)]
    marked = [one for one in own if prefix and one.is_folder and one.name.startswith(prefix)]
    if marked and marked == own:
        return "GitHub Classroom", list(_github(items, prefix))
    for layout, read in (("Moodle", _moodle), ("Canvas", _canvas)):
        _require_few(layout, own, [one for one in own if read([one])])
    _require_few("GitHub Classroom", own, marked)
    return "plain", list(_by_hand(items))


def _require_few(layout: str, own: Sequence[Item], marked: Sequence[Item]) -> None:
    """Refuse a download to which somebody has added something: all names would be lost.

    Raises:
        UsageError: Most of what lies there is such a download.
    """
    if 2 * len(marked) <= len(own):
        return
    odd = sorted({one.name for one in own} - {one.name for one in marked})
    names = ", ".join(f"`{as_name(name)}`" for name in odd[:MOST_NAMED])
    more = f" and {len(odd) - MOST_NAMED:,} more" if len(odd) > MOST_NAMED else ""
    raise UsageError(
        f"this looks like a download of {layout}, but {names}{more} is none of it; move that "
        "out of the folder, or give every submission a name of your own"
    )


def _prefix(stem: str) -> str:
    """How the folders of a clone of GitHub Classroom begin; empty if it is none."""
    return stem.removesuffix(_GITHUB) + "-" if stem.endswith(_GITHUB) else ""


def _is_marked(name: str, stem: str) -> bool:
    """A platform made this folder for one student, who decides what is in it."""
    prefix = _prefix(stem)
    # The folder of the whole clone begins as its zip does, and so as those of students.
    by_github = bool(prefix) and name.startswith(prefix) and not name.endswith(_GITHUB)
    return by_github or bool(moodle_mark(name) or _OF_GRADESCOPE.fullmatch(name))


def _is_of_results(source: Source, item: Item) -> bool:
    """It is what `batch -o` wrote: there is a store, and nothing that anybody handed in."""
    return item.holds_store and not _holds_source(source, item)


def _is_wrapper(inner: Source, name: str) -> bool:
    """A folder holds a class and is no submission: what is in it is several people's."""
    items = inner.items()
    own = [item for item in items if _is_own(item)]
    if any(is_source(item.name) and not item.is_folder for item in items):
        return False
    if METADATA in [item.name for item in items] or _moodle(items) or _canvas(items):
        return True
    if name.endswith(_GITHUB):
        return any(item.is_folder for item in items)
    if len(own) < FEWEST:
        return False
    # Somebody's folder may lack a file to grade; that is no reason to take all for one.
    several = sum(_is_handed_in(inner, item) for item in own) >= FEWEST
    return several or all(_holds_source(inner, item) for item in own)


def _is_handed_in(source: Source, item: Item) -> bool:
    """It is one submission more, and no part of one: it has the file, or an archive."""
    if not item.is_folder:
        return item.name.lower().endswith(ARCHIVES)
    return _holds(source, item, lambda path: is_source(path) or path.lower().endswith(ARCHIVES))


def _holds_source(source: Source, item: Item) -> bool:
    if not item.is_folder:
        return True
    return _holds(source, item, lambda path: path.lower().endswith(HANDED_IN))


def _holds(source: Source, item: Item, wanted: Callable[[str], bool]) -> bool:
    """One of the files in a folder is wanted, or we may not look into it."""
    try:
        return any(wanted(entry.path) for entry in source.entries(item.name))
    except OSError:
        # Whoever reads it as a submission tells what is wrong with it.
        return True


def _is_own(item: Item) -> bool:
    return item.is_folder or item.name.lower().endswith(HANDED_IN)


def _by_hand(items: Sequence[Item]) -> Iterator[Place]:
    """What was meant as a submission is one, unless there is a better one of that name."""
    graded = {_plain(item).key for item in items if _is_own(item)}
    for item in items:
        place = _plain(item)
        is_meant = item.name.lower().endswith(MEANT) and place.key not in graded
        if is_meant or _is_own(item):
            yield place


def _plain(item: Item) -> Place:
    stem = item.name if item.is_folder else stem_of(item.name)
    return Place(key_of("plain", stem), stem, (Member(item.name),))


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
        _place(key_of("Moodle", id), name, id, plugins) for (name, id), plugins in found.items()
    ]


def _canvas(items: Sequence[Item]) -> list[Place]:
    """One folder, or one file to grade without these numbers, shows that it is no such one."""
    found: dict[tuple[str, str], dict[str, list[Member]]] = {}
    keys: dict[tuple[str, str], str] = {}
    for item in items:
        anonymous = _CANVAS_ANONYMOUS.fullmatch(item.name)
        match = anonymous or _CANVAS.fullmatch(item.name)
        if _is_own(item) and (item.is_folder or not match):
            return []
        if not match:
            continue
        name, id, file = match.groups()
        keys[name, id] = anonymous_key(id) if anonymous else key_of("Canvas", id)
        # Canvas counts what is handed in again under the same name.
        path = _CANVAS_COPY.sub(r"\1\2", file or "text.html")
        kinds = found.setdefault((name, id), {})
        kinds.setdefault("file" if file else "typed", []).append(Member(item.name, path))
    return [_place(keys[name, id], name, id, kinds) for (name, id), kinds in found.items()]


def _place(key: str, name: str, id: str, kinds: Mapping[str, Sequence[Member]]) -> Place:
    """What was typed beside a file is a remark and no submission."""
    return Place(key, name, tuple(kinds.get("file") or chain(*kinds.values())), id)


def _gradescope(source: Source, items: Sequence[Item]) -> Iterator[Place]:
    """A submission of a group is one of each of its members: all of them get the points."""
    known = submitters(notes(source, METADATA))
    for item in items:
        if item.is_folder:
            for who in known.get(item.name, []) or [Submitter(item.name, "", "")]:
                key = gradescope_key(who.id, who.email, f"{item.name}/{who.name}")
                yield Place(key, who.name, (Member(item.name),), who.id, who.email)


def _github(items: Sequence[Item], prefix: str) -> Iterator[Place]:
    for item in items:
        if item.is_folder:
            login = item.name.removeprefix(prefix)
            key = key_of("GitHub Classroom", item.name)
            yield Place(key, login, (Member(item.name),), login)

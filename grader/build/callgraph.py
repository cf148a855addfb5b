"""Who calls whom in a submission, read from what the compiler makes of it.

The assembly text of a build without optimisation holds every call: nothing is inlined yet, and
overloads, templates and lambdas are already resolved to mangled names. A call through a pointer
is a call of `ANYTHING`, which in turn calls every function whose address is taken or stands in
a table; who takes it is listed too. A call of what stands at some place in a table of virtual
functions is one of `ANYTHING` at this place. A constructor or destructor with two names calls
itself by the other one. The text is the compiler's, but the names in it are the student's; they
are compared and never used for anything else.
"""

import re
from collections import defaultdict
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from itertools import islice

from grader.build.captures import Frame
from grader.build.lent import Lent
from grader.build.pointers import ANYTHING, POINTER_CALL, Pointers, at_place
from grader.model.stages import SOURCE_PATH, Call, CallGraph

MAX_CALLS = 200_000
"""A textbook solution has about 1,000; more than this is cut."""

MAX_ROWS = 500_000
MAX_BYTES = 24 << 20
"""What is read, each row once for each function that it lies in. The longest of 81 right files
makes 50,000 rows and 1.6 MB, one with `std::regex` and threads 190,000 and 6 MB; a macro can
make 200 million. A row takes 11 microseconds, and 1,000 bytes take 150."""

MOST_IN_A_ROW = 64
"""An instruction names two functions; a comment in it may name millions, for nobody to read."""

MOST_OWNERS = 16
"""Functions that a row may lie in. A compiler's do not overlap; inline assembly adds a few."""

MOST_NAMED = 1 << 20
"""Bytes of all different names together; of 81 right files none has more than 82,000, but one
with `std::regex` and threads has 330,000. All of these are looked into for 10 seconds."""

_KINDS = (b"function", b"object")
_WORD = rb"[\w.$\x80-\xff]{1,65536}"
_SYMBOL = re.compile(rb'^\s*\.type\s+"?(%b)"?,\s*[@%%](function|object)' % _WORD)
_ALIAS = re.compile(rb'^\s*\.(?:set|equ)\s+"?(%b)"?,\s*"?(%b)"?\s*$' % (_WORD, _WORD))
_LABEL = re.compile(rb'^"?(%b)"?:' % _WORD)
_END = re.compile(rb'^\s*\.size\s+"?(%b)"?,' % _WORD)
_NAME = re.compile(rb"[A-Za-z_\x80-\xff]%b" % _WORD)
_CALL = re.compile(rb"^(call|jmp|bl?$|b[lr]+$)")
_ELSEWHERE = re.compile(rb"(?:^|[^\w.$])([a-z]\w{0,80}|_Z(?:n[wa]|d[la])\w{1,20})@GOTPCREL")
_ELSEWHERE_ARM = re.compile(rb":got:([a-z]\w{0,80}|_Z(?:n[wa]|d[la])\w{1,20})\b")
_UNKNOWN = re.compile(
    rb'^\s*\.type\b(?!\s+"?%b"?,\s*[@%%]\w+(?:\s|$))' % _WORD
    + rb"|(?:^|;)\s*\.(?:macro|altmacro|rept|irpc?|include|incbin)\b"
)
"""What no compiler writes: a name that cannot be read, and text that makes text."""

_STRING = re.compile(rb"^\s*\.(?:ascii|asciz|string)\b")
"""Words of a program, in which anything may stand."""

_BYTES = re.compile(
    rb"^\.(?:(?:[248x]?byte|h?word|short|value|long|int|quad|octa|insn|inst|reloc)\b|dc\.)"
)
"""Data amid instructions, of which a compiler writes tables of its own labels only."""

_NAMED = (b"_Z", b"ex03_")
"""How functions begin that lie elsewhere and may lead back: of C++, and our own door."""

_CALLING_BACK = {
    *(b"qsort", b"bsearch", b"lfind", b"lsearch", b"twalk", b"tsearch", b"tfind"),
    *(b"pthread_create", b"pthread_once", b"thrd_create", b"call_once", b"makecontext"),
    *(b"atexit", b"on_exit", b"at_quick_exit", b"__cxa_atexit", b"__cxa_thread_atexit"),
    *(b"qsort_r", b"signal", b"sigaction", b"raise", b"clone"),
}
"""Functions of C that call what they are given."""

_OF_THE_LIBRARY = (b"_ZNSt", b"_ZSt", b"_ZNKSt")
_DATA = {b"stdin", b"stdout", b"stderr", b"environ"}
_TABLE = re.compile(rb"^\.(?:quad|xword|8byte)\s+(%b)" % _WORD)
_TABLE_BYTES = 8
_VIRTUAL, _TYPE = b"_ZTV", b"_ZTI"
"""How tables of virtual functions begin, and what stands in them before the functions."""

_FILE = re.compile(rb'^\s*\.file\s+(\d+)\s+(?:"[^"\n]*"\s+)?"([^"\n]*)"')
# Line 0 is a compiler's word for code that belongs to no line.
_LINE = re.compile(rb"^\s*\.loc\s+(\d+)\s+([1-9]\d{0,6})\b")


class Tangled(Exception):
    """A text would take hours to read, which no compiler writes by itself."""


@dataclass(slots=True)
class _Function:
    """What is known of one function up to a row."""

    frame: Frame = field(default_factory=Frame)
    pointers: Pointers = field(default_factory=Pointers)
    lent: Lent = field(default_factory=Lent)


@dataclass(slots=True)
class _Read:
    """What is known of the text so far; dictionaries keep an order that sets do not have."""

    functions: set[bytes]
    objects: set[bytes]
    calls: dict[tuple[bytes, bytes], None] = field(default_factory=dict)
    taken: dict[tuple[bytes, bytes], None] = field(default_factory=dict)
    lines: dict[bytes, int] = field(default_factory=dict)
    selves: dict[bytes, None] = field(default_factory=dict)
    places: dict[bytes, int] = field(default_factory=dict)
    """How far behind the type the next entry of a table of virtual functions stands."""

    inner: dict[bytes, _Function] = field(default_factory=lambda: defaultdict(_Function))

    @property
    def is_full(self) -> bool:
        """Whether no more is listed."""
        return len(self.calls) + len(self.taken) >= MAX_CALLS


def read_assembly(text: bytes) -> CallGraph:
    """List the calls, and the line of the student's file at which each function begins.

    Raises:
        Tangled: It is too long, too many functions overlap, their names are too long, or there
            is something in it that no compiler writes.
    """
    if len(text) > MAX_BYTES or text.count(b"\n") >= MAX_ROWS:
        raise Tangled
    rows = text.split(b"\n")
    own = {match[1] for row in rows if (match := _FILE.match(row)) and _is_own(match[2])}
    if any(_UNKNOWN.search(row) and not _STRING.match(row) for row in rows):
        raise Tangled
    symbols = [match for row in rows if (match := _SYMBOL.match(row))]
    functions, objects = ({each[1] for each in symbols if each[2] == kind} for kind in _KINDS)
    functions |= {match[1] for row in rows if (match := _ALIAS.match(row))} - objects
    read = _Read(functions, objects)
    for owner, row in _placed(rows, read):
        if (line := _LINE.match(row)) and owner and line[1] in own:
            read.lines.setdefault(owner, int(line[2]))
        elif not read.is_full:
            _note(read, owner, row)
            inner = read.inner[owner]
            read.selves |= dict.fromkeys(filter(None, [inner.frame.read(row)]))
            inner.pointers.read(row)
    unclear = [(owner, inner.lent.end()) for owner, inner in read.inner.items()]
    read.calls |= dict.fromkeys((owner, name) for owner, name in unclear if name)
    named = {name for pair in (*read.calls, *read.taken) for name in pair}
    if sum(map(len, named)) > MOST_NAMED:
        raise Tangled
    # Each name once: 200,000 pairs of long ones would be gigabytes.
    texts = {name: _text(name) for name in named}
    return CallGraph(
        calls=_pairs(read.calls, texts),
        lines=tuple((_text(name), line) for name, line in read.lines.items()),
        taken=_pairs(read.taken, texts),
        selves=tuple(map(_text, read.selves)),
    )


def _pairs(
    pairs: Iterable[tuple[bytes, bytes]], texts: Mapping[bytes, str]
) -> tuple[Call, ...]:
    return tuple(Call(texts[a], texts[b]) for a, b in pairs)


def _placed(rows: list[bytes], read: _Read) -> Iterator[tuple[bytes, bytes]]:
    """Each row with the function it lies in, or the table; nothing if its name is not known.

    A function ends at the last `.size` of its name: inline assembly can write labels and ends
    of its own, but not take the compiler's away. What it puts around a row is listed besides.
    A label lies in the function that it begins.
    """
    ends = {end[1]: number for number, row in enumerate(rows) if (end := _END.match(row))}
    inside: dict[bytes, None] = {}
    table = b""
    placed = size = 0
    for number, row in enumerate(rows):
        if label := _LABEL.match(row):
            name = label[1]
            table = name if name in read.objects else b""
            if name in read.functions and ends.get(name, 0) > number:
                inside[name] = None
                if len(inside) > MOST_OWNERS:
                    raise Tangled
        elif end := _END.match(row):
            table = b""
            if ends[end[1]] == number:
                inside.pop(end[1], None)
            continue
        owners = inside or [table]
        placed += len(owners)
        size += len(owners) * len(row)
        if placed > MAX_ROWS or size > MAX_BYTES:
            raise Tangled
        yield from ((owner, row) for owner in owners)


def _is_own(name: bytes) -> bool:
    return name.decode(errors="replace").endswith(SOURCE_PATH)


def _note(read: _Read, owner: bytes, row: bytes) -> None:
    """Take down the calls in one row and the functions and tables whose address is in it."""
    row = row.strip()
    if owner in read.functions and (b";" in row or _BYTES.match(row)):
        _note_hidden(read, owner, row)
    if row.startswith(b"."):
        _note_data(read, owner, row)
    elif owner in read.functions:
        _note_instruction(read, owner, row)


def _note_instruction(read: _Read, owner: bytes, row: bytes) -> None:
    inner = read.inner[owner]
    if lender := inner.lent.read(row):
        read.calls[owner, lender] = None
    if POINTER_CALL.match(row):
        if called := inner.pointers.called(row):
            read.calls[owner, called] = None
        return
    if inner.lent.lends(row) or _LABEL.match(row):
        return
    verb, *words = row.split(None, 1) or [b""]
    names = _named_in(words[0]) if words else []
    known = [name for name in names if name in read.functions or name.startswith(_NAMED)]
    if _CALL.match(verb):
        back = [name for name in names if name in _CALLING_BACK]
        read.calls |= dict.fromkeys((owner, name) for name in known + back)
        return
    functions = [name for name in known if name in read.functions]
    read.calls |= dict.fromkeys((ANYTHING, name) for name in functions)
    tables = [name for name in names if name in read.objects]
    read.taken |= dict.fromkeys((owner, name) for name in functions + tables)
    # A function of the framework counts as called by whoever names it: `&AABB::extend`
    # makes a box grow in the end, and it leads back to nobody.
    away = [name for name in known if name not in read.functions]
    read.calls |= dict.fromkeys((owner, name) for name in away)
    _note_elsewhere(read, owner, row)


def _note_hidden(read: _Read, owner: bytes, row: bytes) -> None:
    """Take for a call whatever inline assembly may have spelled otherwise than compilers do."""
    called = [name for name in _named_in(row) if name in read.functions]
    read.calls |= dict.fromkeys((owner, name) for name in called)


def _named_in(words: bytes) -> list[bytes]:
    found = [each[0] for each in islice(_NAME.finditer(words), MOST_IN_A_ROW + 1)]
    if len(found) > MOST_IN_A_ROW:
        raise Tangled
    return found


def _note_elsewhere(read: _Read, owner: bytes, row: bytes) -> None:
    """Take down the address of a function that C or `operator new` is, as in `alloc = malloc`.

    It is one more that a pointer may be for, so the file's only one is not surely meant.
    """
    found = _ELSEWHERE.search(row) or _ELSEWHERE_ARM.search(row)
    if not found or owner.startswith(_OF_THE_LIBRARY):
        return
    name = found[1]
    if name not in _DATA | read.functions | read.objects:
        read.calls[ANYTHING, name] = None
        read.taken[owner, name] = None


def _note_data(read: _Read, owner: bytes, row: bytes) -> None:
    """Take down an entry of a table, and a second name of a function."""
    if (alias := _ALIAS.match(row)) and alias[2] in read.functions:
        read.calls[alias[1], alias[2]] = None
    entry = _TABLE.match(row)
    if entry and entry[1] in read.functions:
        read.calls[ANYTHING, entry[1]] = None
        read.taken[owner or ANYTHING, entry[1]] = None
        if owner in read.places:
            read.calls[at_place(read.places[owner]), entry[1]] = None
    if entry and owner.startswith(_VIRTUAL):
        # An object of several bases has several tables, which stand behind each other.
        is_type = entry[1].startswith(_TYPE)
        read.places[owner] = 0 if is_type else read.places.get(owner, 0) + _TABLE_BYTES


def _text(name: bytes) -> str:
    return name.decode("utf-8", errors="backslashreplace")

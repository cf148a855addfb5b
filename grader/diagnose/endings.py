"""Which mistake explains how workers end, and what compilers and sanitizers say?"""

import re
from collections.abc import Callable, Sequence
from functools import partial

import numpy as np

from grader.diagnose.hypothesis import NOTHING, Hypothesis, Support
from grader.diagnose.notes import Notes
from grader.model.cases import BuildCase, MemoryCase, SourceCase, SurvivalCase
from grader.model.mesh import Mesh
from grader.model.stages import Stop
from grader.model.trials import RebuildTrial, Trial
from grader.tolerances import FACES_PER_LEAF
from grader.verify.source import construct_loops
from grader.verify.tree import centres

LARGE = 5_000
BEYOND_16_BITS = 1 << 16
MOST_WORDS = 2_000


def _says(words: str, pattern: re.Pattern[str]) -> bool:
    return pattern.search(words[:MOST_WORDS]) is not None


def _compiler(case: BuildCase, pattern: re.Pattern[str]) -> Support:
    """Look at the first error only: the others may be its consequences."""
    said = bool(case.errors) and _says(case.errors[0], pattern)
    return Support(int(said), int(not said))


def _sanitizer(notes: Notes, pattern: re.Pattern[str]) -> Support:
    found = [case.ending.finding for case in notes.of(MemoryCase) if case.ending.finding]
    fits = sum(_says(finding, pattern) for finding in found)
    return Support(fits, len(found) - fits)


def _built(id: str, sentence: str, pattern: str) -> Hypothesis:
    look = partial(_compiler, pattern=re.compile(pattern))
    return Hypothesis(id, BuildCase, sentence, look, 1)


def _found(id: str, sentence: str, pattern: str) -> Hypothesis:
    look = partial(_sanitizer, pattern=re.compile(pattern))
    return Hypothesis(id, Notes, sentence, look, 1)


def recursion(case: SourceCase) -> Support:
    """Ask the check: here the symptom is the cause."""
    wrong = bool(construct_loops.decide(case).wrong)
    return Support(int(wrong), int(not wrong))


Ended = Callable[[SurvivalCase], bool]


def _endings(notes: Notes, bad: Ended) -> tuple[Sequence[SurvivalCase], Sequence[SurvivalCase]]:
    """Return the cases that ended in a way, and the other ones."""
    cases = notes.of(SurvivalCase)
    return [case for case in cases if bad(case)], [case for case in cases if not bad(case)]


def _by_detail(notes: Notes, words: str) -> Support:
    failed, _ = _endings(notes, lambda case: case.ending.stop is not Stop.FINISHED)
    fits = sum(words in case.ending.detail for case in failed)
    return Support(fits, len(failed) - fits)


def _detail(id: str, sentence: str, words: str) -> Hypothesis:
    return Hypothesis(id, Notes, sentence, partial(_by_detail, words=words), 1)


def too_much_memory(notes: Notes) -> Support:
    """Memory runs out in two cases at least, one of them not the largest."""
    failed, _ = _endings(notes, lambda case: case.ending.stop is not Stop.FINISHED)
    fits = sum(case.ending.stop is Stop.OUT_OF_MEMORY for case in failed)
    small = any(_faces(case.trial) < BEYOND_16_BITS for case in failed)
    return Support(fits, len(failed) - fits) if small else NOTHING


Where = Callable[[Trial], bool]


def _only_where(notes: Notes, where: Where, stops: tuple[Stop, ...]) -> Support:
    """All cases of a kind end badly, and hardly any other does."""
    failed, passed = _endings(notes, lambda case: case.ending.stop is not Stop.FINISHED)
    fits = sum(where(case.trial) and case.ending.stop in stops for case in failed)
    wrong = sum(where(case.trial) for case in passed)
    return Support(fits, len(failed) - fits + wrong)


def _place(
    id: str, sentence: str, where: Where, stops: tuple[Stop, ...], least: int = 1
) -> Hypothesis:
    look = partial(_only_where, where=where, stops=stops)
    return Hypothesis(id, Notes, sentence, look, least)


def _mesh(trial: Trial) -> Mesh:
    return trial.first if isinstance(trial, RebuildTrial) else trial.mesh


def _faces(trial: Trial) -> int:
    return len(_mesh(trial).faces)


def _nothing_to_split(trial: Trial) -> bool:
    """A mesh without any face; in a pair the second one."""
    mesh = trial.second if isinstance(trial, RebuildTrial) else _mesh(trial)
    return len(mesh.faces) == 0


def _single_leaf(trial: Trial) -> bool:
    if isinstance(trial, RebuildTrial):
        return len(trial.second.faces) <= FACES_PER_LEAF
    return _faces(trial) <= FACES_PER_LEAF


def _equal_centres(trial: Trial) -> bool:
    mesh = _mesh(trial)
    if len(mesh.faces) <= FACES_PER_LEAF:
        return False
    return bool((np.ptp(centres(mesh), axis=0) < 1e-6).all())


def ties(notes: Notes) -> Support:
    """Memory errors only where many centres agree on an axis, and nowhere else."""
    cases = [case for case in notes.of(MemoryCase) if _faces(case.trial) > 4 * FACES_PER_LEAF]
    found = [case for case in cases if case.ending.finding]
    fits = sum(_has_ties(_mesh(case.trial)) for case in found)
    alike = all("overflow" in case.ending.finding for case in found)
    spared = any(not case.ending.finding for case in notes.of(MemoryCase))
    return Support(fits, len(found) - fits) if alike and spared else NOTHING


def _has_ties(mesh: Mesh) -> bool:
    held = centres(mesh)
    return any(len(np.unique(held[:, axis])) < 0.6 * len(held) for axis in range(3))


def endless(notes: Notes) -> Support:
    """Nearly every case ends by its time."""
    failed, passed = _endings(notes, lambda case: case.ending.stop is Stop.TIMED_OUT)
    crashed = sum(case.ending.stop is not Stop.FINISHED for case in passed)
    if len(failed) < 4 * (len(passed) - crashed):
        return NOTHING
    return Support(len(failed), 0)


def slow(notes: Notes) -> Support:
    """Only large meshes take too long."""
    failed, passed = _endings(notes, lambda case: case.ending.stop is Stop.TIMED_OUT)
    fits = sum(_faces(case.trial) > LARGE for case in failed)
    small = sum(_faces(case.trial) <= LARGE for case in passed)
    return Support(fits, len(failed) - fits) if small > len(failed) else NOTHING


CRASHED = (Stop.CRASHED, Stop.OUT_OF_MEMORY)

ENDINGS: tuple[Hypothesis, ...] = (
    _built("compile.brace", "A brace is not closed.", r"expected .}|at end of input"),
    _built("compile.semicolon", "A semicolon is missing.", r"expected .;"),
    _built(
        "compile.unknown-name",
        "A name is used that the exercise's headers do not have.",
        r"has no member named|was not declared|does not name a type",
    ),
    _built(
        "compile.const-mesh",
        "The mesh is const: it must not be changed.",
        r"discards qualifiers|read-only|no matching function .*nth_element.*const",
    ),
    Hypothesis(
        "source.recursion",
        SourceCase,
        "A function that builds nodes calls itself, directly or through others.",
        recursion,
        1,
    ),
    _found(
        "memory.used-after-free",
        "A reference or a pointer into a vector is used after the vector has grown or is gone.",
        r"use-after-free",
    ),
    _found(
        "memory.local-is-gone",
        "A reference or a pointer is for a local variable that is gone when it is used.",
        r"stack-use-after-(return|scope)",
    ),
    Hypothesis(
        "memory.comparator",
        Notes,
        "The comparison of two equal centres is true both ways, "
        "as with <=, so sorting runs off the range.",
        ties,
        1,
    ),
    _found(
        "memory.past-the-end",
        "An index is used that the vector does not have: its size is not asked before.",
        r"heap-buffer-overflow|Assertion '__(n|idx) < (this->)?size\(\)'",
    ),
    _found(
        "memory.null",
        "Something is used that is not there: a pointer to nothing is followed.",
        r"null pointer",
    ),
    _found(
        "memory.shift",
        "A number is shifted by as many bits as it has, or by more.",
        r"shift exponent",
    ),
    _found(
        "memory.overflow",
        "A signed number becomes larger than its type can hold.",
        r"signed integer overflow",
    ),
    _found(
        "stack.overflows",
        "The stack of nodes that wait is too small for deep trees, and is "
        "written beyond its end.",
        # A stack of nodes has some room; three coordinates, or two children, have less.
        r"out of bounds for type '[^'\[]*\[(?:[89]|\d\d+)\]",
    ),
    _found(
        "memory.past-the-end",
        "A local array is used beyond its end.",
        r"stack-buffer-overflow|out of bounds for type '[^'\[]*\[[0-7]\]",
    ),
    _detail(
        "end.not-defined",
        "The function is not defined in this file.",
        "not defined in this file",
    ),
    _detail(
        "end.process-ended",
        "The whole program is ended, where the function has to return.",
        "the program ended itself",
    ),
    _detail(
        "end.exception",
        "An exception is thrown, where the function has to return.",
        "threw an exception",
    ),
    Hypothesis(
        "end.too-much-memory",
        Notes,
        "Far more memory is asked for than a tree or a ray needs.",
        too_much_memory,
        2,
    ),
    _place(
        "end.sixteen-bits",
        "Something ends near 65,536: a count in 16 bits, or an array of fixed size.",
        lambda trial: _faces(trial) >= BEYOND_16_BITS,
        CRASHED,
    ),
    _place(
        "end.small-meshes",
        "A mesh without any face is not thought of.",
        _nothing_to_split,
        CRASHED,
    ),
    _place(
        "end.small-meshes",
        "A mesh so small that nothing has to be split is not thought of.",
        _single_leaf,
        CRASHED,
    ),
    _place(
        "end.endless-on-equal-centres",
        "Where the centres of all faces are equal, nothing "
        "separates them, and the loop does not end.",
        _equal_centres,
        (Stop.TIMED_OUT,),
    ),
    Hypothesis(
        "end.endless",
        Notes,
        "Nothing ends the loop: what it waits for never comes about.",
        endless,
        3,
    ),
    Hypothesis(
        "end.slow-on-large-meshes",
        Notes,
        "The time grows too fast with the mesh: something "
        "that is done very often takes as long as the mesh is large.",
        slow,
        2,
    ),
)

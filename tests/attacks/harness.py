"""How is a hostile submission graded end to end, at each level that it could feel?

The limits are tighter than the shipped ones, so that what runs into them does so soon. All the
rest is the grader as it is; only what no check of a run looks at is left out of its build.
"""

import json
import re
import time
import tomllib
from collections.abc import Callable, Iterable
from functools import partial
from typing import Any

import pytest

from grader import pipeline
from grader.build import compile as building
from grader.build.workspace import GRADED
from grader.errors import BuildFault
from grader.model.stages import SOURCE_PATH, Ending
from grader.model.verdict import Verdict
from grader.options import Options
from grader.pipeline import grade_one
from grader.run import trials
from grader.run.session import run_job
from grader.sandbox.selftest import proved_isolation
from grader.score.rubric import SHIPPED
from tests.attacks.attack import Attack, Graded, every_attack
from tests.attacks.reports import checked_reports
from tests.attacks.witness import Witness, census, survivors

SEED = 41
LONGEST_SECONDS = 130.0
"""For any grade; more than the shipped time limit by what the harness itself needs."""

LIMITS = {"small_seconds": 1, "large_seconds": 4}
TOTAL_SECONDS = 40
"""Of a grade that scores some checks only."""

ATTEMPTS = 3
CROWDED = "stood in line for a processor"
"""Words of the verdict "broken" for who did not get the time that its limits promise."""

BOMB_SECONDS = {"seconds": 3, "wall_seconds": 8}
"""Compiling a file that is expected to fail."""

_SANITIZED = ("bvh.memory-is-safe", "hits.memory-is-safe", "bvh.depth-is-limited")


WITHIN = re.compile(
    "(brute|cache|callgraph|chance|detect|forge|interpose)-"
    "|(known|linker|patch|state|terminal|text)-|memory-of-the-sanitizer|clock-(busy|hides)-"
    "|compile-(constexpr|deep|diagnostics|giant|long|macro|many|nested|self|template)"
)
"""Attacks that stay within their own process, and bombs that the limits of one process end:
nothing there knows the level."""


def kind_of(attack: Attack) -> str:
    """Return the first word of its name: what it goes for."""
    return attack.path.stem.partition("-")[0]


def one_of_each_kind() -> list[Attack]:
    """Choose what `scripts/test` grades; `scripts/attacks` grades all others."""
    first: dict[str, Attack] = {}
    for attack in every_attack():
        first.setdefault(kind_of(attack), attack)
    return list(first.values())


def at_every_level(attacks: Iterable[Attack]) -> list[Any]:
    """Both levels of an attack in the same process, so that it is compiled once."""
    return [
        pytest.param(attack, level, marks=pytest.mark.xdist_group(name), id=f"{name}-{level}")
        for attack in attacks
        for level in ("A", "B")
        if (name := attack.path.stem) and (level == "A" or not WITHIN.match(name))
    ]


def gets_nowhere(
    attack: Attack, level: str, witness: Witness, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It earns what its header says; nothing is read, written, called, left or believed."""
    monkeypatch.setattr(pipeline, "proved_isolation", partial(proved_isolation, level))
    proved_isolation(level)
    graded = on_a_free_processor(attack, witness, monkeypatch)
    told = [
        (one.check, one.verdict.value, one.score, one.message) for one in graded.grade.checks
    ]
    assert not graded.grade.needs_review, told
    assert Verdict.BROKEN not in {one.verdict for one in graded.grade.checks}, told
    disappointed = attack.disappointed(graded)
    assert not disappointed, (told, graded.stops, graded.reports)


def on_a_free_processor(
    attack: Attack, witness: Witness, monkeypatch: pytest.MonkeyPatch
) -> Graded:
    """Grade an attack once more, as the grader asks, if other work was in its way.

    Every time nothing is reached, and the grade is there in time.
    """
    for attempt in range(ATTEMPTS):
        started = time.monotonic()
        try:
            noticed, graded = watched(attack, witness, monkeypatch)
        except BuildFault as fault:
            if CROWDED not in str(fault) or attempt == ATTEMPTS - 1:
                raise
            continue
        assert noticed == []
        assert time.monotonic() - started < LONGEST_SECONDS
        if not any(CROWDED in check.message for check in graded.grade.checks):
            break
    return graded


def watched(
    attack: Attack, witness: Witness, monkeypatch: pytest.MonkeyPatch, *, isolated: bool = True
) -> tuple[list[str], Graded]:
    """Grade an attack; what it reached, and what became of it."""
    endings = observed(monkeypatch)
    if attack.checks:
        lean(attack, monkeypatch)
    given = witness.place(attack.path.read_bytes())
    rubric = witness.root / "rubric.toml"
    rubric.write_text(rubric_of(attack))
    before, processes = witness.state(), census()
    options = Options(SEED, rubric, (), lambda *_: None, isolated=isolated)
    grade = grade_one(given, options)
    noticed = [*survivors(processes), *witness.changes(before), *witness.callers()]
    noticed += witness.remains()
    reports = checked_reports(grade)
    printed = "".join(ending.output for ending in endings)
    noticed += ["a report holds the secret"] if witness.secret in reports else []
    noticed += ["a worker printed the secret"] if witness.secret in printed else []
    stops = frozenset(ending.stop for ending in endings)
    return noticed, Graded(grade, stops, reports)


def observed(monkeypatch: pytest.MonkeyPatch) -> list[Ending]:
    """How each worker will have ended, and what it will have printed."""
    endings: list[Ending] = []

    def run(*arguments: Any) -> Any:  # noqa: ANN401 - passes everything through
        ending, result = run_job(*arguments)
        endings.append(ending)
        return ending, result

    monkeypatch.setattr(trials, "run_job", run)
    return endings


def lean(attack: Attack, monkeypatch: pytest.MonkeyPatch) -> None:
    """Leave out of a grade what none of its checks looks at, and compile what can be once.

    What attacks the compiler meets it at each level.
    """
    link, graph = building._link, building.call_graph
    sanitized = bool({*_SANITIZED} & {*attack.checks})

    def one_flavour(framework: Any, work: Any, name: str) -> Any:  # noqa: ANN401 - passes through
        if name != GRADED.name and not sanitized:
            return building._Linked(None, ())
        if not attack.compiles:
            return link(framework, work, name)
        found = once(name, work, lambda: _taken(link(framework, work, name)))
        return _given(work, name, *found)

    def listed(framework: Any, work: Any) -> Any:  # noqa: ANN401 - passes through
        if "source.construct-loops" not in attack.checks:
            return None
        return once("graph", work, lambda: graph(framework, work))

    monkeypatch.setattr(building, "_link", one_flavour)
    monkeypatch.setattr(building, "call_graph", listed)


MADE: dict[tuple[str, bytes], Any] = {}
"""What was made of each source of this process."""


def once(name: str, work: Any, make: Callable[[], Any]) -> Any:  # noqa: ANN401 - passes through
    """Make something of a source, or give what was made before."""
    key = (name, (work.folder / SOURCE_PATH).read_bytes())
    if key not in MADE:
        MADE[key] = make()
    return MADE[key]


def _taken(linked: Any) -> tuple[bytes | None, Any]:  # noqa: ANN401 - passes through
    return linked.library and linked.library.read_bytes(), linked.diagnostics


def _given(work: Any, name: str, content: bytes | None, diagnostics: Any) -> Any:  # noqa: ANN401 - passes through
    if content is None:
        return building._Linked(None, diagnostics)
    library = work.folder / "libraries" / f"{name}.so"
    library.write_bytes(content)
    library.chmod(0o644)
    return building._Linked(library, diagnostics)


def rubric_of(attack: Attack) -> str:
    """The shipped rubric with tighter limits, and with the checks of the attack only."""
    shipped = tomllib.loads(SHIPPED.read_text())
    shipped["limits"] |= LIMITS
    if attack.checks:
        shipped["limits"]["total_seconds"] = TOTAL_SECONDS
    if not attack.compiles:
        shipped["compile"] |= BOMB_SECONDS
    rows = [f"[reading]\nleaf_rule = {json.dumps(shipped['reading']['leaf_rule'])}"]
    rows += [table("[limits]", shipped["limits"]), table("[compile]", shipped["compile"])]
    rows += [table("[[part]]", part) for part in shipped["part"]]
    wanted = {"build.compiles", *attack.checks}
    rows += [
        table("[[criterion]]", criterion)
        for criterion in shipped["criterion"]
        if not attack.checks or criterion["check"] in wanted
    ]
    return "\n".join(rows) + "\n"


def table(name: str, values: dict[str, Any]) -> str:
    """Write one table of TOML; its words and numbers look as in JSON."""
    return "\n".join([name, *(f"{key} = {json.dumps(value)}" for key, value in values.items())])

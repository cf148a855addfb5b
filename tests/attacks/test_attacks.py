"""A hostile submission of each kind is graded end to end: in vain.

`scripts/attacks` grades all others, from `every_attack.py`; CI calls it.
"""

import pytest

from grader.model.stages import Stop
from grader.sandbox.selftest import proved_isolation
from tests.attacks import every_attack as others
from tests.attacks.attack import HERE, Attack, every_attack, read_attack
from tests.attacks.harness import at_every_level, gets_nowhere, one_of_each_kind, watched
from tests.attacks.witness import Witness


@pytest.mark.parametrize(("attack", "level"), at_every_level(one_of_each_kind()))
def test_an_attack_gets_nowhere(
    attack: Attack, level: str, witness: Witness, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It earns what its header says; nothing is read, written, called, left or believed."""
    gets_nowhere(attack, level, witness, monkeypatch)


def test_none_is_left_out() -> None:
    """What is not graded here is graded there, at its levels."""
    here = at_every_level(one_of_each_kind())
    names = sorted(str(one.id) for one in [*here, *others.LEFT])
    assert names == sorted(str(one.id) for one in at_every_level(every_attack()))
    assert len(set(names)) == len(names)


@pytest.mark.parametrize(
    ("name", "sign"),
    [
        ("write-files-of-others", "canary was touched"),
        ("exec-system", "created was touched"),
        ("socket-connects-home", "was called"),
        ("read-files-of-others", "a worker printed the secret"),
        ("read-secret-by-include", "a report holds the secret"),
    ],
)
def test_an_attack_is_real(
    name: str, sign: str, witness: Witness, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Without isolation it gets somewhere, and the harness notices."""
    attack = read_attack(HERE / f"{name}.cpp")
    noticed, graded = watched(attack, witness, monkeypatch, isolated=False)
    assert sign in " ".join(noticed), graded.reports


def test_no_worker_and_no_level_is_taken_on_trust() -> None:
    """Both levels hold on this machine: a level that cannot be tested is not promised."""
    assert [proved_isolation(level).level.name for level in "AB"] == ["NAMESPACES", "PROCESS"]


def test_there_are_enough_of_them() -> None:
    """At least 64 attacks, in both parts and on the compiler; some expect full points."""
    attacks = every_attack()
    assert len(attacks) >= 64
    assert {Stop.CRASHED, Stop.TIMED_OUT, Stop.OUT_OF_MEMORY, Stop.FORBIDDEN} <= {
        clause.stop for one in attacks for _, clause in one.clauses if hasattr(clause, "stop")
    }

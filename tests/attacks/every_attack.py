"""Every hostile submission that `test_attacks.py` leaves out: `scripts/attacks`.

`scripts/test` does not collect them, because they take half as long as all other tests.
"""

import pytest

from tests.attacks.attack import Attack, every_attack
from tests.attacks.harness import at_every_level, gets_nowhere, one_of_each_kind
from tests.attacks.witness import Witness

_GRADED = {attack.path for attack in one_of_each_kind()}

LEFT = at_every_level(attack for attack in every_attack() if attack.path not in _GRADED)


@pytest.mark.parametrize(("attack", "level"), LEFT)
def test_an_attack_gets_nowhere(
    attack: Attack, level: str, witness: Witness, monkeypatch: pytest.MonkeyPatch
) -> None:
    """It earns what its header says; nothing is read, written, called, left or believed."""
    gets_nowhere(attack, level, witness, monkeypatch)

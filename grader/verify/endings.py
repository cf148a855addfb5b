"""Does `intersect` come back from every ray, and does its memory stay in bounds?"""

from grader.model.cases import MemoryCase, SurvivalCase
from grader.model.trials import Trial
from grader.model.verdict import Evidence
from grader.verify.bounds import safe
from grader.verify.check import check
from grader.verify.structure import calls_construct, survived


def calls_intersect(trial: Trial) -> bool:
    """Tell whether a trial is one of part b."""
    return not calls_construct(trial)


@check(MemoryCase, "hits.memory-is-safe", when=calls_intersect)
def intersect_memory_is_safe(case: MemoryCase) -> Evidence:
    """Sanitizers find no memory error and no undefined behaviour in `intersect`."""
    return safe(case)


@check(SurvivalCase, "hits.survives-every-ray", when=calls_intersect)
def survives_every_ray(case: SurvivalCase) -> Evidence:
    """`intersect` comes back from every ray: no crash, no time-out, no exhausted memory."""
    return survived(case)

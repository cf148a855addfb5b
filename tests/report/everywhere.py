"""Grades that hold one text wherever a submission can put one."""

from dataclasses import replace

from grader.model.grade import Grade
from grader.model.stages import Diagnostic, Rejected
from grader.model.verdict import Example
from tests.report import samples


def everywhere(text: str) -> tuple[Grade, Grade, Grade]:
    """Put a text wherever a submission can put one: graded, not compiled, refused."""
    example = Example(text, text, text)
    score = replace(samples.loose_boxes(text), expected=text, got=text, title=text)
    score = replace(score, line=1, examples=(example,) * 9)
    calls = replace(samples.CALLS, lines=((f"_Z{len(text)}{text}", 1),))
    build = replace(
        samples.BUILD,
        calls=calls,
        diagnostics=(Diagnostic(1, 1, "error", text),) * 99,
        remarks=(text,),
        compiler=text,
    )
    source = text[:100_000].encode("utf-8", "replace") * 8
    given = replace(samples.SUBMISSION, student=text, path=text, source=source)
    graded = replace(samples.changed(c5=score), submission=given, build=build)
    failed = replace(graded, build=replace(build, library=None))
    refused = replace(samples.rejected(), submission=Rejected(text, text))
    return graded, failed, refused

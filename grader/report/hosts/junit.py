"""How do GitLab and others read a result? As JUnit's XML, one test case for each check.

There is no official schema; see testmoapp/junitxml and GitLab's "Unit test reports". A wrong
answer is a failure whose type says how the program ended, the grader's own fault is an error,
and what waits for something else is skipped. GitLab drops a test case whose name it has seen,
so both names come from the id of the check. Points have no place of their own and become
properties; one that is withheld has none. There is no time stamp: a result holds none.
"""

from collections.abc import Iterator, Mapping

from grader.language import Words
from grader.report.as_json import Json
from grader.report.escape import for_xml
from grader.report.hosts.told import Row, headline, rows, unbuilt

FILE = "src/exercise03.cpp"

TYPES = {
    "finished": "Wrong",
    "crashed": "Crash",
    "timed_out": "Timeout",
    "out_of_memory": "OutOfMemory",
    "forbidden": "Forbidden",
    "failed_to_start": "FailedToStart",
}


def to_text(result: Json, words: Words = str) -> str:
    """Write the file."""
    shown = rows(result, words)
    spent = result["timing"]["checks"]
    titles = {part["id"]: f"{part['id']}) {words(part['title'])}" for part in result["parts"]}
    lines = ['<?xml version="1.0" encoding="UTF-8"?>']
    total = result["timing"]["total"]
    lines.append(f"<testsuites{attributes(counted('bvhgrade', shown, total))}>")
    for title in dict.fromkeys(titles.get(row.part, words("Both parts")) for row in shown):
        mine = [r for r in shown if titles.get(r.part, words("Both parts")) == title]
        seconds = sum(spent.get(row.id, 0) for row in mine)
        lines.append(f" <testsuite{attributes(counted(title, mine, seconds))}>")
        lines += properties("  ", whole(result, words))
        for row in mine:
            lines += test_case(row, spent.get(row.id, 0), words)
        lines.append(" </testsuite>")
    return "\n".join([*lines, "</testsuites>", ""])


def whole(result: Json, words: Words) -> dict[str, object]:
    """Tell of the whole result what has no other place."""
    made = result["provenance"]
    score = {} if result["score"] is None else {"score": result["score"]}
    return {
        "result": "\n".join(filter(None, [headline(result, words), unbuilt(result, words)])),
        **score,
        "max_score": result["max_score"],
        "grader": made["grader"],
        "seed": made["seed"],
    }


def counted(name: str, given: list[Row], seconds: float) -> dict[str, object]:
    """Name a suite and count how its test cases ended."""
    verdicts = [row.verdict for row in given]
    return {
        "name": name,
        "tests": len(given),
        "failures": verdicts.count("fail"),
        "errors": verdicts.count("broken"),
        "skipped": verdicts.count("blocked"),
        "time": f"{seconds:.3f}",
    }


def test_case(row: Row, seconds: float, words: Words) -> Iterator[str]:
    """Write one check."""
    topic, _, statement = row.id.partition(".")
    named = {"classname": topic, "name": statement, "time": f"{seconds:.3f}", "file": FILE}
    yield f"  <testcase{attributes(named)}>"
    score = {} if row.score is None else {"points": row.score}
    yield from properties("   ", {"title": row.title, **score, "max_points": row.max_score})
    message = {"message": row.text.partition("\n")[0] or row.title}
    body = for_xml(row.text)
    if row.verdict == "fail":
        yield f"   <failure{attributes({**message, 'type': TYPES[row.stop]})}>{body}</failure>"
    elif row.verdict == "broken":
        yield f"   <error{attributes({**message, 'type': words('broken')})}>{body}</error>"
    elif row.verdict == "blocked":
        yield f"   <skipped{attributes(message)}/>"
    yield "  </testcase>"


def properties(indent: str, given: Mapping[str, object]) -> Iterator[str]:
    """Write properties, each on a line."""
    yield f"{indent}<properties>"
    for name, value in given.items():
        yield f"{indent} <property{attributes({'name': name, 'value': value})}/>"
    yield f"{indent}</properties>"


def attributes(given: Mapping[str, object]) -> str:
    """Write attributes in quotes; numbers as Python writes them, which is the shortest way."""
    return "".join(f' {name}="{for_xml(str(value))}"' for name, value in given.items())

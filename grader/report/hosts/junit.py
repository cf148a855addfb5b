"""How do GitLab and others read a result? As JUnit's XML, one test case for each check.

There is no official schema; see testmoapp/junitxml and GitLab's "Unit test reports". A wrong
answer is a failure whose type says how the program ended, the grader's own fault is an error,
and what waits for something else is skipped. GitLab drops a test case whose name it has seen,
so both names come from the id of the check. Points have no place of their own and become
properties; one that is withheld has none. There is no time stamp: a result holds none.
"""

from collections.abc import Iterator, Mapping

from grader.language import Words
from grader.model.stages import SOURCE_PATH
from grader.report.as_json import Json
from grader.report.escape import for_xml
from grader.report.hosts.told import Entry, entries, headline, is_open, unbuilt

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
    shown = entries(result, words)
    spent = result["timing"]["checks"]
    titles = {part["id"]: f"{part['id']}) {words(part['title'])}" for part in result["parts"]}
    lines = ['<?xml version="1.0" encoding="UTF-8"?>']
    total = result["timing"]["total"]
    lines.append(f"<testsuites{attributes(counted('bvhgrade', shown, total))}>")
    for title in dict.fromkeys(titles.get(entry.part, words("Both parts")) for entry in shown):
        mine = [r for r in shown if titles.get(r.part, words("Both parts")) == title]
        seconds = sum(spent.get(entry.id, 0) for entry in mine)
        lines.append(f" <testsuite{attributes(counted(title, mine, seconds))}>")
        lines += properties("  ", whole(result, words))
        for entry in mine:
            lines += test_case(entry, spent.get(entry.id, 0), words)
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
        # Whoever has the grader draws with it the inputs of hidden checks.
        **({"seed": made["seed"]} if is_open(result) else {}),
    }


def counted(name: str, given: list[Entry], seconds: float) -> dict[str, object]:
    """Name a suite and count how its test cases ended."""
    verdicts = [entry.verdict for entry in given]
    return {
        "name": name,
        "tests": len(given),
        "failures": verdicts.count("fail"),
        "errors": verdicts.count("broken"),
        "skipped": verdicts.count("blocked"),
        "time": f"{seconds:.3f}",
    }


def test_case(entry: Entry, seconds: float, words: Words) -> Iterator[str]:
    """Write one check."""
    topic, _, statement = entry.id.partition(".")
    named = {
        "classname": topic,
        "name": statement,
        "time": f"{seconds:.3f}",
        "file": SOURCE_PATH,
    }
    yield f"  <testcase{attributes(named)}>"
    score = {} if entry.score is None else {"points": entry.score}
    yield from properties("   ", {"title": entry.title, **score, "max_points": entry.max_score})
    message = {"message": entry.text.partition("\n")[0] or entry.title}
    body = for_xml(entry.text)
    if entry.verdict == "fail":
        kind = attributes({**message, "type": TYPES[entry.stop]})
        yield f"   <failure{kind}>{body}</failure>"
    elif entry.verdict == "broken":
        yield f"   <error{attributes({**message, 'type': 'GraderFault'})}>{body}</error>"
    elif entry.verdict == "blocked":
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

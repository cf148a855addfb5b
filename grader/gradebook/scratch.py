"""Which list can be made without a teacher's file? One for Moodle's gradebook, and a plain one.

Moodle imports nothing at all if it does not know one user of the file, so no list is made if of
one student only a platform's own number is known. A score that is withheld is left out there.
"""

from collections import Counter
from collections.abc import Sequence

from grader.errors import UsageError
from grader.gradebook.feedback import feedback_cell
from grader.gradebook.fill import Filled
from grader.gradebook.results import Ids, Marked
from grader.language import Words
from grader.report.escape import for_csv

ITEM = "Exercise 3 BVH"

DOWNLOADS = {
    "moodle": 'the assignment\'s "Download grading worksheet"',
    "canvas": 'Grades > Export > "Export Entire Gradebook"',
    "csv": "a list of your own",
}


def made(host: str, given: Sequence[Marked], words: Words) -> Filled:
    """Make a list of all results.

    Raises:
        UsageError: The host needs a file of its own, or it is not known who a student is.
    """
    if host == "canvas":
        raise UsageError(f"Canvas knows students by its own numbers; {download(host)}")
    problems = [f"{each.student}: left out, {each.why}" for each in given if each.is_nobody_s]
    given = [marked for marked in given if not marked.is_nobody_s]
    if unknown := [marked.student for marked in given if not marked.ids.accounts]:
        raise UsageError(
            f"{unknown[0]}: neither login nor address is known, only a platform's own number; "
            f"{download(host)}"
        )
    times = Counter(account(marked.ids) for marked in given)
    twice = sorted(name for name, count in times.items() if count > 1)
    problems += [f"{name}: several results, none is taken" for name in twice]
    alone = [marked for marked in given if account(marked.ids) not in twice]
    problems += [f"{marked.student}: left out, {marked.why}" for marked in alone if marked.why]
    single = [marked for marked in alone if not marked.why]
    if host == "csv":
        lines = plain(single, words)
    else:
        problems += [
            f"{marked.student}: left out, the score is withheld since the grader itself failed"
            for marked in single
            if marked.result["score"] is None
        ]
        lines = moodle([m for m in single if m.result["score"] is not None], words)
    data = "".join(f"{line}\n" for line in lines).encode("utf-8")
    return Filled(data, len(lines) - 1, len(lines) - 1, (), tuple(problems))


def account(ids: Ids) -> str:
    """Say who a student is: by an address, if one is known."""
    return next((each for each in ids.accounts if "@" in each), ids.accounts[0])


def download(host: str) -> str:
    """Say which file to get."""
    return f"give {DOWNLOADS[host]} with --worksheet"


def moodle(given: Sequence[Marked], words: Words) -> list[str]:
    """Write a file for Moodle's gradebook: who, points, feedback, and always all three.

    Raises:
        UsageError: Some are known by an address and others are not.
    """
    accounts = [account(marked.ids) for marked in given]
    addresses = ["@" in each for each in accounts]
    if any(addresses) and not all(addresses):
        other = accounts[addresses.index(False)]
        raise UsageError(f"{other} is no address, but others are; {download('moodle')}")
    who = "Email address" if any(addresses) else "Username"
    lines = [f"{who},{ITEM},{ITEM} (feedback)"]
    for name, marked in zip(accounts, given, strict=True):
        cell = feedback_cell(marked.result, "moodle", words)
        lines.append(f"{for_csv(name)},{marked.result['score']:.10g},{cell}")
    return lines


def plain(given: Sequence[Marked], words: Words) -> list[str]:
    """Write a plain list; a score that is withheld is an empty cell."""
    parts = list(dict.fromkeys(p["id"] for marked in given for p in marked.result["parts"]))
    titles = [f"part {part}" for part in parts]
    lines = [",".join(["student", "score", "max_score", *titles, "needs_review", "feedback"])]
    for marked in given:
        result = marked.result
        scores = {part["id"]: part["score"] for part in result["parts"]}
        known = [result["score"], result["max_score"], *(scores.get(part) for part in parts)]
        cells = ["" if value is None else f"{value:.10g}" for value in known]
        review = "yes" if result["needs_review"] else "no"
        feedback = feedback_cell(result, "csv", words)
        lines.append(",".join([for_csv(account(marked.ids)), *cells, review, feedback]))
    return lines

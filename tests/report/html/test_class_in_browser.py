"""A teacher sorts, searches and saves the table of a class, by keyboard alone if need be."""

from dataclasses import replace

import pytest
from axe_playwright_python.sync_playwright import Axe
from playwright.sync_api import Page, expect

from grader.report.class_row import Row
from grader.report.html.classroom import to_class_page, to_csv
from grader.verify import every_check
from tests.report.html.conftest import Visit

CHECKS = [each.id for each in every_check()]
HOSTILE_NAME = '</script><b>x</b><img src=x onerror="document.title=1">\u202egnp'


def student(number: int) -> Row:
    """Make a student; every seventh fails the third check, the fourth has no score."""
    failed = {CHECKS[2]} if number % 7 == 0 else set()
    verdicts = tuple((check, "fail" if check in failed else "pass") for check in CHECKS)
    score = None if number == 4 else float((number * 17) % 51)
    return Row(
        name=f"s{number:04} Müller",
        link=f"students/{number}/report.html",
        score=score,
        max_score=50.0,
        seconds=float(number % 29),
        verdicts=verdicts,
        causes=(("The search stops at its first hit.", CHECKS[2]),) if failed else (),
        note="",
    )


def class_of(students: int) -> list[Row]:
    """Make a class."""
    return [student(number) for number in range(students)]


def shown(page: Page, column: int) -> list[str]:
    """Read a column of the rows that are shown."""
    cells = page.locator(f"#class tbody tr:not([hidden]) > :nth-child({column + 1})")
    return cells.all_inner_texts()


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nobody_is_shut_out(visit: Visit, scheme: str) -> None:
    """An audit by axe finds neither too little contrast nor a control without a name."""
    found = Axe().run(
        visit(to_class_page(class_of(12), "made by hand", "de"), color_scheme=scheme)
    )
    assert found.violations_count == 0, found.generate_report()


def test_columns_are_sorted_by_keyboard(visit: Visit) -> None:
    """Up, then down; a withheld score stands beside the lowest."""
    page = visit(to_class_page(class_of(12), "", "en"))
    points = page.get_by_role("button", name="Points")
    points.press("Enter")
    known = [row.score for row in class_of(12) if row.score is not None]
    assert shown(page, 1) == ["withheld", *(f"{score:g}" for score in sorted(known))]
    assert page.locator("#class th").nth(1).get_attribute("aria-sort") == "ascending"
    points.press("Enter")
    assert shown(page, 1)[0] == f"{max(known):g}"
    page.get_by_role("button", name="Student").press("Enter")
    assert shown(page, 0) == sorted(row.name for row in class_of(12))


def test_a_thousand_students_are_searched_and_filtered(visit: Visit) -> None:
    """By name, by a failed check, by a withheld score."""
    page = visit(to_class_page(class_of(1000), "", "en"))
    expect(page.locator("#shown")).to_have_text("1000 shown")
    page.locator("#find").fill("S0012")
    assert shown(page, 0) == ["s0012 Müller"]
    page.locator("#find").fill("")
    page.locator("#check").select_option(CHECKS[2])
    expect(page.locator("#shown")).to_have_text("143 shown")
    page.locator("#check").select_option("!")
    assert shown(page, 0) == ["s0004 Müller"]


def test_the_saved_file_is_the_one_that_python_writes(visit: Visit) -> None:
    """Byte by byte, behind the mark that tells a spreadsheet that it is UTF-8."""
    rows = [replace(student(0), name="=1+1"), student(4), student(7)]
    page = visit(to_class_page(rows, "", "en"), accept_downloads=True)
    with page.expect_download() as waiting:
        page.get_by_role("button", name="Save as CSV").press("Enter")
    saved = waiting.value.path().read_bytes()
    assert saved.decode("utf-8-sig") == to_csv(rows)


def test_a_hostile_name_stays_a_name(visit: Visit) -> None:
    """Nothing of it runs or changes the page."""
    rows = [replace(student(0), name=HOSTILE_NAME), student(7)]
    page = visit(to_class_page(rows, "", "en"))
    assert page.locator("#class b, #class img").count() == 0
    assert shown(page, 0)[0].startswith("</script><b>x</b><img src=x")
    assert page.title() == "BVH exercise: the class"


def test_the_table_is_there_without_javascript(visit: Visit) -> None:
    """Only what needs it is missing."""
    page = visit(to_class_page(class_of(5), "", "en"), java_script_enabled=False)
    assert len(shown(page, 0)) == 5
    expect(page.locator("#find")).to_be_hidden()
    assert page.locator("#class a").first.get_attribute("href") == "students/0/report.html"


@pytest.mark.parametrize("width", [360, 800, 1400])
def test_the_page_fits(visit: Visit, width: int) -> None:
    """Only the table scrolls to the side."""
    page = visit(
        to_class_page(class_of(30), "", "en"), viewport={"width": width, "height": 800}
    )
    assert page.evaluate("document.documentElement.scrollWidth") <= width


def test_the_class_can_be_printed(visit: Visit) -> None:
    """Without what one can only click."""
    page = visit(to_class_page(class_of(30), "", "en"))
    page.emulate_media(media="print")
    expect(page.locator("#filter")).to_be_hidden()
    assert page.pdf().startswith(b"%PDF")

"""Code side by side: what is marked is what was found, and nothing of it acts."""

import pytest
from axe_playwright_python.sync_playwright import Axe
from hypothesis import given
from hypothesis import strategies as st

from grader.report.html.alike import LONGEST, Class, Side, pieces, to_alike_page
from tests.report.html.conftest import Visit

HOSTILE = '</pre></script><script>document.title="1"</script>\u202e\x1b[31m'
WHOLE = Class(submissions=9, files=8, usual=0.12, least=0.5, alike=1, given_up=(("Di",),))


def page_of(name: str, text: str, language: str = "en") -> str:
    """Make a page of one pair."""
    places = ((2, 12), (30, 45))
    pair = (Side((name,), text, 0.97, places), Side(("Ben", "Cy"), text, 0.5, places))
    return to_alike_page(WHOLE, [pair], [["Ben", "Cy"]], "made by hand", language)


@given(
    st.text(max_size=60),
    st.lists(st.tuples(st.integers(0, 90), st.integers(0, 90)), max_size=6),
)
def test_pieces_are_the_text_again(text: str, places: list[tuple[int, int]]) -> None:
    """In order, without a gap, and marked exactly where a place covers them."""
    cut = list(pieces(text, places))
    assert "".join(piece for piece, _ in cut) == text
    told = [marked for piece, marked in cut for _ in piece]
    assert told == [any(b <= at < e for b, e in places) for at in range(len(text))]


def test_long_pieces_are_cut_so_that_nothing_is_lost() -> None:
    """What is made printable keeps no more than a few thousand characters at once."""
    text = "x" * (3 * LONGEST + 7)
    assert all(len(piece) <= LONGEST for piece, _ in pieces(text, [(5, 2 * LONGEST)]))
    assert page_of("Ada", text).count("x") >= 2 * len(text)


@pytest.mark.parametrize("scheme", ["light", "dark"])
def test_nobody_is_shut_out(visit: Visit, scheme: str) -> None:
    """An audit by axe finds nothing, in either language."""
    for language in ("en", "de"):
        page = visit(page_of("Ada", "int main() {\n" * 9, language), color_scheme=scheme)
        found = Axe().run(page)
        assert found.violations_count == 0, found.generate_report()


def test_a_strangers_code_is_shown_and_does_nothing(visit: Visit) -> None:
    """Neither as a name nor as a text."""
    page = visit(page_of(HOSTILE, HOSTILE * 3))
    assert page.title() == "BVH exercise: submissions that are alike"
    shown = page.locator("pre").first.inner_text()
    assert "</pre></script>" in shown
    assert "\\x1b[31m" in shown
    assert "\u202e" not in shown

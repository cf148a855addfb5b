"""A teacher's file is filled in place, and each host imports what the results say."""

import codecs
from dataclasses import replace
from pathlib import Path

import pytest

from grader.errors import UsageError
from grader.gradebook.columns import Asked
from grader.gradebook.fill import Filled, filled
from grader.gradebook.results import Marked, ids_of, results_in
from tests.gradebook import rules, sheets
from tests.gradebook.folders import CLASS, POINTS, write_class
from tests.report import real
from tests.report.hostile import HOSTILE
from tests.report.readers import FORMULA, NUMBER

ANY = Asked()


def a_class(**students: str) -> list[Marked]:
    """Name students by their folders, and what became of them."""
    results = real.every_result()
    return [Marked(name, ids_of(name), results[ending]) for name, ending in students.items()]


def fill(text: str, host: str, given: list[Marked], asked: Asked = ANY) -> Filled:
    """Fill a file of UTF-8."""
    return filled(text.encode(), host, asked, given, str)


@pytest.fixture
def whole_class(tmp_path: Path) -> list[Marked]:
    """Six students with real results, as Moodle names their folders."""
    return results_in(write_class(tmp_path, CLASS))


def test_moodle_imports_the_points_of_each_participant(whole_class: list[Marked]) -> None:
    """All but the one whose score nobody knows, and the one whose grade is locked."""
    made = fill(sheets.ENGLISH, "moodle", whole_class)
    taken = rules.moodle_worksheet(made.data, "en")
    points = {who: points for who, (points, _) in taken.items()}
    assert points == {who: worth for who, worth in POINTS.items() if who != 104}
    assert "50 of 50" in taken[101][1]
    assert "hits.closest-wins" not in taken[101][1]
    assert "closest hit" in taken[102][1]
    assert "There is no file to grade" in taken[105][1]


def test_only_cells_for_points_and_words_change(whole_class: list[Marked]) -> None:
    """Order, header, quotes and line ends stay, and so do the rows without a result."""
    made = fill(sheets.ENGLISH, "moodle", whole_class)
    before, after = rules.read(sheets.ENGLISH.encode(), ","), rules.read(made.data, ",")
    assert len(before) == len(after)
    changed = {
        (row, before[0][column])
        for row, (old, new) in enumerate(zip(before, after, strict=True))
        for column, (a, b) in enumerate(zip(old, new, strict=True))
        if a != b
    }
    assert changed == {
        (row, name) for row in (2, 3, 5, 7) for name in ("Grade", "Feedback comments")
    }
    lines, untouched = made.data.split(b"\r\n"), sheets.ENGLISH.encode().split(b"\r\n")
    assert lines[0] == untouched[0]
    assert lines[2].startswith(
        b'Participant 101,"Ada Lovelace",ada@uni.example,"Submitted for grading",50,50.00,'
    )
    assert lines[1] == untouched[1]


def test_what_was_not_filled_is_told(whole_class: list[Marked]) -> None:
    """Rows without a result, and results whose row stays as it was, with the reason."""
    strangers = a_class(eve="right")
    made = fill(sheets.ENGLISH, "moodle", [*whole_class, *strangers])
    assert made.empty == ("row 5: Participant 999, Ada Lovelace",)
    assert (made.filled, made.rows) == (4, 7)
    told = "\n".join(made.problems)
    assert len(made.problems) == 3
    assert "eve: no row has this student" in told
    assert "Our Fault_106_assignsubmission_file: row 2 is left as it was: the score is" in told
    assert "Lin Tan_104_assignsubmission_file: row 7 is left as it was: its grade cann" in told


@pytest.mark.parametrize("mark", [b"", codecs.BOM_UTF8])
def test_a_german_worksheet_stays_german(whole_class: list[Marked], mark: bytes) -> None:
    """Header, semicolons, commas in numbers, and the mark that Excel wants."""
    made = filled(mark + sheets.GERMAN.encode(), "moodle", ANY, whole_class, str)
    assert made.data.startswith(mark + 'ID;"Vollständiger Name"'.encode())
    assert b";38,25;50,00;Ja" in made.data
    taken = rules.moodle_worksheet(made.data, "de", ";")
    assert {who: points for who, (points, _) in taken.items()} == {102: 38.25, 101: 50}


def test_a_number_with_a_comma_is_quoted_between_commas(whole_class: list[Marked]) -> None:
    """A German site may still use commas between cells."""
    text = sheets.GERMAN.replace("50,00", '"50,00"').replace(";", ",")
    made = fill(text, "moodle", whole_class)
    taken = rules.moodle_worksheet(made.data, "de", ",")
    assert taken[102][0] == 38.25


def test_moodle_s_gradebook_is_filled_by_address_or_number() -> None:
    """Whatever the case of letters; a row that stays keeps its dash, which is no grade."""
    made = fill(
        sheets.GRADEBOOK,
        "moodle",
        a_class(**{"ada@uni.example": "right", "u2": "first-hit-wins"}),
    )
    users = {"ada@uni.example", "Grace@uni.example", "nobody@uni.example"}
    item = "Assignment: Exercise 3 BVH"
    columns = ("Email address", f"{item} (Real)", f"{item} (Feedback)")
    taken = rules.moodle_gradebook(made.data, users, columns)
    assert [points for points, _ in taken.values()] == [50, 38.25, None]
    assert b",12.50,1736200000\n" in made.data
    assert not made.problems


def test_canvas_imports_the_points_of_one_assignment() -> None:
    """By its own number of a user, by login, or by the number of the SIS; excused stays so."""
    students = {
        "lovelaceada_LATE_9001_55_exercise03": "right",
        "grace": "first-hit-wins",
        "u3": "right",
    }
    made = fill(sheets.CANVAS, "canvas", a_class(**students), Asked(grade="Exercise 3 BVH"))
    users = {"9001": "ada", "9002": "grace", "9003": "jm", "9009": "test"}
    taken = rules.canvas(made.data, users, "66")
    assert taken == {"9001": 50, "9002": 38.25, "9003": None, "9009": None}
    assert b",EX,\n" in made.data
    assert made.problems == ("u3: row 5 is left as it was: this student is excused",)
    assert made.empty == ("row 6: Student, Test, 9009",)
    assert rules.canvas(made.data, users, "55") == rules.canvas(
        sheets.CANVAS.encode(), users, "55"
    )


def test_who_is_not_assigned_in_canvas_gets_no_points() -> None:
    """Canvas would drop them; in a list of one's own the same word is a cell like any other."""
    text = sheets.CANVAS.replace("u2,grace,CG-1,,12,80", "u2,grace,CG-1,,N/A,80")
    given = a_class(ada="right", grace="right")
    made = fill(text, "canvas", given, Asked(grade="Exercise 3 BVH"))
    assert made.filled == 1
    assert b",grace,CG-1,,N/A,80" in made.data
    assert made.problems == (
        "grace: row 4 is left as it was: the assignment is not this student's (N/A), so Canvas "
        "would drop the points",
    )
    assert fill("login,score\ngrace,N/A\nada,\n", "csv", given).filled == 2


def test_a_plain_list_is_filled() -> None:
    """With German headers too."""
    text = "Matrikelnummer;Punkte;Kommentar\n777;;\n778;;\n"
    made = fill(text, "csv", a_class(**{"777": "first-hit-wins", "778": "right"}))
    header, first, second = rules.read(made.data, ";")
    assert header == ["Matrikelnummer", "Punkte", "Kommentar"]
    assert first[:2] == ["777", "38,25"]
    assert second[:2] == ["778", "50"]
    assert "closest hit" in first[2]


@pytest.mark.parametrize(
    ("text", "points"),
    [
        ("email;score;sheet 1\nada;;7,5\n", "38,25"),
        ("email;score;sheet 1\nada;;7.5\n", "38.25"),
        ("email;score;sheet 1;sheet 2\nada;;7.5;7,5\n", "38,25"),
        ("email;score;sheet 1\nada;7.5;7,5\n", "38.25"),
        ("email;score;sheet 1\nada;;7\n", "38,25"),
        ('email,score,sheet 1\nada,,"7,5"\n', "38,25"),
        ("email,score,sheet 1\nada,,7.5\n", "38.25"),
        ("email,score,day\nada,,7.5.2025\n", "38.25"),
        ("email\tscore\nada\t\n", "38.25"),
        ("email\tscore\tsheet 1\nada\t\t7,5\n", "38,25"),
    ],
)
def test_points_are_written_as_the_file_writes_numbers(text: str, points: str) -> None:
    """As in the assignment's own columns, else as in others, else as its delimiter says."""
    made = fill(text, "csv", a_class(ada="first-hit-wins"))
    sign = next(each for each in "\t;," if each in text)
    assert rules.read(made.data, sign)[1][1] == points


def test_columns_of_other_names_can_be_named() -> None:
    """By their whole name or its beginning."""
    text = "kto,group,ex3 (10),note\nada,1,,\n"
    asked = Asked(grade="ex3", feedback="note", id="kto")
    made = fill(text, "csv", a_class(ada="right"), asked)
    assert made.data.startswith(b'kto,group,ex3 (10),note\nada,1,50,"50 of 50')


@pytest.mark.parametrize(
    ("text", "host", "said"),
    [
        (sheets.CANVAS, "canvas", "2 columns may be the one for points.*--grade-column"),
        ("Student,x\nada,\n", "csv", "no columns may be the one for points, of 'Student', 'x'"),
        ("x,score\nada,\n", "csv", "no column says who a row is.*--id-column"),
        (sheets.ENGLISH.replace("50.00", "100.00"), "moodle", "out of 100 points, but.*of 50"),
    ],
)
def test_a_file_that_cannot_be_filled_is_refused(
    whole_class: list[Marked], text: str, host: str, said: str
) -> None:
    """With what is there and what to do; an assignment out of 100 would halve the points."""
    with pytest.raises(UsageError, match=said):
        fill(text, host, [*whole_class, *a_class(ada="right")])


def test_a_participant_may_have_a_name_in_any_language(whole_class: list[Marked]) -> None:
    """Only the number at the end counts."""
    text = sheets.ENGLISH.replace("Participant ", "Osallistuja")
    assert fill(text, "moodle", whole_class).filled == 4


def test_canvas_s_points_possible_are_compared() -> None:
    """They stand in a row of their own."""
    text = sheets.CANVAS.replace(",10,50,", ",10,100,")
    with pytest.raises(UsageError, match="out of 100 points"):
        fill(text, "canvas", a_class(ada="right"), Asked(grade="Exercise 3 BVH"))


@pytest.mark.parametrize("name", ["Current Score", "Final Grade", "Override Points"])
def test_a_column_of_canvas_s_own_is_refused_even_if_it_is_asked_for(name: str) -> None:
    """Canvas does not read it."""
    text = sheets.CANVAS.replace("Current Score", name)
    with pytest.raises(UsageError, match="of the host's own"):
        fill(text, "canvas", a_class(ada="right"), Asked(grade=name))


@pytest.mark.parametrize("cell", ["(read only)", "50 (Read Only)"])
def test_a_column_that_canvas_passes_over_is_refused(cell: str) -> None:
    """It would say nothing, and no student had any points."""
    text = sheets.CANVAS.replace(",10,50,", f",10,{cell},")
    users = {"9001": "ada", "9002": "grace", "9003": "jm", "9009": "test"}
    assert rules.canvas(text.encode(), users, "66") == {}
    with pytest.raises(UsageError, match=r"'Exercise 3 BVH \(66\)'.*read only.*--grade-column"):
        fill(text, "canvas", a_class(ada="right"), Asked(grade="Exercise 3 BVH"))
    other = text.replace(",10,", ",50,")
    assert fill(other, "canvas", a_class(ada="right"), Asked(grade="Exercise 2")).filled == 1


def test_a_file_of_another_class_is_refused() -> None:
    """Not one of the students is in it."""
    with pytest.raises(UsageError, match="no row has any of the 1 students\neve: no row"):
        fill(sheets.ENGLISH, "moodle", a_class(eve="right"))


def test_two_people_of_one_name_are_not_mixed_up(whole_class: list[Marked]) -> None:
    """There are two called Ada Lovelace; the number decides, never the name."""
    others = [one for one in whole_class if not one.student.startswith("Ada")]
    moved = replace(whole_class[0], ids=ids_of("Ada Lovelace_555_assignsubmission_file"))
    made = fill(sheets.ENGLISH, "moodle", [moved, *others])
    assert 101 not in rules.moodle_worksheet(made.data, "en")
    assert 999 not in rules.moodle_worksheet(made.data, "en")
    assert f"{moved.student}: no row has this student" in made.problems


def test_what_may_be_two_is_filled_into_none() -> None:
    """Neither two rows for one result, nor two results for one row."""
    text = "name,email,score\nAda,a@x,\nAda,b@x,\nBob,c@x,\n"
    given = a_class(**{"Ada": "right", "bob": "right", "BOB": "first-hit-wins", "b@x": "right"})
    made = fill(text, "csv", given)
    assert made.data == b"name,email,score\nAda,a@x,\nAda,b@x,50\nBob,c@x,\n"
    assert "Ada: rows 2, 3 may all be meant" in made.problems
    assert "bob, BOB: several results for row 4" in made.problems


@pytest.mark.parametrize("name", HOSTILE)
@pytest.mark.parametrize("host", ["moodle", "csv"])
def test_no_cell_becomes_a_formula(name: str, host: str) -> None:
    """Nor a second cell, nor an element of HTML, whatever a submission made us quote."""
    result = real.real("first-hit-wins")
    for check in result["checks"]:
        check.update(message=HOSTILE[name], title=HOSTILE[name])
    text = "email,score,feedback\nada,,\n" if host == "csv" else sheets.GRADEBOOK
    student = "ada" if host == "csv" else "ada@uni.example"
    made = fill(text, host, [Marked(student, ids_of(student), result)])
    rows = rules.read(made.data, ",")
    assert {len(row) for row in rows} == {len(rows[0])}
    for cell in (cell for row in rows[1:] for cell in row if cell != "-"):
        assert not FORMULA.match(cell) or NUMBER.fullmatch(cell)
        if host == "moodle":
            assert "<" not in cell.replace("<br>", "")


def test_filling_twice_is_filling_once(whole_class: list[Marked]) -> None:
    """A second export of the same results changes nothing."""
    once = fill(sheets.ENGLISH, "moodle", whole_class).data
    assert filled(once, "moodle", ANY, whole_class, str).data == once

"""Two students of one name are never called the same."""

from grader.report.people import told_apart


def test_an_id_tells_more_than_a_name() -> None:
    """It is shown wherever it is known, and is something else than the name."""
    people = [("Ada", "u1", "ada-u1"), ("Ada", "u2", "ada-u2"), ("bob", "bob", "bob")]
    assert told_apart(people) == ["Ada (u1)", "Ada (u2)", "bob"]


def test_without_an_id_the_folder_tells_namesakes_apart() -> None:
    """Nobody else's is shown."""
    people = [("Ada", "", "ada"), ("Ada", "", "ada-3f2a1c"), ("Bob", "", "bob")]
    assert told_apart(people) == ["Ada (ada)", "Ada (ada-3f2a1c)", "Bob"]


def test_two_with_the_same_id_have_folders_of_their_own() -> None:
    """A group may hand in twice."""
    people = [("Ada", "u1", "ada-u1"), ("Ada", "u1", "ada-u1-77aa00")]
    assert told_apart(people) == ["Ada (ada-u1)", "Ada (ada-u1-77aa00)"]

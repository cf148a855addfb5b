"""How is a class graded, so that nothing is lost and nothing is done twice?

First everybody's file is read and written down, then each file without a result is graded, by
clerks. What goes wrong with one submission is told and written down, and the others go on.
"""

import json
from collections.abc import Iterator
from dataclasses import dataclass, field, replace
from functools import partial
from typing import Protocol

from grader.batch.files import Results, is_written
from grader.batch.job import Job
from grader.batch.layouts import Arrangement, Place
from grader.batch.offices import Staff, staff
from grader.batch.records import Student
from grader.batch.slug import slug
from grader.batch.store import Store
from grader.batch.table import Totals, write_table
from grader.batch.work import Failed, Order, Refused
from grader.errors import GraderError, MissingTool, OutputFault, WorkerFault
from grader.faults import noted
from grader.intake.handed_in import handed_in
from grader.model.stages import Rejected
from grader.plain import as_name
from grader.sandbox.office import Done, Gone, News, Notice, Told
from grader.selection import select

ATTEMPTS = 2
"""How often a submission is given to a clerk that dies over it."""

SPARE_SECONDS = 120.0
"""What a clerk may need beyond the time of two whole grades, before it is given up."""


class Watch(Protocol):
    """Is told what happens, so that somebody may see it."""

    def reading(self, done: int, total: int) -> None:
        """Somebody's file was read."""

    def grading(self, total: int) -> None:
        """So many files are to be graded."""

    def stage(self, student: Student, stage: str) -> None:
        """A submission has come to a stage."""

    def finished(self, student: Student, score: float | None, most: float) -> None:
        """A submission has its points, or they are withheld."""

    def notice(self, sentence: str) -> None:
        """Something is worth knowing, and nothing is wrong."""

    def trouble(self, sentence: str) -> None:
        """Something of ours went wrong; the others go on."""


@dataclass(slots=True)
class Batch:
    """The grading of a class, as far as it has come."""

    job: Job
    store: Store
    watch: Watch
    troubles: int = 0
    attempts: dict[int, int] = field(default_factory=dict)
    """Per ticket, how often it was given away; only of orders that are being done."""

    at_work: dict[int, Student] = field(default_factory=dict)
    again: list[int] = field(default_factory=list)
    """Tickets whose clerk died."""

    @property
    def results(self) -> Results:
        """What is known."""
        return Results(self.store, self.job)

    def read(self, class_: Arrangement) -> None:
        """Write down what everybody handed in."""
        total = len(class_.places)
        for done, place in enumerate(class_.places, 1):
            self.watch.reading(done, total)
            try:
                self._read_one(place, class_)
            except OutputFault as fault:
                self._trouble(f"{as_name(place.name)}: {fault}")

    def _read_one(self, place: Place, class_: Arrangement) -> None:
        known = self.store.student(place.key)
        student, source = _read(place, class_, self._source_limit())
        if known is not None:
            if student.fault and (known.sha256 or known.reason):
                # It was read by an earlier run: what we have is graded, and a person is told.
                self._trouble(f"{student.told}: {student.fault}; the earlier file still counts")
                return
            student = replace(student, slug=known.slug, written=known.written)
            if student == known:
                return
            student = replace(student, written="")
        else:
            name = slug(place.name, place.id, place.key, self.store.is_taken)
            student = replace(student, slug=name)
        self.store.put(student, source)

    def _source_limit(self) -> int:
        return select(self.job.wish.rubric, ()).rubric.limits.source_kib << 10

    def grade(self) -> None:
        """Grade every file that has no result yet, or one without a score."""
        self.store.forget_withheld(self.job.settings)
        self.watch.grading(sum(1 for _ in self.store.ungraded(self.job.settings)))
        waiting = self.store.ungraded(self.job.settings)
        limits = select(self.job.wish.rubric, ()).rubric.limits
        seconds = 2 * self.job.wish.options().most_seconds(limits) + SPARE_SECONDS
        with staff(self.job, seconds) as office:
            while self._all_busy(office, waiting):
                for news in office.news():
                    self._heard(news)

    def _all_busy(self, office: Staff, waiting: Iterator[Student]) -> bool:
        """Give an order to every free clerk; False if all is done."""
        while not office.is_full:
            if self.again:
                ticket = self.again.pop()
            elif (student := next(waiting, None)) is not None:
                ticket = max(self.at_work, default=0) + 1
                self.at_work[ticket] = student
            else:
                break
            self._give(office, ticket)
        return office.busy > 0

    def _give(self, office: Staff, ticket: int) -> None:
        student = self.at_work[ticket]
        try:
            source = self.store.source(student.sha256 or "")
            office.give(
                ticket, Order(student.submission(source), self.job.wish, self.job.settings)
            )
        except (MissingTool, OutputFault) as fault:
            self._failed(ticket, str(fault))
            return
        self.attempts[ticket] = self.attempts.get(ticket, 0) + 1

    def _heard(self, news: News) -> None:
        if isinstance(news, Notice):
            self.watch.notice(news.sentence)
        elif isinstance(news, Told):
            self.watch.stage(self.at_work[news.ticket], str(news.what))
        elif isinstance(news, Gone):
            self._gone(news)
        elif isinstance(news.result, Failed):
            self._failed(news.ticket, news.result.why, news.result.traceback)
        elif isinstance(news.result, Refused):
            raise WorkerFault(news.result.why)
        else:
            self._done(news)

    def _gone(self, news: Gone) -> None:
        if self.attempts[news.ticket] < ATTEMPTS:
            self.again.append(news.ticket)
            return
        self._failed(news.ticket, f"it was tried {ATTEMPTS} times: {news.why}", news.said)

    def _done(self, news: Done) -> None:
        student = self._leave(news.ticket)
        sha256 = student.sha256 or ""
        try:
            self.store.keep(sha256, self.job.settings, news.result)
            if not self.job.preview:
                self.store.forgive(self.job.settings)
        except OutputFault as fault:
            self._trouble(f"{student.told}: the result is lost, grade again: {fault}")
            return
        result = json.loads(news.result.text)
        self.watch.finished(student, result["score"], result["max_score"])
        if traceback := news.result.traceback:
            self._trouble(f"{student.told}: {_placed('checks of ours failed', traceback)}")
        if not self.job.preview:
            self._write(self.store.same(sha256))

    def _failed(self, ticket: int, why: str, traceback: str = "") -> None:
        """Write down that it was us; the points are withheld."""
        student = self._leave(ticket)
        self.watch.finished(student, None, 0)
        self._trouble(f"{student.told}: {_placed(why, traceback)}")
        if self.job.preview:
            return
        try:
            for one in list(self.store.same(student.sha256 or "")):
                self.store.put(replace(one, fault=why, written=""), b"")
        except OutputFault as fault:
            self._trouble(f"{student.told}: {fault}")
            return
        self._write(self.store.same(student.sha256 or ""))

    def _leave(self, ticket: int) -> Student:
        self.attempts.pop(ticket, None)
        return self.at_work.pop(ticket)

    def write(self) -> Totals:
        """Write the folders that do not hold what the store knows, and the table."""
        self.store.forgive(self.job.settings)
        folder, settings = self.job.folder, self.job.settings
        students = self.store.students()
        self._write(one for one in students if not is_written(one, folder, settings))
        return self.tabulate()

    def tabulate(self) -> Totals:
        """Write the table of the class."""
        try:
            return write_table(self.job, self.store, self.results)
        except GraderError as fault:
            self._trouble(str(fault))
            return Totals()

    def _write(self, students: Iterator[Student]) -> None:
        for student in students:
            try:
                self.results.write(student)
            except GraderError as fault:
                self._trouble(f"{student.told}: {fault}")

    def _trouble(self, sentence: str) -> None:
        self.troubles += 1
        self.watch.trouble(sentence)


def _placed(why: str, traceback: str) -> str:
    """Say why, and where a maintainer finds the traceback, if there is one."""
    return f"{why.removesuffix('.')}. {noted(traceback)}" if traceback else why


def _read(place: Place, class_: Arrangement, limit: int) -> tuple[Student, bytes]:
    """Find a student's file; whatever goes wrong with it is written down."""
    blank = Student(
        place.key,
        "",
        as_name(place.name),
        as_name(place.id),
        as_name(place.email),
        class_.layout,
        path=None,
        sha256=None,
        reason="",
        fault="",
        written="",
    )
    try:
        found = handed_in(place.name, partial(place.entries, class_.source), limit)
    except OSError as fault:
        return replace(blank, fault=f"it could not be read: {fault.strerror}"), b""
    except Exception as fault:  # noqa: BLE001 - one hostile archive must not end the class
        why = f"it could not be read: {type(fault).__name__}: {as_name(str(fault))}"
        return replace(blank, fault=why), b""
    if isinstance(found, Rejected):
        return replace(blank, reason=found.reason), b""
    return replace(blank, path=found.path, sha256=found.sha256), found.source

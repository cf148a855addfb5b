"""How is one submission compiled, linked and read by the compiler's front end?"""

import time
from collections.abc import Mapping
from concurrent.futures import Executor, Future, ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path
from tempfile import mkdtemp

from grader.build.callgraph import Tangled, read_assembly
from grader.build.compiler import find_compiler
from grader.build.compiling import TRUSTED, Compilation, compiled, compiled_once
from grader.build.diagnostics import read_diagnostics
from grader.build.stopped import why_stopped
from grader.build.workspace import GRADED, SANITIZED, Workspace, with_real_depth, workspace
from grader.errors import BuildFault
from grader.model.stages import SOURCE_PATH, Build, CallGraph, Diagnostic, Further, Submission
from grader.resources import reference_source
from grader.sandbox.selftest import unconfined


@dataclass(frozen=True, slots=True)
class _Linked:
    """One flavour of a submission: a library, or what was wrong with it."""

    library: Path | None
    diagnostics: tuple[Diagnostic, ...]
    unexplained: bool = False
    """The compiler ended early without a word about the source: is that the machine's fault?"""


@dataclass(frozen=True, slots=True)
class _Sanitized:
    """The libraries with sanitizers, as far as they are asked for and could be made."""

    small: Path | None = None
    deep: Path | None = None
    remarks: tuple[str, ...] = ()


def compile_submission(submission: Submission, order: Compilation) -> Build:
    """Build the graded library of one submission, and what else is asked for.

    Args:
        submission: The file to compile.
        order: What, where and within which limits; the folder is kept as long as the libraries
            are used.

    Raises:
        MissingTool: There is no compiler.
        BuildFault: Our own framework does not compile, or the machine is too busy.
    """
    compiler = find_compiler()
    started = time.monotonic()
    work = prepared(submission, order)
    with ThreadPoolExecutor(2) as pool:
        graded, small = pool.map(lambda each: workspace(compiler, each), (GRADED, SANITIZED))
        plain = pool.submit(_link, graded, work, GRADED.name)
        sanitizing = _sanitizing(pool, small, work)
        graph = (
            pool.submit(call_graph, graded, work) if Further.CALLS in order.further else None
        )
        linked = plain.result()
        compiled = linked.library is not None
        if not compiled:
            pool.shutdown(wait=False, cancel_futures=True)
            if linked.unexplained:
                _blame(graded.linking, graded, work)
        safe = _sanitized(sanitizing, small, work) if compiled else _Sanitized()
        calls = graph.result() if compiled and graph else None
        if compiled and graph and calls is None:
            _blame(graded.listing, graded, work)
    return Build(
        library=linked.library,
        sanitized=safe.small,
        deep=safe.deep,
        calls=calls,
        diagnostics=linked.diagnostics,
        compiler=compiler.title,
        flags=_flags(graded),
        seconds=time.monotonic() - started,
        remarks=safe.remarks,
        own_seconds=sum(work.spent),
    )


def _sanitizing(
    pool: Executor, small: Workspace, work: Compilation
) -> dict[Further, Future[_Linked]]:
    """Begin to build those libraries with sanitizers that are asked for."""
    frameworks = {Further.SANITIZED: small, Further.DEEP: _deep(small)}
    return {
        each: pool.submit(_link, framework, work, each.value)
        for each, framework in frameworks.items()
        if each in work.further
    }


def _sanitized(
    begun: Mapping[Further, Future[_Linked]], framework: Workspace, work: Compilation
) -> _Sanitized:
    """Wait for the libraries with sanitizers.

    A file may insist on the real depth limit, by static_assert: it gets that one for both.
    """
    made = {each: job.result() for each, job in begun.items()}
    small, deep = made.get(Further.SANITIZED), made.get(Further.DEEP)
    if small and small.library is None and deep is None:
        deep = _link(_deep(framework), work, Further.DEEP.value)
    if deep is None:
        return _Sanitized(small.library if small else None)
    if deep.unexplained:
        _blame(_deep(framework).linking, framework, work)
    library = (small.library or deep.library) if small else None
    return _Sanitized(library, deep.library, _unsanitized(deep))


def _blame(command: tuple[str, ...], framework: Workspace, work: Compilation) -> None:
    """Make sure that it is the submission that the compiler does not get through.

    Raises:
        BuildFault: Our own solution does not compile now either: a full disk, no process left.
    """
    own = Submission("reference", SOURCE_PATH, reference_source().read_bytes(), "")
    aside = prepared(own, replace(work, folder=Path(mkdtemp(dir=work.folder))))
    outcome, content = compiled(command, framework, aside, f"{GRADED.name}.so")
    if content is None:
        words = outcome.err.decode(errors="replace").strip()[-500:]
        message = f"the compiler does not get through our own solution either: {words}"
        raise BuildFault(message)


def _unsanitized(linked: _Linked) -> tuple[str, ...]:
    """Say why memory could not be checked; nothing if it could."""
    if linked.library is not None:
        return ()
    errors = (each for each in linked.diagnostics if each.severity == "error")
    first = next(errors, Diagnostic(0, 0, "error", "no reason is known"))
    where = f"line {first.line}: " if first.line else ""
    return (f"with sanitizers it does not compile, so memory is not safe: {where}{first.text}",)


def prepared(submission: Submission, work: Compilation) -> Compilation:
    """Lay out the folder of a submission: its source, which all may read, and room for ours."""
    source = work.folder / SOURCE_PATH
    for folder in (work.folder, source.parent, work.folder / "libraries"):
        folder.mkdir(parents=True, exist_ok=True)
        folder.chmod(0o711)
    source.write_bytes(submission.source)
    source.chmod(0o644)
    return work


def _deep(framework: Workspace) -> Workspace:
    return replace(framework, compile_command=with_real_depth(framework.compile_command))


def compile_reference(submission: Submission, folder: Path) -> Path:
    """Build the graded library of our own solution.

    Raises:
        BuildFault: It does not compile.
    """
    linked = _trusted(submission, folder)
    if linked.library is None:
        message = f"the reference does not compile: {linked.diagnostics[:3]}"
        raise BuildFault(message)
    return linked.library


def compile_trusted(submission: Submission, folder: Path) -> Path | None:
    """Build the graded library of a source of ours; None if it does not compile."""
    return _trusted(submission, folder).library


def _trusted(submission: Submission, folder: Path) -> _Linked:
    work = prepared(submission, Compilation(folder, unconfined(), TRUSTED))
    return _link(workspace(find_compiler(), GRADED), work, GRADED.name)


def _flags(framework: Workspace) -> tuple[str, ...]:
    """Flags that can change what a submission computes: no paths, no warnings."""
    return tuple(
        word
        for word in framework.compile_command[1:]
        if word.startswith(("-O", "-f", "-std", "-D")) and "/" not in word
    )


def _link(framework: Workspace, work: Compilation, name: str) -> _Linked:
    """Compile and link one flavour; whatever goes wrong is the submission's fault."""
    product = f"{name}.so"
    outcome, content = compiled_once(framework.linking, framework, work, product)
    messages = read_diagnostics(outcome.err)
    if content is None:
        silent = not any(message.severity == "error" for message in messages)
        if silent:
            messages += (Diagnostic(0, 0, "error", why_stopped(outcome, work.limits)),)
        return _Linked(None, messages, silent and not outcome.timed_out)
    library = work.folder / "libraries" / product
    library.write_bytes(content)
    library.chmod(0o644)
    return _Linked(library, messages)


def call_graph(framework: Workspace, work: Compilation) -> CallGraph | None:
    """Ask the front end who calls whom; None if that cannot be found out in time."""
    _, content = compiled_once(framework.listing, framework, work, "graph.s")
    try:
        return None if content is None else read_assembly(content)
    except Tangled:
        return None

"""How is one submission compiled, linked and read by the compiler's front end?"""

import time
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass, replace
from pathlib import Path

from grader.build.callgraph import read_assembly
from grader.build.compiler import find_compiler
from grader.build.diagnostics import SOURCE_NAME, read_diagnostics
from grader.build.workspace import GRADED, SANITIZED, Workspace, workspace
from grader.errors import BuildFault
from grader.model.stages import Build, CallGraph, Diagnostic, Submission
from grader.sandbox.launch import Order, Outcome, launch

COMPILE_SECONDS = 60.0
LINK_SECONDS = 30.0
KEPT_OUTPUT = 64 << 10
PLAIN_MESSAGES = ("-fdiagnostics-color=never", "-fmax-errors=20")
"""More errors teach nothing new, and each unknown name is compared with all known ones."""


@dataclass(frozen=True, slots=True)
class _Linked:
    """One flavour of a submission: a library, or what was wrong with it."""

    library: Path | None
    diagnostics: tuple[Diagnostic, ...]


def compile_submission(submission: Submission, folder: Path) -> Build:
    """Build the graded and the sanitized library and the call graph of one submission.

    Args:
        submission: The file to compile.
        folder: An empty folder of our own, kept as long as the libraries are used.

    Raises:
        MissingTool: There is no compiler.
        BuildFault: Our own framework does not compile.
    """
    compiler = find_compiler()
    started = time.monotonic()
    source = folder / SOURCE_NAME
    source.parent.mkdir(parents=True)
    source.write_bytes(submission.source)
    with ThreadPoolExecutor(2) as pool:
        flavours = (GRADED, SANITIZED)
        frameworks = list(pool.map(lambda each: workspace(compiler, each), flavours))
        plain = pool.submit(_link, frameworks[0], folder, GRADED.name)
        sanitized = pool.submit(_link, frameworks[1], folder, SANITIZED.name)
        deep = pool.submit(_link, _with_real_depth(frameworks[1]), folder, "deep")
        graph = pool.submit(call_graph, frameworks[0], folder)
    linked = plain.result()
    compiled = linked.library is not None
    return Build(
        library=linked.library,
        # A file may insist on the real depth limit, by static_assert.
        sanitized=sanitized.result().library or deep.result().library if compiled else None,
        deep=deep.result().library if compiled else None,
        calls=graph.result() if compiled else None,
        diagnostics=linked.diagnostics,
        compiler=compiler.title,
        flags=_flags(frameworks[0]),
        seconds=time.monotonic() - started,
    )


def _with_real_depth(framework: Workspace) -> Workspace:
    return replace(
        framework, compile_command=(*framework.compile_command, "-UEX03_MAX_DEPTH")
    )


def compile_reference(submission: Submission, folder: Path) -> Path:
    """Build the graded library of our own solution.

    Raises:
        BuildFault: It does not compile.
    """
    source = folder / SOURCE_NAME
    source.parent.mkdir(parents=True)
    source.write_bytes(submission.source)
    linked = _link(workspace(find_compiler(), GRADED), folder, GRADED.name)
    if linked.library is None:
        message = f"the reference does not compile: {linked.diagnostics[:3]}"
        raise BuildFault(message)
    return linked.library


def _flags(framework: Workspace) -> tuple[str, ...]:
    """Flags that can change what a submission computes: no paths, no warnings."""
    return tuple(
        word
        for word in framework.compile_command[1:]
        if word.startswith(("-O", "-f", "-std", "-D")) and "/" not in word
    )


def _link(framework: Workspace, folder: Path, name: str) -> _Linked:
    """Compile and link one flavour; whatever goes wrong is the submission's fault."""
    result = folder / f"{name}.o"
    step = [*framework.compile_command, *PLAIN_MESSAGES, "-c", SOURCE_NAME, "-o", str(result)]
    compiled = launch(Order(step, COMPILE_SECONDS, KEPT_OUTPUT, folder))
    messages = _messages(compiled, "compiling", COMPILE_SECONDS)
    if compiled.code != 0:
        return _Linked(None, messages)
    library = folder / f"{name}.so"
    # The submission's object comes first, so that its functions win over the weak stand-ins.
    head, *rest = framework.link_command
    step = [head, str(result), *rest, "-o", str(library)]
    linked = launch(Order(step, LINK_SECONDS, KEPT_OUTPUT, folder))
    messages += _messages(linked, "linking", LINK_SECONDS)
    return _Linked(library if linked.code == 0 else None, messages)


def _messages(outcome: Outcome, doing: str, seconds: float) -> tuple[Diagnostic, ...]:
    """Say why a step failed, even if the compiler itself did not."""
    found = read_diagnostics(outcome.err)
    if outcome.code == 0 or any(message.severity == "error" for message in found):
        return found
    text = f"{doing} ended with status {outcome.code}"
    if outcome.timed_out:
        text = f"{doing} took longer than {seconds:.0f} s"
    return (*found, Diagnostic(0, 0, "error", text))


def call_graph(framework: Workspace, folder: Path) -> CallGraph | None:
    """Ask the front end who calls whom; None if it does not get through the file."""
    result = folder / "graph.s"
    step = [*framework.graph_command, *PLAIN_MESSAGES, "-S", SOURCE_NAME, "-o", str(result)]
    outcome = launch(Order(step, COMPILE_SECONDS, KEPT_OUTPUT, folder))
    if outcome.code != 0 or not result.is_file():
        return None
    return read_assembly(result.read_bytes())

"""How does a compiler run on one submission, so that a busy machine is nobody's fault?"""

from dataclasses import dataclass, field
from pathlib import Path

from grader.build.product import adopted
from grader.build.remembered import Product, keep, name_of, recalled
from grader.build.workspace import Workspace
from grader.errors import BuildFault
from grader.model.grade import CompileLimits
from grader.model.stages import SOURCE_PATH, Further
from grader.sandbox.box import Bounds, Box, Isolation
from grader.sandbox.confine import confined
from grader.sandbox.launch import Outcome
from grader.sandbox.stage import staged
from grader.sandbox.target import Target
from grader.sandbox.turns import Turns

PLAIN_MESSAGES = ("-fdiagnostics-color=never", "-fmax-errors=20")
"""More errors teach nothing new, and each unknown name is compared with all known ones."""

_STACK_BYTES = 64 << 20
_OPEN_FILES = 256

PATIENCE = 2.0
"""How many times as long a compiler may take that was kept waiting, and then runs alone.

A container with half a processor gives two compilers a quarter each.
"""

TRUSTED = CompileLimits(
    seconds=60,
    wall_seconds=300,
    memory_mib=4096,
    file_mib=256,
    tasks=64,
    output_kib=64,
)
"""For sources of ours: these limits only end a machine's bad day."""


@dataclass(frozen=True, slots=True)
class Compilation:
    """Where, how confined and within which limits a submission is compiled."""

    folder: Path
    """A folder of our own."""

    isolation: Isolation
    limits: CompileLimits
    further: frozenset[Further] = frozenset(Further)
    """What to make beside the graded library."""

    spent: list[float] = field(default_factory=list)
    """Takes the own seconds of each compiler that ran for the submission."""

    turns: Turns = field(default_factory=Turns)
    """Compilers of a submission run side by side; one that was kept waiting runs alone."""


def compiled_once(
    command: tuple[str, ...], framework: Workspace, work: Compilation, product: str
) -> tuple[Outcome, bytes | None]:
    """Do as `compiled`, or take what it made of the same file before, in such a box."""
    source = (work.folder / SOURCE_PATH).read_bytes()
    words = (*command, work.isolation.level.value, repr(work.limits))
    name = name_of(source, words, framework.folder, product)
    before = recalled(name)
    if before is not None:
        return Outcome(0, False, b"", before.messages, 0.0, 0.0), before.content
    outcome, content = compiled(command, framework, work, product)
    # Of a process that is killed with its namespace the kernel forgets the CPU time.
    waited = outcome.seconds - outcome.delayed_seconds
    work.spent.append(waited if outcome.timed_out else outcome.cpu_seconds)
    if content is not None:
        keep(name, Product(content, outcome.err))
    return outcome, content


def compiled(
    command: tuple[str, ...], framework: Workspace, work: Compilation, product: str
) -> tuple[Outcome, bytes | None]:
    """Run a compiler in a box; its output, and what it made if it succeeded.

    Raises:
        BuildFault: It got too little of the processor, alone and with twice the time, too.
    """
    seconds = work.limits.wall_seconds
    with work.turns.shared():
        outcome, content = _boxed(command, framework, work, product, seconds)
    if _waited(outcome, work.limits):
        with work.turns.alone():
            again = PATIENCE * seconds
            outcome, content = _boxed(command, framework, work, product, again)
    if _waited(outcome, work.limits):
        message = (
            "compiling stood in line for a processor for too long; grade it again when the "
            "machine is less busy"
        )
        raise BuildFault(message)
    return outcome, content


def _waited(outcome: Outcome, limits: CompileLimits) -> bool:
    """Tell whether a compiler was ended that had got too little of the processor.

    Who got the time of one process, or half of what the clock gave, had enough of it. Not its
    CPU time: the kernel forgets that of processes that are killed with their namespace.
    """
    enough = min(limits.seconds, limits.wall_seconds / 2)
    return outcome.timed_out and outcome.seconds - outcome.delayed_seconds < enough


def _boxed(
    command: tuple[str, ...],
    framework: Workspace,
    work: Compilation,
    product: str,
    seconds: float,
) -> tuple[Outcome, bytes | None]:
    limits = work.limits
    own = work.folder / product.replace(".", "-")
    if own.exists():
        own = own.with_name(f"{own.name}-again")
    own.mkdir(mode=0o700)
    bounds = Bounds(
        cpu_seconds=limits.seconds,
        memory_bytes=limits.memory_mib << 20,
        file_bytes=limits.file_mib << 20,
        open_files=_OPEN_FILES,
        tasks=limits.tasks,
        stack_bytes=_STACK_BYTES,
    )
    readable = (work.folder / "src", framework.folder, *framework.compiler_folders)
    box = Box((*readable, staged().parent), bounds, own, starts_programs=True)
    program, *words = command
    target = Target(
        program=program,
        arguments=[*words, *PLAIN_MESSAGES, "-o", str(own / product)],
        seconds=seconds,
        output_bytes=limits.output_kib << 10,
        folder=work.folder,
        environment={"TMPDIR": str(own)},
    )
    outcome = confined(target, box, staged(), work.isolation)
    made = outcome.code == 0 and not outcome.timed_out
    return outcome, adopted(own, product, limits.file_mib << 20) if made else None

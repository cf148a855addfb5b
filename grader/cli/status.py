"""Which exit status a command ends with, and what is said when it cannot do its work.

0 a grade was produced, or full marks in `check`; 1 `check` lost points; 2 wrong usage; 3 our
own fault; 130 interrupted, 143 terminated. No traceback is ever shown: it is kept in a file,
which is named.
"""

import sys
import traceback
from typing import Any, NoReturn

import click

from grader.cli.output import lead_nowhere
from grader.errors import GraderError, Interrupted, OutputFault, UsageError
from grader.faults import noted
from grader.report.escape import for_terminal

FULL_MARKS = 0
LOST_POINTS = 1
WRONG_USAGE = 2
OUR_FAULT = 3
INTERRUPTED = 130


class GraderGroup(click.Group):
    """A group whose commands may raise anything and still end with the right status."""

    def make_context(
        self,
        info_name: str | None,
        args: list[str],
        parent: click.Context | None = None,
        **extra: Any,  # noqa: ANN401 - click's own signature
    ) -> click.Context:
        """Read the options before the command.

        Raises:
            click.UsageError: They are wrong; what of them is a stranger's is harmless.
        """
        try:
            return super().make_context(info_name, args, parent, **extra)
        except click.UsageError as fault:
            raise harmless(fault) from fault.__cause__
        except OutputFault as fault:
            # Help and version are printed here.
            stop(str(fault), OUR_FAULT)

    def invoke(self, ctx: click.Context) -> Any:  # noqa: ANN401 - click's own signature
        """Run the command; turn what it raises into one sentence and a status.

        Raises:
            click.UsageError: Its options are wrong; see `make_context`.
        """
        try:
            return super().invoke(ctx)
        except click.UsageError as fault:
            raise harmless(fault) from fault.__cause__
        except (click.ClickException, click.exceptions.Exit, BrokenPipeError):
            raise
        except (KeyboardInterrupt, click.Abort, Interrupted) as fault:
            status = getattr(fault, "status", INTERRUPTED)
            stop("interrupted; no result was changed", status)
        except UsageError as fault:
            stop(str(fault), WRONG_USAGE)
        except OutputFault as fault:
            stop(str(fault), OUR_FAULT)
        except GraderError as fault:
            stop(f"{fault}\nNothing is concluded about the submission.", OUR_FAULT)
        except Exception as fault:  # noqa: BLE001 - the outermost place: it must not reach a student
            stop(surprise(fault), OUR_FAULT)


def harmless(fault: click.UsageError) -> click.UsageError:
    """Take the power from what click quotes: a shell's `*` may have named a stranger's file."""
    if isinstance(fault, click.exceptions.NoArgsIsHelpError):
        return fault
    return click.UsageError(for_terminal(fault.format_message()), fault.ctx)


def stop(sentence: str, status: int) -> NoReturn:
    """Say why on standard error and leave.

    Raises:
        click.exceptions.Exit: Always, with the status.
    """
    try:
        for line in for_terminal(sentence).splitlines():
            click.echo(f"bvhgrade: {line}", err=True)
    except OSError:
        # Nothing can be said any more, but the status says it.
        lead_nowhere(sys.stderr.fileno())
    raise click.exceptions.Exit(status)


def tell_of(traceback: str) -> None:
    """Say on standard error where the traceback of checks that broke is, if any did."""
    if traceback:
        click.echo(for_terminal(f"bvhgrade: {noted(traceback)}"), err=True)


def surprise(fault: Exception) -> str:
    """Word a fault that nobody foresaw, and keep its traceback in a file."""
    kind = type(fault).__name__
    text = "".join(traceback.format_exception(fault))
    return (
        f"the grader itself failed ({kind}); nothing is concluded about the submission.\n"
        f"{noted(text)}"
    )

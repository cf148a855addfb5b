"""What runs in a process that holds a submission and stays: it traces what it is asked for.

It carries out a job as any worker does. Then it waits for rows on a pipe, whose rays stand in
the result, and leaves when the pipe is closed. A row of a turn that is over is skipped, so that
who looks elsewhere need not wait for what nobody wants to see any more.
"""

from __future__ import annotations

import os
import time

# A constant that type checkers know: `typing` and `collections` would cost every worker 8 ms.
TYPE_CHECKING = False
if TYPE_CHECKING:
    from collections.abc import Sequence

    from grader.run import protocol, worker
    from grader.run.protocol import Op, Status
    from grader.run.worker import Worker
else:
    # The package is out of reach here: the files beside this one are all that is needed.
    import protocol
    import worker
    from protocol import Op, Status
    from worker import Worker


class Tracer(Worker):
    """A worker that takes the time, and knows that the turn of a row may be over."""

    spent = 0
    """Nanoseconds in `intersect` so far."""

    def construct(self, tree: int, mesh: int) -> int:
        """Call the submission's `construct`."""
        begun = time.monotonic_ns()
        status = super().construct(tree, mesh)
        self.put(protocol.CONSTRUCT_NS, time.monotonic_ns() - begun)
        return status

    def wait(self, orders: int) -> int:
        """Carry out rows until there are no more, or one fails; returns its status."""
        # From now on what is asked for stands in the result, too.
        self.source = self.target
        done = int.from_bytes(self.result[16:24], "little")
        while data := os.read(orders, protocol.ROW.size):
            status = self.asked(protocol.ROW.unpack(data))
            if status != Status.OK:
                return status
            done += 1
            self.put(16, done)
        os._exit(0)

    def asked(self, row: Sequence[int]) -> int:
        """Run one row, unless its turn is over."""
        if row[0] != Op.TRACE:
            return self.one(row)
        turn = int.from_bytes(self.result[protocol.TURN : protocol.TURN + 8], "little")
        if row[-1] != turn:
            return Status.OK
        begun = time.monotonic_ns()
        status = self.one([*row[:-1], 1])
        self.spent += time.monotonic_ns() - begun
        self.put(protocol.TRACE_NS, self.spent)
        return status


def main(arguments: Sequence[str]) -> None:
    """Carry out a job, then what is asked for."""
    library, given, result, orders = arguments
    tracer = worker.begun(Tracer, library, given, result)
    status = tracer.carry_out()
    if status == Status.OK:
        status = tracer.wait(int(orders))
    worker.leave(tracer, status)

"""What is kept of an output stream."""

from grader.sandbox import streams


def test_what_never_ends_is_not_read_to_its_end() -> None:
    """After the child's death no more is read than a pipe can hold."""

    class Endless(streams.Stream):
        """A pipe into which someone writes as fast as it is read."""

        reads = 0

        def __init__(self) -> None:
            pass

        def drain(self) -> int:
            """Find a full pipe again."""
            self.reads += 1
            assert self.reads < 1000
            return streams.CHUNK

    stream = Endless()
    stream.drain_all()
    assert stream.reads * streams.CHUNK == streams.PIPE_LIMIT

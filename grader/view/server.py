"""The viewer as a page of this machine alone: what `view --web` does.

It listens on the loopback interface. Somebody else's page in the same browser could ask it as
well: so the address has a secret part, and the header Host must name this machine, which a page
cannot forge by giving its own name our address.
"""

import json
import secrets
import socket
import threading
from collections.abc import Sequence
from contextlib import suppress
from functools import partial
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from typing import Any
from urllib.parse import parse_qs, urlsplit

import click

from grader.errors import UsageError
from grader.language import translator
from grader.plain import one_line
from grader.view.asked import Unanswered
from grader.view.desk import Desk
from grader.view.dropped import kept
from grader.view.page import HERE, invitation, written
from grader.view.service import Service
from grader.view.study import Study

NAMES = (HERE, "localhost")
LARGEST = 64 << 10
"""Bytes of a question."""

IDLE_SECONDS = 30.0
"""How long a connection may say nothing; the page of a tab in front asks all the time."""

MOST_STRANGERS = 32
"""Connections at once that have not named the secret."""


def served(desk: Desk, study: Study, scenes: Sequence[str], language: str) -> None:
    """Serve the page until Ctrl-C.

    Raises:
        KeyboardInterrupt: At the end.
    """
    words = translator(language)
    service = Service(desk, study, words)
    with Door(service, written(desk.path, scenes, language)) as door:
        click.echo(invitation(door.port, words))
        click.echo(door.address)
        service.serve()


class Door:
    """The server; as a context it is open within the block."""

    def __init__(self, service: Service, text: str) -> None:
        """Take a free port.

        Args:
            service: Answers.
            text: Of the page.
        """
        self.token = secrets.token_urlsafe(16)
        handler = partial(_Handler, service, text, self.token)
        self._server = _Server((HERE, 0), handler)
        self.port = int(self._server.server_address[1])
        self._thread = threading.Thread(target=self._server.serve_forever, daemon=True)

    @property
    def address(self) -> str:
        """What to open."""
        return f"http://{HERE}:{self.port}/{self.token}/"

    def __enter__(self) -> "Door":
        """Open it."""
        self._thread.start()
        return self

    def __exit__(self, *_: object) -> None:
        """Close it."""
        self._server.shutdown()
        self._server.server_close()


class _Server(ThreadingHTTPServer):
    """Answers every connection in a thread of its own.

    Any user of this machine can connect: of those who have not named the secret, only the last
    ones stay.
    """

    daemon_threads = True
    request_queue_size = MOST_STRANGERS

    def __init__(self, *given: Any) -> None:  # noqa: ANN401 - http.server's own
        self._strangers: dict[socket.socket, None] = {}
        self._lock = threading.Lock()
        super().__init__(*given)

    def process_request(self, request: Any, client_address: Any) -> None:  # noqa: ANN401 - http.server's own
        """Take a connection, and end the oldest of strangers if there are too many."""
        with self._lock:
            self._strangers[request] = None
            many = len(self._strangers) > MOST_STRANGERS
            oldest = next(iter(self._strangers)) if many else None
        if oldest is not None:
            self.trust(oldest)
            # Whoever waits for it to say something hears that it ended.
            with suppress(OSError):
                oldest.shutdown(socket.SHUT_RDWR)
        super().process_request(request, client_address)

    def trust(self, request: socket.socket) -> None:
        """Count a connection no longer among the strangers'."""
        with self._lock:
            self._strangers.pop(request, None)

    def shutdown_request(self, request: Any) -> None:  # noqa: ANN401 - http.server's own
        """End a connection."""
        self.trust(request)
        super().shutdown_request(request)

    def handle_error(self, *_: object) -> None:
        """Say nothing: a browser whose page is closed goes away in the middle of an answer."""


class _Handler(BaseHTTPRequestHandler):
    """Answers one connection."""

    protocol_version = "HTTP/1.1"
    server_version, sys_version = "bvhgrade", ""
    timeout = IDLE_SECONDS

    def __init__(self, service: Service, text: str, token: str, *given: Any) -> None:  # noqa: ANN401 - http.server's own
        self._service, self._text, self._token = service, text, token
        super().__init__(*given)

    def log_message(self, *_: object) -> None:
        """Say nothing: what is asked for may come from a stranger."""

    def do_GET(self) -> None:
        """Answer a question that changes nothing."""
        place = self._place()
        try:
            self._answer(place)
        except Unanswered as fault:
            self._json(str(fault), 500)

    def _answer(self, place: str | None) -> None:
        if place == "":
            self._send(self._text.encode(), "text/html; charset=utf-8")
        elif place == "state":
            self._json(self._service.ask(self._service.state))
        elif place == "model":
            self._json(self._service.ask(self._service.model))
        elif place == "image":
            self._image()
        elif place is not None:
            self._refuse(404)

    def do_POST(self) -> None:
        """Do what is asked for."""
        place = self._place()
        if place is None:
            return
        try:
            self._json(self._taken() if place == "drop" else self._done(place))
        except UsageError as fault:
            self._json(one_line(str(fault)), 400)
        except Unanswered as fault:
            self._json(one_line(str(fault)), 500)

    def _done(self, place: str) -> object:
        """Do what is asked for in words."""
        given, service = self._given(), self._service
        if place not in ("look", "do") or given is None:
            raise UsageError("there is no such question")
        return service.ask(lambda: (service.look if place == "look" else service.do)(given))

    def _taken(self) -> object:
        """Take a file that was dropped onto the page."""
        size, service = self._size(), self._service
        name = parse_qs(urlsplit(self.path).query).get("name", [""])[0]
        # What is left unread would be taken for the next question.
        self.close_connection = True
        load = kept(name, size, self.rfile)
        self.close_connection = False
        return service.ask(lambda: service.open(load))

    def _place(self) -> str | None:
        """What is asked for, behind the secret part; None if it was refused."""
        name = (self.headers.get("Host") or "").rpartition(":")[0]
        if name not in NAMES:
            self._refuse(403)
            return None
        if self.path == "/favicon.ico":
            # Browsers ask by themselves.
            self._refuse(204)
            return None
        first, _, rest = urlsplit(self.path).path.lstrip("/").partition("/")
        if not secrets.compare_digest(first.encode(), self._token.encode()):
            self._refuse(404)
            return None
        if isinstance(self.server, _Server):
            self.server.trust(self.connection)
        return rest

    def _given(self) -> dict[str, Any] | None:
        """The values of a question; None if it is none."""
        size = self._size()
        if not 0 <= size <= LARGEST:
            self.close_connection = True
            return None
        try:
            given = json.loads(self.rfile.read(size))
        except (ValueError, RecursionError):
            return None
        return given if isinstance(given, dict) else None

    def _size(self) -> int:
        """Bytes of the body; -1 if the page does not say."""
        size = self.headers.get("Content-Length") or ""
        return int(size) if size.isdecimal() else -1

    def _image(self) -> None:
        """Send the right pane, if it is another one than the page has."""
        after = parse_qs(urlsplit(self.path).query).get("after", ["-1"])[0]
        number = int(after) if after.lstrip("-").isdecimal() else -1
        found = self._service.ask(lambda: self._service.image(number))
        if found is None:
            self._send(b"", "text/plain", 204)
            return
        version, shown, share = found
        height, width = shown.pixels.shape[:2]
        told = {"width": width, "height": height, "version": version, "share": share}
        self._send(shown.pixels.tobytes(), "application/octet-stream", 200, told)

    def _json(self, value: object, status: int = 200) -> None:
        self._send(json.dumps(value, allow_nan=False).encode(), "application/json", status)

    def _refuse(self, status: int) -> None:
        # What was sent along was not read, and is not to be taken for the next request.
        self.close_connection = True
        self._send(b"", "text/plain", status)

    def _send(
        self, data: bytes, kind: str, status: int = 200, told: dict[str, Any] | None = None
    ) -> None:
        self.send_response(status)
        self.send_header("Content-Type", kind)
        self.send_header("Content-Length", str(len(data)))
        self.send_header("Cache-Control", "no-store")
        self.send_header("X-Content-Type-Options", "nosniff")
        self.send_header("Referrer-Policy", "no-referrer")
        for name, value in (told or {}).items():
            self.send_header(f"X-{name}", str(value))
        self.end_headers()
        self.wfile.write(data)

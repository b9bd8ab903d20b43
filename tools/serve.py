#!/usr/bin/env python3
"""Builds the WebAssembly core and serves the page on this machine.

    python3 tools/serve.py [--port N] [--open] [--no-build] [--host ADDRESS]

Installs what is missing (tools/setup.py says what it does), builds what is stale and prints the page's address. The
page is web/ at /, the built core at /build/ and assets/ at /assets/. The browser asks again for every file (no-cache
with an ETag), so that a reload shows what was just built, and everything is under the strict policy that the page
promises to work with.
"""

import argparse
import errno
import os
import shutil
import socket
import sys
import threading
import webbrowser
from contextlib import contextmanager
from email.utils import formatdate
from http import HTTPStatus
from http.server import BaseHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from typing import NamedTuple
from urllib.parse import quote, unquote, urlsplit

import build

ROOT = Path(__file__).resolve().parent.parent
DEFAULT_PORT = 8000
PORTS_TRIED = 50
CONTENT_SECURITY_POLICY = "; ".join((
    "default-src 'none'",
    "script-src 'self' 'wasm-unsafe-eval'",
    "style-src 'self'",
    "img-src 'self' data: blob:",
    "font-src 'self'",
    "connect-src 'self'",
    "base-uri 'none'",
    "form-action 'none'",
    "frame-ancestors 'none'",
))
MIME_TYPES = {
    ".html": "text/html; charset=utf-8",
    ".js": "text/javascript; charset=utf-8",
    ".mjs": "text/javascript; charset=utf-8",
    ".css": "text/css; charset=utf-8",
    ".json": "application/json; charset=utf-8",
    ".map": "application/json; charset=utf-8",
    ".webmanifest": "application/manifest+json; charset=utf-8",
    ".txt": "text/plain; charset=utf-8",
    ".wasm": "application/wasm",
    ".woff2": "font/woff2",
    ".glb": "model/gltf-binary",
    ".gltf": "model/gltf+json",
    ".bin": "application/octet-stream",
    ".svg": "image/svg+xml",
    ".png": "image/png",
    ".jpg": "image/jpeg",
    ".webp": "image/webp",
    ".ico": "image/x-icon",
}


class Mount(NamedTuple):
    """A folder and the path under which it is served; suffixes: the only files of it that are, all when empty."""

    path: str
    folder: Path
    suffixes: tuple = ()


# The first mount whose path begins the request's wins.
MOUNTS = (
    Mount("/build/", ROOT / "build/wasm", (".js", ".wasm", ".map")),
    Mount("/assets/", ROOT / "assets"),
    Mount("/", ROOT / "web"),
)


def locate(mounts, request_path: str):
    """The file for a request's path (still percent-encoded), or None when it names nothing that is served."""
    path = unquote(request_path)
    if "\0" in path or "\\" in path:
        return None
    for mount in mounts:
        if not path.startswith(mount.path):
            continue
        names = path[len(mount.path):].split("/")
        # Neither .. nor hidden files; an empty name only at the end, where it stands for the folder.
        if any(name.startswith(".") for name in names) or "" in names[:-1]:
            return None
        root = mount.folder.resolve()
        file = root.joinpath(*names).resolve()
        if not file.is_relative_to(root):  # by a link
            return None
        if names[-1] == "":
            file = file / "index.html"
        if not file.is_file() or (mount.suffixes and file.suffix not in mount.suffixes):
            return None
        return file
    return None


class Handler(BaseHTTPRequestHandler):
    protocol_version = "HTTP/1.1"
    server_version = "dimline"
    sys_version = ""
    timeout = 60

    def do_GET(self):
        self.answer(with_body=True)

    def do_HEAD(self):
        self.answer(with_body=False)

    def answer(self, with_body: bool) -> None:
        path = urlsplit(self.path).path
        file = locate(self.server.mounts, path)
        if file is None:
            if not path.endswith("/") and locate(self.server.mounts, path + "/"):
                self.send_response(HTTPStatus.MOVED_PERMANENTLY)
                self.send_header("Location", quote(unquote(path)) + "/")
                self.send_header("Content-Length", "0")
                self.end_headers()
                return
            self.send_error(HTTPStatus.NOT_FOUND)
            return
        # The size comes from the text that is sent: a build may replace the file meanwhile.
        body = file.read_bytes()
        modified = file.stat()
        etag = f'"{modified.st_mtime_ns:x}-{len(body):x}"'
        fresh = etag in (self.headers.get("If-None-Match") or "")
        self.send_response(HTTPStatus.NOT_MODIFIED if fresh else HTTPStatus.OK)
        self.send_header("ETag", etag)
        self.send_header("Last-Modified", formatdate(modified.st_mtime, usegmt=True))
        self.send_header("Cache-Control", "no-cache")
        if not fresh:
            self.send_header("Content-Type", MIME_TYPES.get(file.suffix.lower(), "application/octet-stream"))
            self.send_header("Content-Length", str(len(body)))
        self.end_headers()
        if with_body and not fresh:
            self.wfile.write(body)

    def end_headers(self):
        self.send_header("Content-Security-Policy", CONTENT_SECURITY_POLICY)
        self.send_header("X-Content-Type-Options", "nosniff")
        super().end_headers()

    def log_request(self, code="-", size="-"):
        if int(code) >= 400:  # a page's every file would be noise
            super().log_request(code, size)

    def log_error(self, format, *arguments):
        pass  # log_request has said it


class Server(ThreadingHTTPServer):
    daemon_threads = True

    def __init__(self, host: str, port: int, mounts=MOUNTS):
        if ":" in host:
            self.address_family = socket.AF_INET6
        self.mounts = mounts
        super().__init__((host, port), Handler)

    @property
    def url(self) -> str:
        host, port = self.server_address[:2]
        return f"http://{f'[{host}]' if ':' in host else host}:{port}/"

    def handle_error(self, request, client_address):
        # A browser that leaves in the middle of a file is no error.
        if not isinstance(sys.exc_info()[1], (ConnectionError, TimeoutError)):
            super().handle_error(request, client_address)


@contextmanager
def for_browser():
    """Serves the page as long as it is wanted; gives the environment in which scripts of node find it and Chromium."""
    server = Server("127.0.0.1", 0)
    threading.Thread(target=server.serve_forever, daemon=True).start()
    try:
        yield dict(os.environ, DIMLINE_URL=server.url, DIMLINE_CHROMIUM=shutil.which("chromium") or "chromium")
    finally:
        server.shutdown()
        server.server_close()


def bind(host: str, port, mounts=MOUNTS) -> Server:
    """A server on the wanted port, or, when none is wanted, on the first free one from DEFAULT_PORT on.

    Raises OSError when the wanted port, or every port tried, is taken.
    """
    if port is not None:
        return Server(host, port, mounts)
    for candidate in range(DEFAULT_PORT, DEFAULT_PORT + PORTS_TRIED):
        try:
            return Server(host, candidate, mounts)
        except OSError as error:
            if error.errno != errno.EADDRINUSE:
                raise
    return Server(host, 0, mounts)


def port_number(text: str) -> int:
    port = int(text)
    if not 1 <= port <= 65535:
        raise argparse.ArgumentTypeError(f"{port} is not between 1 and 65535")
    return port


def parse_arguments(arguments=None):
    parser = argparse.ArgumentParser(description="Build the WebAssembly core and serve the page on this machine.")
    parser.add_argument("--port", type=port_number,
                        help=f"the port to serve on (default: {DEFAULT_PORT}, or the next one that is free)")
    parser.add_argument("--open", action="store_true", help="open the page in the default browser")
    parser.add_argument("--no-build", action="store_true", help="serve what was built before; install and build nothing")
    parser.add_argument("--host", default="127.0.0.1",
                        help="the address to listen on (default: 127.0.0.1, this machine alone)")
    return parser.parse_args(arguments)


def main() -> int:
    options = parse_arguments()
    if not options.no_build and not build.core("serve"):
        return 1
    if not (ROOT / "build/wasm/dimline.wasm").exists():
        print("serve: there is no build/wasm/dimline.wasm. Start without --no-build once.", file=sys.stderr)
        return 1

    try:
        server = bind(options.host, options.port)
    except OSError as error:
        if error.errno == errno.EADDRINUSE:
            reason = f"port {options.port} is taken. Choose another, or leave --port out and a free one is found."
        else:
            reason = f"cannot listen on {options.host}: {error.strerror or error}"
        print(f"serve: {reason}", file=sys.stderr)
        return 1
    with server:
        port = server.server_address[1]
        if options.port is None and port != DEFAULT_PORT:
            print(f"Port {DEFAULT_PORT} is taken; this is port {port}.")
        if options.host not in ("127.0.0.1", "localhost", "::1"):
            print("Everybody who reaches this machine over the network can open the page.")
        print(f"Dimline is at {server.url}  (Ctrl+C stops it)", flush=True)
        if options.open:
            webbrowser.open(server.url)
        try:
            server.serve_forever()
        except KeyboardInterrupt:
            print()
    return 0


if __name__ == "__main__":
    sys.exit(main())

import http.client
import os
import socket
import subprocess
import sys
import tempfile
import threading
import unittest
from pathlib import Path
from unittest import mock

from tools_path import ROOT

import serve


class Served(unittest.TestCase):
    """A server over temporary folders, asked over a real connection."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = Path(temporary.name)
        for path, text in {
            "web/index.html": "<!doctype html>", "web/page.mjs": "export {}", "web/style.css": "a{}",
            "web/docs/index.html": "docs", "web/.hidden": "secret", "web/font.woff2": "f", "web/name with space.txt": "n",
            "wasm/dimline.js": "export {}", "wasm/dimline.wasm": "\0asm", "wasm/CMakeCache.txt": "secret",
            "assets/house.glb": "glTF", "assets/house.gltf": "{}", "assets/thumbs/house.png": "p", "assets/i.svg": "<svg/>",
            "assets/list.json": "[]", "secret.txt": "secret",
        }.items():
            file = self.root / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
        mounts = (serve.Mount("/build/", self.root / "wasm", (".js", ".wasm")),
                  serve.Mount("/assets/", self.root / "assets"), serve.Mount("/", self.root / "web"))
        self.server = serve.Server("127.0.0.1", 0, mounts)
        quiet = mock.patch.object(serve.Handler, "log_request")
        quiet.start()
        self.addCleanup(quiet.stop)
        threading.Thread(target=self.server.serve_forever, kwargs={"poll_interval": 0.01}, daemon=True).start()
        self.addCleanup(self.server.server_close)
        self.addCleanup(self.server.shutdown)

    def ask(self, path, method="GET", headers=None):
        connection = http.client.HTTPConnection("127.0.0.1", self.server.server_address[1], timeout=10)
        self.addCleanup(connection.close)
        connection.request(method, path, headers=headers or {})
        response = connection.getresponse()
        return response.status, response.headers, response.read()

    def test_types(self):
        for path, expected in {
            "/": "text/html; charset=utf-8", "/page.mjs": "text/javascript; charset=utf-8",
            "/style.css": "text/css; charset=utf-8", "/font.woff2": "font/woff2",
            "/build/dimline.js": "text/javascript; charset=utf-8", "/build/dimline.wasm": "application/wasm",
            "/assets/house.glb": "model/gltf-binary", "/assets/house.gltf": "model/gltf+json",
            "/assets/thumbs/house.png": "image/png", "/assets/i.svg": "image/svg+xml",
            "/assets/list.json": "application/json; charset=utf-8",
        }.items():
            status, headers, _ = self.ask(path)
            self.assertEqual((path, status, headers["Content-Type"]), (path, 200, expected))

    def test_policy_stands_on_every_answer(self):
        for path in ("/", "/build/dimline.js", "/nothing", "/docs"):
            _, headers, _ = self.ask(path)
            policy = headers["Content-Security-Policy"]
            self.assertIn("default-src 'none'", policy)
            self.assertIn("script-src 'self' 'wasm-unsafe-eval';", policy)
            self.assertNotIn("unsafe-inline", policy)
            self.assertEqual(headers["X-Content-Type-Options"], "nosniff")

    def test_a_changed_file_is_sent_anew_and_an_unchanged_one_is_not(self):
        status, headers, body = self.ask("/build/dimline.wasm")
        self.assertEqual((status, body, headers["Cache-Control"]), (200, b"\0asm", "no-cache"))
        again = {"If-None-Match": headers["ETag"]}
        status, headers, body = self.ask("/build/dimline.wasm", headers=again)
        self.assertEqual((status, body), (304, b""))
        self.assertIn("default-src", headers["Content-Security-Policy"])
        (self.root / "wasm/dimline.wasm").write_text("\0asm2")
        status, _, body = self.ask("/build/dimline.wasm", headers=again)
        self.assertEqual((status, body), (200, b"\0asm2"))

    def test_head_sends_the_length_and_no_body(self):
        status, headers, body = self.ask("/style.css", method="HEAD")
        self.assertEqual((status, headers["Content-Length"], body), (200, "3", b""))

    def test_other_methods_are_refused(self):
        self.assertEqual(self.ask("/", method="POST")[0], 501)

    def test_nothing_outside_the_folders(self):
        for path in ("/../secret.txt", "/%2e%2e/secret.txt", "/assets/../secret.txt", "/assets/..%2f..%2fsecret.txt",
                     "/..%5csecret.txt", "//secret.txt", "/assets//house.glb", "/.hidden", "/%2ehidden",
                     "/style.css%00.html", "/build/CMakeCache.txt", "/build/", "/assets/", "/web/index.html",
                     str(self.root / "secret.txt")):
            status, _, body = self.ask(path)
            self.assertEqual((path, status), (path, 404))
            self.assertNotIn(b"secret", body)

    def test_links_that_leave_the_folder(self):
        os.symlink(self.root / "secret.txt", self.root / "web/link.txt")
        self.assertEqual(self.ask("/link.txt")[0], 404)

    def test_query_and_percent_encoding(self):
        self.assertEqual(self.ask("/style.css?v=1")[0], 200)
        self.assertEqual(self.ask("/name%20with%20space.txt")[2], b"n")

    def test_folders(self):
        status, headers, _ = self.ask("/docs")
        self.assertEqual((status, headers["Location"]), (301, "/docs/"))
        self.assertEqual(self.ask("/docs/")[2], b"docs")

    def test_url(self):
        self.assertEqual(self.server.url, f"http://127.0.0.1:{self.server.server_address[1]}/")


class Ports(unittest.TestCase):
    def occupy(self, port=0):
        taken = socket.socket()
        self.addCleanup(taken.close)
        taken.bind(("127.0.0.1", port))
        taken.listen()
        return taken.getsockname()[1]

    def test_a_wanted_port_that_is_taken_is_an_error(self):
        with self.assertRaises(OSError):
            serve.bind("127.0.0.1", self.occupy())

    def test_without_a_wish_the_next_free_port_is_taken(self):
        taken = self.occupy()
        default, serve.DEFAULT_PORT = serve.DEFAULT_PORT, taken
        self.addCleanup(setattr, serve, "DEFAULT_PORT", default)
        with serve.bind("127.0.0.1", None) as server:
            self.assertNotEqual(server.server_address[1], taken)

    def test_the_program_says_that_the_port_is_taken(self):
        port = self.occupy()
        wasm = ROOT / "build/wasm/dimline.wasm"
        run = subprocess.run([sys.executable, str(ROOT / "tools/serve.py"), "--no-build", "--port", str(port)],
                             capture_output=True, text=True, timeout=30)
        self.assertEqual(run.returncode, 1)
        self.assertIn(f"port {port} is taken" if wasm.exists() else "Start without --no-build", run.stderr)

    def test_bad_ports(self):
        for text in ("0", "65536", "-1", "http"):
            run = subprocess.run([sys.executable, str(ROOT / "tools/serve.py"), f"--port={text}"],
                                 capture_output=True, text=True, timeout=30)
            self.assertEqual(run.returncode, 2, text)


if __name__ == "__main__":
    unittest.main()

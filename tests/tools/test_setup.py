import json
import tempfile
import unittest
from pathlib import Path
from unittest import mock

from tools_path import ROOT

import setup


class Versions(unittest.TestCase):
    def test_version_of(self):
        self.assertEqual(setup.version_of("v18.20.4\n"), (18, 20, 4))
        self.assertEqual(setup.version_of('"3.1.69"'), (3, 1, 69))
        self.assertEqual(setup.version_of("none"), ())

    def test_cmake_and_setup_agree_on_emscripten(self):
        toolchain = (ROOT / "cmake/wasm_toolchain.cmake").read_text()
        self.assertIn(f"set(DIMLINE_EMSCRIPTEN_MINIMUM {'.'.join(map(str, setup.EMSCRIPTEN_MINIMUM))})", toolchain)
        self.assertIn(f"/dimline/emscripten-{setup.EMSCRIPTEN_VERSION}", toolchain)

    def emscripten(self, version):
        """What emscripten_on_path finds when the em++ on PATH is of this version."""
        with tempfile.TemporaryDirectory() as folder:
            program = Path(folder).resolve() / "em++"
            program.write_text("")
            (program.parent / "emscripten-version.txt").write_text(f'"{version}"\n')
            with mock.patch.object(setup.shutil, "which", return_value=str(program)):
                return setup.emscripten_on_path() == program.parent

    def test_an_old_emscripten_on_path_is_not_taken(self):
        self.assertFalse(self.emscripten("3.1.6"))
        self.assertFalse(self.emscripten("3.1.49"))
        self.assertTrue(self.emscripten("3.1.50"))
        self.assertTrue(self.emscripten("4.0.1"))


class Packages(unittest.TestCase):
    missing = (setup.Package("one", command="no-such-program-1"), setup.Package("two", header="no/such/header.h"),
               setup.Package("three", library="dri/no_such.so"), setup.Package("four", file="/no/such/file"),
               setup.Package("five", command="python3"))

    def test_present(self):
        self.assertEqual([package.present() for package in self.missing], [False, False, False, False, True])

    def install(self, programs, user):
        """The error when the missing packages meet a machine with these programs and this user."""
        with mock.patch.object(setup.shutil, "which", side_effect=lambda name: name if name in programs else None), \
                mock.patch.object(setup.os, "geteuid", return_value=user), \
                mock.patch.object(setup.subprocess, "run", side_effect=AssertionError("nothing may be started")):
            with self.assertRaises(setup.SetupError) as caught:
                setup.install_packages(self.missing)
        return str(caught.exception)

    def test_without_apt_it_names_the_packages(self):
        text = self.install({"python3"}, user=0)
        self.assertIn("no apt-get", text)
        self.assertIn("one two three four", text)
        self.assertNotIn("five", text)

    def test_without_root_and_sudo_it_names_the_command(self):
        self.assertIn("apt-get install --no-install-recommends one two three four",
                      self.install({"python3", "apt-get"}, user=1000))

    def test_nothing_is_started_when_nothing_is_missing(self):
        with mock.patch.object(setup.subprocess, "run", side_effect=AssertionError("nothing may be started")):
            setup.install_packages((setup.Package("five", command="python3"),))

    def test_llvm_is_needed_only_for_our_own_emscripten(self):
        with mock.patch.object(setup, "has_emscripten", return_value=True):
            self.assertNotIn("clang-19", [package.name for package in setup.needed_packages("build")])
        with mock.patch.object(setup, "has_emscripten", return_value=False):
            self.assertIn("clang-19", [package.name for package in setup.needed_packages("build")])

    def test_serving_needs_no_browser(self):
        self.assertNotIn("chromium", [package.name for package in setup.needed_packages("build")])
        self.assertIn("chromium", [package.name for package in setup.needed_packages("test")])


class LockFiles(unittest.TestCase):
    def test_locks_name_no_registry_and_hold_a_checksum_for_each_package(self):
        for folder in ("tests/browser", "tools/node"):
            lock = json.loads((ROOT / folder / "package-lock.json").read_text())
            for name, package in lock["packages"].items():
                self.assertNotIn("resolved", package, f"{folder}: {name}")
                if name:
                    self.assertTrue(package["integrity"].startswith("sha512-"), f"{folder}: {name}")

    def test_playwright_is_pinned(self):
        package = json.loads((ROOT / "tests/browser/package.json").read_text())
        self.assertEqual(package["dependencies"]["playwright-core"], "1.64.1")


if __name__ == "__main__":
    unittest.main()

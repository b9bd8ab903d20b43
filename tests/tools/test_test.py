import json
import os
import re
import subprocess
import sys
import tempfile
import threading
import time
import unittest
from pathlib import Path
from unittest import mock

from tools_path import ROOT

import build
import test


def ends_within(pid, seconds) -> bool:
    """Whether a process has ended, waited for that long: a killed one closes its files a moment before it counts as ended."""
    until = time.monotonic() + seconds
    while time.monotonic() < until:
        try:
            if Path(f"/proc/{pid}/stat").read_text().split()[2] in "ZX":
                return True
        except (FileNotFoundError, ProcessLookupError):
            return True
        time.sleep(0.02)
    return False


class NativeCounts(unittest.TestCase):
    def count(self, log, status=0):
        result = test.count_cases("test_math", log, status, "")
        return result.passed, result.failed, result.output

    def test_all_pass(self):
        self.assertEqual(self.count("begin a\npass\nbegin b\npass\n")[:2], (2, 0))

    def test_one_fails(self):
        self.assertEqual(self.count("begin a\nfail\nbegin b\npass\n", status=1)[:2], (1, 1))

    def test_the_summary_names_what_failed(self):
        log = "".join(f"begin {name}\nfail\n" for name in "abcdefg") + "begin h\n"
        result = test.count_cases("test_math", log, -11, "")
        self.assertEqual(test.summary("native", result),
                         ["FAILED in native: test_math (8)", *(f"    {name}" for name in "abcde"), "    and 3 more"])

    def test_no_case_is_a_failure(self):
        passed, failed, output = self.count("")
        self.assertEqual((passed, failed), (0, 1))
        self.assertIn("no test", output)

    def test_a_crash_names_its_case(self):
        passed, failed, output = self.count("begin a\npass\nbegin the tree\n", status=-11)
        self.assertEqual((passed, failed), (1, 1))
        self.assertIn('"the tree"', output)

    def test_a_leak_at_the_end_is_a_failure(self):
        self.assertEqual(self.count("begin a\npass\n", status=23)[:2], (1, 1))


class ScriptCounts(unittest.TestCase):
    def count(self, entries, status=0):
        result = test.count_tests("node/a.test.mjs", "".join(json.dumps(entry) + "\n" for entry in entries), status, "")
        return result.passed, result.failed

    def test_counts(self):
        entry = {"name": "x", "passed": True, "left": False}
        self.assertEqual(self.count([entry, entry]), (2, 0))
        self.assertEqual(self.count([entry, dict(entry, passed=False, why="1 is not 2")], status=1), (1, 1))

    def test_a_skipped_test_is_a_failure(self):
        self.assertEqual(self.count([{"name": "x", "passed": True, "left": True}]), (0, 1))

    def test_a_file_without_tests_is_a_failure(self):
        self.assertEqual(self.count([{"name": "/some/where/a.test.mjs", "passed": True, "left": False}]), (0, 1))

    def test_a_file_that_does_not_load_is_one_failure(self):
        self.assertEqual(self.count([{"name": "/some/where/a.test.mjs", "passed": False, "left": False, "why": "x"}], status=1), (0, 1))


class RealNode(unittest.TestCase):
    """The reporter against node itself."""

    def run_text(self, text):
        with tempfile.TemporaryDirectory() as folder:
            file = Path(folder) / "x.test.mjs"
            file.write_text("import { test, describe, it } from 'node:test';\n" + text)
            self.result = test.run_script(file, dict(os.environ))
        return self.result.passed, self.result.failed

    def test_tests_and_suites(self):
        self.assertEqual(self.run_text("test('a', () => {}); describe('s', () => { it('b', () => {}); });"), (2, 0))

    def test_failures(self):
        self.assertEqual(self.run_text("describe('s', () => { it('b', () => { throw new Error('x'); }); it('c', () => {}); });"),
                         (1, 1))
        self.assertEqual(self.result.failures, ["b: x"])

    def test_what_failed_is_told_in_one_line(self):
        self.run_text("test('a', () => { throw new Error('too few\\nlines'); });")
        self.assertEqual(test.summary("browser", self.result), [f"FAILED in browser: {self.result.name} (1)", "    a: too few lines"])

    def test_skipped(self):
        self.assertEqual(self.run_text("test('a', () => {}); test('b', { skip: true }, () => {});"), (1, 1))

    def test_skipped_suite(self):
        self.assertEqual(self.run_text("test('a', () => {}); describe('s', { skip: true }, () => { it('b', () => {}); });"), (1, 1))

    def test_empty_file(self):
        self.assertEqual(self.run_text(""), (0, 1))

    def test_error_while_loading(self):
        self.assertEqual(self.run_text("throw new Error('x');"), (0, 1))


class Runs(unittest.TestCase):
    def test_a_run_past_its_time_is_stopped_with_all_its_children(self):
        with tempfile.TemporaryDirectory() as folder:
            mark = Path(folder) / "pid"
            # A shell, since it has its child within milliseconds, however busy the machine.
            script = f"sleep 600 > /dev/null 2>&1 & echo $! > '{mark}'; wait"
            status, output = test.run_limited(["sh", "-c", script], 3, dict(os.environ))
            child = int(mark.read_text())
        self.assertNotEqual(status, 0)
        self.assertIn("stopped after", output)
        self.assertTrue(ends_within(child, 10), "the child outlived the run that was stopped")

    def test_a_part_that_cannot_run_is_a_failure(self):
        def broken(match):
            raise build.BuildError("error: no such thing")
            yield

        def breaks_midway(match):
            yield test.Result("first", passed=3)
            raise RuntimeError("boom")

        with mock.patch("builtins.print"):
            self.assertEqual(test.totals(test.run_part("native", broken, "")), (0, 1))
            self.assertEqual(test.totals(test.run_part("native", breaks_midway, "")), (3, 1))
            self.assertEqual(test.totals(test.run_part("native", lambda match: iter(()), "")), (0, 1))

    def test_builds_follow_each_other_and_are_waited_for(self):
        def slow_build(preset, **options):
            time.sleep(0.2)
            built.append((preset, options))

        built = []
        with mock.patch.object(build, "build", slow_build):
            test.begin_builds(["native", "asan"])
            self.assertEqual(built, [])
            test.wait_for_build("native")
            self.assertEqual(built, [("native", {"targets": (), "keep_going": True, "background": False})])
            test.wait_for_build("asan")
            test.wait_for_build("asan")
        self.assertEqual(built[1:], [("asan", {"targets": (), "keep_going": True, "background": True})])

    def test_a_build_that_fails_does_so_where_it_is_waited_for_and_holds_up_no_other(self):
        def some_fail(preset, **options):
            if preset == "native":
                raise build.BuildError("error: no such thing")

        with mock.patch.object(build, "build", some_fail):
            test.begin_builds(["native", "asan"])
            for _ in range(2):
                with self.assertRaises(build.BuildError):
                    test.wait_for_build("native")
            test.wait_for_build("asan")

    def test_every_part_but_the_quick_ones_names_its_build(self):
        self.assertEqual(set(test.PARTS) - set(test.PRESETS), {"includes", "tools"})
        needed = dict.fromkeys(preset for name in test.PARTS for preset in test.PRESETS.get(name, ()))
        self.assertEqual(list(needed), ["native", "wasm", "asan"])
        self.assertEqual(set(test.TARGETS) - set(needed), set())

    def test_the_longest_begin_first(self):
        self.assertEqual(test.longest_first(["a", "test_app", "b", "test_cli"]), ["test_cli", "test_app", "a", "b"])
        there = {f"test_{folder}" for folder in test.test_folders("")} | {file.name for file in (ROOT / "tests/browser").glob("*.mjs")}
        self.assertEqual(set(test.LONGEST) - there, set())

    def test_files_run_beside_each_other_and_are_told_in_order(self):
        both_run = threading.Barrier(2, timeout=30)

        def run(file, environment):
            both_run.wait()
            return test.Result(file.name, passed=1)

        with tempfile.TemporaryDirectory() as folder, mock.patch.object(test, "ROOT", Path(folder)), \
                mock.patch.object(test, "run_script", run):
            for name in ("a", "b", "c", "d"):
                file = Path(folder) / f"tests/node/{name}.test.mjs"
                file.parent.mkdir(parents=True, exist_ok=True)
                file.touch()
            names = [result.name for result in test.script_part("node", "", {})]
        self.assertEqual(names, [f"{name}.test.mjs" for name in ("a", "b", "c", "d")])

    def test_description_shows_the_output_of_a_failure_alone(self):
        self.assertNotIn("noise", test.describe(test.Result("a", passed=1, output="noise")))
        self.assertIn("    | reason", test.describe(test.failure("a", "reason")))

    def test_of_a_long_output_the_ends_are_shown(self):
        text = test.describe(test.failure("a", "\n".join(f"line {i}" for i in range(1, 1001))))
        self.assertIn("| line 1\n", text)
        self.assertTrue(text.endswith("| line 1000"))
        self.assertIn("(880 lines left out)", text)
        self.assertEqual(len(text.splitlines()), 1 + 60 + 1 + 60)

    def test_last_line_and_exit_status(self):
        run = subprocess.run([sys.executable, str(ROOT / "tools/test.py"), "--only", "node", "-k", "no such test"],
                             capture_output=True, text=True, timeout=300,
                             env=dict(os.environ, PATH=self.path_without_builds()))
        self.assertRegex(run.stdout.strip().splitlines()[-1], re.compile(r"^\d+ passed, [1-9]\d* failed$"))
        self.assertEqual(run.returncode, 1)

    def path_without_builds(self):
        """A PATH whose cmake does nothing, so that the run within the run builds nothing."""
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        cmake = Path(temporary.name) / "cmake"
        cmake.write_text("#!/bin/sh\nexit 0\n")
        cmake.chmod(0o755)
        return f"{temporary.name}:{os.environ['PATH']}"


if __name__ == "__main__":
    unittest.main()

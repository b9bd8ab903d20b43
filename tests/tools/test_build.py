import io
import sys
import unittest

from tools_path import ROOT  # noqa: F401

import build


class Stream(unittest.TestCase):
    def run_script(self, script):
        build.stream_build([sys.executable, "-c", script], "native")

    def test_success_is_quiet(self):
        self.run_script("print('[1/2] Building a'); print('[2/2] Linking')")

    def test_failure_gives_the_compilers_words_without_the_steps(self):
        with self.assertRaises(build.BuildError) as caught:
            self.run_script("import sys; print('[1/2] Building a'); print('a.cpp:1: error: x'); sys.exit(1)")
        self.assertEqual(str(caught.exception), "a.cpp:1: error: x")

    def test_a_build_in_the_background_stands_back(self):
        with self.assertRaises(build.BuildError) as caught:
            build.stream_build([sys.executable, "-c", "import os, sys; print(os.nice(0)); sys.exit(1)"], "asan", background=True)
        self.assertEqual(str(caught.exception), "19")

    def test_an_unknown_preset_is_a_build_error(self):
        with self.assertRaises(build.BuildError):
            build.build("no-such-preset")


class ProgressLines(unittest.TestCase):
    def test_now_and_then_a_line_where_there_is_no_terminal(self):
        stream = io.StringIO()
        progress = build.Progress("wasm", stream)
        progress.step(1, 9)
        self.assertEqual(stream.getvalue(), "")
        progress.last -= build.SECONDS_BETWEEN_LINES
        progress.step(2, 9)
        progress.step(3, 9)
        progress.close()
        self.assertEqual(stream.getvalue(), "  building wasm: 2 of 9\n")

    def test_a_build_in_the_background_says_nothing(self):
        stream = io.StringIO()
        progress = build.Progress("asan", stream, quiet=True)
        progress.last -= build.SECONDS_BETWEEN_LINES
        progress.step(2, 9)
        progress.close()
        self.assertEqual(stream.getvalue(), "")


if __name__ == "__main__":
    unittest.main()

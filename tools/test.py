#!/usr/bin/env python3
"""Runs everything that shows that Dimline works, and ends with one line: N passed, N failed.

    python3 tools/test.py                       all parts
    python3 tools/test.py --only native node    some parts
    python3 tools/test.py --only browser -k drag    only files or executables with "drag" in their name

Installs what is missing first (tools/setup.py). A part that cannot run is a failure, never a skip; so is a test
executable or file without a single test. tests/README.md says how a test of each kind looks.
"""

import argparse
import io
import json
import os
import signal
import subprocess
import sys
import tempfile
import threading
import time
import traceback
import unittest
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, field
from pathlib import Path

import build
import check_includes
import serve
import setup

ROOT = Path(__file__).resolve().parent.parent
# Software GL drivers keep memory to the end of the process, which the leak checker would report as ours.
GL_FOLDERS = ("gpu", "render")
EXECUTABLE_LIMIT_S = 900
SCRIPT_LIMIT_S = 600
SCRIPTS_AT_ONCE = 2  # a page waits for frames half of its time; more at once would wait for each other
HEAD_LINES, TAIL_LINES = 60, 60  # of a failure's output that are shown
SUMMARY_LINES = 5  # tests of one file that the summary names


@dataclass
class Result:
    """What one executable, one file or one check gave."""

    name: str
    passed: int = 0
    failed: int = 0
    output: str = ""
    seconds: float = 0.0
    failures: list = field(default_factory=list)  # the tests that failed, by name, and of what where that is known


def describe(result: Result) -> str:
    """The lines that are printed for a result: one when all is well, and the output beneath when not."""
    text = f"  {result.name:<34} {result.passed:>4} passed"
    if result.failed:
        text += f", {result.failed} FAILED"
    text += f"  {result.seconds:.1f} s"
    if result.failed:
        lines = result.output.strip().splitlines()
        left_out = len(lines) - HEAD_LINES - TAIL_LINES
        if left_out > 0:
            lines[HEAD_LINES:-TAIL_LINES] = [f"({left_out} lines left out)"]
        text += "".join("\n    | " + line for line in lines)
    return text


def summary(part: str, result: Result) -> list:
    """What the last lines of a run say of a failure, for whoever sees no more than those."""
    shown = result.failures[:SUMMARY_LINES]
    if len(result.failures) > len(shown):
        shown.append(f"and {len(result.failures) - len(shown)} more")
    return [f"FAILED in {part}: {result.name} ({result.failed})", *(f"    {line}" for line in shown)]


def failure(name: str, reason: str) -> Result:
    return Result(name, failed=1, output=reason)


def run_limited(command, limit_s: float, environment: dict) -> tuple:
    """Runs a command in a process group of its own: (exit status, output). The group is killed when its time is up."""
    process = subprocess.Popen(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               stdin=subprocess.DEVNULL, text=True, errors="replace", start_new_session=True)
    try:
        output, _ = process.communicate(timeout=limit_s)
        return process.returncode, output
    except subprocess.TimeoutExpired:
        os.killpg(process.pid, signal.SIGKILL)
        output, _ = process.communicate()
        return -signal.SIGKILL, f"{output}\nstopped after {limit_s:.0f} s"
    except BaseException:
        os.killpg(process.pid, signal.SIGKILL)
        raise


def settle(result: Result, status: int) -> Result:
    """A run that ended badly without a failed test, or without any test, has failed all the same."""
    if status != 0 and result.failed == 0:
        result.failed = 1
        result.output += f"\nexit status {status}, though no test failed"
    elif result.passed + result.failed == 0:
        result.failed = 1
        result.output += "\nthere is no test in it"
    return result


# Builds. Those that later parts need follow the first one at once and take what the parts before leave idle: the last of a part's tests
# runs alone, and a page waits for its next frame now and then.

# What tests need besides the usual: no page asks for the program for node.
TARGETS = {"wasm": ("all", "dimline_node")}

builds = {}  # preset -> Future of its build


def begin_builds(presets) -> None:
    """Builds the presets one after the other, the first as fast as can be, the others behind whatever else runs."""
    begun = {preset: Future() for preset in presets}

    def work():
        for number, (preset, done) in enumerate(begun.items()):
            try:
                done.set_result(build.build(preset, targets=TARGETS.get(preset, ()), keep_going=True, background=number > 0))
            except Exception as error:
                done.set_exception(error)

    builds.update(begun)
    threading.Thread(target=work, daemon=True).start()


def wait_for_build(preset: str) -> None:
    """Raises BuildError."""
    builds[preset].result()


# What takes longest begins first, so that nothing waits for it alone at the end; the rest in the order of their names.
LONGEST = ("test_cli", "test_app", "test_models", "test_silhouette", "test_render",
           "gesture.test.mjs", "panel.test.mjs", "keyboard.test.mjs", "drag.test.mjs", "fields.test.mjs", "follow.test.mjs", "models.test.mjs",
           "robust.test.mjs", "every_model.test.mjs")


def longest_first(names) -> list:
    return sorted(names, key=lambda name: (LONGEST.index(name) if name in LONGEST else len(LONGEST), name))


# Native executables (Catch2)


def count_cases(name: str, log: str, status: int, output: str) -> Result:
    """Counts a case log (tests/support/catch_main.cpp); a case that began and never ended is the one that crashed."""
    result, running = Result(name, output=output), None
    for line in log.splitlines():
        kind, _, rest = line.partition(" ")
        if kind == "begin":
            running = rest
        elif kind == "pass":
            result.passed, running = result.passed + 1, None
        elif kind == "fail":
            result.failures.append(running)
            result.failed, running = result.failed + 1, None
    if running is not None:
        result.failures.append(f"{running}: it crashed")
        result.failed += 1
        result.output += f'\ncrashed in the case "{running}" (exit status {status})'
    return settle(result, status)


def test_folders(match: str) -> list:
    """The folders of tests/ that have an executable."""
    names = longest_first({f"test_{file.parent.name}" for file in (ROOT / "tests").glob("*/*_test.cpp")})
    return [name.removeprefix("test_") for name in names if match in name]


def run_executable(preset: str, folder: str) -> Result:
    start = time.monotonic()
    program = ROOT / "build" / preset / "tests" / f"test_{folder}"
    environment = dict(os.environ, UBSAN_OPTIONS="print_stacktrace=1")
    if preset == "asan" and folder in GL_FOLDERS:
        environment["ASAN_OPTIONS"] = "detect_leaks=0"
    with tempfile.TemporaryDirectory() as temporary:
        log = Path(temporary) / "cases"
        environment["DIMLINE_CASE_LOG"] = str(log)
        # A case or section that asserts nothing cannot fail, so it is a failure.
        status, output = run_limited([str(program), "--warn", "NoAssertions"], EXECUTABLE_LIMIT_S, environment)
        result = count_cases(program.name, log.read_text() if log.exists() else "", status, output)
    result.seconds = time.monotonic() - start
    return result


def native_part(preset: str, match: str):
    wait_for_build(preset)
    folders = test_folders(match)
    if not folders:
        yield failure(preset, "there are no test executables to run")
    with ThreadPoolExecutor(max_workers=os.cpu_count() or 1) as pool:
        yield from pool.map(lambda folder: run_executable(preset, folder), folders)


# JavaScript (node --test)


def count_tests(name: str, log: str, status: int, output: str) -> Result:
    """Counts a log of tools/node_reporter.mjs. A test that is skipped or left to do has not passed."""
    result = Result(name, output=output)
    for line in log.splitlines():
        entry = json.loads(line)
        if entry["passed"] and Path(entry["name"]).name == Path(name).name:
            continue  # node's stand-in for a file without tests
        if entry["left"]:
            result.failed += 1
            result.failures.append(f'{entry["name"]}: not run')
            result.output += f'\nnot run: "{entry["name"]}"'
        elif entry["passed"]:
            result.passed += 1
        else:
            result.failed += 1
            result.failures.append(f'{entry["name"]}: {entry["why"]}')
    return settle(result, status)


def run_script(file: Path, environment: dict) -> Result:
    start = time.monotonic()
    with tempfile.TemporaryDirectory() as temporary:
        log = Path(temporary) / "tests"
        command = [setup.node(), "--test",
                   "--test-reporter=spec", "--test-reporter-destination=stdout",
                   f"--test-reporter={(ROOT / 'tools/node_reporter.mjs').as_uri()}", f"--test-reporter-destination={log}",
                   str(file)]
        status, output = run_limited(command, SCRIPT_LIMIT_S, environment)
        result = count_tests(f"{file.parent.name}/{file.name}", log.read_text() if log.exists() else "", status, output)
    result.seconds = time.monotonic() - start
    return result


def script_part(folder: str, match: str, environment: dict):
    names = longest_first(file.name for file in (ROOT / "tests" / folder).glob("*.test.mjs"))
    files = [ROOT / "tests" / folder / name for name in names if match in name]
    if not files:
        yield failure(folder, f"there are no tests/{folder}/*.test.mjs to run")
    with ThreadPoolExecutor(max_workers=SCRIPTS_AT_ONCE) as pool:
        yield from pool.map(lambda file: run_script(file, environment), files)


def node_part(match: str):
    for preset in PRESETS["node"]:
        wait_for_build(preset)
    yield from script_part("node", match, dict(os.environ))


def browser_part(match: str):
    wait_for_build("wasm")
    artifacts = ROOT / "build/test-artifacts"
    artifacts.mkdir(parents=True, exist_ok=True)
    with serve.for_browser() as environment:
        yield from script_part("browser", match, environment | {"DIMLINE_ARTIFACTS": str(artifacts)})


# The rest


def includes_part(match: str):
    problems = check_includes.check(ROOT)
    yield Result("check_includes", passed=0 if problems else 1, failed=1 if problems else 0, output="\n".join(problems))


def tools_part(match: str):
    for file in sorted((ROOT / "tests/tools").glob("test_*.py")):
        if match not in file.name:
            continue
        start, stream = time.monotonic(), io.StringIO()
        suite = unittest.TestLoader().discover(str(file.parent), pattern=file.name)
        outcome = unittest.TextTestRunner(stream=stream, verbosity=1).run(suite)
        failures = [case.id() for case, _ in outcome.failures + outcome.errors + outcome.skipped]
        failures += [case.id() for case in outcome.unexpectedSuccesses]
        result = Result(file.name, passed=max(0, outcome.testsRun - len(failures)), failed=len(failures), output=stream.getvalue(),
                        failures=failures)
        result.seconds = time.monotonic() - start
        yield settle(result, 0)


def wasm_part(match: str):
    start = time.monotonic()
    wait_for_build("wasm")
    missing = [name for name in ("dimline.js", "dimline.wasm", "dimline_gltf.js", "dimline_gltf.wasm", "dimline_node.cjs") if not (ROOT / "build/wasm" / name).exists()]
    result = Result("build", passed=0 if missing else 1)
    if missing:
        result = failure("build", f"the build made no {' and no '.join(missing)}")
    result.seconds = time.monotonic() - start
    yield result


# The order in which they run: what is quick and what fails early first. PRESETS: the builds that a part needs.
PARTS = {
    "includes": includes_part,
    "tools": tools_part,
    "native": lambda match: native_part("native", match),
    "wasm": wasm_part,
    "node": node_part,
    "browser": browser_part,
    "asan": lambda match: native_part("asan", match),
}
PRESETS = {"native": ("native",), "wasm": ("wasm",), "node": ("native", "wasm"), "browser": ("wasm",), "asan": ("asan",)}


def run_part(name: str, part, match: str) -> list:
    """Runs a part and prints what it gives as it comes. Whatever stops it is a failure of its own."""
    print(f"== {name}", flush=True)
    start, results = time.monotonic(), []

    def take(result: Result) -> None:
        results.append(result)
        print(describe(result), flush=True)

    try:
        for result in part(match):
            take(result)
    except build.BuildError as error:
        take(failure("build", str(error)))
    except Exception:
        take(failure(name, traceback.format_exc()))
    if not results:
        take(failure(name, "nothing was run"))
    passed, failed = totals(results)
    print(f"   {name}: {passed} passed, {failed} failed, {time.monotonic() - start:.1f} s\n", flush=True)
    return results


def totals(results) -> tuple:
    return sum(result.passed for result in results), sum(result.failed for result in results)


def parse_arguments(arguments=None):
    parser = argparse.ArgumentParser(description="Run everything that shows that Dimline works.")
    parser.add_argument("--only", nargs="+", choices=tuple(PARTS), metavar="PART", default=list(PARTS),
                        help=f"the parts to run: {', '.join(PARTS)}")
    parser.add_argument("-k", dest="match", default="", metavar="TEXT",
                        help="only the test files or executables that have TEXT in their name")
    return parser.parse_args(arguments)


def main() -> int:
    options = parse_arguments()
    start, results = time.monotonic(), []
    try:
        setup.install("test")
        print(f"== setup\n   everything is there, {time.monotonic() - start:.1f} s\n", flush=True)
    except setup.SetupError as error:
        results.append(failure("setup", str(error)))
        print(f"== setup\n{describe(results[-1])}\n", flush=True)

    failures = []
    begin_builds(dict.fromkeys(preset for name in PARTS if name in options.only for preset in PRESETS.get(name, ())))
    for name, part in PARTS.items():
        if name in options.only:
            of_part = run_part(name, part, options.match)
            failures += [line for result in of_part if result.failed for line in summary(name, result)]
            results += of_part

    print(f"in {time.monotonic() - start:.0f} s", *failures, sep="\n")
    passed, failed = totals(results)
    print(f"{passed} passed, {failed} failed", flush=True)
    return 1 if failed or not passed else 0


if __name__ == "__main__":
    sys.exit(main())

"""Builds one of the presets of CMakePresets.json, quietly: progress while it runs, the compiler's output when it fails."""

import os
import re
import subprocess
import sys
import time
from pathlib import Path

import setup

ROOT = Path(__file__).resolve().parent.parent
STEP = re.compile(r"^\[(\d+)/(\d+)\] ")
SECONDS_BETWEEN_LINES = 15  # of progress, where there is no terminal to redraw a line on


class BuildError(Exception):
    """The build failed; the text is what CMake or the compiler said."""


class Progress:
    """The steps of a build: one line that is redrawn on a terminal, now and then a line of its own elsewhere; or nothing."""

    def __init__(self, name: str, stream=sys.stdout, quiet: bool = False):
        self.name, self.stream, self.quiet = name, stream, quiet
        self.terminal = stream.isatty()
        self.last = time.monotonic()
        self.shown = False

    def step(self, done: int, total: int) -> None:
        now = time.monotonic()
        if self.quiet:
            return
        if self.terminal:
            print(f"\r  building {self.name}: {done} of {total}", end="", file=self.stream, flush=True)
            self.shown = True
        elif now - self.last >= SECONDS_BETWEEN_LINES:
            print(f"  building {self.name}: {done} of {total}", file=self.stream, flush=True)
            self.last = now

    def close(self) -> None:
        if self.shown:
            print("\r\033[K", end="", file=self.stream, flush=True)


def stream_build(command, name: str, background: bool = False) -> None:
    """Runs a build command and follows its steps; raises BuildError with what it wrote beside them."""
    environment = dict(os.environ, NINJA_STATUS="[%f/%t] ")
    if background:
        command = ["nice", "-n", "19", *command]
    process = subprocess.Popen(command, cwd=ROOT, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                               text=True, errors="replace")
    progress, output = Progress(name, quiet=background), []
    for line in process.stdout:
        match = STEP.match(line)
        if match:
            progress.step(int(match[1]), int(match[2]))
        else:
            output.append(line)
    progress.close()
    if process.wait() != 0:
        raise BuildError("".join(output).strip())


def build(preset: str, targets=(), keep_going: bool = False, background: bool = False) -> None:
    """Configures the preset when that was never done, and builds what is stale. Raises BuildError.

    targets: what to build, the preset's usual things unless told.
    keep_going: build all that can be built, so that one run shows every file that fails.
    background: without a word, and with the processor time alone that other work leaves idle.
    """
    folder = ROOT / "build" / preset
    if not (folder / "build.ninja").exists():
        stream_build(["cmake", "--preset", preset], preset, background)
    stream_build(["cmake", "--build", str(folder), *(["--target", *targets] if targets else []), *(["--", "-k", "0"] if keep_going else [])],
                 preset, background)


def core(program: str, purpose: str = "build") -> bool:
    """Installs what is missing for a purpose (setup.install) and builds the WebAssembly core. False when that failed; why has been said then, in the program's name."""
    try:
        setup.install(purpose)
        if not (ROOT / "build/wasm/dimline.wasm").exists():
            print("Building the WebAssembly core; the first time takes a minute or two.", flush=True)
        build("wasm")
    except setup.SetupError as error:
        print(f"{program}: {error}", file=sys.stderr)
        return False
    except BuildError as error:
        print(f"{error}\n{program}: the build of the WebAssembly core failed; the reason stands above.", file=sys.stderr)
        return False
    return True

#!/usr/bin/env python3
"""Installs what building, serving and testing Dimline need, and says what it does.

    python3 tools/setup.py                 everything for building and testing
    python3 tools/setup.py --for build     what serve.py needs: the wasm toolchain
    python3 tools/setup.py --for develop   everything, and the linters and ccache

serve.py and test.py call install() at each start. What is there already is found by looking for the files themselves,
without starting a program, so that a second start costs next to nothing and a node or a compiler that did not come as a
Debian package counts too.
"""

import argparse
import functools
import glob
import hashlib
import os
import platform
import re
import shutil
import subprocess
import sys
import time
from dataclasses import dataclass
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent
EMSCRIPTEN_VERSION = "3.1.69"
EMSCRIPTEN_MINIMUM = (3, 1, 50)  # cmake/wasm_toolchain.cmake holds the same
NODE_MINIMUM = 20  # playwright-core refuses less
INCLUDE_FOLDERS = ("/usr/local/include", "/usr/include", "/opt/homebrew/include")
LIBRARY_FOLDERS = ("/usr/lib/*-linux-gnu", "/usr/lib64", "/usr/lib", "/usr/local/lib")


class SetupError(Exception):
    """Something is missing and could not be installed; the text is a sentence for the user."""


@dataclass(frozen=True)
class Package:
    """A Debian package, and what shows that it, or something as good, is there."""

    name: str
    command: str = ""  # a program on PATH
    header: str = ""  # a file in an include folder
    library: str = ""  # a file in a library folder
    file: str = ""  # a file

    def present(self) -> bool:
        if self.command:
            return shutil.which(self.command) is not None
        if self.header:
            return any(os.path.exists(f"{folder}/{self.header}") for folder in INCLUDE_FOLDERS)
        if self.library:
            return any(glob.glob(f"{folder}/{self.library}") for folder in LIBRARY_FOLDERS)
        return os.path.exists(self.file)


BUILD_PACKAGES = (
    Package("cmake", command="cmake"),
    Package("ninja-build", command="ninja"),
    Package("nodejs", command="node"),
    Package("npm", command="npm"),
    Package("libglm-dev", header="glm/glm.hpp"),
    Package("libtinygltf-dev", header="tiny_gltf.h"),
    Package("nlohmann-json3-dev", header="nlohmann/json.hpp"),
    Package("libstb-dev", header="stb/stb_image.h"),
)
LLVM_PACKAGES = tuple(
    Package(name, file=f"/usr/lib/llvm-19/bin/{program}")
    for name, program in (("clang-19", "clang"), ("lld-19", "lld"), ("llvm-19", "llvm-ar"))
)
TEST_PACKAGES = (
    Package("g++", command="g++"),
    Package("catch2", header="catch2/catch.hpp"),
    Package("libegl-dev", header="EGL/egl.h"),
    Package("libgles-dev", header="GLES3/gl3.h"),
    Package("libgl1-mesa-dri", library="dri/swrast_dri.so"),
    Package("chromium", command="chromium"),
)
DEVELOP_PACKAGES = (
    Package("clang-format-19", command="clang-format-19"),
    Package("clang-tidy-19", command="clang-tidy-19"),
    Package("ccache", command="ccache"),
)


def say(text: str) -> None:
    print(text, flush=True)


def run(command, failure: str, **options) -> None:
    """Runs a command silently; when it fails, its last lines follow the failure's sentence."""
    result = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, errors="replace", **options)
    if result.returncode != 0:
        tail = "\n".join("    " + line for line in result.stdout.strip().splitlines()[-15:])
        raise SetupError(f"{failure}\n    {' '.join(map(str, command))}\n{tail}")


def cache_folder() -> Path:
    return Path(os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache") / "dimline"


def emscripten_prefix() -> Path:
    return cache_folder() / f"emscripten-{EMSCRIPTEN_VERSION}"


def version_of(text: str) -> tuple:
    """The first version number in a text, as a tuple; () when there is none."""
    match = re.search(r"(\d+)\.(\d+)\.(\d+)", text)
    return tuple(map(int, match.groups())) if match else ()


def emscripten_on_path():
    """The folder of an em++ on PATH that is new enough, or None. Its version stands in a file beside it."""
    program = shutil.which("em++")
    if not program:
        return None
    folder = Path(program).resolve().parent
    try:
        version = version_of((folder / "emscripten-version.txt").read_text())
    except OSError:
        return None
    return folder if version >= EMSCRIPTEN_MINIMUM else None


def has_emscripten() -> bool:
    return emscripten_on_path() is not None or (emscripten_prefix() / ".done").exists()


@functools.cache
def node_major(program: str) -> int:
    try:
        text = subprocess.run([program, "--version"], capture_output=True, text=True, check=True).stdout
    except (OSError, subprocess.CalledProcessError):
        return 0
    version = version_of(text)
    return version[0] if version else 0


def own_node() -> Path:
    """The node of tools/node. Not by .bin/node: npm 9 removes that link with the package for another processor."""
    processor = {"x86_64": "x64", "aarch64": "arm64"}.get(platform.machine(), platform.machine())
    return ROOT / f"tools/node/node_modules/node-linux-{processor}/bin/node"


def node() -> str:
    """A node that is new enough for the tests. Call after install("test")."""
    system = shutil.which("node")
    return system if system and node_major(system) >= NODE_MINIMUM else str(own_node())


def needed_packages(purpose: str) -> tuple:
    packages = BUILD_PACKAGES
    if not has_emscripten():
        packages += LLVM_PACKAGES
    if purpose in ("test", "develop"):
        packages += TEST_PACKAGES
    if purpose == "develop":
        packages += DEVELOP_PACKAGES
    return packages


def install_packages(packages) -> None:
    """Installs Debian packages by apt-get, as root or with sudo."""
    names = [package.name for package in packages if not package.present()]
    if not names:
        return
    listed = " ".join(names)
    if not shutil.which("apt-get"):
        raise SetupError(
            "Missing on this machine, and there is no apt-get to install it with. Please install by hand what these "
            f"Debian packages hold, then start again: {listed}")
    root = [] if os.geteuid() == 0 else ["sudo"]
    if root and not shutil.which("sudo"):
        raise SetupError("Missing, and only root may install it. Please run this as root, then start again:\n"
                         f"    apt-get install --no-install-recommends {listed}")
    count = "1 Debian package" if len(names) == 1 else f"{len(names)} Debian packages"
    say(f"Installing {count}{' with sudo' if root else ''}: {listed}")
    start = time.monotonic()
    if root:  # ask for the password while the terminal is still ours
        subprocess.run(["sudo", "-v"], check=False)
    environment = ["env", "DEBIAN_FRONTEND=noninteractive"]
    run([*root, *environment, "apt-get", "-qq", "update"], "apt-get could not read the package lists.")
    run([*root, *environment, "apt-get", "-qq", "-y", "--no-install-recommends", "install", *names],
        "apt-get could not install the packages.")
    missing = [package.name for package in packages if not package.present()]
    if missing:
        raise SetupError(f"apt-get installed them, but still nothing is found of: {' '.join(missing)}")
    say(f"  installed in {time.monotonic() - start:.0f} s")


def install_emscripten() -> None:
    if has_emscripten():
        return
    prefix = emscripten_prefix()
    if platform.system() != "Linux" or not shutil.which("apt-get"):
        raise SetupError("There is no Emscripten here. Please install the Emscripten SDK, "
                         f"{'.'.join(map(str, EMSCRIPTEN_MINIMUM))} or newer, and activate it, so that em++ is on PATH.")
    say(f"Installing Emscripten {EMSCRIPTEN_VERSION} into {prefix} (about 1 GB; delete the folder to be rid of it)")
    start = time.monotonic()
    run(["bash", str(ROOT / "tools/install-emscripten.sh"), str(prefix)],
        "Emscripten could not be installed. An em++ of your own on PATH would do as well "
        f"({'.'.join(map(str, EMSCRIPTEN_MINIMUM))} or newer).")
    say(f"  installed in {time.monotonic() - start:.0f} s")


def install_npm(folder: Path, what: str) -> None:
    """npm ci in the folder, unless what its lock file asks for is there."""
    lock = hashlib.sha256((folder / "package-lock.json").read_bytes()).hexdigest()
    stamp = folder / "node_modules/.installed-lock"
    if stamp.exists() and stamp.read_text() == lock:
        return
    say(f"Installing {what} with npm into {folder.relative_to(ROOT)}/node_modules")
    start = time.monotonic()
    run(["npm", "ci", "--no-audit", "--no-fund", "--loglevel=error"], f"npm could not install {what}.", cwd=folder)
    stamp.parent.mkdir(exist_ok=True)
    stamp.write_text(lock)
    say(f"  installed in {time.monotonic() - start:.0f} s")


def install(purpose: str) -> None:
    """Installs what is missing for a purpose: build, test (holds build) or develop (holds test). Raises SetupError."""
    install_packages(needed_packages(purpose))
    install_emscripten()
    if purpose in ("test", "develop"):
        system = shutil.which("node")
        if not system or node_major(system) < NODE_MINIMUM:
            install_npm(ROOT / "tools/node", f"Node {NODE_MINIMUM}, because the system's is {node_major(system or '')}")
            if node_major(str(own_node())) < NODE_MINIMUM:
                raise SetupError(f"The tests need Node {NODE_MINIMUM}, and npm has none for this kind of machine. "
                                 "Please install it by hand, so that node is on PATH.")
        install_npm(ROOT / "tests/browser", "the browser tests' packages")


def main() -> int:
    parser = argparse.ArgumentParser(description="Install what building, serving and testing Dimline need.")
    parser.add_argument("--for", dest="purpose", choices=("build", "test", "develop"), default="test",
                        help="build: what serve.py needs; test: everything that test.py needs (default); develop: linters too")
    purpose = parser.parse_args().purpose
    try:
        install(purpose)
    except SetupError as error:
        print(f"setup: {error}", file=sys.stderr)
        return 1
    say("Everything is there.")
    return 0


if __name__ == "__main__":
    sys.exit(main())

#!/usr/bin/env python3
"""Puts together the npm package that hosts install.

    python3 tools/package.py [--no-build]

Installs what is missing, builds the WebAssembly and writes build/package/dimline (to be copied into a site as it is)
and build/package/dimline-VERSION.tgz (`npm install` takes that file). What belongs to the package stands in
web/package.json. The same build gives the same bytes.
"""

import argparse
import gzip
import io
import json
import shutil
import sys
import tarfile
from pathlib import Path

import build

ROOT = Path(__file__).resolve().parent.parent
OUTPUT = ROOT / "build/package"
# npm packs these whether or not they are listed.
ALWAYS_PACKED = ("package.json", "README.md", "LICENSE")


class PackageError(Exception):
    """Something that belongs to the package is not there; the text says what."""


def read_manifest(root: Path = ROOT) -> dict:
    return json.loads((root / "web/package.json").read_text())


def source_of(path: str, root: Path) -> Path:
    """Where a file of the package lies in the checkout."""
    if path == "LICENSE":
        return root / path
    if path.startswith("build/"):
        return root / "build/wasm" / path.removeprefix("build/")
    if path.startswith("assets/"):
        return root / path
    return root / "web" / path


def write_folder(folder: Path, manifest: dict, root: Path = ROOT) -> list:
    """Replaces the folder by the package's files, which are what the manifest lists and what npm always packs; gives their paths in it, sorted. Raises PackageError."""
    paths = sorted({*manifest["files"], *ALWAYS_PACKED})
    missing = [path for path in paths if not source_of(path, root).is_file()]
    if missing:
        raise PackageError(f"missing for the package: {', '.join(missing)}. "
                           "Start without --no-build once, or mend \"files\" in web/package.json.")
    shutil.rmtree(folder, ignore_errors=True)
    for path in paths:
        target = folder / path
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(source_of(path, root), target)
    return paths


def write_archive(archive: Path, folder: Path, paths: list) -> None:
    """As `npm pack` lays it out: everything below package/. Neither clocks, users nor its own name go in."""
    with archive.open("wb") as file, gzip.GzipFile("", "wb", fileobj=file, mtime=0) as zipped, \
            tarfile.open(fileobj=zipped, mode="w") as tar:
        for path in paths:
            data = (folder / path).read_bytes()
            entry = tarfile.TarInfo(f"package/{path}")
            entry.size, entry.mode = len(data), 0o644
            tar.addfile(entry, io.BytesIO(data))


def parse_arguments(arguments=None):
    parser = argparse.ArgumentParser(description="Put together the npm package that hosts install.")
    parser.add_argument("--no-build", action="store_true", help="take what was built before; install and build nothing")
    return parser.parse_args(arguments)


def main() -> int:
    options = parse_arguments()
    if not options.no_build and not build.core("package"):
        return 1
    manifest = read_manifest()
    folder, archive = OUTPUT / "dimline", OUTPUT / f"dimline-{manifest['version']}.tgz"
    try:
        paths = write_folder(folder, manifest)
        write_archive(archive, folder, paths)
    except PackageError as error:
        print(f"package: {error}", file=sys.stderr)
        return 1
    except OSError as error:
        print(f"package: {error.filename or OUTPUT} cannot be written: {error.strerror or error}", file=sys.stderr)
        return 1
    print(f"{folder.relative_to(ROOT)}/ holds the package, {len(paths)} files.\n"
          f"{archive.relative_to(ROOT)} is the same for npm install, {archive.stat().st_size / 1000:.0f} kB.")
    return 0


if __name__ == "__main__":
    sys.exit(main())

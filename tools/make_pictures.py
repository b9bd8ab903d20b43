#!/usr/bin/env python3
"""Draws the pictures that ship: a thumbnail of each model for the page's menu, and the README's picture of the page.

    python3 tools/make_pictures.py                  all of them
    python3 tools/make_pictures.py boat lever       the thumbnails of these models
    python3 tools/make_pictures.py --readme         the README's picture

They are taken of the page itself, in headless Chromium: assets/thumbnails/NAME.webp and assets/readme/house.jpg.
tools/make_pictures.mjs says from where and how large.
"""

import argparse
import subprocess
import sys
from pathlib import Path

import build
import serve
import setup

ROOT = Path(__file__).resolve().parent.parent


def parse_arguments(arguments=None):
    parser = argparse.ArgumentParser(description="Draw the thumbnails of the models and the README's picture.")
    parser.add_argument("models", nargs="*", metavar="MODEL", help="only the thumbnails of these models")
    parser.add_argument("--readme", action="store_true", help="the README's picture")
    return parser.parse_args(arguments)


def what_to_draw(options) -> list:
    """The words for make_pictures.mjs: names of models, "*" for every one, "readme"."""
    everything = not options.models and not options.readme
    return [*options.models, *(["*"] if everything else []), *(["readme"] if options.readme or everything else [])]


def main() -> int:
    options = parse_arguments()
    if not build.core("make_pictures", "test"):
        return 1
    with serve.for_browser() as environment:
        script = ROOT / "tools/make_pictures.mjs"
        return subprocess.run([setup.node(), str(script), *what_to_draw(options)], cwd=ROOT, env=environment).returncode


if __name__ == "__main__":
    sys.exit(main())

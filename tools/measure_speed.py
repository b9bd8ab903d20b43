#!/usr/bin/env python3
"""Measures what the project's aims for speed are about, natively, in WebAssembly and in the page, and prints it beside the aims.

    python3 tools/measure_speed.py

Takes about three minutes, and a machine that does nothing else. `dimline bench` measures natively alone, and more of it.
"""

import json
import subprocess
import sys
from pathlib import Path

import build
import serve
import setup

ROOT = Path(__file__).resolve().parent.parent

# What of a model is measured in both builds: key of bench's JSON and title.
TIMES = {"placerMs": "placer", "cpuFieldsMs": "CPU fields", "rebuildMs": "rebuild"}


def bench(*command) -> dict:
    """Name of each model -> what `bench all` measured, in ms."""
    done = subprocess.run([*command, "bench", "all", "--json"], capture_output=True, text=True, check=True)
    return {result["model"]: result for result in json.loads(done.stdout)}


def ratio(native: dict, wasm: dict, model: str, key: str) -> float:
    return wasm[model][key] / native[model][key]


def model_rows(native: dict, wasm: dict) -> list:
    """A table's lines: every model's times, native and in WebAssembly."""
    lines = ["ms".ljust(20) + "".join(f"{title:>11}{'wasm':>9}{'ratio':>7}" for title in TIMES.values())]
    for model in native:
        cells = (f"{native[model][key]:>11.3f}{wasm[model][key]:>9.3f}{ratio(native, wasm, model, key):>6.2f}x" for key in TIMES)
        lines.append(model.ljust(20) + "".join(cells))
    return lines


def aims(native: dict, wasm: dict, page: dict) -> list:
    """(what, measured, aim, unit), the aim being the most that there should be."""
    rebuild = max(native, key=lambda model: native[model]["rebuildMs"])
    slowest, key = max(((model, key) for model in native for key in TIMES), key=lambda pair: ratio(native, wasm, *pair))
    return [
        ("placer, Candler Building", native["candler"]["placerMs"], 0.5, "ms"),
        ("CPU fields, Parthenon", native["parthenon"]["cpuFieldsMs"], 0.5, "ms"),
        ("CPU fields, Parthenon, WebAssembly", wasm["parthenon"]["cpuFieldsMs"], 1, "ms"),
        (f"longest rebuild ({rebuild})", native[rebuild]["rebuildMs"], 8, "ms"),
        (f"WebAssembly against native, worst ({TIMES[key]}, {slowest})", ratio(native, wasm, slowest, key), 2, "x"),
        ("dimline.wasm, brotli", page["brotliBytes"] / 1000, 300, "kB"),
        ("first picture, warm cache, software WebGL", page["firstPictureMs"] / 1000, 1, "s"),
    ]


def aim_rows(measured: list) -> list:
    return [f"{what:<58}{value:>9.3f} {unit:<3} <= {aim:<5g}{'ok' if value <= aim else 'missed'}" for what, value, aim, unit in measured]


def measure_page() -> dict:
    """What measure_page.mjs says of the page that is served here."""
    with serve.for_browser() as environment:
        done = subprocess.run([setup.node(), str(ROOT / "tools/measure_page.mjs")], cwd=ROOT, env=environment, stdout=subprocess.PIPE, text=True, check=True)
        return json.loads(done.stdout)


def main() -> int:
    if not build.core("measure_speed", "test"):
        return 1
    try:
        build.build("wasm", targets=["dimline_node"])
        build.build("native", targets=["dimline"])
        native = bench(str(ROOT / "build/native/dimline"))
        wasm = bench(setup.node(), str(ROOT / "build/wasm/dimline_node.cjs"))
        page = measure_page()
    except build.BuildError as error:
        print(f"{error}\nmeasure_speed: the build failed; the reason stands above.", file=sys.stderr)
        return 1
    except subprocess.CalledProcessError as error:
        print(f"measure_speed: {error.cmd[0]} failed: {(error.stderr or '').strip() or f'status {error.returncode}'}", file=sys.stderr)
        return 1
    print(*model_rows(native, wasm), "", *aim_rows(aims(native, wasm, page)), sep="\n")
    return 0


if __name__ == "__main__":
    sys.exit(main())

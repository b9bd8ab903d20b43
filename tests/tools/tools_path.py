"""Import this first: it puts tools/ on the import path, before the standard library's own `test`."""

import sys
from pathlib import Path

ROOT = Path(__file__).resolve().parent.parent.parent
if sys.path[0] != str(ROOT / "tools"):
    sys.path.insert(0, str(ROOT / "tools"))

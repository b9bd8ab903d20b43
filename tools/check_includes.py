#!/usr/bin/env python3
"""Fails when a source includes what its folder must not or leaves out what it needs, or when it belongs to no target.

    python3 tools/check_includes.py [ROOT]

The rule: a file in src/<folder> includes files of its own folder, of the folders in MAY_INCLUDE, and of theirs in turn.
The same list stands as DEPS in each src/<folder>/CMakeLists.txt, where it makes the link list; the two must agree.
"""

import re
import sys
from pathlib import Path

# Each folder of src/ and what it builds directly upon. Includes go only downwards.
MAY_INCLUDE = {
    "core": (),
    "math": ("core",),
    "model": ("math",),
    "models": ("model",),
    "gltf": ("model",),
    "silhouette": ("model",),
    "placement": ("silhouette",),
    "editing": ("placement",),
    "gpu": ("silhouette",),
    "render": ("editing", "gpu"),
    "app": ("render", "models", "gltf"),
    "bindings": ("app",),
    "cli": ("app",),
}

# Headers that the build makes, and the folders that see them.
GENERATED = {"core/version.h": None, "shaders.h": ("gpu", "render")}

# Headers of others that are kept to few folders: pattern, folders, and how many files of a folder may have them.
CONFINED = (
    (re.compile(r"tiny_gltf\.h$"), {"gltf": None}, "tinygltf is named only in src/gltf"),
    (re.compile(r"^(emscripten\b|webgl/)"), {"bindings": None, "gpu": 1},
     "emscripten's headers are included only in src/bindings and in one file of src/gpu"),
    (re.compile(r"^(GLES[23]?|GL|EGL|KHR)/"), {"gpu": None, "render": None, "app": None},
     "GL is seen only by src/gpu, src/render and src/app"),
)

# Headers of the standard library, and what each is included for. Precompiled headers and unity builds let a file pass that forgot one,
# until another file is moved; so a file has to reach each of them by includes of its own or of our headers.
STANDARD = {
    "algorithm": "all_of any_of clamp copy_if count count_if equal fill fill_n find find_if for_each is_sorted lower_bound max max_element min "
                 "min_element minmax none_of nth_element replace reverse rotate sort stable_sort transform",
    "array": "array",
    "bit": "bit_cast bit_ceil",
    "chrono": "chrono",
    "cmath": "acos asin atan atan2 cbrt ceil cos exp2 expm1 floor fmod hypot isfinite isinf isnan ldexp log log10 lround pow round sin sqrt "
             "tan trunc",
    "cstdint": "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t",
    "cstdio": "FILE fclose fopen fwrite snprintf",
    "cstdlib": "strtod",
    "cstring": "memcpy strerror",
    "deque": "deque",
    "filesystem": "filesystem",
    "fstream": "ifstream",
    "functional": "function",
    "initializer_list": "initializer_list",
    "iomanip": "setw",
    "iostream": "cerr cout",
    "limits": "numeric_limits",
    "map": "map multimap",
    "memory": "make_shared make_unique shared_ptr unique_ptr",
    "numbers": "numbers",
    "numeric": "iota partial_sum",
    "optional": "nullopt optional",
    "random": "minstd_rand mt19937",
    "set": "set",
    "span": "as_bytes span",
    "sstream": "ostringstream",
    "string": "string to_string",
    "string_view": "string_view",
    "system_error": "error_code",
    "thread": "thread",
    "tuple": "tie tuple",
    "unordered_map": "unordered_map unordered_multimap",
    "utility": "exchange forward move pair swap",
    "variant": "get_if in_place_index monostate variant visit",
    "vector": "vector",
}
HEADER_OF = {name: header for header, names in STANDARD.items() for name in names.split()}

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"\n]+)[>"]', re.MULTILINE)
COMMENT = re.compile(r"//[^\n]*")
STANDARD_NAME = re.compile(r"\bstd::(?:ranges::)?(\w+)")
MODULE_CALL = re.compile(r"\bdimline_module\(\s*(\w+)([^)]*)\)")
KEYWORDS = ("OBJECT", "DEPS", "LIBS", "EXCLUDE", "APART", "WASM", "WASM_O2", "WASM_Os", "WASM_Oz")


def closure(folder: str) -> set:
    """A folder and all that it may include, directly or not."""
    seen, rest = set(), [folder]
    while rest:
        name = rest.pop()
        if name not in seen:
            seen.add(name)
            rest.extend(MAY_INCLUDE[name])
    return seen


def dependencies(cmake_text: str):
    """Folder and DEPS of the dimline_module call in a CMakeLists.txt, or None when there is none."""
    match = MODULE_CALL.search(re.sub(r"#.*", "", cmake_text))
    if not match:
        return None
    words, found, keyword = match[2].split(), [], None
    for word in words:
        if word in KEYWORDS:
            keyword = word
        elif keyword == "DEPS":
            found.append(word)
    return match[1], found


def check_targets(root: Path) -> list:
    """Every folder has its target, with the DEPS of MAY_INCLUDE, and the root CMakeLists.txt adds it."""
    problems = []
    root_cmake = re.sub(r"#.*", "", (root / "CMakeLists.txt").read_text())
    for folder, allowed in MAY_INCLUDE.items():
        where = f"src/{folder}/CMakeLists.txt"
        try:
            declared = dependencies((root / where).read_text())
        except OSError:
            declared = None
        if declared is None or declared[0] != folder:
            problems.append(f"{where}: no dimline_module({folder} ...), so its files belong to no target")
        elif set(declared[1]) != set(allowed):
            problems.append(f"{where}: DEPS is {sorted(declared[1])}, MAY_INCLUDE in tools/check_includes.py is "
                            f"{sorted(allowed)}")
        if not re.search(rf"\b{folder}\b", root_cmake):
            problems.append(f"CMakeLists.txt: src/{folder} is not added")
    return problems


def check_place(path: Path) -> list:
    """A file of src/ (path from there) lies where its target's glob finds it."""
    if len(path.parts) < 2 or path.parts[0] not in MAY_INCLUDE:
        return [f"src/{path}: in none of the folders {', '.join(MAY_INCLUDE)}"]
    if len(path.parts) > 2:
        return [f"src/{path}: in a folder below src/{path.parts[0]}, where no target finds it"]
    if path.name != "CMakeLists.txt" and path.suffix not in (".h", ".cpp"):
        return [f"src/{path}: neither .h nor .cpp, so it belongs to no target"]
    return []


def check_file(root: Path, path: Path, confined_count: dict) -> list:
    """The includes of one source. confined_count counts, over all files, those with a confined header."""
    problems, folder = [], path.parts[0]
    allowed = closure(folder)
    text = (root / "src" / path).read_text(errors="replace")
    counted = set()
    for match in INCLUDE.finditer(text):
        quoted, name = match[1] == '"', match[2]
        where = f"src/{path}:{text.count(chr(10), 0, match.start()) + 1}"
        target = name.split("/")[0]
        if name in GENERATED:
            folders = GENERATED[name]
            if folders and folder not in folders:
                problems.append(f"{where}: {name} is for {' and '.join(folders)}")
            elif "/" in name and target not in allowed:
                problems.append(f"{where}: {folder} must not include {target} ({name})")
        elif "/" in name and target in MAY_INCLUDE:
            if target not in allowed:
                problems.append(f"{where}: {folder} must not include {target} ({name})")
            elif not quoted:
                problems.append(f"{where}: write our own header in quotes, \"{name}\"")
            elif not (root / "src" / name).is_file():
                problems.append(f"{where}: there is no src/{name}")
        elif quoted:
            problems.append(f"{where}: write \"{name}\" from src/ as root, or in <> when it is not ours")
        for index, (pattern, folders, rule) in enumerate(CONFINED):
            if not pattern.search(name):
                continue
            if folder not in folders:
                problems.append(f"{where}: <{name}>: {rule}")
            elif index not in counted and folders[folder] is not None:
                counted.add(index)
                key = (folder, index)
                confined_count[key] = confined_count.get(key, 0) + 1
                if confined_count[key] > folders[folder]:
                    problems.append(f"{where}: <{name}>: {rule}")
    return problems


def standard_headers(root: Path, name: str, seen: dict) -> set:
    """The headers of the standard library that src/name reaches through includes of its own and of our headers. seen: what is known."""
    if name not in seen:
        seen[name] = set()  # stops a ring of includes
        file = root / "src" / name
        if file.is_file():
            for match in INCLUDE.finditer(file.read_text(errors="replace")):
                seen[name] |= standard_headers(root, match[2], seen) if match[1] == '"' else {match[2]}
    return seen[name]


def check_standard(root: Path, path: Path, seen: dict) -> list:
    """The standard headers that one source needs and does not reach."""
    text = COMMENT.sub("", (root / "src" / path).read_text(errors="replace"))
    reached, problems = standard_headers(root, str(path), seen), {}
    for match in STANDARD_NAME.finditer(text):
        header = HEADER_OF.get(match[1])
        if header and header not in reached and header not in problems:
            line = text.count("\n", 0, match.start()) + 1
            problems[header] = f"src/{path}:{line}: {match[0]} needs #include <{header}>"
    return list(problems.values())


def check(root: Path) -> list:
    """All problems of a checkout, as sentences that begin with file and line. Empty when it is sound."""
    problems, confined_count, seen = check_targets(root), {}, {}
    for file in sorted((root / "src").rglob("*")):
        if not file.is_file() or file.name.startswith("."):
            continue
        path = file.relative_to(root / "src")
        misplaced = check_place(path)
        problems += misplaced
        if not misplaced and path.suffix in (".h", ".cpp"):
            problems += check_file(root, path, confined_count)
            problems += check_standard(root, path, seen)
    return problems


def main() -> int:
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parent.parent
    problems = check(root)
    for problem in problems:
        print(problem)
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())

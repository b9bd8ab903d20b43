import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

from tools_path import ROOT

import check_includes


class Checkout(unittest.TestCase):
    """Each test starts from a small sound checkout in a temporary folder and breaks it in one way."""

    def setUp(self):
        temporary = tempfile.TemporaryDirectory()
        self.addCleanup(temporary.cleanup)
        self.root = Path(temporary.name)
        for folder, allowed in check_includes.MAY_INCLUDE.items():
            deps = f" DEPS {' '.join(allowed)}" if allowed else ""
            self.write(f"src/{folder}/CMakeLists.txt", f"dimline_module({folder}{deps} LIBS dimline::some)\n")
        self.write("CMakeLists.txt", " ".join(check_includes.MAY_INCLUDE) + "\n")
        self.write("src/core/result.h", "#pragma once\n#include <string>\n")
        self.write("src/math/obb.h", '#pragma once\n#include "core/result.h"\n')
        self.write("src/placement/placer.h", '#pragma once\n#include "math/obb.h"\n#include "core/version.h"\n')

    def write(self, path, text):
        file = self.root / path
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def assert_problem(self, *parts):
        """There is exactly one problem, and it holds all the parts."""
        problems = check_includes.check(self.root)
        self.assertEqual(len(problems), 1, problems)
        for part in parts:
            self.assertIn(part, problems[0])

    def test_sound(self):
        self.assertEqual(check_includes.check(self.root), [])

    def test_upward_include(self):
        self.write("src/math/obb.h", '#pragma once\n\n#include "placement/placer.h"\n')
        self.assert_problem("src/math/obb.h:3", "math must not include placement")

    def test_sideways_include(self):
        self.write("src/gpu/field.h", "#pragma once\n")
        self.write("src/editing/drag.cpp", '#  include  "gpu/field.h"\n')
        self.assert_problem("src/editing/drag.cpp:1", "editing must not include gpu")

    def test_upward_include_in_angle_brackets(self):
        self.write("src/core/result.h", "#include <math/obb.h>\n")
        self.assert_problem("core must not include math")

    def test_own_header_in_angle_brackets(self):
        self.write("src/math/plane.h", "#include <core/result.h>\n")
        self.assert_problem("in quotes")

    def test_include_that_is_not_there(self):
        self.write("src/math/plane.h", '#include "core/results.h"\n')
        self.assert_problem("there is no src/core/results.h")

    def test_include_from_the_folder_as_root(self):
        self.write("src/math/plane.h", '#include "obb.h"\n')
        self.assert_problem("src/math/plane.h:1", "from src/ as root")

    def test_include_by_way_of_the_parent(self):
        self.write("src/math/plane.h", '#include "../core/result.h"\n')
        self.assert_problem("from src/ as root")

    def test_shaders_below_gpu(self):
        self.write("src/gpu/mask.cpp", '#include "shaders.h"\n')
        self.assertEqual(check_includes.check(self.root), [])
        self.write("src/model/mesh.cpp", '#include "shaders.h"\n')
        self.assert_problem("src/model/mesh.cpp:1", "gpu and render")

    def test_tinygltf(self):
        self.write("src/gltf/reader.cpp", "#include <tiny_gltf.h>\n")
        self.assertEqual(check_includes.check(self.root), [])
        self.write("src/app/editor.cpp", "#include <tiny_gltf.h>\n")
        self.assert_problem("src/app/editor.cpp:1", "only in src/gltf")

    def test_emscripten(self):
        self.write("src/bindings/a.cpp", "#include <emscripten/bind.h>\n#include <emscripten.h>\n")
        self.write("src/bindings/b.cpp", "#include <emscripten/val.h>\n")
        self.write("src/gpu/context_web.cpp", "#include <emscripten/html5.h>\n#include <webgl/webgl2.h>\n")
        self.assertEqual(check_includes.check(self.root), [])
        self.write("src/gpu/fields.cpp", "#include <webgl/webgl2.h>\n")
        self.assert_problem("src/gpu/fields.cpp:1", "one file of src/gpu")
        (self.root / "src/gpu/fields.cpp").unlink()
        self.write("src/app/editor.h", "#include <emscripten/val.h>\n")
        self.assert_problem("src/app/editor.h:1", "emscripten")

    def test_gl_in_placement(self):
        self.write("src/gpu/mask.cpp", "#include <GLES3/gl3.h>\n#include <EGL/egl.h>\n")
        self.assertEqual(check_includes.check(self.root), [])
        self.write("src/placement/placer.cpp", "#include <GLES3/gl3.h>\n")
        self.assert_problem("src/placement/placer.cpp:1", "GL is seen only")

    def test_file_outside_the_folders(self):
        self.write("src/main.cpp", "")
        self.assert_problem("src/main.cpp", "in none of the folders")

    def test_folder_that_the_table_does_not_have(self):
        self.write("src/physics/CMakeLists.txt", "dimline_module(physics)\n")
        self.assert_problem("src/physics/CMakeLists.txt", "in none of the folders")

    def test_folder_below_a_folder(self):
        self.write("src/math/detail/hull.h", "")
        self.assert_problem("src/math/detail/hull.h", "no target finds it")

    def test_suffix_that_no_target_globs(self):
        self.write("src/math/hull.cc", "")
        self.assert_problem("src/math/hull.cc", "belongs to no target")

    def test_folder_without_target(self):
        (self.root / "src/math/CMakeLists.txt").unlink()
        self.assert_problem("src/math/CMakeLists.txt", "no dimline_module(math ...)")

    def test_deps_that_differ_from_the_table(self):
        self.write("src/math/CMakeLists.txt", "dimline_module(math DEPS core model)\n")
        self.assert_problem("src/math/CMakeLists.txt", "['core', 'model']")

    def test_folder_that_the_root_does_not_add(self):
        names = [name for name in check_includes.MAY_INCLUDE if name != "editing"]
        self.write("CMakeLists.txt", " ".join(names) + "\n# editing\n")
        self.assert_problem("src/editing is not added")

    def test_standard_header_that_is_left_out(self):
        self.write("src/math/plane.h", "#include <vector>\n\n// std::string here\nstd::vector<int> a; std::optional<int> b; std::optional<int> c;\n")
        self.assert_problem("src/math/plane.h:4", "std::optional needs #include <optional>")

    def test_standard_header_of_an_algorithm_over_a_range(self):
        self.write("src/math/plane.cpp", "bool sorted = std::ranges::is_sorted(numbers);\n")
        self.assert_problem("std::ranges::is_sorted needs #include <algorithm>")

    def test_standard_header_reached_through_our_own(self):
        self.write("src/math/plane.h", '#include "math/obb.h"\nstd::string name;\n')
        self.assertEqual(check_includes.check(self.root), [])

    def test_standard_header_in_a_file_that_only_another_includes(self):
        self.write("src/math/plane.cpp", "std::string name;\n")
        self.assert_problem("std::string needs #include <string>")


class Table(unittest.TestCase):
    def test_closure_reaches_down_to_core(self):
        self.assertEqual(check_includes.closure("editing"),
                         {"editing", "placement", "silhouette", "model", "math", "core"})

    def test_no_folder_reaches_itself(self):
        for folder, direct in check_includes.MAY_INCLUDE.items():
            for lower in direct:
                self.assertNotIn(folder, check_includes.closure(lower))

    def test_placement_never_sees_gl(self):
        for folder in ("silhouette", "placement", "editing"):
            self.assertFalse({"gpu", "render"} & check_includes.closure(folder))

    def test_cmake_call(self):
        self.assertEqual(check_includes.dependencies("# dimline_module(x)\ndimline_module(a OBJECT\n  DEPS b c\n  LIBS d::e)"),
                         ("a", ["b", "c"]))
        self.assertIsNone(check_includes.dependencies("add_library(a a.cpp)"))


class Program(unittest.TestCase):
    def test_exit_status(self):
        with tempfile.TemporaryDirectory() as empty:
            (Path(empty) / "CMakeLists.txt").write_text("")
            run = subprocess.run([sys.executable, str(ROOT / "tools/check_includes.py"), empty], capture_output=True, text=True)
        self.assertEqual(run.returncode, 1)
        self.assertIn("src/core/CMakeLists.txt", run.stdout)


if __name__ == "__main__":
    unittest.main()

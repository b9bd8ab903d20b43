import json
import tarfile
import tempfile
import unittest
from pathlib import Path

import tools_path  # noqa: F401  (so that tools/ can be imported)

import package


class Package(unittest.TestCase):
    def setUp(self):
        scratch = tempfile.TemporaryDirectory()
        self.addCleanup(scratch.cleanup)
        self.root = Path(scratch.name)
        self.put("web/package.json", json.dumps({"version": "1.2.3", "files": ["b.js", "build/core.wasm", "assets/fonts/f.woff2"]}))
        self.put("web/README.md", "for hosts")
        self.put("web/b.js", "b")
        self.put("web/page.js", "not listed")
        self.put("build/wasm/core.wasm", "core")
        self.put("assets/fonts/f.woff2", "font")
        self.put("LICENSE", "MIT")
        self.folder = self.root / "out/dimline"

    def put(self, name: str, text: str):
        file = self.root / name
        file.parent.mkdir(parents=True, exist_ok=True)
        file.write_text(text)

    def write(self):
        return package.write_folder(self.folder, package.read_manifest(self.root), self.root)

    def written(self):
        return sorted(str(file.relative_to(self.folder)) for file in self.folder.rglob("*") if file.is_file())

    def test_what_is_listed_and_what_npm_always_packs(self):
        paths = self.write()
        self.assertEqual(paths, ["LICENSE", "README.md", "assets/fonts/f.woff2", "b.js", "build/core.wasm", "package.json"])
        self.assertEqual(self.written(), paths)
        self.assertEqual((self.folder / "README.md").read_text(), "for hosts")
        self.assertEqual((self.folder / "build/core.wasm").read_text(), "core")

    def test_what_was_packed_before_and_is_no_more_goes(self):
        self.write()
        self.put("web/package.json", json.dumps({"files": ["b.js"]}))
        self.write()
        self.assertEqual(self.written(), ["LICENSE", "README.md", "b.js", "package.json"])

    def test_a_file_that_is_missing_is_named_and_the_last_package_stays(self):
        self.write()
        (self.root / "build/wasm/core.wasm").unlink()
        with self.assertRaisesRegex(package.PackageError, "build/core.wasm"):
            self.write()
        self.assertIn("build/core.wasm", self.written())

    def test_the_archive_is_as_npm_packs_and_the_same_every_time(self):
        paths = self.write()
        archives = [self.root / name for name in ("a.tgz", "b.tgz")]
        for archive in archives:
            package.write_archive(archive, self.folder, paths)
            (self.folder / "b.js").touch()
        first, second = (archive.read_bytes() for archive in archives)
        self.assertEqual(first, second)
        with tarfile.open(archives[0]) as tar:
            self.assertEqual(tar.getnames(), [f"package/{path}" for path in paths])
            self.assertEqual(tar.extractfile("package/b.js").read(), b"b")


if __name__ == "__main__":
    unittest.main()

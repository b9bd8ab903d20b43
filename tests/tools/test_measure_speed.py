import unittest

import tools_path  # noqa: F401  (so that tools/ can be imported)

import measure_speed


def times(placer, fields, rebuild):
    return {"placerMs": placer, "cpuFieldsMs": fields, "rebuildMs": rebuild}


class Rows(unittest.TestCase):
    native = {"candler": times(0.25, 0.4, 2.0), "parthenon": times(0.1, 0.2, 1.0)}
    wasm = {"candler": times(0.5, 0.6, 3.0), "parthenon": times(0.15, 0.5, 1.5)}
    page = {"firstPictureMs": 1200, "brotliBytes": 299400}

    def test_each_model_has_both_builds_and_their_ratio(self):
        header, candler, parthenon = measure_speed.model_rows(self.native, self.wasm)
        self.assertEqual(header.split(), "ms placer wasm ratio CPU fields wasm ratio rebuild wasm ratio".split())
        self.assertEqual(candler.split(), "candler 0.250 0.500 2.00x 0.400 0.600 1.50x 2.000 3.000 1.50x".split())
        self.assertEqual(parthenon.split()[-3:], ["1.000", "1.500", "1.50x"])
        self.assertEqual(len({len(header), len(candler), len(parthenon)}), 1)

    def test_what_is_measured_stands_beside_its_aim(self):
        measured = {what: (round(value, 6), aim, unit) for what, value, aim, unit in measure_speed.aims(self.native, self.wasm, self.page)}
        self.assertEqual(measured, {
            "placer, Candler Building": (0.25, 0.5, "ms"),
            "CPU fields, Parthenon": (0.2, 0.5, "ms"),
            "CPU fields, Parthenon, WebAssembly": (0.5, 1, "ms"),
            "longest rebuild (candler)": (2.0, 8, "ms"),
            "WebAssembly against native, worst (CPU fields, parthenon)": (2.5, 2, "x"),
            "dimline.wasm, brotli": (299.4, 300, "kB"),
            "first picture, warm cache, software WebGL": (1.2, 1, "s"),
        })

    def test_an_aim_that_is_missed_is_said_to_be(self):
        met, exactly, missed = measure_speed.aim_rows([("a", 0.4, 0.5, "ms"), ("b", 2, 2, "x"), ("c", 1.2, 1, "s")])
        self.assertTrue(met.endswith("ok") and exactly.endswith("ok"))
        self.assertEqual(missed.split(), ["c", "1.200", "s", "<=", "1", "missed"])


if __name__ == "__main__":
    unittest.main()

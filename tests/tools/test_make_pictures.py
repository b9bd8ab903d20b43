import unittest

import tools_path  # noqa: F401  (so that tools/ can be imported)

import make_pictures


class Words(unittest.TestCase):
    def words(self, *arguments):
        return make_pictures.what_to_draw(make_pictures.parse_arguments(arguments))

    def test_everything_without_arguments(self):
        self.assertEqual(self.words(), ["*", "readme"])

    def test_only_the_models_that_are_named(self):
        self.assertEqual(self.words("boat", "lever"), ["boat", "lever"])

    def test_only_the_readme_picture(self):
        self.assertEqual(self.words("--readme"), ["readme"])

    def test_both(self):
        self.assertEqual(self.words("boat", "--readme"), ["boat", "readme"])


if __name__ == "__main__":
    unittest.main()

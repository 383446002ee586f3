"""scenes/generate: writes the committed scenes again, and says in one line what it cannot write."""
import os
import pathlib
import re
import subprocess
import sys
import tempfile
import unittest

ROOT = pathlib.Path(__file__).resolve().parents[2]
SCENES = ROOT / "scenes"
ACCORD = os.environ["ACCORD"]
# Scenes that were put together by hand, from maps, meshes and robots of others.
BY_HAND = {"depot-map", "mixed-floor", "panda-four", "rack-drones", "ros-floor", "ur5e-pair"}
FAMILY_OF_NAME = {"peer-planar-cross": "planar-cross"}  # where the file has another name

sys.path.insert(0, str(SCENES))
from families import FAMILIES  # noqa: E402  (from the folder above)


def generate(*arguments):
    return subprocess.run([SCENES / "generate", *map(str, arguments)], capture_output=True,
                          text=True, timeout=60, check=False)


class Generate(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = pathlib.Path(folder.name)

    def assert_refused(self, why, *arguments):
        result = generate(*arguments, "-o", self.folder)
        self.assertEqual(2, result.returncode, result.stderr)
        self.assertEqual(1, result.stderr.count("\n"), result.stderr)
        self.assertIn(why, result.stderr)
        self.assertEqual([], list(self.folder.iterdir()))

    def test_writes_every_committed_scene_byte_for_byte(self):
        committed = [scene for scene in sorted(SCENES.glob("*.yaml"))
                     if scene.stem not in BY_HAND]
        self.assertGreater(len(committed), 30)
        for scene in committed:
            name, size = re.fullmatch(r"(.+?)(?:-(\d+))?", scene.stem).groups()
            with self.subTest(scene=scene.stem):
                robots = size or scene.read_text().count("- {name: ")
                result = generate(FAMILY_OF_NAME.get(name, name), int(robots), "-o", self.folder)
                self.assertEqual(0, result.returncode, result.stderr)
                self.assertEqual(scene.read_bytes(), (self.folder / scene.name).read_bytes())
        urdfs = list(self.folder.glob("*.urdf"))
        self.assertEqual({"arm6.urdf", "planar3.urdf", "planar3s.urdf"},
                         {urdf.name for urdf in urdfs})
        for urdf in urdfs:
            self.assertEqual((SCENES / urdf.name).read_bytes(), urdf.read_bytes())

    def test_accord_accepts_every_family(self):
        # Smallest and largest; all sizes where there are few.
        for family in FAMILIES.values():
            few = len(family.sizes) <= 16
            for size in family.sizes if few else (family.sizes[0], family.sizes[-1]):
                with self.subTest(family=family.name, size=size):
                    result = generate(family.name, size, "-o", self.folder)
                    self.assertEqual(0, result.returncode, result.stderr)
                    scene = result.stdout.splitlines()[0]
                    info = subprocess.run([ACCORD, "info", scene], capture_output=True, text=True,
                                          timeout=60, check=False)
                    self.assertEqual(0, info.returncode, info.stderr)
                    self.assertRegex(info.stdout, rf"robots +{size} with")

    def test_the_seed_decides_what_is_drawn(self):
        def texts(folder, seed):
            generate("random-crossing", 8, "--seed", seed, "-o", self.folder / folder)
            generate("fleet", 10, "--seed", seed, "-o", self.folder / folder)
            return [path.read_text() for path in sorted((self.folder / folder).iterdir())]

        first, again, other = texts("first", 5), texts("again", 5), texts("other", 6)
        self.assertEqual(2, len(first))
        self.assertEqual(first, again)
        for a, b in zip(first, other):
            self.assertNotEqual(a.split("robots:")[1], b.split("robots:")[1])

    def test_a_parameter_is_part_of_the_name_so_that_no_scene_is_overwritten(self):
        generate("low-mobile", 8, "-o", self.folder)
        generate("low-mobile", 8, "--radius", "0.3", "-o", self.folder)
        self.assertEqual({"low-mobile-08.yaml", "low-mobile-08-radius0.3.yaml"},
                         {path.name for path in self.folder.iterdir()})

    def test_arms_of_other_lengths_have_files_of_their_own(self):
        generate("planar-cross", 4, "--link", "0.25", "-o", self.folder)
        scene = (self.folder / "peer-planar-cross-004-link0.25.yaml").read_text()
        urdf, = self.folder.glob("*.urdf")
        self.assertIn(f"urdf: {urdf.name}", scene)
        self.assertNotIn(urdf.name, os.listdir(SCENES))

    def test_says_in_one_line_what_it_cannot_write(self):
        self.assert_refused("no family 'magic'; there are low-mobile, high-mobile", "magic", 4)
        self.assert_refused("no scene of 9 robots; the number must be even", "low-mobile", 9)
        self.assert_refused("no scene of 17 robots; the number must be from 2 to 16",
                            "low-manipulator", 17)
        self.assert_refused("no scene of 7 robots", "peer-parallel", 8, 7)
        self.assert_refused("radius below half the pitch", "low-mobile", 8, "--radius", 0.8)
        self.assert_refused("invalid finite value", "low-mobile", 8, "--radius", "nan")
        self.assert_refused("unrecognized arguments: --seed 1", "low-mobile", 8, "--seed", 1)
        self.assert_refused("required: N", "low-mobile")
        self.assertEqual(2, generate().returncode)

    def test_lists_its_families(self):
        listed = generate("--list")
        self.assertEqual(0, listed.returncode)
        self.assertEqual(list(FAMILIES), [line.split()[0] for line in listed.stdout.splitlines()])
        self.assertIn("--density", generate("fleet", "--help").stdout)


if __name__ == "__main__":
    unittest.main()

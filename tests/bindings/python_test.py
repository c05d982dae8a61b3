"""The Python package: arrays without a copy, edits with their errors, copies, sweeps, examples."""
import copy
import importlib.util
import os
import pathlib
import pickle
import subprocess
import sys
import tempfile
import time
import unittest

import numpy

import colors_of
import griffith

SOURCE = pathlib.Path(os.environ["GRIFFITH_SOURCE"])
PROGRAM = os.environ.get("GRIFFITH_PROGRAM")
SHOT_WALL = {
    "bodies": [
        {
            "shape": {"box": {"size": [3, 3, 1], "element_size": 1.5, "pattern": "kuhn"}},
            "position": [0, 1.5, 0],
            "material": {"preset": "brick", "tensile_strength": 60000, "fracture_toughness": 40000},
            "supports": [{"region": {"half_space": {"point": [0, -1.5, 0], "normal": [0, -1, 0]}}}],
        }
    ],
    "projectiles": [{"position": [0, 2, 2], "speed": 40, "mass": 25}],
}


def example(name):
    """Imports a program of examples/python."""
    spec = importlib.util.spec_from_file_location(name, SOURCE / "examples" / "python" / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    sys.modules[name] = module
    spec.loader.exec_module(module)
    return module


class Frames(unittest.TestCase):
    def test_arrays_are_views_of_one_memory(self):
        frame = griffith.World(SHOT_WALL).frame
        address = frame.positions.__array_interface__["data"][0]
        self.assertEqual(address, frame.positions.__array_interface__["data"][0])
        self.assertFalse(frame.positions.flags.owndata)
        self.assertFalse(frame.positions.flags.writeable)
        with self.assertRaises(ValueError):
            frame.positions[0, 0] = 1

    def test_arrays_have_the_shapes_that_belong_together(self):
        frame = griffith.World(SHOT_WALL).run(30).frame
        nodes, tets, bodies = len(frame.positions), len(frame.tets), len(frame.body_masses)
        self.assertEqual(frame.separation_tensors.shape, (nodes, 3, 3))
        self.assertEqual(frame.utilization.shape, (nodes,))
        self.assertEqual(frame.stress.shape, (tets, 3, 3))
        self.assertEqual(frame.body_orientations.shape, (bodies, 4))
        self.assertEqual(bodies, frame.bodies)
        self.assertLess(frame.tets.max(), nodes)
        self.assertAlmostEqual(frame.masses.sum(), frame.body_masses.sum())
        numpy.testing.assert_allclose(frame.separation_tensors, frame.separation_tensors.transpose(0, 2, 1))
        numpy.testing.assert_allclose(numpy.linalg.norm(frame.body_orientations, axis=1), 1)

    def test_quantities_are_computed_from_the_arrays(self):
        frame = griffith.World(SHOT_WALL).run(30).frame
        self.assertEqual(griffith.QUANTITIES["von_mises"].unit, "Pa")
        for name in griffith.QUANTITIES:
            self.assertIn(len(frame.quantity(name)), (len(frame.positions), len(frame.tets)))
        pressure = -numpy.trace(frame.stress, axis1=1, axis2=2) / 3
        numpy.testing.assert_allclose(frame.quantity("pressure"), pressure)
        numpy.testing.assert_array_equal(frame.quantity("displacement"), frame.positions - frame.rest_positions)
        with self.assertRaisesRegex(KeyError, "QUANTITIES"):
            frame.quantity("presure")

    def test_arrays_keep_their_world(self):
        positions = griffith.World(SHOT_WALL).frame.positions
        self.assertTrue(numpy.isfinite(positions.sum()))

    def test_all_names_are_known_to_editors(self):
        stub = (SOURCE / "bindings/python/griffith/frame.pyi").read_text()
        for name in [*griffith.ARRAYS, *griffith.VALUES]:
            self.assertIn(f"    {name}: ", stub)
        self.assertIn("utilization", dir(griffith.World(SHOT_WALL).frame))
        with self.assertRaisesRegex(AttributeError, "utilisation"):
            griffith.World(SHOT_WALL).frame.utilisation

    def test_a_step_costs_little_more_than_in_cpp(self):
        world = griffith.World({"bodies": [], "ground": None})
        world.step(1000)
        start = time.process_time()
        world.step(20000)
        inside = time.process_time() - start
        start = time.process_time()
        for _ in range(20000):
            world.step()
        outside = time.process_time() - start
        self.assertLess((outside - inside) / 20000, 20e-6)


class Scenes(unittest.TestCase):
    def test_fields_are_edited_by_attribute_and_pointer(self):
        scene = griffith.Scene(SHOT_WALL)
        scene.projectiles[0].speed = numpy.float64(12)
        self.assertEqual(scene["/projectiles/0/speed"], 12)
        scene["/gravity"] = [0, 0, 0]
        self.assertEqual(scene.gravity, [0, 0, 0])
        scene.bodies[-1].material = "granite"
        self.assertEqual(scene.bodies[0].material.density, 2650)
        self.assertEqual([body.name for body in scene.bodies], ["body"])

    def test_errors_say_where_and_change_nothing(self):
        scene = griffith.Scene(SHOT_WALL)
        before = scene.get()
        with self.assertRaises(griffith.InputError) as caught:
            scene.bodies[0].material.density = -1
        self.assertEqual(caught.exception.where, "scene#/bodies/0/material/density")
        self.assertTrue(caught.exception.remedy)
        with self.assertRaisesRegex(griffith.InputError, "gravity"):
            scene.gravty = [0, 0, 0]
        with self.assertRaises(griffith.InputError):
            griffith.Scene("no/such/scene.json")
        self.assertEqual(scene.get(), before)
        self.assertEqual(pickle.loads(pickle.dumps(caught.exception)).where, caught.exception.where)

    def test_copies_are_independent(self):
        scene = griffith.Scene(SHOT_WALL)
        other = copy.deepcopy(scene)
        self.assertEqual(scene, other)
        other.projectiles[0].speed = 1
        self.assertNotEqual(scene, other)

    def test_meshes_come_from_arrays(self):
        scene = griffith.Scene({"bodies": [{"shape": {"mesh": {"path": "tet"}}, "material": "brick"}]})
        scene.set_mesh("tet", [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]], [[0, 1, 2, 3]])
        self.assertAlmostEqual(griffith.World(scene).frame.mass, 1900 / 6)

    def test_every_shipped_scene_is_read(self):
        for path in sorted((SOURCE / "scenes").glob("*.json")):
            if path.name != "scene.schema.json":
                self.assertTrue(griffith.Scene(path).name, path)


class Worlds(unittest.TestCase):
    @unittest.skipUnless(PROGRAM, "the program griffith is not built")
    def test_the_state_is_that_of_the_command_line(self):
        path = SOURCE / "scenes" / "wall_small.json"
        output = subprocess.run([PROGRAM, "simulate", path, "--frames", "60"], capture_output=True, text=True, check=True)
        self.assertIn(griffith.World(path).run(60).state_hash, output.stdout)

    def test_copies_go_on_alike(self):
        world = griffith.World(SHOT_WALL).run(5)
        snapshot = world.copy()
        end = world.run(20).state_hash
        self.assertEqual(snapshot.run(20).state_hash, end)
        with griffith.thread_limit(1):
            self.assertEqual(griffith.World(SHOT_WALL).run(25).state_hash, end)

    def test_shots_and_edits_are_recorded(self):
        world = griffith.World(SHOT_WALL, record=True)
        world.fire(position=[0, 1, 3], speed=20, mass=10, radius=0.1)
        world.run(3)
        world.set_material(0, young_modulus=5e9, density=2000)
        world.push([0, 1, 1], [0, 0, -40])
        world.grab([0, 1, 1], target=[0, 1.3, 1], strength=5)
        world.run(5)
        world.move_grab([0, 1.4, 1])
        world.run(2)
        world.release()
        with self.assertRaises(griffith.ArgumentError):
            world.push([0, 1, 1], [float("nan"), 0, 0])
        with self.assertRaises(griffith.InputError):
            world.move_grab([0, 1, 1])
        with self.assertRaises(griffith.InputError):
            world.set_material(0, density=2100, poisson_ratio=3)
        with self.assertRaises(griffith.InputError):
            world.fire(speed=-1)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "run.tar.zst"
            world.save_recording(path)
            if PROGRAM:
                subprocess.run([PROGRAM, "replay", path], check=True, capture_output=True)

    def test_progress_is_followed_and_may_give_up(self):
        stages = []
        griffith.World(SHOT_WALL, progress=stages.append)
        self.assertTrue(stages)

        def give_up(_):
            raise KeyboardInterrupt

        with self.assertRaises(KeyboardInterrupt):
            griffith.World(SHOT_WALL, progress=give_up)
        made = []
        griffith.World(SHOT_WALL).run(3, lambda done, total: made.append((done, total)))
        self.assertEqual(made, [(1, 3), (2, 3), (3, 3)])
        self.assertEqual([frame.step for frame in griffith.World(SHOT_WALL).steps(3)], [1, 2, 3])

    def test_wrong_arguments_are_refused(self):
        world = griffith.World(SHOT_WALL)
        with self.assertRaises(griffith.ArgumentError):
            world.step(-1)
        with self.assertRaises(griffith.ArgumentError):
            world.set_material(7, density=1000)
        with self.assertRaises(griffith.ArgumentError):
            world.save_recording("run.tar.zst")


@unittest.skipUnless(PROGRAM, "the library is built without pictures")
class Pictures(unittest.TestCase):
    def test_pictures_are_those_of_the_command_line(self):
        path = SOURCE / "scenes" / "wall_small.json"
        world = griffith.World(path)
        painter = griffith.Painter(world, (320, 180), view="utilization")
        for _ in world.steps(30):
            pixels = painter.paint(world)
        self.assertEqual(pixels.shape, (180, 320, 4))
        with tempfile.TemporaryDirectory() as folder:
            png = pathlib.Path(folder) / "wall.png"
            arguments = [path, "--frame", "30", "--view", "utilization", "--size", "320x180", "-o", png]
            subprocess.run([PROGRAM, "render", *arguments], check=True, capture_output=True)
            rows, size = colors_of.rows_of(png.read_bytes())
        drawn = numpy.array([list(row) for row in rows], numpy.uint8).reshape(180, 320, size)
        numpy.testing.assert_array_equal(pixels[:, :, :3], drawn[:, :, :3])

    def test_what_a_scene_lacks_is_refused(self):
        world = griffith.World(SHOT_WALL)
        with self.assertRaises(griffith.InputError):
            griffith.Painter(world, view="no_such_view")
        with self.assertRaises(griffith.ArgumentError):
            griffith.Painter(world, (0, 180))
        world.run(60)
        with self.assertRaisesRegex(griffith.ArgumentError, "before the first step"):
            griffith.Painter(world)


class Studies(unittest.TestCase):
    def test_a_sweep_is_a_table(self):
        table = griffith.sweep(SHOT_WALL, 60, {"/projectiles/0/speed": [1, 40]}, processes=2)
        self.assertEqual(list(table["/projectiles/0/speed"]), [1, 40])
        self.assertEqual(table["pieces"][0], 1)
        self.assertGreater(table["pieces"][1], 1)

    def test_a_sweep_raises_the_error_of_a_run(self):
        with self.assertRaisesRegex(griffith.InputError, "speed"):
            griffith.sweep(SHOT_WALL, 1, {"/projectiles/0/speed": [-1]}, processes=1)

    def test_the_program_of_the_readme_breaks_a_pane(self):
        program = [sys.executable, SOURCE / "examples" / "python" / "shot.py"]
        self.assertIn(".", subprocess.run(program, cwd=SOURCE, capture_output=True, text=True, check=True).stdout)

    def test_strength_is_that_of_the_material(self):
        measured, exact = example("strength_test").breaking_stress()
        self.assertAlmostEqual(measured / exact, 1, delta=0.02)

    def test_eigenvectors_point_along_the_load(self):
        angles = example("separation_axes").angles_to_load()
        self.assertGreater(len(angles), 10)
        self.assertLess(numpy.degrees(angles).max(), 1e-3)

    def test_thicker_plates_bear_faster_balls(self):
        thickness, speed = example("breaking_speed").breaking_speeds(thicknesses=(0.05, 0.2), tolerance=0.2)
        self.assertGreater(speed[1], 1.5 * speed[0])

    def test_a_data_set_holds_its_shots(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "shots.npz"
            example("shot_dataset").write_dataset(path, shots=4)
            with numpy.load(path) as data:
                self.assertEqual(data["position"].shape, (4, 2))
                self.assertEqual(len(data["pieces"]), 4)
                self.assertEqual(len(data["crack_position"]), data["first_crack"][-1])


if __name__ == "__main__":
    unittest.main()

#!/usr/bin/env python3
"""The arithmetic of tools/bench: exponents and their errors, the time to an error, turns, ratios; its commands on wrong input.

usage: bench_test.py SOURCE_FOLDER
"""
import random
import statistics
import subprocess
import sys
import tempfile
import types
import unittest
from pathlib import Path


class Fit(unittest.TestCase):
    def test_finds_the_exponent_above_a_fixed_cost(self):
        sizes = [1, 4, 16, 64, 256]
        found = fit.growth(sizes, [2 + 0.5 * x**0.8 for x in sizes])
        self.assertAlmostEqual(found.exponent, 0.8, places=4)
        self.assertAlmostEqual(found.fixed, 2.0, places=4)
        self.assertLess(found.slope, 0.6)

    def test_a_power_alone_is_the_slope(self):
        sizes = [10, 40, 160, 640]
        found = fit.growth(sizes, [3 * x**1.2 for x in sizes])
        self.assertAlmostEqual(found.slope, 1.2, places=6)
        self.assertAlmostEqual(found.exponent, 1.2, places=3)
        self.assertLess(found.slope_error, 1e-6)

    def test_the_standard_errors_are_those_of_noise(self):
        chance, sizes = random.Random(1), [1, 4, 16, 64, 256, 1024]
        found = [fit.growth(sizes, [(2 + 0.5 * x**0.8) * chance.gauss(1, 0.02) for x in sizes]) for _ in range(200)]
        true = statistics.stdev(each.exponent for each in found)
        said = statistics.mean(each.exponent_error**2 for each in found) ** 0.5
        self.assertTrue(0.7 < said / true < 1.4, f"{said} is said, {true} is true")
        self.assertAlmostEqual(statistics.mean(each.exponent for each in found), 0.8, delta=0.01)


class Error(unittest.TestCase):
    def points(self, *pairs):
        return [{"seconds": seconds, "rel_mse": value} for seconds, value in pairs]

    def test_interpolates_in_logarithms(self):
        self.assertAlmostEqual(error.seconds_for(self.points((1, 1e-1), (100, 1e-3)), 1e-2), 10.0)

    def test_does_not_extrapolate(self):
        self.assertIsNone(error.seconds_for(self.points((1, 1e-1), (100, 1e-2)), 1e-3))

    def test_a_first_point_that_is_good_enough_counts(self):
        self.assertEqual(error.seconds_for(self.points((1, 1e-4), (2, 1e-5)), 1e-3), 1)


class Search(unittest.TestCase):
    def side(self, errors):
        """A renderer whose n samples take n seconds."""
        side = object.__new__(convergence.Side)
        side.name, side.errors, side.noise, side.setting = "ours", {}, 1e-3, types.SimpleNamespace(is_quick=False, progress=types.SimpleNamespace(say=lambda text: None))
        side.picture, side.reference, rendered = None, None, []
        side.render = lambda count: rendered.append(count) or float(count)
        side.judge = lambda *_: errors[rendered[-1]]
        return side

    def test_ends_at_the_first_count_that_reaches_the_target(self):
        self.assertEqual(self.side({4: 1e-1, 8: 1e-2, 16: 1e-3}).bracket([4, 8, 16], 5e-3), [8, 16])

    def test_ends_at_a_render_that_takes_too_long(self):
        with self.assertRaises(convergence.NotReached) as raised:
            self.side({16: 1e-1, 32: 1e-2, 64: 1e-3}).bracket([16, 32, 64], 5e-3)
        self.assertEqual(raised.exception.count, 32)
        raised.exception.seconds = [32.0]
        line = convergence.error_line("", [8.0], raised.exception, 0.35, "")
        self.assertEqual((line.is_met, line.ratio), (True, None))
        self.assertIn("below 0.25", line.remark)
        self.assertIsNone(convergence.error_line("", [16.0], raised.exception, 0.35, "").is_met)

    def test_a_count_within_the_noise_of_the_long_picture_bounds_nothing(self):
        with self.assertRaises(convergence.NotReached) as raised:
            self.side({16: 1e-2, 32: 5.5e-3}).bracket([16, 32], 5e-3)
        self.assertEqual(raised.exception.count, 16)

    def test_a_line_compares_turn_by_turn(self):
        line = convergence.error_line("", [1.0, 2.0, 9.0], [4.0, 4.0, 10.0], 0.35, "")
        self.assertEqual((line.is_met, line.ratio.median), (False, 0.5))


class Turns(unittest.TestCase):
    def test_each_task_runs_once_a_turn_and_the_first_turn_does_not_count(self):
        order = []
        tasks = {name: lambda name=name: order.append(name) or len(order) for name in "AB"}
        results, failures = timing.in_turns(tasks, 2)
        self.assertEqual(order, list("ABABAB"))
        self.assertEqual((results, failures), ({"A": [3, 5], "B": [4, 6]}, {}))

    def test_a_task_that_fails_is_named_and_left_out(self):
        def fails():
            raise timing.Failed("no GL")
        results, failures = timing.in_turns({"A": fails, "B": lambda: 1}, 2)
        self.assertEqual((results, failures), ({"B": [1, 1]}, {"A": "no GL"}))

    def test_a_ratio_is_the_median_of_the_turns(self):
        self.assertEqual(vars(row.ratio_of([2, 9, 4], [1, 3, 4])), {"median": 2.0, "low": 1.0, "high": 3.0})

    def test_a_command_that_fails_says_its_last_line(self):
        with self.assertRaisesRegex(timing.Failed, "status 3: why"):
            timing.measured([sys.executable, "-c", "import sys; print('why', file=sys.stderr); sys.exit(3)"])
        with self.assertRaisesRegex(timing.Failed, "ended by signal 11"):
            timing.measured([sys.executable, "-c", "import os; os.kill(os.getpid(), 11)"])
        with self.assertRaisesRegex(timing.Failed, "wrote no picture"):
            timing.measured([sys.executable, "-c", ""], Path("no_such_picture.png"))

    def test_measures_memory_and_processor_time_of_the_process(self):
        cost = timing.measured([sys.executable, "-c", "x = bytearray(2**27); sum(range(3000000))"])
        self.assertGreater(cost.memory_mib, 128)
        self.assertTrue(0 < cost.processors < cost.seconds + 0.5)


class Commands(unittest.TestCase):
    def run_it(self, *words):
        return subprocess.run([sys.executable, *map(str, words)], capture_output=True, text=True)

    def test_wrong_input_is_status_2_and_one_line(self):
        bench = SOURCES / "tools" / "bench"
        with tempfile.NamedTemporaryFile(suffix=".glb") as file:
            file.write(b"no glTF")
            file.flush()
            for words, said in [
                    ([bench / "table", "--only", "no_such_row", "--program", sys.executable], "no_such_row is none of frame_point"),
                    ([bench / "table", "--program", "no/such/program"], "no such file"),
                    ([bench / "table", "--model", file.name, "--program", sys.executable], "is not a .glb file"),
                    ([bench / "growth", "--only", "width", "--program", sys.executable], "width is none of pixels"),
                    ([bench / "peers" / "run", "--program", sys.executable], "one of them"),
                    ([bench / "peers" / "run", file.name, "--program", sys.executable], "is not a .glb file"),
                    ([bench / "peers" / "run", "--scene", "atrium", "--peers", "nobody", "--program", sys.executable], "nobody is none of")]:
                run = self.run_it(*words)
                self.assertEqual(run.returncode, 2, run.stderr)
                self.assertIn(said, run.stderr.strip().splitlines()[-1])

    def test_rows_of_a_missing_model_are_named(self):
        run = self.run_it(SOURCES / "tools" / "bench" / "table", "--only", "frame_point,softbox_error", "--program", sys.executable)
        self.assertEqual(run.returncode, 0, run.stderr)
        self.assertEqual(run.stdout.count("not measured: needs DamagedHelmet.glb"), 2, run.stdout)


if __name__ == "__main__":
    SOURCES = Path(sys.argv.pop()).resolve()
    sys.path.insert(0, str(SOURCES / "tools" / "bench"))
    import timing
    from curves import error, fit
    from speed import convergence, row
    unittest.main()

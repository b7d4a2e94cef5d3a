"""Tests tests/validate_exact.py against known numbers, and the reader of tests/validate.py."""
import io
import math
import unittest

import validate
import validate_exact as exact


class Exact(unittest.TestCase):
    def test_norms(self):
        self.assertAlmostEqual(exact.l1([1, 2], [1, 4]), 0.4)
        self.assertAlmostEqual(exact.l2([3, 5], [3, 4]), 0.2)
        self.assertAlmostEqual(exact.linf([1, 5], [2, 4]), 0.25)
        self.assertAlmostEqual(exact.slope([0, 1, 2], [1, 3, 5]), 2)

    def test_taylor_green(self):
        for t, energy in ((0.5, 0.4540), (1, 0.2062), (2, 0.0425)):
            self.assertAlmostEqual(exact.taylor_green_energy(t, 100), energy, 4)
        fastest = .673825451  # at t = 0.5
        for place, expected in (((0.25, 0), (0, fastest, 0)),
                                ((0, 0.25), (-fastest, 0, 0)),
                                ((0, 0), (0, 0, -fastest ** 2 / 2))):
            for got, value in zip(exact.taylor_green(*place, 0.5, 100), expected):
                self.assertAlmostEqual(got, value, 8)

    def test_beltrami(self):
        self.assertAlmostEqual(exact.beltrami_energy(1, 0.01), math.exp(-0.08 * math.pi ** 2))

    def test_poiseuille(self):
        fractions = ((.0225, .17862), (.045, .33877), (.1125, .65999), (.225, .88798), (1, .99995))
        for t, fraction in fractions:  # nu = H = 1, F = 8: largest speed 1
            self.assertAlmostEqual(exact.poiseuille(0.5, t, 1, 8), fraction, 5)
        self.assertAlmostEqual(exact.poiseuille(0.25, .1125, 1, 8), .509576349, 8)
        self.assertAlmostEqual(exact.poiseuille(0.025, 4500, 1e-6, 1e-4, 0.05),
                               1e-4 * 0.05 ** 2 / 8e-6 * exact.poiseuille(0.5, 1.8, 1, 8))

    def test_couette(self):
        self.assertAlmostEqual(exact.couette(0.5, .045, 1, 1), .0955801312, 8)
        self.assertAlmostEqual(exact.couette(0.9, .0225, 1, 1), .637351888, 8)
        self.assertAlmostEqual(exact.couette(0.75, 1, 1, 1), .749976716, 8)

    def test_drops(self):
        a, b = exact.ellipse(0.0076, 100)
        self.assertAlmostEqual(a, 0.514266, 6)
        self.assertAlmostEqual(b, 1.944517, 5)
        self.assertAlmostEqual(exact.oscillating_drop_period(), 4.567374, 5)
        a, b, sigma = exact.oscillating_drop(1.14184375)
        self.assertAlmostEqual(a, math.sqrt(2), 6)
        self.assertAlmostEqual(b, math.sqrt(0.5), 6)
        self.assertAlmostEqual(sigma, 0, 5)

    def test_square_patch(self):
        for x, p in ((0.5, -0.14734274), (0.25, -0.11466983), (0.05, -0.0313350769)):
            self.assertAlmostEqual(exact.square_patch_pressure(x, 0.5), p, 6)

    def test_wave(self):
        self.assertAlmostEqual(2 * math.pi / exact.wave_frequency(1, 2), 1.13391748, 6)
        self.assertAlmostEqual(exact.wave_energy(0, 0.05, 1, 2, 0), 0.01 * 9.81 * 2 / 16)

    def test_martin_moyce(self):
        self.assertTrue(all(low <= mean <= high
                            for _, mean, low, high in exact.MARTIN_MOYCE_FRONT))
        width, scale = exact.MARTIN_MOYCE_WIDTH, math.sqrt(2 * 9.81 / exact.MARTIN_MOYCE_WIDTH)
        times = [(row[1] + 0.3) / scale for row in exact.MARTIN_MOYCE_FRONT]
        fronts = [row[0] * width for row in exact.MARTIN_MOYCE_FRONT]
        rms, within, n = exact.martin_moyce(times, fronts)
        self.assertLess(rms, 1e-9)
        self.assertEqual((within, n), (1, 22))
        late = [t * 1.1 for t in times]
        self.assertGreater(exact.martin_moyce(late, fronts)[0], 0.05)
        self.assertIsNone(exact.martin_moyce(times, [width] * len(times)))

    def test_fall(self):
        self.assertAlmostEqual(exact.fall(1, 5), 0.095)
        self.assertEqual(exact.hydrostatic(2), 19620)


class Reader(unittest.TestCase):
    def test_columns(self):
        text = "# a note\ntime (s),\"energy, kinetic (J)\"\n0,1\n0.5,2.5\n"
        columns = validate.read_columns(io.StringIO(text))
        self.assertEqual(columns["time (s)"], [0, 0.5])
        self.assertEqual(columns["energy, kinetic (J)"], [1, 2.5])
        self.assertEqual(validate.column(columns, "kinetic"), [1, 2.5])
        with self.assertRaises(validate.Missing):
            validate.column(columns, "potential")

    def test_cases_have_scenes(self):
        for case in validate.CASES:
            self.assertTrue(validate.scene_path(case.scene).exists(), case.scene)


if __name__ == "__main__":
    unittest.main()

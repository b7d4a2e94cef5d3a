"""Tests exact solutions, fits and comparisons of the validation against known numbers."""
import io
import json
import math
import random
import unittest

import validate
import validate_cases as cases
import validate_exact as exact
import validate_fits as fits


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

    def test_viscous_wave(self):
        omega = exact.wave_frequency(1, 2)
        thin, rate = exact.viscous_wave(1, 2, 1e-6)
        self.assertAlmostEqual(thin / omega, 1, 5)
        self.assertAlmostEqual(rate / (2e-6 * math.pi ** 2), 1, 2)
        self.assertEqual(exact.viscous_wave(1, 2, 0), (omega, 0))
        thick, rate = exact.viscous_wave(1, 2, 9.81 ** 0.5 / 250)
        self.assertAlmostEqual(thick, 5.51530140, 6)  # root of the equation by Newton's method
        self.assertAlmostEqual(rate, 0.220885114, 6)

    def test_ellipse_reach(self):
        for reach in (0, 0.3, 0.959, 1):
            th = math.acos(reach)
            part = (th - math.sin(th) * math.cos(th)) / math.pi
            self.assertAlmostEqual(exact.ellipse_reach(part), reach, 6)
        n = 400  # count the points of a lattice in an ellipse of semi-axes 2 and 1/2
        xs = sorted(2 * i / n for i in range(-n, n + 1) for j in range(-n, n + 1)
                    if i * i + j * j < n * n)
        self.assertAlmostEqual(xs[int(0.995 * len(xs))] / 2, exact.ellipse_reach(0.005), 2)

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

    def test_martin_moyce_height(self):
        width = exact.MARTIN_MOYCE_WIDTH
        times = [tau / math.sqrt(9.81 / width) for tau, _ in exact.MARTIN_MOYCE_HEIGHT]
        heights = [h * 2 * width for _, h in exact.MARTIN_MOYCE_HEIGHT]
        rms, n = exact.martin_moyce_height([0] + times, [2 * width] + heights)
        self.assertLess(rms, 1e-9)
        self.assertEqual(n, 17)
        rms, n = exact.martin_moyce_height(times[:9], [h + 0.02 * width for h in heights[:9]])
        self.assertAlmostEqual(rms, 0.01)
        self.assertGreater(n, 6)

    def test_fall(self):
        self.assertAlmostEqual(exact.fall(1, 5), 0.095)
        self.assertEqual(exact.hydrostatic(2), 19620)


class Fits(unittest.TestCase):
    def test_least_squares(self):
        factors, left = fits.least_squares(([1, 1, 1, 1], [0, 1, 2, 3]), [1, 3, 5, 7])
        self.assertAlmostEqual(factors[0], 1)
        self.assertAlmostEqual(factors[1], 2)
        self.assertAlmostEqual(left, 0)

    def test_damped_wave(self):
        noise = random.Random(1)
        times = [0.04 * k for k in range(227)]
        values = [0.05 * math.exp(-0.25 * t) * math.sin(5.5 * t)  # a wave on a tank that settles
                  + 0.03 * (1 - math.exp(-t / 8)) + noise.gauss(0, 5e-4) for t in times]
        omega, gamma, amplitude = fits.damped_wave(times, values, 5.541, 0.2)
        self.assertAlmostEqual(omega / 5.5, 1, 2)
        self.assertAlmostEqual(gamma / 0.25, 1, 1)
        self.assertAlmostEqual(amplitude / 0.05, 1, 1)
        clean = [0.05 * math.exp(-0.3 * t) * math.cos(5.2 * t) + 0.01 - 0.001 * t for t in times]
        omega, gamma, amplitude = fits.damped_wave(times, clean, 5.541, 0.25)
        for got, value in ((omega, 5.2), (gamma, 0.3), (amplitude, 0.05)):
            self.assertAlmostEqual(got / value, 1, 5)

    def test_undamped_wave(self):
        times = [0.05 * k for k in range(200)]
        omega, gamma, _ = fits.damped_wave(times, [math.sin(5 * t) for t in times], 5.2, 0.3)
        self.assertAlmostEqual(omega, 5, 5)
        self.assertAlmostEqual(gamma, 0, 5)

    def test_period_and_decay(self):
        times = [0.05 * k for k in range(285)]
        values = [math.exp(-0.02 * t) * math.sin(2 * math.pi * t / 4.5) for t in times]
        crossings = fits.sign_changes(times, values, after=1)
        self.assertEqual(len(crossings), 6)
        self.assertAlmostEqual(2 * exact.slope(range(6), crossings), 4.5, 3)
        tops = fits.peaks(times, values, crossings)
        self.assertAlmostEqual(tops[-1] / tops[0], math.exp(-0.02 * 9), 2)

    def test_last_quarter(self):
        self.assertEqual(fits.last_quarter([0, 1, 2, 3, 4]), [3, 4])
        self.assertEqual(fits.late_mean([0, 1, 2, 3, 4], [9, 9, 9, 1, 3]), 2)


class Reader(unittest.TestCase):
    def test_columns(self):
        text = "# a note\ntime (s),\"energy, kinetic (J)\"\n0,1\n0.5,2.5\n"
        columns = validate.read_columns(io.StringIO(text))
        self.assertEqual(columns["time (s)"], [0, 0.5])
        self.assertEqual(columns["energy, kinetic (J)"], [1, 2.5])
        self.assertEqual(cases.column(columns, "kinetic"), [1, 2.5])
        with self.assertRaises(cases.Missing):
            cases.column(columns, "potential")
        self.assertEqual(cases.row_at(columns, 0.5), 1)
        with self.assertRaises(cases.Missing):
            cases.row_at(columns, 0.4)

    def test_lines(self):
        columns = {"up.0.pressure (Pa)": [1], "up.1.pressure (Pa)": [2], "up.10.pressure (Pa)": [9]}
        self.assertEqual(cases.line(columns, "up", "pressure", 0), [1, 2])

    def test_cases_have_scenes(self):
        """The scene's own solver runs as the scene says."""
        for case in cases.CASES:
            shipped = json.loads(validate.scene_path(case.scene).read_text())
            solver = shipped["solver"]["method"]
            self.assertEqual(validate.scene_of(case, solver)["solver"], shipped["solver"],
                             case.name)

    def test_changes(self):
        scene = validate.scene_of(next(c for c in cases.CASES if c.changes), "dfsph",
                                  {"domain.max": [1, 2, 3]})
        self.assertEqual(scene["fluids"][0]["viscosity"], 1)
        self.assertEqual(scene["domain"]["max"], [1, 2, 3])
        self.assertEqual(scene["solver"], {"method": "dfsph"})


class Comparisons(unittest.TestCase):
    """Columns of the exact solutions have no error."""

    def test_oscillating_drop(self):
        times = [0.05 * k for k in range(285)]
        axes = [exact.oscillating_drop(t, steps=400) if t else (1, 1) for t in times]
        half = [math.sqrt(0.25 - 0.0025 / 48)]  # a lattice's moment lacks d^2 / 12
        columns = {"time (s)": times, "spread.x (m)": half + [a[1] / 2 for a in axes[1:]],
                   "spread.y (m)": half + [a[0] / 2 for a in axes[1:]]}
        scene = {"particles": {"spacing": 0.025}}
        errors = {r.quantity: r.value for r in cases.oscillating_drop(columns, scene)}
        self.assertLess(abs(errors["period"]), 1e-4)
        self.assertLess(abs(errors["first amplitude"]), 2e-3)
        self.assertLess(abs(errors["amplitude, change in a period"]), 1e-3)
        for error in errors["semi-axes by moments at t = 0"]:
            self.assertLess(abs(error), 1e-6)

    def test_standing_wave(self):
        omega, rate = exact.viscous_wave(1, 2, 9.81 ** 0.5 / 250)
        times = [0.04 * k for k in range(227)]
        columns = {"time (s)": times, "wave.cosine (1)": [
            0.025 * math.exp(-rate * t) * math.sin(omega * t) for t in times]}
        errors = cases.standing_wave(columns, None)
        self.assertAlmostEqual(errors[0].value, omega / exact.wave_frequency(1, 2) - 1, 6)
        self.assertAlmostEqual(errors[1].value, -0.1068134, 5)
        self.assertAlmostEqual(errors[2].value, 0, 5)
        self.assertAlmostEqual(errors[3].value, 0, 5)
        self.assertAlmostEqual(errors[4].value, 0, 5)

    def test_table(self):
        results = [cases.Result("height", 1e-3, "+m", 1e-4), cases.Result("L2", [0.01, -0.02])]
        text = validate.table({"fall": {"a": results, "b": "it stopped"}}, ["a", "b"])
        self.assertEqual(text.splitlines()[2:], [
            "| fall | height | < 0.0001 m | **+0.001 m** | failed |",
            "|  | L2 |  | +1, -2 % | failed |"])


if __name__ == "__main__":
    unittest.main()

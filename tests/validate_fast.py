#!/usr/bin/env python3
"""Runs coarse validation cases in seconds; TAP: a bound for each error, about twice what is measured.

Each case runs with the solver that does it best. The whole list, finer: tests/validate.py. First the
measuring itself, of start states that are exact.
"""
import pathlib
import sys
import tempfile

import validate
import validate_exact as exact
import validate_cases as cases
from validate_cases import CASES, Missing


def start_pressure(columns, scene):
    d, top = cases.spacing(scene), scene["bodies"][0]["max"][1]
    values = cases.line(columns, "up", "pressure", 0)
    heights = cases.points_between(3 * d, top - 3 * d, len(values))
    return exact.l2(values, [exact.hydrostatic(top - y) for y in heights])


def first(*words):
    return lambda columns, _: abs(cases.column(columns, *words)[0])


# (case, solver, error of the first row, the most it may be)
START = (
    ("hydrostatic-20", "isph", start_pressure, 1e-6),
    ("column-100m", "isph", start_pressure, 1e-6),
    ("taylor-green-jitter", "isph", first("flow-error.speed"), 1e-6),
    ("beltrami", "isph", first("flow-error.velocity"), 1e-6),
    ("standing-wave", "isph", first("wave.cosine"), 1e-9),
    ("martin-moyce", "isph", lambda columns, _: abs(
        cases.column(columns, "front.position")[0] / exact.MARTIN_MOYCE_WIDTH - 1), 1e-6),
    ("martin-moyce", "isph", lambda columns, _: abs(
        cases.column(columns, "wall2")[0] / exact.MARTIN_MOYCE_WIDTH - 2), 1e-6),
)

# (case, solver, changes of its scene, {what an error's name begins with: the most it may be})
COARSE = (
    ("free-fall", "isph", {}, {"height": 2e-7}),
    ("poiseuille", "wcsph", {"time.end": 2.25}, {"velocity": 0.015}),
    ("couette", "isph", {"time.end": 1.125}, {"velocity": 0.015}),
    ("taylor-green-jitter", "isph",
     {"particles.spacing": 0.04, "domain.max": [1, 1, 0.28], "bodies.0.max": [1, 1, 0.28],
      "time.end": 1},
     {"kinetic energy at": 0.02, "speed": 0.012}),
    ("beltrami", "isph", {"particles.spacing": 0.0625}, {"kinetic energy at": 0.036, "speed": 0.02}),
    ("elliptic-drop", "isph",
     {"particles.spacing": 0.05, "domain.max": [1.6, 2.6, 0.35], "bodies.0.height": 0.35,
      "bodies.0.center": [0, 0, 0.175]},
     {"semi-axes by moments at t = 0": 0.005, "short, long semi-axis by moments": 0.032,
      "kinetic energy": 0.024}),
    ("oscillating-drop", "isph",
     {"particles.spacing": 0.1, "domain.max": [1.8, 1.8, 0.7], "bodies.0.height": 0.7,
      "bodies.0.center": [0, 0, 0.35], "central_force.center": [0, 0, 0.35], "time.end": 7.1},
     {"period": 0.02, "first amplitude": 0.036, "amplitude, change": 0.13}),
    ("standing-wave", "isph",
     {"particles.spacing": 0.1, "domain.max": [2, 1.3, 0.7], "bodies.0.max": [2, 1, 0.7],
      "time.end": 4.6},
     {"frequency, of sqrt": 0.02, "amplitude": 0.016}),
    ("hydrostatic-20-thick", "isph",
     {"particles.spacing": 0.1, "domain.max": [0.6, 1.3, 0.6], "bodies.0.max": [0.6, 1, 0.6],
      "time.end": 3.2},
     {"pressure, L2": 0.013, "pressure on": 0.006, "volume": 0.004, "mass centre": 0.008,
      "kinetic energy": 3.6e-5}),
)


def check(number, case, solver, changes, bounds):
    """Prints a result for each bound; how many."""
    try:
        results = validate.errors_of(case, solver, changes)
    except Missing as missing:
        results = []
        print(f"# {case.name}: {missing}")
    for begin, bound in bounds.items():
        number += 1
        found = [r for r in results if r.quantity.startswith(begin)]
        good = bool(found) and all(validate.largest(r) <= bound for r in found)
        said = "; ".join(f"{r.quantity} {validate.shown(r)}" for r in found) or begin + " unknown"
        print(f"{'ok' if good else 'not ok'} {number} - {case.name}, {solver}: {said}, "
              f"at most {bound:g}", flush=True)
    return number


def case_named(name):
    return next(case for case in CASES if case.name == name)


def check_start(number, name, solver, error, bound):
    case = case_named(name)
    scene = validate.scene_of(case, solver, {"time.end": 1e-3 * case.rows})
    try:
        with tempfile.TemporaryDirectory() as folder:
            found = error(validate.measured(scene, pathlib.Path(folder)), scene)
    except Missing as missing:
        print(f"# {name}: {missing}")
        found = float("inf")
    print(f"{'ok' if found <= bound else 'not ok'} {number} - {name}, {solver}, as it starts: error "
          f"of measuring {found:.2g}, at most {bound:g}", flush=True)


def main():
    number = 0
    for start in START:
        number += 1
        check_start(number, *start)
    for name, solver, changes, bounds in COARSE:
        number = check(number, case_named(name), solver, changes, bounds)
    print(f"1..{number}")


if __name__ == "__main__":
    sys.exit(main())

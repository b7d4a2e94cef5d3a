#!/usr/bin/env python3
"""Runs the validation scenes with measured quantities and prints errors against exact solutions.

Usage: tests/validate.py [CASE...]; SPH is the program, default build/sph-render. Each case runs with
each solver of SOLVERS (default "dfsph wcsph"). What cannot be measured is reported as skipped.
"""
import collections
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile

import validate_exact as exact

SCENES = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "validation"


class Missing(Exception):
    """The measured file has no such column."""


def scene_path(name):
    return SCENES / (name + ".json")


def read_columns(file):
    """Columns of numbers by name; lines that begin with # are notes."""
    rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return {name.strip(): [float(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}


def column(columns, *words):
    """The first column whose name has all the words."""
    for name, values in columns.items():
        if all(word in name for word in words):
            return values
    raise Missing(" ".join(words))


def measured(program, case, solver, folder):
    """Runs a scene with what the case measures; columns by name, or None when it cannot be."""
    scene = json.loads(scene_path(case.scene).read_text())
    scene["measure"] = case.measure
    if scene["solver"]["method"] != solver:
        scene["solver"] = {"method": solver}
    scene["time"]["measure"] = scene["time"]["end"] / 200
    source, table = folder / (case.scene + ".json"), folder / (case.scene + ".csv")
    source.write_text(json.dumps(scene))
    run = subprocess.run([program, str(source), "-q", "-o", str(table)], text=True,
                         stderr=subprocess.PIPE, check=False)
    if run.returncode:
        raise Missing(run.stderr.strip().splitlines()[-1] if run.stderr else "the run failed")
    with open(table, encoding="utf-8") as file:
        return read_columns(file)


def energy_ratio(columns):
    """(times, kinetic energy over that at the start)"""
    energy = column(columns, "kinetic")
    return column(columns, "time"), [e / energy[0] for e in energy]


def compare_energy(columns, solution):
    times, ratios = energy_ratio(columns)
    reference = [solution(t) for t in times]
    return {"L2 of energy": exact.l2(ratios, reference),
            "energy at the end": ratios[-1] / reference[-1] - 1}


def taylor_green(columns):
    return compare_energy(columns, lambda t: exact.taylor_green_energy(t, 100))


def beltrami(columns):
    return compare_energy(columns, lambda t: exact.beltrami_energy(t, 0.01))


def square_patch(columns):
    return {"energy at the end": energy_ratio(columns)[1][-1] - 1}


def standing_wave(columns):
    nu = 9.81 ** 0.5 / 250
    start = exact.wave_energy(0, 0.05, 1, 2, nu)
    return compare_energy(columns, lambda t: exact.wave_energy(t, 0.05, 1, 2, nu) / start)


def span(columns, axis):
    """Length between the outermost particles along an axis at the end."""
    return column(columns, "max", axis)[-1] - column(columns, "min", axis)[-1]


def elliptic_drop(columns):
    a, b = exact.ellipse(column(columns, "time")[-1], 100)
    d = 0.025  # the outermost particles lie half a spacing inside
    return {"a": (span(columns, "x") + d) / 2 / a - 1, "b": (span(columns, "y") + d) / 2 / b - 1}


def free_fall(columns):
    t = column(columns, "time")[-1]
    return {"height, m": column(columns, "min", "y")[-1] - exact.fall(t, 2.225)}


def martin_moyce(columns):
    result = exact.martin_moyce(column(columns, "time"), column(columns, "front"))
    if not result:
        raise Missing("a front that passes Z = 1.44")
    return {"RMS of T": result[0], "outside of the runs": 1 - result[1]}


Case = collections.namedtuple("Case", "scene measure compare")
ENERGY = [{"quantity": "energy"}]
EXTENT = [{"quantity": "extent"}]
CASES = (
    Case("free-fall", EXTENT, free_fall),
    Case("taylor-green-lattice", ENERGY, taylor_green),
    Case("taylor-green-jitter", ENERGY, taylor_green),
    Case("beltrami", ENERGY, beltrami),
    Case("elliptic-drop", EXTENT, elliptic_drop),
    Case("square-patch", ENERGY, square_patch),
    Case("standing-wave", ENERGY, standing_wave),
    Case("martin-moyce", [{"quantity": "front"}], martin_moyce),
)


def main(names):
    program = os.environ.get("SPH", "build/sph-render")
    unknown = set(names) - {case.scene for case in CASES}
    if unknown:
        sys.exit("no such case: " + ", ".join(sorted(unknown)) + "; there are " +
                 ", ".join(case.scene for case in CASES))
    done = 0
    with tempfile.TemporaryDirectory() as folder:
        for case in CASES:
            if names and case.scene not in names:
                continue
            for solver in os.environ.get("SOLVERS", "dfsph wcsph").split():
                name = f"{case.scene:24} {solver:6}"
                try:
                    errors = case.compare(measured(program, case, solver, pathlib.Path(folder)))
                except Missing as missing:
                    print(name, "skipped:", missing, flush=True)
                    continue
                done += 1
                print(name, ", ".join(f"{k} {v:+.3g}" for k, v in errors.items()), flush=True)
    print(f"{done} cases measured")


if __name__ == "__main__":
    main(sys.argv[1:])

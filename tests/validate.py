#!/usr/bin/env python3
"""Runs the validation scenes with measured quantities and prints errors against exact solutions.

Usage: tests/validate.py [CASE...]; SPH is the program, default build/sph-render. Each case runs with
each solver of SOLVERS, by default those that the program lists but muller, and ends in a table in
Markdown. What cannot be measured says why. LIMIT is the longest that a run may take, s.
"""
import csv
import json
import os
import pathlib
import subprocess
import sys
import tempfile
import time

from validate_cases import CASES, Missing

SCENES = pathlib.Path(__file__).resolve().parent.parent / "scenes" / "validation"


def program():
    return os.environ.get("SPH", "build/sph-render")


def solvers():
    named = os.environ.get("SOLVERS")
    if named:
        return named.split()
    text = subprocess.run([program(), "list", "solvers"], text=True, stdout=subprocess.PIPE,
                          check=True).stdout
    return [row.split()[0] for row in text.splitlines()[1:] if row.split()[0] != "muller"]


def scene_path(name):
    return SCENES / (name + ".json")


def read_columns(file):
    """Columns of numbers by name; lines that begin with # are notes."""
    rows = list(csv.reader(line for line in file if not line.startswith("#")))
    return {name.strip(): [float(row[k]) for row in rows[1:]] for k, name in enumerate(rows[0])}


def change(scene, path, value):
    """Sets a key by its path, as --set does: fluids.0.viscosity"""
    *parents, last = [int(word) if word.isdigit() else word for word in path.split(".")]
    for word in parents:
        scene = scene[word]
    scene[last] = value


def scene_of(case, solver, changes=None):
    """The case's scene, with what it measures, for that solver. Frames, at which a run stops as well,
    come when rows do."""
    scene = json.loads(scene_path(case.scene).read_text())
    scene["solver"] = {"method": solver, **case.settings.get(solver, {})}
    for path, value in {**case.changes, **(changes or {})}.items():
        change(scene, path, value)
    scene["measure"] = case.measure(scene)
    scene["time"]["measure"] = case.rows
    scene["movie"].update({"start": 0, "fps": 1, "speed": case.rows})
    return scene


def measured(scene, folder):
    """Runs a scene; columns by name."""
    source, rows = folder / "scene.json", folder / "rows.csv"
    source.write_text(json.dumps(scene))
    limit = os.environ.get("LIMIT")
    try:
        run = subprocess.run([program(), str(source), "-q", "-o", str(rows)], text=True,
                             stderr=subprocess.PIPE, check=False,
                             timeout=float(limit) if limit else None)
    except subprocess.TimeoutExpired as expired:
        raise Missing(f"took longer than {expired.timeout:g} s") from expired
    if run.returncode:
        raise Missing(run.stderr.strip().splitlines()[-1] if run.stderr else "the run failed")
    with open(rows, encoding="utf-8") as file:
        return read_columns(file)


def errors_of(case, solver, changes=None):
    """Runs a case; its Results."""
    scene = scene_of(case, solver, changes)
    with tempfile.TemporaryDirectory() as folder:
        return case.compare(measured(scene, pathlib.Path(folder)), scene)


def number(value, form):
    if "%" in form:
        value *= 100
    digits = 3 if 10 <= abs(value) < 1000 else 2
    return f"{value:+.{digits}g}" if "+" in form else f"{value:.{digits}g}"


def unit(form):
    return " " + form.strip("+") if form else ""


def shown(result):
    """Value with its unit; numbers in a row share one."""
    values = result.value if isinstance(result.value, list) else [result.value]
    return ", ".join(number(value, result.form) for value in values) + unit(result.form)


def wanted(result):
    if result.asked is None:
        return ""
    bound = 100 * result.asked if "%" in result.form else result.asked
    return f"< {bound:g}{unit(result.form)}"


def largest(result):
    values = result.value if isinstance(result.value, list) else [result.value]
    return max(abs(value) for value in values)


def table(found, names):
    """found: {case: {solver: Results or what was missing}}. Bold is more than asked."""
    lines = ["| case | error of | asked | " + " | ".join(f"`{name}`" for name in names) + " |",
             "|---" * (3 + len(names)) + "|"]
    for case, by_solver in found.items():
        results = [value for value in by_solver.values() if isinstance(value, list)]
        for k, first in enumerate(results[0] if results else []):
            cells = []
            for name in names:
                value = by_solver[name]
                bold = isinstance(value, list) and first.asked and largest(value[k]) > first.asked
                cell = shown(value[k]) if isinstance(value, list) else "failed"
                cells.append(f"**{cell}**" if bold else cell)
            lines.append(" | ".join([f"| {case if k == 0 else ''}", first.quantity, wanted(first)]
                                    + cells) + " |")
    return "\n".join(lines)


def run(case, solver):
    """Results, or what was missing; printed in one line."""
    name, start = f"{case.name:24} {solver:6}", time.monotonic()
    try:
        results = errors_of(case, solver)
    except Missing as missing:
        print(name, "failed:", missing, flush=True)
        return str(missing)
    print(name, f"{time.monotonic() - start:5.0f} s ",
          "; ".join(f"{result.quantity} {shown(result)}" for result in results), flush=True)
    return results


def main(names):
    unknown = set(names) - {case.name for case in CASES}
    if unknown:
        sys.exit("no such case: " + ", ".join(sorted(unknown)) + "; there are " +
                 ", ".join(case.name for case in CASES))
    asked = solvers()
    found = {case.name: {solver: run(case, solver) for solver in asked}
             for case in CASES if not names or case.name in names}
    print("\n" + table(found, asked))
    print("\nBold is more than asked.")


if __name__ == "__main__":
    main(sys.argv[1:])

"""The validation cases: what each measures of its scene, and its errors against what is known.

A comparison takes the measured columns and the scene, and gives Results. The moments of particles
count each as a square of side d, of moment d^2 / 12.
"""
import collections
import math

import validate_exact as exact
import validate_fits as fits


class Missing(Exception):
    """Something that a comparison needs was not measured."""


# value: a number, or several; form: a unit, with + for values that have a sign, % of parts; asked: the
# bound of |value|, or None
Result = collections.namedtuple("Result", "quantity value form asked", defaults=("+%", None))
Case = collections.namedtuple("Case", "name scene measure compare rows settings changes",
                              defaults=({}, {}))
FREE = {"wcsph": {"clamp_negative": False, "artificial_viscosity": 0}}
CHANNEL = {"wcsph": {"clamp_negative": False, "artificial_viscosity": 0, "sound_speed": 15}}
PATCH = {"wcsph": {"clamp_negative": False, "artificial_viscosity": 0, "shifting": "on"}}
WAVE = {"wcsph": {"artificial_viscosity": 0}}


# Reading of columns.

def column(columns, *words):
    """The first column whose name has all the words."""
    for name, values in columns.items():
        if all(word in name for word in words):
            return values
    raise Missing(" ".join(words))


def times_of(columns):
    return column(columns, "time")


def row_at(columns, t):
    """The row of that time."""
    times = times_of(columns)
    row = min(range(len(times)), key=lambda k: abs(times[k] - t))
    if abs(times[row] - t) > 1e-6 * max(t, times[-1]):
        raise Missing(f"a row at {t} s")
    return row


def line(columns, name, quantity, row):
    """Values along a profile or across layers in one row."""
    values = []
    while f"{name}.{len(values)}." in "".join(columns):
        values.append(column(columns, f"{name}.{len(values)}.", quantity)[row])
    return values


def points_between(low, high, count):
    return [low + (high - low) * k / (count - 1) for k in range(count)]


def body_mass(scene):
    low, high = scene["bodies"][0]["min"], scene["bodies"][0]["max"]
    return scene["fluids"][0]["density"] * math.prod(b - a for a, b in zip(low, high))


def spacing(scene):
    return scene["particles"]["spacing"]


# Tanks at rest. Profiles keep 3 spacings off floor and surface, more than a support radius.

def tank_measure(scene):
    """Of a tank filled to the top of its body: energy, volume, floor, a line up its middle."""
    d, low, high = spacing(scene), scene["bodies"][0]["min"], scene["bodies"][0]["max"]
    x, z = (low[0] + high[0]) / 2, (low[2] + high[2]) / 2
    count = round((high[1] - low[1]) / d) - 5
    return [{"quantity": "energy"}, {"quantity": "volume"}, {"quantity": "mass-centre"},
            {"quantity": "wall-pressure", "name": "floor", "face": "-y"},
            {"quantity": "profile", "name": "up", "from": [x, low[1] + 3 * d, z],
             "to": [x, high[1] - 3 * d, z], "points": count}]


def tank_pressures(columns, scene):
    """(heights, exact pressures, pressures of each late row)"""
    d, depth = spacing(scene), scene["bodies"][0]["max"][1]
    late = [line(columns, "up", "pressure", k) for k in fits.last_quarter(times_of(columns))]
    ys = points_between(3 * d, depth - 3 * d, len(late[0]))
    return ys, [exact.hydrostatic(depth - y) for y in ys], late


def tank_common(columns, scene, drift_asked):
    times, depth = times_of(columns), scene["bodies"][0]["max"][1]
    surface, height = column(columns, "volume.surface"), column(columns, "mass-centre.y")
    kinetic = fits.late_mean(times, column(columns, "kinetic"))
    return [
        Result("volume below the surface, drift", fits.late_mean(times, surface) / surface[0] - 1,
               "+%", drift_asked),
        Result("mass centre, drift", fits.late_mean(times, height) / height[0] - 1, "+%",
               drift_asked),
        Result("kinetic energy / M g H", kinetic / (body_mass(scene) * 9.81 * depth), "", 1e-6)]


def mean_rows(rows):
    return [sum(values) / len(values) for values in zip(*rows)]


def hydrostatic(columns, scene):
    _, reference, late = tank_pressures(columns, scene)
    floor = fits.late_mean(times_of(columns), column(columns, "floor"))
    return [
        Result("pressure, L2 over points and time",
               exact.l2([p for row in late for p in row], reference * len(late)), "%", 0.01),
        Result("pressure, L2 of its mean", exact.l2(mean_rows(late), reference), "%"),
        Result("pressure on the floor",
               floor / exact.hydrostatic(scene["bodies"][0]["max"][1]) - 1, "+%", 0.01),
    ] + tank_common(columns, scene, 0.005)


def deep_column(columns, scene):
    ys, _, late = tank_pressures(columns, scene)
    rise = exact.slope(ys, mean_rows(late)) / -exact.hydrostatic(1)
    return [Result("slope of pressure", rise - 1, "+%", 0.01)] + tank_common(columns, scene, 0.01)


TILTED_LINES = (("across", [0.075, 0.25, 0.25], [0.425, 0.25, 0.25]),
                ("up", [0.25, 0.075, 0.25], [0.25, 0.425, 0.25]),
                ("along", [0.15, 0.4232051, 0.25], [0.35, 0.0767949, 0.25]))


def tilted_measure(_):
    return [{"quantity": "energy"}, {"quantity": "mass-centre"}] + [
        {"quantity": "profile", "name": name, "from": low, "to": high}
        for name, low, high in TILTED_LINES]


def tilted(columns, scene):
    """A full box has no surface: the pressure is that below its highest corner, and a constant."""
    g, reference, late = scene["gravity"], [], fits.last_quarter(times_of(columns))
    for _, low, high in TILTED_LINES:
        for x, y in zip(points_between(low[0], high[0], 10), points_between(low[1], high[1], 10)):
            reference.append(1000 * (g[0] * x + g[1] * (y - 0.5)))
    rows = [[p for name, _, _ in TILTED_LINES for p in line(columns, name, "pressure", k)]
            for k in late]
    level = sum(mean_rows(rows)) / len(reference) - sum(reference) / len(reference)
    drop = 0.5 * (abs(g[0]) + abs(g[1])) / 9.81
    kinetic = fits.late_mean(times_of(columns), column(columns, "kinetic"))
    moved = [fits.late_mean(times_of(columns), column(columns, "mass-centre." + axis)) -
             column(columns, "mass-centre." + axis)[0] for axis in "xy"]
    return [
        Result("pressure but for a constant, L2 over points and time",
               exact.l2([p - level for row in rows for p in row], reference * len(rows)), "%", 0.01),
        Result("mass centre moved, of H", math.hypot(*moved) / drop, "%", 0.005),
        Result("kinetic energy / M g H", kinetic / (body_mass(scene) * 9.81 * drop), "", 1e-6)]


# Decaying vortices.

def vortices_measure(flow, decay):
    return lambda scene: [
        {"quantity": "energy"},
        {"quantity": "flow-error", "flow": flow, "decay": decay}]


def vortices(columns, solution, last):
    energy = column(columns, "kinetic")
    ratios = [e / energy[0] for e in energy]
    reference = [solution(t) for t in times_of(columns)]
    at = row_at(columns, 1)
    speed = column(columns, "flow-error.speed")
    return [Result("kinetic energy at t = 1 s", ratios[at] / reference[at] - 1, "+%", 0.05),
            Result("kinetic energy, L2", exact.l2(ratios, reference), "%"),
            Result(f"speed, L1 at t = {last:g} s", speed[row_at(columns, last)], "%", 0.03)]


def taylor_green(columns, scene):
    return vortices(columns, lambda t: exact.taylor_green_energy(t, 100), scene["time"]["end"])


def beltrami(columns, scene):
    return vortices(columns, lambda t: exact.beltrami_energy(t, 0.01), scene["time"]["end"])


# Channels, nu = 0.1 m^2/s, H = 1 m.

CHANNEL_TIMES = (0.0225, 0.045, 0.1125, 0.225, 1)


def channel_measure(scene):
    return [{"quantity": "layers", "points": round(1 / spacing(scene))}]


def channel(solution):
    def compare(columns, _):
        errors = []
        told = [t for t in CHANNEL_TIMES if t / 0.1 <= times_of(columns)[-1] * (1 + 1e-9)]
        for t in told:
            row = row_at(columns, t / 0.1)
            ys = line(columns, "layers", "coordinate", row)
            errors.append(exact.l2(line(columns, "layers", "velocity.x", row),
                                   [solution(y, t / 0.1) for y in ys]))
        return [Result("velocity, L2 at t nu/H^2 = " + " ".join(f"{t:g}" for t in told), errors,
                       "%", 0.01)]
    return compare


# Drops.

def drop_measure(_):
    return [{"quantity": name} for name in ("energy", "angular-momentum", "spread", "extent")]


def moment_axis(columns, axis, row, d):
    return 2 * math.sqrt(column(columns, "spread." + axis)[row] ** 2 + d * d / 12)


def start_axes(columns, d):
    """What the measuring itself errs: the drop is round at first."""
    return Result("semi-axes by moments at t = 0",
                  [moment_axis(columns, axis, 0, d) - 1 for axis in "xy"])


def quantile_axis(columns, axis, row):
    """From the coordinates that 99.5 % of the particles do not pass, on either side."""
    high, low = column(columns, axis + ".high")[row], column(columns, axis + ".low")[row]
    return (high - low) / 2 / exact.ellipse_reach(0.005)


def outer_axis(columns, axis, row, d):
    """The outermost particles lie half a spacing inside."""
    return (column(columns, axis + ".max")[row] - column(columns, axis + ".min")[row] + d) / 2


def elliptic_drop(columns, scene):
    d, last = spacing(scene), len(times_of(columns)) - 1
    axes = exact.ellipse(times_of(columns)[-1], 100)
    energy = column(columns, "kinetic")
    ways = (("moments", lambda axis, row: moment_axis(columns, axis, row, d)),
            ("99.5 % extents", lambda axis, row: quantile_axis(columns, axis, row)),
            ("outermost particles", lambda axis, row: outer_axis(columns, axis, row, d)))
    results = []
    for name, way in ways:
        errors = [way(axis, last) / length - 1 for axis, length in zip("xy", axes)]
        results.append(Result("short, long semi-axis by " + name, errors, "+%",
                              0.01 if name == "moments" else None))
    return results + [start_axes(columns, d),
                      Result("kinetic energy, drift", energy[-1] / energy[0] - 1)]


def capillary_measure(scene):
    return [{"quantity": "spread"}, {"quantity": "pressure", "at": [0, 0, 0], "radius": 0.005}]


def oscillating_drop(columns, scene):
    """From <y^2> - <x^2>, which passes zero each half period and reaches 3/8 R^2 between; R is that
    of the particles at the start, whose number is whole."""
    times, exact_period = times_of(columns), exact.oscillating_drop_period()
    waves = [y * y - x * x for x, y in
             zip(column(columns, "spread.x"), column(columns, "spread.y"))]
    crossings = fits.sign_changes(times, waves, after=exact_period / 10)
    if len(crossings) < 3:
        raise Missing("two half periods")
    half = exact.slope(range(1, len(crossings) + 1), crossings)
    tops = fits.peaks(times, waves, [0] + crossings)
    periods = (len(tops) - 1) / 2
    radius = moment_axis(columns, "x", 0, spacing(scene))
    return [Result("period", 2 * half / exact_period - 1, "+%", 0.005),
            Result("first amplitude", tops[0] / (0.375 * radius ** 2) - 1),
            Result("amplitude, change in a period", (tops[-1] / tops[0]) ** (1 / periods) - 1),
            start_axes(columns, spacing(scene))]



def capillary_drop(columns, scene):
    """Mode 2 from <x^2> - <y^2>; the pressure is the mean of the second half."""
    fluid, radius = scene["fluids"][0], scene["bodies"][0]["radius"]
    period = 2 * math.pi / math.sqrt(8 * fluid["surface_tension"] / (fluid["density"] * radius ** 3))
    rate = 5 * fluid["viscosity"] / (fluid["density"] * radius ** 2)
    times, pressures = times_of(columns), column(columns, "pressure")
    waves = [x * x - y * y for x, y in
             zip(column(columns, "spread.x"), column(columns, "spread.y"))]
    crossings = fits.sign_changes(times, waves, after=period / 10)
    if len(crossings) < 3:
        raise Missing("two half periods")
    half = exact.slope(range(1, len(crossings) + 1), crossings)
    tops = fits.peaks(times, waves, [0] + crossings)
    decay = math.log(abs(tops[0] / tops[-1])) / ((len(tops) - 1) * half)
    late = pressures[len(pressures) // 2:]
    return [Result("period", 2 * half / period - 1), Result("damping", decay / rate - 1),
            Result("pressure", sum(late) / len(late) / (2 * fluid["surface_tension"] / radius) - 1)]


# The others.

def square_patch(columns, _):
    energy, turning = column(columns, "kinetic"), column(columns, "angular-momentum.z")
    return [Result("kinetic energy, drift", energy[-1] / energy[0] - 1, "+%", 0.004),
            Result("angular momentum, drift", turning[-1] / turning[0] - 1)]


def standing_wave(columns, _):
    """The level is A cos kx, A = 2 H <cos kx>: settling leaves it alone."""
    nu, depth, length = 9.81 ** 0.5 / 250, 1, 2
    omega, rate = exact.wave_frequency(depth, length), 2 * nu * (2 * math.pi / length) ** 2
    theory = exact.viscous_wave(depth, length, nu)
    level = [2 * depth * mean for mean in column(columns, "wave.cosine")]
    fit = fits.damped_wave(times_of(columns), level, omega, rate)
    return [Result("frequency, of sqrt(g k tanh kH)", fit[0] / omega - 1, "+%", 0.01),
            Result("damping rate, of 2 nu k^2", fit[1] / rate - 1, "+%", 0.10),
            Result("frequency, of linear viscous theory", fit[0] / theory[0] - 1, "+%", 0.01),
            Result("damping rate, of the same", fit[1] / theory[1] - 1, "+%", 0.10),
            Result("amplitude", fit[2] / 0.05 - 1)]


def martin_moyce(columns, _):
    front = exact.martin_moyce(times_of(columns), column(columns, "front.position"))
    walls = [column(columns, "wall" + name) for name in "123"]
    height = exact.martin_moyce_height(times_of(columns), [sorted(h)[1] for h in zip(*walls)])
    if not front or not height:
        raise Missing("a front that passes Z = 1.44")
    return [Result("time of the front, RMS", front[0], "%"),
            Result("front outside of the runs", 1 - front[1], "%"),
            Result("height at the wall, RMS, of 2 a", height[0], "%")]


def martin_moyce_measure(_):
    return [{"quantity": "front"}] + [
        {"quantity": "height", "name": f"wall{k}", "at": [0, 0, 0.0125 * k]} for k in (1, 2, 3)]


def free_fall(columns, _):
    fallen = exact.fall(times_of(columns)[-1], 2.225)
    return [Result("height", column(columns, "y.min")[-1] - fallen, "+m")]


def asking(*names):
    return lambda scene: [{"quantity": name} for name in names]


def wave_measure(_):
    return [{"quantity": "wave", "wavelength": 2}, {"quantity": "energy"}]


# Names in the order they run; rows is the time between rows, s.
THICK = {"fluids.0.viscosity": 1}
CASES = (
    Case("free-fall", "free-fall", asking("extent"), free_fall, 0.05),
    Case("poiseuille", "poiseuille", channel_measure,
         channel(lambda y, t: exact.poiseuille(y, t, 0.1, 1.2)), 0.025, CHANNEL),
    Case("couette", "couette", channel_measure,
         channel(lambda y, t: exact.couette(y, t, 0.1, 1.5)), 0.025, CHANNEL),
    Case("taylor-green-lattice", "taylor-green-lattice",
         vortices_measure("taylor-green", -exact.taylor_green_rate(100)), taylor_green, 0.02, FREE),
    Case("taylor-green-jitter", "taylor-green-jitter",
         vortices_measure("taylor-green", -exact.taylor_green_rate(100)), taylor_green, 0.02, FREE),
    Case("beltrami", "beltrami", vortices_measure("beltrami", 0.04 * math.pi ** 2), beltrami, 0.02,
         FREE),
    Case("elliptic-drop", "elliptic-drop", drop_measure, elliptic_drop, 0.00038),
    Case("oscillating-drop", "oscillating-drop", drop_measure, oscillating_drop, 0.05),
    Case("capillary-drop", "capillary-drop", capillary_measure, capillary_drop, 0.0066),
    Case("square-patch", "square-patch", asking("energy", "angular-momentum"), square_patch, 0.1,
         PATCH),
    Case("standing-wave", "standing-wave", wave_measure, standing_wave, 0.04, WAVE),
    Case("martin-moyce", "martin-moyce", martin_moyce_measure, martin_moyce, 0.00175),
    Case("hydrostatic-20-thick", "hydrostatic-20", tank_measure, hydrostatic, 0.1, {}, THICK),
    Case("hydrostatic-20", "hydrostatic-20", tank_measure, hydrostatic, 0.1),
    Case("hydrostatic-40-thick", "hydrostatic-40", tank_measure, hydrostatic, 0.1, {}, THICK),
    Case("hydrostatic-40", "hydrostatic-40", tank_measure, hydrostatic, 0.1),
    Case("hydrostatic-tilted", "hydrostatic-tilted", tilted_measure, tilted, 0.1),
    Case("column-100m", "column-100m", tank_measure, deep_column, 1),
)

"""Exact solutions and measured references of the validation cases, and error norms. SI units."""
import cmath
import math

PI = math.pi


# Norms over pairs of measured and exact values.

def l1(values, exact):
    """sum |e| / sum |exact|"""
    return sum(abs(v - x) for v, x in zip(values, exact)) / sum(abs(x) for x in exact)


def l2(values, exact):
    """sqrt(sum e^2 / sum exact^2)"""
    return math.sqrt(sum((v - x) ** 2 for v, x in zip(values, exact)) / sum(x * x for x in exact))


def linf(values, exact):
    """max |e| / max |exact|"""
    return max(abs(v - x) for v, x in zip(values, exact)) / max(abs(x) for x in exact)


def slope(xs, ys):
    """Least squares of y = a + b x: b."""
    n, mx, my = len(xs), sum(xs) / len(xs), sum(ys) / len(ys)
    assert n > 1
    return sum((x - mx) * (y - my) for x, y in zip(xs, ys)) / sum((x - mx) ** 2 for x in xs)


# Solutions.

def hydrostatic(depth, density=1000.0, g=9.81):
    """Pressure below a free surface, Pa."""
    return density * g * max(depth, 0.0)


def fall(t, height, g=9.81):
    """Height of a body that falls from rest, m."""
    return height - g * t * t / 2


def taylor_green_rate(re, u=1.0, length=1.0):
    """b of exp(b t), the decay of velocity: -8 pi^2 nu / L^2, nu = U L / Re."""
    return -8 * PI * PI * u / (re * length)


def taylor_green(x, y, t, re, u=1.0, length=1.0):
    """(u, v, p / rho)"""
    f, k = math.exp(taylor_green_rate(re, u, length) * t), 2 * PI / length
    return (-u * f * math.cos(k * x) * math.sin(k * y), u * f * math.sin(k * x) * math.cos(k * y),
            -(u * f) ** 2 / 4 * (math.cos(2 * k * x) + math.cos(2 * k * y)))


def taylor_green_energy(t, re, u=1.0, length=1.0):
    """Kinetic energy over that at the start."""
    return math.exp(2 * taylor_green_rate(re, u, length) * t)


def beltrami_energy(t, nu, length=1.0):
    """The same of the ABC flow: exp(-2 nu k^2 t)."""
    return math.exp(-2 * nu * (2 * PI / length) ** 2 * t)


def poiseuille(y, t, nu, force, width=1.0, terms=200):
    """Velocity after the force per mass F began (Morris et al. 1997), m/s."""
    u = force / (2 * nu) * y * (width - y)
    for n in range(terms):
        k = (2 * n + 1) * PI / width
        u -= 4 * force / (nu * width * k ** 3) * math.sin(k * y) * math.exp(-nu * k * k * t)
    return u


def couette(y, t, nu, wall, width=1.0, terms=200):
    """Velocity after the upper wall began to move (Morris et al. 1997), m/s."""
    u = wall * y / width
    for n in range(1, terms):
        u += (2 * wall / (n * PI) * (-1) ** n * math.sin(n * PI * y / width) *
              math.exp(-nu * (n * PI / width) ** 2 * t))
    return u


def _runge_kutta(rates, state, t, steps):
    h = t / steps
    for _ in range(steps):
        def moved(k, part):
            return [s + part * h * r for s, r in zip(state, k)]
        k1 = rates(state)
        k2 = rates(moved(k1, 0.5))
        k3 = rates(moved(k2, 0.5))
        k4 = rates(moved(k3, 1.0))
        state = [s + h / 6 * (a + 2 * b + 2 * c + d)
                 for s, a, b, c, d in zip(state, k1, k2, k3, k4)]
    return state


def ellipse(t, rate, radius=1.0, steps=4000):
    """Semi-axes (a, b) of the drop with v = A (-x, y) at first (Monaghan 1994), m:
    a' = -a A, A' = A^2 (a^4 - R^4) / (a^4 + R^4), a b = R^2."""
    def rates(s):
        a4, r4 = s[0] ** 4, radius ** 4
        return [-s[0] * s[1], s[1] ** 2 * (a4 - r4) / (a4 + r4)]
    a = _runge_kutta(rates, [radius, rate], t, steps)[0]
    return a, radius * radius / a


def ellipse_reach(part):
    """x / a beyond which that part of an ellipse's area lies: (th - sin th cos th) / pi, x = a cos th."""
    low, high = 0.0, PI
    for _ in range(60):
        th = (low + high) / 2
        if (th - math.sin(th) * math.cos(th)) / PI < part:
            low = th
        else:
            high = th
    return math.cos(low)


def oscillating_drop(t, sigma=0.5, omega=1.0, radius=1.0, steps=4000):
    """(a, b, sigma) under the force -omega^2 x (Monaghan & Rafiee 2013)."""
    def rates(s):
        a2, b2 = s[0] ** 2, s[1] ** 2
        return [s[2] * s[0], -s[2] * s[1], (s[2] ** 2 + omega ** 2) * (b2 - a2) / (a2 + b2)]
    return tuple(_runge_kutta(rates, [radius, radius, sigma], t, steps))


def oscillating_drop_period(sigma=0.5, omega=1.0):
    """sigma changes its sign a quarter of a period after the start."""
    low, high = 0.1 / omega, 3.0 / omega
    for _ in range(50):
        middle = (low + high) / 2
        if oscillating_drop(middle, sigma, omega, steps=800)[2] > 0:
            low = middle
        else:
            high = middle
    return 4 * low


def square_patch_pressure(x, y, omega=1.0, length=1.0, terms=100):
    """p / rho of the rotating square at the start, x and y from its corner (Colagrossi 2005)."""
    total = 0.0
    for m in range(1, 2 * terms, 2):
        for n in range(1, 2 * terms, 2):
            total -= (32 * (omega * length) ** 2 / (m * n * PI ** 4 * (m * m + n * n)) *
                      math.sin(m * PI * x / length) * math.sin(n * PI * y / length))
    return total


def wave_frequency(depth, length, g=9.81):
    """Angular frequency of a small wave: omega^2 = g k tanh kH."""
    k = 2 * PI / length
    return math.sqrt(g * k * math.tanh(k * depth))


def viscous_wave(depth, length, nu, g=9.81):
    """(angular frequency, damping rate) of the small wave in a viscous fluid with a free surface, s:
    (s + 2 nu k^2)^2 + omega^2 = 4 nu^2 k^4 sqrt(1 + s / (nu k^2)) (Lamb, Hydrodynamics, art. 349, of
    deep water). Without the right side, which counts the vorticity below the surface, the damping
    is 2 nu k^2."""
    rate, omega = nu * (2 * PI / length) ** 2, wave_frequency(depth, length, g)
    s = -2 * rate + 1j * omega
    for _ in range(100 if nu > 0 else 0):
        s = -2 * rate + 1j * cmath.sqrt(omega ** 2 - 4 * rate ** 2 * cmath.sqrt(1 + s / rate))
    return s.imag, -s.real


def wave_energy(t, amplitude, depth, length, nu, g=9.81):
    """Kinetic energy per density and thickness of a viscous standing wave, J m/kg:
    eps^2 g H^2 L / 32 (1 + cos 2 omega t) exp(-4 nu k^2 t), eps = 2 A / H."""
    k, eps = 2 * PI / length, 2 * amplitude / depth
    return (eps ** 2 * g * depth ** 2 * length / 32 *
            (1 + math.cos(2 * wave_frequency(depth, length, g) * t)) * math.exp(-4 * nu * k * k * t))


# Experiment: J. C. Martin and W. J. Moyce, "An experimental study of the collapse of liquid columns
# on a rigid horizontal plane", Phil. Trans. R. Soc. A 244 (1952) 312-324,
# doi:10.1098/rsta.1952.0006. Table 2: column of width a = 2.25 in and height 2 a; front Z = z/a,
# T = t sqrt(2 g/a): mean, least and greatest of the runs. Every run's clock was shifted so that
# T = 1.19 at Z = 1.44.
MARTIN_MOYCE_WIDTH = 0.05715
MARTIN_MOYCE_FRONT = (
    (1.11, 0.41, 0.30, 0.48), (1.22, 0.84, 0.75, 0.91), (1.44, 1.19, 1.19, 1.19),
    (1.67, 1.43, 1.39, 1.44), (1.89, 1.63, 1.57, 1.67), (2.11, 1.83, 1.75, 1.88),
    (2.33, 1.98, 1.90, 2.02), (2.56, 2.20, 2.04, 2.29), (2.78, 2.32, 2.21, 2.39),
    (3.00, 2.51, 2.38, 2.66), (3.22, 2.65, 2.53, 2.74), (3.44, 2.83, 2.69, 2.93),
    (3.67, 2.97, 2.86, 3.08), (3.89, 3.11, 2.94, 3.25), (4.11, 3.33, 3.13, 3.46),
    (5.00, 4.02, 3.90, 4.09), (5.89, 4.44, 4.37, 4.50), (7.00, 5.09, 5.01, 5.16),
    (8.00, 5.69, 5.60, 5.76), (9.00, 6.30, 6.25, 6.34), (10.0, 6.83, 6.77, 6.90),
    (11.0, 7.44, 7.34, 7.51), (12.0, 8.08, 8.02, 8.12), (13.0, 8.67, 8.60, 8.73),
    (14.0, 9.31, 9.26, 9.36))
# Table 6: height H = h/(2 a) left at the back wall, tau = t sqrt(g/a).
MARTIN_MOYCE_HEIGHT = (
    (0.56, 0.94), (0.77, 0.89), (0.93, 0.83), (1.08, 0.78), (1.28, 0.72), (1.46, 0.67),
    (1.66, 0.61), (1.84, 0.56), (2.00, 0.50), (2.21, 0.44), (2.45, 0.39), (2.70, 0.33),
    (3.06, 0.28), (3.44, 0.22), (4.20, 0.17), (5.25, 0.11), (7.40, 0.06))


def crossing(times, values, level):
    """When a rising series first reaches the level, interpolated; None when it never does."""
    for k in range(1, len(values)):
        if values[k - 1] < level <= values[k]:
            part = (level - values[k - 1]) / (values[k] - values[k - 1])
            return times[k - 1] + part * (times[k] - times[k - 1])
    return None


def interpolated(xs, ys, x):
    """y at x of a piecewise linear curve with rising xs; None outside of it."""
    for k in range(1, len(xs)):
        if xs[k - 1] <= x <= xs[k]:
            return ys[k - 1] + (x - xs[k - 1]) / (xs[k] - xs[k - 1]) * (ys[k] - ys[k - 1])
    return None


def martin_moyce_height(times, heights, width=MARTIN_MOYCE_WIDTH, g=9.81):
    """Compares the height at the back wall, m, with Table 6. Gives (RMS of the error of
    h / (2 a), number of rows compared), or None."""
    taus = [t * math.sqrt(g / width) for t in times]
    found = [(interpolated(taus, heights, tau), h) for tau, h in MARTIN_MOYCE_HEIGHT]
    errors = [height / (2 * width) - h for height, h in found if height is not None]
    return (math.sqrt(sum(e * e for e in errors) / len(errors)), len(errors)) if errors else None


def martin_moyce(times, fronts, width=MARTIN_MOYCE_WIDTH, g=9.81):
    """Compares the front z(t), m, with Table 2, clocks aligned at Z = 1.44. Gives (RMS of the
    relative error of T, fraction of Z with T within the runs, number of Z compared)."""
    scale = math.sqrt(2 * g / width)
    ts, zs = [t * scale for t in times], [z / width for z in fronts]
    start = crossing(ts, zs, 1.44)
    if start is None:
        return None
    errors, within = [], 0
    for z, mean, least, most in MARTIN_MOYCE_FRONT:
        t = crossing(ts, zs, z)
        if z <= 1.44 or t is None:
            continue
        t += 1.19 - start
        errors.append(t / mean - 1)
        within += least <= t <= most
    n = len(errors)
    return (math.sqrt(sum(e * e for e in errors) / n), within / n, n) if n else None

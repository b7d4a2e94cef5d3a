"""Fits of the validation cases: least squares, damped oscillations, crossings, means at the end."""
import math


def solve(matrix, right):
    """Gaussian elimination with row exchanges; both are changed."""
    n = len(right)
    for k in range(n):
        pivot = max(range(k, n), key=lambda row: abs(matrix[row][k]))
        matrix[k], matrix[pivot] = matrix[pivot], matrix[k]
        right[k], right[pivot] = right[pivot], right[k]
        for row in range(k + 1, n):
            part = matrix[row][k] / matrix[k][k]
            right[row] -= part * right[k]
            matrix[row] = [a - part * b for a, b in zip(matrix[row], matrix[k])]
    for k in reversed(range(n)):
        known = sum(matrix[k][j] * right[j] for j in range(k + 1, n))
        right[k] = (right[k] - known) / matrix[k][k]
    return right


def least_squares(bases, values):
    """Coefficients of the functions in bases (each a list of values), and the sum of squares left."""
    n = len(bases)
    matrix = [[sum(a * b for a, b in zip(bases[i], bases[j])) for j in range(n)] for i in range(n)]
    factors = solve(matrix, [sum(a * v for a, v in zip(base, values)) for base in bases])
    fitted = [sum(f * x for f, x in zip(factors, row)) for row in zip(*bases)]
    return factors, sum((v - x) ** 2 for v, x in zip(values, fitted))


def _damped(times, values, omega, gamma):
    end = times[-1]
    decay = [math.exp(-gamma * t) for t in times]
    bases = ([d * math.cos(omega * t) for d, t in zip(decay, times)],
             [d * math.sin(omega * t) for d, t in zip(decay, times)],
             [1.0] * len(times), [t / end for t in times], [(t / end) ** 2 for t in times])
    return least_squares(bases, values)


def damped_wave(times, values, omega, gamma):
    """(omega, gamma, amplitude at time 0) of e^(-gamma t) cos(omega t + phase) in values that also
    drift as a parabola of time, by least squares; from a guess of omega within 10 % and of gamma."""
    best = (omega, gamma)
    least = _damped(times, values, *best)[1]
    steps = [0.1 * omega, 0.5 * gamma + 1 / times[-1]]
    while steps[0] > 1e-7 * omega:
        around = [(best[0] + i * steps[0], best[1] + j * steps[1])
                  for i in (-1, 0, 1) for j in (-1, 0, 1) if i or j]
        left, near = min((_damped(times, values, *at)[1], at) for at in around)
        if left < least:
            least, best = left, near
        else:
            steps = [step / 2 for step in steps]
    factors = _damped(times, values, *best)[0]
    return best[0], best[1], math.hypot(factors[0], factors[1])


def sign_changes(times, values, after=0.0):
    """When the values pass through zero, later than `after`, interpolated."""
    found = []
    for k in range(1, len(values)):
        low, high = values[k - 1], values[k]
        if (low < 0) != (high < 0):
            t = times[k - 1] + low / (low - high) * (times[k] - times[k - 1])
            if t > after:
                found.append(t)
    return found


def peaks(times, values, crossings):
    """Largest |value| between crossings, one for each pair of neighbours."""
    return [max(abs(v) for t, v in zip(times, values) if start <= t <= end)
            for start, end in zip(crossings, crossings[1:])]


def last_quarter(times):
    """Indices of the times in the last 25 %."""
    return [k for k, t in enumerate(times) if t >= 0.75 * times[-1] * (1 - 1e-9)]


def late_mean(times, values):
    """Mean over the last 25 % of the time."""
    late = last_quarter(times)
    return sum(values[k] for k in late) / len(late)

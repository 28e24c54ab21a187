#!/usr/bin/env python3
"""Exact figures of the shelf's cases, by other means than Plumb's: closed forms, series and shooting.

    python3 exact.py            # all of them
    python3 exact.py elastica   # some, by name

Each function prints the figures that reference files beside this one have in their rows or in those of [exact], and the
intermediate ones that they are told apart by. Only Python's standard library is needed; all is in metres, newtons,
kilograms and seconds unless a docstring says otherwise.
"""

import math
import sys

# ---------------------------------------------------------------------------------------------- tools


def root(f, a, b, tolerance=1e-15):
    """Of f between a and b, where it changes its sign: bisection with Illinois's secants."""
    fa, fb = f(a), f(b)
    if fa == 0 or fb == 0:
        return a if fa == 0 else b
    assert fa * fb < 0, (a, fa, b, fb)
    for _ in range(200):
        c = b - fb * (b - a) / (fb - fa)
        fc = f(c)
        if fc * fb < 0:
            a, fa = b, fb
        else:
            fa /= 2
        b, fb = c, fc
        if fb == 0 or abs(b - a) <= tolerance * max(1, abs(b)):
            break
    return b


def roots(f, start, step, count):
    """The first roots above a start that are farther apart than the step."""
    found, x = [], start
    while len(found) < count:
        if f(x) * f(x + step) < 0:
            found.append(root(f, x, x + step))
        x += step
    return found


def newton(f, x, size=1e-7):
    """A root of several equations, from near it, with differences for derivatives."""
    for _ in range(50):
        r = f(x)
        columns = []
        for k in range(len(x)):
            h = size * max(1, abs(x[k]))
            moved = list(x)
            moved[k] += h
            columns.append([(a - b) / h for a, b in zip(f(moved), r)])
        step = solve([[columns[k][i] for k in range(len(x))] for i in range(len(r))], r)
        x = [a - b for a, b in zip(x, step)]
        if max(abs(s) / max(1, abs(a)) for s, a in zip(step, x)) < 1e-14:
            break
    return x


def solve(matrix, right):
    """Gauss's elimination with pivots."""
    n = len(right)
    rows = [list(row) + [b] for row, b in zip(matrix, right)]
    for i in range(n):
        p = max(range(i, n), key=lambda k: abs(rows[k][i]))
        rows[i], rows[p] = rows[p], rows[i]
        for k in range(i + 1, n):
            f = rows[k][i] / rows[i][i]
            rows[k] = [a - f * b for a, b in zip(rows[k], rows[i])]
    x = [0.0] * n
    for i in reversed(range(n)):
        x[i] = (rows[i][n] - sum(rows[i][k] * x[k] for k in range(i + 1, n))) / rows[i][i]
    return x


def runge_kutta(rate, y, length, steps):
    """The classical method of order four."""
    h = length / steps
    for k in range(steps):
        s = k * h
        a = rate(s, y)
        b = rate(s + h / 2, [u + h / 2 * v for u, v in zip(y, a)])
        c = rate(s + h / 2, [u + h / 2 * v for u, v in zip(y, b)])
        d = rate(s + h, [u + h * v for u, v in zip(y, c)])
        y = [u + h / 6 * (p + 2 * q + 2 * r + t) for u, p, q, r, t in zip(y, a, b, c, d)]
    return y


def elliptic(k):
    """Complete integrals K and E of modulus k, by the arithmetic-geometric mean."""
    a, b, c, weight, total = 1.0, math.sqrt(1 - k * k), k, 0.5, 0.0
    while True:
        total += weight * c * c
        if abs(c) < 1e-16:
            break
        a, b, c, weight = (a + b) / 2, math.sqrt(a * b), (a - b) / 2, 2 * weight
    K = math.pi / (2 * a)
    return K, K * (1 - total)


def jacobi(u, k):
    """sn, cn and dn of u of modulus k, by descending Landen transformations."""
    a, c, b = [1.0], [k], math.sqrt(1 - k * k)
    while abs(c[-1]) > 1e-16:
        a_next = (a[-1] + b) / 2
        c.append((a[-1] - b) / 2)
        b = math.sqrt(a[-1] * b)
        a.append(a_next)
    phi = 2 ** (len(a) - 1) * a[-1] * u
    for n in range(len(a) - 1, 0, -1):
        phi = (phi + math.asin(max(-1, min(1, c[n] / a[n] * math.sin(phi))))) / 2
    sn, cn = math.sin(phi), math.cos(phi)
    return sn, cn, math.sqrt(1 - (k * sn) ** 2)


def rows(values, digits=10):
    for row in values:
        print("  [" + ", ".join(f"{x:.{digits}g}" if isinstance(x, float) else str(x) for x in row) + "],")


# ---------------------------------------------------------------------------------------------- the plane rod


class Rod:
    """A rod of length L in the plane that stretches and bends but does not shear, of either strain of a cable.

    r' = λ (cos θ, sin θ). The force F in it obeys F' = -q, its moment M' = -λ (cos θ F_y - sin θ F_x), with s and q by
    the undeformed length. Engineering strain and material curvature: N = EA (λ - 1), θ' = M/EI. Green's strain and
    geometric curvature: W = EA (λ² - 1)²/8 + EI θ'²/(2 λ²), so that M = EI θ'/λ² and N = EA λ (λ² - 1)/2 - M² λ/EI.
    """

    def __init__(self, EA, EI, L, strain="engineering", steps=2000):
        self.EA, self.EI, self.L, self.strain, self.steps = EA, EI, L, strain, steps

    def stretch(self, N, M):
        if math.isinf(self.EA):
            return 1.0
        if self.strain == "engineering":
            return 1 + N / self.EA
        x = 1 + N / self.EA
        for _ in range(50):
            f = self.EA * x * (x * x - 1) / 2 - M * M * x / self.EI - N
            x_next = x - f / (self.EA * (3 * x * x - 1) / 2 - M * M / self.EI)
            if abs(x_next - x) < 1e-16:
                break
            x = x_next
        return x

    def rate(self, q):
        """Of x, y, θ, M, F_x, F_y over s."""

        def of(s, state):
            _, _, angle, M, Fx, Fy = state
            c, n = math.cos(angle), math.sin(angle)
            x = self.stretch(Fx * c + Fy * n, M)
            turn = M / self.EI if self.strain == "engineering" else M * x * x / self.EI
            qx, qy = q(angle)
            return [x * c, x * n, turn, -x * (c * Fy - n * Fx), -qx, -qy]

        return of

    def clamped(self, force, tip_angle, q=lambda angle: (0.0, 0.0), moment=0.0):
        """Tip of a rod that is clamped along x at its first end: x, y, θ. `force` and `q` are functions of the angle
        there; `tip_angle` is near the answer."""

        def back(angle):
            Fx, Fy = force(angle)
            rate = self.rate(q)
            return runge_kutta(
                lambda s, y: [-v for v in rate(s, y)], [0.0, 0.0, angle, moment, Fx, Fy], self.L, self.steps)

        a, b = tip_angle, tip_angle + 1e-4
        fa, fb = back(a)[2], back(b)[2]
        for _ in range(60):
            if fb == fa or abs(fb) < 1e-14:
                break
            a, b, fa = b, b - fb * (b - a) / (fb - fa), fb
            fb = back(b)[2]
        end = back(b)
        return -end[0], -end[1], b


def followed(of_load, loads, first_angle=0.0, parts=8):
    """Solutions at rising loads, each from the one before, through some loads between."""
    found, angle, before, earlier = [], first_angle, 0.0, None
    for load in loads:
        for k in range(1, parts + 1):
            now = before + (load - before) * k / parts
            solution = of_load(now, angle if earlier is None else 2 * angle - earlier)
            earlier, angle = angle, solution[2]
        before = load
        earlier = None
        found.append((load, *solution))
    return found


def dead(fx, fy):
    return lambda angle: (fx, fy)


def follower(fx, fy):
    return lambda angle: (fx * math.cos(angle) - fy * math.sin(angle), fx * math.sin(angle) + fy * math.cos(angle))


# ---------------------------------------------------------------------------------------------- statics


def elastica_inextensible(a):
    """Tip of an inextensible cantilever of length 1 and EI 1 under a force of size a across: w, u. The angle at the
    tip solves ∫ dφ/sqrt(1 - k² sin² φ) = sqrt(a), with 2 k² = 1 + sin of it."""

    def incomplete(k, of_sn):
        # ∫ from sin φ = 1/(k sqrt 2) to the quarter turn; smooth, by Gauss and Legendre on parts.
        start = math.asin(1 / (k * math.sqrt(2)))
        nodes = ((-0.9061798459386640, 0.2369268850561891), (-0.5384693101056831, 0.4786286704993665), (0.0, 0.5688888888888889),
                 (0.5384693101056831, 0.4786286704993665), (0.9061798459386640, 0.2369268850561891))
        parts, total = 200, 0.0
        h = (math.pi / 2 - start) / parts
        for p in range(parts):
            for x, w in nodes:
                total += w * h / 2 * of_sn(math.sin(start + h * (p + (x + 1) / 2)))
        return total

    k = root(lambda k: incomplete(k, lambda s: 1 / math.sqrt(1 - (k * s) ** 2)) - math.sqrt(a),
             math.sqrt(0.5) + 1e-12, 1 - 1e-12)
    second = incomplete(k, lambda s: math.sqrt(1 - (k * s) ** 2))
    w = 1 - 2 * second / math.sqrt(a)
    u = 1 - math.sqrt(2 * (2 * k * k - 1) / a)
    return abs(w), u


def elastica():
    """load PL²/EI, tip x = 1 - u/L, y = w/L"""
    found = []
    for a in (1, 2, 5, 10):
        w, u = elastica_inextensible(a)
        shot = followed(lambda load, angle: Rod(math.inf, 1.0, 1.0).clamped(dead(0.0, load), angle), [float(a)])[0]
        assert abs(shot[2] - w) < 1e-10 and abs(1 - shot[1] - u) < 1e-10, (shot, w, u)
        found.append((a, 1 - u, w))
    rows(found)


def gerstmayr_irschik():
    """of each strain: tip x, y for the force 3 EI/L²"""
    EI, EA, L = 2.07e11 * 0.1**4 / 12, 2.07e11 * 0.1**2, 2.0
    for strain in ("green", "engineering"):
        rod = Rod(EA, EI, L, strain)
        _, x, y, _ = followed(lambda load, angle: rod.clamped(dead(0.0, load), angle), [3 * EI / L**2])[0]
        print(strain)
        rows([(1, x, y)], 13)


def princeton():
    """load in N, tip displacement along the force, of Green's strain"""
    h, t, E, L = 12.3777e-3, 3.2024e-3, 71.7e9, 0.508
    for axis, I in (("weak", h * t**3 / 12), ("strong", t * h**3 / 12)):
        rod = Rod(E * h * t, E * I, L, "green")
        print(axis)
        rows([(load, y) for load, x, y, _ in
              followed(lambda f, angle: rod.clamped(dead(0.0, f), angle), [8.896, 13.345])])
        G = E / (2 * 1.31)
        print("  shear adds F L/(5/6 G A):", [f * L / (5 / 6 * G * h * t) for f in (8.896, 13.345)])


def roll_up():
    """load in shares of 2πEI/L, tip x, y: L = 2, square section of 0.1, E = 2.07e11; both strains in closed form"""
    L, h, E = 2.0, 0.1, 2.07e11
    EI, EA = E * h**4 / 12, E * h**2
    for strain in ("engineering", "green"):
        found = []
        for share in (0.25, 0.5, 0.75, 1.0):
            M = share * 2 * math.pi * EI / L
            x2 = 1 + 2 * M**2 / (EA * EI) if strain == "green" else 1.0
            angle, radius = M * x2 * L / EI, math.sqrt(x2) * EI / (M * x2)
            found.append((share, radius * math.sin(angle), radius * (1 - math.cos(angle))))
        print(strain)
        rows(found)


def roll_up_rod():
    """load t = ML/EI in rad, tip x, y of a length of 1"""
    rows([(t, math.sin(t) / t, (1 - math.cos(t)) / t) for t in (1, 2, 3, 4, 5, 6)])


def buckled_column():
    """load P/Pcr, tip across, x, in m; of the inextensible column, and of one that stretches"""
    L, EI, EA = 0.5, 2e11 * 5.69531e-10, 2e11 * 3.375e-4
    critical = math.pi**2 * EI / (4 * L * L)
    found, stretched = [], []
    for p in (1.015, 1.063, 1.152, 1.293, 1.884, 2.541):
        k = root(lambda k: (2 * elliptic(k)[0] / math.pi) ** 2 - p, 1e-6, 0.999999)
        K, E = elliptic(k)
        found.append((p, 2 * k / K * L, (2 * E / K - 1) * L))
        x, y, _ = Rod(EA, EI, L).clamped(dead(-p * critical, 0.0), 2 * math.asin(k))
        stretched.append((p, abs(y), x))
    rows(found)
    print("of one that stretches")
    rows(stretched)


def uniform_load():
    """load K = qL³/EI, tip x, y in m: L = 0.5, EI = 0.01, EA = 1200; dead, and following the normal"""
    L, EI, EA = 0.5, 1.2e7 * 0.01**4 / 12, 1.2e7 * 0.01**2
    for name, EA_of in (("inextensible", math.inf), ("EA = 1200 N", EA)):
        rod = Rod(EA_of, EI, L)
        for kind, loads, q in (("dead", [1.0, 5.0, 13.0, 25.0], dead), ("follower", [1.0, 5.0, 13.0], follower)):
            print(kind, name)
            rows([(K, x, y) for K, x, y, _ in followed(
                lambda K, angle: rod.clamped(dead(0.0, 0.0), angle, q(0.0, K * EI / L**3)), loads)])


def follower_tip():
    """load a = FL²/EI, tip x, y, cosine and sine of its turn, and the turn; inextensible, L = 1"""
    rod = Rod(math.inf, 1.0, 1.0)
    found = followed(lambda a, angle: rod.clamped(follower(0.0, a), angle), [1.0, 2.0, 4.0, 8.0], parts=16)
    rows([(a, x, y, math.cos(turn), math.sin(turn), turn) for a, x, y, turn in found])


def suspended_cable():
    """sag of an elastic catenary whose length is its span"""
    l0, g, density, E = 325 / 2, 9.81, 2844.23, 5.7e10
    e = density * g / E
    a = root(lambda a: a * math.asinh(l0 / a) + e * a * l0 - l0, 100.0, 1e5)
    print(f"  {a * (math.sqrt(1 + (l0 / a) ** 2) - 1) + e * l0 * l0 / 2:.10g}")


def green_bar():
    """load F/EA in compression, tip x of a length of 1: the greatest root of λ³ - λ + 2F/EA = 0"""
    rows([(f, root(lambda x: x**3 - x + 2 * f, 1 / math.sqrt(3), 1.0) if f else 1.0)
          for f in (0.05, 0.1, 0.15, 0.19)])


def beam_under_its_weight():
    """deflection of the middle on two fixed hinges, and of the tip of a cantilever; beside 5qL⁴/384EI and qL⁴/8EI"""
    L, EA, EI, q = 10.0, 1.5e9, 1e7, 100 * 9.80665
    for strain in ("green", "engineering"):
        half = Rod(EA, EI, L / 2, strain)

        def ends(x):
            end = runge_kutta(half.rate(dead(0.0, q)), [0.0, 0.0, 0.0, x[0] * 1e4, x[1] * 1e4, 0.0], L / 2, 2000)
            return [end[0] - L / 2, end[3] * 1e-4]

        M, H = newton(ends, [-q * L * L / 8 * 1e-4, 0.5])
        end = runge_kutta(half.rate(dead(0.0, q)), [0.0, 0.0, 0.0, M * 1e4, H * 1e4, 0.0], L / 2, 2000)
        tip = Rod(EA, EI, L, strain).clamped(dead(0.0, 0.0), 0.016, dead(0.0, q))
        print(strain, "middle", abs(end[1]), "tension", H * 1e4, "cantilever", tip[1])
    print("linear", 5 * q * L**4 / (384 * EI), q * L**4 / (8 * EI))


# ---------------------------------------------------------------------------------------------- vibrations


def beams():
    """mode, ω/sqrt(EI/ρAL⁴) of clamped-free and of free-free beams: cos βL cosh βL = ∓1"""
    for name, sign in (("clamped-free", 1), ("free-free", -1)):
        print(name)
        beta = roots(lambda b: math.cos(b) + sign / math.cosh(b), 1.0, 0.01, 4)
        rows([(k + 1, b * b) for k, b in enumerate(beta)])


def piano_wire():
    """mode, frequency in Hz of a pinned wire in tensions of 0 and 10 N"""
    r, L, E, density = 5e-3, 2.0, 2e11, 7800
    A, EI = math.pi * r * r, E * math.pi * r**4 / 4
    for T in (0, 10):
        print("tension", T)
        rows([(n, n / (2 * L) * math.sqrt((T + EI * (n * math.pi / L) ** 2) / (density * A))) for n in range(1, 11)])


def taut_string():
    """mode, frequency in Hz of a string of 1 m in either tension"""
    for T in (6171.050459855, 12345.2954376):
        rows([(n, n / 2 * math.sqrt(T / (7800 * 5.026e-5))) for n in (1, 2, 3)])


def hanging_chain():
    """mode, ω in rad/s: zeros of J0(2 ω sqrt(L/g))"""
    def bessel(x):
        term = total = 1.0
        for k in range(1, 80):
            term *= -((x / 2) ** 2) / k**2
            total += term
        return total

    rows([(n + 1, z / 2 * math.sqrt(9.81)) for n, z in enumerate(roots(bessel, 1.0, 0.1, 4))])


def rotating_beam():
    """first two flapping μ and lagging sqrt(μ² - η²), at η: Frobenius's series of w'''' = η²/2 ((1 - x²) w')' + μ² w"""

    def free_end(eta, mu):
        ends = []
        for second, third in ((1.0, 0.0), (0.0, 1.0)):
            a = [0.0, 0.0, second, third]
            for n in range(160):
                a.append((eta**2 / 2 * ((n + 2) * (n + 1) * a[n + 2] - n * (n + 1) * a[n]) + mu**2 * a[n]) /
                         ((n + 4) * (n + 3) * (n + 2) * (n + 1)))
            ends.append((sum(n * (n - 1) * c for n, c in enumerate(a)),
                         sum(n * (n - 1) * (n - 2) * c for n, c in enumerate(a))))
        return ends[0][0] * ends[1][1] - ends[0][1] * ends[1][0]

    for eta in range(5):
        mu = roots(lambda m: free_end(eta, m), 0.5, 0.1, 3)
        print("eta", eta, "flap", [f"{m:.10g}" for m in mu], "lag", [f"{math.sqrt(m * m - eta**2):.10g}" for m in mu])


def rotating_string():
    """n, flapping ω/Ω = sqrt(n(2n - 1)), lagging sqrt(n(2n - 1) - 1)"""
    rows([(n, math.sqrt(n * (2 * n - 1)), math.sqrt(n * (2 * n - 1) - 1)) for n in (1, 2, 3)])


# ---------------------------------------------------------------------------------------------- motions


def pendulum_a01():
    """t, x, y of 1 m from the horizontal at rest: sin(φ/2) = k cd(ωt), k = sin 45°; and the period 4K/ω"""
    k, omega = math.sqrt(0.5), math.sqrt(9.81)
    K = elliptic(k)[0]
    found = []
    for t in (0.5, 1.0, 2.0, 10.0, 100.0, 500.0, 1000.0, 2000.0):
        u = (omega * t) % (4 * K)
        _, cn, dn = jacobi(u, k)
        half = k * cn / dn
        cosine = 1 - 2 * half * half
        found.append((t, 2 * half * math.sqrt(1 - half * half), -cosine))
    rows(found)
    print("period", 4 * K / omega, "of a uniform rod", 4 * K / omega * math.sqrt(2 / 3), "of half the length",
          4 * K / omega * math.sqrt(1 / 2))


def spin_up():
    """t, deflection across of the tip of a beam that is spun up, linearised about the rigid motion. Ritz's method with
    x², x³, …, and Newmark's rule; greatest deflection and when it is."""
    L, EA, EI, mass = 10.0, 2.8e7, 1.4e4, 1.2
    n = 7
    # ∫ of powers of x/L: bending, mass, and the two parts of the stiffness by rotation.
    p = [k + 2 for k in range(n)]
    bend = [[EI / L**3 * a * (a - 1) * b * (b - 1) / (a + b - 3) for b in p] for a in p]
    weigh = [[mass * L / (a + b + 1) for b in p] for a in p]
    pull = [[mass * L / 2 * a * b * (1 / (a + b - 1) - 1 / (a + b + 1)) - mass * L / (a + b + 1) for b in p] for a in p]
    push = [mass * L * L / (a + 2) for a in p]

    def turning(t):
        if t >= 15:
            return 6.0, 0.0
        return 0.4 * (t - 15 / (2 * math.pi) * math.sin(2 * math.pi * t / 15)), 0.4 * (1 - math.cos(2 * math.pi * t / 15))

    h = 0.005
    x, v = [0.0] * n, [0.0] * n
    a = [0.0] * n
    tips, shown = [0.0], []
    for k in range(1, 4001):
        t = k * h
        omega, rise = turning(t)
        guess = [x[i] + h * v[i] + h * h / 4 * a[i] for i in range(n)]
        stiff = [[bend[i][j] + omega**2 * pull[i][j] for j in range(n)] for i in range(n)]
        left = [[weigh[i][j] + h * h / 4 * stiff[i][j] for j in range(n)] for i in range(n)]
        right = [-rise * push[i] - sum(stiff[i][j] * guess[j] for j in range(n)) for i in range(n)]
        a_next = solve(left, right)
        x = [guess[i] + h * h / 4 * a_next[i] for i in range(n)]
        v = [v[i] + h / 2 * (a[i] + a_next[i]) for i in range(n)]
        a = a_next
        tips.append(sum(x))
        if k % 600 == 0:
            shown.append((t, tips[-1]))
    rows(shown, 6)
    # Of the parabola through the least and those beside it.
    i = tips.index(min(tips))
    a, b, c = tips[i - 1 : i + 2]
    off = (a - c) / (2 * (a - 2 * b + c))
    print("least", b - (a - c) * off / 4, "at", (i + off) * h)
    k = 6 * math.sqrt(mass / EA)
    print("steady extension", math.tan(k * L) / k - L, "to first order", mass * 36 * L**3 / (3 * EA))


def heavy_mass():
    """t, x, z and the period of 1e5 kg on a straight line that stretches evenly and weighs 7.854 kg/m, from
    (10, 0, -100) where its pull is the weight's part along it; Lagrange's equations of its length and angle"""
    M, m, EA, g = 1e5, 7.854, 1e9, 9.80665
    far = math.hypot(10.0, 100.0)
    angle = math.atan2(10.0, 100.0)
    # The unstretched length of which `far` is the stretched one under M g cos φ.
    l0 = root(lambda l: EA * (far / l - 1) - M * g * math.cos(angle), far * 0.99, far)
    inert, heavy = M + m * l0 / 3, M + m * l0 / 2

    def rate(_, y):
        r, phi, dr, dphi = y
        return [dr, dphi, r * dphi**2 + (heavy * g * math.cos(phi) - EA * (r / l0 - 1)) / inert,
                -2 * dr * dphi / r - heavy / inert * g * math.sin(phi) / r]

    y, h, rises, before = [far, angle, 0.0, 0.0], 1e-3, [], angle
    shown = []
    for k in range(1, 65001):
        y = runge_kutta(rate, y, h, 1)
        if before < 0 <= y[1]:
            rises.append(k * h - h * y[1] / (y[1] - before))
        before = y[1]
        if k == 20114 or (k % 5000 == 0 and k <= 60000):
            shown.append((k * h, y[0] * math.sin(y[1]), -y[0] * math.cos(y[1])))
    print("unstretched length", l0, "stretch", far / l0, "line's mass", m * l0)
    rows(shown)
    print("period", (rises[-1] - rises[0]) / (len(rises) - 1), "2π sqrt(l/g)", 2 * math.pi * math.sqrt(far / g))


def spinning_rod():
    """least height of the middle of a rigid rod of 1 m that starts level, turning at 4 rad/s about the vertical; when;
    and the period of its height: dt = dc/sqrt(3 g c (1 - c²) - Ω² c²) by the sine c of the dip (θ'² from energy and
    angular momentum)"""
    g, spin = 9.81, 4.0
    # With c = sin of the dip: c'² = (3 g c)(1 - c²) - spin² c², as L = cos² φ' and E are kept.
    f = lambda c: 3 * g * c * (1 - c * c) - spin**2 * c * c
    deepest = root(lambda c: 3 * g * (1 - c * c) - spin**2 * c, 1e-3, 1.0)
    # c = deepest sin² u makes the integrand smooth at both ends.
    n, total = 4000, 0.0
    for k in range(n):
        u = (k + 0.5) * math.pi / 2 / n
        c = deepest * math.sin(u) ** 2
        total += 2 * deepest * math.sin(u) * math.cos(u) / math.sqrt(f(c)) * math.pi / 2 / n
    print("least y of the middle", -deepest / 2, "at", total, "period", 2 * total)


everything = [
    elastica, gerstmayr_irschik, princeton, roll_up, roll_up_rod, buckled_column, uniform_load, follower_tip,
    suspended_cable, green_bar, beam_under_its_weight, beams, piano_wire, taut_string, hanging_chain, rotating_beam,
    rotating_string, pendulum_a01, spin_up, heavy_mass, spinning_rod,
]

if __name__ == "__main__":
    for one in everything:
        if len(sys.argv) == 1 or one.__name__ in sys.argv[1:]:
            print(f"{one.__name__}: {one.__doc__.splitlines()[0]}")
            one()

# SPDX-License-Identifier: BSD-3-Clause
"""One material point: no strength, no shear stiffness, whole strains in a step, vertex and cap, stretch and rotation without end."""
import numpy as np
from tools.drive import drive
from tools.extreme import STOPS

# Dry rock of simple numbers: I1 at the vertex 1 MPa, cone to it, cap from p0 on.
ROCK = {
    "PEAKI1": 1e6, "FSLOPE": 0.4, "STREN": 5e8, "YSLOPE": 0.1, "B0": 1e10, "G0": 8e9, "p0_crush_curve": -3e8, "p1_crush_curve": 2e-9,
    "p3_crush_curve": 0.2,
    "CR": 0.5,
}  # fmt: skip
PAIRS = ("xx", "yy", "zz", "xy", "yz", "zx")


def rock(**more):
    return {name: repr(value) if not isinstance(value, str) else value for name, value in {**ROCK, **more}.items()}


def stress_of(table, row=-1):
    xx, yy, zz, xy, yz, zx = (table[f"stress_{pair}"][row] for pair in PAIRS)
    return np.array([[xx, xy, zx], [xy, yy, yz], [zx, yz, zz]])


def invariants(stress):
    """I1 and the root of J2."""
    s = stress - np.trace(stress) / 3.0 * np.eye(3)
    return float(np.trace(stress)), float(np.sqrt(0.5 * (s * s).sum()))


def strained(strain):
    values, vectors = np.linalg.eigh(np.asarray(strain, float))
    return vectors @ np.diag(np.exp(values)) @ vectors.T


def answer(barreno, model, parameters, strains, steps=1):
    """Table, or the sentence of a refusal: each row one step to a logarithmic strain."""
    rows = [(0.0, np.eye(3))] + [(1e-3 * (i + 1), strained(e)) for i, e in enumerate(strains)]
    try:
        return drive(barreno, model, parameters, rows, steps), ""
    except RuntimeError as error:
        return None, str(error)[str(error).index("ended with") :]


def within(table, title, setup, what, found, sentence, value, limit, at_least=False):
    if found is None:
        refused = sentence.startswith("ended with 1") or sentence.startswith("ended with 3")
        table.add(title, setup, f"{what} {'>=' if at_least else '<='} {limit:.3g}, or a refusal with a sentence", sentence[:12], refused,
            STOPS, sentence)
    else:
        table.within(title, setup, what, value(found), limit, at_least)


def random_strain(generator, size):
    e = generator.normal(size=(3, 3))
    e = e + e.T
    return e * size / np.linalg.norm(e)


def strength_rows(barreno, table):
    title = "Zero strength, zero shear modulus"
    shear = np.zeros((3, 3))
    shear[0, 1] = shear[1, 0] = 0.1
    none = {"PEAKI1": 0.0, "FSLOPE": 0.0, "STREN": 0.0, "YSLOPE": 0.0}
    for name, more in (("PEAKI1 = 0", {"PEAKI1": 0.0}), ("PEAKI1 = FSLOPE = STREN = YSLOPE = 0", none)):
        found, sentence = answer(barreno, "Arenisca", rock(**more), [0.05 * np.eye(3)], 10)
        within(table, title, f"Arenisca, {name}, tension", "root of J2 over K", found, sentence,
            lambda t: invariants(stress_of(t))[1] / 1e10, 1e-9)
        within(table, title, f"Arenisca, {name}, tension", "I1 over K", found, sentence, lambda t: invariants(stress_of(t))[0] / 1e10, 1e-9)
        found, sentence = answer(barreno, "Arenisca", rock(**more), [shear], 10)
        slope = more.get("FSLOPE", ROCK["FSLOPE"])
        within(table, title, f"Arenisca, {name}, shear", "root of J2 less FSLOPE |I1|, over K", found, sentence,
               lambda t, slope=slope: (invariants(stress_of(t))[1] - slope * abs(invariants(stress_of(t))[0])) / 1e10, 1e-9)  # fmt: skip
    for model in ("Linear Elastic", "Neo-Hookean"):
        found, sentence = answer(barreno, model, {"Bulk Modulus": "1e9", "Shear Modulus": "0"}, [shear, shear - 0.02 * np.eye(3)], 10)
        within(table, title, f"{model}, G = 0, shear and pressure", "root of J2 over K", found, sentence,
            lambda t: invariants(stress_of(t))[1] / 1e9, 1e-12)
        within(table, title, f"{model}, G = 0, shear and pressure", "|pressure over K 0.06 less 1|", found, sentence,
               lambda t: abs(-invariants(stress_of(t))[0] / 3.0 / (1e9 * 0.06) - 1.0), 0.05)  # fmt: skip


def increment_rows(barreno, full, table):
    """One step against a thousand; every answer must be on its yield surface or the step refused."""
    title = "Strain of 100 % in a step"
    generator = np.random.default_rng(6)
    for size in (0.01, 0.1, 1.0):
        worst = refused = 0.0
        for _ in range(40 if full else 8):
            strain = random_strain(generator, size)
            one, _ = answer(barreno, "Arenisca", rock(), [strain])
            many, _ = answer(barreno, "Arenisca", rock(), [strain], 1000)
            if one is None or many is None:
                refused += 1.0
                continue
            a, b = stress_of(one), stress_of(many)
            worst = max(worst, float(np.abs(a - b).max() / max(np.abs(b).max(), 1e6)))
        setup = f"Arenisca, |strain| = {size:g} in random directions"
        table.within(title, setup, "one step against 1000, of the largest stress", worst, 0.05)
        table.within(title, setup, "steps refused", refused, 0.0)
    for model, parameters in (("Linear Elastic", {"Bulk Modulus": "1e9", "Shear Modulus": "5e8"}),
            ("Neo-Hookean", {"Bulk Modulus": "1e9", "Shear Modulus": "5e8"})):
        strain = random_strain(generator, 1.0)
        one, _ = answer(barreno, model, parameters, [strain])
        many, _ = answer(barreno, model, parameters, [strain], 1000)
        table.within(title, f"{model}, |strain| = 1", "one step against 1000, of the largest stress",
                     np.abs(stress_of(one) - stress_of(many)).max() / np.abs(stress_of(many)).max(), 1e-10)  # fmt: skip
    found, sentence = answer(barreno, "Arenisca", rock(), [np.diag([-1.0, -1.0, -1.0])])
    within(table, title, "Arenisca, each axis to 1 / e: beyond the collapse of its pores", "I1 over 3 K (strain + p3) less 1",
        found, sentence,
           lambda t: abs(invariants(stress_of(t))[0] / (3.0 * 1e10 * (-3.0 + 0.2)) - 1.0), 0.05)  # fmt: skip


def corner_rows(barreno, table):
    title = "Vertex and corner of the cap"
    vertex = ROCK["PEAKI1"]
    turn = np.linalg.qr(np.random.default_rng(1).normal(size=(3, 3)))[0]
    for size in (1e-3, 1e-2, 1e-1):
        found, sentence = answer(barreno, "Arenisca", rock(), [size * np.eye(3)])
        within(table, title, f"all-round tension {size:g}", "|I1 / PEAKI1 less 1|", found, sentence,
            lambda t: abs(invariants(stress_of(t))[0] / vertex - 1.0), 1e-6)
        within(table, title, f"all-round tension {size:g}", "root of J2 over PEAKI1", found, sentence,
            lambda t: invariants(stress_of(t))[1] / vertex, 1e-6)
        bit = size * (np.eye(3) + turn @ np.diag([1e-3, 0.0, -1e-3]) @ turn.T)
        found, sentence = answer(barreno, "Arenisca", rock(), [bit])
        within(table, title, f"tension {size:g} with a thousandth of shear", "|I1 / PEAKI1 less 1|", found, sentence,
               lambda t: abs(invariants(stress_of(t))[0] / vertex - 1.0), 1e-2)  # fmt: skip
    for squeeze in (0.03, 0.06, 0.1):
        plain, sentence = answer(barreno, "Arenisca", rock(), [-squeeze / 3.0 * np.eye(3)])
        off, _ = answer(barreno, "Arenisca", rock(), [-squeeze / 3.0 * np.eye(3) + 1e-9 * np.diag([1.0, 0.0, -1.0])])
        within(table, title, f"all-round squeeze {squeeze:g}, exactly on the hydrostat", "root of J2 over K", plain, sentence,
               lambda t: invariants(stress_of(t))[1] / 1e10, 1e-12)  # fmt: skip
        if plain is not None and off is not None:
            change = np.abs(stress_of(off) - stress_of(plain)).max() / np.abs(stress_of(plain)).max()
            table.within(title, f"all-round squeeze {squeeze:g}, 1e-9 off the hydrostat", "change of stress over stress", change, 1e-6)
    for cr in (0.0, 1e-6, 0.999999):
        strain = np.diag([-0.05, -0.01, -0.01])
        found, sentence = answer(barreno, "Arenisca", rock(CR=cr), [strain], 10)
        within(table, title, f"CR = {cr:g}", "stress that is finite", found, sentence, lambda t: float(np.isfinite(stress_of(t)).all()),
            1.0, at_least=True)
    same = [np.diag([-0.06, -0.02, -0.01]), turn @ np.diag([-0.06, -0.02, -0.01]) @ turn.T]
    both = [answer(barreno, "Arenisca", rock(), [strain])[0] for strain in same]
    values = [np.sort(np.linalg.eigvalsh(stress_of(t))) for t in both]
    table.within(title, "the same strain in turned axes", "change of principal stresses",
        np.abs(values[0] - values[1]).max() / np.abs(values[0]).max(), 1e-9)


def motion_rows(barreno, table):
    title = "F stretched a thousandfold, one point"
    for stretch in (1e3, 1e-3):
        side = stretch**-0.5
        f = np.diag([stretch, side, side])
        rows = [(0.0, np.eye(3)), (1.0, f)]
        parameters = {"Bulk Modulus": "1e9", "Shear Modulus": "5e8"}
        answered = drive(barreno, "Neo-Hookean", parameters, rows, 100)
        exact = 5e8 * (f @ f.T - np.eye(3))
        table.within(title, f"Neo-Hookean to {stretch:g}", "|stress - exact| over the largest",
            np.abs(stress_of(answered) - exact).max() / np.abs(exact).max(), 1e-9)
        answered = drive(barreno, "Linear Elastic", parameters, rows, 100)
        exact = 1e9 * np.diag(np.log([stretch, side, side]))
        table.within(title, f"Linear Elastic to {stretch:g}", "|stress - exact| over the largest",
            np.abs(stress_of(answered) - exact).max() / np.abs(exact).max(), 1e-9)
    title = "Rotation of 1e4 rad, one point"
    from cases.simple_motions import MATERIALS, turned_point

    for model in MATERIALS:
        change, off = turned_point(barreno, model)
        table.within(title, f"{model}, steps of 0.01 rad", "change of principal stresses", change, 1e-10)
        table.within(title, f"{model}, steps of 0.01 rad", "stress against the turned one", off, 1e-10)


def run(barreno, full, table):
    strength_rows(barreno, table)
    increment_rows(barreno, full, table)
    corner_rows(barreno, table)
    motion_rows(barreno, table)

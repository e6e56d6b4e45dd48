# SPDX-License-Identifier: BSD-3-Clause
"""Triaxial tests of Berea sandstone, dry and saturated: strength follows the pressure less the pore pressure (Terzaghi)."""
import pathlib
import tempfile
import xml.etree.ElementTree as xml

import numpy as np

from oracles.arenisca_laws import Laws
from barreno.materials import Material, load
from tools.case import Result
from tools.plug import Plug, write_card

REPOSITORY = pathlib.Path(__file__).resolve().parents[2]
BEREA = REPOSITORY / "materials" / "cards" / "berea_sandstone.xml"
LAW = ("PEAKI1", "FSLOPE", "STREN", "YSLOPE", "CR", "B0", "B1", "B2", "G0", "G1", "G2", "p0_crush_curve", "p1_crush_curve",
       "p3_crush_curve")  # fmt: skip
WATER = {"fluid_B0": 2.2e9, "Matrix bulk modulus": 36e9}
FORMS = ("poroplastic", "elastic centre")
# (confinement, initial pore pressure) [MPa]; None: dry
TESTS = ((10.0, None), (40.0, None), (100.0, None), (40.0, 0.0), (100.0, 0.0), (100.0, 60.0), (100.0, 90.0), (200.0, 100.0), (200.0, 190.0))
# The same with a tap: fluid comes and goes at constant pressure, so that it is one without stiffness.
TAP = {"fluid_B0": 10.0, "Matrix bulk modulus": 36e9}
DRAINED = ((100.0, 60.0), (100.0, 90.0), (50.0, 40.0), (90.0, 50.0))
ALIKE = (((100.0, 0.0), (200.0, 100.0)), ((100.0, 90.0), (200.0, 190.0)))  # of equal effective pressure
# Squeezed without drainage and then sheared at that pressure: bulk modulus of the fluid [Pa]; confinement [MPa]
FLUIDS, SQUEEZE = (2.2e9, 20e9), 104.0
STEPS, SHORTENING = 60, 0.03
SHEAR = 1e-4  # of an increment
YIELDS = 1e-6  # smallest plastic strain of an increment that counts as flow
FINE = "1e-6"  # Tolerance


def berea_laws():
    values = {e.get("name"): e.get("value") for e in xml.parse(BEREA).getroot().iter("Parameter")}
    return Laws({name: float(values[name]) for name in LAW})


def envelope(laws, mean_stress, plastic_volume):
    """sqrt(J2) of dry rock at this I1: limit surface and cap of that crush."""
    return laws.surface(plastic_volume).strength(mean_stress)


def triaxial(material, laws, confinement, pore_pressure):
    """Peak of the stress difference, with the pressures there; how far flow was from the dry envelope; first flow and that envelope
    there."""
    plug = Plug(material, pore_pressure)
    plug.confine(confinement)
    peak, furthest, first = (0.0, 0.0, 0.0), 0.0, None
    for _ in range(STEPS):
        before = plug.get("equivalent_plastic_strain")
        plug.shorten(-SHORTENING / STEPS, confinement)
        axial, side = plug.stress[0, :2]
        pore, shear = plug.get("pore_pressure"), abs(axial - side) / np.sqrt(3.0)
        pressure = -(axial + 2.0 * side) / 3.0
        if plug.get("equivalent_plastic_strain") - before > YIELDS:
            dry = envelope(laws, -3.0 * (pressure - pore), plug.get("plastic_volume_strain"))
            furthest = max(furthest, abs(shear / dry - 1.0))
            first = first or (side - axial, np.sqrt(3.0) * dry)
        peak = max(peak, (side - axial, pressure, pore))
    return peak, furthest, first


def measure(result, laws, library, settings, row):
    """A test with these parameters more: its row, and the peak of the stress difference [Pa]."""
    kind, form, confinement, pore = row
    with tempfile.TemporaryDirectory() as folder:
        with Material(write_card(folder, BEREA, settings), library) as material:
            (peak, pressure, fluid), off, first = triaxial(material, laws, 1e6 * confinement, None if pore is None else 1e6 * pore)
    known = float("nan") if pore is None else pore
    result.rows.append([kind, form, confinement, known, first[0] / 1e6, first[1] / 1e6, peak / 1e6, pressure / 1e6, fluid / 1e6, off])
    return peak, off


def squeezed(result, laws, library):
    """First flow in shear of rock whose pore pressure comes from its squeezing."""
    for fluid in FLUIDS:
        for form in FORMS:
            settings = {"Tolerance": FINE, **WATER, "fluid_B0": fluid, "Backstress strain": form}
            with tempfile.TemporaryDirectory() as folder, Material(write_card(folder, BEREA, settings), library) as material:
                plug = Plug(material, None)
                plug.confine(1e6 * SQUEEZE)
                before = plug.get("equivalent_plastic_strain")
                while plug.get("equivalent_plastic_strain") - before < YIELDS:
                    plug.shear(SHEAR)
                pressure, pore = plug.pressure(), plug.get("pore_pressure")
                dry = envelope(laws, -3.0 * (pressure - pore), plug.get("plastic_volume_strain"))
                off, root = abs(plug.root_j2() / dry - 1.0), np.sqrt(3.0) * plug.root_j2() / 1e6
            name = f"sheared, fluid of {fluid / 1e9:g} GPa"
            result.rows.append([name, form, SQUEEZE, 0.0, root, np.sqrt(3.0) * dry / 1e6, float("nan"), pressure / 1e6, pore / 1e6, off])
            if form == "poroplastic":
                result.demand(f"{name}, squeezed to {SQUEEZE:g} MPa before: flow off the dry envelope", off, 1e-6)


def drained(result, laws, library, full):
    """Tests at constant pore pressure, each against the test of the dry rock at the difference of the pressures."""
    for confinement, pore in DRAINED if full else DRAINED[1:2]:
        fine = {"Tolerance": FINE}
        known = [row for row in result.rows if row[:3] == ["dry", "dry", confinement - pore]]
        alone = 1e6 * known[0][6] if known else measure(result, laws, library, fine, ("dry", "dry", confinement - pore, None))[0]
        wet = {**fine, **TAP, "fluid_pressure_initial": repr(1e6 * pore)}
        for form in FORMS:
            peak, off = measure(result, laws, library, {**wet, "Backstress strain": form}, ("drained", form, confinement, pore))
            if form == "poroplastic":
                name = f"drained, confinement {confinement:g} MPa, pore pressure {pore:g} MPa"
                result.demand(f"{name}: flow off the dry envelope", off, 1e-6)
                result.demand(f"{name}: peak of dry rock at {confinement - pore:g} MPa, relative", abs(peak / alone - 1.0), 1e-6)


def run(barreno, full):
    result = Result(
        "Effective stress",
        "Saturated rock is as strong as dry rock under the pressure minus the pore pressure, whatever their values.",
        "the dry limit surface and cap, from the oracle's own formulas, at P - p (Terzaghi). Undrained: triaxial compression of the "
        "Berea card with water and quartz, 3 % axial strain, pore pressure applied before the confinement. Drained: a fluid of bulk "
        "modulus 10 Pa instead of water, whose pressure stays constant, against the dry test under the difference of the pressures.",
        ["test", "form", "confinement [MPa]", "initial pore pressure [MPa]", "stress difference at first flow [MPa]",
         "dry envelope at P - p there [MPa]", "peak stress difference [MPa]", "P there [MPa]", "p there [MPa]",
         "flow off the dry envelope, maximum"],
        [],
    )  # fmt: skip
    laws, library = berea_laws(), load(barreno.resolve().parents[1] / "materials" / "libBARRENO.so")
    tests = TESTS if full else TESTS[1::3]
    for confinement, pore in tests:
        for form in FORMS if pore is not None else ("dry",):
            settings = {"Tolerance": FINE}
            if pore is not None:
                settings |= {**WATER, "Backstress strain": form, "fluid_pressure_initial": repr(1e6 * pore)}
            kind = "dry" if pore is None else "undrained"
            off = measure(result, laws, library, settings, (kind, form, confinement, pore))[1]
            if form != "elastic centre":
                name = "dry" if pore is None else f"initial pore pressure {pore:g} MPa"
                result.demand(f"{name}, confinement {confinement:g} MPa: flow off the dry envelope", off, 1e-6)
    peaks = {(row[2], row[3]): row[6] for row in result.rows if row[1] == "poroplastic"}
    for one, two in ALIKE:
        if one in peaks and two in peaks:
            what = "peaks of {:g} less {:g} MPa and {:g} less {:g} MPa, relative".format(*two, *one)
            result.demand(what, abs(peaks[one] / peaks[two] - 1.0), 1e-6)
    drained(result, laws, library, full)
    if full:
        squeezed(result, laws, library)
    result.notes = (
        "Water in the pores carries part of the total pressure, so the grains are pressed together by P - p only, and friction and "
        "crushing depend "
        "on this effective pressure. The rows `elastic centre` belong to the form that was the default before. Its yield surface accounted "
        "for the "
        "initial pore pressure and for that due to plastic strain, but not for that due to elastic compression. Drained tests have no "
        "elastic compression of the fluid, and both forms agree with dry rock at P - p. In undrained tests rock of the old form starts "
        "to yield later than its own pore pressure allows. Compare its first flow with the dry envelope at P - p in the next column. "
        "When such rock dilates, the pressure seen by its yield surface soon vanishes, whatever the pressure of the fluid. At 100 MPa of "
        "confinement its strength was that of dry rock at 100 MPa for any pore pressure up to 90 MPa.\n\n"
        "The rows `sheared` follow rock that is squeezed to 104 MPa without drainage and then sheared at constant total pressure; its pore "
        "pressure"
        " comes from the squeezing alone. The stress difference is sqrt(3 J2). The old form starts to flow near the envelope at P, as if "
        "there were "
        "no pore pressure.\n\n"
        "Undrained rock dilates in shear, by the associated flow rule at the angle of friction; its pore pressure falls and its strength "
        "rises with"
        " strain. The peak is the value at 3 % strain; every point of flow is compared with the envelope."
    )
    return result

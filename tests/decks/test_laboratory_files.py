#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""Files of laboratories as `fit` reads them: other names, forces and lengths for stress and strain, signs of single columns, titles; each
guess is told, what stays open is asked for with the option that says it, and signs that no rock has are refused."""

import pathlib
import tempfile

import numpy

from barreno.fit import command
from barreno.runs.faults import Fault

DIAMETER, LENGTH, POISSON, YOUNG, SIDE = 50.0, 100.0, 0.2, 20e3, 40.0  # mm, mm, -, MPa, MPa
AXIAL = 0.001 * numpy.arange(10)  # engineering, compression positive
RADIAL = -POISSON * AXIAL
VOLUME = 1.0 - (1.0 - AXIAL) * (1.0 - RADIAL) ** 2
STRESS = YOUNG * AXIAL  # true, above the confinement [MPa]
FORCE = STRESS * 0.25 * numpy.pi * (DIAMETER * (1.0 - RADIAL)) ** 2 * 1e-3  # kN
HEAD = "# kind: triaxial\n# compression: positive\n# confinement: 40 MPa\n"
SIZE = f"# diameter: {DIAMETER} mm\n# length: {LENGTH} mm\n"


def table(columns):
    rows = numpy.array(list(columns.values())).T.tolist()
    return ",".join(columns) + "\n" + "".join(",".join(map(repr, row)) + "\n" for row in rows)


def read(folder, text, *words):
    file = folder / "tri40.csv"
    file.write_text(text)
    options = command.parse([str(file), "--out", "card.xml", *words])
    (test,) = command.read_tests(options.data, command.said_of(options))
    return test


PLAIN = {"axial_strain [%]": 100 * AXIAL, "differential_stress [MPa]": STRESS, "radial_strain [%]": 100 * RADIAL}
VOLUMES = {"axial_strain [%]": 100 * AXIAL, "differential_stress [MPa]": STRESS, "volume_strain [%]": 100 * VOLUME}
READ = {  # text, words, what the notes say
    "as documented": (HEAD + table(PLAIN), (), ()),
    "other names": (HEAD + table({"Axial Strain (%)": 100 * AXIAL, "Deviatoric stress (MPa)": STRESS, "Lateral strain (%)": 100 * RADIAL}),
        (), ("is read as differential_stress", "is read as radial_strain")),
    "symbols": (HEAD + table({"eps_1 [-]": AXIAL, "q [psi]": STRESS / 6.894757293168361e-3, "eps_3 [-]": RADIAL}), (),
        ("'q' is read as differential_stress",)),
    "units behind a slash": (HEAD + table({"axial_strain / %": 100 * AXIAL, "differential_stress / kPa": 1e3 * STRESS,
        "radial_strain / microstrain": 1e6 * RADIAL}), (), ()),
    "mapped": (HEAD + table({"A1 [%]": 100 * AXIAL, "B1 [MPa]": STRESS, "C1 [%]": 100 * RADIAL}),
        ("--column", "A1=axial_strain", "--column", "B1=differential_stress", "--column", "c1=radial_strain"), ()),
    "force of a balanced piston": (HEAD + SIZE
        + table({"axial_strain [%]": 100 * AXIAL, "Force [kN]": FORCE, "radial_strain [%]": 100 * RADIAL}),
        ("--column", "Force=axial_force"), ("differential_stress is axial_force per present area",)),
    "force with the confinement": (HEAD + SIZE
        + table({"axial_strain [%]": 100 * AXIAL,
            "Force [kN]": FORCE * (STRESS + SIDE) / numpy.maximum(STRESS, 1e-9)
            + (AXIAL == 0) * SIDE * 0.25 * numpy.pi * DIAMETER**2 * 1e-3, "radial_strain [%]": 100 * RADIAL}),
            ("--column", "Force=axial_force"), ("axial_stress is axial_force per present area",)),
    "displacement": (HEAD + SIZE
        + table({"Displacement [mm]": LENGTH * AXIAL, "differential_stress [MPa]": STRESS, "diameter_change [mm]": -DIAMETER * RADIAL}), (),
        ("axial_strain is axial_displacement over 100 mm", "radial_strain is diameter_change")),
    "size by words": (HEAD
        + table({"axial_displacement [mm]": LENGTH * AXIAL, "differential_force [kN]": FORCE, "radial_strain [%]": 100 * RADIAL}),
        ("--say", "tri40.csv:diameter=50 mm", "--say", "length=100 mm"), ("differential_stress is differential_force",)),
    "rate": (HEAD + table({"time [min]": numpy.arange(10.0), **PLAIN}), (), ("mean strain rate 1.67e-05 1/s",)),
    "fast": (HEAD + table({"time [ms]": 0.1 * numpy.arange(10.0), **PLAIN}), (), ("a fit takes tests as slow",)),
    "confinement in a column": (HEAD.replace("# confinement: 40 MPa\n", "")
        + table({**PLAIN, "Confining pressure [MPa]": SIDE + 0.1 * numpy.sin(9 * AXIAL * 1e3)}), (),
        ("confinement 40", "is read as confinement")),
    "titles": (HEAD.replace("# confinement: 40 MPa\n", "") + "Confining pressure: 40 MPa\nSpecimen diameter: 50 mm\n\n"
        + table({"axial_strain [%]": 100 * AXIAL, "axial_force [kN]": FORCE, "radial_strain [%]": 100 * RADIAL}), (),
        ("is read as confinement", "is read as diameter", "lines 3 to 4 stand")),
    "header by words": (table(PLAIN), ("--say", "kind=triaxial", "--say", "compression=positive", "--say", "tri40.csv:confinement=40 MPa"),
        ()),
    "negative": (HEAD.replace("positive", "negative") + table({name: -values for name, values in PLAIN.items()}), (), ()),
    "one column by option": (HEAD + table({**PLAIN, "radial_strain [%]": -100 * RADIAL}), ("--sign", "radial_strain=negative"), ()),
    "one column by header": (HEAD.replace("positive", "positive, radial_strain negative")
        + table({**PLAIN, "radial_strain [%]": -100 * RADIAL}), (), ()),
    "volume": (HEAD + table(VOLUMES), (), ()),
    "dilatancy positive": (HEAD.replace("positive", "positive, dilatancy positive")
        + table({**VOLUMES, "volume_strain [%]": -100 * VOLUME}), (), ()),
    "dilatancy by option": (HEAD + table({**VOLUMES, "volume_strain [%]": -100 * VOLUME}), ("--sign", "volume_strain=negative"), ()),
}  # fmt: skip
REFUSED = {
    "swells": (HEAD + table({**VOLUMES, "volume_strain [%]": -100 * VOLUME}), (), "swells while it is compressed elastically"),
    "advice for it": (HEAD + table({**VOLUMES, "volume_strain [%]": -100 * VOLUME}), (), "say --sign volume_strain=negative"),
    "becomes thinner": (HEAD + table({**PLAIN, "radial_strain [%]": -100 * RADIAL}), (),
        "becomes thinner while it is compressed elastically"),
    "swells by its side": (HEAD + table({**PLAIN, "radial_strain [%]": 400 * RADIAL}), (),
        "swells while it is compressed elastically ('radial_strain'"),
    "volume beyond the axis": (HEAD + table({**VOLUMES, "volume_strain [%]": 300 * VOLUME}), (), "check the units of both"),
    "hydrostatic": ("# kind: hydrostatic\n# compression: positive\n"
        + table({"volume_strain [%]": -100 * VOLUME, "pressure [MPa]": STRESS}), (),
        "swells while it is compressed elastically ('pressure'"),
    "uniaxial": ("# kind: uniaxial strain\n# compression: positive\n"
        + table({"axial_strain [%]": 100 * AXIAL, "axial_stress [MPa]": STRESS, "radial_stress [MPa]": -0.3 * STRESS}), (),
        "radial stress that falls"),
    "unknown column": (HEAD + table({"A1 [%]": 100 * AXIAL, "B1 [MPa]": STRESS}), (),
        'say which it is with --column "NAME=axial_strain", NAME one of A1, B1'),
    "no diameter": (HEAD + table({"axial_strain [%]": 100 * AXIAL, "axial_force [kN]": FORCE}), (),
        "not the diameter of the specimen; add a line such as '# diameter: 50 mm', or --say"),
    "no length": (HEAD + table({"displacement [mm]": LENGTH * AXIAL, "differential_stress [MPa]": STRESS}), (),
        "not the length of the specimen"),
    "odd length": (HEAD + SIZE.replace("100.0 mm", "100 m")
        + table({"displacement [mm]": LENGTH * AXIAL, "differential_stress [MPa]": STRESS}), (), "which no specimen has"),
    "open force": (HEAD + SIZE + table({"axial_strain [%]": 100 * AXIAL, "axial_force [kN]": FORCE + 30.0}), (),
        "it is open whether the force includes it"),
    "no kind": ("# compression: positive\n" + table(PLAIN), (), '--say "tri40.csv:kind=NAME"'),
    "no sign": ("# kind: triaxial\n# confinement: 40 MPa\n" + table(PLAIN), (), "--say compression=positive"),
    "no confinement": (HEAD.replace("# confinement: 40 MPa\n", "") + table(PLAIN), (), '--say "tri40.csv:confinement=40 MPa"'),
    "varying confinement": (HEAD.replace("# confinement: 40 MPa\n", "") + table({**PLAIN, "confining pressure [MPa]": STRESS}), (),
        "a triaxial test has a constant one"),
    "no unit of a force": (HEAD + SIZE + table({"axial_strain [%]": 100 * AXIAL, "axial_force": FORCE}), (),
        "gives no unit for the column 'axial_force'; write for example 'axial_force [kN]'"),
    "backward time": (HEAD + table({"time [s]": -numpy.arange(10.0), **PLAIN}), (), "does not increase"),
    "odd sign of a column": (HEAD.replace("positive", "positive, strain up") + table(PLAIN), (), "is no column with positive or negative"),
    "odd --sign": (HEAD + table(PLAIN), ("--sign", "radial_strain=up"), "--sign radial_strain=up is no column"),
    "odd --column": (HEAD + table(PLAIN), ("--column", "Force"), "--column Force is no assignment"),
    "unused --column": (HEAD + table(PLAIN), ("--column", "Kraft=axial_force"), "names no column of the files"),
    "--column to nothing": (HEAD + table(PLAIN), ("--column", "radial_strain=girth"), "names no column of"),
    "odd --say": (HEAD + table(PLAIN), ("--say", "colour=red"), "is no line of a header"),
    "--say to no file": (HEAD + table(PLAIN), ("--say", "tri60.csv:kind=triaxial"), "names no file of the data"),
}  # fmt: skip


def check_read(folder):
    expected = {"axial_strain": -numpy.log1p(-AXIAL), "radial_strain": -numpy.log1p(-RADIAL), "volume_strain": -numpy.log1p(-VOLUME),
        "differential_stress": 1e6 * STRESS, "axial_stress": 1e6 * (STRESS + SIDE)}
    for name, (text, words, notes) in READ.items():
        test = read(folder, text, *words)
        assert {"axial_strain", "radial_strain" if "radial_strain" in test.columns
            else "volume_strain"} < set(test.columns), f"{name}: {list(test.columns)}"
        for column, values in test.columns.items():
            numpy.testing.assert_allclose(values, expected[column], rtol=1e-9, atol=1e-9, err_msg=f"{name}, {column}")
        assert abs(test.confinement - 40e6) < 0.1e6, f"{name}: {test.confinement}"
        for note in notes:
            assert any(note in said for said in test.notes), f"{name}: {test.notes}"
        assert notes or not test.notes, f"{name}: {test.notes}"


def check_hydrostatic(folder):
    """The volume strain of strains on the axis and on the side, or of one of them where all sides are alike."""
    head = "# kind: hydrostatic\n# compression: positive\n"
    axial, radial = AXIAL, 0.7 * AXIAL
    expected = -numpy.log1p(-axial) - 2 * numpy.log1p(-radial)
    both = {"axial_strain [%]": 100 * axial, "radial strain [%]": 100 * radial, "confining pressure [MPa]": STRESS}
    test = read(folder, head + table(both))
    numpy.testing.assert_allclose(test.columns["volume_strain"], expected, rtol=1e-9, atol=1e-12)
    assert list(test.columns) == ["pressure", "volume_strain"] and any("volume_strain is that of axial_strain and radial_strain" in note
        for note in test.notes), test
    logarithmic = {"axial_strain [-]": -numpy.log1p(-axial), "radial_strain [-]": -numpy.log1p(-radial), "pressure [MPa]": STRESS}
    numpy.testing.assert_allclose(read(folder, head + "# strain: logarithmic\n" + table(logarithmic)).columns["volume_strain"], expected,
        rtol=1e-9, atol=1e-12)
    one = read(folder, head + table({"axial_strain [%]": 100 * axial, "pressure [MPa]": STRESS}))
    numpy.testing.assert_allclose(one.columns["volume_strain"], -3 * numpy.log1p(-axial), rtol=1e-9, atol=1e-12)
    assert any("alike on all sides" in note for note in one.notes), one.notes


def check_noisy_signs(folder):
    """Volume strains whose scatter is as large as what is elastic of them: a sign that the rows cannot tell is taken as the file says, one
    that they can is refused."""
    random, axial = numpy.random.default_rng(5), numpy.linspace(0.0, 0.01, 41)
    stress, volume = 200.0 * numpy.minimum(axial / 0.004, 1.0), 0.4 * axial
    taken = refused = 0
    for _ in range(40):
        noise = 0.3 * volume.max() * random.standard_normal(len(axial))
        for sign in (1.0, -1.0):
            columns = {"axial_strain [%]": 100 * axial, "differential_stress [MPa]": stress,
                "volume_strain [%]": 100 * sign * (volume + noise)}
            try:
                read(folder, HEAD + table(columns))
                taken += sign > 0.0
            except Fault as fault:
                assert "swells" in str(fault), fault
                assert sign < 0.0, "scatter is taken for a wrong sign"
                refused += 1
    assert taken == 40, taken
    small = {"axial_strain [%]": 100 * axial, "differential_stress [MPa]": stress, "volume_strain [%]": -100 * (volume + 0.01 * noise)}
    try:
        read(folder, HEAD + table(small))
    except Fault as fault:
        assert "swells" in str(fault), fault
    else:
        raise AssertionError("a wrong sign with little scatter is read")


def check_refused(folder):
    for name, (text, words, sentence) in REFUSED.items():
        try:
            read(folder, text, *words)
        except Fault as fault:
            assert sentence in str(fault) and str(fault).endswith(".") and "\n" not in str(fault), f"{name}: {fault}"
        else:
            raise AssertionError(f"{name} is read")


def check_scatter(folder):
    """Half a percent of noise on a real specimen, and one that dilates later, are no fault."""
    random = numpy.random.default_rng(3)
    axial = numpy.linspace(0.0, 0.02, 80)
    volume = 0.5 * axial - 60.0 * numpy.maximum(axial - 0.006, 0.0) ** 2
    stress = 150.0 * (1.0 - numpy.exp(-axial / 0.006))
    for _ in range(20):
        columns = {"axial_strain [%]": 100 * axial, "differential_stress [MPa]": stress * (1 + 0.005 * random.standard_normal(80)),
            "volume_strain [%]": 100 * volume + 0.005 * random.standard_normal(80)}
        read(folder, HEAD + table(columns))


def main():
    with tempfile.TemporaryDirectory() as scratch:
        for check in (check_read, check_hydrostatic, check_noisy_signs, check_refused, check_scatter):
            check(pathlib.Path(scratch))
    print(f"{len(READ)} files of laboratories are read, {len(REFUSED)} refused with what to say")


if __name__ == "__main__":
    main()

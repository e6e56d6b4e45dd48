#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""A rigid body of every shape that a deck can say, in every mode, is pushed into an elastic block and through a copper
plate: the run ends well, and what the body gave is what the material got.

    test_rigid_shapes.py BARRENO
"""
import pathlib
import re
import subprocess
import sys
import tempfile

from tools.runs import Run, call

MODES = {"axisymmetric": 2, "plane strain": 2, "3D": 3}
ACROSS = {"axisymmetric": "", "plane strain": "x", "3D": "xz"}  # where a reaction has components beside y
CLEARANCE = 0.1  # between the body and what it meets at y = 0 [mm]
CARDS = pathlib.Path(__file__).resolve().parents[2] / "materials" / "cards"

ELASTIC = {"Model": "Linear Elastic", "Density": "2000 kg/m3", "Bulk Modulus": "10 GPa", "Shear Modulus": "6 GPa"}


def vector(mode, x, y):
    return f"{{{x} mm, {y} mm" + (", 0 mm}" if mode == "3D" else "}")


def line(mode, radius, **more):
    """A cylinder or cone down the axis; in plane strain a cylinder is a disk."""
    if mode == "plane strain":
        return {"Centre": vector(mode, 0, radius + CLEARANCE), "Radius": f"{radius} mm"}
    return {"Start": vector(mode, 0, 4), "End": vector(mode, 0, CLEARANCE), "Radius": f"{radius} mm", **more}


def box(mode, half, top):
    left = -half if mode == "plane strain" else 0
    back, front = (", 0 mm", f", {half} mm") if mode == "3D" else ("", "")
    return {"Lower": f"{{{left} mm, {CLEARANCE} mm{back}}}", "Upper": f"{{{half} mm, {top} mm{front}}}"}


def part_ball(mode):
    """In three dimensions off the planes of symmetry, which cut a ball but not what is made of one."""
    centre = f"{{2 mm, {2 + CLEARANCE} mm, 2 mm}}" if mode == "3D" else vector(mode, 0, 2 + CLEARANCE)
    return {"Shape": "ball", "Centre": centre, "Radius": "2 mm"}


def above(mode, height):
    return {"Shape": "half-space", "Point": vector(mode, 0, height), "Normal": "{0, -1, 0}" if mode == "3D" else "{0, -1}"}


def wedge(mode):
    left = -3 if mode == "plane strain" else 0
    corners = {"Corners": f"3x2:{{0 mm, {CLEARANCE} mm, 3 mm, 4 mm, {left} mm, 4 mm}}"}
    return {**corners, "Axis": "z", "From": "0 mm", "To": "3 mm"} if mode == "3D" else corners


def samples(mode):
    """By the deck's word for a shape: its own parameters, the lists of Shapes that it needs; None where a mode has none."""
    parts = {"One": {"Shape": "box", **box(mode, 3, 4)}, "Other": part_ball(mode)}
    joined = {"Parts": "{One, Other}"}
    return {
        "box": (box(mode, 3, 4), {}),
        "ball": ({"Centre": vector(mode, 0, 3 + CLEARANCE), "Radius": "3 mm"}, {}),
        "cylinder": (line(mode, 3), {}),
        "cone": None if mode == "plane strain" else (line(mode, 3), {}),
        "polygon": (wedge(mode), {}),
        "half-space": (above(mode, CLEARANCE), {}),
        "union": (joined, parts),
        "difference": ({"Parts": "{Other, One}"}, {"One": above(mode, 3), "Other": part_ball(mode)}),
        "intersection": (joined, parts),
        "STL": ({"File": "pyramid.stl", "File Unit": "1 mm"}, {}) if mode == "3D" else None,
    }


def write_pyramid(path):
    """Its tip down, a square of 3 mm on top, in the corner of the grid."""
    tip, top = (1.5, CLEARANCE, 1.5), [(0, 4, 0), (3, 4, 0), (3, 4, 3), (0, 4, 3)]
    triangles = [(tip, top[i], top[(i + 1) % 4]) for i in range(4)] + [(top[0], top[3], top[2]), (top[0], top[2], top[1])]
    corners = "".join(
        "facet normal 0 0 0\nouter loop\n" + "".join("vertex %g %g %g\n" % corner for corner in triangle) + "endloop\nendfacet\n"
        for triangle in triangles
    )
    path.write_text("solid pyramid\n" + corners + "endsolid pyramid\n")


def xml(name, values, indent=""):
    lines = [f'{indent}<ParameterList name="{name}">']
    for key, value in values.items():
        if isinstance(value, dict):
            lines.append(xml(key, value, indent + "  "))
        else:
            kind = {int: "int", float: "double"}.get(type(value), "string")
            lines.append(f'{indent}  <Parameter name="{key}" type="{kind}" value="{value}"/>')
    return "\n".join(lines + [indent + "</ParameterList>"])


def deck(mode, shape, parameters, parts, target):
    """`target`: block (elastic, frictionless contact) or plate (copper, friction, particles may be lost)."""
    plate = target == "plate"
    left, depth = (-8, None) if mode == "plane strain" else (0, 8)
    third = {"lower": ", 0 mm", "upper": f", {depth} mm"} if mode == "3D" else {"lower": "", "upper": ""}
    bottom = 2 if plate else 6
    lists = {
        "Schema Version": 1,
        "Grid": {
            "Mode": mode,
            "Lower": f"{{{left} mm, -9 mm{third['lower']}}}",
            "Upper": f"{{8 mm, 8 mm{third['upper']}}}",
            "Cell Size": "1 mm",
        },
        "Materials": {"Soft": {"Card": str(CARDS / "copper.xml")} if plate else {**ELASTIC, "Bad Particles": "stop"}, "Hard": ELASTIC},
        "Bodies": {
            "Target": {
                "Material": "Soft",
                "Lower": f"{{{-6 if left else 0} mm, -{bottom} mm{third['lower']}}}",
                "Upper": "{6 mm, 0 mm" + (", 6 mm}" if mode == "3D" else "}"),
            },
            "Punch": {
                "Material": "Hard",
                "Shape": shape,
                **parameters,
                "Motion": f"{{0 m/s, {-500 if plate else -100} m/s" + (", 0 m/s}" if mode == "3D" else "}"),
            },
        },
        "Contact": {"Face": {"Material": "Soft", "Other Material": "Hard", "Kind": "friction" if plate else "frictionless"}},
        "Time": {"End Time": "6 us"},
    }
    if plate:
        lists["Contact"]["Face"]["Friction Coefficient"] = 0.2
    if parts:
        lists["Shapes"] = parts
    symmetric = {"axisymmetric": ["x_lower"], "plane strain": [], "3D": ["x_lower", "z_lower"]}[mode]
    if symmetric:
        lists["Conditions"] = {face: {"Face": face, "Kind": "symmetry"} for face in symmetric}
    return '<?xml version="1.0"?>\n' + xml("Barreno", lists) + "\n"


def run_sample(barreno, folder, mode, shape, target, ranks=1):
    parameters, parts = samples(mode)[shape]
    path = folder / f"{MODES[mode]}-{mode[0]}-{shape}-{target}-{ranks}.xml"
    path.write_text(deck(mode, shape, parameters, parts, target))
    out = path.with_suffix("")
    result = call(barreno, ["run", path, "--out", out], ranks, 120)
    assert result.returncode == 0, f"exit {result.returncode}: {result.stderr.strip()}"
    return Run(out)


def check_ranks(barreno, folder, mode):
    folder = pathlib.Path(tempfile.mkdtemp(dir=folder))
    one, two = (run_sample(barreno, folder, mode, "ball", "plate", ranks).table("history.csv") for ranks in (1, 2))
    for column in (name for name in one if name.startswith("Punch_")):
        assert (one[column] == two[column]).all(), f"{mode}: {column} is not the same on two ranks"


def check(barreno, folder, mode, shape, target):
    run = run_sample(barreno, folder, mode, shape, target)
    history = run.table("history.csv")
    for axis in "y" + ACROSS[mode]:
        assert f"Punch_force_{axis}" in history, f"no force along {axis}: {sorted(history)}"
    assert ("Punch_force_x" in history) == ("x" in ACROSS[mode])
    got, given = history["Punch_impulse_y"][-1], -history["rigid_impulse"][-1]
    lost = sum(cause["momentum"] for cause in run.summary["removed_particles"].values())
    material = history["momentum"][-1] + lost  # nothing else pushes it along y
    assert got > 0.0, f"the body was pulled: {got}"
    assert abs(got - given) <= 1e-12 * got, f"{got} in its column, {given} in the ledger"
    assert abs(got + material) <= 1e-11 * got, f"the body got {got}, the material {material}"
    assert abs(history["energy_error"][-1]) <= (2e-2 if target == "plate" else 1e-3), history["energy_error"][-1]
    if target == "block":
        assert history["particles"][-1] == history["particles"][0]
    return int(run.summary["steps"]), history["energy_error"][-1], got


def main():
    barreno = sys.argv[1]
    text = subprocess.run([barreno, "describe", "Bodies"], capture_output=True, text=True, check=True).stdout
    words = re.search(r"one of: (box,[^;\n]*)", text)
    assert words, text
    shapes = [word.strip() for word in words.group(1).split(",")]
    failures = 0
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        write_pyramid(folder / "pyramid.stl")
        for mode in MODES:
            known = samples(mode)
            assert list(known) == shapes, f"a shape without a sample: the code has {shapes}"
            check_ranks(barreno, folder, mode)
            for shape in (word for word in shapes if known[word]):
                for target in ("block", "plate"):
                    try:
                        steps, energy, got = check(barreno, folder, mode, shape, target)
                        print(f"{mode}, {shape} into {target}: {steps} steps, energy error {energy:.1e}, impulse {got:.3g}")
                    except AssertionError as error:
                        failures += 1
                        print(f"{mode}, {shape} into {target}: {error}")
    assert failures == 0, f"{failures} failed"


if __name__ == "__main__":
    main()

#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""src/python/barreno/materials: every status of the C interface has its name, its words and its row in docs/finite_elements.md, and
a point that fails says which. Paths of laboratory tests meet the stresses that are held.

    test_python_face.py LIBRARY
"""
import pathlib
import re
import sys

import numpy

from barreno import materials

ROOT = pathlib.Path(__file__).resolve().parents[2]
CARD = ROOT / "materials" / "cards" / "berea_sandstone.xml"


def statuses():
    """{name: number} of barreno_material.h"""
    header = (ROOT / "materials" / "include" / "barreno_material.h").read_text()
    body = re.search(r"enum barreno_status \{(.*?)\};", header, re.DOTALL).group(1)
    return {name: int(number) for name, number in re.findall(r"BARRENO_(\w+) = (\d+)", body)}


def check_names():
    found, page = statuses(), (ROOT / "docs" / "finite_elements.md").read_text()
    assert len(found) >= 4 and sorted(found.values()) == sorted(materials.STATUS), found
    for name, number in found.items():
        assert getattr(materials, name) == number, name
        assert re.search(rf"(?m)^\| {number} \| `BARRENO_{name}` \| \w", page), f"docs/finite_elements.md has no row of BARRENO_{name}"
        assert number == 0 or str(number) in materials.Material.update.__doc__, name


def check_bad_input(library):
    """One sound point beside one whose strain is no number: 0 and 3, the old values, and a sentence."""
    with materials.Material(str(CARD), library) as rock:
        stress, state = rock.virgin(2)
        strain = numpy.array([[-1e-4, 0, 0, 0, 0, 0], [numpy.nan, 0, 0, 0, 0, 0]])
        answer = rock.update(strain, stress, state)
        assert list(answer.status) == [materials.OK, materials.BAD_INPUT], answer.status
        assert answer.stress[0, 0] < 0.0 and not answer.stress[1].any(), answer.stress
        assert "point 1 of the batch has an impossible step or state" in rock.why(), rock.why()


def check_elastic_path(rock):
    """Uniaxial stress: Young's modulus and Poisson's ratio of the elastic tangent."""
    stress, state = rock.virgin(1)
    strain, wanted = numpy.zeros((1, 1, 6)), numpy.full((1, 1, 6), numpy.nan)
    strain[0, 0, 0], wanted[0, 0, 1:3] = -1e-9, 0.0
    C = rock.update(numpy.zeros((1, 6)), stress, state, want=materials.ELASTIC).tangent[0]
    bulk, shear = C[:3, :3].sum() / 9.0, C[3, 3]
    E, nu = 9.0 * bulk * shear / (3.0 * bulk + shear), (3.0 * bulk - 2.0 * shear) / (2.0 * (3.0 * bulk + shear))
    found = rock.follow(strain, wanted, stress, state)
    assert abs(found.stress[0, 0, 0] / (-1e-9 * E) - 1.0) < 1e-5, found.stress
    assert abs(found.strain[0, 0, 1] / (1e-9 * nu) - 1.0) < 1e-5, found.strain


def check_triaxial_path(rock):
    """Pressed to 20 and 50 MPa, then compressed far beyond yield: held stresses are met, and the strains that were taken give the path
    again."""
    pressure, press, steps = numpy.array([20e6, 50e6]), 8, 60
    strain, wanted = numpy.zeros((press + steps, 2, 6)), numpy.full((press + steps, 2, 6), numpy.nan)
    wanted[:press, :, :3] = -pressure[:, None] * (numpy.arange(1, press + 1) / press)[:, None, None]
    strain[press:, :, 0], strain[press:, :, 1:3] = -1e-3, 2e-4
    wanted[press:, :, 1:3] = -pressure[:, None]
    stress, state = rock.virgin(2)
    found = rock.follow(strain, wanted, stress, state)
    assert not found.status.any(), rock.why()
    held = ~numpy.isnan(wanted)
    assert (abs(found.stress - wanted)[held] <= 1e-7 * abs(found.stress).max()).all()
    assert (found.strain[~held] == strain[~held]).all()
    for increment, there in zip(found.strain, found.stress):
        answer = rock.update(increment, stress, state, want=materials.STRESS)
        stress, state = answer.stress, answer.state
        assert (stress == there).all()
    assert (state == found.state).all() and (state[:, rock.state_index("equivalent_plastic_strain")] > 0.01).all()


def check_impossible_path(rock, library):
    """Tension that no rock carries, beside a specimen that is let alone; arrays that do not fit, and none."""
    strain, wanted = numpy.zeros((2, 2, 6)), numpy.full((2, 2, 6), numpy.nan)
    strain[:, 0, 0], strain[:, 1, 0] = -1e-4, -1e-4
    wanted[1, 1, 1:3] = 1e9
    stress, state = rock.virgin(2)
    found = rock.follow(strain, wanted, stress, state)
    assert list(found.status) == [materials.OK, materials.NOT_CONVERGED], found.status
    assert (found.stress[0, 1] == found.stress[1, 1]).all() and not found.strain[1, 1].any(), "a specimen that fails stays where it was"
    try:
        rock.follow(strain, wanted[:1], stress, state)
    except ValueError as error:
        assert "wanted has the shape (1, 2, 6); (2, 2, 6) is needed" in str(error), error
    else:
        raise AssertionError("arrays of unlike shapes are taken")
    path = materials._Path(1, 1, 1.0)
    assert rock.library.barreno_material_follow(rock.handle, path) == -1 and "an array of the path is NULL" in rock.why(), rock.why()


def check_paths(library):
    with materials.Material(str(CARD), library) as rock:
        check_elastic_path(rock)
        check_triaxial_path(rock)
        check_impossible_path(rock, library)


def main():
    check_names()
    check_paths(sys.argv[1])
    check_bad_input(sys.argv[1])
    print("every status is documented")


if __name__ == "__main__":
    main()

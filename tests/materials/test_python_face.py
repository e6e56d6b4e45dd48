#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""materials/python/barreno_material.py: every status of the C interface has its name, its words and its row in docs/finite_elements.md, and
a point that fails says which.

    test_python_face.py LIBRARY
"""
import pathlib
import re
import sys

import numpy

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "materials" / "python"))
import barreno_material  # noqa: E402

CARD = ROOT / "materials" / "cards" / "berea_sandstone.xml"


def statuses():
    """{name: number} of barreno_material.h"""
    header = (ROOT / "materials" / "include" / "barreno_material.h").read_text()
    body = re.search(r"enum barreno_status \{(.*?)\};", header, re.DOTALL).group(1)
    return {name: int(number) for name, number in re.findall(r"BARRENO_(\w+) = (\d+)", body)}


def check_names():
    found, page = statuses(), (ROOT / "docs" / "finite_elements.md").read_text()
    assert len(found) >= 4 and sorted(found.values()) == sorted(barreno_material.STATUS), found
    for name, number in found.items():
        assert getattr(barreno_material, name) == number, name
        assert re.search(rf"(?m)^\| {number} \| `BARRENO_{name}` \| \w", page), f"docs/finite_elements.md has no row of BARRENO_{name}"
        assert number == 0 or str(number) in barreno_material.Material.update.__doc__, name


def check_bad_input(library):
    """One sound point beside one whose strain is no number: 0 and 3, the old values, and a sentence."""
    with barreno_material.Material(str(CARD), library) as rock:
        stress, state = rock.virgin(2)
        strain = numpy.array([[-1e-4, 0, 0, 0, 0, 0], [numpy.nan, 0, 0, 0, 0, 0]])
        answer = rock.update(strain, stress, state)
        assert list(answer.status) == [barreno_material.OK, barreno_material.BAD_INPUT], answer.status
        assert answer.stress[0, 0] < 0.0 and not answer.stress[1].any(), answer.stress
        assert "point 1 of the batch has an impossible step or state" in rock.why(), rock.why()


def main():
    check_names()
    check_bad_input(sys.argv[1])
    print("every status is documented")


if __name__ == "__main__":
    main()

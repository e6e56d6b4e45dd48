# SPDX-License-Identifier: BSD-3-Clause
"""CalculiX as a host: decks of a box of bricks, running them, reading what was printed."""

import itertools
import os
import pathlib
import re
import subprocess
import sys

import numpy

SKIPPED = 77  # what ctest counts as skipped


def skip(reason):
    """Ends the test as skipped; as failed where BARRENO_HOSTS=required says that every host has to be here."""
    required = os.environ.get("BARRENO_HOSTS") == "required"
    print("missing, but BARRENO_HOSTS=required:" if required else "skipped:", reason)
    sys.exit(1 if required else SKIPPED)


def program(folder):
    """The ccx that build_ccx.sh put into this folder, or that BARRENO_CCX names; one that opens material libraries."""
    ccx = pathlib.Path(os.environ.get("BARRENO_CCX") or pathlib.Path(folder) / "ccx")
    if not ccx.is_file():
        skip(f"no CalculiX at {ccx} (tests/hosts/build_ccx.sh builds it; see the output of that test).")
    symbols = subprocess.run(["nm", "-D", "--undefined-only", ccx], capture_output=True, text=True, check=True).stdout
    # Debian's own binary has no dlopen: it computes with zero stress and reports success.
    assert "dlopen" in symbols, f"{ccx} cannot open material libraries"
    return ccx


class Box:
    """Bricks of a box [0, lengths] with cells along each axis; node numbers from 1, x fastest."""

    def __init__(self, cells, lengths):
        self.cells = cells
        axes = [numpy.linspace(0.0, length, n + 1) for n, length in zip(cells, lengths)]
        self.nodes = numpy.array([(x, y, z) for z, y, x in itertools.product(axes[2], axes[1], axes[0])])
        self.lengths = lengths

    def node(self, i, j, k):
        return 1 + i + (self.cells[0] + 1) * (j + (self.cells[1] + 1) * k)

    def bricks(self):
        corners = [(0, 0, 0), (1, 0, 0), (1, 1, 0), (0, 1, 0), (0, 0, 1), (1, 0, 1), (1, 1, 1), (0, 1, 1)]
        for k, j, i in itertools.product(*(range(n) for n in reversed(self.cells))):
            yield [self.node(i + a, j + b, k + c) for a, b, c in corners]

    def face(self, axis, upper):
        """Node numbers of a face."""
        place = self.lengths[axis] if upper else 0.0
        return [i + 1 for i, x in enumerate(self.nodes) if abs(x[axis] - place) < 1e-9 * self.lengths[axis]]

    def bricks_at(self, axis):
        """Element numbers along the upper face of an axis."""
        upper = set(self.face(axis, True))
        return [e + 1 for e, brick in enumerate(self.bricks()) if len(upper & set(brick)) == 4]

    def deck(self):
        """Nodes, elements EALL, and the node sets XM XP YM YP ZM ZP. CalculiX reads at most 20 characters of a number."""
        lines = ["*NODE,NSET=NALL"]
        lines += [f"{i + 1},{x:.12g},{y:.12g},{z:.12g}" for i, (x, y, z) in enumerate(self.nodes)]
        lines.append("*ELEMENT,TYPE=C3D8,ELSET=EALL")
        lines += [f"{e + 1}," + ",".join(map(str, brick)) for e, brick in enumerate(self.bricks())]
        for axis, upper in itertools.product(range(3), (False, True)):
            lines.append(f"*NSET,NSET={'XYZ'[axis]}{'MP'[upper]}")
            lines += [f"{n}," for n in self.face(axis, upper)]
        return "\n".join(lines) + "\n"


def material(card, state_count, function="@ABAQUS_BARRENO_UMAT@"):
    name = function + card
    return (
        f"*MATERIAL,NAME={name}\n*USER MATERIAL,CONSTANTS=0\n*DEPVAR\n{state_count}\n"
        f"*SOLID SECTION,ELSET=EALL,MATERIAL={name}\n"
    )


# Residual forces relative to the mean force, and small corrections (the default lets 0.5 % pass); and patience: with
# the symmetric part of an unsymmetric tangent Newton's method takes many iterations.
TIGHT = (
    "*CONTROLS,PARAMETERS=FIELD\n1.E-8,1.E-7,0.,,1.E-8,1.E-8\n"
    "*CONTROLS,PARAMETERS=TIME INCREMENTATION\n60,60,9,200,10,4,,5\n"
)


def run(ccx, library, folder, deck, threads=1, name="deck", timeout=300):
    """Runs a deck: exit code, what was said, and the numbers of deck.dat by title and time."""
    folder = pathlib.Path(folder)
    (folder / f"{name}.inp").write_text(deck)
    environment = dict(os.environ, OMP_NUM_THREADS=str(threads), LD_LIBRARY_PATH=str(pathlib.Path(library).parent))
    environment["BARRENO_MATERIALS"] = str(folder)  # cards of a test's own lie beside its deck
    result = subprocess.run(
        [ccx, "-i", name], cwd=folder, env=environment, capture_output=True, text=True, timeout=timeout
    )
    return result.returncode, result.stdout + result.stderr, read_dat(folder / f"{name}.dat")


def read_dat(path):
    """{title: {time: array of rows}} of a .dat file, titles such as "stresses" and "total force"."""
    blocks = {}
    rows = None
    for line in path.read_text().splitlines() if path.exists() else []:
        head = re.match(r" *(stresses|strains|internal state variables|total force).* time +([0-9.E+-]+)$", line)
        if head:
            rows = blocks.setdefault(head.group(1), {}).setdefault(float(head.group(2)), [])
        elif rows is not None and line.strip():
            rows.append([float(word) for word in line.split()])
    return {title: {t: numpy.array(r) for t, r in times.items()} for title, times in blocks.items()}


def assert_job(code, said, card):
    """The job ended well and our library was in it, as its one line shows."""
    assert code == 0 and "Job finished" in said, said[-2000:]
    assert said.count(f"material {card} is") == 1, "the library did not say that it was opened, once:\n" + said[-2000:]

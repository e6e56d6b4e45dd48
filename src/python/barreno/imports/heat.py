# SPDX-License-Identifier: BSD-3-Clause
"""Heat: Uintah conducts it unless the file says no; nothing flows where all temperatures are the same."""

from barreno.imports.ups import ALL, TEXT

SWITCHES = ("DoExplicitHeatConduction", "DoImplicitHeatConduction")


def prescribed(root):
    """Elements of temperatures on faces."""
    entries = [entry for entry in root.find("Grid").element.iter("BCType") if entry.get("label", "").strip().lower() == "temperature"]
    return [value for entry in entries if entry.get("var", "").strip().lower() == "dirichlet" for value in entry.findall("value")]


def starts(root):
    """Elements of temperatures at which bodies begin, but for those that are left out."""
    materials = [one for one in root.find("MaterialProperties").find("MPM").element.findall("material") if (one, ALL) not in root.record]
    bodies = [body for one in materials for body in one.findall("geom_object") if (body, ALL) not in root.record]
    return [value for body in bodies for value in body.findall("temperature")]


def numbers_of(elements):
    out = set()
    for element in elements:
        try:
            out.add(float(element.text or ""))
        except ValueError:  # of another solver, which has words or tables there
            continue
    return sorted(out)


def read_heat(root, notes):
    """Says whether heat flows in the file: a deck conducts none."""
    flags = root.find("MPM")
    asked = [flags.flag(tag) for tag in SWITCHES]
    faces, bodies = prescribed(root), starts(root)
    found = numbers_of(faces + bodies)
    if any(asked):
        notes.lost("Conduction of heat is left out (Barreno's metals keep their heat where it arises).")
    elif len(found) > 1 and flags.flag(SWITCHES[0], default=True):
        root.record.update((element, what) for element in bodies for what in ("", TEXT))
        notes.lost(f"Heat that flows between bodies or faces of several temperatures, from {found[0]:g} to {found[-1]:g}, is left out (a "
            "deck conducts no heat).")
    elif faces:
        notes.add_neutral("BCType Dirichlet Temperature")

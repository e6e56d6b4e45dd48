#!/usr/bin/python3
# SPDX-License-Identifier: BSD-3-Clause
"""barreno import-ups names what it does not know: an unknown element, attribute or text at every place of two rich inputs, one
at a time, appears in the remarks or in the sentence that refuses the file. Words for numbers, and numbers that no simulation
has, at each of those places end in a deck or in one sentence, never in a traceback."""
import contextlib
import copy
import pathlib
import xml.etree.ElementTree as ElementTree

from barreno.imports import files
from barreno.imports.command import convert
from barreno.imports.notes import Notes
from barreno.imports.ups import Ups
from barreno.runs.faults import Fault

ROOT = pathlib.Path(__file__).resolve().parents[2]
UPS = ROOT / "tests" / "decks" / "ups"


def remarks_of(root, folder):
    notes = Notes()
    whole = Ups(root, "fuzz.ups")
    whole.mark()
    convert(whole, folder, "SI", {}, notes)
    return "\n".join(notes.sentences)


def rich_inputs():
    """The inputs of the other test, without what is left out whole, in whose place one remark stands."""
    projectile, jet = (files.read_ups(UPS / name).element for name in ("projectile.ups", "jet.ups"))
    place = jet.find("MaterialProperties/MPM")
    place.remove(place.findall("material")[2])
    projectile.find("MaterialProperties/MPM").append(ElementTree.fromstring("""<contact><type>specified</type><master_material>1</master_material><stop_time>3.0</stop_time><direction>[1, 1, 1]</direction>
        <velocity_after_stop>[0, 0, 0]</velocity_after_stop><materials>[0, 1]</materials></contact>"""))
    jet.find("PhysicalBC/MPM/pressure/load_curve").append(ElementTree.fromstring("<material>1</material>"))
    projectile.find("MPM").remove(projectile.find("MPM/erosion"))
    for metal in projectile.iter("constitutive_model"):
        for part in metal.findall("yield_condition"):
            metal.remove(part)
    return projectile, jet


def with_unknown(root, position, kind):
    """A copy with something new in the element at that position of the walk, or None."""
    new = copy.deepcopy(root)
    element = list(new.iter())[position]
    if kind == "element":
        ElementTree.SubElement(element, "zz_new").text = "7.5"
    elif kind == "attribute":
        element.set("zz_new", "7.5")
    elif len(element) or not (element.text or "").strip():
        (element if not len(element) else element[-1]).__setattr__("tail" if len(element) else "text", " zz_new ")
    else:
        return None
    return new


WORDS = ("", "often", "nan", "inf", "-1e308", "1e308", "1e-320", "-1", "0", "1.5", "[0, 0, 0]", "[-1e308, 1e308, 1e308]",
    "[1e-320, 1e-320, 1e-320]", "[1, 2]", "[5, 5, 5]")


def check_words():
    """Python's own exceptions end the test."""
    for root in rich_inputs():
        for element in root.iter():
            places = [lambda word, e=element, n=name: e.set(n, word)
                for name in element.attrib] + ([lambda word, e=element: setattr(e, "text", word)] if not len(element) else [])
            for put in places:
                kept = element.text, dict(element.attrib)
                for word in WORDS:
                    put(word)
                    with contextlib.suppress(Fault):
                        remarks_of(root, UPS)
                element.text = kept[0]
                element.attrib.update(kept[1])


def main():
    check_words()
    count = 0
    for root in rich_inputs():
        assert "zz_new" not in remarks_of(root, UPS)
        for position, element in enumerate(root.iter()):
            for kind in ("element", "attribute", "text"):
                new = with_unknown(root, position, kind)
                if new is None:
                    continue
                try:
                    answer = remarks_of(new, UPS)
                except Fault as fault:
                    answer = str(fault)
                assert "zz_new" in answer, f"{kind} in <{element.tag}> (number {position}) is lost in silence:\n{answer}"
                count += 1
    assert count > 600, count
    print(f"{count} unknown things are all in the remarks")


if __name__ == "__main__":
    main()

# SPDX-License-Identifier: BSD-3-Clause
"""The command: its words, the order of its work, what it says."""

import pathlib
import subprocess
import sys

from barreno import places
from barreno.imports.bodies import read_contents
from barreno.imports.conditions import read_conditions
from barreno.imports.deck import deck_text, table
from barreno.imports.files import read_ups
from barreno.imports.flags import gravity_of, output_of, step_of, time_of
from barreno.imports.heat import read_heat
from barreno.imports.interactions import read_contact
from barreno.imports.jet import read_jet
from barreno.imports.loads import read_loads
from barreno.imports.motion import read_motions
from barreno.imports.notes import Notes
from barreno.imports.space import grid_of, read_space
from barreno.imports.unread import note_unread
from barreno.runs.faults import FILE, USAGE, Fault, exit_code
from barreno.runs.tables import place
from barreno.runs.words import Words

EXAMPLE = "write for example barreno import-ups penetration.ups --out penetration.xml"
SCHEMA = 1  # of decks


def parse(words):
    parser = Words(
        "import-ups",
        EXAMPLE,
        "import.md",
        description="An input of Uintah's MPM (.ups) as a deck, and what of it cannot carry over (docs/import.md).",
        epilog="Example:\n  barreno import-ups penetration.ups --out penetration.xml\n\nExit codes: 0 the deck is written and barreno "
            "check takes it, 1 bad input, a deck that barreno check refuses, or with --strict an incomplete one, 2 file.",
    )
    parser.add_argument("file", metavar="FILE", help="input file of Uintah")
    parser.add_argument("--out", metavar="DECK", help="deck to write (default: FILE's name with .xml, in the working folder)")
    parser.add_argument("--units", default="SI", metavar="NAME",
        help="units of the file's numbers: SI (default), or those of length, time and mass, such as mm-us-g")
    parser.add_argument("--card", action="append", default=[], metavar='"MATERIAL=CARD"',
        help="a card of Barreno instead of a material of the file, as often as needed")
    parser.add_argument("--strict", action="store_true",
        help="exit code 1 where something that moves, loads, breaks or ends the simulation did not carry over")
    parser.add_argument("--overwrite", action="store_true", help="replace a deck that is there")
    return parser.parse_args(words)


def cards_of(options):
    cards = dict(word.split("=", 1) for word in options.card if "=" in word)
    for word in options.card:
        if "=" not in word or not all(part.strip() for part in word.split("=", 1)):
            raise Fault(f'--card "{word}" is not MATERIAL=CARD; write for example --card "Sandstone=berea_sandstone".')
    return {name.strip(): card.strip() for name, card in cards.items()}


def out_of(options):
    out = pathlib.Path(options.out) if options.out else pathlib.Path(pathlib.Path(options.file).stem + ".xml")
    if out.exists() and not options.overwrite:
        raise Fault(f"{out} exists already; name another deck with --out, or add --overwrite.", FILE)
    return out


def convert(root, folder, units, cards, notes):
    """@return (entries of the deck, Contents)"""
    space = read_space(root, notes)
    contents = read_contents(root, space, cards, notes)
    read_motions(root, folder, contents, space, notes)
    jet = read_jet(root, folder, contents, space, notes)
    if jet:
        jet["Slugs"] = table(jet["Slugs"])
    time = time_of(root)
    title = root.find("Meta").text("title", default="") or "Imported from Uintah"
    look_at_component(root, notes)
    entries = {
        "Schema Version": SCHEMA, "Title": " ".join(title.split()), "Units": units, "Grid": grid_of(space), "Materials": contents.materials,
        "Shapes": contents.shapes,
        "Bodies": contents.bodies, "Conditions": read_conditions(root, space, notes),
        "Loads": read_loads(root, contents, space, notes), "Jet": jet,
        "Body Force": gravity_of(root, space, notes), "Contact": read_contact(root, contents, notes), "Step": step_of(root, notes),
        "Time": time,
        "Output": output_of(root, time["End Time"], notes),
    }  # fmt: skip
    read_heat(root, notes)
    note_unread(root, notes)
    return entries, contents


def look_at_component(root, notes):
    """Parts of a file that another solver than the material point method reads are left out whole."""
    kind = root.find("SimulationComponent").attribute("type")
    if kind.lower().endswith("mpm") and kind.lower() != "mpm":
        notes.lost(f"SimulationComponent {kind} is read as mpm, the explicit material point method (a deck has no other); what {kind} adds "
            "to it or does in another way is left out.")
    elif kind.lower() not in ("", "mpm"):
        notes.lost(f"SimulationComponent {kind} is left out but for its material points (Barreno has the explicit material point method "
            "alone: no gas, no fluid on the grid).")
    for section, tags in ((root, ("CFD", "Models", "ICE", "Arches", "EqPort", "MPMICE")), (root.find("MaterialProperties"), ("ICE",))):
        for part in section.children(*tags):
            part.cover()
            notes.lost(f"<{part.tag}> is left out with all in it (it belongs to another solver than the material point method).")


def refuse_empty(deck, contents, entries):
    """A deck without materials or bodies: why."""
    if not contents.materials and contents.left:
        raise Fault(f"{deck} is written, but has no material: Barreno has no counterpart of the model of {listed(contents.left)}; choose a "
            "card for each with --card \"MATERIAL=CARD\".")
    if not contents.materials:
        raise Fault(f"{deck} is written, but has no material (the file has no <material> in MaterialProperties/MPM); add materials to the "
            "deck.")
    if not contents.bodies and not entries["Jet"]:
        left = f" or the models of their materials ({listed(contents.left)})" if contents.left else ""
        raise Fault(f"{deck} is written, but has no body: none of the file's has a counterpart of its shape{left}, as the remarks say; add "
            "bodies to the deck.")


def listed(names):
    return names[0] if len(names) == 1 else f"any of its {len(names)} materials ({', '.join(names[:3])}{', ...' if len(names) > 3 else ''})"


def check(deck):
    """The deck is sound, or `barreno check` has a sentence; its plan, which takes longer, is left out."""
    binary = places.program()
    if not binary:
        raise Fault(f"{deck} is written but not checked (the program barreno is not found); name it in BARRENO_PROGRAM.", FILE)
    try:
        result = subprocess.run([binary, "check", str(deck), "--print-deck"], capture_output=True, encoding="utf-8", errors="replace",
            check=False)
    except OSError as error:
        raise Fault(f"{deck} is written but not checked (the program {binary} cannot be started: {error.strerror}); name it in "
            "BARRENO_PROGRAM.", FILE) from None
    if result.returncode:
        said = result.stderr.strip().removeprefix("barreno: ") or "it cannot be checked."
        raise Fault(f"{deck} is written, but barreno check refuses it: {said}", result.returncode)


def run(words):
    options = parse(words)
    cards, out, notes = cards_of(options), out_of(options), Notes()
    root = read_ups(options.file)
    entries, contents = convert(root, pathlib.Path(options.file).resolve().parent, options.units, cards, notes)
    name = pathlib.Path(options.file).name
    head = [f"From {name}, an input of Uintah, by barreno import-ups (docs/import.md). What did not carry over:", *notes.sentences]
    place(out, deck_text(entries, head if notes.sentences else head[:1]))
    for sentence in notes.sentences:
        print(f"  - {sentence}")
    count = len(notes.sentences)
    print(f"{count} remark{'' if count == 1 else 's'}; the deck is {out}", flush=True)
    refuse_empty(out, contents, entries)
    check(out)
    if not notes.count_lost:
        print("The deck is valid.")
        return 0
    lost = notes.count_lost
    things, remarks = ("1 thing", "the first remark") if lost == 1 else (f"{lost} things", f"the first {lost} remarks")
    print(f"The deck is incomplete: {things} did not carry over ({remarks}); barreno check takes it as it is.")
    return USAGE if options.strict else 0


def main(words=None):
    for stream in (sys.stdout, sys.stderr):  # names of a file may have letters that a terminal lacks
        stream.reconfigure(errors="backslashreplace")
    return exit_code(run, sys.argv[1:] if words is None else words)

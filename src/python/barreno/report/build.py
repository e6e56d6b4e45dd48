# SPDX-License-Identifier: BSD-3-Clause
"""The report of a run: RUN/report with a page, its pictures, a profile of the hole and a script for ParaView."""

import dataclasses
import functools
import sys

from barreno.report.explore import Shown, explorable
from barreno.report.fields import PLASTIC_STRAIN, check_field, known_fields
from barreno.report.files import make_folder, reading, written, write_text
from barreno.report.hole import holes_of
from barreno.report.pages import as_html, as_markdown, write_pdf
from barreno.report.paraview import view_script, walls_text
from barreno.report.path_section import chosen_paths
from barreno.report.run import opened
from barreno.report.sections import all_sections, tip_of
from barreno.report.strength_picture import NEAR
from barreno.runs.faults import on_one_line
from barreno.runs.plots import plt

WALLS = "walls.csv"  # beside the script for ParaView


@dataclasses.dataclass
class Wishes:
    """What the words of the command ask for."""

    left: str = ""
    right: str = ""
    time: float = None  # [s]; the last one
    depths: list = dataclasses.field(default_factory=list)  # of rings around the hole [m]; three in rock
    particles: str = None  # whose stress paths are shown, as --particles says it
    pdf: bool = False
    measured: object = None  # report.measured.Measured


def fields_of(run, wishes):
    """The fields at the left and at the right; names that are none are refused."""
    with run.particles_read():
        known = known_fields(run.file, run.deck)
    for option, name in (("--left", wishes.left), ("--right", wishes.right)):
        if name:
            check_field(option, name, known)
    strain = next((name for name in PLASTIC_STRAIN if name in known), "shear_stress")
    return wishes.left or "pressure", wishes.right or strain


def paths_wished(run, wishes):
    """Stress paths, read before anything is written; none unless they are asked for."""
    if wishes.particles is None:
        return []
    table = run.depth_table()
    with run.particles_read():
        frame = run.frame(wishes.time)
        tip = tip_of(run, table, frame)
        return chosen_paths(run, wishes.particles, frame, tip, NEAR * tip[2] if tip else 0.0)


def save(picture, folder):
    with written(folder / f"{picture.name}.png") as aside:
        picture.figure.savefig(aside, dpi=130, bbox_inches="tight")


def write_pages(run, fields, shown, title, sections, pdf):
    folder = run.folder / "report"
    for section in sections:
        for picture in section.pictures:
            save(picture, folder)
    write_text(folder / "index.md", as_markdown(title, sections))
    write_text(folder / "index.html", explorable(functools.partial(as_html, title, sections, folder), run, fields, shown))
    if pdf:
        with written(folder / "report.pdf") as aside:
            write_pdf(aside, title, sections)


def make_report(folder, wishes=None):
    """Writes the page and its pictures. @return the page  @raises BadRun, Fault"""
    wishes = wishes or Wishes()
    with opened(folder) as run:
        fields = fields_of(run, wishes)
        run.step_at(wishes.time)
        paths = paths_wished(run, wishes)
        target = run.folder / "report"
        make_folder(target)
        try:
            sections = all_sections(run, fields, wishes, paths, target)
            with reading(run.folder / "summary.json"):
                title = on_one_line(run.summary.get("title") or run.folder.resolve().name)
            hole_of = holes_of(run, run.depth_table())
            write_pages(run, fields, Shown(hole_of, wishes.measured), title, sections, wishes.pdf)
        finally:
            plt.close("all")
        make_folder(target / "paraview")
        with run.particles_read():
            walls = walls_text(run, hole_of)
            if walls:
                write_text(target / "paraview" / WALLS, walls)
            write_text(target / "paraview" / "view.py", view_script(run, fields, wishes.time, WALLS if walls else ""))
        for remark in run.remarks():
            print(f"barreno: {on_one_line(remark)}", file=sys.stderr)
    return target / "index.html"

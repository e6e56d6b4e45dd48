# SPDX-License-Identifier: BSD-3-Clause
"""Words of the commands report and film."""

import pathlib

from barreno.runs.faults import FILE, Fault
from barreno.runs.words import LENGTH_UNITS, TIME_UNITS, Words, quantity_of

EXAMPLES = {
    "report": 'write for example barreno report runs/perforation-1 --left pressure --right plastic_volume_strain --time "30 us"',
    "film": "write for example barreno film runs/perforation-1 --field pressure",
}


def report_parser():
    parser = Words("report", EXAMPLES["report"], "report.md",
        description="Pictures and numbers of a run: RUN/report/index.html (docs/report.md).")
    parser.add_argument("run", metavar="RUN", help="run folder")
    parser.add_argument("--left", default="", metavar="FIELD", help="field at the left of the axis (default pressure)")
    parser.add_argument("--right", default="", metavar="FIELD", help="field at the right (default equivalent_plastic_strain)")
    parser.add_argument("--time", default="", metavar="TIME",
        help='of the pictures of particles, for example "30 us": the nearest that particles.e has (default: the last)')
    parser.add_argument("--depths", default="", metavar="LIST",
        help='below the outer face, of porosity against radius: "30 mm, 60 mm" (default: three in rock)')
    parser.add_argument("--particles", metavar="near tip|ID,...",
        help='stress paths of particles at the tip of the hole, "near tip", or by their numbers (as ParaView shows them): "120,340"')
    parser.add_argument("--measured", default="", metavar="FILE",
        help="a measured hole to compare with: CSV of radius against depth, TIFF of CT slices, or a folder of PNG slices")
    parser.add_argument("--pdf", action="store_true", help="report.pdf too")
    return parser


def film_parser():
    parser = Words("film", EXAMPLES["film"], "report.md",
        description="Particles in the colours of a field, from the start to the end of a run (docs/report.md).")
    parser.add_argument("run", metavar="RUN", help="run folder")
    parser.add_argument("--field", required=True, metavar="FIELD", help="field at both sides of the axis")
    parser.add_argument("--right", default="", metavar="FIELD", help="another field at the right")
    parser.add_argument("--out", default="", metavar="FILE",
        help=".gif (default RUN/report/FIELD.gif), .png (animated) or, with ffmpeg installed, .mp4")
    parser.add_argument("--per-second", type=float, default=6.0, metavar="N", help="pictures per second (default 6)")
    return parser


def time_of(option, text):
    """In s; None for no text."""
    try:
        return quantity_of(text, TIME_UNITS) if text else None
    except ValueError:
        raise Fault(f'{option} "{text.strip()}" is not a time; write for example {option} "30 us".') from None


def depths_of(option, text):
    """In m, in their order; none for no text."""
    try:
        return sorted(quantity_of(part, LENGTH_UNITS) for part in text.split(",")) if text else []
    except ValueError as error:
        raise Fault(f'{option} has "{str(error).strip()}", which is not a length; write for example {option} "30 mm, 60 mm".') from None


def check_folder(text):
    folder = pathlib.Path(text)
    if not folder.is_dir():
        raise Fault(f"'{text}' is not a folder (report and film read what a run wrote into it); check the path.", FILE)
    return folder

# SPDX-License-Identifier: BSD-3-Clause
"""A film of a run: one picture for every time of particles.e, with the same colours throughout."""

import shutil

import numpy as np
from matplotlib.animation import FFMpegWriter
from PIL import Image

from barreno.report.channel import draw_channel
from barreno.report.fields import look_in, range_of, values_of
from barreno.report.files import written
from barreno.report.hole import hole_at
from barreno.report.particles import areas_of
from barreno.report.view import View
from barreno.runs.faults import FILE, Fault
from barreno.runs.plots import plt

DPI = 80


def check_out(out):
    """The writer of a file by its end; what cannot be made is refused before anything is drawn."""
    if out.suffix not in (".gif", ".png", ".mp4"):
        raise Fault(f'--out "{out.name}" is no film that can be written; end it with .gif, .png (animated) or .mp4.')
    if out.suffix == ".mp4" and shutil.which("ffmpeg") is None:
        raise Fault(f'--out "{out.name}" needs ffmpeg, which is not installed; install the package ffmpeg, or end the name with .gif or '
            '.png.', FILE)
    if not out.parent.is_dir():
        raise Fault(f"--out {out}: '{out.parent}' is not a folder; make it first, or name another file.", FILE)


def box_of(run):
    """What particles ever cover, in mm, over both halves; the jet on its way to the target is left out at the edge of the grid."""
    lower, upper = run.deck.vector("Grid/Lower"), run.deck.vector("Grid/Upper")
    low, high = np.full(2, np.inf), np.full(2, -np.inf)
    for step in range(len(run.file.times)):
        shapes, _ = run.file.frame(step).shapes
        if len(shapes):
            low, high = np.minimum(low, shapes.min(axis=(0, 1))), np.maximum(high, shapes.max(axis=(0, 1)))
    if len(lower) >= 2 and len(upper) >= 2:
        low, high = np.maximum(low, lower[:2]), np.minimum(high, upper[:2])
    left = -high[0] if run.deck.mirrored() else low[0]
    return tuple(1e3 * float(value) for value in (left, high[0], low[1], high[1]))


def limits_over_time(run, field):
    """Colours that suit most pictures: the median over time of each one's range, widened to the last."""
    look, ranges = look_in(run.file, run.deck, field), []
    for step in range(len(run.file.times)):
        frame = run.file.frame(step)
        shapes, of = frame.shapes
        if len(of):
            ranges.append(range_of(values_of(frame, run.deck, field)[of] / look.scale, areas_of(shapes), look))
    low, high = np.array(ranges).T
    return min(float(np.median(low)), float(low[-1])), max(float(np.median(high)), float(high[-1]))


def pictures(run, left, right):
    """Figures, one after the other, all of one size."""
    box = box_of(run)
    limits, table = [limits_over_time(run, field) for field in (left, right)], run.depth_table()
    for step in range(len(run.file.times)):
        frame = run.file.frame(step)
        if frame.alive.any():
            hole = hole_at(run, table, frame)
            yield draw_channel(frame, run.deck, left, right, View(box=box, limits=limits, hole=hole if hole and hole.open_rows else None))


def grab(figure):
    """Pixels of a figure, (rows, columns, RGB)."""
    figure.set_dpi(DPI)
    figure.canvas.draw()
    pixels = np.asarray(figure.canvas.buffer_rgba())[:, :, :3].copy()
    plt.close(figure)
    return pixels


class Animation:
    """An animated GIF or PNG."""

    def __init__(self, per_second):
        self.images, self.duration = [], int(round(1000.0 / per_second))

    def add(self, pixels):
        self.images.append(Image.fromarray(pixels))

    def finish(self, aside, out):
        images = self.images
        if out.suffix == ".gif":  # the colours of each picture, without the dots that stand for colours in between
            images = [image.quantize(256, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE) for image in images]
        images[0].save(aside, save_all=True, append_images=images[1:], duration=self.duration, loop=0)


class Movie:
    """An MP4 by ffmpeg."""

    def __init__(self, per_second, aside):
        self.writer, self.aside, self.canvas = FFMpegWriter(fps=per_second), aside, None

    def add(self, pixels):
        if self.canvas is None:
            self.canvas = plt.figure(figsize=(pixels.shape[1] / DPI, pixels.shape[0] / DPI), dpi=DPI)
            self.image = self.canvas.figimage(pixels)
            self.writer.setup(self.canvas, str(self.aside), dpi=DPI)
        self.image.set_data(pixels)
        self.writer.grab_frame()

    def finish(self, *_):
        self.writer.finish()
        plt.close(self.canvas)


def write_film(out, run, left, right, per_second, progress):
    """@param progress  called with the number of pictures drawn and their count"""
    count = len(run.file.times)
    with written(out) as aside:
        film = Movie(per_second, aside) if out.suffix == ".mp4" else Animation(per_second)
        with run.particles_read():
            for number, figure in enumerate(pictures(run, left, right), 1):
                film.add(grab(figure))
                progress(number, count)
        film.finish(aside, out)

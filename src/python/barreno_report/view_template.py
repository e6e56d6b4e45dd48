# SPDX-License-Identifier: BSD-3-Clause
"""Text of view.py, which runs in ParaView alone: it imports nothing of this package."""

TEMPLATE = '''# SPDX-License-Identifier: BSD-3-Clause
"""The particles of a run in ParaView: pvpython view.py [--glyphs] [--time SECONDS] [--save PICTURE.png]

Or in ParaView itself: Tools, Python Shell, Run Script. Particles appear in their deformed shapes; with --glyphs, or where the file has
plain points, as balls of their size. Written by barreno report; change what you like.
"""
import argparse
import os
import sys

from paraview.simple import (
    Calculator, CellCenters, CellSize, ColorBy, CreateView, ExodusIIReader, GetActiveViewOrCreate, GetAnimationScene, GetColorTransferFunction,
    Glyph, Interact, Render, ResetCamera, SaveScreenshot, Show, Threshold, Transform,
)

HERE = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else os.getcwd()
# CONSTANTS


def existing(reader):
    """Particles that exist at the time: the others have status 0."""
    kept = Threshold(Input=reader, Scalars=["CELLS", "status"])
    if hasattr(kept, "LowerThreshold"):
        kept.LowerThreshold, kept.UpperThreshold = 0.5, 1.5
    else:  # before ParaView 5.10
        kept.ThresholdRange = [0.5, 1.5]
    return kept


def balls(source):
    """A ball at the centre of every particle, as wide as a square, or a cube, of its size."""
    sized = CellSize(Input=source, ComputeVertexCount=0, ComputeLength=0, ComputeArea=1, ComputeVolume=1)
    wide = Calculator(Input=sized, AttributeType="Cell Data", ResultArrayName="particle_size", Function="sqrt(Area) + Volume^(1/3)")
    centres = CellCenters(Input=wide, VertexCells=1)
    return Glyph(Input=centres, GlyphType="Sphere", ScaleArray=["POINTS", "particle_size"], ScaleFactor=1.0, GlyphMode="All Points")


def points(source):
    """Plain points have no shape: a ball of their size at the start, grown as their volume has."""
    wide = Calculator(Input=source, AttributeType="Cell Data", ResultArrayName="particle_size", Function=f"{SIZE!r}*volume_ratio^(1/{DIMENSIONS})")
    centres = CellCenters(Input=wide, VertexCells=1)
    return Glyph(Input=centres, GlyphType="Sphere", ScaleArray=["POINTS", "particle_size"], ScaleFactor=1.0, GlyphMode="All Points")


def mirrored(source):
    image = Transform(Input=source)
    image.Transform.Scale = [-1.0, 1.0, 1.0]
    return image


def show(source, view, field, on):
    array, component, colours, limits = field
    shown = Show(source, view)
    ColorBy(shown, (on, array, component) if component else (on, array))
    scale = GetColorTransferFunction(array)
    scale.ApplyPreset(colours, True)
    scale.RescaleTransferFunction(*limits)
    shown.SetScalarBarVisibility(view, True)


def look(view, time):
    view.ViewTime = time
    view.InteractionMode = "2D"
    view.CameraParallelProjection = 1
    ResetCamera(view)
    if DOWN:  # a jet is shown flying down
        x, y, _ = view.CameraFocalPoint
        distance = abs(view.CameraPosition[2] - view.CameraFocalPoint[2])
        view.CameraPosition, view.CameraViewUp = [x, y, -distance], [0.0, -1.0, 0.0]


def words():
    parser = argparse.ArgumentParser(description="The particles of a run in ParaView.")
    parser.add_argument("--glyphs", action="store_true", help="balls of the particles' size instead of their shapes")
    parser.add_argument("--time", type=float, default=TIME, help="in s")
    parser.add_argument("--save", metavar="PICTURE", help="write a picture instead of opening a window")
    return parser.parse_args(sys.argv[1:] if "__file__" in globals() else [])


def main():
    options = words()
    reader = ExodusIIReader(FileName=[os.path.join(HERE, FILES[0])])  # the others of a set are found by it
    reader.ElementBlocks = BLOCKS
    reader.ElementVariables = reader.ElementVariables.Available
    reader.ApplyDisplacements = 1
    GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    reader.UpdatePipeline(options.time)
    source, on = existing(reader), "CELLS"
    if POINTS or options.glyphs:
        source, on = (points if POINTS else balls)(source), "POINTS"
    view = GetActiveViewOrCreate("RenderView")
    show(source, view, RIGHT, on)
    # Two components of one vector would share their colours, and without an axis there is no other half.
    beside = view if MIRRORED and (LEFT == RIGHT or LEFT[0] != RIGHT[0]) else CreateView("RenderView")
    show(mirrored(source) if MIRRORED else source, beside, LEFT, on)
    for one in {id(view): view, id(beside): beside}.values():
        look(one, options.time)
        Render(one)
    if options.save:
        SaveScreenshot(options.save, view)
    elif "__file__" in globals() and "pvpython" in os.path.basename(sys.executable):
        Interact()


main()
'''

# SPDX-License-Identifier: BSD-3-Clause
"""Text of view.py, which runs in ParaView alone: it imports nothing of this package."""

TEMPLATE = '''# SPDX-License-Identifier: BSD-3-Clause
"""The particles of a run in ParaView: pvpython view.py [--glyphs] [--map] [--time SECONDS] [--save PICTURE.png] [--state FILE.pvsm]

Or in ParaView itself: File, Load State, of which this is one; or Tools, Python Shell, Run Script. Particles appear in their deformed shapes; with
--glyphs, or where the file has plain points, as balls of their size. With --map their colours are pressure and shear stress together. Written by
barreno report; change what you like.
"""
import argparse
import os
import sys

from paraview.simple import (
    Calculator, CellCenters, CellSize, ColorBy, CreateView, ExodusIIReader, GetActiveViewOrCreate, GetAnimationScene, GetColorTransferFunction,
    GetScalarBar, Glyph, Interact, LoadPalette, ProgrammableFilter, Render, ResetCamera, SaveScreenshot, SaveState, Show, Text, Threshold, Transform,
)

# CONSTANTS
# Of a run that was moved, where the script knows its own place.
HERE = os.path.dirname(os.path.abspath(__file__)) if "__file__" in globals() else FOLDER
PRESSURES = (30e6, 3e9)  # Pa: from white to full ink, logarithmic
SHEARS = (10e6, 600e6)
INKS = "cyan: pressure, 30 MPa to 3 GPa\\nmagenta: sqrt(J2), 10 to 600 MPa\\ndark: both; yellow: tension"


def existing(reader):
    """Particles that exist at the time: the others have status 0."""
    return between(reader, "status", 0.5, 1.5)


# What a filter of ParaView runs: an array "rubble" of the particles, 1 inside the wall of the hole that walls.csv has for the time.
FLAGGED = """
import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkDataObject

times, depths, radii = np.loadtxt(WALLS, delimiter=",", skiprows=1, ndmin=2).T


def flagged(leaf, time):
    new = leaf.NewInstance()
    new.ShallowCopy(leaf)
    known = times[times <= time * (1.0 + 1e-9)]
    if leaf.GetNumberOfCells() == 0 or len(known) == 0:
        found = np.zeros(leaf.GetNumberOfCells())
    else:
        points, cells = vtk_to_numpy(leaf.GetPoints().GetData()).astype(float), leaf.GetCells()
        first = vtk_to_numpy(cells.GetOffsetsArray())
        x, y, z = (np.add.reduceat(points[vtk_to_numpy(cells.GetConnectivityArray())], first[:-1]) / np.diff(first)[:, None]).T
        own = times == known.max()
        found = np.hypot(x, z) < np.interp(DIRECTION * (y - FACE), depths[own], radii[own], left=0.0, right=0.0)
    array = numpy_to_vtk(found.astype(float), deep=1)
    array.SetName("rubble")
    new.GetCellData().AddArray(array)
    return new


source, made = self.GetInputDataObject(0, 0), self.GetOutputDataObject(0)
time = source.GetInformation().Get(vtkDataObject.DATA_TIME_STEP())
if source.IsA("vtkCompositeDataSet"):
    made.CopyStructure(source)
    leaves = source.NewIterator()
    leaves.InitTraversal()
    while not leaves.IsDoneWithTraversal():
        made.SetDataSet(leaves, flagged(leaves.GetCurrentDataObject(), time))
        leaves.GoToNextItem()
else:
    made.ShallowCopy(flagged(source, time))
"""


def between(source, name, low, high):
    kept = Threshold(Input=source, Scalars=["CELLS", name])
    if hasattr(kept, "LowerThreshold"):
        kept.LowerThreshold, kept.UpperThreshold = low, high
    else:  # before ParaView 5.10
        kept.ThresholdRange = [low, high]
    return kept


def split(source):
    """Rock that holds together, and loose pieces of the target in the hole."""
    values = {"WALLS": os.path.join(HERE, WALLS), "FACE": FACE, "DIRECTION": DIRECTION}
    head = "".join(f"{name} = {value!r}\\n" for name, value in values.items())
    with_flag = ProgrammableFilter(Input=source, Script=head + FLAGGED)
    return between(with_flag, "rubble", -0.5, 0.5), between(with_flag, "rubble", 0.5, 1.5)


def balls(source):
    """A ball at the centre of every particle, as wide as a square, or a cube, of its size."""
    sized = CellSize(Input=source, ComputeVertexCount=0, ComputeLength=0, ComputeArea=1, ComputeVolume=1)
    wide = Calculator(Input=sized, AttributeType="Cell Data", ResultArrayName="particle_size", Function="sqrt(Area) + Volume^(1/3)")
    return glyphs(wide)


def glyphs(wide):
    centres = CellCenters(Input=wide, VertexCells=1)
    balls = Glyph(Input=centres, GlyphType="Sphere", ScaleArray=["POINTS", "particle_size"], GlyphMode="All Points")
    balls.ScaleFactor = 1.0  # behind the array, which sets it to a guess
    return balls


def points(source):
    """Plain points have no shape: a ball of their size at the start, grown as their volume has."""
    wide = Calculator(Input=source, AttributeType="Cell Data", ResultArrayName="particle_size", Function=f"{SIZE!r}*volume_ratio^(1/{DIMENSIONS})")
    return glyphs(wide)


def ink(name, ends):
    """Expression of 0 to 1 on a logarithmic scale."""
    low, high = ends
    return f"min(1, max(0, ln(max({name}, 1e-3)/{low!r})/ln({high!r}/{low!r})))"


def mapped(source, on):
    """Pressure and shear stress as one colour, an array "map" of red, green and blue."""
    cyan, magenta = ink("pressure", PRESSURES), ink("shear_stress", SHEARS)
    dark = f"(1 - 0.45*({cyan})*({magenta}))"
    parts = (f"{dark}*(1 - 0.9*({cyan}))", f"{dark}*(1 - 0.85*({magenta}))", f"{dark}*(1 - 0.9*if(pressure < 0, 1, 0))")
    kind = "Cell Data" if on == "CELLS" else "Point Data"
    return Calculator(Input=source, AttributeType=kind, ResultArrayName="map", Function=" + ".join(f"({part})*{axis}" for part, axis in zip(parts, ("iHat", "jHat", "kHat"))))


def show_plain(source, view):
    """Without light, which would turn the report's colours darker. @return what ParaView has of it in the view"""
    shown = Show(source, view)
    shown.Ambient, shown.Diffuse, shown.Specular = 1.0, 0.0, 0.0
    return shown


def show_map(source, view, on):
    shown = show_plain(source, view)
    ColorBy(shown, (on, "map"))
    shown.MapScalars = 0  # the array is the colour
    shown.SetScalarBarVisibility(view, False)


def mirrored(source):
    image = Transform(Input=source)
    image.Transform.Scale = [-1.0, 1.0, 1.0]
    return image


def show(source, view, field, on, place):
    array, component, points, title, _ = field
    shown = show_plain(source, view)
    ColorBy(shown, (on, array, component) if component else (on, array))
    scale = GetColorTransferFunction(array)
    scale.AutomaticRescaleRangeMode = "Never"
    scale.ColorSpace = "RGB"
    scale.RGBPoints = points
    scale.NanColor = WITHOUT
    shown.AmbientColor = shown.DiffuseColor = WITHOUT  # of a block that lacks the array
    shown.SetScalarBarVisibility(view, True)
    bar = GetScalarBar(scale, view)
    bar.Title, bar.ComponentTitle, bar.WindowLocation = title, "", place
    bar.Orientation = "Horizontal" if LYING else "Vertical"


def show_piece(source, view, field, on, place, colour):
    """In one colour, as in the report, where the field says nothing of jet and rubble."""
    if field[-1]:
        show(source, view, field, on, place)
        return
    shown = show_plain(source, view)
    shown.ColorArrayName = [on, ""]
    shown.AmbientColor = shown.DiffuseColor = shown.EdgeColor = colour
    shown.Representation = "Surface With Edges"  # pieces drawn out into needles are narrower than a pixel


def show_jet(*what):
    show_piece(*what, JET_COLOUR)


def show_rubble(*what):
    show_piece(*what, RUBBLE_COLOUR)


def show_half(sources, view, field, on, side):
    """@param sources  [(source, what shows it)]"""
    place = {"left": "Upper Center", "right": "Lower Center"}[side] if LYING else f"Upper {side.capitalize()} Corner"
    for source, how in sources:
        how(source, view, field, on, place)


def look(view, time):
    view.ViewTime = time
    view.ViewSize = SHAPE
    view.InteractionMode = "2D"
    view.CameraParallelProjection = 1
    if hasattr(view, "UseColorPaletteForBackground"):
        view.UseColorPaletteForBackground = 0
    view.Background = VOID
    ResetCamera(view)
    x, y, _ = view.CameraFocalPoint
    distance = abs(view.CameraPosition[2] - view.CameraFocalPoint[2])
    if LYING:  # depth along the picture, x down; a jet is shown flying to the right
        view.CameraPosition, view.CameraViewUp = [x, y, -distance if BACK else distance], [-1.0, 0.0, 0.0]
    elif DOWN:  # a jet is shown flying down
        view.CameraPosition, view.CameraViewUp = [x, y, -distance], [0.0, -1.0, 0.0]
    view.CameraParallelScale = HALF


def words():
    parser = argparse.ArgumentParser(description="The particles of a run in ParaView.")
    parser.add_argument("--glyphs", action="store_true", help="balls of the particles' size instead of their shapes")
    parser.add_argument("--map", action="store_true", help="colours of pressure and shear stress together, on both sides")
    parser.add_argument("--time", type=float, default=TIME, help="in s")
    parser.add_argument("--save", metavar="PICTURE", help="write a picture instead of opening a window")
    parser.add_argument("--state", metavar="FILE", help="write a state file (.pvsm) of this ParaView too")
    return parser.parse_args(sys.argv[1:] if "__file__" in globals() else [])


def show_fields(sources, view, on):
    """Two fields, or two views where they cannot share one. @return the views"""
    show_half(sources, view, RIGHT, on, "right")
    # Two components of one vector would share their colours, and without an axis there is no other half.
    beside = view if MIRRORED and (LEFT == RIGHT or LEFT[0] != RIGHT[0]) else CreateView("RenderView")
    show_half([(mirrored(source) if MIRRORED else source, how) for source, how in sources], beside, LEFT, on, "left")
    return list({id(view): view, id(beside): beside}.values())


def show_both(sources, view, on):
    """Both sides in the colours of the map, and what they mean."""
    for source, _ in sources:
        # A mirror would turn a colour over, which to ParaView is a vector.
        for one in (source, mirrored(source)) if MIRRORED else (source,):
            show_map(mapped(one, on), view, on)
    said = Show(Text(Text=INKS), view)
    said.WindowLocation, said.FontSize = "Lower Left Corner", 14
    return [view]


def read(blocks):
    reader = ExodusIIReader(FileName=[os.path.join(HERE, FILES[0])])  # the others of a set are found by it
    reader.ElementBlocks = blocks
    reader.ElementVariables = reader.ElementVariables.Available
    reader.ApplyDisplacements = 1
    return reader


def main():
    options = words()
    groups = [(TARGET, show), (OTHERS, show), (JET, show_jet)]
    readers = [(read(blocks), how, blocks is TARGET) for blocks, how in groups if blocks]
    scene = GetAnimationScene()
    scene.UpdateAnimationUsingDataTimeSteps()
    scene.AnimationTime = options.time  # which a state file keeps
    LoadPalette("WhiteBackground")
    sources, on = [], "CELLS"
    for reader, how, of_target in readers:
        reader.UpdatePipeline(options.time)
        source = existing(reader)
        sources += zip(split(source), (show, show_rubble)) if of_target and WALLS else [(source, how)]
    if POINTS or options.glyphs:
        sources, on = [((points if POINTS else balls)(source), how) for source, how in sources], "POINTS"
    view = GetActiveViewOrCreate("RenderView")
    views = (show_both if options.map else show_fields)(sources, view, on)
    for one in views:
        look(one, options.time)
        Render(one)
    if options.state:
        SaveState(options.state)
    if options.save:
        SaveScreenshot(options.save, view, ImageResolution=SHAPE)
    elif not options.state and "__file__" in globals() and "pvpython" in os.path.basename(sys.executable):
        Interact()


main()
'''

// SPDX-License-Identifier: BSD-3-Clause
#include "deck/shape_entries.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

std::vector<Entry> round_entries() {
  return {
      vector(
          "Centre",
          dim::length,
          any(),
          "centre of a ball, on the axis in axisymmetry; of a cylinder in plane strain, which is a "
          "disk; on a face of the grid it is cut there"
      )
          .if_given(),
      vector(
          "Start",
          dim::length,
          any(),
          "where the middle line of a cylinder or cone begins; in axisymmetry on the axis; a face "
          "of the "
          "grid that holds the line cuts the body"
      )
          .if_given(),
      vector("End", dim::length, any(), "where that line ends").if_given(),
      number("Radius", dim::length, above(0.0), "of a ball or a cylinder; of a cone at Start")
          .if_given(),
      number("End Radius", dim::length, at_least(0.0), "of a cone at End; a tip without it")
          .if_given(),
      number(
          "Inner Radius",
          dim::length,
          above(0.0),
          "radius of a ball's or a cylinder's hollow; solid without it"
      )
          .if_given()};
}

std::vector<Entry> flat_entries() {
  return {
      table(
          "Corners",
          {dim::length, dim::length},
          "of a polygon in order, a row each; in three dimensions in the two coordinates across "
          "Axis, in "
          "their order; edges do not cross"
      )
          .if_given(),
      word("Axis", {"x", "y", "z"}, "along which a polygon is extruded; three dimensions only")
          .if_given(),
      number("From", dim::length, any(), "where the extrusion begins on Axis").if_given(),
      number("To", dim::length, any(), "where it ends").if_given(),
      vector("Point", dim::length, any(), "on the plane that bounds a half-space").if_given(),
      vector(
          "Normal",
          dim::none,
          any(),
          "of that plane, out of the body, of any length; the half-space ends with the grid"
      )
          .if_given()};
}

std::vector<Entry> made_entries() {
  return {
      words(
          "Parts",
          {},
          "names of lists in Shapes: of a union, an intersection, or a difference (the first "
          "without "
          "the others)"
      )
          .if_given(),
      file(
          "File",
          "STL file of a closed surface, normals outward, relative to the deck; three dimensions "
          "only"
      )
          .if_given(),
      text(
          "File Digest",
          "CRC-32 of the STL file in hexadecimal digits: another file of that name is refused; "
          "deck.xml of a run has it"
      )
          .if_given(),
      number("File Unit", dim::length, above(0.0), "length of 1 in the STL file, which has no unit")
          .if_given(),
      vector("Shift", dim::length, any(), "added to the corners of the STL file; none without it")
          .if_given()};
}

}  // namespace

std::vector<Entry> shape_entries(const std::string& shape) {
  Entry choice = word(
      "Shape",
      {"box",
       "ball",
       "cylinder",
       "cone",
       "polygon",
       "half-space",
       "union",
       "difference",
       "intersection",
       "STL"},
      "box: Lower and Upper; ball: Centre, Radius; cylinder: Start, End, Radius (plane strain: "
      "Centre, "
      "Radius); cone: Start, End, Radius, End Radius (not in plane strain); polygon: Corners "
      "(three "
      "dimensions: Axis, From and To too); half-space: Point, Normal; union, difference and "
      "intersection: "
      "Parts; STL: File, File Unit (three dimensions only). In axisymmetry a shape is a figure in "
      "{r, "
      "axial}, turned about the axis"
  );
  if (!shape.empty()) choice = choice.by_default(shape);
  std::vector<Entry> entries{
      choice,
      vector("Lower", dim::length, any(), "lower corner of a box").if_given(),
      vector("Upper", dim::length, any(), "upper corner of a box").if_given()};
  for (const auto& group : {round_entries(), flat_entries(), made_entries()})
    entries.insert(entries.end(), group.begin(), group.end());
  return entries;
}

}  // namespace barreno

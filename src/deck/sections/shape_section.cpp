// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/shape_section.hpp"

#include "deck/section_table.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

Entries<ShapeSection> choice_entries() {
  return {
      needed(
          &ShapeSection::word,
          "Shape",
          "box: Lower and Upper; ball: Centre, Radius; cylinder: Start, End, Radius (plane strain: "
          "Centre, Radius); cone: Start, End, Radius, End Radius (not in plane strain); polygon: "
          "Corners, Arcs (three dimensions: Axis, From and To too); half-space: Point, Normal; "
          "union, "
          "difference and intersection: Parts; STL: File, File Unit (three dimensions only). In "
          "axisymmetry a shape is a figure in {r, axial}, turned about the axis"
      ),
      if_given(&ShapeSection::lower, "Lower", dim::length, any(), "lower corner of a box"),
      if_given(&ShapeSection::upper, "Upper", dim::length, any(), "upper corner of a box")};
}

Entries<ShapeSection> round_entries() {
  return {
      if_given(
          &ShapeSection::centre,
          "Centre",
          dim::length,
          any(),
          "centre of a ball, on the axis in axisymmetry; of a cylinder in plane strain, which is a "
          "disk; a centre on a face of the grid cuts the body there"
      ),
      if_given(
          &ShapeSection::start,
          "Start",
          dim::length,
          any(),
          "start of the centre line of a cylinder or cone; in axisymmetry on the axis; a face of "
          "the grid that contains this line cuts the body"
      ),
      if_given(&ShapeSection::end, "End", dim::length, any(), "end of that line"),
      if_given(
          &ShapeSection::radius,
          "Radius",
          dim::length,
          above(0.0),
          "of a ball or a cylinder; of a cone at Start"
      ),
      if_given(
          &ShapeSection::end_radius,
          "End Radius",
          dim::length,
          at_least(0.0),
          "of a cone at End; a tip without it"
      ),
      if_given(
          &ShapeSection::inner_radius,
          "Inner Radius",
          dim::length,
          above(0.0),
          "radius of the cavity of a ball or a cylinder; solid without it"
      )};
}

Entries<ShapeSection> flat_entries() {
  return {
      if_given(
          &ShapeSection::corners,
          table(
              "Corners",
              {dim::length, dim::length},
              "of a polygon in order, one per row; in three dimensions the two coordinates normal "
              "to Axis, in their order; edges must not cross"
          )
      ),
      if_given(
          &ShapeSection::arcs,
          table(
              "Arcs",
              {dim::none, dim::length, dim::length},
              "edges of a polygon that are arcs of circles, a row each: number of the corner that "
              "the edge starts from, counted from 1, and a point of the arc between its ends; an "
              "arc becomes chords of 1 degree or less that enclose its area"
          )
      ),
      if_given(
          &ShapeSection::axis,
          "Axis",
          Words<int>{{"x", 0}, {"y", 1}, {"z", 2}},
          "along which a polygon is extruded; three dimensions only"
      ),
      if_given(
          &ShapeSection::from, "From", dim::length, any(), "where the extrusion begins on Axis"
      ),
      if_given(&ShapeSection::to, "To", dim::length, any(), "where it ends"),
      if_given(
          &ShapeSection::point, "Point", dim::length, any(), "on the plane that bounds a half-space"
      ),
      if_given(
          &ShapeSection::normal,
          "Normal",
          dim::none,
          any(),
          "of that plane, pointing out of the body, of any length; the half-space ends at the grid"
      )};
}

Entries<ShapeSection> made_entries() {
  return {
      if_given(
          &ShapeSection::parts,
          words(
              "Parts",
              {},
              "names of lists in Shapes: of a union, an intersection, or a difference (the first "
              "without the others)"
          )
      ),
      if_given(
          &ShapeSection::file,
          file(
              "File",
              "STL file of a closed surface, normals outward, relative to the deck; three "
              "dimensions only"
          )
      ),
      if_given(
          &ShapeSection::file_digest,
          "File Digest",
          "CRC-32 of the STL file in hexadecimal digits: another file of that name is refused; "
          "deck.xml of a run has it"
      ),
      if_given(
          &ShapeSection::file_unit,
          "File Unit",
          dim::length,
          above(0.0),
          "length of 1 in the STL file, which has no unit"
      ),
      if_given(
          &ShapeSection::shift,
          "Shift",
          dim::length,
          any(),
          "added to the corners of the STL file; none without it"
      )};
}

SectionTable<ShapeSection> shape_table() {
  return {
      "Shapes",
      "shapes that bodies can be combined from, one freely named list each",
      Presence::defaulted,
      joined<ShapeSection>({choice_entries(), round_entries(), flat_entries(), made_entries()}),
      "one shape"};
}

}  // namespace

template <>
const SectionTable<ShapeSection>& table_of<ShapeSection>() {
  static const SectionTable<ShapeSection> table = shape_table();
  return table;
}

std::vector<input::Entry> shape_entries() {
  std::vector<input::Entry> entries = entries_of<ShapeSection>();
  entries.front() = entries.front().by_default(word_of(ShapeSection{}.word));
  return entries;
}

}  // namespace barreno

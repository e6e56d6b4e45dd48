// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"
#include "deck/words.hpp"
#include "geometry/shape.hpp"

#include <barreno/input/schema.hpp>
#include <optional>
#include <string>
#include <vector>

namespace barreno {

enum class ShapeWord {
  box,
  ball,
  cylinder,
  cone,
  polygon,
  half_space,
  joined,
  difference,
  intersection,
  stl
};
inline Words<ShapeWord> words_of(ShapeWord /*of*/) {
  return {
      {"box", ShapeWord::box},
      {"ball", ShapeWord::ball},
      {"cylinder", ShapeWord::cylinder},
      {"cone", ShapeWord::cone},
      {"polygon", ShapeWord::polygon},
      {"half-space", ShapeWord::half_space},
      {"union", ShapeWord::joined},
      {"difference", ShapeWord::difference},
      {"intersection", ShapeWord::intersection},
      {"STL", ShapeWord::stl}};
}

/// What a list of Shapes or Bodies says of its shape; which entries are there depends on the word.
struct ShapeSection {
  ShapeWord word = ShapeWord::box;
  Vector lower{}, upper{};                      ///< of a box [length]
  Vector centre{};                              ///< of a ball [length]
  Vector start{}, end{};                        ///< of a cylinder's or cone's middle line [length]
  double radius = 0.0;                          ///< [length]
  double end_radius = 0.0, inner_radius = 0.0;  ///< a tip, and solid, without them [length]
  std::vector<std::vector<double>> corners;     ///< of a polygon, a row each [length]
  std::vector<std::vector<double>> arcs;        ///< of its edges: {number, point [length]}
  int axis = 2;                                 ///< along which it is extruded
  double from = 0.0, to = 0.0;                  ///< on that axis [length]
  Vector point{}, normal{};                     ///< of the plane that bounds a half-space
  std::vector<std::string> parts;               ///< names in Shapes
  std::string file, file_digest;                ///< of an STL surface
  double file_unit = 1.0;                       ///< length of 1 in the file [length]
  Vector shift{};                               ///< added to its corners [length]
};
template <>
const SectionTable<ShapeSection>& table_of<ShapeSection>();

/// The entries of a shape for lists that hold more than that, where Shape may be left out.
std::vector<input::Entry> shape_entries();

}  // namespace barreno

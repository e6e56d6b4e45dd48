// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "deck/sections/shape_section.hpp"
#include "geometry/drawn_polygon.hpp"
#include "geometry/surface.hpp"
#include "scene/geometry.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>
#include <cmath>
#include <map>

namespace barreno {
namespace {

using input::join;
using Names = std::vector<std::string>;

/// A list of the deck that says a shape.
struct GivenShape {
  const Deck& deck;
  std::string path;
  Mode mode;
  ShapeSection said;
};

template <class T>
std::string entry_of(const GivenShape& list, T ShapeSection::*member) {
  return join(list.path, name_of(member));
}
template <class T>
bool is_given(const GivenShape& list, T ShapeSection::*member) {
  return list.deck.has(entry_of(list, member));
}
template <class T>
[[noreturn]] void refuse(
    const GivenShape& list, T ShapeSection::*member, const std::string& problem
) {
  list.deck.refuse_value(entry_of(list, member), problem);
}

template <class... Members>
Names names_of(Members... members) {
  return {name_of(members)...};
}

/// The parameters of a shape in a mode, and how sentences call it.
struct Keys {
  std::string called;
  Names needed, allowed;
};

Keys keys_of_round(ShapeWord word, Mode mode) {
  using S = ShapeSection;
  const Names hollow = names_of(&S::inner_radius), ball = names_of(&S::centre, &S::radius);
  if (word == ShapeWord::ball) return {"a ball", ball, hollow};
  if (word == ShapeWord::cylinder && mode == Mode::plane_strain)
    return {"a cylinder in plane strain", ball, hollow};
  const Names line = names_of(&S::start, &S::end, &S::radius);
  if (word == ShapeWord::cylinder) return {"a cylinder", line, hollow};
  return {"a cone", line, names_of(&S::end_radius)};
}

Keys keys_of(ShapeWord word, Mode mode) {
  using S = ShapeSection;
  const Names arcs = names_of(&S::arcs);
  switch (word) {
    case ShapeWord::box:
      return {"a box", names_of(&S::lower, &S::upper), {}};
    case ShapeWord::ball:
    case ShapeWord::cylinder:
    case ShapeWord::cone:
      return keys_of_round(word, mode);
    case ShapeWord::polygon:
      if (dimensions(mode) == 2)
        return {"a polygon in two dimensions", names_of(&S::corners), arcs};
      return {
          "a polygon in three dimensions", names_of(&S::corners, &S::axis, &S::from, &S::to), arcs};
    case ShapeWord::half_space:
      return {"a half-space", names_of(&S::point, &S::normal), {}};
    case ShapeWord::stl:
      return {
          "an STL surface",
          names_of(&S::file, &S::file_unit),
          names_of(&S::shift, &S::file_digest)};
    case ShapeWord::joined:
    case ShapeWord::difference:
    case ShapeWord::intersection:
      break;
  }
  const char* const article = word == ShapeWord::intersection ? "an " : "a ";
  return {article + word_of(word), names_of(&S::parts), {}};
}

/// Refuse a parameter of another shape, which would be read and do nothing.
void check_keys(const GivenShape& list) {
  const Keys keys = keys_of(list.said.word, list.mode);
  const auto in = [](const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const std::string& name : keys.needed) {
    const std::string entry = join(list.path, name);
    if (list.deck.has(entry)) continue;
    list.deck.refuse(entry, "is missing (" + keys.called + " needs it); add it or change Shape");
  }
  for (const input::Entry& entry : entries_of<ShapeSection>()) {
    const std::string& name = entry.name;
    if (name == name_of(&ShapeSection::word) || in(keys.needed, name) || in(keys.allowed, name))
      continue;
    if (list.deck.has(join(list.path, name)))
      list.deck.refuse_value(
          join(list.path, name), "has no meaning for " + keys.called + "; remove it or change Shape"
      );
  }
}

/// Shapes that a mode cannot have.
void check_mode(const GivenShape& list) {
  const ShapeWord word = list.said.word;
  if (word == ShapeWord::cone && list.mode == Mode::plane_strain) {
    refuse(
        list,
        &ShapeSection::word,
        "has no meaning in plane strain (there is no axis of rotation); write a polygon"
    );
  }
  if (word == ShapeWord::stl && dimensions(list.mode) != 3) {
    refuse(
        list,
        &ShapeSection::word,
        "needs three dimensions (a surface does not define a plane figure); write a polygon"
    );
  }
}

Shape read_box(const GivenShape& list) {
  const Box box{list.said.lower, list.said.upper};
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(list.mode)); ++i) {
    if (box.upper[i] > box.lower[i]) continue;
    refuse(
        list,
        &ShapeSection::upper,
        std::string("is not above Lower along ") + "xyz"[i] + " (the body is empty); swap the two"
    );
  }
  return box;
}

/// The hollow is inside.
void check_inner_radius(const GivenShape& list) {
  const bool hollow = is_given(list, &ShapeSection::inner_radius);
  if (hollow && !(list.said.inner_radius < list.said.radius)) {
    refuse(
        list,
        &ShapeSection::inner_radius,
        "is not below Radius (the body is empty); make it smaller"
    );
  }
}

Shape read_ball(const GivenShape& list) {
  const Ball ball{list.said.centre, list.said.radius, list.said.inner_radius};
  check_inner_radius(list);
  if (list.mode == Mode::axisymmetric && ball.centre[0] != 0.0) {
    refuse(
        list, &ShapeSection::centre, "is off the axis (the ball would be a ring); put it at x = 0"
    );
  }
  return ball;
}

/// A round body about the axis as its figure in {r, axial}: a box, so that its faces can be
/// pressed, or a polygon.
Shape figure_of(const Cone& cone) {
  const double from = std::min(cone.start[1], cone.end[1]),
               to = std::max(cone.start[1], cone.end[1]);
  if (cone.start_radius == cone.end_radius)
    return Box{{cone.inner_radius, from, 0.0}, {cone.start_radius, to, 0.0}};
  Polygon figure;
  figure.corners = {{0.0, cone.start[1]}, {cone.start_radius, cone.start[1]}};
  if (cone.end_radius > 0.0) figure.corners.push_back({cone.end_radius, cone.end[1]});
  figure.corners.push_back({0.0, cone.end[1]});
  return figure;
}

Shape read_round(const GivenShape& list) {
  if (list.mode == Mode::plane_strain) return read_ball(list);  // a disk
  const ShapeSection& said = list.said;
  const double end_radius = said.word == ShapeWord::cone ? said.end_radius : said.radius;
  const Cone cone{said.start, said.end, said.radius, end_radius, said.inner_radius};
  check_inner_radius(list);
  if (cone.start == cone.end) {
    refuse(
        list, &ShapeSection::end, "coincides with Start (the body is empty); move one of the two"
    );
  }
  if (list.mode != Mode::axisymmetric) return cone;
  for (const auto member : {&ShapeSection::start, &ShapeSection::end}) {
    if ((said.*member)[0] == 0.0) continue;
    refuse(list, member, "is off the axis (the body would not be axisymmetric); put it at x = 0");
  }
  return figure_of(cone);
}

Shape read_polygon(const GivenShape& list) {
  std::string problem;
  const DrawnPolygon drawn = draw_polygon(list.said.corners, list.said.arcs, problem);
  if (!problem.empty()) refuse(list, &ShapeSection::arcs, problem);
  Polygon polygon;
  polygon.corners = drawn.corners;
  if (dimensions(list.mode) == 3) {
    polygon.axis = list.said.axis;
    polygon.from = list.said.from;
    polygon.to = list.said.to;
    if (!(polygon.to > polygon.from))
      refuse(list, &ShapeSection::to, "is not above From (the body is empty); swap the two");
  }
  if (polygon.corners.size() < 3 || measure_bound(Shape(polygon), 2) == 0.0) {
    refuse(
        list,
        &ShapeSection::corners,
        "enclose no area (the body is empty); give three corners or more"
    );
  }
  constexpr std::size_t max_corners = 10000;  // every edge is compared with every other
  if (polygon.corners.size() > max_corners) {
    refuse(
        list,
        &ShapeSection::corners,
        "has more than " + std::to_string(max_corners) +
            " corners, one per degree of an arc among them (too many to compare); leave out those "
            "that matter least"
    );
  }
  const auto edges = crossing_edges(drawn);
  if (!edges.empty()) {
    refuse(
        list,
        &ShapeSection::corners,
        "has edges " + std::to_string(edges[0]) + " and " + std::to_string(edges[1]) +
            " that cross (inside and outside are not defined); put the corners in order"
    );
  }
  return polygon;
}

Shape read_half_space(const GivenShape& list) {
  HalfSpace half{list.said.point, list.said.normal};
  const double length = length_of(half.normal);
  if (!(length > 0.0))
    refuse(list, &ShapeSection::normal, "is zero (it has no direction); give a nonzero vector");
  for (double& component : half.normal) component /= length;
  return half;
}

/// A shape of the deck's Shapes, and of how many shapes it is made.
struct NamedShape {
  Shape shape;
  int shapes = 0;
};

/// Where in the tree of parts a shape is read: the combinations around it, and the number of shapes
/// so far. Shapes that name shapes twice over would else grow without bound.
struct Reached {
  std::vector<std::string> within;
  int shapes = 0;
  std::map<std::string, NamedShape> read;  ///< a shape that many name is read once
};

void check_number(const GivenShape& list, const Reached& reached) {
  constexpr int max_shapes = 1000;
  if (reached.shapes <= max_shapes) return;
  refuse(
      list,
      &ShapeSection::parts,
      "makes a shape of more than " + std::to_string(max_shapes) +
          " shapes (parts of parts count); make it simpler, or an STL surface"
  );
}

Shape read_any(const Deck& deck, const std::string& path, Mode mode, Reached& reached);

Shape read_named(const Deck& deck, const std::string& name, Mode mode, Reached& reached) {
  if (const auto known = reached.read.find(name); known != reached.read.end()) {
    reached.shapes += known->second.shapes;
    return known->second.shape;
  }
  const int before = reached.shapes;
  reached.within.push_back(name);
  Shape shape = read_any(deck, list_of<ShapeSection>(name), mode, reached);
  reached.within.pop_back();
  reached.read[name] = {shape, reached.shapes - before};
  return shape;
}

Shape read_combination(const GivenShape& list, Reached& reached) {
  Combination combination;
  if (list.said.word == ShapeWord::difference) combination.operation = Operation::subtract;
  if (list.said.word == ShapeWord::intersection) combination.operation = Operation::intersect;
  const Names names = list.deck.lists(table_of<ShapeSection>().path), &parts = list.said.parts;
  if (parts.size() < 2)
    refuse(list, &ShapeSection::parts, "names fewer than two shapes; name all shapes to combine");
  for (const std::string& part : parts) {
    if (std::find(names.begin(), names.end(), part) == names.end()) {
      refuse(
          list,
          &ShapeSection::parts,
          "names '" + part + "', which is not in Shapes; " +
              (names.empty() ? "add that section with the shape" : input::suggest_name(part, names))
      );
    }
    const auto& within = reached.within;
    if (std::find(within.begin(), within.end(), part) != within.end()) {
      refuse(
          list,
          &ShapeSection::parts,
          "names '" + part + "', of which this is a part (a shape cannot contain itself); remove it"
      );
    }
    ++reached.shapes;
    check_number(list, reached);  // before the parts of the part, which may be nested deep
    combination.parts.push_back(read_named(list.deck, part, list.mode, reached));
    check_number(list, reached);
  }
  return combination;
}

Shape read_any(const Deck& deck, const std::string& path, Mode mode, Reached& reached) {
  const GivenShape list{deck, path, mode, read_list<ShapeSection>(deck, path)};
  check_mode(list);
  check_keys(list);
  switch (list.said.word) {
    case ShapeWord::box:
      return read_box(list);
    case ShapeWord::ball:
      return read_ball(list);
    case ShapeWord::cylinder:
    case ShapeWord::cone:
      return read_round(list);
    case ShapeWord::polygon:
      return read_polygon(list);
    case ShapeWord::half_space:
      return read_half_space(list);
    case ShapeWord::stl:
      return Faceted{deck.surfaces.at(path)};
    case ShapeWord::joined:
    case ShapeWord::difference:
    case ShapeWord::intersection:
      break;
  }
  return read_combination(list, reached);
}

}  // namespace

Shape read_shape(const Deck& deck, const std::string& path, Mode mode) {
  Reached reached;
  return read_any(deck, path, mode, reached);
}

void check_shapes(const Deck& deck, Mode mode) {
  Reached reached;
  for (const std::string& name : deck.lists(table_of<ShapeSection>().path)) {
    reached.shapes = 0;
    read_named(deck, name, mode, reached);
  }
}

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#include "geometry/surface.hpp"
#include "scene/geometry.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>
#include <cmath>

namespace barreno {
namespace {

using Names = std::vector<const char*>;

/// The parameters of a shape in a mode, and how sentences call it.
struct Keys {
  std::string called;
  Names needed, allowed;
};

Keys keys_of(const std::string& shape, Mode mode) {
  const bool plane = mode == Mode::plane_strain, space = dimensions(mode) == 3;
  if (shape == "box") return {"a box", {"Lower", "Upper"}, {}};
  if (shape == "ball") return {"a ball", {"Centre", "Radius"}, {"Inner Radius"}};
  if (shape == "cylinder" && plane)
    return {"a cylinder in plane strain", {"Centre", "Radius"}, {"Inner Radius"}};
  if (shape == "cylinder") return {"a cylinder", {"Start", "End", "Radius"}, {"Inner Radius"}};
  if (shape == "cone") return {"a cone", {"Start", "End", "Radius"}, {"End Radius"}};
  if (shape == "polygon" && space)
    return {"a polygon in three dimensions", {"Corners", "Axis", "From", "To"}, {}};
  if (shape == "polygon") return {"a polygon in two dimensions", {"Corners"}, {}};
  if (shape == "half-space") return {"a half-space", {"Point", "Normal"}, {}};
  if (shape == "STL") return {"an STL surface", {"File", "File Unit"}, {"Shift", "File Digest"}};
  return {(shape == "intersection" ? "an " : "a ") + shape, {"Parts"}, {}};
}

/// Refuse a parameter of another shape, which would be read and do nothing.
void check_keys(const Deck& deck, const std::string& path, const Keys& keys) {
  const auto in = [](const Names& names, const std::string& name) {
    return std::find(names.begin(), names.end(), name) != names.end();
  };
  for (const char* name : keys.needed) {
    if (deck.has(path + "/" + name)) continue;
    deck.refuse(
        path + "/" + name, "is missing (" + keys.called + " needs it); add it or change Shape"
    );
  }
  for (const char* name :
       {"Lower",
        "Upper",
        "Centre",
        "Start",
        "End",
        "Radius",
        "End Radius",
        "Inner Radius",
        "Corners",
        "Axis",
        "From",
        "To",
        "Point",
        "Normal",
        "Parts",
        "File",
        "File Unit",
        "Shift"}) {
    if (!deck.has(path + "/" + name) || in(keys.needed, name) || in(keys.allowed, name)) continue;
    deck.refuse_value(
        path + "/" + name, "has no meaning for " + keys.called + "; remove it or change Shape"
    );
  }
}

/// Shapes that a mode cannot have.
void check_mode(const Deck& deck, const std::string& path, const std::string& shape, Mode mode) {
  if (shape == "cone" && mode == Mode::plane_strain) {
    deck.refuse_value(
        path + "/Shape", "has no meaning in plane strain (nothing is round there); write a polygon"
    );
  }
  if (shape == "STL" && dimensions(mode) != 3) {
    deck.refuse_value(
        path + "/Shape",
        "needs three dimensions (a surface is no figure in the plane); write a polygon"
    );
  }
}

Shape read_box(const Deck& deck, const std::string& path, Mode mode) {
  const Box box{vector_at(deck, path + "/Lower", mode), vector_at(deck, path + "/Upper", mode)};
  for (std::size_t i = 0; i < static_cast<std::size_t>(dimensions(mode)); ++i) {
    if (box.upper[i] > box.lower[i]) continue;
    deck.refuse_value(
        path + "/Upper",
        std::string("is not above Lower along ") + "xyz"[i] +
            " (the body is empty); exchange the two"
    );
  }
  return box;
}

double inner_radius(const Deck& deck, const std::string& path, double radius) {
  if (!deck.has(path + "/Inner Radius")) return 0.0;
  const double inner = deck.number(path + "/Inner Radius");
  if (!(inner < radius)) {
    deck.refuse_value(
        path + "/Inner Radius", "is not below Radius (the body is empty); make it smaller"
    );
  }
  return inner;
}

Shape read_ball(const Deck& deck, const std::string& path, Mode mode) {
  Ball ball{vector_at(deck, path + "/Centre", mode), deck.number(path + "/Radius")};
  ball.inner_radius = inner_radius(deck, path, ball.radius);
  if (mode == Mode::axisymmetric && ball.centre[0] != 0.0) {
    deck.refuse_value(
        path + "/Centre", "is off the axis (the ball would be a ring); put it at x = 0"
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

Shape read_round(const Deck& deck, const std::string& path, const std::string& word, Mode mode) {
  if (mode == Mode::plane_strain) return read_ball(deck, path, mode);  // a disk
  Cone cone{vector_at(deck, path + "/Start", mode), vector_at(deck, path + "/End", mode)};
  cone.start_radius = cone.end_radius = deck.number(path + "/Radius");
  cone.inner_radius = inner_radius(deck, path, cone.start_radius);
  if (word == "cone")
    cone.end_radius = deck.has(path + "/End Radius") ? deck.number(path + "/End Radius") : 0.0;
  if (cone.start == cone.end) {
    deck.refuse_value(path + "/End", "is where Start is (the body is empty); move one of the two");
  }
  if (mode != Mode::axisymmetric) return cone;
  for (const char* name : {"/Start", "/End"}) {
    if (vector_at(deck, path + name, mode)[0] == 0.0) continue;
    deck.refuse_value(
        path + name, "is off the axis (the body would not be round about it); put it at x = 0"
    );
  }
  return figure_of(cone);
}

/// On which side of the line from a to b.
double turn(
    const std::array<double, 2>& a, const std::array<double, 2>& b, const std::array<double, 2>& x
) {
  return (b[0] - a[0]) * (x[1] - a[1]) - (b[1] - a[1]) * (x[0] - a[0]);
}

/// Two edges without a common corner meet; their numbers from 1, or nothing.
std::vector<std::size_t> crossing_edges(const Polygon& polygon) {
  const auto& p = polygon.corners;
  const std::size_t n = p.size();
  for (std::size_t i = 0; i < n; ++i)
    for (std::size_t j = i + 2; j < n; ++j) {
      if (i == 0 && j == n - 1) continue;
      const auto &a = p[i], &b = p[i + 1], &c = p[j], &d = p[(j + 1) % n];
      if (turn(a, b, c) * turn(a, b, d) < 0.0 && turn(c, d, a) * turn(c, d, b) < 0.0)
        return {i + 1, j + 1};
    }
  return {};
}

Shape read_polygon(const Deck& deck, const std::string& path, Mode mode) {
  Polygon polygon;
  for (const std::vector<double>& row : deck.rows(path + "/Corners"))
    polygon.corners.push_back({row[0], row[1]});
  if (dimensions(mode) == 3) {
    polygon.axis = static_cast<int>(std::string("xyz").find(deck.word(path + "/Axis")));
    polygon.from = deck.number(path + "/From");
    polygon.to = deck.number(path + "/To");
    if (!(polygon.to > polygon.from))
      deck.refuse_value(path + "/To", "is not above From (the body is empty); exchange the two");
  }
  if (polygon.corners.size() < 3 || measure_bound(Shape(polygon), 2) == 0.0) {
    deck.refuse_value(
        path + "/Corners", "enclose no area (the body is empty); give three corners or more"
    );
  }
  constexpr std::size_t most_corners = 10000;  // every edge is compared with every other
  if (polygon.corners.size() > most_corners) {
    deck.refuse_value(
        path + "/Corners",
        "has more than " + std::to_string(most_corners) +
            " corners (that many cannot be compared); leave out those that change little"
    );
  }
  const auto edges = crossing_edges(polygon);
  if (!edges.empty()) {
    deck.refuse_value(
        path + "/Corners",
        "has edges " + std::to_string(edges[0]) + " and " + std::to_string(edges[1]) +
            " that cross (inside and outside are not defined); put the corners in order"
    );
  }
  return polygon;
}

Shape read_half_space(const Deck& deck, const std::string& path, Mode mode) {
  HalfSpace half{vector_at(deck, path + "/Point", mode), vector_at(deck, path + "/Normal", mode)};
  const double length = std::hypot(half.normal[0], half.normal[1], half.normal[2]);
  if (!(length > 0.0))
    deck.refuse_value(path + "/Normal", "is zero (it points nowhere); give a direction");
  for (double& component : half.normal) component /= length;
  return half;
}

Shape read_surface_shape(const Deck& deck, const std::string& path, Mode mode) {
  if (deck.has(path + "/Shift")) vector_at(deck, path + "/Shift", mode);
  return Faceted{deck.surfaces.at(path)};
}

/// Where in the tree of parts a shape is read: the combinations around it, and the shapes read so
/// far. Shapes that name shapes twice over would else grow without bound.
struct Reached {
  std::vector<std::string> within;
  int shapes = 0;
};
constexpr int most_shapes = 1000;

Shape read_any(const Deck& deck, const std::string& path, Mode mode, Reached& reached);

Shape read_combination(
    const Deck& deck, const std::string& path, const std::string& word, Mode mode, Reached& reached
) {
  Combination combination;
  if (word == "difference") combination.operation = Operation::subtract;
  if (word == "intersection") combination.operation = Operation::intersect;
  const auto names = deck.lists("Shapes"), parts = deck.words(path + "/Parts");
  if (parts.size() < 2)
    deck.refuse_value(path + "/Parts", "names fewer than two shapes; name what is joined");
  for (const std::string& part : parts) {
    if (std::find(names.begin(), names.end(), part) == names.end()) {
      deck.refuse_value(
          path + "/Parts",
          "names '" + part + "', which is not in Shapes; " +
              (names.empty() ? "add that section with the shape" : input::suggest_name(part, names))
      );
    }
    auto& within = reached.within;
    if (std::find(within.begin(), within.end(), part) != within.end()) {
      deck.refuse_value(
          path + "/Parts",
          "names '" + part + "', which this is a part of (a shape cannot hold itself); remove it"
      );
    }
    if (++reached.shapes > most_shapes) {
      deck.refuse_value(
          path + "/Parts",
          "makes a shape of more than " + std::to_string(most_shapes) +
              " shapes (parts of parts count); make it simpler, or an STL surface"
      );
    }
    within.push_back(part);
    combination.parts.push_back(read_any(deck, "Shapes/" + part, mode, reached));
    within.pop_back();
  }
  return combination;
}

Shape read_any(const Deck& deck, const std::string& path, Mode mode, Reached& reached) {
  const std::string word = deck.word(path + "/Shape");
  check_mode(deck, path, word, mode);
  check_keys(deck, path, keys_of(word, mode));
  if (word == "box") return read_box(deck, path, mode);
  if (word == "ball") return read_ball(deck, path, mode);
  if (word == "cylinder" || word == "cone") return read_round(deck, path, word, mode);
  if (word == "polygon") return read_polygon(deck, path, mode);
  if (word == "half-space") return read_half_space(deck, path, mode);
  if (word == "STL") return read_surface_shape(deck, path, mode);
  return read_combination(deck, path, word, mode, reached);
}

}  // namespace

Shape read_shape(const Deck& deck, const std::string& path, Mode mode) {
  Reached reached;
  return read_any(deck, path, mode, reached);
}

void check_shapes(const Deck& deck, Mode mode) {
  for (const std::string& name : deck.lists("Shapes")) {
    Reached reached{{name}, 0};
    read_any(deck, "Shapes/" + name, mode, reached);
  }
}

}  // namespace barreno

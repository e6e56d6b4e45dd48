// SPDX-License-Identifier: BSD-3-Clause
#include "deck/boundary_sections.hpp"

namespace barreno {
namespace {

using namespace input;
namespace dim = dimension;

std::vector<std::string> face_words() {
  return {face_names.begin(), face_names.end()};
}

}  // namespace

const std::array<std::string, 6> face_names = {
    "x_lower", "x_upper", "y_lower", "y_upper", "z_lower", "z_upper"};

Section conditions_section() {
  const Section condition = {
      "*",
      "one condition",
      Presence::required,
      {word("Face", face_words(), "face of the grid box"),
       word(
           "Kind",
           {"symmetry", "fixed", "prescribed velocity"},
           "symmetry: no normal velocity; fixed: no velocity; prescribed velocity: that of Velocity"
       ),
       vector("Velocity", dim::velocity, any(), "only for a prescribed velocity").if_given(),
       vector("Times", dim::time, any(), "increasing; Factors is linear in between").if_given(),
       vector("Factors", dim::none, any(), "of Velocity, one for each of Times; 1 without them")
           .if_given()},
      {},
      {}};
  return {
      "Conditions",
      "prescribed motion of the faces of the grid box, a list of free name each",
      Presence::defaulted,
      {},
      {},
      {condition}};
}

Section loads_section() {
  const Section load = {
      "*",
      "one load",
      Presence::required,
      {word(
           "Kind",
           {"pressure", "non-reflecting", "pore fluid"},
           "pressure: follows the surface, pushes inward when positive; non-reflecting: the same "
           "(or the confinement's, or none), and waves that come to these faces of a box leave "
           "through them; pore fluid: fills the hollow of a ball, p = Pressure - Bulk Modulus ln(V "
           "/ V0)"
       ),
       text("Body", "name of a list in Bodies"),
       words("Faces", face_words(), "of a box: faces that are loaded").if_given(),
       words("Surfaces", {"inner", "outer"}, "of a ball: that of its hollow, that around it")
           .if_given(),
       number(
           "Pressure",
           dim::stress,
           any(),
           "constant in time (or Times and Pressures); a pore fluid's at the start, 0 without it"
       )
           .if_given(),
       number("Bulk Modulus", dim::stress, above(0.0), "of a pore fluid").if_given(),
       vector("Times", dim::time, any(), "increasing; the pressure is linear in between")
           .if_given(),
       vector("Pressures", dim::stress, any(), "one for each of Times").if_given()},
      {},
      {}};
  return {
      "Loads", "prescribed forces, a list of free name each", Presence::defaulted, {}, {}, {load}};
}

Section confinement_section() {
  return {
      "Confinement",
      "bodies that start in equilibrium under a pressure, which stays on their surfaces",
      Presence::optional,
      {number(
           "Pressure",
           dim::stress,
           at_least(0.0),
           "on every outer face that has no condition, and on all surfaces of balls"
       ),
       words("Bodies", {}, "names of lists in Bodies")},
      {},
      {}};
}

Section contact_section() {
  const Section contact = {
      "*",
      "one pair of materials",
      Presence::required,
      {text("Material", "name of a list in Materials"),
       text("Other Material", "name of another, which may be of the same Card"),
       word(
           "Kind",
           {"friction", "frictionless", "stick"},
           "what happens along surfaces that press on each other; all let the surfaces part"
       ),
       number(
           "Friction Coefficient",
           dim::none,
           at_least(0.0),
           "shear over pressure; only for friction"
       )
           .if_given()},
      {},
      {}};
  return {
      "Contact",
      "materials whose surfaces slide on each other or part, a list of free name each; materials "
      "without one stick together where they meet",
      Presence::defaulted,
      {},
      {},
      {contact}};
}

}  // namespace barreno

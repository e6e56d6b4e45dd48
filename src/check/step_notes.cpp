// SPDX-License-Identifier: BSD-3-Clause
#include "check/step_notes.hpp"

#include "base/format.hpp"
#include "deck/section_table.hpp"
#include "scene/geometry.hpp"
#include "scene/tile_levels.hpp"

#include <cmath>
#include <variant>

namespace barreno {
namespace {

bool is_in_motion(const BodySpec& body) {
  for (const double v : body.velocity)
    if (v != 0.0) return true;
  return body.radial_velocity != 0.0;
}

bool lies_on_cells(const GridSpec& grid, double coordinate, std::size_t axis) {
  const double cells = (coordinate - grid.lower[axis]) / grid.cell_size;
  return std::fabs(cells - std::round(cells)) * grid.cell_size <= length_tolerance(grid);
}

/// Whether each face that bears the confinement is a face of cells, as the deck places it.
bool faces_lie_on_cells(const Scene& scene, const PressureLoadSpec& load) {
  const BodySpec& body = scene.bodies[static_cast<std::size_t>(load.body)];
  const auto* box = std::get_if<Box>(&body.shape);
  if (box == nullptr) return false;
  for (std::size_t face = 0; face < load.faces.size(); ++face) {
    const std::size_t axis = face / 2;
    const double coordinate = face % 2 == 0 ? box->lower[axis] : box->upper[axis];
    if (load.faces[face] && !lies_on_cells(scene.grid, coordinate, axis)) return false;
  }
  return true;
}

/// Why a confined body rings; null if it does not. Quadratic splines are exact at a face of cells.
const char* why_it_rings(const Scene& scene, const PressureLoadSpec& load) {
  const BodySpec& body = scene.bodies[static_cast<std::size_t>(load.body)];
  if (scene.step.shape != "quadratic B-spline") return "its faces bear a pressure";
  if (is_in_motion(body)) return "it moves through the cells";
  return faces_lie_on_cells(scene, load) ? nullptr : "its faces do not lie on faces of cells";
}

bool is_pointwise(const std::string& shape) {
  return shape == "linear" || shape.find("B-spline") != std::string::npos;
}

}  // namespace

std::string ringing_note(const Scene& scene) {
  if (!is_pointwise(scene.step.shape)) return {};
  for (const PressureLoadSpec& load : scene.loads) {
    if (load.body < 0) continue;
    const BodySpec& body = scene.bodies[static_cast<std::size_t>(load.body)];
    if (body.initial_pressure == 0.0) continue;
    const char* const why = why_it_rings(scene, load);
    if (why == nullptr) continue;
    return list_of<BodySpec>(body.name) + " will ring under its confinement with Shape Function " +
           scene.step.shape + ", because " + why +
           " (splines gave 5.8 to 14.3 MPa instead of 10 MPa in a block that flies, linear "
           "functions far more); take Shape Function GIMP or CPDI, which keep the pressure exactly";
  }
  return {};
}

std::string largest_strain_note(const Scene& scene) {
  constexpr double recommended = 0.1;  // what each fidelity takes with a jet
  const double largest = scene.step.largest_strain;
  if (!scene.jet.present || finest_level(scene.grid) == 0) return {};
  if (largest < StepSpec{}.largest_strain) return {};
  return path_of(&StepSpec::largest_strain) +
         format(
             " = %g lets single particles of spent jet gain energy where they collide in refined "
             "cells (docs/method.md, 4); take %g",
             largest,
             recommended
         );
}

}  // namespace barreno

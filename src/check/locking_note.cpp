// SPDX-License-Identifier: BSD-3-Clause
#include "check/locking_note.hpp"

#include "state/bodies/body_particles.hpp"

#include <algorithm>
#include <barreno/tangent.hpp>
#include <sstream>
#include <variant>

namespace barreno {
namespace {

constexpr double stiffest = 100.0;  ///< K / G
constexpr double most_said = 1e12;  ///< larger ratios are not told apart

/// K / G at the start; 0 of what has no shear stiffness and cannot lock.
double bulk_over_shear(const Material& material) {
  return std::visit(
      [](const auto& model) {
        const auto history = model.initial_history();
        const double shear = shear_modulus(model, Sym3{}, history);
        const double axial = model.longitudinal_modulus({}, history, 1.0);
        return shear > 0.0 ? axial / shear - 4.0 / 3.0 : 0.0;
      },
      material.model
  );
}

/// Whether the deck gives all particles of a material the size of a cell. Some may be smaller all
/// the same: in a wall that ends inside a cell, in a short slug, after a division.
bool asks_for_whole_cells(const Scene& scene, int material) {
  const bool flies = scene.jet.present && scene.jet.material == material;
  return (!flies || scene.jet.particles_per_cell == 1) &&
         std::all_of(scene.bodies.begin(), scene.bodies.end(), [&](const BodySpec& body) {
           return body.material != material || body.particles_per_cell == 1;
         });
}

}  // namespace

std::string locking_note(const Scene& scene, int material) {
  const Material& rock = scene.materials[static_cast<std::size_t>(material)].material();
  const double ratio = bulk_over_shear(rock);
  const bool spline = scene.step.shape.find("B-spline") != std::string::npos;
  if (ratio <= stiffest || spline || smallest_half_size(scene, material) >= 0.5) return {};
  std::ostringstream text;
  text << "material '" << rock.name << "' is nearly incompressible (K "
       << (ratio < most_said ? "= " : "above ") << std::min(ratio, most_said)
       << " G) and will respond too stiffly, through volumetric locking, with " << scene.step.shape
       << (asks_for_whole_cells(scene, material)
               ? " and particles smaller than a cell; take "
               : " and more than one particle per cell; take Particles Per Cell 1 or ")
       << "Shape Function quadratic B-spline";
  return text.str();
}

}  // namespace barreno

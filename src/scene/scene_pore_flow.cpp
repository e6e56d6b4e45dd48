// SPDX-License-Identifier: BSD-3-Clause
#include "scene/build_scene.hpp"
#include "scene/load_tables.hpp"
#include "scene/porous.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// One number for all axes, or one for each.
Vector read_permeability(const Deck& deck, const std::string& path, Mode mode) {
  const std::vector<double> given = deck.vector(path);
  if (given.size() == 1) return {given[0], given[0], given[0]};
  return vector_at(deck, path, mode);
}

/// Of a material before anything has happened to it; without storage if its fluid cannot drain.
PorePoint first_point(const MaterialSpec& material) {
  return std::visit(
      [](const auto& model) {
        PorePoint point;
        if constexpr (is_drainable<std::decay_t<decltype(model)>>)
          point = initial_pore_point(model);
        return point;
      },
      material.material.model
  );
}

/// (K + 4G/3) / (alpha^2 M): undrained moduli are that sum and alpha^2 M.
double softness_of_fluid(const MaterialSpec& material) {
  const PorePoint point = first_point(material);
  const double undrained = std::visit(
      [](const auto& model) {
        const auto start = model.initial_state(0.0);
        return model.longitudinal_modulus(start.stress, start.history, 1.0);
      },
      material.material.model
  );
  return undrained * point.storage / (point.biot * point.biot) - 1.0;
}

/// Fluid and grains that do not give leave the pressure of sealed rock without an answer.
void refuse_singular(const Deck& deck, const Scene& scene, std::size_t m, const std::string& path) {
  constexpr double least = 1e-8;
  const auto& conditions = scene.pore_flow.conditions;
  const bool sealed = std::none_of(conditions.begin(), conditions.end(), [](const auto& condition) {
    return condition.kind == PoreConditionKind::drained;
  });
  if (sealed && softness_of_fluid(scene.materials[m]) < least)
    deck.refuse(
        path,
        "holds a fluid and grains that are incompressible, and no condition is drained (the "
        "pressure of sealed rock could be anything); add a condition of the kind 'drained' or "
        "lower the fluid's bulk modulus"
    );
}

void add_rocks(const Deck& deck, Scene& scene) {
  scene.pore_flow.rocks.resize(scene.materials.size());
  for (const std::string& name : deck.lists("Pore Flow/Rocks")) {
    const std::string path = "Pore Flow/Rocks/" + name;
    std::size_t m = 0;
    while (m < scene.materials.size() && scene.materials[m].material.name != name) ++m;
    if (m == scene.materials.size())
      deck.refuse(path, "is not in Materials (a permeability belongs to one); change the name");
    if (!(first_point(scene.materials[m]).storage > 0.0))
      deck.refuse(
          path,
          "has no fluid that drains (Poroelastic with a Fluid Bulk Modulus, and Arenisca with "
          "fluid_B0, have one); remove the list or change the material"
      );
    PermeabilitySpec& rock = scene.pore_flow.rocks[m];
    rock.permeability = read_permeability(deck, path + "/Permeability", scene.grid.mode);
    rock.kozeny_carman = deck.flag(path + "/Kozeny-Carman");
    refuse_singular(deck, scene, m, path);
  }
}

void read_faces(const Deck& deck, const std::string& path, Mode mode, std::array<bool, 6>& faces) {
  if (!deck.has(path)) return;
  for (const std::string& word : deck.words(path))
    faces[static_cast<std::size_t>(face_at(deck, path, word, mode))] = true;
}

Table read_flux(const Deck& deck, const std::string& path) {
  if (!deck.has(path + "/Flux"))
    deck.refuse(path + "/Flux", "is missing (the kind 'flux' needs it); add it or change Kind");
  if (has_pressure(deck, path))
    deck.refuse(
        path, "has a pressure, which the kind 'flux' does not use; remove it or change Kind"
    );
  return {{0.0}, {deck.number(path + "/Flux")}};
}

void add_flow_conditions(const Deck& deck, Scene& scene) {
  for (const std::string& name : deck.lists("Pore Flow/Conditions")) {
    const std::string path = "Pore Flow/Conditions/" + name;
    PoreConditionSpec condition;
    condition.name = name;
    if (deck.word(path + "/Kind") == "flux") condition.kind = PoreConditionKind::flux;
    read_faces(deck, path + "/Grid Faces", scene.grid.mode, condition.grid_faces);
    read_faces(deck, path + "/Open Faces", scene.grid.mode, condition.open_faces);
    if (!deck.has(path + "/Grid Faces") && !deck.has(path + "/Open Faces"))
      deck.refuse(path, "acts nowhere; give Grid Faces or Open Faces");
    const bool flux = condition.kind == PoreConditionKind::flux;
    if (!flux && deck.has(path + "/Flux"))
      deck.refuse_value(path + "/Flux", "has no meaning for the kind 'drained'; remove it");
    condition.value = flux ? read_flux(deck, path) : read_pressure(deck, path);
    scene.pore_flow.conditions.push_back(condition);
  }
}

}  // namespace

double drained_length(const Scene& scene) {
  double diffusivity = 0.0;
  for (std::size_t m = 0; m < scene.pore_flow.rocks.size(); ++m) {
    const Vector& k = scene.pore_flow.rocks[m].permeability;
    const double fastest = std::max({k[0], k[1], k[2]}) / scene.pore_flow.viscosity;
    const PorePoint point = first_point(scene.materials[m]);
    if (point.storage > 0.0) diffusivity = std::max(diffusivity, fastest / point.storage);
  }
  return std::sqrt(diffusivity * scene.end_time);
}

void add_pore_flow(const Deck& deck, Scene& scene) {
  if (!deck.has("Pore Flow/Viscosity")) return;
  PoreFlowSpec& flow = scene.pore_flow;
  flow.viscosity = deck.number("Pore Flow/Viscosity");
  if (scene.body_force.kind == BodyForceKind::gravity)
    for (std::size_t d = 0; d < 3; ++d)
      flow.fluid_weight[d] =
          deck.number("Pore Flow/Fluid Density") * scene.body_force.acceleration[d];
  flow.diffusion_number = deck.number("Pore Flow/Diffusion Number");
  auto solver = std::make_shared<Teuchos::ParameterList>("Pore Flow");
  for (const char* name : {"Belos", "Ifpack2", "MueLu"})
    solver->sublist(name) = deck.list(std::string("Pore Flow/") + name);
  flow.solver = solver;
  add_flow_conditions(deck, scene);
  add_rocks(deck, scene);
  const std::string drainage = deck.word("Pore Flow/Drainage");
  if (drainage == "on") flow.drainage = Drainage::on;
  if (drainage == "automatic" &&
      drained_length(scene) >= shortest_drained_length * scene.grid.cell_size)
    flow.drainage = Drainage::on;
}

}  // namespace barreno

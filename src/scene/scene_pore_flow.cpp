// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "scene/build_scene.hpp"
#include "scene/load_tables.hpp"
#include "scene/porous.hpp"
#include "scene/scene_parts.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

/// One number for all axes, or one for each.
Vector read_permeability(const Deck& deck, const std::string& path) {
  const std::vector<double> given = deck.vector(path);
  if (given.size() == 1) return {given[0], given[0], given[0]};
  return vector_at(deck, path);
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
      material.material().model
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
      material.material().model
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
        "has incompressible fluid and incompressible grains, and no condition is drained (the "
        "pressure of sealed rock would be undetermined); add a condition of the kind 'drained' or "
        "lower the fluid's bulk modulus"
    );
}

void add_rocks(const Deck& deck, Scene& scene) {
  scene.pore_flow.rocks.resize(scene.materials.size());
  for (const std::string& name : deck.lists(table_of<PermeabilitySpec>().path)) {
    const std::string path = list_of<PermeabilitySpec>(name);
    std::size_t m = 0;
    while (m < scene.materials.size() && scene.materials[m].name() != name) ++m;
    if (m == scene.materials.size())
      deck.refuse(path, "is not in Materials (a permeability belongs to one); change the name");
    if (!(first_point(scene.materials[m]).storage > 0.0))
      deck.refuse(
          path,
          "has no fluid that can drain (Poroelastic with a Fluid Bulk Modulus, and Arenisca with "
          "fluid_B0, have one); remove the list or change the material"
      );
    PermeabilitySpec& rock = scene.pore_flow.rocks[m];
    rock = read_list<PermeabilitySpec>(deck, path);
    rock.permeability = read_permeability(deck, path_of(&PermeabilitySpec::permeability, name));
    refuse_singular(deck, scene, m, path);
  }
}

Table read_flux(const Deck& deck, const std::string& path, const std::string& entry) {
  if (!deck.has(entry))
    deck.refuse(entry, "is missing (the kind 'flux' needs it); add it or change Kind");
  if (has_pressure(deck, path))
    deck.refuse(
        path, "has a pressure, which the kind 'flux' does not use; remove it or change Kind"
    );
  return {{0.0}, {deck.number(entry)}};
}

void add_flow_conditions(const Deck& deck, Scene& scene) {
  for (const std::string& name : deck.lists(table_of<PoreConditionSpec>().path)) {
    const std::string path = list_of<PoreConditionSpec>(name);
    auto condition = read_list<PoreConditionSpec>(deck, path);
    condition.name = name;
    if (!deck.has(path_of(&PoreConditionSpec::grid_faces, name)) &&
        !deck.has(path_of(&PoreConditionSpec::open_faces, name)))
      deck.refuse(path, "acts nowhere; give Grid Faces or Open Faces");
    const std::string entry = path_of(&PoreConditionSpec::value, name);
    const bool flux = condition.kind == PoreConditionKind::flux;
    if (!flux && deck.has(entry))
      deck.refuse_value(entry, "has no meaning for the kind 'drained'; remove it");
    condition.value = flux ? read_flux(deck, path, entry) : read_pressure(deck, path);
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
  if (!deck.has(path_of(&PoreFlowSpec::viscosity))) return;
  PoreFlowSpec& flow = scene.pore_flow;
  flow = read_section<PoreFlowSpec>(deck);
  if (scene.body_force.kind == BodyForceKind::gravity)
    for (std::size_t d = 0; d < 3; ++d)
      flow.fluid_weight[d] = flow.fluid_density * scene.body_force.acceleration[d];
  auto solver = std::make_shared<Teuchos::ParameterList>("Pore Flow");
  for (const std::string& name : solver_lists())
    solver->sublist(name) = deck.list(input::join(table_of<PoreFlowSpec>().path, name));
  flow.solver = solver;
  add_flow_conditions(deck, scene);
  add_rocks(deck, scene);
  if (flow.drainage != Drainage::automatic) return;
  const bool far = drained_length(scene) >= shortest_drained_length * scene.grid.cell_size;
  flow.drainage = far ? Drainage::on : Drainage::off;
}

}  // namespace barreno

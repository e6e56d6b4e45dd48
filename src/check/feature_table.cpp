// SPDX-License-Identifier: BSD-3-Clause
#include "check/feature_table.hpp"

#include "base/format.hpp"
#include "check/choices.hpp"
#include "scene/velocity_fields.hpp"
#include "shape/shape_facts.hpp"
#include "state/particles.hpp"

#include <algorithm>
#include <functional>
#include <vector>

namespace barreno {
namespace {

constexpr const char* no_pic = "Transfer is not FLIP, or PIC Fraction is 0";

/// A row of the table, but for its numbers.
struct Feature {
  const char* name;
  Choice choice;
  std::function<void(Scene&)> leave_out;  ///< makes the scene that does without it
  std::vector<const char*> verbs;         ///< that do nothing else
};

/// Of the particles of that material that need most.
std::size_t max_bytes(const Scene& scene) {
  std::size_t most = 0;
  for (std::size_t m = 0; m < scene.materials.size(); ++m)
    most = std::max(most, bytes_per_particle(make_particles(scene, static_cast<int>(m))));
  return most;
}

/// Counted and measured whether it is on or off: what is off must show that it costs nothing.
std::string row(const Scene& scene, const Probe& probe, const Feature& feature) {
  Scene without = scene;
  feature.leave_out(without);
  double share = 0.0;
  for (const char* verb : feature.verbs) share += share_of(probe, verb);
  const auto more = static_cast<long>(max_bytes(scene)) - static_cast<long>(max_bytes(without));
  const std::string time = feature.verbs.empty() ? "     -" : format("%4.1f %%", 100.0 * share);
  return format(
      "  %-22s %-3s %5ld  %s  %s\n",
      feature.name,
      feature.choice.on ? "on" : "off",
      std::max(0L, more),
      time.c_str(),
      feature.choice.why.c_str()
  );
}

Choice loads_of(const Scene& scene, LoadKind kind) {
  const auto count = std::count_if(scene.loads.begin(), scene.loads.end(), [&](const auto& load) {
    return load.kind == kind;
  });
  return {count > 0, std::to_string(count) + " in the deck"};
}

void leave_out_loads(Scene& scene, LoadKind kind) {
  auto& loads = scene.loads;
  const auto is_of_kind = [&](const PressureLoadSpec& load) { return load.kind == kind; };
  loads.erase(std::remove_if(loads.begin(), loads.end(), is_of_kind), loads.end());
}

/// A row for each kind; the functions that apply loads of all kinds are counted with the first.
std::vector<Feature> load_features(const Scene& scene) {
  std::vector<Feature> features;
  features.reserve(load_traits.size());
  for (const LoadTraits& traits : load_traits)
    features.push_back(
        {traits.feature,
         loads_of(scene, traits.kind),
         [kind = traits.kind](Scene& without) { leave_out_loads(without, kind); },
         {}}
    );
  features.front().verbs = {
      "project_loads",
      "tally_loads",
      "project_surface_pressures",
      "tally_surface_pressures",
      "grow_cavities",
      "release_torn_faces"};
  return features;
}

void leave_out_transfer(Scene& scene) {
  scene.step.transfer = Transfer::flip;
}

Choice transfer_choice(const StepSpec& step, Transfer transfer, const std::string& why) {
  const bool on = step.transfer == transfer;
  return {on, on ? why : std::string("Transfer is ") + transfer_name(step)};
}

Choice confinement_choice(const Scene& scene) {
  const bool on = std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const BodySpec& body) {
    return body.initial_pressure > 0.0;
  });
  return {on, on ? "bodies start in equilibrium" : "no Confinement list"};
}

Choice tables_choice(const Scene& scene) {
  const bool on = std::any_of(
      scene.conditions.begin(),
      scene.conditions.end(),
      [](const ConditionSpec& condition) { return condition.factor.time.size() > 1; }
  );
  return {on, on ? "a condition has Times" : "no condition has Times"};
}

Choice contact_choice(const Scene& scene) {
  if (scene.contacts.empty()) return {false, "no Contact list: materials stick where they meet"};
  return {true, std::to_string(velocity_fields(scene).count) + " velocity fields"};
}

Choice domains_choice(const Scene& scene) {
  const bool on = follows_deformation(scene);
  return {on, "Shape Function is " + scene.step.shape};
}

/// It costs no more memory.
void keep_all(Scene& /*scene*/) {}

/// Of how a step is taken.
std::vector<Feature> step_features(const Scene& scene) {
  const StepSpec& step = scene.step;
  const bool pic = step.transfer != Transfer::apic && step.pic_fraction > 0.0;
  const bool viscous = step.linear_viscosity + step.quadratic_viscosity > 0.0;
  return {
      {"artificial viscosity",
       {viscous, format("A1 = %g, A2 = %g", step.linear_viscosity, step.quadratic_viscosity)},
       keep_all,
       {}},
      {"domains that deform",
       domains_choice(scene),
       [](Scene& without) { without.step.shape = StepSpec{}.shape; },
       {"tally_domains"}},
      {"PIC share",
       {pic, pic ? format("PIC Fraction = %g", step.pic_fraction) : no_pic},
       keep_all,
       {}},
      {"XPIC",
       transfer_choice(
           step,
           Transfer::xpic,
           format("order %d: %d more projections", step.xpic_order, step.xpic_order - 1)
       ),
       leave_out_transfer,
       {"filter_velocity"}},
      {"APIC",
       transfer_choice(step, Transfer::apic, "particles carry first moments of the velocity"),
       leave_out_transfer,
       {"project_affine", "gather_affine", "start_affine"}},
      {"subcycling",
       {step.subcycles > 1,
        step.subcycles > 1
            ? format("tiles take up to %d of the smallest steps at once", step.subcycles)
            : "Subcycles is 1: all tiles take one step"},
       [](Scene& without) { without.step.subcycles = 1; },
       {"plan_subcycles", "end_tile_steps", "carry_tile_steps", "find_early_arrivals"}},
      {"returned losses",
       {step.return_losses,
        step.return_losses ? "losses of a step become heat of materials that have it"
                           : "Return Losses is false"},
       [](Scene& without) { without.step.return_losses = false; },
       {}},
      {"second projection",
       {step.order != Order::stress_last, std::string("Order is ") + word_of(step.order)},
       [](Scene& without) { without.step.order = Order::stress_last; },
       {}}};
}

/// Of how a scene starts.
std::vector<Feature> start_features(const Scene& scene) {
  return {
      {"jet",
       {scene.jet.present, scene.jet.present ? "the deck has a Jet list" : "no Jet list"},
       keep_all,
       {"launch_jet"}},
      {"initial confinement", confinement_choice(scene), keep_all, {}}};
}

/// Of what else is in the scene.
std::vector<Feature> scene_features(const Scene& scene) {
  const bool space = scene.grid.mode == Mode::three_dimensional;
  const bool forced = scene.body_force.kind != BodyForceKind::none;
  return {
      {"walls moved by tables", tables_choice(scene), keep_all, {}},
      {"body force",
       {forced, forced ? "the deck has a Body Force list" : "no Body Force list"},
       [](Scene& without) { without.body_force = {}; },
       {"project_body_force", "tally_body_force"}},
      {"third dimension",
       {space,
        space ? "nodes and particles have three coordinates"
              : "the mode is two-dimensional: 2D data"},
       keep_all,
       {}},
      {"contact",
       contact_choice(scene),
       keep_all,
       {"detect_contact_nodes", "fit_surface_normals", "refine_surface_normals", "solve_contact"}},
      {"pore flow", pore_flow_choice(scene), [](Scene& without) { without.pore_flow = {}; }, {}},
      {"dormant tiles",
       dormancy_choice(scene),
       [](Scene& without) { without.step.skip_dormant = false; },
       {}},
      {"refined cells", refinement_choice(scene), keep_all, {"restrict_sums"}},
      {"quasi-static", quasi_static_choice(scene), keep_all, {}}};
}

}  // namespace

std::string feature_table(const Scene& scene, const Probe& probe) {
  std::string text =
      "Features                     bytes   time  (bytes per particle that a feature needs; share "
      "of "
      "the first steps that its functions take)\n";
  for (const auto& features :
       {start_features(scene), load_features(scene), scene_features(scene), step_features(scene)})
    for (const Feature& feature : features) text += row(scene, probe, feature);
  return text;
}

}  // namespace barreno

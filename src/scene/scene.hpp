// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/sections/body_force_section.hpp"
#include "deck/sections/body_section.hpp"
#include "deck/sections/contact_section.hpp"
#include "deck/sections/detonation_section.hpp"
#include "deck/sections/grid_section.hpp"
#include "deck/sections/jet_section.hpp"
#include "deck/sections/load_sections.hpp"
#include "deck/sections/material_section.hpp"
#include "deck/sections/output_section.hpp"
#include "deck/sections/pore_flow_section.hpp"
#include "deck/sections/step_section.hpp"
#include "scene/quasi_static_spec.hpp"

#include <barreno/describe.hpp>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace barreno {

struct Material;

/// What was asked, as plain structs in SI, checked and complete. Built once by build_scene, then
/// const. What a section of the deck fills as it is stands beside that section's table, in
/// src/deck.

/// A material and what happens to its bad particles. Whoever asks for its model includes
/// <barreno/models.hpp>; others need not know the models.
class MaterialSpec {
public:
  MaterialSpec(
      const Material& material, BadParticlePolicy policy = MaterialSection{}.bad_particles
  );

  const Material& material() const { return *material_; }
  const std::string& name() const;
  std::string model_name() const;
  std::vector<HistoryField> history_table() const;  ///< of the model's internal variables
  /// Of an internal variable, or none.
  std::optional<int> history_column(std::string_view field) const;
  bool is_porous() const;    ///< it has a fluid that can drain
  bool holds_voids() const;  ///< it may be expanded (scene/voids.hpp)
  /// Of a metal that holds voids: solid over mean density above which heat alone keeps a shock from
  /// compressing it beyond its own density; infinite of others.
  double largest_porous_expansion() const;
  /// Speed with which an explosive burns; without: it is none [length/time]
  std::optional<double> detonation_speed() const;
  double density() const { return density_; }  ///< at reference [mass/length^3]
  /// How often a particle may be divided, and the column of its history that counts it; 0: never.
  int splits() const;
  int splits_column() const;
  void scale_density(double factor);

  BadParticlePolicy bad_particles;
  std::string source;  ///< of its numbers, as the deck says it: "card NAME"; empty: none is said
  /// V / V_ref beyond which a particle counts as bad; without: that of the step [-]
  std::optional<double> largest_expansion;
  /// Of particles of one cell towards its mean volume ratio, per shear strain [-]
  double volume_relaxation = 0.0;

private:
  double density_;  ///< the material's, for those who do not include it
  std::shared_ptr<const Material> material_;
};

/// Longest Largest Domain that the patches of tiles are made for, which is what 0 in a deck means
/// [cells]. Domains of three dimensions reach 1.5 times as far as that.
inline double farthest_domain(Mode mode) {
  return mode == Mode::three_dimensional ? 16.0 / 3.0 : 8.0;
}

struct Scene {
  std::string title;
  GridSpec grid;
  std::vector<MaterialSpec> materials;
  std::vector<BodySpec> bodies;
  std::vector<ConditionSpec> conditions;
  std::vector<PressureLoadSpec> loads;
  std::vector<ContactSpec> contacts;
  DetonationSpec detonation;
  JetSpec jet;
  BodyForceSpec body_force;
  PoreFlowSpec pore_flow;
  /// What a fidelity chose and this scene cannot have, a sentence each.
  std::vector<std::string> left_out;
  QuasiStaticSpec quasi_static;
  StepSpec step;
  double end_time = 0.0;  ///< of the run; of one to rest the longest time [time]
  OutputSpec output;
  bool at_rest = false;  ///< the run ends before end_time if the hole of its jet is at rest
  std::optional<double> cut_off_velocity;  ///< as the deck gives it [length/time]
};

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#include "deck/section_table.hpp"
#include "scene/dormant.hpp"
#include "scene/scene_parts.hpp"
#include "scene/velocity_fields.hpp"

#include <algorithm>
#include <array>
#include <string>

namespace barreno {
namespace {

bool is_across_axis(const ConditionSpec& condition) {
  return condition.kind == ConditionKind::symmetry &&
         (condition.face == Face::y_lower || condition.face == Face::y_upper);
}

/// Shape functions whose particles all bear the step of the cells, whatever their deformation.
bool has_fixed_supports(const std::string& shape) {
  static const std::array<const char*, 4> words{
      "linear", "GIMP", "quadratic B-spline", "cubic B-spline"};
  return std::find(words.begin(), words.end(), shape) != words.end();
}

/// Beyond this share of their stable steps, tiles that step differently side by side can resonate:
/// perforation_120us.xml gained energy without bound at 0.9, and at 0.8 and below never.
constexpr double largest_courant_fraction = 0.8;

/// Why all tiles of a scene take one step; empty: they need not. The first reasons are those for
/// which a step visits all tiles (why_all_awake); particles that take a share of the grid's
/// velocity, not its change alone, would take the mean of a step of several parts.
std::string why_one_step(const Scene& scene) {
  std::string awake = why_all_awake(scene);
  if (!awake.empty()) return awake;
  if (!scene.contacts.empty()) return "contact needs all tiles to take the same step";
  if (velocity_fields(scene).count > 1) return "a rigid body needs all tiles to take the same step";
  const StepSpec& step = scene.step;
  if (step.transfer == Transfer::pic || step.pic_fraction > 0.0)
    return "particles take a share of the grid's velocity (PIC)";
  if (step.damping > 0.0) return "damping acts on particles too";
  if (step.courant_fraction > largest_courant_fraction)
    return path_of(&StepSpec::courant_fraction) +
           " is above 0.8, where tiles with different steps can resonate";
  if (step.return_losses && scene.grid.mode == Mode::three_dimensional)
    return "Return Losses was verified with steps of several lengths in two dimensions only";
  if (!has_fixed_supports(step.shape))
    return "the domains of shape function " + step.shape + " limit the step one by one";
  if (std::any_of(scene.conditions.begin(), scene.conditions.end(), is_across_axis))
    return "a symmetry plane across y mirrors the nodes' momenta in every step";
  return {};
}

}  // namespace

void settle_subcycles(const Deck& deck, Scene& scene) {
  const int most = scene.step.subcycles;
  if (most == 1) return;
  const std::string path = path_of(&StepSpec::subcycles);
  if ((most & (most - 1)) != 0)
    deck.refuse_value(path, "is not a power of two; choose 1, 2, 4, 8 or 16");
  const std::string why = why_one_step(scene);
  if (why.empty()) return;
  if (deck.chosen_by_fidelity.count(path) == 0)
    deck.refuse_value(path, "must be 1 here: " + why + "; remove it or change that");
  scene.step.subcycles = 1;
  scene.left_out.push_back("The fidelity's " + path + " is left out: " + why + ".");
}

}  // namespace barreno

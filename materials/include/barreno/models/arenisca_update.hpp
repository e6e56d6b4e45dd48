// SPDX-License-Identifier: BSD-3-Clause
#pragma once

// The point update of Arenisca for several points at once (real.hpp). Read first: arenisca.hpp,
// which includes this, and arenisca/substep.hpp, which is the same for one point.
#include "barreno/models/arenisca.hpp"
#include "barreno/real.hpp"

#if BARRENO_HAS_LANES

#include "barreno/arenisca/points_queue.hpp"
#include "barreno/arenisca/points_start.hpp"

namespace barreno {

/// One lane of a structure that consists of reals, and back.
template <class One, class Several>
inline One lane_of(const Several& from, int lane) {
  static_assert(sizeof(Several) == lane_count * sizeof(One), "the same structure over reals");
  One to;
  for (std::size_t c = 0; c < sizeof(One) / sizeof(double); ++c)
    reinterpret_cast<double*>(&to)[c] = reinterpret_cast<const Lanes*>(&from)[c][lane];
  return to;
}
template <class One, class Several>
inline void set_lane(const One& from, int lane, Several& to) {
  static_assert(sizeof(Several) == lane_count * sizeof(One), "the same structure over reals");
  for (std::size_t c = 0; c < sizeof(One) / sizeof(double); ++c)
    reinterpret_cast<Lanes*>(&to)[c][lane] = reinterpret_cast<const double*>(&from)[c];
}

/// update() for the points asked for, one after the other.
inline void update_one_by_one(
    const Arenisca& model, const LaneMask& asked, Arenisca::Points<Lanes>& p
) {
  for (int i = 0; i < lane_count; ++i) {
    if (asked[i] == 0) continue;
    Increment increment;
    increment.strain = lane_of<Sym3>(p.increment.strain, i);
    increment.dt = p.increment.dt;
    increment.volume_ratio_begin = p.increment.volume_ratio_begin[i];
    increment.volume_ratio_end = p.increment.volume_ratio_end[i];
    increment.viscous_pressure = p.increment.viscous_pressure[i];
    auto stress = lane_of<Sym3>(p.stress, i);
    auto history = lane_of<Arenisca::History>(p.history, i);
    const Outcome one = model.update(increment, stress, history);
    set_lane(stress, i, p.stress);
    set_lane(history, i, p.history);
    p.outcome.sound[i] = one.failed() ? 0 : -1;
    p.outcome.elastic_work[i] = one.elastic_work;
    p.outcome.plastic_work[i] = one.plastic_work;
    p.outcome.longitudinal_modulus[i] = one.longitudinal_modulus;
  }
}

namespace arenisca {

template <class R>
BARRENO_FUNCTION StartOf<R> start_of(const Rock& rock, const Arenisca::Points<R>& p) {
  StartOf<R> n{
      trace(p.stress),
      deviator(p.stress),
      p.history.plastic_volume_strain,
      trace(p.increment.strain),
      deviator(p.increment.strain)};
  n.term = pressure_term_of(rock.elasticity, n.x, n.evp);
  n.coupling = coupling_of(rock.elasticity, n.x, n.evp);
  n.moduli = moduli_of(rock.elasticity, n.term.value, n.coupling);
  return n;
}

/// End of steps that flow, from the stress and strain increment that they began with.
/// @return where the step is left to update()
template <class R>
BARRENO_FUNCTION MaskOf<R> end_step(
    const MaskOf<R>& flows, const StepOf<R>& step, Arenisca::Points<R>& p
) {
  const PlaneOf<R> plane = plane_of(deviator(p.stress), deviator(p.increment.strain));
  const Sym3Of<R> end = plane.tensor(step.state.s) + isotropic(R(step.state.x * (1.0 / 3.0)));
  const MaskOf<R> good = flows & !step.refused;
  const R mean_ratio = 0.5 * (p.increment.volume_ratio_begin + p.increment.volume_ratio_end);
  p.stress = select_points<R>(good, end, p.stress);
  p.history = {
      real::select(good, step.state.evp, p.history.plastic_volume_strain),
      real::select(good, step.state.shear_strain, p.history.equivalent_plastic_strain)};
  PointsOutcome<R>& out = p.outcome;
  out.elastic_work = real::select(good, mean_ratio * step.elastic_work, out.elastic_work);
  out.plastic_work = real::select(good, mean_ratio * step.plastic_work, out.plastic_work);
  out.longitudinal_modulus = real::select(good, step.modulus, out.longitudinal_modulus);
  return flows & step.refused;
}

}  // namespace arenisca

template <class R>
BARRENO_FUNCTION MaskOf<R> Arenisca::start_points(Points<R>& p) const {
  using namespace arenisca;
  const StartOf<R> n = start_of<R>(rock_, p);
  const MaskOf<R> sound =
      sound_points(p.increment, p.stress, n.evp, p.history.equivalent_plastic_strain);
  p.outcome.sound = sound;
  WholeStepOf<R> whole;
  const MaskOf<R> elastic = step_elastically(rock_, n, sound, whole, p.outcome);
  const R mean_ratio = 0.5 * (p.increment.volume_ratio_begin + p.increment.volume_ratio_end);
  p.outcome.elastic_work = mean_ratio * p.outcome.elastic_work;
  const Sym3Of<R> end = whole.s + isotropic(R(whole.x * (1.0 / 3.0)));
  p.stress = select_points<R>(elastic, end, p.stress);
  return sound & !elastic;
}

template <class R>
BARRENO_FUNCTION void Arenisca::finish_points(Points<R>* groups, const MaskOf<R>* flows, int count)
    const {
  using namespace arenisca;
  constexpr std::size_t room = groups_together;
  StepOf<R> steps[room];
  for (int g = 0; g < count; ++g) {
    const StartOf<R> n = start_of<R>(rock_, groups[g]);
    const R shear_strain = groups[g].history.equivalent_plastic_strain;
    steps[g] = begin_step(rock_, n, plane_of(n.s, n.de), shear_strain, flows[g]);
    // The published return is left to update().
    if (rock_.bisection) steps[g].refused = flows[g];
  }
  if (!rock_.bisection) finish_steps(rock_, steps, count);
  for (int g = 0; g < count; ++g) {
    const MaskOf<R> refused = end_step<R>(flows[g], steps[g], groups[g]);
    if (real::any(refused)) update_one_by_one(*this, refused, groups[g]);
  }
}

}  // namespace barreno

#endif

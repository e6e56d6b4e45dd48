// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/real.hpp"

namespace barreno {

/// Verdict of one point update. A failed update leaves stress and history as they were; the host
/// decides.
enum class Status { ok = 0, substep_limit = 1, not_converged = 2, bad_input = 3 };

/// What a point update reports beside the new stress and history.
struct [[nodiscard]] Outcome {
  Status status = Status::ok;
  int substeps = 1;
  double elastic_work = 0.0;  ///< recoverable work of this step per reference volume [stress]
  double plastic_work = 0.0;  ///< dissipated work of this step per reference volume [stress]
  double longitudinal_modulus =
      0.0;  ///< K + 4G/3 at the end of the step, bounds the wave speed [stress]
  bool failed() const { return status != Status::ok; }
};

/// The same for several points at once (real.hpp): `sound` where the point took its step, else its
/// stress and history are as they were, and update() says why.
template <class R>
struct PointsOutcome {
  MaskOf<R> sound;
  R elastic_work, plastic_work, longitudinal_modulus;
};

/// update() of a model that refuses nothing but its input, from that of points.
BARRENO_FUNCTION Outcome outcome_of(const PointsOutcome<double>& point) {
  Outcome outcome;
  if (!point.sound) {
    outcome.status = Status::bad_input;
    return outcome;
  }
  outcome.elastic_work = point.elastic_work;
  outcome.longitudinal_modulus = point.longitudinal_modulus;
  return outcome;
}

/// What the host knows about a step at one point.
///
/// The strain increment is unrotated (corotational), logarithmic and finite; volume ratios are V /
/// V_ref with V_ref = mass / reference density, so that an equation of state sees the true density.
template <class Tensor>
struct IncrementOf {
  using Real = typename Tensor::Real;
  Tensor strain;                           ///< d_eps, tension positive [-]
  Real dt{};                               ///< [time]; 0 is allowed (rate terms off)
  Real volume_ratio_begin = Real{} + 1.0;  ///< V_n / V_ref [-]
  Real volume_ratio_end = Real{} + 1.0;    ///< V_n+1 / V_ref [-]
  Real viscous_pressure{};  ///< mean artificial viscosity of the step, heats the material [stress]
};

/// Points with a step to take. Where hardly any point needs more than a quick look, a model may
/// offer its update in two parts:
///
///   MaskOf<R> start_points(PointsOf&) const    updates the quick points, returns the others
///   void finish_points(PointsOf* groups, const MaskOf<R>* rest, int count) const
///
/// count is at most the model's groups_together: the work left in several groups is shared out over
/// the lanes. A point's result depends on the point alone.
template <class Tensor, class History>
struct PointsOf {
  IncrementOf<Tensor> increment;
  Tensor stress;  ///< [stress]
  History history;
  PointsOutcome<typename Tensor::Real> outcome;
};

/// Start of a scene under hydrostatic pressure p >= 0: stress, history and density in equilibrium.
template <class Tensor, class History>
struct InitialStateOf {
  Tensor stress;
  History history;
  double volume_ratio = 1.0;   ///< V / V_ref under that pressure; 1 for laws given in rate form
  double stored_energy = 0.0;  ///< elastic energy of that state per reference volume [stress]
  bool possible = true;  ///< false: the pressure is beyond what the material can hold elastically
};

}  // namespace barreno

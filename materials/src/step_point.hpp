// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/tangent.hpp"
#include "barreno_material.h"

#include <cmath>
#include <cstring>

namespace barreno::c_interface {

/// State variables that every model has, before its own history.
enum Slot { initialized, volume_ratio, first_of_history };

/// C index of each component of a Sym3: 11 22 33 12 13 23 against xx yy zz xy yz zx.
inline constexpr int place[6] = {0, 1, 2, 3, 5, 4};

inline Sym3 read_tensor(const double* v) {
  return {v[place[0]], v[place[1]], v[place[2]], v[place[3]], v[place[4]], v[place[5]]};
}
inline void write_tensor(Sym3 s, double* v) {
  for (int i = 0; i < 6; ++i) v[place[i]] = tangent::components(s)[i];
}
inline bool all_finite(const double* v, int n) {
  for (int i = 0; i < n; ++i) {
    if (!std::isfinite(v[i])) return false;
  }
  return true;
}
/// Old values of a point that failed, in the arrays of new ones; never one that is not finite.
inline void keep(const double* old, double* kept, int n) {
  for (int i = 0; i < n; ++i) kept[i] = std::isfinite(old[i]) ? old[i] : 0.0;
}

/// What a model advances, from the arrays of a host.
template <class Model>
struct HostPoint {
  Sym3 stress{};
  typename Model::History history{};
  double ratio = 1.0;  ///< V / V_ref
};

template <class Model>
constexpr int state_count() {
  return first_of_history + Model::history_count;
}

/// Pressure under which virgin rock stands by the fluid in its pores; 0 for all other models.
template <class Model>
auto virgin_pressure(const Model& model, int /*preferred*/) -> decltype(model.virgin_pressure()) {
  return model.virgin_pressure();
}
template <class Model>
double virgin_pressure(const Model& /*model*/, long /*otherwise*/) {
  return 0.0;
}

// A host that carries states from mesh to mesh may bring 0 and 1 with round-off.
constexpr double near = 1e-6;

/// True of a point that its host starts without pressure, though the pores hold one: unstressed as
/// a whole, its rock would be under tension from the first step on.
template <class Model>
bool lacks_initial_stress(const Model& model, const double* stress, const double* state) {
  const bool without = stress[0] + stress[1] + stress[2] >= 0.0;
  return without && std::fabs(state[initialized]) < near && virgin_pressure(model, 0) > 0.0;
}

/// A point that the host has not touched yet: in equilibrium under its pressure, if it has one.
/// @return false if it cannot be so
template <class Model>
bool begin_virgin(const Model& model, HostPoint<Model>& point) {
  point.history = model.initial_history();
  const double pressure = -trace(point.stress) / 3.0;
  if (!(pressure > 0.0)) return virgin_pressure(model, 0) == 0.0;
  const auto confined = model.initial_state(pressure);
  point.history = confined.history;
  point.ratio = confined.volume_ratio;
  return confined.possible;
}

/// @return false if such a point cannot be
template <class Model>
bool read_point(
    const Model& model, const double* stress, const double* state, HostPoint<Model>& point
) {
  if (!all_finite(stress, 6) || !all_finite(state, state_count<Model>())) return false;
  point.stress = read_tensor(stress);
  if (std::fabs(state[initialized]) < near) return begin_virgin(model, point);
  point.ratio = state[volume_ratio];
  if (Model::history_count > 0)
    std::memcpy(
        static_cast<void*>(&point.history),
        state + first_of_history,
        Model::history_count * sizeof(double)
    );
  return std::fabs(state[initialized] - 1.0) < near && point.ratio > 0.0;
}

template <class Model>
void write_state(const HostPoint<Model>& point, double* state) {
  state[initialized] = 1.0;
  state[volume_ratio] = point.ratio;
  if (Model::history_count > 0)
    std::memcpy(state + first_of_history, &point.history, Model::history_count * sizeof(double));
}

inline bool write_tangent(const Tangent& t, double* out) {
  for (int i = 0; i < 6; ++i) {
    for (int j = 0; j < 6; ++j) out[6 * place[i] + place[j]] = t.c[i][j];
  }
  return all_finite(out, 36);
}

template <class Model>
bool write_elastic_tangent(const Model& model, const HostPoint<Model>& p, double* out) {
  return write_tangent(elastic_tangent(model, p.stress, p.history, p.ratio), out);
}

/// Where the arrays of one point begin; `tangent` and `work` may be null.
struct PointArrays {
  const double *strain, *stress_old, *state_old;
  double *stress_new, *state_new, *tangent, *work;
};

/// Verdict and new values of a point whose old ones were read.
template <class Model>
Outcome advance(
    const Model& model,
    double dt,
    int want,
    const double* strain,
    HostPoint<Model>& point,
    Tangent& tangent
) {
  Increment increment{};
  increment.strain = read_tensor(strain);
  increment.dt = dt;
  increment.volume_ratio_begin = point.ratio;
  increment.volume_ratio_end = point.ratio * std::exp(trace(increment.strain));
  Outcome refused;
  refused.status = Status::bad_input;
  if (!(increment.volume_ratio_end > 0.0) || !std::isfinite(increment.volume_ratio_end))
    return refused;
  const Outcome outcome =
      want == BARRENO_CONSISTENT
          ? update_with_tangent(model, increment, point.stress, point.history, tangent)
          : model.update(increment, point.stress, point.history);
  if (!outcome.failed()) point.ratio = increment.volume_ratio_end;
  return outcome;
}

/// Advances one point; the arrays of new values are written in every case, finite in every case.
template <class Model>
Status step_point(const Model& model, double dt, int want, const PointArrays& p) {
  constexpr int n = state_count<Model>();
  HostPoint<Model> begin;
  const bool sound = read_point(model, p.stress_old, p.state_old, begin) &&
                     all_finite(p.strain, 6) && dt >= 0.0 && std::isfinite(dt);
  HostPoint<Model> end = begin;
  Tangent tangent;
  Outcome outcome;
  outcome.status = Status::bad_input;
  if (sound) outcome = advance(model, dt, want, p.strain, end, tangent);
  double stress[6], state[static_cast<std::size_t>(n)];
  write_tensor(end.stress, stress);
  write_state(end, state);
  const double work[2] = {outcome.elastic_work, outcome.plastic_work};
  if (!outcome.failed() && !(all_finite(stress, 6) && all_finite(state, n) && all_finite(work, 2)))
    outcome.status = Status::not_converged;
  const bool ok = !outcome.failed();
  if (p.tangent != nullptr) {
    const bool written = ok && want == BARRENO_CONSISTENT
                             ? write_tangent(tangent, p.tangent)
                             : sound && write_elastic_tangent(model, begin, p.tangent);
    if (!written) {
      HostPoint<Model> virgin;
      begin_virgin(model, virgin);
      write_elastic_tangent(model, virgin, p.tangent);
    }
  }
  keep(ok ? stress : p.stress_old, p.stress_new, 6);
  keep(ok ? state : p.state_old, p.state_new, n);
  if (p.work != nullptr) {
    for (int i = 0; i < 2; ++i) p.work[i] = ok ? work[i] : 0.0;
  }
  return outcome.status;
}

}  // namespace barreno::c_interface

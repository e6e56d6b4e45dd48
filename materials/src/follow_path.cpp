// SPDX-License-Identifier: BSD-3-Clause
// Paths of laboratory tests in the C interface: steps of which some components of the strain are
// given and of the others the stress.
#include "barreno_material.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace {

constexpr double exact = 1e-7;   // of the stress
constexpr double enough = 1e-4;  // where Newton's method stalls at a jump of the update
constexpr double fast = 0.2;     // of the residual before: a tangent that leaves more is made anew
constexpr double least_stress = 1e5;
constexpr int most_steps = 60, most_halvings = 8;

/// A point on its way.
struct PathPoint {
  const barreno_material* material;
  double dt;
  double stress[6];
  std::vector<double> state;
};

/// An increment that was tried.
struct Tried {
  double strain[6], stress[6], tangent[36];
  std::vector<double> state;
  int status;
};

void try_increment(const PathPoint& point, int want, Tried& tried) {
  tried.state.resize(point.state.size());
  barreno_batch batch{};
  batch.count = 1;
  batch.want = want;
  batch.time_increment = point.dt;
  batch.strain_increment = tried.strain;
  batch.stress_old = point.stress;
  batch.stress_new = tried.stress;
  batch.state_old = point.state.data();
  batch.state_new = tried.state.data();
  batch.tangent = want == BARRENO_STRESS ? nullptr : tried.tangent;
  batch.status = &tried.status;
  if (barreno_material_update(point.material, &batch) < 0) tried.status = BARRENO_BAD_INPUT;
}

/// The components whose stress is given, and what it is.
struct Held {
  int count = 0;
  int component[6] = {};
  double target[6] = {};
};
Held held_of(const double* target) {
  Held held;
  for (int c = 0; c < 6; ++c) {
    if (std::isnan(target[c])) continue;
    held.component[held.count] = c;
    held.target[held.count++] = target[c];
  }
  return held;
}

using Square = double[6][6];

/// d stress/d strain of the held components; shear strains are those of the tensor.
void held_tangent(const Held& held, const Tried& tried, Square& slope) {
  for (int i = 0; i < held.count; ++i)
    for (int j = 0; j < held.count; ++j) {
      const double part = tried.tangent[6 * held.component[i] + held.component[j]];
      slope[i][j] = held.component[j] < 3 ? part : 2.0 * part;
    }
}

/// Solves slope x = right by Gauss' elimination.
/// @return false where the slope is singular
bool solve(const Square& slope, const double* right, int n, double* x) {
  Square a;
  double b[6];
  for (int i = 0; i < n; ++i) {
    std::copy(slope[i], slope[i] + n, a[i]);
    b[i] = right[i];
  }
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (std::fabs(a[i][k]) > std::fabs(a[pivot][k])) pivot = i;
    if (!(std::fabs(a[pivot][k]) > 0.0)) return false;
    std::swap_ranges(a[k], a[k] + n, a[pivot]);
    std::swap(b[k], b[pivot]);
    for (int i = k + 1; i < n; ++i) {
      const double factor = a[i][k] / a[k][k];
      for (int j = k; j < n; ++j) a[i][j] -= factor * a[k][j];
      b[i] -= factor * b[k];
    }
  }
  for (int k = n - 1; k >= 0; --k) {
    double sum = b[k];
    for (int j = k + 1; j < n; ++j) sum -= a[k][j] * x[j];
    x[k] = sum / a[k][k];
    if (!std::isfinite(x[k])) return false;
  }
  return true;
}

/// Held stresses less what they should be, and the largest of them; infinite where the update has
/// failed.
double residual_of(const Held& held, const Tried& tried, double* residual) {
  double largest = 0.0;
  for (int i = 0; i < held.count; ++i) {
    residual[i] = tried.stress[held.component[i]] - held.target[i];
    largest = std::max(largest, std::fabs(residual[i]));
  }
  return tried.status == BARRENO_OK ? largest : std::numeric_limits<double>::infinity();
}

double scale_of(const Tried& tried) {
  double largest = least_stress;
  for (const double s : tried.stress) largest = std::max(largest, std::fabs(s));
  return largest;
}

/// Broyden's update: the slope follows what a step has shown.
void follow_slope(
    const double* step, const double* before, const double* after, int n, Square& slope
) {
  double squares = 0.0;
  for (int j = 0; j < n; ++j) squares += step[j] * step[j];
  for (int i = 0; i < n && squares > 0.0; ++i) {
    double left = after[i] - before[i];
    for (int j = 0; j < n; ++j) left -= slope[i][j] * step[j];
    for (int j = 0; j < n; ++j) slope[i][j] += left * step[j] / squares;
  }
}

/// One step of a point: Newton's method for the strains of the held components, shortened while the
/// residual grows. A tangent costs three updates: as long as the residual falls fast, the slope is
/// Broyden's.
/// @param[in,out] at  with the strains to begin with; the step that was taken
/// @return whether the stresses were reached
bool take_step(const PathPoint& point, const Held& held, Tried& at) {
  try_increment(point, held.count > 0 ? BARRENO_CONSISTENT : BARRENO_STRESS, at);
  if (at.status != BARRENO_OK) return false;
  double residual[6];
  double size = residual_of(held, at, residual);
  Square slope;
  held_tangent(held, at, slope);
  Tried next;
  for (int turn = 0; turn < most_steps && size > exact * scale_of(at); ++turn) {
    double step[6], right[6], left[6];
    for (int i = 0; i < held.count; ++i) right[i] = -residual[i];
    if (!solve(slope, right, held.count, step)) break;
    double size_after = 0.0;
    for (int halving = 0; halving < most_halvings; ++halving) {
      std::copy(at.strain, at.strain + 6, next.strain);
      for (int i = 0; i < held.count; ++i) next.strain[held.component[i]] += step[i];
      try_increment(point, BARRENO_STRESS, next);
      size_after = residual_of(held, next, left);
      if (size_after <= size) break;
      for (int i = 0; i < held.count; ++i) step[i] *= 0.5;
    }
    if (!std::isfinite(size_after)) return false;
    const bool slow = size_after > fast * size;
    std::copy(next.strain, next.strain + 6, at.strain);
    if (slow) {
      try_increment(point, BARRENO_CONSISTENT, at);
      held_tangent(held, at, slope);
    } else {
      follow_slope(step, residual, left, held.count, slope);
      std::copy(next.stress, next.stress + 6, at.stress);
      at.state = next.state;
      at.status = next.status;
    }
    size = residual_of(held, at, residual);
  }
  return size <= enough * scale_of(at);
}

/// Strains to begin with: as in the step before where the same stresses were held and the given
/// strains go on in its direction, else the caller's.
void first_guess(
    const Held& held,
    const Held& held_before,
    const double* given,
    const double* before,
    double* strain
) {
  std::copy(given, given + 6, strain);
  const bool same = before != nullptr && held.count == held_before.count &&
                    std::equal(held.component, held.component + held.count, held_before.component);
  if (!same) return;
  bool is_held[6] = {};
  for (int i = 0; i < held.count; ++i) is_held[held.component[i]] = true;
  double product = 0.0, squares = 0.0, squares_now = 0.0;
  for (int c = 0; c < 6; ++c) {
    if (is_held[c]) continue;
    product += given[c] * before[c];
    squares += before[c] * before[c];
    squares_now += given[c] * given[c];
  }
  const double still = squares_now == 0.0 ? 1.0 : 0.0;
  const double ratio = squares > 0.0 ? product / squares : still;
  if (!(ratio > 0.0)) return;
  for (int i = 0; i < held.count; ++i)
    strain[held.component[i]] = ratio * before[held.component[i]];
}

/// The path of point i.
/// @return its status
int follow(const barreno_material* material, const barreno_path& path, int i) {
  const std::ptrdiff_t n = barreno_material_state_count(material),
                       row = 6 * std::ptrdiff_t(path.count);
  PathPoint point{material, path.time_increment, {}, {}};
  std::copy(path.stress_old + 6 * i, path.stress_old + 6 * i + 6, point.stress);
  point.state.assign(path.state_old + n * i, path.state_old + n * (i + 1));
  int status = BARRENO_OK;
  Held held_before;
  const double* before = nullptr;
  Tried at;
  for (int k = 0; k < path.steps; ++k) {
    const std::ptrdiff_t here = k * row + 6 * i;
    const Held held = held_of(path.stress_wanted + here);
    first_guess(held, held_before, path.strain_increment + here, before, at.strain);
    if (status == BARRENO_OK && !take_step(point, held, at)) status = BARRENO_NOT_CONVERGED;
    if (status == BARRENO_OK) {
      std::copy(at.stress, at.stress + 6, point.stress);
      point.state = at.state;
    } else {
      std::fill(at.strain, at.strain + 6, 0.0);
    }
    std::copy(at.strain, at.strain + 6, path.strain_taken + here);
    std::copy(point.stress, point.stress + 6, path.stress + here);
    before = path.strain_taken + here;
    held_before = held;
  }
  std::copy(point.state.begin(), point.state.end(), path.state_new + n * i);
  return status;
}

}  // namespace

namespace barreno::c_interface {

int follow_all(const barreno_material* material, const barreno_path& path) {
  int failed = 0;
  for (int i = 0; path.steps > 0 && i < path.count; ++i) {
    const int status = follow(material, path, i);
    if (path.status != nullptr) path.status[i] = status;
    failed += status == BARRENO_OK ? 0 : 1;
  }
  return failed;
}

}  // namespace barreno::c_interface

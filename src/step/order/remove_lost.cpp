// SPDX-License-Identifier: BSD-3-Clause
#include "step/order/remove_lost.hpp"

#include "base/row_sum.hpp"

#include <cmath>

namespace barreno {
namespace {

struct LostTally {
  int rows = 0;
  RemovalTallyOf<ReproducibleSum> by_cause[removal_causes];
};
KOKKOS_INLINE_FUNCTION void add(const LostTally& from, LostTally& to) {
  to.rows += from.rows;
  for (int cause = 0; cause < removal_causes; ++cause) {
    to.by_cause[cause].count += from.by_cause[cause].count;
    to.by_cause[cause].mass += from.by_cause[cause].mass;
    to.by_cause[cause].momentum += from.by_cause[cause].momentum;
    to.by_cause[cause].kinetic += from.by_cause[cause].kinetic;
  }
}

/// Of motion that is not finite only the mass counts.
KOKKOS_INLINE_FUNCTION void tally_removal(
    double mass, const FieldView& velocity, int p, RemovalTallyOf<ReproducibleSum>& tally
) {
  tally.count += 1.0;
  tally.mass += mass;
  double v[3] = {};
  for (std::size_t d = 0; d < velocity.extent(1); ++d) v[d] = velocity(p, d);
  const double square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
  if (!std::isfinite(square)) return;
  tally.momentum += mass * v[1];
  tally.kinetic += 0.5 * mass * square;
}

/// Marks the lost rows in `spare`.
LostTally mark_lost(const RemovalRule& rule, const Particles& particles) {
  const ArrayView<int> lost = particles.spare;
  const FieldView mass = particles.mass.values;
  LostTally tally;
  launch_reduction(
      "mark_lost",
      range(particles.count),
      KOKKOS_LAMBDA(const int p, LostTally& part) {
        const int cause = rule.cause_of(p);
        lost(p) = cause < 0 ? 0 : 1;
        if (cause < 0) return;
        ++part.rows;
        tally_removal(mass(p, 0), rule.velocity, p, part.by_cause[cause]);
      },
      TallyReducer<LostTally>(tally)
  );
  return tally;
}

}  // namespace

Fault fault_of_cause(int cause) {
  if (cause == static_cast<int>(RemovalCause::material_failure)) return Fault::failed;
  if (cause == static_cast<int>(RemovalCause::expanded)) return Fault::expanded;
  if (cause == static_cast<int>(RemovalCause::inverted)) return Fault::inverted;
  return Fault::none;
}

void remove_lost(const Grid& grid, Particles& particles, OwnLedger& ledger) {
  const LostTally lost = mark_lost(RemovalRule(grid, particles), particles);
  remove_marked_rows(particles, lost.rows);
  if (particles.rigid) return;
  for (std::size_t cause = 0; cause < removal_causes; ++cause) {
    const RemovalTallyOf<ReproducibleSum>& one = lost.by_cause[cause];
    auto& tally = ledger.removed[cause];
    tally.count += one.count;
    tally.mass += one.mass;
    tally.momentum += one.momentum;
    tally.kinetic += one.kinetic;
    ledger.mass -= one.mass;
    ledger.momentum -= one.momentum;
    ledger.kinetic -= one.kinetic;
  }
}

}  // namespace barreno

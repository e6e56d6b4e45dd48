// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/particles.hpp"
#include "step/stable_step_rule.hpp"

#include <cmath>

namespace barreno {

/// Whether the rows of a cell decide on their step together. Divided rows of a jet are small beside
/// their cells: a stiff one hardly moves the mass that it shares its nodes with. Domains that
/// follow the deformation have their own limits (tally_domains).
inline bool decides_by_cells(const Particles& particles) {
  const SplitRule& rule = particles.split_rule;
  return rule.most > 0 && rule.body >= 0 && !rule.halves;
}

/// Steps of such sets; captured by value in kernels.
struct CellStepRule {
  StableStepRule rule;
  Particles particles;
  double fraction;

  CellStepRule(const StepSpec& step, Mode mode, const Particles& of)
      : rule(step, mode, of.critical_courant, of.isolated_courant),
        particles(of),
        fraction(step.courant_fraction) {}

  /// sum_d 1/C_d^2, C_d the critical Courant number of the row's size along axis d: frequencies
  /// along the axes add up as squares.
  KOKKOS_INLINE_FUNCTION double frequency_squared(double cell_size, int p) const {
    double sum = 0.0;
    for (int d = 0; d < particles.half_size.components; ++d) {
      const double critical = particles.courant_table.at(particles.half_size(p, d) / cell_size);
      sum += 1.0 / (critical * critical);
    }
    return sum;
  }
  /// The least step that the cells of a tile allow [time].
  /// @pre  the rows are sorted by cell
  KOKKOS_INLINE_FUNCTION double of_tile(int tile, double cell_size) const;
  /// Of a row that is alone in its cell, and not compressed yet.
  KOKKOS_INLINE_FUNCTION double of_row(int p, double cell_size) const;
};

/// The rows of one cell, taken up one by one:
///
///   dt = C h / (sqrt(sum m k w^2 / sum m) + max sqrt(k) |v|),   k = sum_d 1/C_d^2
///
/// w is a row's Q + sqrt(Q^2 + c^2) (StableStepRule). The frequency of what moves together is the
/// root of stiffness over mass, both of all that is in the cell. For rows that are alike this is
/// StableStepRule::stable_step.
struct CellStep {
  double mass = 0.0, stiffness = 0.0, speed = 0.0, fastest_wave = 0.0;

  KOKKOS_INLINE_FUNCTION void add(const CellStepRule& of, double cell_size, double rate, int p) {
    const Particles& particles = of.particles;
    const double own = particles.mass(p);
    const double density = own / particles.volume(p);
    const double modulus = particles.longitudinal_modulus(p);
    const double wave = of.rule.wave_speed(cell_size, density, modulus, rate);
    const double frequency_squared = of.frequency_squared(cell_size, p);
    double square = 0.0;
    for (int d = 0; d < particles.velocity.components; ++d)
      square += particles.velocity(p, d) * particles.velocity(p, d);
    const double own_speed = std::sqrt(frequency_squared * square);
    mass += own;
    stiffness += own * frequency_squared * wave * wave;
    speed = own_speed > speed ? own_speed : speed;
    fastest_wave = wave > fastest_wave ? wave : fastest_wave;
  }
  /// @pre it has rows
  KOKKOS_INLINE_FUNCTION double stable_step(const CellStepRule& of, double cell_size) const {
    const double together = of.fraction / (std::sqrt(stiffness / mass) + speed);
    const double alone = of.rule.courant / (of.rule.isolated_ratio * fastest_wave);
    return cell_size * (alone < together ? alone : together);
  }
};

KOKKOS_INLINE_FUNCTION double CellStepRule::of_tile(int tile, double cell_size) const {
  double least = HUGE_VAL;
  const int end = particles.tile_begin(tile + 1);
  for (int begin = particles.tile_begin(tile), next = begin; begin < end; begin = next) {
    CellStep cell;
    const CellKey key = particles.key(particles.order(begin));
    for (; next < end && particles.key(particles.order(next)) == key; ++next) {
      const int p = particles.order(next);
      if ((particles.body(p) & debris_bit) != 0) continue;
      const double density = particles.mass(p) / particles.volume(p);
      cell.add(
          *this, cell_size, rule.compression(cell_size, density, particles.viscous_pressure(p)), p
      );
    }
    if (!(cell.mass > 0.0)) continue;
    const double of_cell = cell.stable_step(*this, cell_size);
    least = of_cell < least ? of_cell : least;
  }
  return least;
}

KOKKOS_INLINE_FUNCTION double CellStepRule::of_row(int p, double cell_size) const {
  CellStep cell;
  cell.add(*this, cell_size, 0.0, p);
  return cell.stable_step(*this, cell_size);
}

}  // namespace barreno

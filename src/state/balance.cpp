// SPDX-License-Identifier: BSD-3-Clause
#include "state/balance.hpp"

#include "base/numbers.hpp"
#include "state/ledger_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <type_traits>
#include <vector>

namespace barreno {

namespace {

using OwnTerms = LedgerTerms<ReproducibleSum>;
using Terms = LedgerTerms<double>;
constexpr std::size_t term_count = sizeof(OwnTerms) / sizeof(ReproducibleSum);
static_assert(
    sizeof(OwnTerms) == term_count * sizeof(ReproducibleSum) &&
        sizeof(Terms) == term_count * sizeof(double) && std::is_trivially_copyable_v<Terms>,
    "ledgers are read as arrays of their terms"
);

/// visit(term) for all energies of all materials.
template <class AnyLedger, class Visitor>
void for_each_material_term(AnyLedger& ledger, Visitor&& visit) {
  for (auto& energies : ledger.materials)
    for (auto* term :
         {&energies.prestress,
          &energies.elastic,
          &energies.plastic,
          &energies.viscous,
          &energies.explosive})
      visit(*term);
}

}  // namespace

std::vector<ReproducibleSum> terms_of(const OwnLedger& ledger) {
  std::vector<ReproducibleSum> terms(term_count);
  std::memcpy(
      static_cast<void*>(terms.data()), static_cast<const OwnTerms*>(&ledger), sizeof(OwnTerms)
  );
  return terms;
}

void put_terms(const std::vector<ReproducibleSum>& terms, OwnLedger& ledger) {
  std::memcpy(static_cast<void*>(static_cast<OwnTerms*>(&ledger)), terms.data(), sizeof(OwnTerms));
}

std::vector<ReproducibleSum> material_terms_of(const OwnLedger& ledger) {
  std::vector<ReproducibleSum> terms;
  for_each_material_term(ledger, [&](const ReproducibleSum& term) { terms.push_back(term); });
  return terms;
}

void put_material_terms(const std::vector<ReproducibleSum>& terms, OwnLedger& ledger) {
  auto next = terms.begin();
  for_each_material_term(ledger, [&](ReproducibleSum& term) { term = *next++; });
}

void carry(OwnLedger& ledger) {
  auto* const terms = reinterpret_cast<ReproducibleSum*>(static_cast<OwnTerms*>(&ledger));
  for (std::size_t i = 0; i < term_count; ++i) terms[i].carry();
  for_each_material_term(ledger, [](ReproducibleSum& term) { term.carry(); });
}

Ledger sum_over_ranks(const Comm& comm, const OwnLedger& mine) {
  std::vector<ReproducibleSum> terms = terms_of(mine);
  sum_over_ranks(comm, terms);
  const std::vector<double> values(terms.begin(), terms.end());
  Ledger sum;
  std::memcpy(static_cast<void*>(static_cast<Terms*>(&sum)), values.data(), sizeof(Terms));
  sum.retried_steps = mine.retried_steps;  // every rank counted the same steps
  std::vector<ReproducibleSum> of_materials = material_terms_of(mine);
  sum_over_ranks(comm, of_materials);
  sum.materials.resize(mine.materials.size());
  auto next = of_materials.begin();
  for_each_material_term(sum, [&](double& term) { term = *next++; });
  return sum;
}

RemovalTally total_removed(const Ledger& ledger) {
  RemovalTally total;
  for (const RemovalTally& tally : ledger.removed) {
    total.count += tally.count;
    total.mass += tally.mass;
    total.momentum += tally.momentum;
    total.kinetic += tally.kinetic;
  }
  return total;
}

double Balance::error() const {
  if (remainder == 0.0) return 0.0;
  const double scale = std::max(put_in, moved);
  return scale > 0.0 ? remainder / scale : std::numeric_limits<double>::infinity();
}

namespace {

double signed_put_in(const Ledger& l, Conserved what) {
  return add_rows(l, what, Part::worked, add_rows(l, what, Part::supplied, 0.0));
}
double energy_put_in(const Ledger& l) {
  const double supplied = add_magnitudes(l, Conserved::energy, Part::supplied, 0.0);
  return add_magnitudes(l, Conserved::energy, Part::worked, supplied);
}
double energy_moved(const Ledger& l) {
  return std::max(
      largest_magnitude(l, Conserved::energy, Part::exchanged),
      largest_magnitude(l, Conserved::energy, Part::numerical)
  );
}

}  // namespace

Balance mass_balance(const Ledger& l) {
  const double put_in = signed_put_in(l, Conserved::mass);
  return {add_rows(l, Conserved::mass, Part::held, 0.0) - put_in, put_in};
}

Balance momentum_balance(const Ledger& l) {
  constexpr Conserved along_y = Conserved::momentum;
  // Net momenta may cancel (a standing wave, a load across y): the roots are what the same energy
  // carries one way.
  const double work = add_magnitudes(l, Conserved::energy, Part::worked, 0.0);
  const double roots = std::sqrt(2.0 * l.initial_mass * l.initial_kinetic) +
                       std::sqrt(2.0 * l.launched_mass * l.launched_kinetic) +
                       std::sqrt(2.0 * l.initial_mass * work);
  const double scale = add_magnitudes(l, along_y, Part::worked, roots);
  const double unpaid = std::max(0.0, energy_moved(l) - energy_put_in(l));
  // |p| <= sqrt(2 m K): the round-off of forces that cancel, before any of them has done work.
  const bool is_round_off =
      scale == 0.0 && unpaid == 0.0 && l.kinetic == 0.0 && total_removed(l).kinetic == 0.0;
  const double held = add_rows(l, along_y, Part::held, 0.0);
  return {
      is_round_off ? 0.0 : held - signed_put_in(l, along_y),
      scale,
      std::sqrt(2.0 * l.initial_mass * unpaid)};
}

Balance energy_balance(const Ledger& l) {
  constexpr Conserved energy = Conserved::energy;
  double remainder = add_rows(l, energy, Part::held, 0.0) - signed_put_in(l, energy);
  remainder = add_rows(l, energy, Part::exchanged, remainder, -1.0);
  remainder = add_rows(l, energy, Part::numerical, remainder, -1.0);
  return {remainder, energy_put_in(l), energy_moved(l)};
}

NumericalEnergy numerical_energy(const Ledger& l) {
  const double scale = energy_balance(l).put_in;
  return {Balance{l.stress_integration, scale}.error(), Balance{l.transfer, scale}.error()};
}

namespace {

/// Cross-section of a slug within the grid: a disk, of which planes x = 0 and z = 0 leave a half or
/// a quarter, or in plane strain a width.
double section_inside(const JetSlug& slug, const GridSpec& grid) {
  const double disk = pi * slug.radius * slug.radius;
  if (grid.mode == Mode::axisymmetric) return disk;
  if (grid.mode == Mode::three_dimensional)
    return disk * (grid.lower[0] < 0.0 ? 1.0 : 0.5) * (grid.lower[2] < 0.0 ? 1.0 : 0.5);
  return std::min(slug.radius, grid.upper[0]) - std::max(-slug.radius, grid.lower[0]);
}

const std::vector<JetSlug>& rows_of(const JetSpec& jet) {
  return jet.table.empty() ? jet.slugs : jet.table;
}

double mass_inside(const JetSlug& slug, const GridSpec& grid) {
  return slug.density * section_inside(slug, grid) * slug.length;
}

}  // namespace

std::vector<double> jet_table_masses(const Scene& scene) {
  std::vector<double> masses;
  for (const JetSlug& slug : rows_of(scene.jet)) masses.push_back(mass_inside(slug, scene.grid));
  return masses;
}

JetTotals jet_table_totals(const Scene& scene, std::size_t slugs) {
  JetTotals totals;
  const std::vector<JetSlug>& rows = rows_of(scene.jet);
  for (std::size_t s = 0; s < std::min(slugs, rows.size()); ++s) {
    const JetSlug& slug = rows[s];
    const double mass = mass_inside(slug, scene.grid);
    totals.mass += mass;
    totals.momentum += mass * slug.velocity * scene.jet.direction;
    totals.kinetic += 0.5 * mass * slug.velocity * slug.velocity;
  }
  return totals;
}

}  // namespace barreno

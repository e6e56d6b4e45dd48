// SPDX-License-Identifier: BSD-3-Clause
// Rows of ledger_table() that are sums, and the results of their balances.
#include "state/balance.hpp"
#include "state/ledger_table.hpp"

namespace barreno {
namespace {

using P = Part;
using RowValue = std::function<double(const Ledger&)>;
using LedgerRows = std::vector<LedgerRow>;

/// Rows of one balance, of which `path` is that in summary.json.
class BalanceRows {
public:
  BalanceRows(Conserved unit, const char* path) : unit_(unit), path_(path) {}
  /// @param word  in summary.json
  void add(
      const std::string& name,
      const std::string& word,
      int column,
      Part part,
      RowValue value,
      const std::string& meaning
  ) {
    rows_.push_back({name, meaning, std::move(value), unit_, part, column, path_ + word, ""});
  }
  void add(
      const std::string& name, int column, Part part, RowValue value, const std::string& meaning
  ) {
    add(name, name, column, part, std::move(value), meaning);
  }
  /// Its result, with a column for the error alone.
  void add_result(int column, const std::string& what, Balance (*balance)(const Ledger&)) {
    add(
        "remainder",
        0,
        P::outside,
        [=](const Ledger& l) { return balance(l).remainder; },
        "what the balance leaves over"
    );
    add(
        "put_in",
        0,
        P::outside,
        [=](const Ledger& l) { return balance(l).put_in; },
        "what the remainder is compared with"
    );
    add_ratio(
        what + "_error",
        "error",
        column,
        [=](const Ledger& l) { return balance(l).error(); },
        "remainder of the " + what + " balance, relative to the " + what + " put in"
    );
  }
  void add_ratio(
      const std::string& name,
      const std::string& word,
      int column,
      RowValue value,
      const std::string& meaning
  ) {
    add(name, word, column, P::outside, std::move(value), meaning);
    rows_.back().unit = Conserved::none;
  }
  const LedgerRows& rows() const { return rows_; }

private:
  Conserved unit_;
  std::string path_;
  LedgerRows rows_;
};

double removed_mass(const Ledger& l) {
  return total_removed(l).mass;
}
double removed_momentum(const Ledger& l) {
  return total_removed(l).momentum;
}
double removed_kinetic(const Ledger& l) {
  return total_removed(l).kinetic;
}

LedgerRows mass_rows() {
  BalanceRows mass(Conserved::mass, "balances.mass.");
  mass.add("mass", "now", 1, P::held, &Ledger::mass, "mass of all particles now");
  mass.add("initial_mass", "initial", 0, P::supplied, &Ledger::initial_mass, "at the start");
  mass.add(
      "launched_mass",
      "launched",
      0,
      P::supplied,
      &Ledger::launched_mass,
      "of the jet particles launched so far"
  );
  mass.add("removed_mass", "removed", 0, P::held, removed_mass, "of particles that were removed");
  mass.add_result(15, "mass", mass_balance);
  return mass.rows();
}

LedgerRows momentum_rows() {
  BalanceRows along_y(Conserved::momentum, "balances.momentum.");
  along_y.add(
      "momentum", "now", 2, P::held, &Ledger::momentum, "momentum of all particles now, along y"
  );
  along_y.add(
      "initial_momentum", "initial", 0, P::supplied, &Ledger::initial_momentum, "at the start"
  );
  along_y.add(
      "launched_momentum",
      "launched",
      0,
      P::supplied,
      &Ledger::launched_momentum,
      "of the jet particles launched so far"
  );
  along_y.add(
      "condition_impulse",
      0,
      P::worked,
      &Ledger::condition_impulse,
      "impulse of conditions on the material"
  );
  along_y.add("load_impulse", 0, P::worked, &Ledger::load_impulse, "impulse of loads");
  along_y.add("body_impulse", 0, P::worked, &Ledger::body_impulse, "impulse of the body force");
  along_y.add(
      "damping_impulse", 0, P::worked, &Ledger::damping_impulse, "impulse of `Step/Damping`"
  );
  along_y.add(
      "rigid_impulse",
      25,
      P::worked,
      &Ledger::rigid_impulse,
      "impulse of rigid bodies on the material"
  );
  along_y.add(
      "removed_momentum", "removed", 0, P::held, removed_momentum, "of particles that were removed"
  );
  along_y.add_result(16, "momentum", momentum_balance);
  return along_y.rows();
}

void add_held_energy(BalanceRows& energy) {
  energy.add("kinetic", 3, P::held, &Ledger::kinetic, "kinetic energy of all particles now");
  energy.add(
      "elastic",
      4,
      P::held,
      &Ledger::elastic,
      "elastic energy: that of the initial equilibrium (`prestress`) and the elastic work "
      "since then; it may fall below zero ([Energy](#energy))"
  );
  energy.add("plastic", 5, P::held, &Ledger::plastic, "work dissipated by the materials");
  energy.add(
      "viscous", 6, P::held, &Ledger::viscous, "work dissipated by the artificial viscosity"
  );
  energy.add(
      "friction", 24, P::held, &Ledger::friction, "dissipated by surfaces that slide on each other"
  );
  energy.add("damped", 10, P::held, &Ledger::damped, "work done against `Step/Damping`");
  energy.add(
      "removed_kinetic",
      13,
      P::held,
      removed_kinetic,
      "kinetic energy of particles that were removed"
  );
}

void add_energy_put_in(BalanceRows& energy) {
  energy.add(
      "initial_kinetic", 0, P::supplied, &Ledger::initial_kinetic, "kinetic energy at the start"
  );
  energy.add(
      "launched_kinetic",
      8,
      P::supplied,
      &Ledger::launched_kinetic,
      "kinetic energy of the jet particles launched so far"
  );
  energy.add(
      "prestress", 0, P::supplied, &Ledger::prestress, "elastic energy of the initial equilibrium"
  );
  energy.add(
      "explosive",
      28,
      P::worked,
      &Ledger::explosive,
      "energy that explosives have given to everything else, their own kinetic energy "
      "included ([explosives.md](explosives.md))"
  );
  energy.add(
      "boundary_work",
      7,
      P::worked,
      &Ledger::boundary_work,
      "work of loads, moving conditions and rigid bodies on the material"
  );
  energy.add("body_work", 9, P::worked, &Ledger::body_work, "work of the body force");
}

LedgerRows energy_rows_of_table() {
  BalanceRows energy(Conserved::energy, "balances.energy.");
  add_held_energy(energy);
  add_energy_put_in(energy);
  energy.add(
      "fluid_work",
      0,
      P::exchanged,
      &Ledger::fluid_work,
      "with Pore Flow: work that the fluid brought into the rock where it flowed in"
  );
  energy.add(
      "transfer",
      12,
      P::numerical,
      &Ledger::transfer,
      "numerical error: kinetic energy that particles gained when velocities went to the "
      "grid and back; negative: lost"
  );
  energy.add(
      "stress_integration",
      11,
      P::numerical,
      &Ledger::stress_integration,
      "numerical error: work of the nodal forces less that of the stresses at particles; "
      "negative: lost"
  );
  energy.add_result(14, "energy", energy_balance);
  energy.add_ratio(
      "stress_integration_share",
      "stress_integration_share",
      0,
      [](const Ledger& l) { return numerical_energy(l).stress_integration; },
      "`stress_integration` relative to the energy put in"
  );
  energy.add_ratio(
      "transfer_share",
      "transfer_share",
      0,
      [](const Ledger& l) { return numerical_energy(l).transfer; },
      "`transfer` relative to the energy put in"
  );
  return energy.rows();
}

/// Beside `kinetic`, of which it is no part.
LedgerRow remembered_row() {
  return {
      "remembered",
      "kinetic energy of the grid's motion that APIC's particles carry besides `kinetic`",
      &Ledger::remembered,
      Conserved::energy,
      P::outside,
      27,
      "",
      ""};
}

}  // namespace

std::vector<LedgerRow> balance_rows() {
  LedgerRows all{remembered_row()};
  for (const LedgerRows& some : {mass_rows(), momentum_rows(), energy_rows_of_table()})
    all.insert(all.end(), some.begin(), some.end());
  return all;
}

}  // namespace barreno

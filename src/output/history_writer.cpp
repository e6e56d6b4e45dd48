// SPDX-License-Identifier: BSD-3-Clause
#include "output/history_writer.hpp"

#include "base/region.hpp"
#include "output/history_columns.hpp"
#include "output/pore_flow_columns.hpp"
#include "output/reactions.hpp"
#include "state/balance.hpp"

namespace barreno {

RunTotals sum_totals(const State& state) {
  const Comm& comm = *state.grid.comm;
  RunTotals totals;
  totals.ledger = sum_over_ranks(comm, state.ledger);
  std::vector<double> counts{0.0, state.particle_steps, state.skipped_steps};
  for (const Particles& particles : state.particles) counts[0] += particles.count;
  sum_over_ranks(comm, counts);
  totals.particles = counts[0];
  totals.particle_steps = counts[1];
  totals.skipped_steps = counts[2];
  std::vector<double> shares = values_of(state.step_shares);
  sum_over_ranks(comm, shares);
  totals.step_shares = shares_of(shares);
  totals.step_limits = state.step_limits;
  totals.time = state.clock.time;
  totals.reactions = reaction_impulses(state);
  totals.pore_flow = pore_flow_values(state, totals.ledger);
  return totals;
}

namespace {

/// What the comment of the file says of rigid bodies.
std::string note_on_reactions(const Scene& scene) {
  std::string note =
      "; of a rigid body force N (mean over the time since the row before) and impulse kg m/s "
      "(since the start) that the other bodies gave it";
  if (scene.grid.mode == Mode::axisymmetric) return note + ", along the axis, of the full circle";
  if (scene.grid.mode == Mode::three_dimensional) return note + ", of the part inside the grid";
  return note;
}

}  // namespace

HistoryWriter::HistoryWriter(
    const Scene& scene,
    const Comm& comm,
    const std::filesystem::path& path,
    std::uintmax_t kept,
    const PreviousRow& before
)
    : before_(before) {
  std::string header;
  for (const HistoryColumn& column : history_columns())
    header += (header.empty() ? "" : ",") + column.name;
  for (const std::string& column : pore_flow_columns(scene)) header += "," + column;
  const std::vector<std::string> columns = reaction_columns(scene);
  for (const std::string& column : columns) header += "," + column;
  RootWork work(comm);
  work.run([&] {
    file_ = std::make_unique<LineFile>(path, kept);
    if (kept > 0) return;  // it has its header
    file_->append(
        "# SI units: time, dt s; mass kg; momentum, rigid_impulse (of rigid bodies on the "
        "material) along y kg m/s; energies and work J; plane "
        "strain: per "
        "m of thickness; errors relative; removed, held, clipped (at Largest Domain, now): "
        "particles; retried: steps; remembered: kinetic energy that APIC's particles hold beside "
        "kinetic; explosive: energy that explosives gave, their viscous heat taken off" +
        (scene.pore_flow.on() ? std::string(pore_flow_note) : std::string()) +
        (columns.empty() ? std::string() : note_on_reactions(scene))
    );
    file_->append(header);
  });
  work.agree();
}

void HistoryWriter::write(const Comm& comm, const Clock& clock, const RunTotals& totals) {
  const Region region("write_history");
  std::vector<double> row;
  for (const HistoryColumn& column : history_columns())
    row.push_back(column.value({clock, totals}));
  row.insert(row.end(), totals.pore_flow.begin(), totals.pore_flow.end());
  const bool first = before_.reactions.empty();
  const std::vector<double>& before = first ? totals.reactions : before_.reactions;
  const double elapsed = first ? 0.0 : clock.time - before_.time;
  const std::vector<double> reactions = reaction_values(totals.reactions, before, elapsed);
  row.insert(row.end(), reactions.begin(), reactions.end());
  before_ = {clock.time, totals.reactions};
  RootWork work(comm);
  work.run([&] { file_->append(csv_line(row)); });
  work.agree();
}

}  // namespace barreno

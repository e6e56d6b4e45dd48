// SPDX-License-Identifier: BSD-3-Clause
#include "output/summary.hpp"

#include "base/process.hpp"
#include "base/region.hpp"
#include "output/json.hpp"
#include "state/balance.hpp"

#include <limits>
#include <sstream>

namespace barreno {
namespace {

/// Phases by the root's labels: every rank runs the same verbs.
std::vector<PhaseSummary> collect_phases(const Comm& comm) {
  std::string labels;
  for (const PhaseTime& phase : phase_times()) labels += std::string(phase.label) + "\n";
  std::istringstream stream(broadcast_from_root(comm, labels));
  std::vector<PhaseSummary> phases;
  std::vector<double> sums;
  for (std::string label; std::getline(stream, label);) {
    PhaseSummary summary{label, 0.0, 0.0, 0};
    for (const PhaseTime& phase : phase_times()) {
      if (label != phase.label) continue;
      sums.push_back(phase.seconds);
      summary.calls = phase.calls;
    }
    phases.push_back(summary);
    sums.resize(phases.size(), 0.0);
  }
  std::vector<double> largest = sums;
  sum_over_ranks(comm, sums);
  max_over_ranks(comm, largest);
  for (std::size_t i = 0; i < phases.size(); ++i) {
    phases[i].mean_seconds = sums[i] / comm.getSize();
    phases[i].largest_seconds = largest[i];
  }
  return phases;
}

void put_cost(JsonWriter& json, const RunSummary& summary, const RunTotals& totals) {
  json.number("particle_steps", totals.particle_steps);
  json.number("skipped_particle_steps", totals.skipped_steps);
  json.number("wall_seconds", summary.wall_seconds);
  const double steps = totals.particle_steps;
  json.number("ns_per_particle_step", steps > 0.0 ? 1e9 * summary.wall_seconds / steps : 0.0);
  json.number("bytes_per_particle", summary.bytes_per_particle);
  json.number("peak_resident_bytes", summary.peak_resident_bytes);
  json.number("largest_rank_peak_bytes", summary.largest_rank_peak_bytes);
  json.begin_object("phases");
  for (const PhaseSummary& phase : summary.phases) {
    json.begin_object(phase.label);
    json.number("seconds", phase.mean_seconds);
    json.number("largest_rank_seconds", phase.largest_seconds);
    json.integer("calls", phase.calls);
    json.number("ns_per_particle_step", steps > 0.0 ? 1e9 * phase.mean_seconds / steps : 0.0);
    json.end_object();
  }
  json.end_object();
}

/// What was expected before the run, beside what came.
void put_prediction(JsonWriter& json, const RunDescription& run, const RunSummary& summary) {
  json.number("cpu_seconds", summary.cpu_seconds);
  if (!(run.prediction.seconds > 0.0)) return;  // a resumed run has none
  json.begin_object("prediction");
  json.number("steps", run.prediction.steps);
  json.number("particle_steps", run.prediction.particle_steps);
  json.number("ns_per_particle_step", run.prediction.nanoseconds);
  json.number("wall_seconds", run.prediction.seconds);
  json.number("bytes", run.prediction.bytes);
  json.end_object();
}

void put_penetration(JsonWriter& json, const Penetration& p) {
  json.begin_object("penetration");
  json.flag("met_target", p.met);
  json.number("depth", p.met ? p.depth : std::numeric_limits<double>::quiet_NaN());  // null
  json.number("channel_depth", p.channel_depth);
  json.number("channel_radius_mid", p.channel_radius_mid);
  json.number("jet_mass_inside", p.jet_mass_inside);
  json.number("tip_velocity", p.tip_velocity);
  json.end_object();
}

void put_balance(JsonWriter& json, const Balance& balance) {
  json.number("remainder", balance.remainder);
  json.number("put_in", balance.put_in);
  json.number("error", balance.error());
}

void put_balances(JsonWriter& json, const Ledger& l) {
  json.begin_object("balances");
  json.begin_object("mass");
  json.number("now", l.mass);
  json.number("initial", l.initial_mass);
  json.number("launched", l.launched_mass);
  json.number("removed", total_removed(l).mass);
  put_balance(json, mass_balance(l));
  json.end_object();
  json.begin_object("momentum");
  json.number("now", l.momentum);
  json.number("initial", l.initial_momentum);
  json.number("launched", l.launched_momentum);
  json.number("condition_impulse", l.condition_impulse);
  json.number("load_impulse", l.load_impulse);
  json.number("body_impulse", l.body_impulse);
  json.number("damping_impulse", l.damping_impulse);
  json.number("rigid_impulse", l.rigid_impulse);
  json.number("removed", total_removed(l).momentum);
  put_balance(json, momentum_balance(l));
  json.end_object();
  json.begin_object("energy");
  json.number("kinetic", l.kinetic);
  json.number("elastic", l.elastic);
  json.number("plastic", l.plastic);
  json.number("viscous", l.viscous);
  json.number("friction", l.friction);
  json.number("stress_integration", l.stress_integration);
  json.number("transfer", l.transfer);
  json.number("removed_kinetic", total_removed(l).kinetic);
  json.number("initial_kinetic", l.initial_kinetic);
  json.number("launched_kinetic", l.launched_kinetic);
  json.number("boundary_work", l.boundary_work);
  json.number("body_work", l.body_work);
  json.number("fluid_work", l.fluid_work);
  json.number("damped", l.damped);
  json.number("prestress", l.prestress);
  put_balance(json, energy_balance(l));
  json.number("stress_integration_share", numerical_energy(l).stress_integration);
  json.number("transfer_share", numerical_energy(l).transfer);
  json.end_object();
  json.end_object();
}

void put_jet(JsonWriter& json, const Scene& scene, const State& state, const Ledger& l) {
  const JetTotals table = jet_table_totals(scene, state.next_slug);
  const auto compare = [&](const char* name, double launched, double expected) {
    json.begin_object(name);
    json.number("launched", launched);
    json.number("table", expected);
    json.number("difference", expected != 0.0 ? launched / expected - 1.0 : launched);
    json.end_object();
  };
  json.begin_object("jet");
  json.text("table_file", scene.jet.table_file);
  json.number("direction", scene.jet.direction);
  json.integer("slugs", static_cast<long long>(scene.jet.slugs.size()));
  json.integer("slugs_launched", static_cast<long long>(state.next_slug));
  compare("mass", l.launched_mass, table.mass);
  compare("momentum", l.launched_momentum, table.momentum);
  compare("kinetic", l.launched_kinetic, table.kinetic);
  json.end_object();
}

void put_removed(JsonWriter& json, const Ledger& l) {
  json.begin_object("removed_particles");
  for (int cause = 0; cause < removal_causes; ++cause) {
    const RemovalTally& tally = l.removed[static_cast<std::size_t>(cause)];
    json.begin_object(removal_names[static_cast<std::size_t>(cause)]);
    json.number("count", tally.count);
    json.number("mass", tally.mass);
    json.number("momentum", tally.momentum);
    json.number("kinetic", tally.kinetic);
    json.end_object();
  }
  json.end_object();
}

}  // namespace

RunSummary summarise(const State& state, double wall_seconds, double cpu_seconds) {
  const Comm& comm = *state.grid.comm;
  RunSummary summary;
  summary.ranks = comm.getSize();
  summary.wall_seconds = wall_seconds;
  double particles = 0.0, bytes = 0.0;
  for (const Particles& set : state.particles) {
    particles += set.count;
    bytes += static_cast<double>(set.count) * static_cast<double>(bytes_per_particle(set));
  }
  const double peak = peak_resident_bytes();
  std::vector<double> sums{particles, bytes, peak, cpu_seconds}, largest{peak};
  sum_over_ranks(comm, sums);
  max_over_ranks(comm, largest);
  summary.bytes_per_particle = sums[0] > 0.0 ? sums[1] / sums[0] : 0.0;
  summary.peak_resident_bytes = sums[2];
  summary.cpu_seconds = sums[3];
  summary.largest_rank_peak_bytes = largest[0];
  summary.phases = collect_phases(comm);
  return summary;
}

std::string summary_text(
    const Scene& scene,
    const State& state,
    const RunDescription& run,
    const RunTotals& totals,
    const Penetration& penetration,
    const RunSummary& summary,
    const RunVerdict& verdict
) {
  JsonWriter json;
  json.text("deck", run.deck_name);
  json.text("title", scene.title);
  json.text("version", run.version);
  json.text("mode", mode_name(scene.grid.mode));
  json.flag("finished", verdict.finished);
  json.text("reason", verdict.reason);
  json.integer("exit_code", verdict.exit_code);
  json.integer("ranks", summary.ranks);
  // Of mass, momentum and kinetic energy below.
  if (scene.quasi_static.on()) json.number("inertia_factor", scene.quasi_static.inertia_factor);
  json.number("time", state.clock.time);
  json.number("end_time", scene.end_time);
  json.number("particles", totals.particles);
  json.integer("steps", state.clock.step);
  put_cost(json, summary, totals);
  put_prediction(json, run, summary);
  if (scene.jet.present) put_penetration(json, penetration);
  put_balances(json, totals.ledger);
  if (scene.jet.present) put_jet(json, scene, state, totals.ledger);
  put_removed(json, totals.ledger);
  json.number("held_particles", totals.ledger.held);
  json.number("unloaded_particles", totals.ledger.unloaded);
  json.number("clipped_particles", totals.ledger.clipped);
  json.number("retried_steps", totals.ledger.retried_steps);
  json.begin_object("warnings");
  for (const auto& [kind, count] : summary.warnings) json.integer(kind, count);
  json.end_object();
  return json.finish();
}

}  // namespace barreno

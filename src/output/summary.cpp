// SPDX-License-Identifier: BSD-3-Clause
#include "output/summary.hpp"

#include "base/process.hpp"
#include "base/region.hpp"
#include "base/utf8.hpp"
#include "base/work_counts.hpp"
#include "jet/channel.hpp"
#include "jet/divided_error.hpp"
#include "jet/estimate.hpp"
#include "jet/range_effects.hpp"
#include "output/share_numbers.hpp"
#include "scene/input_speeds.hpp"
#include "state/balance.hpp"
#include "state/ledger_table.hpp"

#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>
#include <numeric>
#include <sstream>

namespace barreno {
namespace {

/// Members stay in the order in which they are written.
using Json = nlohmann::ordered_json;

/// Counts are kept as doubles, and stand in the file as whole numbers. What JSON cannot say, nan
/// and infinity, becomes null.
Json number(double value) {
  constexpr double largest = 9007199254740992.0;  // 2^53: larger doubles do not hold every integer
  if (value == std::floor(value) && std::abs(value) < largest) return static_cast<long long>(value);
  return value;
}

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

std::vector<WorkSummary> collect_work(const Comm& comm) {
  const WorkCounts& mine = work_counts();
  std::vector<long long> sums{
      mine.candidate_points, mine.undivided_points, mine.particles_made, mine.checkpoint_bytes};
  std::vector<long long> largest = sums;
  sum_over_ranks(comm, sums);
  max_over_ranks(comm, largest);
  std::vector<WorkSummary> work;
  for (const char* label :
       {"candidate_points", "undivided_points", "particles_made", "checkpoint_bytes"}) {
    const std::size_t i = work.size();
    work.push_back({label, static_cast<double>(sums[i]), static_cast<double>(largest[i])});
  }
  return work;
}

void put_cost(Json& json, const RunSummary& summary, const RunTotals& totals) {
  json["particle_steps"] = number(totals.particle_steps);
  json["skipped_particle_steps"] = number(totals.skipped_steps);
  json["wall_seconds"] = number(summary.wall_seconds);
  const double steps = totals.particle_steps;
  json["ns_per_particle_step"] = number(steps > 0.0 ? 1e9 * summary.wall_seconds / steps : 0.0);
  json["bytes_per_particle"] = number(summary.bytes_per_particle);
  json["peak_resident_bytes"] = number(summary.peak_resident_bytes);
  json["largest_rank_peak_bytes"] = number(summary.largest_rank_peak_bytes);
  Json& phases = json["phases"] = Json::object();
  for (const PhaseSummary& phase : summary.phases) {
    Json& one = phases[phase.label];
    one["seconds"] = number(phase.mean_seconds);
    one["largest_rank_seconds"] = number(phase.largest_seconds);
    one["calls"] = phase.calls;
    one["ns_per_particle_step"] = number(steps > 0.0 ? 1e9 * phase.mean_seconds / steps : 0.0);
  }
  for (const WorkSummary& one : summary.work) {
    json["set_up"][one.label] = number(one.sum);
    json["set_up"][std::string("largest_rank_") + one.label] = number(one.largest);
  }
}

/// Where cells or steps are of several sizes.
void put_step_shares(Json& json, double cell_size, const StepShares& shares) {
  for (const auto& [name, share] : shares_by_cell_size(cell_size, shares))
    json["particle_steps_by_cell_size"][name] = number(share);
  for (const auto& [name, share] : shares_by_step_length(shares))
    json["particle_steps_by_step_length"][name] = number(share);
}

/// What set the length of the steps.
void put_step_limits(Json& json, const Scene& scene, const StepLimits& limits) {
  const std::vector<std::string> names = step_limit_names(scene);
  const double time = std::accumulate(limits.time.begin(), limits.time.end(), 0.0);
  for (std::size_t row = 0; row < limits.steps.size(); ++row) {
    if (limits.steps[row] == 0.0) continue;
    Json& one = json["step_set_by"][names[row]];
    one["share"] = number(time > 0.0 ? limits.time[row] / time : 0.0);
    one["steps"] = number(limits.steps[row]);
    one["shortest"] = number(limits.shortest[row]);
  }
}

/// What was expected before the run, beside what came.
void put_prediction(Json& json, const RunDescription& run, const RunSummary& summary) {
  json["cpu_seconds"] = number(summary.cpu_seconds);
  if (!(run.prediction.seconds > 0.0)) return;  // a resumed run has none, nor one of unknown cost
  Json& expected = json["prediction"];
  expected["steps"] = number(run.prediction.steps);
  expected["particle_steps"] = number(run.prediction.particle_steps);
  expected["ns_per_particle_step"] = number(run.prediction.nanoseconds);
  expected["wall_seconds"] = number(run.prediction.seconds);
  expected["bytes"] = number(run.prediction.bytes);
}

void put_cells(Json& json, const char* name, const SlugCells& cells) {
  Json& one = json[name];
  one["tip"] = number(cells.tip);
  one["tail"] = number(cells.tail);
  one["least"] = number(cells.least);
  one["most"] = number(cells.most);
}

/// How well the cells resolve the jet, and how deep it is in which body.
void put_resolution(Json& json, const Scene& scene, const Penetration& p) {
  put_cells(json, "cells_per_radius", slug_cells(scene, &JetSlug::radius));
  put_cells(json, "cells_per_length", slug_cells(scene, &JetSlug::length));
  if (!p.met) return;
  const JetPath path = jet_path(scene);
  for (const PathLayer& layer : solid_layers(path_layers(scene, widest_radius(scene)))) {
    const std::string name = as_utf8(scene.bodies[layer.body].name);
    json["depth_in_body"][name] = number(depth_in(layer, path, p.depth));
    json["channel_depth_in_body"][name] = number(depth_in(layer, path, p.channel_depth));
    json["entrance_diameter_in_body"][name] = number(entrance_diameter(layer, path, p));
  }
}

/// What the cells were measured to do to a depth, or why that is unknown and what to do.
void put_depth_error(Json& error, const DepthDoubt& doubt) {
  if (!doubt.unknown.empty()) {
    error["unknown"] = as_utf8(doubt.unknown);
    error["advice"] = unknown_error_advice;
    return;
  }
  error["value"] = number(doubt.error.value);
  error["low"] = number(doubt.error.low);
  error["high"] = number(doubt.error.high);
  error["cells_per_radius"] = number(doubt.cells_per_radius);
  error["source"] = depth_error_source;
}

void put_penetration(
    Json& json, const Scene& scene, const JetPath& path, double time, const Penetration& p
) {
  Json& reached = json["penetration"];
  reached["met_target"] = p.met;
  reached["depth"] = number(p.met ? p.depth : std::numeric_limits<double>::quiet_NaN());  // null
  reached["through"] = p.through;
  // null
  reached["through_since"] =
      number(p.through ? p.through_since : std::numeric_limits<double>::quiet_NaN());
  reached["channel_depth"] = number(p.channel_depth);
  reached["probed_depth"] = number(p.probed_depth);
  reached["probed_volume"] = number(p.probed_volume);
  reached["channel_radius_mid"] = number(p.channel_radius_mid);
  reached["channel_volume"] = number(channel_volume(scene.grid, path, p));
  reached["jet_mass_inside"] = number(p.jet_mass_inside);
  reached["tip_velocity"] = number(p.tip_velocity);
  if (scene.jet.present) put_resolution(reached, scene, p);
  if (!p.met) return;
  put_depth_error(reached["depth_error"], depth_doubt(scene, time, p));
  if (is_divided(scene)) {
    put_depth_error(reached["probed_depth_error"], probed_depth_doubt(scene, time, p));
    put_depth_error(reached["channel_volume_error"], volume_doubt(scene, time, p));
    put_depth_error(reached["core_flow_efficiency_error"], efficiency_doubt(scene, time, p));
  }
}

/// What is least certain of the rock, and what that does to the hole.
void put_least_certain(Json& json, const Scene& scene) {
  const LeastCertain least = least_certain(scene);
  if (least.worst.empty()) return;
  Json& all = json["penetration"]["least_certain"];
  all["sentence"] = least_certain_sentence(least);
  all["body"] = as_utf8(least.body);
  const auto put = [](Json& to, const RangeEffect::Change& change) {
    to["at_low"] = number(change.at_low);
    to["at_high"] = number(change.at_high);
  };
  for (const RangeEffect& effect : least.worst) {
    Json& one = all["range_of"][effect.parameter];
    one["range"] = effect.range;
    one["known"] = effect.known;
    one["until"] = effect.until;
    put(one["depth"], effect.depth);
    put(one["probed_depth"], effect.probed_depth);
    put(one["channel_volume"], effect.volume);
  }
}

/// What crushing and dilation have made of the rock around the hole.
void put_zones(Json& json, const Scene& scene, const std::vector<RockZones>& zones) {
  for (const RockZones& found : zones) {
    Json& one = json["penetration"]["zones_in_body"][as_utf8(scene.bodies[found.body].name)];
    one["depth"] = number(found.depth);
    one["radius"] = number(found.wall);
    one["crushed_from"] = number(found.crushed_from);
    one["crushed_to"] = number(found.crushed_to);
    one["dilated_to"] = number(found.dilated_to);
    one["impaired_to"] = number(found.impaired_to);
    one["least_porosity"] = number(found.least_porosity);
    one["least_permeability"] = number(found.least_permeability);
    one["greatest_breakage"] = number(found.greatest_breakage);
    one["skin"] = number(found.skin);  // null in plane strain
  }
}

/// Whether the hole is at rest, and why not.
void put_rest(Json& json, const Rest& rest) {
  Json& one = json["penetration"]["rest"];
  one["at_rest"] = rest.at_rest;
  one["sentence"] = rest_sentence(rest);
  one["window"] = number(rest.window);
  one["growth"] = number(rest.growth);
  one["rate"] = number(rest.rate());
  one["probed"] = rest.probed;
  one["thread_grew"] = has_growing_thread(rest);
  one["probed_growth"] = number(rest.probed_growth);
  one["volume_growth"] = number(rest.volume_growth);
  one["share_on_its_way"] = number(rest.share_on_its_way);
}

/// The rows of the ledger whose paths begin with `group`, or stand alone if that is empty.
void put_ledger(Json& json, const Ledger& ledger, const std::string& group) {
  for (const LedgerRow& row : ledger_table()) {
    const bool alone = row.summary.find('.') == std::string::npos;
    if (row.summary.empty() || (group.empty() ? !alone : row.summary.rfind(group, 0) != 0))
      continue;
    Json* place = &json;
    std::istringstream path(row.summary);
    for (std::string word; std::getline(path, word, '.');) place = &(*place)[word];
    *place = number(row.value(ledger));
  }
}

/// What of the energies of the balance belongs to which material.
void put_material_energies(Json& json, const Scene& scene, const Ledger& ledger) {
  Json& all = json["balances"]["energy"]["materials"] = Json::object();
  for (std::size_t m = 0; m < ledger.materials.size(); ++m) {
    const MaterialEnergies& energies = ledger.materials[m];
    Json& one = all[as_utf8(scene.materials[m].name())];
    one["prestress"] = number(energies.prestress);
    one["elastic"] = number(energies.elastic);
    one["plastic"] = number(energies.plastic);
    one["viscous"] = number(energies.viscous);
    one["explosive"] = number(energies.explosive);
  }
}

/// The largest numerical errors of the run; `since` is null and `warning` empty where they are
/// small.
void put_numerical_energy(Json& json, const RunSummary& summary) {
  Json& one = json["numerical_energy"];
  one["bound"] = number(largest_numerical_share);
  one["largest_stress_integration_share"] = number(summary.numerical.stress_integration);
  one["largest_transfer_share"] = number(summary.numerical.transfer);
  one["since"] = number(summary.numerical.since);
  one["warning"] = as_utf8(summary.numerical_warning);
}

void put_jet(Json& json, const Scene& scene, const State& state, const Ledger& l) {
  const JetTotals table = jet_table_totals(scene, state.jet.next_slug);
  Json& jet = json["jet"];
  const auto compare = [&](const char* name, double launched, double expected) {
    Json& one = jet[name];
    one["launched"] = number(launched);
    one["table"] = number(expected);
    one["difference"] = number(expected != 0.0 ? launched / expected - 1.0 : launched);
  };
  jet["kind"] = word_of(scene.jet.kind);
  jet["table_file"] = as_utf8(scene.jet.table_file);
  jet["direction"] = number(scene.jet.direction);
  jet["slugs"] = scene.jet.slugs.size();
  jet["slugs_launched"] = state.jet.next_slug;
  compare("mass", l.launched_mass, table.mass);
  compare("momentum", l.launched_momentum, table.momentum);
  compare("kinetic", l.launched_kinetic, table.kinetic);
}

void put_sums(Json& json, const JetSums& sums) {
  json["count"] = number(sums.count);
  json["mass"] = number(sums.mass);
  json["momentum"] = number(sums.momentum);
  json["kinetic"] = number(sums.kinetic);
}

/// What crossed the plane of a Jet Monitor beside what its table says.
void put_formed_jet(Json& json, const JetMonitorSpec& monitor, const JetAudit& audit) {
  Json& jet = json["formed_jet"];
  jet["position"] = number(monitor.position);
  jet["direction"] = number(monitor.direction);
  put_sums(jet["crossed"], audit.crossed);
  put_sums(jet["table"], audit.table);
  put_sums(jet["slow"], audit.slow);
  put_sums(jet["wide"], audit.wide);
  jet["lateral_kinetic"] = number(audit.lateral);
  jet["slice_loss"] = number(audit.slice_loss);
  jet["largest_void"] = number(audit.largest_void);
  jet["largest_particle"] = number(audit.largest_particle);
  jet["mass_beyond"] = number(audit.mass_beyond);
}

void put_removed(Json& json, const Ledger& l) {
  Json& removed = json["removed_particles"];
  for (int cause = 0; cause < removal_causes; ++cause) {
    const RemovalTally& tally = l.removed[static_cast<std::size_t>(cause)];
    Json& one = removed[removal_names[static_cast<std::size_t>(cause)]];
    one["count"] = number(tally.count);
    one["mass"] = number(tally.mass);
    one["momentum"] = number(tally.momentum);
    one["kinetic"] = number(tally.kinetic);
  }
}

/// Single particles whose motion is that of no continuum, by material, and the bounds.
void put_anomalies(Json& json, const Scene& scene, const std::vector<Anomalies>& anomalies) {
  Json& all = json["kinematic_anomalies"];
  const double input = largest_input_speed(scene);
  all["stretch_bound"] = number(anomalous_stretch);
  all["speed_bound"] =
      number(input > 0.0 ? anomalous_speed * input : std::numeric_limits<double>::quiet_NaN());
  Json& materials = all["materials"] = Json::object();
  for (std::size_t m = 0; m < anomalies.size(); ++m) {
    Json& one = materials[as_utf8(scene.materials[m].name())];
    one["stretched"] = number(anomalies[m].stretched);
    one["ejected"] = number(anomalies[m].ejected);
    one["clipped"] = number(anomalies[m].clipped);
    one["largest_stretch"] = number(anomalies[m].largest_stretch);
    one["largest_speed"] = number(anomalies[m].largest_speed);
  }
}

void put_counted(Json& json, const CountedMass& counted) {
  json["particles"] = number(counted.particles);
  json["mass"] = number(counted.mass);
}

/// What was taken over from another run, and what was left.
void put_continued(Json& json, const RunDescription& run) {
  if (!run.continued.on()) return;
  Json& continued = json["continued"];
  continued["run"] = as_utf8(run.continued_run.run);
  continued["time"] = number(run.continued.time);
  continued["velocities"] = word_of(run.continued_run.velocities);
  continued["bodies"] = Json::object();
  continued["left_out"] = Json::object();
  for (const ContinuedBody& body : run.continued.bodies) {
    const std::string name = as_utf8(body.name);
    if (body.in_deck) put_counted(continued["bodies"][name], body.taken);
    if (body.left.particles > 0.0) put_counted(continued["left_out"][name], body.left);
  }
}

/// What ended a run that has finished; null of others.
Json end_word(const Scene& scene, const RunVerdict& verdict) {
  if (!verdict.finished) return nullptr;
  if (!scene.at_rest) return "end time";
  return verdict.at_rest ? "rest" : "longest time";
}

}  // namespace

RunSummary summarise(
    const Scene& scene, const State& state, double wall_seconds, double cpu_seconds
) {
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
  summary.work = collect_work(comm);
  summary.anomalies = count_anomalies(scene, state);
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
  Json json;
  json["deck"] = as_utf8(run.deck_name);
  json["title"] = as_utf8(scene.title);
  json["version"] = as_utf8(run.version);
  for (const auto& [name, value] : run.build) json["build"][name] = as_utf8(value);
  put_continued(json, run);
  json["mode"] = word_of(scene.grid.mode);
  json["finished"] = verdict.finished;
  json["reason"] = as_utf8(verdict.reason);
  json["exit_code"] = verdict.exit_code;
  json["ranks"] = summary.ranks;
  // Of mass, momentum and kinetic energy below.
  if (scene.quasi_static.on()) json["inertia_factor"] = number(scene.quasi_static.inertia_factor);
  json["time"] = number(state.clock.time);
  json["end_time"] = number(scene.end_time);
  json["ended_at"] = end_word(scene, verdict);
  json["particles"] = number(totals.particles);
  json["steps"] = state.clock.step;
  put_cost(json, summary, totals);
  put_step_shares(json, scene.grid.cell_size, totals.step_shares);
  put_step_limits(json, scene, totals.step_limits);
  put_prediction(json, run, summary);
  if (const auto path = recorded_path(scene, run.monitor))
    put_penetration(json, scene, *path, state.clock.time, penetration);
  put_zones(json, scene, summary.zones);
  if (penetration.met) put_least_certain(json, scene);
  if (summary.rest) put_rest(json, *summary.rest);
  put_ledger(json, totals.ledger, "balances.");
  put_material_energies(json, scene, totals.ledger);
  put_numerical_energy(json, summary);
  if (scene.jet.present) put_jet(json, scene, state, totals.ledger);
  if (summary.formed_jet) put_formed_jet(json, run.monitor, *summary.formed_jet);
  put_removed(json, totals.ledger);
  put_ledger(json, totals.ledger, "");
  put_anomalies(json, scene, summary.anomalies);
  Json& warnings = json["warnings"] = Json::object();
  for (const auto& [kind, count] : summary.warnings) warnings[as_utf8(kind)] = count;
  return json.dump(2) + "\n";
}

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#include "output/output.hpp"

#include "base/error.hpp"
#include "base/gather.hpp"
#include "base/process.hpp"
#include "jet/depth.hpp"
#include "jet/estimate.hpp"
#include "jet/monitor.hpp"
#include "jet/rest.hpp"
#include "output/cavities.hpp"
#include "output/copy_surfaces.hpp"
#include "output/exodus_writer.hpp"
#include "output/history_writer.hpp"
#include "output/progress.hpp"
#include "output/radii.hpp"
#include "output/result_numbers.hpp"
#include "output/schedule.hpp"
#include "output/summary.hpp"
#include "output/watch_ledger.hpp"
#include "state/balance.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <unistd.h>

namespace barreno {
namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines = split_lines(text, text.size() + 1);
  lines.insert(lines.begin(), "effective deck:");
  return lines;
}

}  // namespace

struct Output::Parts {
  Parts(
      const Scene& scene,
      const State& state,
      const RunDescription& description,
      const RunNumbers& position
  );
  void open_files(const Scene& scene, const State& state, const RunNumbers& position);
  std::vector<double> start_of_radii_in(
      const Scene& scene, const State& state, const RunNumbers& position
  ) const;
  void write_fields(const Scene& scene, const State& state);
  void write_rows(const Scene& scene, const State& state);
  void write_depth(const Scene& scene, const State& state);
  bool rows_due(const Clock& clock) const;
  RunNumbers position() const;
  void show_progress(const State& state, bool finished = false);
  JetAudit write_jet_table(double mass_beyond) const;

  RunDescription run;
  Teuchos::RCP<const Comm> comm;
  double end_time;
  bool to_rest;
  std::unique_ptr<Progress> progress;  ///< root only
  std::unique_ptr<ExodusWriter> fields;
  std::unique_ptr<HistoryWriter> history;
  std::unique_ptr<DepthWriter> depth;        ///< scenes with a recorded_path() only
  std::optional<RestWatch> rest;             ///< launched jets with a target; its looks: root only
  bool at_rest = false;                      ///< on every rank
  std::unique_ptr<RadiiWriter> radii;        ///< scenes with hollow balls only
  std::unique_ptr<CavitiesWriter> cavities;  ///< scenes with a pore fluid only
  JetMonitor monitor;                        ///< decks with a Jet Monitor only
  Schedule field_schedule, history_schedule, progress_schedule;
  RunTotals totals;  ///< of the last row
  Ledger watched;    ///< tallies that were warned about
  long fields_step = -1, rows_step = -1;
  double fields_time = 0.0;
  RunNumbers whole;  ///< position() behind the last output that all files took; root only
  bool gave_up = false;
  double cpu_start = cpu_seconds();
};

/// Whether the output goes to a terminal. mpirun gives its ranks terminals of its own: there the
/// launcher, which knows, says so in BARRENO_TERMINAL.
bool has_reader() {
  if (std::getenv("OMPI_COMM_WORLD_SIZE") == nullptr) return isatty(STDOUT_FILENO) == 1;
  const char* const said = std::getenv("BARRENO_TERMINAL");
  return said != nullptr && std::string(said) == "1";
}

/// The records of particles.e: the deck, then what computed it.
std::vector<std::string> information_of(const RunDescription& run) {
  std::vector<std::string> lines = lines_of(run.deck_text);
  for (const auto& [name, value] : run.build)
    lines.push_back(std::string("<!-- ").append(name).append(": ").append(value).append(" -->"));
  return lines;
}

Output::Parts::Parts(
    const Scene& scene,
    const State& state,
    const RunDescription& description,
    const RunNumbers& position
)
    : run(description),
      comm(state.grid.comm),
      end_time(scene.end_time),
      to_rest(scene.at_rest),
      monitor(run.monitor, position),
      field_schedule(scene.output.field_interval),
      history_schedule(scene.output.history_interval),
      progress_schedule(0.01 * scene.end_time) {
  totals = sum_totals(state);
  RootWork work(*comm);
  work.run([&] {
    progress = std::make_unique<Progress>(
        run.folder / "run.log",
        RunEnds{scene.end_time, expected_end(scene), scene.at_rest},
        has_reader(),
        position
    );
    for (const std::string& line : scene_lines(scene, run, comm->getSize(), totals.particles))
      progress->say(line);
    copy_surfaces(run.surfaces, run.folder);
    write_whole_file(run.folder / "deck.xml", run.deck_text);
  });
  work.agree();
  open_files(scene, state, position);
  if (position.empty()) return;
  fields_step = std::lround(number_of(position, "fields_step"));
  fields_time = number_of(position, "fields_time");
  rows_step = std::lround(number_of(position, "rows_step"));
  if (field_schedule.on()) field_schedule.done(fields_time);
  if (history_schedule.on()) history_schedule.done(number_of(position, "row_time"));
  if (progress_schedule.on()) progress_schedule.done(number_of(position, "time"));
  whole = this->position();
}

/// Of a run that continues another one the radii are those of the undeformed bodies.
std::vector<double> Output::Parts::start_of_radii_in(
    const Scene& scene, const State& state, const RunNumbers& position
) const {
  if (run.continued.on()) return run.continued.radii_start;
  return position.empty() ? start_of_radii(scene, state) : position.at("radii_start");
}

void Output::Parts::open_files(const Scene& scene, const State& state, const RunNumbers& position) {
  const auto kept = [&](const char* name) {
    return static_cast<std::uintmax_t>(number_of(position, name));
  };
  fields = std::make_unique<ExodusWriter>(
      scene,
      run.ids,
      state,
      run.folder / "particles.e",
      run.version,
      information_of(run),
      KeptFields{static_cast<int>(kept("fields_kept")), static_cast<int>(kept("fields_files"))}
  );
  PreviousRow before;
  if (!position.empty()) before = {number_of(position, "row_time"), position.at("row_reactions")};
  history = std::make_unique<HistoryWriter>(
      scene, *comm, run.folder / "history.csv", kept("history_bytes"), before
  );
  if (const std::optional<JetPath> path = recorded_path(scene, run.monitor)) {
    depth = std::make_unique<DepthWriter>(
        *path,
        *comm,
        run.folder / "depth.csv",
        kept("depth_bytes"),
        position.empty() ? 0.0 : number_of(position, "through_since")
    );
    if (scene.jet.present && path->has_target) rest.emplace(rest_rule(scene), position);
    at_rest = rest && rest->last().at_rest;
  }
  if (!hollow_balls(scene).empty())
    radii = std::make_unique<RadiiWriter>(
        scene,
        *comm,
        start_of_radii_in(scene, state, position),
        run.folder / "radii.csv",
        kept("radii_bytes")
    );
  if (!pore_fluids(scene).empty())
    cavities = std::make_unique<CavitiesWriter>(
        scene, *comm, run.folder / "cavities.csv", kept("cavities_bytes")
    );
}

void Output::Parts::write_fields(const Scene& scene, const State& state) {
  fields->write(scene, state);
  fields_step = state.clock.step;
  fields_time = state.clock.time;
  if (field_schedule.on()) field_schedule.done(fields_time);
}

/// Of the first step, then at every interval, or at every step without one.
bool Output::Parts::rows_due(const Clock& clock) const {
  if (rows_step < 0) return true;
  return history_schedule.on() ? history_schedule.due(clock.time) : rows_step != clock.step;
}

/// A row of depth.csv, and a look at the hole, of which the root tells all ranks.
void Output::Parts::write_depth(const Scene& scene, const State& state) {
  if (!depth) return;
  depth->write(scene, state);
  if (!rest) return;
  std::array<double, 1> found{0.0};
  if (is_root(*comm)) {
    rest->look(state.clock.time, depth->last());
    found[0] = rest->last().at_rest ? 1.0 : 0.0;
  }
  max_over_ranks(*comm, found);
  at_rest = found[0] == 1.0;
}

void Output::Parts::write_rows(const Scene& scene, const State& state) {
  totals = sum_totals(state);
  history->write(*comm, state.clock, totals);
  write_depth(scene, state);
  if (radii) radii->write(scene, state);
  if (cavities) cavities->write(scene, state);
  rows_step = state.clock.step;
  if (history_schedule.on()) history_schedule.done(state.clock.time);
}

void Output::Parts::show_progress(const State& state, bool finished) {
  const Clock& clock = state.clock;
  progress->show(
      {clock.time,
       clock.dt,
       clock.step,
       totals.particles,
       totals.particle_steps,
       energy_balance(totals.ledger).error(),
       numerical_energy(totals.ledger).sum(),
       finished}
  );
}

/// On the root.
JetAudit Output::Parts::write_jet_table(double mass_beyond) const {
  const std::vector<JetSlug> slugs = jet_slugs(monitor.spec(), monitor.crossings());
  if (!gave_up)
    write_whole_file(run.folder / "jet_table.csv", jet_table_text(monitor.spec(), slugs));
  JetAudit audit = audit_jet(monitor.spec(), monitor.crossings(), slugs);
  audit.mass_beyond = mass_beyond;
  return audit;
}

Output::Output(
    const Scene& scene, const State& state, const RunDescription& run, const RunNumbers& position
)
    : parts_(std::make_unique<Parts>(scene, state, run, position)) {}
Output::~Output() = default;

void Output::write_if_due(const Scene& scene, const State& state) {
  Parts& o = *parts_;
  const Clock& clock = state.clock;
  o.monitor.watch(state);
  const bool fields_due = o.fields_step < 0 || o.field_schedule.due(clock.time);
  const bool rows_due = o.rows_due(clock);
  const bool progress_due = o.progress_schedule.due(clock.time);
  if (fields_due) o.write_fields(scene, state);
  if (rows_due)
    o.write_rows(scene, state);
  else if (progress_due)
    o.totals = sum_totals(state);
  if (progress_due) o.progress_schedule.done(clock.time);
  if (!fields_due && !rows_due && !progress_due) return;
  RootWork work(*o.comm);
  work.run([&] {
    watch_ledger(o.totals.ledger, clock.time, o.watched, *o.progress);
    o.show_progress(state);
  });
  work.agree();
  if (fields_due || rows_due) work.run([&] { o.whole = o.position(); });
}

double Output::next_time(double now) const {
  return parts_->field_schedule.next_until(now, parts_->end_time);
}

bool Output::at_rest() const {
  return parts_->to_rest && parts_->at_rest;
}

void Output::warn(const std::string& kind, const std::string& sentence) {
  RootWork work(*parts_->comm);
  work.run([&] { parts_->progress->warn(kind, sentence); });
  work.agree();
}

RunNumbers Output::Parts::position() const {
  const auto bytes = [](const auto& writer) {
    return writer ? static_cast<double>(writer->bytes()) : 0.0;
  };
  RunNumbers numbers{
      {"fields_step", {static_cast<double>(fields_step)}},
      {"fields_time", {fields_time}},
      {"rows_step", {static_cast<double>(rows_step)}},
      {"fields_kept", {static_cast<double>(fields->steps())}},
      {"fields_files", {static_cast<double>(fields->files())}},
      {"row_time", {history->last_row().time}},
      {"row_reactions", history->last_row().reactions},
      {"history_bytes", {bytes(history)}},
      {"depth_bytes", {bytes(depth)}},
      {"through_since", {depth ? depth->through_since() : 0.0}},
      {"radii_bytes", {bytes(radii)}},
      {"cavities_bytes", {bytes(cavities)}}};
  if (rest) numbers.merge(rest->numbers());
  return numbers;
}

RunNumbers Output::position() const {
  RunNumbers position = parts_->whole;
  position["seconds"] = {seconds()};
  // It has looked at every state so far.
  position.merge(parts_->monitor.numbers());
  return position;
}

void Output::give_up_files() {
  parts_->gave_up = true;
  if (parts_->progress) parts_->progress->give_up_log();
}

void Output::go_on_from(const Scene& scene, const State& state) {
  if (parts_->depth) parts_->depth->measure(scene, state);
  parts_->totals = sum_totals(state);
  parts_->watched = parts_->totals.ledger;
  if (parts_->progress) parts_->progress->count_from(parts_->totals.particle_steps);
  if (parts_->field_schedule.due(state.clock.time) || parts_->rows_due(state.clock))
    write_if_due(scene, state);
}

double Output::seconds() const {
  return parts_->progress ? parts_->progress->seconds() : 0.0;
}

namespace {

/// A disk that has taken no more may still take this; if not, that has been said.
void write_summary(const std::filesystem::path& folder, const std::string& text, bool gave_up) {
  try {
    write_whole_file(folder / "summary.json", text);
  } catch (const FileError&) {
    if (!gave_up) throw;
  }
}

/// Whether numerical errors were too large at any row of the run.
void judge_energy(
    const Scene& scene,
    const std::filesystem::path& history,
    const RunTotals& totals,
    const Extremes& extremes,
    RunSummary& summary
) {
  summary.numerical = largest_shares(energy_rows(history, totals.ledger, totals.time));
  summary.numerical_warning = numerical_energy_sentence(scene, summary.numerical, extremes);
  if (!summary.numerical_warning.empty()) summary.warnings[numerical_energy_kind] = 1;
}

}  // namespace

void Output::finish(const Scene& scene, const State& state, const RunVerdict& verdict) {
  Parts& o = *parts_;
  if (o.fields_step != state.clock.step && !o.gave_up) o.fields->write(scene, state);
  if (o.rows_step != state.clock.step && !o.gave_up) o.write_rows(scene, state);
  if (!o.gave_up) o.fields->close(*o.comm);
  const double mass_beyond = o.monitor.on() ? o.monitor.mass_beyond(state) : 0.0;
  RunSummary summary = summarise(scene, state, seconds(), cpu_seconds() - o.cpu_start);
  if (o.rest) summary.rest = o.rest->last();
  const Penetration penetration = o.depth ? o.depth->last() : Penetration{};
  if (o.depth) summary.zones = o.depth->zones(scene, state);
  const Extremes extremes = find_extremes(scene, state);
  RootWork work(*o.comm);
  work.run([&] {
    watch_ledger(o.totals.ledger, state.clock.time, o.watched, *o.progress);
    o.show_progress(state, verdict.finished);
    o.progress->list_warnings();
    summary.warnings = o.progress->warnings();
    judge_energy(scene, o.run.folder / "history.csv", o.totals, extremes, summary);
    if (o.monitor.on()) summary.formed_jet = o.write_jet_table(mass_beyond);
    write_summary(
        o.run.folder,
        summary_text(scene, state, o.run, o.totals, penetration, summary, verdict),
        o.gave_up
    );
    const auto numbers = result_numbers(scene, o.totals, penetration, summary, o.run.prediction);
    o.progress->say_result(result_lines(scene, state, o.run, verdict, numbers));
    if (!summary.numerical_warning.empty())
      o.progress->warn(numerical_energy_kind, summary.numerical_warning);
    // Whoever sends the screen to a file still sees why.
    if (!verdict.finished) std::cerr << "barreno: " << verdict.reason << std::endl;
  });
  work.agree();
}

}  // namespace barreno

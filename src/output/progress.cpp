// SPDX-License-Identifier: BSD-3-Clause
#include "output/progress.hpp"

#include "jet/depth.hpp"
#include "jet/estimate.hpp"
#include "output/radii.hpp"
#include "scene/tile_levels.hpp"

#include <algorithm>
#include <barreno/input/scan_xml.hpp>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <iostream>

namespace barreno {
namespace {

using Clock_ = std::chrono::steady_clock;
constexpr double redraw_seconds = 0.1;
constexpr double line_seconds = 60.0;  ///< between two lines where no line can be redrawn

/// printf into a string; for the few places where columns must line up.
template <class... Values>
std::string format(const char* pattern, Values... values) {
  char text[256];
  std::snprintf(text, sizeof text, pattern, values...);
  return text;
}

std::string si(double value, const char* unit) {
  return format("%.4g %s", value, unit);
}

/// 0 if there is no such file.
std::uintmax_t size_of_file(const std::filesystem::path& path) {
  std::error_code error;
  const std::uintmax_t size = std::filesystem::file_size(path, error);
  return error ? 0 : size;
}

/// Of so many parts of a run the ones that are done: all of them at its end and not before, however
/// near it comes, so that a line says the end.
int whole_parts(double done, int parts) {
  constexpr double round_off = 1e-9;  // a step that ends on a tenth belongs to it
  if (done >= 1.0) return parts;
  return std::min(parts - 1, static_cast<int>(std::floor(parts * done + round_off)));
}

double seconds_between(Clock_::time_point a, Clock_::time_point b) {
  return std::chrono::duration<double>(b - a).count();
}

}  // namespace

std::string duration_text(double seconds) {
  if (!(seconds >= 0.0) || seconds > 1e9) return "?";
  const auto s = static_cast<long>(std::lround(seconds));
  if (s < 60) return std::to_string(s) + " s";
  if (s < 3600) return std::to_string(s / 60) + " min " + std::to_string(s % 60) + " s";
  return std::to_string(s / 3600) + " h " + std::to_string(s % 3600 / 60) + " min";
}

std::string cost_text(double seconds) {
  return seconds < 10.0 ? format("%.2g s", seconds) : duration_text(seconds);
}

Progress::Progress(
    const std::filesystem::path& log, const RunEnds& ends, bool terminal, const RunNumbers& position
)
    : log_(std::in_place, log, position.empty() ? 0 : size_of_file(log), false),
      ends_(ends),
      first_time_(number_of(position, "time")),
      first_seconds_(number_of(position, "seconds")),
      terminal_(terminal),
      start_(Clock_::now()) {}

double Progress::seconds() const {
  return first_seconds_ + seconds_between(start_, Clock_::now());
}

void Progress::append(const std::string& line) {
  if (log_) log_->append(line);
}

void Progress::say_on(std::ostream& screen, const std::string& line) {
  if (drawing_) std::cout << std::endl;
  drawing_ = false;
  screen << line << std::endl;
  append(line);
}

void Progress::say(const std::string& line) {
  say_on(std::cout, line);
}

void Progress::say_result(const std::vector<std::string>& lines) {
  for (const std::string& line : lines) append(line);
  if (drawing_) std::cout << std::endl;
  drawing_ = false;
  for (const std::string& line : lines) std::cout << line << std::endl;
}

/// Of the run; of one to rest, of the time until its predicted end, and less than all of it until
/// it is known to be over.
double Progress::share_done(const ProgressNow& now) const {
  if (!(ends_.expected > 0.0) || (ends_.at_rest && now.finished)) return 1.0;
  const double done = now.time / ends_.expected;
  return ends_.at_rest ? std::min(done, 0.99) : done;
}

std::string Progress::left_text(const ProgressNow& now) const {
  if (now.step == 0) return "?";
  const double elapsed = seconds() - first_seconds_;
  const auto until = [&](double end) {
    const double done = end > 0.0 ? std::min(1.0, now.time / end) : 1.0;
    const double begun = end > 0.0 ? std::min(1.0, first_time_ / end) : 0.0;
    return duration_text(done > begun ? elapsed * (1.0 - done) / (done - begun) : -1.0);
  };
  if (!ends_.at_rest) return until(ends_.latest);
  if (now.finished) return duration_text(0.0);
  std::string most = "at most " + until(ends_.latest);
  if (now.time >= ends_.expected) return most;
  return until(ends_.expected) + format(" if at rest at %.3g s, ", ends_.expected) + most;
}

std::string Progress::line(const ProgressNow& now) const {
  const double done = std::min(1.0, share_done(now));
  const double elapsed = seconds() - first_seconds_;
  const double rate = elapsed > 0.0 ? (now.particle_steps - first_steps_) / elapsed : 0.0;
  return format(
      "%3d %%  t %.4g s  step %ld  dt %.3g s  %s  %.3g particle-steps/s  left %s  numerical energy "
      "%+.2g %%  energy error %+.1e",
      whole_parts(done, 100),
      now.time,
      now.step,
      now.dt,
      counted(now.particles, "particles").c_str(),
      rate,
      left_text(now).c_str(),
      100.0 * now.numerical_energy,
      now.energy_error
  );
}

void Progress::show(const ProgressNow& now) {
  const int tenth = whole_parts(share_done(now), 10);
  const bool passed = tenth > tenths_;
  tenths_ = std::max(tenths_, tenth);
  const std::string text = line(now);
  if (passed) append(text);
  const auto clock = Clock_::now();
  if (!terminal_) {
    if (!passed && seconds_between(drawn_, clock) < line_seconds) return;
    drawn_ = clock;
    std::cout << text << std::endl;
    return;
  }
  if (!passed && seconds_between(drawn_, clock) < redraw_seconds) return;
  drawn_ = clock;
  drawing_ = true;
  std::cout << "\r\033[K" << text << std::flush;
}

void Progress::warn(const std::string& kind, const std::string& sentence, long count) {
  const bool first = warnings_.find(kind) == warnings_.end();
  warnings_[kind] += count;
  if (first) say_on(std::cerr, "warning: " + sentence);
}

void Progress::list_warnings() {
  for (const auto& [kind, count] : warnings_)
    if (count > 1)
      say_on(std::cerr, "warning: " + kind + ": " + std::to_string(count) + " times in total");
}

namespace {

std::string transfer_text(const StepSpec& step) {
  if (step.transfer == Transfer::xpic) return "XPIC(" + std::to_string(step.xpic_order) + ")";
  if (step.transfer == Transfer::apic) return "APIC";
  if (step.pic_fraction == 0.0) return "FLIP";
  return format("FLIP with a PIC Fraction of %.3g", step.pic_fraction);
}

std::string grid_text(const GridSpec& grid) {
  std::string text = word_of(grid.mode);
  if (grid.mode == Mode::axisymmetric) text += " (x = r, y = axial)";
  if (grid.mode == Mode::plane_strain) text += " (per m of thickness)";
  const auto last = static_cast<std::size_t>(dimensions(grid.mode)) - 1;
  text += ", ";
  for (std::size_t d = 0; d <= last; ++d)
    text += si(1e3 * (grid.upper[d] - grid.lower[d]), d < last ? "mm x " : "mm, cells of ");
  text += si(1e3 * grid.cell_size, "mm");
  if (finest_level(grid) > 0) text += ", refined to " + si(1e3 * smallest_cell(grid), "mm");
  return text;
}

/// @param filled  by the deck itself, not with the particles of another run
std::string body_text(const Scene& scene, const BodySpec& body, bool filled) {
  const MaterialSpec& material = scene.materials[static_cast<std::size_t>(body.material)];
  std::string text = body.name + ": " + material.name() + " (" + material.model_name() + ")";
  if (!filled) return text;
  text += ", " + counted(body.particles_per_cell, "particles per cell and direction");
  if (body.initial_pressure != 0.0)
    text += ", starts under " + si(1e-6 * body.initial_pressure, "MPa");
  if (body.pore_pressure && (*body.pore_pressure > 0.0 || material.is_porous()))
    text += ", fluid under " + si(1e-6 * *body.pore_pressure, "MPa");
  return text;
}

std::string jet_text(const Scene& scene) {
  const auto& slugs = scene.jet.slugs;
  const MaterialSpec& material = scene.materials[static_cast<std::size_t>(scene.jet.material)];
  std::string text = std::to_string(slugs.size()) + " slugs of " + material.name();
  if (!scene.jet.table_file.empty()) text += " from " + scene.jet.table_file;
  if (slugs.empty()) return text;
  return text + ", " + format("%.4g to %.4g m/s", slugs.front().velocity, slugs.back().velocity);
}

std::string modelled_text(const Scene& scene) {
  return "explicit dynamics, " + scene.step.shape + ", " + transfer_text(scene.step) + ", " +
         word_of(scene.step.order) + ", artificial viscosity, " +
         (scene.pore_flow.on() ? "pore fluid flow, " : "") +
         counted(static_cast<double>(scene.conditions.size()), "conditions") + ", " +
         counted(static_cast<double>(scene.loads.size()), "loads");
}

std::string left_out_text(const Scene& scene) {
  return std::string(scene.pore_flow.on() ? "" : "pore fluid flow, ") + "heat conduction" +
         (scene.contacts.empty() ? ", friction between bodies (one velocity field)" : "") +
         (scene.jet.present ? "" : ", jet");
}

std::string slow_text(const Scene& scene) {
  return format(
      "inertia x %.4g, which mass, momentum and kinetic energy show: a wave crosses in %.3g of the "
      "time of diffusion; damping %.4g 1/s",
      scene.quasi_static.inertia_factor,
      scene.quasi_static.transit_time / scene.quasi_static.slow_time,
      scene.step.damping
  );
}

std::string at_most_text(const Scene& scene) {
  return scene.at_rest ? format(", at most t = %.4g s", scene.end_time) : std::string();
}

std::string counted_text(const std::string& name, const CountedMass& counted) {
  return name + ": " + barreno::counted(counted.particles, "particles") +
         format(", %.6g kg", counted.mass);
}

/// What was taken over from another run.
std::vector<std::string> continued_lines(const RunDescription& run) {
  const Continued& continued = run.continued;
  if (!continued.on()) return {};
  std::vector<std::string> lines{
      "  continues  " + input::on_one_line(run.continued_run.run) +
      format(" at t = %.6g s, which is 0 here, velocities ", continued.time) +
      word_of(run.continued_run.velocities)};
  for (const ContinuedBody& body : continued.bodies)
    if (body.in_deck)
      lines.push_back("  taken      " + input::on_one_line(counted_text(body.name, body.taken)));
  for (const ContinuedBody& body : continued.bodies)
    if (body.left.particles > 0.0)
      lines.push_back(
          "  left       " + input::on_one_line(counted_text(body.name, body.left)) +
          (body.in_deck ? " (outside of the grid, or lost)" : " (not in the deck)")
      );
  return lines;
}

/// How a run to rest has ended.
std::string end_text(const Scene& scene, const RunVerdict& verdict) {
  if (!scene.at_rest) return "";
  return verdict.at_rest ? ", at rest" : ", at its Longest Time";
}

}  // namespace

std::vector<std::string> scene_lines(
    const Scene& scene, const RunDescription& run, int ranks, double particles
) {
  std::vector<std::string> lines;
  // Names are the user's: a line of the screen stays one, without escape sequences.
  lines.push_back(
      input::on_one_line("Barreno " + run.version + ": " + run.deck_name + ", " + scene.title)
  );
  lines.push_back("  grid       " + grid_text(scene.grid));
  for (const BodySpec& body : scene.bodies)
    lines.push_back("  body       " + body_text(scene, body, !run.continued.on()));
  if (scene.jet.present) lines.push_back("  jet        " + jet_text(scene));
  lines.push_back("  modelled   " + modelled_text(scene));
  lines.push_back("  left out   " + left_out_text(scene));
  if (scene.quasi_static.on()) lines.push_back("  slow       " + slow_text(scene));
  for (const std::string& line : continued_lines(run)) lines.push_back(line);
  for (const std::string& note : run.notes) lines.push_back("  note       " + note);
  const char* const plural = ranks == 1 ? "" : "s";
  lines.push_back(
      "  run        " + format(
                            "%s now, to %st = %.4g s%s, %d rank%s",
                            counted(particles, "particles").c_str(),
                            scene.at_rest ? "rest, predicted at " : "",
                            expected_end(scene),
                            at_most_text(scene).c_str(),
                            ranks,
                            plural
                        )
  );
  lines.push_back("  files      " + run.folder.string());
  return lines;
}

namespace {

/// The command as the user has it: of an installation, which says so, or of the source tree.
std::string command_name() {
  const char* const name = std::getenv("BARRENO_NAME");
  return name != nullptr && std::string(name) == "barreno" ? "barreno" : "./barreno";
}

}  // namespace

std::string next_command(const RunDescription& run, const RunVerdict& verdict) {
  const std::string folder = shell_word(run.folder.string());
  std::string command = command_name();
  if (!verdict.may_be_resumed) return command.append(" report ").append(folder);
  for (const char* name : {"checkpoint.h5", "checkpoint_previous.h5"})
    if (std::filesystem::exists(run.folder / name))
      return command.append(" resume ").append(folder);
  command.append(" run ").append(shell_word(run.deck_name));
  return command.append(" --out ").append(folder).append(" --overwrite");
}

std::vector<std::string> result_lines(
    const Scene& scene,
    const State& state,
    const RunDescription& run,
    const RunVerdict& verdict,
    const std::vector<std::string>& numbers
) {
  std::vector<std::string> lines;
  lines.push_back(
      verdict.finished
          ? format("Finished: t = %.4g s after %ld steps", state.clock.time, state.clock.step) +
                end_text(scene, verdict) + "."
          : format(
                "Stopped at t = %.4g s of %.4g s, step %ld: ",
                state.clock.time,
                scene.end_time,
                state.clock.step
            ) + verdict.reason
  );
  for (const std::string& number : numbers) lines.push_back("  " + number);
  const std::string folder = run.folder.string();
  lines.push_back(
      "Files in " + folder + ": summary.json, history.csv" +
      (recorded_path(scene, run.monitor) ? ", depth.csv" : "") +
      (hollow_balls(scene).empty() ? "" : ", radii.csv") +
      (std::filesystem::exists(run.folder / "particles.e") ? ", particles.e" : ", particles.e*") +
      " (ParaView), deck.xml, run.log"
  );
  lines.push_back("Next: " + next_command(run, verdict));
  return lines;
}

}  // namespace barreno

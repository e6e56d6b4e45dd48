// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "files/text_file.hpp"
#include "output/output.hpp"

#include <chrono>
#include <map>
#include <optional>

namespace barreno {

/// What the progress line says.
struct ProgressNow {
  double time = 0.0, dt = 0.0;
  long step = 0;
  double particles = 0.0, particle_steps = 0.0;
  double energy_error = 0.0;
  double numerical_energy = 0.0;  ///< that the method itself added, relative to what was put in
  bool finished = false;
};

/// When a run will end.
struct RunEnds {
  double latest = 0.0;    ///< in any case [time]
  double expected = 0.0;  ///< of a run to rest the predicted one; else the same [time]
  bool at_rest = false;   ///< a run to rest
};

/// The screen and the same text in run.log. Root only.
///
/// Warnings go to the standard error and to the log.
/// On a terminal the progress line is redrawn in place; elsewhere, and in run.log, there is a line
/// at every tenth of the run.
class Progress {
public:
  /// @param position  of a run that is resumed: the log is continued, and the clock goes on
  Progress(
      const std::filesystem::path& log,
      const RunEnds& ends,
      bool terminal,
      const RunNumbers& position = {}
  );

  /// Particle-steps that a resumed run had behind it, for the rate.
  void count_from(double particle_steps) { first_steps_ = particle_steps; }
  /// The disk takes no more of run.log: from now on the screen alone.
  void give_up_log() { log_.reset(); }
  /// A line on the screen and in the log.
  void say(const std::string& line);
  /// Lines that end a run, in the log first: what it cannot take is no result on the screen.
  void say_result(const std::vector<std::string>& lines);
  void show(const ProgressNow& now);
  /// The first of a kind is shown, all are counted.
  void warn(const std::string& kind, const std::string& sentence, long count = 1);
  /// Counts of the warnings that came more than once.
  void list_warnings();
  const std::map<std::string, long>& warnings() const { return warnings_; }
  double seconds() const;  ///< since the construction, and those of a run before its resume

private:
  std::string line(const ProgressNow& now) const;
  double share_done(const ProgressNow& now) const;
  std::string left_text(const ProgressNow& now) const;
  void append(const std::string& line);
  void say_on(std::ostream& screen, const std::string& line);

  using Time = std::chrono::steady_clock::time_point;
  std::optional<LineFile> log_;
  RunEnds ends_;
  double first_time_ = 0.0, first_steps_ = 0.0, first_seconds_ = 0.0;  ///< of a resume
  bool terminal_;
  Time start_, drawn_{};
  int tenths_ = -1;       ///< last tenth of the run that was said
  bool drawing_ = false;  ///< the cursor stands behind a progress line
  std::map<std::string, long> warnings_;
};

/// Seconds as a person says them: 42 s, 3 min 20 s, 2 h 5 min.
std::string duration_text(double seconds);

/// The same with tenths below ten seconds.
std::string cost_text(double seconds);

/// Lines that say what was read, what is modelled and what is not.
std::vector<std::string> scene_lines(
    const Scene& scene, const RunDescription& run, int ranks, double particles
);

/// What to type next: report, or resume where a run was cut off and has a checkpoint.
std::string next_command(const RunDescription& run, const RunVerdict& verdict);

/// Lines of the end: the result, where the files are and what to type next.
std::vector<std::string> result_lines(
    const Scene& scene,
    const State& state,
    const RunDescription& run,
    const RunVerdict& verdict,
    const std::vector<std::string>& numbers
);

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#include "base/numbers.hpp"
#include "checkpoint/check_values.hpp"
#include "checkpoint/checkpoint_contents.hpp"
#include "files/text_file.hpp"
#include "jet/rest.hpp"

#include <cmath>
#include <fstream>

namespace barreno {
namespace {

/// Larger whole numbers are not exact as doubles.
constexpr double max_exact_integer = 9007199254740992.0;

/// What a number may be.
struct Rule {
  std::string name;
  double least, most;
  bool whole;
};

std::string fault_of_number(const RunNumbers& numbers, const std::string& group, const Rule& rule) {
  const std::string name = group + rule.name;
  const auto found = numbers.find(rule.name);
  if (found == numbers.end()) return name + " is missing";
  if (found->second.size() != 1)
    return name + " has " + std::to_string(found->second.size()) + " values instead of 1";
  const double value = found->second.front();
  const bool fine =
      value >= rule.least && value <= rule.most && (!rule.whole || value == std::floor(value));
  return fine ? std::string() : name + " is " + to_text(value);
}

std::string fault_of_list(
    const RunNumbers& numbers, const std::string& group, const std::string& name, std::size_t size
) {
  const auto found = numbers.find(name);
  if (found == numbers.end()) return group + name + " is missing";
  if (found->second.size() != size)
    return group + name + " has " + std::to_string(found->second.size()) + " values instead of " +
           std::to_string(size);
  for (const double value : found->second)
    if (!std::isfinite(value)) return group + name + " holds " + to_text(value);
  return {};
}

/// Rules of the numbers in for_each_number; any other is finite.
Rule rule_of(const Scene& scene, const std::string& name) {
  constexpr double most = std::numeric_limits<double>::max();
  if (name == "time" || name == "dt" || name == "begin" || name == "pore_flow_interval" ||
      name == "pore_flow_waiting" || name == "pore_flow_iterations")
    return {name, 0.0, most, false};
  if (name == "step" || name == "retried_steps" || name == "pore_flow_solves")
    return {name, 0.0, max_exact_integer, true};
  if (name == "next_slug") return {name, 0.0, static_cast<double>(scene.jet.slugs.size()), true};
  return {name, -most, most, false};
}

/// The last step began before it ended, at least its last part before.
std::string fault_of_begin(const RunNumbers& numbers) {
  const double time = number_of(numbers, "time"), begin = number_of(numbers, "begin");
  const double round_off = 1e-9 * time;
  if (begin <= time - number_of(numbers, "dt") + round_off) return {};
  return "run/begin is " + to_text(begin) + ", which does not belong to its time";
}

/// A slug is launched at the beginning of the first step that begins at its time or later.
std::string fault_of_launches(const Scene& scene, const RunNumbers& numbers) {
  const auto next = static_cast<std::size_t>(number_of(numbers, "next_slug"));
  const double time = number_of(numbers, "time");
  const double begin = number_of(numbers, "begin");
  const double round_off = 1e-9 * time;
  const auto& slugs = scene.jet.slugs;
  const bool early = next > 0 && slugs[next - 1].time > begin + round_off;
  const bool late = next < slugs.size() && slugs[next].time < begin - round_off;
  if (number_of(numbers, "step") == 0.0 || (!early && !late)) return {};
  return "run/next_slug is " + std::to_string(next) + ", which does not belong to run/begin";
}

/// A table of text goes on behind a whole line.
std::string fault_of_length(
    const Checkpoint& checkpoint, const std::string& number, const std::string& file, bool wanted
) {
  const double bytes = number_of(checkpoint.output, number);
  if (!wanted) return {};
  std::ifstream stream(checkpoint.file.parent_path() / file, std::ios::binary);
  stream.seekg(static_cast<std::streamoff>(bytes) - 1);
  // A file that is shorter, or gone, has its own sentence.
  const int last = bytes < 1.0 ? 0 : stream.get();
  if (last == '\n' || !stream) return {};
  return "output/" + number + " is " + to_text(bytes) + ", where no line of " + file +
         " ends; put that table back if it was changed";
}

std::string fault_of_output(const Scene& scene, const State& state, const Checkpoint& checkpoint) {
  const RunNumbers& numbers = checkpoint.output;
  const double step = number_of(checkpoint.numbers, "step");
  const double time = number_of(checkpoint.numbers, "time");
  const double max_ranks = 1e9;
  for (const Rule& rule : std::vector<Rule>{
           {"seconds", 0.0, std::numeric_limits<double>::max(), false},
           {"fields_step", 0.0, step, true},
           {"rows_step", 0.0, step, true},
           {"fields_time", 0.0, time, false},
           {"row_time", 0.0, time, false},
           {"fields_kept", 1.0, step + 1.0, true},
           {"fields_files", 1.0, max_ranks, true},
           {"history_bytes", 1.0, max_exact_integer, true},
           {"depth_bytes", 0.0, max_exact_integer, true},
           {"through_since", 0.0, time, false},
           {"radii_bytes", 0.0, max_exact_integer, true},
           {"cavities_bytes", 0.0, max_exact_integer, true}}) {
    std::string fault = fault_of_number(numbers, "output/", rule);
    if (!fault.empty()) return fault;
  }
  const int axes = scene.grid.mode == Mode::three_dimensional ? 3
                   : scene.grid.mode == Mode::plane_strain    ? 2
                                                              : 1;
  const std::size_t reactions = state.reactions.size() * static_cast<std::size_t>(axes);
  std::string fault = fault_of_list(numbers, "output/", "row_reactions", reactions);
  const auto look = [&](const char* number, const char* file, bool wanted) {
    if (fault.empty()) fault = fault_of_length(checkpoint, number, file, wanted);
  };
  if (fault.empty()) {
    fault = fault_of_rest(numbers, time);
    if (!fault.empty()) fault = "output/" + fault;
  }
  look("history_bytes", "history.csv", true);
  look("depth_bytes", "depth.csv", scene.jet.present || number_of(numbers, "depth_bytes") > 0.0);
  return fault;
}

}  // namespace

std::string fault_of_run_numbers(
    const Scene& scene, const State& state, const Checkpoint& checkpoint
) {
  const RunNumbers& numbers = checkpoint.numbers;
  std::string fault;
  for_each_number(state, [&](const char* name, const auto&) {
    if (fault.empty()) fault = fault_of_number(numbers, "run/", rule_of(scene, name));
  });
  if (fault.empty()) fault = fault_of_number(numbers, "run/", {"ranks", 1.0, 1e9, true});
  if (fault.empty())
    fault = fault_of_number(
        numbers, "run/", {"stable_step", std::numeric_limits<double>::denorm_min(), infinity, false}
    );
  if (fault.empty()) fault = fault_of_list(numbers, "run/", "cavities", state.cavities.size());
  if (fault.empty()) fault = fault_of_begin(numbers);
  return fault.empty() ? fault_of_launches(scene, numbers) : fault;
}

std::string fault_of_numbers(const Scene& scene, const State& state, const Checkpoint& checkpoint) {
  std::string fault = fault_of_run_numbers(scene, state, checkpoint);
  return fault.empty() ? fault_of_output(scene, state, checkpoint) : fault;
}

}  // namespace barreno

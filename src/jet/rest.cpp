// SPDX-License-Identifier: BSD-3-Clause
#include "jet/rest.hpp"

#include "base/format.hpp"
#include "jet/path.hpp"
#include "scene/jet.hpp"
#include "state/balance.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

constexpr const char* rest_samples_name = "rest_samples";
constexpr const char* rest_look_name = "rest_look";
constexpr std::size_t numbers_of_look = 8;

std::string microseconds(double time) {
  return format("%.4g us", 1e6 * time);
}

std::string percent_text(double share) {
  return format("%.2g %%", 100.0 * share);
}

/// What keeps a hole from being at rest.
std::string unrest_sentence(const Rest& rest) {
  const std::string text =
      format("The hole is not at rest: its depth grew at %.4g m/s in the last ", rest.rate()) +
      microseconds(rest.window);
  if (!(rest.share_on_its_way > 0.0)) return text + ".";
  return text + ", and " + percent_text(rest.share_on_its_way) +
         " of the jet's mass, which still digs, is on its way.";
}

/// Whether the numbers of a look can be of a run at this time.
bool is_look(const std::vector<double>& numbers, double time) {
  for (const std::size_t at : {3U, 4U, 7U})  // its time, its window and the first contact
    if (!(numbers[at] <= time)) return false;
  return std::all_of(numbers.begin(), numbers.end(), [](double number) {
    return number >= 0.0 && std::isfinite(number);
  });
}

/// Whether times and depths grow, and are there if the target was met.
bool is_growth(const std::vector<double>& samples, bool met, double time) {
  if (samples.size() % 2 != 0 || met == samples.empty()) return false;
  for (std::size_t i = 0; i < samples.size(); i += 2) {
    const double at = samples[i], depth = samples[i + 1];
    if (!(at >= 0.0 && at <= time && depth > 0.0 && std::isfinite(depth))) return false;
    if (i > 0 && !(at > samples[i - 2] && depth > samples[i - 1])) return false;
  }
  return true;
}

}  // namespace

RestRule rest_rule(const Scene& scene) {
  constexpr double radii = 20.0;
  const JetSpec& jet = scene.jet;
  const double cut_off = cut_off_velocity(scene);
  const std::vector<double> masses = jet_table_masses(scene);
  RestRule rule;
  rule.least_window = radii * widest_radius(scene) / fastest_velocity(jet);
  rule.stand_off = std::abs(jet_path(scene).face - jet.launch_position);
  for (std::size_t s = 0; s < jet.slugs.size(); ++s) {
    const JetSlug& slug = jet.slugs[s];
    rule.jet_mass += masses[s];
    if (slug.velocity >= cut_off) rule.slugs.push_back({slug.time, slug.velocity, masses[s]});
  }
  return rule;
}

double share_on_its_way(const RestRule& rule, double time, double depth) {
  double mass = 0.0;
  for (const ComingSlug& slug : rule.slugs)
    if (slug.time + (rule.stand_off + depth) / (slowed * slug.velocity) > time) mass += slug.mass;
  return mass / rule.jet_mass;
}

RestWatch::RestWatch(RestRule rule, const RunNumbers& position) : rule_(std::move(rule)) {
  const auto look = position.find(rest_look_name), samples = position.find(rest_samples_name);
  if (look == position.end() || samples == position.end()) return;
  if (look->second.size() != numbers_of_look) return;
  const std::vector<double>& n = look->second;
  last_ = {n[0] != 0.0, n[1] != 0.0, n[2] != 0.0, n[3], n[4], n[5], n[6]};
  first_contact_ = n[7];
  for (std::size_t i = 0; i + 1 < samples->second.size(); i += 2)
    samples_.push_back({samples->second[i], samples->second[i + 1]});
}

void RestWatch::look(double time, const Penetration& found) {
  last_.time = time;
  last_.through = found.through;
  last_.share_on_its_way = share_on_its_way(rule_, time, 0.0);
  if (!found.met && !last_.met) return;
  if (!last_.met) first_contact_ = time;
  last_.met = true;
  if (samples_.empty() || found.depth > samples_.back().depth)
    samples_.push_back({time, found.depth});
  const double window = std::max(rule_.least_window, rest_window * (time - first_contact_));
  const double begin = std::max(first_contact_, time - window);
  const auto later = std::find_if(samples_.begin() + 1, samples_.end(), [&](const Sample& sample) {
    return sample.time > begin;
  });
  samples_.erase(samples_.begin(), later - 1);
  const double depth = samples_.back().depth;
  last_.share_on_its_way = share_on_its_way(rule_, time, depth);
  last_.window = time - begin;
  last_.growth = depth - samples_.front().depth;
  last_.at_rest = time - window >= first_contact_ && last_.growth <= rest_share * depth &&
                  last_.share_on_its_way <= rest_share;
}

RunNumbers RestWatch::numbers() const {
  const Rest& l = last_;
  const auto flag = [](bool is) { return is ? 1.0 : 0.0; };
  std::vector<double> samples;
  for (const Sample& sample : samples_) samples.insert(samples.end(), {sample.time, sample.depth});
  return {
      {rest_look_name,
       {flag(l.met),
        flag(l.through),
        flag(l.at_rest),
        l.time,
        l.window,
        l.growth,
        l.share_on_its_way,
        first_contact_}},
      {rest_samples_name, samples}};
}

std::string fault_of_rest(const RunNumbers& position, double time) {
  const auto look = position.find(rest_look_name), samples = position.find(rest_samples_name);
  if (look == position.end() && samples == position.end()) return {};
  if (look == position.end() || look->second.size() != numbers_of_look)
    return std::string(rest_look_name) + " does not hold " + std::to_string(numbers_of_look) +
           " numbers";
  if (samples == position.end()) return std::string(rest_samples_name) + " is missing";
  const bool fine =
      is_look(look->second, time) && is_growth(samples->second, look->second[0] != 0.0, time);
  return fine ? std::string() : std::string(rest_samples_name) + " is not the growth of a hole";
}

bool is_at_rest(const RunNumbers& position) {
  return RestWatch({}, position).last().at_rest;
}

std::string rest_sentence(const Rest& rest) {
  const std::string now = microseconds(rest.time);
  if (!rest.met) return "There is no hole: the jet has not met its target by " + now + ".";
  if (rest.through && rest.at_rest)
    return "There is no depth: the jet has come out of the rear of the target, and nothing of it "
           "that still digs is on its way at " +
           now + ".";
  if (rest.through)
    return "There is no depth: the jet has come out of the rear of the target, and " +
           percent_text(rest.share_on_its_way) + " of its mass is still on its way at " + now + ".";
  if (!rest.at_rest) return unrest_sentence(rest);
  return "The hole is at rest at " + now + ": its depth grew by less than " +
         percent_text(rest_share) + " in the last " + microseconds(rest.window) +
         ", and nothing of the jet that can still reach the bottom is on its way.";
}

}  // namespace barreno

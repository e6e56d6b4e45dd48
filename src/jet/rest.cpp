// SPDX-License-Identifier: BSD-3-Clause
#include "jet/rest.hpp"

#include "base/format.hpp"
#include "base/numbers.hpp"
#include "jet/path.hpp"
#include "scene/jet.hpp"
#include "state/balance.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {
namespace {

constexpr const char* rest_samples_name = "rest_samples";
constexpr const char* rest_look_name = "rest_look";
constexpr std::size_t numbers_of_look = 14;
constexpr std::size_t numbers_of_sample = 4;

/// Share of what there is now by which it has grown.
double share_of(double growth, double now) {
  return now > 0.0 ? growth / now : 0.0;
}

std::string microseconds(double time) {
  return format("%.4g us", 1e6 * time);
}

std::string percent_text(double share) {
  return format("%.2g %%", 100.0 * share);
}

/// What the hole as wide as the jet did in the window.
std::string width_text(const Rest& rest) {
  if (!rest.probed) return {};
  return ", as far as it is as wide as the jet by " +
         percent_text(share_of(rest.probed_growth, rest.probed_depth)) + ", its volume there by " +
         percent_text(share_of(rest.volume_growth, rest.probed_volume));
}

/// What keeps a hole from being at rest.
std::string unrest_sentence(const Rest& rest) {
  const std::string text =
      format("The hole is not at rest: its depth grew at %.4g m/s in the last ", rest.rate()) +
      microseconds(rest.window) + width_text(rest);
  if (!(rest.share_on_its_way > 0.0)) return text + ".";
  return text + ", and " + percent_text(rest.share_on_its_way) +
         " of the jet's mass, which still digs, is on its way.";
}

/// What has hardly grown, and by how much.
std::string settled_text(const Rest& rest) {
  const double growth = rest.probed ? share_of(rest.probed_growth, rest.probed_depth)
                                    : share_of(rest.growth, rest.depth);
  const std::string where =
      has_growing_thread(rest) ? "as far as it is as wide as the jet, " : std::string();
  std::string text = where + "its depth grew by " + percent_text(growth) + " in the last " +
                     microseconds(rest.window);
  if (!rest.probed) return text;
  return text + ", its volume by " + percent_text(share_of(rest.volume_growth, rest.probed_volume));
}

std::string thread_sentence(const Rest& rest) {
  if (!has_growing_thread(rest)) return {};
  return format(" Its narrower end grew at %.4g m/s; such a thread may still grow.", rest.rate());
}

/// Whether a hole as wide as the jet grew by no more than can be told from no growth: its depth is
/// known in whole rows, its volume as well as the place of its wall. The wall's area is that of a
/// cylinder with this depth and volume: 2 sqrt(pi V L).
bool is_settled(const RestRule& rule, const Rest& rest) {
  const double wall = rule.plane ? 2.0 * rest.probed_depth
                                 : 2.0 * std::sqrt(pi * rest.probed_volume * rest.probed_depth);
  const double depth = std::max(rest_share * rest.probed_depth, rule.row);
  const double volume = std::max(rest_share * rest.probed_volume, wall_share * rule.row * wall);
  // A row more or less, as a sum of rows, has a rounding error.
  return rest.probed_growth <= depth * (1.0 + 1e-9) && rest.volume_growth <= volume;
}

/// Whether the numbers of a look can be of a run at this time.
bool is_look(const std::vector<double>& numbers, double time) {
  for (const std::size_t at : {3U, 4U, 7U})  // its time, its window and the first contact
    if (!(numbers[at] <= time)) return false;
  return std::all_of(numbers.begin(), numbers.end(), [](double number) {
    return number >= 0.0 && std::isfinite(number);
  });
}

/// Whether a sample of a hole can follow another: later, and in something larger.
bool can_follow(const double* sample, const double* before) {
  bool larger = false;
  for (std::size_t i = 1; i < numbers_of_sample; ++i) {
    if (sample[i] < before[i]) return false;
    larger = larger || sample[i] > before[i];
  }
  return larger && sample[0] > before[0];
}

/// Whether times and sizes grow, and are there if the target was met.
bool is_growth(const std::vector<double>& samples, bool met, double time) {
  if (samples.size() % numbers_of_sample != 0 || met == samples.empty()) return false;
  for (std::size_t i = 0; i < samples.size(); i += numbers_of_sample) {
    const double* const sample = &samples[i];
    if (!(sample[0] >= 0.0 && sample[0] <= time && sample[1] > 0.0)) return false;
    if (!(sample[2] >= 0.0 && sample[3] >= 0.0)) return false;
    if (!std::all_of(sample, sample + numbers_of_sample, [](double n) { return std::isfinite(n); }))
      return false;
    if (i > 0 && !can_follow(sample, sample - numbers_of_sample)) return false;
  }
  return true;
}

}  // namespace

RestRule rest_rule(const Scene& scene) {
  constexpr double radii = 20.0;
  const JetSpec& jet = scene.jet;
  const double cut_off = cut_off_velocity(scene);
  const std::vector<double> masses = jet_table_masses(scene);
  const JetPath path = jet_path(scene);
  RestRule rule;
  rule.least_window = radii * widest_radius(scene) / fastest_velocity(jet);
  rule.stand_off = std::abs(path.face - jet.launch_position);
  rule.row = path.bin;
  rule.plane = scene.grid.mode == Mode::plane_strain;
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
  last_ = {
      n[0] != 0.0,
      n[1] != 0.0,
      n[2] != 0.0,
      n[3],
      n[4],
      n[5],
      n[6],
      n[8],
      n[9] != 0.0,
      n[10],
      n[11],
      n[12],
      n[13]};
  first_contact_ = n[7];
  const std::vector<double>& s = samples->second;
  for (std::size_t i = 0; i + numbers_of_sample <= s.size(); i += numbers_of_sample)
    samples_.push_back({s[i], s[i + 1], s[i + 2], s[i + 3]});
}

/// A sample, if the hole has become larger.
void RestWatch::keep(double time, const Penetration& found) {
  Sample now{time, found.depth, found.probed_depth, found.probed_volume};
  if (!samples_.empty()) {
    const Sample& before = samples_.back();
    now.depth = std::max(now.depth, before.depth);
    now.probed_depth = std::max(now.probed_depth, before.probed_depth);
    now.probed_volume = std::max(now.probed_volume, before.probed_volume);
    if (now.depth == before.depth && now.probed_depth == before.probed_depth &&
        now.probed_volume == before.probed_volume)
      return;
  }
  samples_.push_back(now);
}

/// Compares the ends of the window.
void RestWatch::judge() {
  const Sample &now = samples_.back(), &before = samples_.front();
  last_.depth = now.depth;
  last_.growth = now.depth - before.depth;
  last_.probed_depth = now.probed_depth;
  last_.probed_growth = now.probed_depth - before.probed_depth;
  last_.probed_volume = now.probed_volume;
  last_.volume_growth = now.probed_volume - before.probed_volume;
  // A jet that is through has no depth: its hole is as long as the target.
  last_.probed = !last_.through && now.probed_depth >= wide_share * now.depth;
  const double bottom = last_.probed ? now.probed_depth : now.depth;
  last_.share_on_its_way = share_on_its_way(rule_, last_.time, bottom);
  const bool settled =
      last_.probed ? is_settled(rule_, last_) : last_.growth <= rest_share * now.depth;
  last_.at_rest = settled && last_.share_on_its_way <= rest_share;
}

void RestWatch::look(double time, const Penetration& found) {
  last_.time = time;
  last_.through = found.through;
  last_.share_on_its_way = share_on_its_way(rule_, time, 0.0);
  if (!found.met && !last_.met) return;
  if (!last_.met) first_contact_ = time;
  last_.met = true;
  keep(time, found);
  const double window = std::max(rule_.least_window, rest_window * (time - first_contact_));
  const double begin = std::max(first_contact_, time - window);
  const auto later = std::find_if(samples_.begin() + 1, samples_.end(), [&](const Sample& sample) {
    return sample.time > begin;
  });
  samples_.erase(samples_.begin(), later - 1);
  last_.window = time - begin;
  judge();
  last_.at_rest = last_.at_rest && time - window >= first_contact_;
}

RunNumbers RestWatch::numbers() const {
  const Rest& l = last_;
  const auto flag = [](bool is) { return is ? 1.0 : 0.0; };
  std::vector<double> samples;
  for (const Sample& one : samples_)
    samples.insert(samples.end(), {one.time, one.depth, one.probed_depth, one.probed_volume});
  return {
      {rest_look_name,
       {flag(l.met),
        flag(l.through),
        flag(l.at_rest),
        l.time,
        l.window,
        l.growth,
        l.share_on_its_way,
        first_contact_,
        l.depth,
        flag(l.probed),
        l.probed_depth,
        l.probed_growth,
        l.probed_volume,
        l.volume_growth}},
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

bool has_growing_thread(const Rest& rest) {
  return rest.probed && share_of(rest.growth, rest.depth) > rest_share;
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
  return "The hole is at rest at " + now + ": " + settled_text(rest) +
         ", and nothing of the jet that can still reach the bottom is on its way." +
         thread_sentence(rest);
}

}  // namespace barreno

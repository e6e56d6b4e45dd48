// SPDX-License-Identifier: BSD-3-Clause
#include "drive/yield_table.hpp"

#include "drive/yield_view.hpp"
#include "files/text_file.hpp"

#include <algorithm>
#include <barreno/arenisca/parts/lode.hpp>
#include <cmath>
#include <optional>

namespace barreno {
namespace {

constexpr double third_turn = arenisca::Lode::third_turn;
constexpr int degrees = 60;  // of a third of a half turn

struct Range {
  double low, high;
};

/// The picture shows all of the initial surface and what lies about the path of a larger one.
Range range_of(const std::vector<Sym3>& bounded, const YieldView& initial) {
  constexpr double margin = 0.15;
  Range range{0.0, 0.0};
  for (const Sym3& s : bounded) {
    range.low = std::min(range.low, trace(s));
    range.high = std::max(range.high, trace(s));
  }
  const double path = range.high - range.low;
  if (std::isfinite(initial.tip)) range.low = std::min(range.low, initial.tip);
  if (std::isfinite(initial.vertex)) range.high = std::max(range.high, initial.vertex);
  range.low -= margin * path;
  range.high += margin * path;
  return range;
}

class YieldTable {
public:
  void add(
      const char* state, const char* section, double time, double theta, double I1, double shear
  ) {
    text_ += std::string(state) + "," + section + "," +
             csv_line({time, degrees / third_turn * theta, I1, shear}) + "\n";
  }
  const std::string& text() const { return text_; }

private:
  std::string text_ = "state,section,time,lode_angle,I1,sqrt_J2\n";
};

/// Points lie closer at both ends, where the meridian is steep.
void add_meridian(
    YieldTable& table,
    const char* state,
    const char* section,
    double time,
    double theta,
    const YieldView& view,
    const Range& shown
) {
  constexpr int parts = 200;
  const double low = std::max(view.tip, shown.low), high = std::min(view.vertex, shown.high);
  const double gamma = view.gamma(theta);
  for (int i = 0; i <= parts; ++i) {
    const double part = 0.5 - 0.5 * std::cos(3.0 * third_turn * i / parts);
    const double I1 = i == parts ? high : low + part * (high - low);
    table.add(state, section, time, theta, I1, gamma * view.limit(I1));
  }
}

void add_octahedral(
    YieldTable& table, const char* state, double time, const YieldView& view, double I1
) {
  if (I1 < view.tip || I1 > view.vertex) return;
  const double limit = view.limit(I1);
  for (int i = 0; i <= degrees; ++i) {
    const double theta = third_turn * i / degrees;
    table.add(state, "octahedral", time, theta, I1, view.gamma(theta) * limit);
  }
}

/// The state of largest sqrt(J2); the last one of a path that has none beyond round-off.
std::size_t most_sheared(const std::vector<Sym3>& stresses) {
  constexpr double round_off = 1e-6;
  std::size_t most = stresses.size() - 1;
  double largest = 0.0, size = 0.0;
  for (const Sym3& s : stresses) size = std::max(size, norm(s));
  for (std::size_t i = 0; i < stresses.size(); ++i) {
    const double shear = shear_of(stresses[i]);
    if (shear <= largest || shear <= round_off * size) continue;
    largest = shear;
    most = i;
  }
  return most;
}

}  // namespace

double shear_of(const Sym3& stress) {
  const Sym3 s = deviator(stress);
  return std::sqrt(0.5 * contract(s, s));
}

std::string yield_table(const Material& material, const std::vector<DrivenState>& states) {
  const auto view = [&](std::size_t i) {
    return yield_view(material, states[i], states[i == 0 ? 0 : i - 1]);
  };
  const auto initial = view(0);
  if (!initial) return {};
  std::vector<Sym3> bounded;
  for (std::size_t i = 0; i < states.size(); ++i) bounded.push_back(view(i)->bounded);
  const std::size_t largest = most_sheared(bounded);
  const std::size_t last = states.size() - 1;
  const auto current = view(last), sheared = view(largest);
  const Range shown = range_of(bounded, *initial);
  YieldTable table;
  for (const double theta : {third_turn, 0.0}) {
    const char* section = theta > 0.0 ? "compression" : "extension";
    if (theta == 0.0 && initial->gamma(0.0) == 1.0) continue;
    add_meridian(table, "initial", section, states[0].time, theta, *initial, shown);
    add_meridian(table, "current", section, states[last].time, theta, *current, shown);
  }
  const double I1 = trace(bounded[largest]);
  add_octahedral(table, "initial", states[0].time, *initial, I1);
  add_octahedral(table, "current", states[largest].time, *sheared, I1);
  return "# SI units: time s; lode_angle degree, 0 in triaxial extension and 60 in compression; "
         "I1, sqrt_J2 Pa, of the " +
         bounded_stress_words(material) + "\n" + table.text();
}

}  // namespace barreno

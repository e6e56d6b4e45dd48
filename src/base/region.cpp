// SPDX-License-Identifier: BSD-3-Clause
#include "base/region.hpp"

#include <Kokkos_Core.hpp>

#include <chrono>

namespace barreno {
namespace {

std::vector<PhaseTime>& all_phases() {
  static std::vector<PhaseTime> phases;
  return phases;
}

std::size_t find_or_add(const char* label) {
  auto& phases = all_phases();
  for (std::size_t i = 0; i < phases.size(); ++i)
    if (phases[i].label == label) return i;
  phases.push_back({label, label, 0.0, 0});
  return phases.size() - 1;
}

double now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

}  // namespace

const std::vector<PhaseTime>& phase_times() {
  return all_phases();
}
void clear_phase_times() {
  all_phases().clear();
}

Region::Region(const char* label) : index_(find_or_add(label)), start_(now()) {
  Kokkos::Profiling::pushRegion(all_phases()[index_].name);
}

Region::~Region() {
  Kokkos::Profiling::popRegion();
  all_phases()[index_].seconds += now() - start_;
  ++all_phases()[index_].calls;
}

}  // namespace barreno

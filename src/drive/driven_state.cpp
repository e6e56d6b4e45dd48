// SPDX-License-Identifier: BSD-3-Clause
#include "drive/driven_state.hpp"

#include "drive/matrix.hpp"

namespace barreno {

std::vector<DrivenState> states_of(const std::vector<DrivenRow>& rows) {
  const Mat3 from_first = inverse(rows.front().deformation_gradient);
  std::vector<DrivenState> states;
  for (const DrivenRow& row : rows) {
    const Mat3 f = row.deformation_gradient * from_first;
    // U^2 = F^T F is positive definite, so that it has a logarithm wherever det F > 0.
    const auto twice = logarithm_1p(transpose(f) * f - identity());
    const Sym3 strain = twice ? 0.5 * symmetric_part(*twice) : Sym3{};
    states.push_back({row.time, strain, row.unrotated, row.history});
  }
  return states;
}

std::vector<DrivenState> states_of(const std::vector<MixedAnswer>& answers) {
  std::vector<DrivenState> states;
  states.reserve(answers.size());
  for (const MixedAnswer& a : answers) states.push_back({a.time, a.strain, a.stress, a.history});
  return states;
}

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/section_of.hpp"

#include <optional>

namespace barreno {

/// How slow a deck wants its loading to be; what follows from it is QuasiStaticSpec.
struct QuasiStaticSection {
  double transit_ratio = 0.001;          ///< time of a wave over that of diffusion, or the run [-]
  std::optional<double> inertia_factor;  ///< densities that move times this [-]
};
template <>
const SectionTable<QuasiStaticSection>& table_of<QuasiStaticSection>();

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#include "jet/rock_permeability.hpp"

#include <algorithm>
#include <cmath>

namespace barreno {

double rock_permeability(double porosity, double virgin, double breakage) {
  using Law = PermeabilityLaw;
  const double pores = porosity / virgin, grains = (1.0 - virgin) / std::max(1.0 - porosity, 1e-12);
  const double of_pores = std::min(pores * pores * pores * grains * grains, Law::most);
  const double surface = 1.0 + breakage * (1.0 / std::sqrt(Law::of_broken) - 1.0);
  return of_pores / (surface * surface);
}

}  // namespace barreno

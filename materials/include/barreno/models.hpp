// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models/arenisca.hpp"
#include "barreno/models/general_arenisca.hpp"
#include "barreno/models/johnson_cook.hpp"
#include "barreno/models/linear_elastic.hpp"
#include "barreno/models/neo_hookean.hpp"
#include "barreno/models/poroelastic.hpp"

#include <string>
#include <variant>

namespace barreno {

/// The list of models: the one line that a new model adds. Dispatch, registry, manual, restart and
/// output names, host interfaces and contract tests all follow from it.
///
/// A model with a SpecialForm is not asked for by name: it serves those parameter sets of that
/// other model for which its needed() says so.
using AnyModel =
    std::variant<LinearElastic, Poroelastic, NeoHookean, JohnsonCook, Arenisca, GeneralArenisca>;

/// A model with its parameters, as a deck or a host asked for it.
struct Material {
  std::string name;      ///< the deck's or card's own name, for messages
  double density = 0.0;  ///< reference density: V_ref = mass / density [mass/length^3]
  AnyModel model;
};

}  // namespace barreno

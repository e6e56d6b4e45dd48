// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models/arenisca.hpp"
#include "barreno/models/exchanged_arenisca.hpp"
#include "barreno/models/featured_arenisca.hpp"
#include "barreno/models/general_arenisca.hpp"
#include "barreno/models/jwl_explosive.hpp"
#include "barreno/models/linear_elastic.hpp"
#include "barreno/models/liquid.hpp"
#include "barreno/models/metals.hpp"
#include "barreno/models/neo_hookean.hpp"
#include "barreno/models/poroelastic.hpp"
#include "barreno/models/wet_arenisca.hpp"

#include <string>
#include <type_traits>
#include <variant>

namespace barreno {

/// The list of models: the one line that a new model adds. Dispatch, registry, manual, restart and
/// output names, host interfaces and contract tests all follow from it.
///
/// A model with a SpecialForm is not asked for by name: it serves those parameter sets of that
/// other model for which its needed() says so. Metals, and rocks with other parts than the
/// published ones, follow from the lists of their parts (metal/list.hpp, arenisca/parts/list.hpp).
using AnyModel = arenisca::WithOtherParts<JoinedVariants<
    std::variant<LinearElastic, Poroelastic, JwlExplosive, NeoHookean, Liquid>,
    Metals,
    std::variant<
        Arenisca,
        ScatteredArenisca,
        WetArenisca,
        RatedArenisca,
        RatedWetArenisca,
        AngledArenisca,
        AngledWetArenisca,
        DamagedArenisca,
        DamagedWetArenisca,
        HeatedArenisca,
        HeatedWetArenisca,
        RatedHeatedArenisca,
        RatedHeatedWetArenisca,
        GeneralArenisca>>::type>;

/// Name of a model, and that of its form where several models serve one name: "Arenisca wet".
template <class Model, class = void>
struct FullName {
  static std::string of() { return Model::name; }
};
template <class Model>
struct FullName<Model, std::void_t<typename Model::SpecialForm>> {
  static std::string of() { return std::string(Model::name) + " " + Model::form; }
};

/// A model with its parameters, as a deck or a host asked for it.
struct Material {
  std::string name;      ///< the deck's or card's own name, for messages
  double density = 0.0;  ///< reference density: V_ref = mass / density [mass/length^3]
  AnyModel model;
};

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models/arenisca.hpp"
#include "barreno/models/wet_arenisca.hpp"

#include <variant>

namespace barreno {

/// Arenisca, dry or in the wet poroplastic form, with one part in place of a published one
/// (arenisca/parts/list.hpp); for the cards that ask for it.
/// @param Part  the part
/// @param Form  AreniscaOf or WetAreniscaOf, with it
template <class Part, class Form>
struct ExchangedArenisca : Form {
  using SpecialForm = Arenisca;
  using Form::Form;
  static constexpr bool wet = Form::Law::wet;
  static constexpr JoinedText words = joined_text(Part::word, wet ? " wet" : "");
  static constexpr const char* form = words.letters;

  static bool needed(const AreniscaParameters& p) {
    return Part::asked(p) && arenisca::is_plain(p) && arenisca::is_plain_law(p, wet) &&
           (p.fluid_B0 > 0.0) == wet;
  }
};

namespace arenisca {

template <class Part, class Parts>
using ExchangedForms = std::variant<
    ExchangedArenisca<Part, AreniscaOf<Parts>>,
    ExchangedArenisca<Part, WetAreniscaOf<Parts>>>;

/// The forms of the parts in all three lists.
template <class Models, class Limits, class Curves, class Rules>
struct WithExchanged;
template <class Models, class... Limits, class... Curves, class... Rules>
struct WithExchanged<Models, PartList<Limits...>, PartList<Curves...>, PartList<Rules...>>
    : JoinedVariants<
          Models,
          ExchangedForms<Limits, PartsOf<Limits, CrushCurve, FlowRule>>...,
          ExchangedForms<Curves, PartsOf<ShearLimit, Curves, FlowRule>>...,
          ExchangedForms<Rules, PartsOf<ShearLimit, CrushCurve, Rules>>...> {};

/// The models, and the forms that parts outside of the published law make.
template <class Models>
using WithOtherParts =
    typename WithExchanged<Models, OtherShearLimits, OtherCrushCurves, OtherFlowRules>::type;

}  // namespace arenisca
}  // namespace barreno

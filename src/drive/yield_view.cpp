// SPDX-License-Identifier: BSD-3-Clause
#include "drive/yield_view.hpp"

#include <algorithm>
#include <barreno/arenisca/points_pieces.hpp>
#include <barreno/arenisca/points_rate.hpp>
#include <barreno/history_values.hpp>
#include <cmath>
#include <limits>
#include <type_traits>

namespace barreno {
namespace {

constexpr double infinite = std::numeric_limits<double>::infinity();

template <class Model>
typename Model::History history_from(const std::vector<double>& values) {
  typename Model::History history{};
  double* const into = history_values<Model>(history);
  for (std::size_t i = 0; i < values.size(); ++i) into[i] = values[i];
  return history;
}

template <class Surface>
YieldView view_of(
    const Sym3& bounded,
    const Surface& surface,
    const arenisca::Cap& cap,
    const arenisca::Lode& lode
) {
  YieldView view{bounded, cap.present ? cap.X : -infinite, surface.vertex, {}, {}};
  view.limit = [surface, cap](double x) {
    const auto m = arenisca::meridian_at(surface, x, cap);
    return m.limit * std::sqrt(std::max(0.0, m.cap_squared));
  };
  view.gamma = [lode](double theta) { return lode.at(theta).gamma; };
  return view;
}

/// The forms that share one source over the features of a card.
template <class Law, class History>
YieldView view_of_law(const Law& law, const Sym3& stress, const History& h) {
  const auto& rock = arenisca::rock_of<double>(law, h);
  Sym3 bounded = stress;
  arenisca::Lode lode;
  if constexpr (Law::rated) bounded = bounded - arenisca::overstress_of<double>(h);
  // Of the forms for comparison, the stress less that at the elastic centre.
  bounded = bounded + isotropic(arenisca::pores_before<double>(rock, h).pressure);
  if constexpr (Law::angled) lode = law.lode;
  const auto cap = arenisca::cap_of<double>(rock, h.plastic_volume_strain);
  return view_of(bounded, rock.surface, cap, lode);
}

/// Von Mises' circle at the flow stress of the plastic strain rate that led here, or of the
/// reference rate where nothing has flowed.
template <class Model>
YieldView view_of_metal(
    const Model& model,
    const Sym3& stress,
    const typename Model::History& h,
    const typename Model::History& h_before,
    double dt
) {
  const double growth = h.plastic_strain - h_before.plastic_strain;
  const double rate = dt > 0.0 ? growth / dt : 0.0;
  // The flow stress of a step is that of the temperature at its start.
  const double flow = model.strength().stress(h.plastic_strain, rate, h_before.temperature);
  const double radius = model.is_broken(h) ? 0.0 : flow / std::sqrt(3.0);
  return {
      stress, -infinite, infinite, [radius](double) { return radius; }, [](double) { return 1.0; }};
}

template <class Model>
std::optional<YieldView> view_for(
    const Model& model, const DrivenState& now, const DrivenState& before
) {
  using P = typename Model::Parameters;
  [[maybe_unused]] const auto h = history_from<Model>(now.history);
  if constexpr (is_metal_model<Model>) {
    const auto h_before = history_from<Model>(before.history);
    return view_of_metal(model, now.stress, h, h_before, now.time - before.time);
  } else if constexpr (std::is_same_v<P, AreniscaParameters>) {
    return view_of_law(model.rock(), now.stress, h);
  } else {
    return std::nullopt;
  }
}

template <class Model>
std::string words_for(const Model& model) {
  using P = typename Model::Parameters;
  if constexpr (std::is_same_v<P, AreniscaParameters>) {
    const P& p = model.parameters();
    const bool wet = p.fluid_B0 > 0.0, rated = p.T1_rate_dependence > 0.0;
    if (wet && std::is_same_v<Model, GeneralArenisca>)
      return "stress less that at the elastic centre";
    if (wet && rated) return "effective stress (stress + pore pressure - overstress)";
    if (wet) return "effective stress (stress + pore pressure)";
    if (rated) return "quasi-static stress (stress - overstress)";
  }
  return "stress";
}

}  // namespace

std::optional<YieldView> yield_view(
    const Material& material, const DrivenState& now, const DrivenState& before
) {
  return std::visit(
      [&](const auto& model) { return view_for(model, now, before); }, material.model
  );
}

std::string bounded_stress_words(const Material& material) {
  return std::visit([](const auto& model) { return words_for(model); }, material.model);
}

}  // namespace barreno

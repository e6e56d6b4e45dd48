// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/compiled_once.hpp"
#include "barreno/arenisca/points_angle.hpp"
#include "barreno/arenisca/points_damage.hpp"
#include "barreno/arenisca/points_heat.hpp"
#include "barreno/models/arenisca.hpp"
#include "barreno/models/wet_arenisca.hpp"

#include <string>
#include <vector>

namespace barreno {

/// Dry or wet Arenisca with rate dependence (arenisca/points_rate.hpp), strength that scatters
/// (arenisca/parts/scatter.hpp) and, in the angled form, third invariant (arenisca/parts/lode.hpp);
/// or with damage (arenisca/parts/damage.hpp) and scatter, or with heat (arenisca/parts/heat.hpp)
/// besides, or with rate dependence and both: the same law, with features that the plain form
/// leaves out when it is compiled. Those that a card does not ask for are off.
///
/// @param Plain     the form without them
/// @param Law_      rock of arenisca/points_angle.hpp, points_damage.hpp or points_heat.hpp
/// @param History_  begins with that of Plain
template <class Plain, class Law_, template <class> class History_>
struct FeaturedForm {
  using SpecialForm = Arenisca;
  using Parameters = Arenisca::Parameters;
  using Law = Law_;
  static constexpr const char* name = "Arenisca";
  static constexpr const char* summary = Arenisca::summary;

  template <class R>
  using HistoryOf = History_<R>;
  using History = HistoryOf<double>;
  static constexpr int history_count = Plain::history_count + 1 + (Law::rated ? 6 : 0) +
                                       (Law::damaged ? 3 : 0) + (Law::heated ? 2 : 0);

  static ParameterTable<Parameters> parameter_table() { return arenisca_parameter_table(); }
  static std::vector<HistoryField> history_table() {
    std::vector<HistoryField> table = Plain::history_table();
    table.push_back({"coherence", dimension::none, "strength at the vertex over the card's PEAKI1"}
    );
    if (Law::damaged) {
      table.push_back(
          {"damage", dimension::none, "0: whole; 1: no cohesion and no tensile strength"}
      );
      table.push_back(
          {"fracture_strain",
           dimension::none,
           "plastic strain of full damage in tension, for the size of the piece"}
      );
      table.push_back({"breakage", dimension::none, "breakage of grains, from 0 to 1"});
    }
    if (Law::heated) {
      table.push_back({"temperature", dimension::temperature, "temperature"});
      table.push_back(
          {"thermal_expansion",
           dimension::none,
           "volume strain of the grains by the heat of the last step, to come in the next"}
      );
    }
    if (!Law::rated) return table;
    for (const char* component :
         {"overstress_xx",
          "overstress_yy",
          "overstress_zz",
          "overstress_xy",
          "overstress_yz",
          "overstress_zx"})
      table.push_back({component, dimension::stress, "dynamic less quasi-static stress"});
    return table;
  }
  static std::string check(const Parameters& p, double density) {
    return Arenisca::check(p, density);
  }

  FeaturedForm(const Parameters& p, double density)
      : plain_(p, density),
        rock_(make_rock(plain_, density)),
        weibull_(arenisca::Weibull::make(p, Plain::Law::Parts::ShearLimit::largest_factor(p))) {}

  /// Gives a piece of rock the strength of its own, and the strain at which it breaks; a host that
  /// makes pieces calls this once, one that does not has the mean everywhere.
  void vary(History& h, const Specimen& piece) const {
    h.coherence = weibull_.factor(piece);
    if constexpr (Law::damaged)
      h.fracture_strain = rock_.damage.strain_of(piece.per_crack * std::sqrt(piece.face));
  }
  const arenisca::Weibull& weibull() const { return weibull_; }

  /// Gives a point heat that its update did not know of [energy/mass].
  template <class R>
  BARRENO_FUNCTION void add_heat(const R& heat, const Sym3Of<R>& stress, HistoryOf<R>& h) const {
    static_assert(Law::heated, "rock with heat");
    const R warming = heat * rock_.heat.per_specific_heat;
    h.temperature = h.temperature + warming;
    const R pressure = trace(stress) * (-1.0 / 3.0);
    h.thermal_expansion = h.thermal_expansion + rock_.heat.expansion(warming, pressure);
  }

  History initial_history() const { return full(plain_.initial_history()); }
  InitialStateOf<Sym3, History> initial_state(double pressure) const {
    return full(plain_.initial_state(pressure));
  }

  BARRENO_FUNCTION Outcome update(const Increment& increment, Sym3& stress, History& h) const {
    return arenisca::update_point(*this, rock_, increment, stress, h);
  }
  template <class R>
  using Points = PointsOf<Sym3Of<R>, HistoryOf<R>>;
  static constexpr int groups_together = 32;
  template <class R>
  BARRENO_FUNCTION MaskOf<R> start_points(Points<R>& p) const {
    const HistoryOf<R>& h = p.history;
    R sum = h.plastic_volume_strain + h.coherence;
    if constexpr (Law::rated)
      sum = sum + trace(arenisca::overstress_of<R>(h)) + h.overstress_xy + h.overstress_yz +
            h.overstress_zx;
    if constexpr (Law::wet) sum = sum + h.fluid_mass_ratio + h.pore_pressure;
    MaskOf<R> sound =
        arenisca::sound_points(p.increment, p.stress, sum, h.equivalent_plastic_strain) &
        (h.coherence >= 0.0);
    if constexpr (Law::damaged)
      sound = sound & (h.damage >= 0.0) & (h.damage <= 1.0) & (h.fracture_strain > 0.0) &
              (h.breakage >= 0.0) & (h.breakage <= 1.0);
    if constexpr (Law::heated)
      sound = sound & real::is_finite(R(h.temperature + h.thermal_expansion));
    if constexpr (Law::wet) sound = sound & arenisca::sound_pores<R, Law>(h);
    return arenisca::start_rock<R>(rock_, sound, p);
  }
  template <class R>
  BARRENO_FUNCTION void finish_points(Points<R>* groups, const MaskOf<R>* flows, int count) const {
    arenisca::StepOf<R, Law> steps[groups_together];
    arenisca::finish_rock(rock_, steps, groups, flows, count);
  }

  /// Bound on K + 4G/3 over all reachable states [stress].
  BARRENO_FUNCTION double longitudinal_modulus() const { return plain_.longitudinal_modulus(); }
  /// K + 4G/3 of a point in this state [stress].
  BARRENO_FUNCTION double longitudinal_modulus(
      const Sym3& stress, const History& h, double volume_ratio
  ) const {
    return plain_.longitudinal_modulus(quasi_static(stress, h), plain(h), volume_ratio);
  }
  /// Tangent moduli of the drained rock in this state.
  BARRENO_FUNCTION arenisca::Moduli drained_moduli(const Sym3& stress, const History& h) const {
    return plain_.drained_moduli(quasi_static(stress, h), plain(h));
  }
  const Parameters& parameters() const { return plain_.parameters(); }
  const Law& rock() const { return rock_; }

protected:
  static Law make_rock(const Plain& plain, double density) {
    const Parameters& p = plain.parameters();
    Law rock;
    static_cast<typename Plain::Law&>(rock) = plain.rock();
    arenisca::set_strength(p, rock);
    if constexpr (Law::angled) rock.lode = {p.J3_type, p.J3_psi};
    if constexpr (Law::damaged) {
      rock.damage = arenisca::Damage::make(p);
      rock.breakage = arenisca::Breakage::make(p);
      arenisca::set_damage(rock);
      rock.tension = arenisca::Tension::make(p);
    }
    if constexpr (Law::heated) rock.heat = arenisca::Heat::make(p, density);
    if constexpr (Law::rated) {
      rock.T1 = p.T1_rate_dependence;
      rock.T2 = p.T2_rate_dependence;
    }
    return rock;
  }
  BARRENO_FUNCTION static Sym3 quasi_static(const Sym3& stress, const History& h) {
    if constexpr (Law::rated)
      return stress - arenisca::overstress_of<double>(h);
    else
      return stress;
  }
  /// What the plain form knows of a point, and back.
  BARRENO_FUNCTION static typename Plain::History plain(const History& h) {
    typename Plain::History part;
    for (int i = 0; i < Plain::history_count; ++i)
      reals_of<double>(part)[i] = reals_of<double>(h)[i];
    return part;
  }
  BARRENO_FUNCTION History full(const typename Plain::History& part) const {
    History h;
    for (int i = 0; i < Plain::history_count; ++i)
      reals_of<double>(h)[i] = reals_of<double>(part)[i];
    if constexpr (Law::damaged) h.fracture_strain = rock_.damage.strain;
    if constexpr (Law::heated) h.temperature = rock_.heat.initial_temperature;
    return h;
  }
  InitialStateOf<Sym3, History> full(const InitialStateOf<Sym3, typename Plain::History>& s) const {
    return {s.stress, full(s.history), s.volume_ratio, s.stored_energy, s.possible};
  }

  Plain plain_;
  Law rock_;
  arenisca::Weibull weibull_;
};

template <class R>
struct ScatteredHistoryOf {
  R plastic_volume_strain{}, equivalent_plastic_strain{};
  R coherence = R{} + 1.0;
};
template <class R>
struct DamagedHistoryOf {
  R plastic_volume_strain{}, equivalent_plastic_strain{};
  R coherence = R{} + 1.0;
  R damage{}, fracture_strain = R{} + 1.0;
  R breakage{};
};
template <class R>
struct DamagedWetHistoryOf {
  R plastic_volume_strain{}, equivalent_plastic_strain{};
  R fluid_mass_ratio = R{} + 1.0;
  R pore_pressure{}, porosity{}, gas{};
  R coherence = R{} + 1.0;
  R damage{}, fracture_strain = R{} + 1.0;
  R breakage{};
};
template <class R>
struct HeatedHistoryOf {
  R plastic_volume_strain{}, equivalent_plastic_strain{};
  R coherence = R{} + 1.0;
  R damage{}, fracture_strain = R{} + 1.0;
  R breakage{};
  R temperature{}, thermal_expansion{};
};
template <class R>
struct HeatedWetHistoryOf {
  R plastic_volume_strain{}, equivalent_plastic_strain{};
  R fluid_mass_ratio = R{} + 1.0;
  R pore_pressure{}, porosity{}, gas{};
  R coherence = R{} + 1.0;
  R damage{}, fracture_strain = R{} + 1.0;
  R breakage{};
  R temperature{}, thermal_expansion{};
};
template <class R>
struct RatedHeatedHistoryOf {
  R plastic_volume_strain{}, equivalent_plastic_strain{};
  R coherence = R{} + 1.0;
  R damage{}, fracture_strain = R{} + 1.0;
  R breakage{};
  R temperature{}, thermal_expansion{};
  R overstress_xx{}, overstress_yy{}, overstress_zz{};
  R overstress_xy{}, overstress_yz{}, overstress_zx{};
};
template <class R>
struct RatedHeatedWetHistoryOf {
  R plastic_volume_strain{}, equivalent_plastic_strain{};
  R fluid_mass_ratio = R{} + 1.0;
  R pore_pressure{}, porosity{}, gas{};
  R coherence = R{} + 1.0;
  R damage{}, fracture_strain = R{} + 1.0;
  R breakage{};
  R temperature{}, thermal_expansion{};
  R overstress_xx{}, overstress_yy{}, overstress_zz{};
  R overstress_xy{}, overstress_yz{}, overstress_zx{};
};
template <class R>
struct FeaturedHistoryOf {
  R plastic_volume_strain{}, equivalent_plastic_strain{};
  R coherence = R{} + 1.0;
  R overstress_xx{}, overstress_yy{}, overstress_zz{};
  R overstress_xy{}, overstress_yz{}, overstress_zx{};
};
template <class R>
struct FeaturedWetHistoryOf {
  R plastic_volume_strain{}, equivalent_plastic_strain{};
  R fluid_mass_ratio = R{} + 1.0;
  R pore_pressure{}, porosity{}, gas{};
  R coherence = R{} + 1.0;
  R overstress_xx{}, overstress_yy{}, overstress_zz{};
  R overstress_xy{}, overstress_yz{}, overstress_zx{};
};

template <class Law>
using FeaturedDryForm = FeaturedForm<Arenisca, Law, FeaturedHistoryOf>;
using ScatteredForm =
    FeaturedForm<Arenisca, arenisca::ScatteredRock<arenisca::Rock>, ScatteredHistoryOf>;

using DamagedForm = FeaturedForm<Arenisca, arenisca::DamagedRock<arenisca::Rock>, DamagedHistoryOf>;

using HeatedForm = FeaturedForm<Arenisca, arenisca::HeatedRock<arenisca::Rock>, HeatedHistoryOf>;

using RatedHeatedForm =
    FeaturedForm<Arenisca, arenisca::RatedHeatedRock<arenisca::Rock>, RatedHeatedHistoryOf>;

/// With fluid in its pores, in the poroplastic form.
template <class Law, template <class> class History_ = FeaturedWetHistoryOf>
struct FeaturedWetForm : FeaturedForm<WetArenisca, Law, History_> {
  using Base = FeaturedForm<WetArenisca, Law, History_>;
  using History = typename Base::History;
  using Base::Base;

  using Base::initial_state;
  /// See WetArenisca.
  InitialStateOf<Sym3, History> initial_state(double pressure, double pore_pressure) const {
    return this->full(this->plain_.initial_state(pressure, pore_pressure));
  }
  double virgin_pressure() const { return this->plain_.virgin_pressure(); }
  /// The fluid of a point, see PorePoint.
  BARRENO_FUNCTION PorePoint pore_point(const Sym3& stress, const History& h) const {
    return this->plain_.pore_point(Base::quasi_static(stress, h), Base::plain(h));
  }
  BARRENO_FUNCTION Outcome drain(double fluid_volume, Sym3& stress, History& h) const {
    return arenisca::drain_point(*this, this->rock_, fluid_volume, stress, h);
  }
  BARRENO_FUNCTION static bool sound_history(const History& h) {
    if constexpr (Law::rated)
      if (!is_finite(arenisca::overstress_of<double>(h))) return false;
    return WetArenisca::sound_history(Base::plain(h)) && h.coherence >= 0.0;
  }
};

// The forms; `form` tells one from others of the name Arenisca.

struct ScatteredArenisca : ScatteredForm {
  using FeaturedForm::FeaturedForm;
  static constexpr const char* form = "scattered";
  static bool needed(const Parameters& p) { return arenisca::is_scattered(p); }
};
struct RatedArenisca : FeaturedDryForm<arenisca::RatedRock<arenisca::Rock>> {
  using FeaturedForm::FeaturedForm;
  static constexpr const char* form = "rated";
  static bool needed(const Parameters& p) { return arenisca::is_rated(p, false); }
};
struct RatedWetArenisca : FeaturedWetForm<arenisca::RatedRock<arenisca::WetRock>> {
  using FeaturedWetForm::FeaturedWetForm;
  static constexpr const char* form = "rated wet";
  static bool needed(const Parameters& p) { return arenisca::is_rated(p, true); }
};
struct AngledArenisca : FeaturedDryForm<arenisca::AngledRock<arenisca::Rock>> {
  using FeaturedForm::FeaturedForm;
  static constexpr const char* form = "angled";
  static bool needed(const Parameters& p) { return arenisca::is_angled(p, false); }
};
struct AngledWetArenisca : FeaturedWetForm<arenisca::AngledRock<arenisca::WetRock>> {
  using FeaturedWetForm::FeaturedWetForm;
  static constexpr const char* form = "angled wet";
  static bool needed(const Parameters& p) { return arenisca::is_angled(p, true); }
};

struct DamagedArenisca : DamagedForm {
  using FeaturedForm::FeaturedForm;
  static constexpr const char* form = "damaged";
  static bool needed(const Parameters& p) { return arenisca::is_damaged(p, false); }
};
using DamagedWetForm =
    FeaturedWetForm<arenisca::DamagedRock<arenisca::WetRock>, DamagedWetHistoryOf>;
struct DamagedWetArenisca : DamagedWetForm {
  using DamagedWetForm::DamagedWetForm;
  static constexpr const char* form = "damaged wet";
  static bool needed(const Parameters& p) { return arenisca::is_damaged(p, true); }
};

struct HeatedArenisca : HeatedForm {
  using FeaturedForm::FeaturedForm;
  static constexpr const char* form = "heated";
  static bool needed(const Parameters& p) { return arenisca::is_heated(p, false); }
};
using HeatedWetForm = FeaturedWetForm<arenisca::HeatedRock<arenisca::WetRock>, HeatedWetHistoryOf>;
struct HeatedWetArenisca : HeatedWetForm {
  using HeatedWetForm::HeatedWetForm;
  static constexpr const char* form = "heated wet";
  static bool needed(const Parameters& p) { return arenisca::is_heated(p, true); }
};

struct RatedHeatedArenisca : RatedHeatedForm {
  using FeaturedForm::FeaturedForm;
  static constexpr const char* form = "rated heated";
  static bool needed(const Parameters& p) { return arenisca::is_rated_heated(p, false); }
};
using RatedHeatedWetForm =
    FeaturedWetForm<arenisca::RatedHeatedRock<arenisca::WetRock>, RatedHeatedWetHistoryOf>;
struct RatedHeatedWetArenisca : RatedHeatedWetForm {
  using RatedHeatedWetForm::RatedHeatedWetForm;
  static constexpr const char* form = "rated heated wet";
  static bool needed(const Parameters& p) { return arenisca::is_rated_heated(p, true); }
};

}  // namespace barreno

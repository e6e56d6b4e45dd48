// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/models.hpp"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

/// What a model brings to the contract tests: a new model adds one Sample.
namespace barreno::test {

/// A sound parameter set in SI units, and what the tests need to know about it.
///   density       reference density [kg/m3]
///   parameters()  the set
///   elastic       a strain that is clearly elastic from the unstressed state, in any direction [-]
///   plastic       a strain that is clearly plastic, if the model has plasticity [-]
///   pressure      a hydrostatic pressure the material holds elastically [Pa]
///   contradictions()  sets that check() refuses, each with the parameter its sentence must name
template <class Model>
struct Sample {
  static_assert(
      sizeof(Model) == 0, "a new model needs its Sample in tests/materials/sample_models.hpp"
  );
};

template <>
struct Sample<LinearElastic> {
  static constexpr double density = 7830.0, elastic = 1e-3, plastic = 2e-2, pressure = 68.95e6;
  static LinearElastic::Parameters parameters() { return {160e9, 80e9}; }
  static std::vector<std::pair<LinearElastic::Parameters, std::string>> contradictions() {
    return {};
  }
};

/// Berea-like sandstone full of water: alpha = 7/9, B = 0.55.
template <>
struct Sample<Poroelastic> {
  static constexpr double density = 2300.0, elastic = 1e-3, plastic = 2e-2, pressure = 68.95e6;
  static Poroelastic::Parameters parameters() { return {8e9, 6e9, 0.19, 2.25e9, 36e9, 1.0, 5e6}; }
  static std::vector<std::pair<Poroelastic::Parameters, std::string>> contradictions() {
    std::vector<std::pair<Poroelastic::Parameters, std::string>> list(
        6, {parameters(), "Biot Coefficient"}
    );
    list[0].first.biot_coefficient = 0.8;
    list[1].first.grain_bulk_modulus = 0.0;
    list[1].first.biot_coefficient = 0.18;
    list[2].first.grain_bulk_modulus = 9.5e9;
    list[2].second = "Grain Bulk Modulus";
    list[3].first.grain_bulk_modulus = 7e9;
    list[3].second = "Grain Bulk Modulus";
    list[4].first.fluid_bulk_modulus = 0.0;
    list[4].second = "Initial Pore Pressure";
    list[5].first.grain_bulk_modulus = 0.0;
    list[5].first.biot_coefficient = 0.0;
    return list;
  }
};

/// Composition B, as in materials/cards/comp_b.xml, that bears a pressure before it burns, with a
/// modulus above rho D^2: else the bound on the step is not the stiffness of what is unlit.
template <>
struct Sample<JwlExplosive> {
  static constexpr double density = 1717.0, elastic = 1e-3, plastic = 2e-2, pressure = 68.95e6;
  static JwlExplosive::Parameters parameters() {
    return {7980.0, 524.23e9, 7.678e9, 4.2, 1.1, 0.34, 8.5e9, 115e9, 2.5};
  }
  static std::vector<std::pair<JwlExplosive::Parameters, std::string>> contradictions() {
    std::vector<std::pair<JwlExplosive::Parameters, std::string>> list(
        3, {parameters(), "Detonation Speed"}
    );
    list[0].first.detonation_speed = 7890.0;  // 1.1 % too slow
    list[1].first.r1 = 4.3;
    list[2].first.a = 0.0;
    list[2].first.b = -800e9;
    list[2].second = "Energy";
    return list;
  }
};

template <>
struct Sample<NeoHookean> {
  static constexpr double density = 1000.0, elastic = 1e-3, plastic = 2e-2, pressure = 0.5e6;
  static NeoHookean::Parameters parameters() { return {2e6, 0.4e6}; }
  static std::vector<std::pair<NeoHookean::Parameters, std::string>> contradictions() {
    return {{{0.2e6, 0.4e6}, "Bulk Modulus"}};
  }
};

/// Water whose pressures count from the state without stress, which every point starts from.
template <>
struct Sample<Liquid> {
  static constexpr double density = 998.2, elastic = 1e-3, plastic = 2e-2, pressure = 68.95e6;
  static Liquid::Parameters parameters() {
    return {4157.0, 1483.0, 1.921, 0.28, -98986.0, 0.0, 293.0};
  }
  static std::vector<std::pair<Liquid::Parameters, std::string>> contradictions() {
    std::vector<std::pair<Liquid::Parameters, std::string>> list(
        5, {parameters(), "Vapour Pressure"}
    );
    list[0].first.vapour_pressure = 2339.0;
    list[1].first.vapour_pressure = -50e6;
    list[2].first.vapour_pressure = 50e6;
    list[3].first.gamma = 6.0;
    list[3].second = "Gruneisen";
    list[4].first.initial_pressure = 1e20;
    list[4].second = "Initial Pressure";
    return list;
  }
};

/// Copper, as in materials/cards/copper.xml. A part from outside of the library brings its own.
template <class Part>
void set_copper(typename Part::Parameters& p) {
  Part::example(p);
}
template <>
inline void set_copper<JohnsonCookFlow>(JohnsonCookFlow::Parameters& p) {
  p.shear_modulus = 47.7e9;
  p.a = 90e6;
  p.b = 292e6;
  p.c = 0.025;
  p.n = 0.31;
  p.m = 1.09;
  p.melt_temperature = 1356.0;
}
template <>
inline void set_copper<MieGruneisen>(MieGruneisen::Parameters& p) {
  p.specific_heat = 383.0;
  p.sound_speed = 3940.0;
  p.slope = 1.489;
  p.gamma = 2.02;
}
template <class Strength, class EquationOfState, class Failure>
struct SampleOfMetal {
  using Parameters = typename Metal<Strength, EquationOfState, Failure>::Parameters;
  static constexpr double density = 8930.0, elastic = 1e-4, plastic = 2e-2, pressure = 68.95e6;
  static Parameters parameters() {
    Parameters p;
    set_copper<Strength>(p);
    set_copper<EquationOfState>(p);
    return p;
  }
  static std::vector<std::pair<Parameters, std::string>> contradictions() { return {}; }
};
template <class Strength, class EquationOfState, class Failure>
struct Sample<Metal<Strength, EquationOfState, Failure>>
    : SampleOfMetal<Strength, EquationOfState, Failure> {};
template <class Strength, class EquationOfState, class Failure>
struct Sample<Metal<Strength, EquationOfState, Voids<Failure>>>
    : SampleOfMetal<Strength, EquationOfState, Failure> {
  static auto parameters() {
    auto p = SampleOfMetal<Strength, EquationOfState, Failure>::parameters();
    p.expansion_strain = 1;
    return p;
  }
};

template <>
struct Sample<JohnsonCook> : SampleOfMetal<JohnsonCookFlow, MieGruneisen, Fracture> {
  static std::vector<std::pair<JohnsonCook::Parameters, std::string>> contradictions() {
    std::vector<std::pair<JohnsonCook::Parameters, std::string>> list(
        6, {parameters(), "Melt Temperature"}
    );
    list[0].first.melt_temperature = list[0].first.room_temperature;
    list[1].first.shear_modulus = 300e9;
    list[1].second = "Shear Modulus";
    list[2].first.a = 90e9;
    list[2].second = "A = ";
    list[3].first.spall_stress = 1.2e12;
    list[3].second = "Spall Stress";
    list[4].first.d1 = -0.5;
    list[4].second = "D1 + D2";
    list[5].first.thermal_spall = 1;
    list[5].second = "Thermal Spall";
    return list;
  }
};

template <>
struct Sample<Expanded<JohnsonCook>> : Sample<JohnsonCook> {
  static JohnsonCook::Parameters parameters() {
    JohnsonCook::Parameters p = Sample<JohnsonCook>::parameters();
    p.expansion_strain = 1;
    return p;
  }
};

/// The demonstration set of design/arenisca.md: plausible, not fitted.
template <>
struct Sample<Arenisca> {
  static constexpr double density = 2300.0, elastic = 1e-4, plastic = 2e-2, pressure = 68.95e6;
  static Arenisca::Parameters parameters() {
    Arenisca::Parameters p{};
    for (const auto& entry : Arenisca::parameter_table().numbers) {
      if (!entry.required) p.*entry.member = entry.default_value;
    }
    for (const auto& entry : Arenisca::parameter_table().choices) {
      p.*entry.member = entry.default_index;
    }
    p.PEAKI1 = 21e6;
    p.FSLOPE = 0.435;
    p.STREN = 4e8;
    p.YSLOPE = 0.02;
    p.B0 = 8e9;
    p.B1 = 28e9;
    p.B2 = 4e8;
    p.B3 = 0.0;
    p.B4 = 0.0;
    p.G0 = 8e9;
    p.p0_crush_curve = -6e8;
    p.p1_crush_curve = 1.5e-9;
    p.p3_crush_curve = 0.22;
    p.CR = 0.5;
    return p;
  }
  static std::vector<std::pair<Arenisca::Parameters, std::string>> contradictions() {
    std::vector<std::pair<Arenisca::Parameters, std::string>> list(1, {parameters(), "YSLOPE"});
    list[0].first.YSLOPE = 0.6;
    return list;
  }
};

/// The same rock, of which every piece has a strength of its own.
template <>
struct Sample<ScatteredArenisca> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() {
    Arenisca::Parameters p = Sample<Arenisca>::parameters();
    p.weibull_modulus = 6.0;
    p.weibull_reference_volume = 1e-6;
    return p;
  }
};

/// The same rock full of water.
template <>
struct Sample<WetArenisca> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() {
    Arenisca::Parameters p = Sample<Arenisca>::parameters();
    p.fluid_B0 = 2.2e9;
    p.backstress_strain = Arenisca::Parameters::poroplastic;
    return p;
  }
};

/// The same rock with overstress, of scattering strength.
template <>
struct Sample<RatedArenisca> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() {
    return rated(Sample<ScatteredArenisca>::parameters());
  }
  static Arenisca::Parameters rated(Arenisca::Parameters p) {
    p.T1_rate_dependence = 1e-5;  // T2 = 0: else its unit depends on T2
    return p;
  }
};
template <>
struct Sample<RatedWetArenisca> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() {
    return Sample<RatedArenisca>::rated(Sample<WetArenisca>::parameters());
  }
};
/// The same rock, weaker in triaxial extension than in compression.
template <>
struct Sample<AngledArenisca> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() { return angled(Sample<Arenisca>::parameters()); }
  static Arenisca::Parameters angled(Arenisca::Parameters p) {
    p.J3_type = arenisca::Lode::willam_warnke;
    p.J3_psi = 0.7;
    return p;
  }
};
template <>
struct Sample<AngledWetArenisca> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() {
    return Sample<AngledArenisca>::angled(Sample<WetArenisca>::parameters());
  }
};

/// The same rock that loses cohesion and tensile strength.
template <>
struct Sample<DamagedArenisca> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() { return damaged(Sample<Arenisca>::parameters()); }
  static Arenisca::Parameters damaged(Arenisca::Parameters p) {
    p.fracture_strain = 0.02;
    p.fracture_energy = 60.0;
    p.residual_slope = 0.3;
    p.damage_pressure = 150e6;
    p.breakage_energy = 40e6;
    p.breakage_pressure = 100e6;
    return p;
  }
  static std::vector<std::pair<Arenisca::Parameters, std::string>> contradictions() {
    using P = Arenisca::Parameters;
    std::vector<std::pair<P, std::string>> list(16, {parameters(), "Fracture strain"});
    list[0].first.fracture_strain = 0.0;
    list[0].second = "Fracture energy";
    list[1].first = Sample<Arenisca>::parameters();
    list[1].first.residual_slope = 0.3;
    list[1].second = "Residual slope";
    list[2].first = Sample<Arenisca>::parameters();
    list[2].first.damage_pressure = 150e6;
    list[2].second = "Damage pressure";
    list[3].first.PEAKI1 = 0.0;
    list[4].first.T1_rate_dependence = 1e-5;
    list[4].first.J3_type = arenisca::Lode::willam_warnke;
    list[4].first.J3_psi = 0.8;
    list[5].first.J3_type = arenisca::Lode::gudehus;
    list[5].first.J3_psi = 0.8;
    list[6].first.return_solver = 1;
    list[7].first.residual_slope = 1.1 * list[7].first.FSLOPE;
    list[7].second = "Residual slope";
    list[8].first.FSLOPE = 0.7;
    list[8].first.residual_slope = 0.6;
    list[8].second = "Residual slope";
    list[9].first.FSLOPE = 0.7;
    list[9].first.residual_slope = 0.0;
    list[9].second = "FSLOPE";
    list[10].first.residual_slope = 0.5 * list[10].first.YSLOPE;
    list[10].second = "Residual slope";
    list[11].first.fracture_energy = -1.0;
    list[11].second = "Fracture energy";
    list[12].first = Sample<Arenisca>::parameters();
    list[12].first.tension_cutoff = 3e6;
    list[12].second = "Tension cutoff";
    list[13].first.breakage_energy = 0.0;
    list[13].second = "Breakage pressure";
    for (std::size_t i = 14; i < 16; ++i) {
      list[i].first = Sample<Arenisca>::parameters();  // rock without damage
      list[i].first.breakage_energy = 40e6;
      list[i].second = "Breakage energy";
    }
    list[14].first.return_solver = 1;
    list[15].first.J3_type = arenisca::Lode::gudehus;
    list[15].first.J3_psi = 0.8;
    return list;
  }
};
template <>
struct Sample<DamagedWetArenisca> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() {
    return Sample<DamagedArenisca>::damaged(Sample<WetArenisca>::parameters());
  }
};

/// Rock with damage that heats, with a bound on its tension.
template <>
struct Sample<HeatedArenisca> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() {
    return bounded(heated(Sample<DamagedArenisca>::parameters()));
  }
  static Arenisca::Parameters bounded(Arenisca::Parameters p) {
    p.tension_cutoff = 3e6;
    return p;
  }
  static Arenisca::Parameters heated(Arenisca::Parameters p) {
    p.specific_heat = 1000.0;
    p.grueneisen = 0.7;
    p.grain_density = 2650.0;
    p.initial_temperature = 300.0;
    p.melting_temperature = 2500.0;
    return p;
  }
  static std::vector<std::pair<Arenisca::Parameters, std::string>> contradictions() {
    using P = Arenisca::Parameters;
    std::vector<std::pair<P, std::string>> list(10, {parameters(), "Specific heat"});
    list[0].first.specific_heat = 0.0;
    list[0].second = "Grueneisen parameter";
    list[1].first = Sample<Arenisca>::parameters();
    list[1].first.melting_temperature = 2000.0;
    list[1].second = "Melting temperature";
    list[2].first = Sample<Arenisca>::parameters();
    list[2].first.grain_density = 2650.0;
    list[2].second = "Grain density";
    list[3].first.grain_density = 0.0;
    list[3].second = "Grueneisen parameter";
    list[4].first.grueneisen = 0.0;
    list[4].second = "Grain density";
    list[5].first.melting_temperature = 200.0;
    list[5].second = "Melting temperature";
    for (std::size_t i = 6; i < 9; ++i)
      list[i].first = heated(Sample<Arenisca>::parameters());  // rock without damage
    list[6].first.T1_rate_dependence = 1e-5;
    list[6].first.J3_type = arenisca::Lode::willam_warnke;
    list[6].first.J3_psi = 0.8;
    list[7].first.J3_type = arenisca::Lode::gudehus;
    list[7].first.J3_psi = 0.8;
    list[8].first.return_solver = 1;
    list[9].first.specific_heat = -1.0;
    return list;
  }
};
template <>
struct Sample<HeatedWetArenisca> : Sample<Arenisca> {
  /// Grains and fluid stiffen, and grains turn into a denser phase.
  static Arenisca::Parameters parameters() {
    using S = Sample<HeatedArenisca>;
    Arenisca::Parameters p = S::bounded(S::heated(Sample<DamagedWetArenisca>::parameters()));
    p.grain_stiffening = 5.0;
    p.fluid_stiffening = 8.0;
    p.transition_strain = 0.2;
    p.transition_start = 12e9;
    p.transition_end = 35e9;
    return p;
  }
};

/// Rock with damage that heats, with overstress.
template <>
struct Sample<RatedHeatedArenisca> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() {
    return Sample<RatedArenisca>::rated(Sample<HeatedArenisca>::parameters());
  }
};
template <>
struct Sample<RatedHeatedWetArenisca> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() {
    return Sample<RatedArenisca>::rated(Sample<HeatedWetArenisca>::parameters());
  }
};

/// The same rock full of water, weaker in triaxial extension than in compression, with the
/// published backstress at the elastic centre.
template <>
struct Sample<GeneralArenisca> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() {
    Arenisca::Parameters p = Sample<WetArenisca>::parameters();
    p.backstress_strain = Arenisca::Parameters::elastic_centre;
    p.J3_type = arenisca::Lode::gudehus;
    p.J3_psi = 0.8;
    return p;
  }
  static std::vector<std::pair<Arenisca::Parameters, std::string>> contradictions() {
    std::vector<std::pair<Arenisca::Parameters, std::string>> list(11, {parameters(), "J3_psi"});
    list[0].first.J3_psi = 0.7;
    list[1].first.J3_type = arenisca::Lode::none;
    list[2].first.fluid_B0 = 0.0;
    list[2].first.fluid_pressure_initial = 1e6;
    list[2].second = "fluid_pressure_initial";
    list[3].first.fluid_B0 = 40e9;
    list[3].second = "fluid_B0";
    list[4].first.matrix_bulk_modulus = 30e9;
    list[4].second = "Matrix bulk modulus";
    list[5].first.undrained_moduli = Arenisca::arenisca3_moduli;
    list[5].second = "Undrained moduli";
    list[6].first.weibull_modulus = 6.0;
    list[6].second = "Weibull modulus";
    list[7].first.weibull_reference_volume = 1e-6;
    list[7].second = "Weibull reference volume";
    list[8].first.weibull_seed = 0.5;
    list[8].second = "Weibull seed";
    list[9].first.weibull_modulus = 6.0;
    list[9].first.weibull_reference_volume = 1e-6;
    list[9].first.PEAKI1 = 0.0;
    list[9].second = "Weibull modulus";
    list[10].first.backstress_strain = Arenisca::Parameters::poroplastic;
    list[10].first.return_solver = 1;
    list[10].second = "Return solver";
    return list;
  }
};

/// The same rock, dry or wet, with one part in place of a published one.
template <class Part, class Form>
struct Sample<ExchangedArenisca<Part, Form>> : Sample<Arenisca> {
  static Arenisca::Parameters parameters() {
    Arenisca::Parameters p =
        Form::Law::wet ? Sample<WetArenisca>::parameters() : Sample<Arenisca>::parameters();
    Part::ask(p);
    return p;
  }
};

template <class Model>
Model sample_model() {
  return Model(Sample<Model>::parameters(), Sample<Model>::density);
}

/// A point with its own state, driven by strain increments; the volume follows the trace of the
/// strain.
template <class Model>
struct Point {
  const Model& model;
  Sym3 stress{};
  typename Model::History history{};
  double volume_ratio = 1.0;
  Outcome last{};

  explicit Point(const Model& m) : model(m), history(m.initial_history()) {}

  Increment increment(const Sym3& strain, double dt) const {
    Increment i{};
    i.strain = strain;
    i.dt = dt;
    i.volume_ratio_begin = volume_ratio;
    i.volume_ratio_end = volume_ratio * std::exp(trace(strain));
    return i;
  }
  Outcome apply(const Sym3& strain, double dt, double viscous_pressure = 0.0) {
    Increment i = increment(strain, dt);
    i.viscous_pressure = viscous_pressure;
    last = model.update(i, stress, history);
    if (!last.failed()) volume_ratio = i.volume_ratio_end;
    return last;
  }
};

inline double largest_component(const Sym3& s) {
  return std::max(
      {std::fabs(s.xx),
       std::fabs(s.yy),
       std::fabs(s.zz),
       std::fabs(s.xy),
       std::fabs(s.yz),
       std::fabs(s.zx)}
  );
}

/// The sample of Arenisca, without and with water in its pores.
inline Arenisca::Parameters dry_rock() {
  return Sample<Arenisca>::parameters();
}
inline Arenisca::Parameters wet_rock() {
  Arenisca::Parameters p = dry_rock();
  p.fluid_B0 = 2.2e9;
  return p;
}

/// Largest |values - reference| over the largest |reference|.
inline double largest_difference(
    const std::vector<Sym3>& values, const std::vector<Sym3>& reference
) {
  double size = 0.0;
  double difference = 0.0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    size = std::max(size, norm(reference[i]));
    difference = std::max(difference, norm(values[i] - reference[i]));
  }
  return difference / size;
}

}  // namespace barreno::test

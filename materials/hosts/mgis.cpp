// SPDX-License-Identifier: BSD-3-Clause
// The generic behaviour interface of MFront, as the library MGIS loads it (code_aster, MFEM, FEniCS
// and others by way of it): the behaviour "Barreno" of small strains, of the card that the
// environment variable BARRENO_CARD names when the library is loaded.
//
// Structures, names of symbols and meanings of numbers are those of version 1 of that interface
// (TFEL 3.4.1 and later, MGIS 1.2.1 and later), learned from the public sources of MGIS: its
// BehaviourDataView.hxx, StateView.hxx and LibrariesManager.cxx.
#include "barreno_material.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>

namespace {

constexpr int most_variables = 64;
constexpr std::size_t message_length = 512;  // of the buffer that a host gives, at least

struct StateView {
  const double* gradients;
  double* thermodynamic_forces;
  const double* mass_density;
  const double* material_properties;
  double* internal_state_variables;
  double* stored_energy;
  double* dissipated_energy;
  const double* external_state_variables;
};

struct DataView {
  char* error_message;
  double dt;
  double* stiffness;
  double* step_factor;  ///< by which a host may multiply its next step
  double* speed_of_sound;
  StateView begin;  ///< read alone
  StateView end;
};

enum Result { failed = -1, reliable = 1 };

/// What the first number of the stiffness asks for.
struct Wish {
  int want = BARRENO_STRESS;
  bool prediction = false;  ///< the stiffness alone, and no step
  bool speed = false;
};

Wish wish_of(double word) {
  constexpr double from_here_with_speed = 50.0, speed_added = 100.0, half = 0.5, elastic = 1.5;
  Wish wish;
  wish.speed = word > from_here_with_speed;
  const double kind = wish.speed ? word - speed_added : word;
  wish.prediction = kind < -half;
  if (kind > elastic)
    wish.want = BARRENO_CONSISTENT;  // also for the secant operator
  else if (kind > half || wish.prediction)
    wish.want = BARRENO_ELASTIC;  // also for the other predictions
  return wish;
}

/// The card, opened when the library is loaded.
struct Opened {
  barreno_material* material = nullptr;
  std::string problem;
};

Opened& opened() {
  static auto& one = *new Opened;
  return one;
}

int fail(const DataView& data, const std::string& sentence) {
  if (data.error_message != nullptr)
    std::snprintf(data.error_message, message_length, "%s", sentence.c_str());
  return failed;
}

/// Shears of tensors are kept sqrt(2) times as large there, in the same order as here.
double kelvin(int i) {
  return i < 3 ? 1.0 : std::sqrt(2.0);
}

struct Point {
  std::array<double, 6> strain{}, stress{}, new_stress{};
  std::array<double, 36> tangent{};
  std::array<double, 2> work{};
  std::vector<double> state, new_state;
};

Point point_of(const DataView& data, int components, bool prediction, int variables) {
  Point point;
  for (int i = 0; i < components; ++i) {
    const auto c = static_cast<std::size_t>(i);
    point.stress[c] = data.begin.thermodynamic_forces[i] / kelvin(i);
    if (!prediction)
      point.strain[c] = (data.end.gradients[i] - data.begin.gradients[i]) / kelvin(i);
  }
  const double* const old = data.begin.internal_state_variables;
  point.state.assign(old, old + variables);
  point.new_state = point.state;
  return point;
}

void put_stiffness(const Point& point, int components, double* stiffness) {
  for (int i = 0; i < components; ++i) {
    for (int j = 0; j < components; ++j) {
      const double* const row = point.tangent.data() + 6 * i;
      stiffness[components * i + j] = kelvin(i) * kelvin(j) * row[j];
    }
  }
}

void put_state(const Point& point, int components, const DataView& data) {
  for (int i = 0; i < components; ++i) {
    data.end.thermodynamic_forces[i] = kelvin(i) * point.new_stress[static_cast<std::size_t>(i)];
  }
  std::copy(point.new_state.begin(), point.new_state.end(), data.end.internal_state_variables);
  if (data.end.stored_energy != nullptr && data.begin.stored_energy != nullptr)
    *data.end.stored_energy = *data.begin.stored_energy + point.work[0];
  if (data.end.dissipated_energy != nullptr && data.begin.dissipated_energy != nullptr)
    *data.end.dissipated_energy = *data.begin.dissipated_energy + point.work[1];
}

/// @param components  6, or 4 without the shears 13 and 23
int integrate(DataView& data, int components) {
  const Opened& card = opened();
  if (card.material == nullptr) return fail(data, card.problem);
  const Wish wish = wish_of(data.stiffness[0]);
  Point point =
      point_of(data, components, wish.prediction, barreno_material_state_count(card.material));
  barreno_batch batch{};
  batch.count = 1;
  batch.want = wish.want;
  batch.time_increment = wish.prediction ? 0.0 : data.dt;
  batch.strain_increment = point.strain.data();
  batch.stress_old = point.stress.data();
  batch.stress_new = point.new_stress.data();
  batch.state_old = point.state.data();
  batch.state_new = point.new_state.data();
  batch.tangent = wish.want == BARRENO_STRESS ? nullptr : point.tangent.data();
  batch.work = point.work.data();
  if (barreno_material_update(card.material, &batch) != 0) {
    constexpr double retry = 0.25;
    if (data.step_factor != nullptr) *data.step_factor = retry;
    return fail(data, barreno_last_error());
  }
  if (wish.want != BARRENO_STRESS) put_stiffness(point, components, data.stiffness);
  if (wish.speed && data.speed_of_sound != nullptr) {
    const double modulus = barreno_material_longitudinal_modulus(
        card.material, point.new_stress.data(), point.new_state.data()
    );
    *data.speed_of_sound = std::sqrt(modulus / barreno_material_density(card.material));
  }
  if (!wish.prediction) put_state(point, components, data);
  return reliable;
}

}  // namespace

// Names are those that the host looks up.
// NOLINTBEGIN(readability-identifier-naming,modernize-avoid-c-arrays,cppcoreguidelines-*)
extern "C" {

const char* Barreno_mfront_ept = "Barreno";
const char* Barreno_mfront_interface = "Generic";
const char* Barreno_tfel_version = "";
const char* Barreno_unit_system = "SI";
const char* Barreno_src = "";
unsigned short Barreno_api_version = 1;
unsigned short Barreno_mfront_mkt = 1;          // a behaviour
unsigned short Barreno_BehaviourType = 1;       // of strain
unsigned short Barreno_BehaviourKinematic = 1;  // small
unsigned short Barreno_SymmetryType = 0;
unsigned short Barreno_ElasticSymmetryType = 0;
unsigned short Barreno_requiresStiffnessTensor = 0;
unsigned short Barreno_requiresThermalExpansionCoefficientTensor = 0;
unsigned short Barreno_ComputesInternalEnergy = 1;
unsigned short Barreno_ComputesDissipatedEnergy = 1;
unsigned short Barreno_UsableInPurelyImplicitResolution = 1;
unsigned short Barreno_TemperatureRemovedFromExternalStateVariables = 0;
unsigned short Barreno_nModellingHypotheses = 4;
const char* Barreno_ModellingHypotheses[] = {
    "Tridimensional", "PlaneStrain", "GeneralisedPlaneStrain", "Axisymmetrical"};
unsigned short Barreno_nMainVariables = 1;
unsigned short Barreno_nGradients = 1;
int Barreno_GradientsTypes[] = {1};  // a symmetric tensor
const char* Barreno_Gradients[] = {"Strain"};
unsigned short Barreno_nThermodynamicForces = 1;
int Barreno_ThermodynamicForcesTypes[] = {1};
const char* Barreno_ThermodynamicForces[] = {"Stress"};
unsigned short Barreno_nTangentOperatorBlocks = 2;
const char* Barreno_TangentOperatorBlocks[] = {"Stress", "Strain"};
unsigned short Barreno_nMaterialProperties = 0;
unsigned short Barreno_nExternalStateVariables = 0;
unsigned short Barreno_nParameters = 0;
unsigned short Barreno_nInitializeFunctions = 0;
unsigned short Barreno_nPostProcessings = 0;
// Those of the card; scalars all.
unsigned short Barreno_nInternalStateVariables = 0;
const char* Barreno_InternalStateVariables[most_variables] = {};
int Barreno_InternalStateVariablesTypes[most_variables] = {};
int Barreno_ParametersTypes[1] = {0};

int Barreno_Tridimensional(DataView* data) {
  return integrate(*data, 6);
}
int Barreno_PlaneStrain(DataView* data) {
  return integrate(*data, 4);
}
int Barreno_GeneralisedPlaneStrain(DataView* data) {
  return integrate(*data, 4);
}
int Barreno_Axisymmetrical(DataView* data) {
  return integrate(*data, 4);
}

}  // extern "C"

namespace {

/// A host reads the names before it calls anything.
__attribute__((constructor)) void open_card() {
  Opened& card = opened();
  const char* const name = std::getenv("BARRENO_CARD");
  if (name == nullptr) {
    card.problem =
        "no card is chosen; name it in the environment variable BARRENO_CARD before the library is "
        "loaded.";
    return;
  }
  barreno_material* const material = barreno_material_open(name);
  const int count = material == nullptr ? 0 : barreno_material_state_count(material);
  if (material == nullptr || count > most_variables) {
    card.problem = material == nullptr
                       ? "BARRENO_CARD: " + std::string(barreno_last_error())
                       : "BARRENO_CARD: the card has more state variables than there is room for.";
    return;
  }
  card.material = material;
  Barreno_src = barreno_material_file(material);
  Barreno_nInternalStateVariables = static_cast<unsigned short>(count);
  for (int i = 0; i < count; ++i)
    Barreno_InternalStateVariables[i] = barreno_material_state_name(material, i);
}

}  // namespace
// NOLINTEND(readability-identifier-naming,modernize-avoid-c-arrays,cppcoreguidelines-*)

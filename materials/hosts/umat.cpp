// SPDX-License-Identifier: BSD-3-Clause
// UMAT: the subroutine of implicit codes (Abaqus/Standard, CalculiX), one point per call. Component
// order 11 22 33 12 13 23 as in barreno_material.h, engineering shears.
#include "host_material.hpp"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <vector>

namespace {

constexpr double half = 0.5;
constexpr int tensor_size = 6;

/// NTENS = 6: solids; 4: plane strain and axisymmetry (11 22 33 12).
void check_components(int ndi, int nshr, int ntens) {
  const bool known = ndi == 3 && (nshr == 3 || nshr == 1) && ntens == ndi + nshr;
  if (known) return;
  barreno::hosts::stop(
      "an element has " + std::to_string(ndi) + " direct and " + std::to_string(nshr) +
      " shear components, but this material supports only solid, plane strain and axisymmetric "
      "elements (3 direct, 3 or 1 shear)."
  );
}

/// State variables that are the first of a tensor's six, NAME_xx to NAME_zx, and must turn.
std::vector<int> tensors_of(const barreno_material* material) {
  std::vector<int> first;
  for (int i = 0; i < barreno_material_state_count(material); ++i) {
    const std::string name = barreno_material_state_name(material, i);
    if (name.size() > 3 && name.compare(name.size() - 3, 3, "_xx") == 0) first.push_back(i);
  }
  return first;
}

/// The same, found once per material and thread.
const std::vector<int>& known_tensors_of(const barreno_material* material) {
  thread_local const barreno_material* last = nullptr;
  thread_local std::vector<int> first;
  if (material != last) first = tensors_of(material);
  last = material;
  return first;
}

/// Stops the job unless R R^T = I, to the digits that a host's rotation has.
void check_rotation(const barreno_material* material, const double* r) {
  constexpr double round_off = 1e-6;
  double worst = 0.0;
  for (int i = 0; i < 3; ++i) {
    for (int j = 0; j < 3; ++j) {
      double product = i == j ? -1.0 : 0.0;
      for (int k = 0; k < 3; ++k) product += r[i + 3 * k] * r[j + 3 * k];
      worst = std::fabs(product) <= worst ? worst : std::fabs(product);
    }
  }
  if (worst <= round_off) return;
  barreno::hosts::stop(
      std::string(barreno_material_file(material)) +
      ": the host's DROT is not a rotation, but the tensors among the state variables (" +
      barreno_material_state_name(material, known_tensors_of(material).front()) +
      " and the like) have to turn with it; hand over the rotation of the increment, which is the "
      "unit matrix for small strains."
  );
}

/// o <- R o R^T. R is stored by columns, the tensor o as xx yy zz xy yz zx.
void rotate(const double* r, double* o) {
  constexpr int row[tensor_size] = {0, 1, 2, 0, 1, 2}, column[tensor_size] = {0, 1, 2, 1, 2, 0};
  constexpr int at[3][3] = {{0, 3, 5}, {3, 1, 4}, {5, 4, 2}};
  double turned[tensor_size];
  for (int c = 0; c < tensor_size; ++c) {
    turned[c] = 0.0;
    for (int k = 0; k < 3; ++k) {
      for (int l = 0; l < 3; ++l)
        turned[c] += r[row[c] + 3 * k] * o[at[k][l]] * r[column[c] + 3 * l];
    }
  }
  std::copy(turned, turned + tensor_size, o);
}

/// The frame in which a host hands strains over and keeps stresses.
enum class Frame {
  space,     ///< stress and tensors of the state turn with DROT
  material,  ///< the host has taken the rotation out: nothing turns
};

/// CalculiX has two interfaces for a material of this kind, told by its name. @ABAQUS_ passes
/// Green's strain and the second Piola-Kirchhoff stress, which are those of small strains only
/// where NLGEOM is off; @ABAQUSNL_ passes ln U and R^T sigma R (and a DROT that nothing needs),
/// which it makes of Green's strain, so only where NLGEOM is on. KSTEP has four entries there, of
/// which the third is 1 with NLGEOM, except in the linear prediction of a step, where the strains
/// do not change (umat_abaqus.f, umat_abaqusnl.f, calctotstrain.f, nonlingeo.c of CalculiX 2.20).
Frame frame_of(const char* name, const int* kstep, const double* dstran) {
  constexpr double no_change = 1e-12;
  const auto begins = [&](const char* word) {
    return name != nullptr && std::strncmp(name, word, std::strlen(word)) == 0;
  };
  if (begins("@ABAQUS_") && kstep[2] == 1) {
    barreno::hosts::stop(
        "the step has NLGEOM, but the material's name begins with @ABAQUS_, to which CalculiX "
        "passes Green's strain and the second Piola-Kirchhoff stress instead of logarithmic "
        "strain and Cauchy stress; write @ABAQUSNL_ in *MATERIAL and *SOLID SECTION, or take "
        "NLGEOM out."
    );
  }
  if (!begins("@ABAQUSNL_")) return Frame::space;
  double change = 0.0;
  for (int i = 0; i < tensor_size; ++i) change = std::fmax(change, std::fabs(dstran[i]));
  if (kstep[2] != 1 && change > no_change) {
    barreno::hosts::stop(
        "the material's name begins with @ABAQUSNL_, but the step has no NLGEOM, without which "
        "CalculiX passes wrong strains to it; write *STEP,NLGEOM, or @ABAQUS_ for small strains."
    );
  }
  return Frame::material;
}

/// A point that failed asks for a quarter of the step; one that no step cures stops the job.
void ask_for_less(
    const barreno_material* material, const double* stress, const double* state, double* pnewdt
) {
  const std::string sentence = barreno_last_error();
  if (barreno_material_longitudinal_modulus(material, stress, state) == 0.0)
    barreno::hosts::stop(sentence);
  constexpr double retry = 0.25;
  *pnewdt = retry;
}

}  // namespace

extern "C" {

/// The list of arguments of Abaqus/Standard. Stress, state and DDSDDE are updated; a point that
/// fails keeps its stress and state, and asks for a quarter of the step by PNEWDT. STRESS comes
/// rotated to the end of the increment; tensors of the state are turned here by DROT, except where
/// CalculiX has taken the rotation out.
void UMAT(  // NOLINT(readability-function-size,readability-identifier-naming)
    double* stress,
    double* statev,
    double* ddsdde,
    double* sse,
    double* spd,
    double* /*scd*/,
    double* /*rpl*/,
    double* /*ddsddt*/,
    double* /*drplde*/,
    double* /*drpldt*/,
    const double* /*stran*/,
    const double* dstran,
    const double* /*time*/,
    const double* dtime,
    const double* /*temp*/,
    const double* /*dtemp*/,
    const double* /*predef*/,
    const double* /*dpred*/,
    const char* cmname,
    const int* ndi,
    const int* nshr,
    const int* ntens,
    const int* nstatv,
    const double* props,
    const int* nprops,
    const double* /*coords*/,
    const double* drot,
    double* pnewdt,
    const double* /*celent*/,
    const double* /*dfgrd0*/,
    const double* /*dfgrd1*/,
    const int* /*noel*/,
    const int* /*npt*/,
    const int* /*layer*/,
    const int* /*kspt*/,
    const int* kstep,
    const int* /*kinc*/
) {
  const barreno_material* material = barreno::hosts::material_of(cmname);
  barreno::hosts::check_deck(material, *nstatv, *nprops, props);
  check_components(*ndi, *nshr, *ntens);
  const int n = *ntens;
  double strain[6] = {}, old_stress[6] = {}, new_stress[6], tangent[36], work[2];
  for (int i = 0; i < n; ++i) {
    strain[i] = (i < 3 ? 1.0 : half) * dstran[i];
    old_stress[i] = stress[i];
  }
  const std::vector<int>& tensors = known_tensors_of(material);
  const bool turns =
      frame_of(cmname, kstep, dstran) == Frame::space && drot != nullptr && !tensors.empty();
  std::vector<double> unturned;
  if (turns) {
    check_rotation(material, drot);
    unturned.assign(statev, statev + *nstatv);
    for (const int first : tensors) rotate(drot, statev + first);
  }
  barreno_batch batch{};
  batch.count = 1;
  batch.want = BARRENO_CONSISTENT;
  batch.time_increment = *dtime;
  batch.strain_increment = strain;
  batch.stress_old = old_stress;
  batch.stress_new = new_stress;
  batch.state_old = statev;
  batch.state_new = statev;
  batch.tangent = tangent;
  batch.work = work;
  if (barreno_material_update(material, &batch) != 0) {
    ask_for_less(material, old_stress, statev, pnewdt);
    if (turns) std::copy(unturned.begin(), unturned.end(), statev);
  }
  std::copy(new_stress, new_stress + n, stress);
  // DDSDDE is stored by columns: (i, j) is d stress_i / d strain_j.
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) ddsdde[i + n * j] = tangent[6 * i + j];
  }
  if (sse != nullptr) *sse += work[0];
  if (spd != nullptr) *spd += work[1];
}

}  // extern "C"

// SPDX-License-Identifier: BSD-3-Clause
// UMAT: the subroutine of implicit codes (Abaqus/Standard, CalculiX), one point per call. Component
// order 11 22 33 12 13 23 as in barreno_material.h, engineering shears.
#include "host_material.hpp"

#include <algorithm>

namespace {

constexpr double half = 0.5;

/// NTENS = 6: solids; 4: plane strain and axisymmetry (11 22 33 12).
void check_components(int ndi, int nshr, int ntens) {
  const bool known = ndi == 3 && (nshr == 3 || nshr == 1) && ntens == ndi + nshr;
  if (known) return;
  barreno::hosts::stop(
      "an element has " + std::to_string(ndi) + " direct and " + std::to_string(nshr) +
      " shear components, but this material serves solid, plane strain and axisymmetric elements "
      "only (3 direct, 3 or 1 shear)."
  );
}

}  // namespace

extern "C" {

/// The list of arguments of Abaqus/Standard. Stress, state and DDSDDE are updated; a point that
/// fails keeps its stress and state, and asks for a quarter of the step by PNEWDT.
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
    const double* /*drot*/,
    double* pnewdt,
    const double* /*celent*/,
    const double* /*dfgrd0*/,
    const double* /*dfgrd1*/,
    const int* /*noel*/,
    const int* /*npt*/,
    const int* /*layer*/,
    const int* /*kspt*/,
    const int* /*kstep*/,
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
    constexpr double retry = 0.25;
    *pnewdt = retry;
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

// SPDX-License-Identifier: BSD-3-Clause
// VUMAT: the subroutine of explicit codes (Abaqus/Explicit, Sierra, Uintah), blocks of points,
// arrays by component: value c of point k is a[k + nblock * c]. Component order 11 22 33 12 23 31,
// tensor shears.
#include "host_material.hpp"

#include <atomic>
#include <cstddef>
#include <cstdio>
#include <vector>

namespace {

/// Component of barreno_material.h (11 22 33 12 13 23) of each of VUMAT's.
constexpr int component[6] = {0, 1, 2, 3, 5, 4};

/// A block by point, as the library takes it.
struct Block {
  std::size_t points, shears, states;
  std::vector<double> strain, stress, state, tangent, work;
  std::vector<int> status;

  Block(int nblock, int nshr, int nstatev)
      : points(static_cast<std::size_t>(nblock)),
        shears(static_cast<std::size_t>(nshr)),
        states(static_cast<std::size_t>(nstatev)),
        strain(6 * points),
        stress(6 * points),
        state(states * points),
        work(2 * points),
        status(points) {}

  void gather(const double* strain_inc, const double* stress_old, const double* state_old) {
    for (std::size_t k = 0; k < points; ++k) {
      for (std::size_t c = 0; c < 3 + shears; ++c) {
        const std::size_t to = 6 * k + static_cast<std::size_t>(component[c]);
        strain[to] = strain_inc[k + points * c];
        stress[to] = stress_old[k + points * c];
      }
      for (std::size_t s = 0; s < states; ++s) state[states * k + s] = state_old[k + points * s];
    }
  }
  void scatter(double* stress_new, double* state_new) const {
    for (std::size_t k = 0; k < points; ++k) {
      for (std::size_t c = 0; c < 3 + shears; ++c)
        stress_new[k + points * c] = stress[6 * k + static_cast<std::size_t>(component[c])];
      for (std::size_t s = 0; s < states; ++s) state_new[k + points * s] = state[states * k + s];
    }
  }
  barreno_batch batch(double dt) {
    barreno_batch b{};
    b.count = static_cast<int>(points);
    b.time_increment = dt;
    b.strain_increment = strain.data();
    b.stress_old = stress.data();
    b.stress_new = stress.data();
    b.state_old = state.data();
    b.state_new = state.data();
    b.work = work.data();
    b.status = status.data();
    return b;
  }
};

/// The data check, a call with made-up strains before the first step: an elastic answer, from which
/// the host takes wave speeds; the points stay virgin.
void answer_elastically(const barreno_material* material, Block& block) {
  std::vector<double> none(6 * block.points, 0.0), stress(6 * block.points),
      state(block.state.size());
  block.tangent.resize(36 * block.points);
  barreno_batch b = block.batch(0.0);
  b.want = BARRENO_ELASTIC;
  b.strain_increment = none.data();
  b.stress_new = stress.data();
  b.state_new = state.data();
  b.tangent = block.tangent.data();
  barreno_material_update(material, &b);
  for (std::size_t k = 0; k < block.points; ++k) {
    for (std::size_t i = 0; i < 6; ++i) {
      for (std::size_t j = 0; j < 6; ++j) {
        const double gamma = (j < 3 ? 1.0 : 2.0) * block.strain[6 * k + j];
        block.stress[6 * k + i] += block.tangent[36 * k + 6 * i + j] * gamma;
      }
    }
  }
}

/// An explicit code cannot take a step back: a point that fails keeps its stress, which is said;
/// one with values that are not finite ends the job.
void report_failures(const barreno_material* material, const Block& block, int failed) {
  static std::atomic<int> said{0};
  constexpr int most = 10;
  const std::string sentence = barreno_last_error();
  for (const int status : block.status) {
    if (status == BARRENO_BAD_INPUT) barreno::hosts::stop(sentence);
  }
  if (said.fetch_add(1) >= most) return;
  std::fprintf(
      stderr,
      " *WARNING in barreno: %s: %d points of a block keep their stress (%s)\n",
      barreno_material_file(material),
      failed,
      sentence.c_str()
  );
}

/// Energies per mass at the end of the step, where the host keeps them.
void add_energies(
    const Block& block,
    double density,
    const double* internal_old,
    const double* plastic_old,
    double* internal_new,
    double* plastic_new
) {
  for (std::size_t k = 0; k < block.points; ++k) {
    const double elastic = block.work[2 * k] / density, plastic = block.work[2 * k + 1] / density;
    if (internal_old && internal_new) internal_new[k] = internal_old[k] + elastic + plastic;
    if (plastic_old && plastic_new) plastic_new[k] = plastic_old[k] + plastic;
  }
}

}  // namespace

extern "C" {

/// The list of arguments of Abaqus/Explicit in double precision; what is not used may be null.
void VUMAT(  // NOLINT(readability-function-size,readability-identifier-naming)
    const int* nblock,
    const int* ndir,
    const int* nshr,
    const int* nstatev,
    const int* /*nfieldv*/,
    const int* nprops,
    const int* /*lanneal*/,
    const double* step_time,
    const double* total_time,
    const double* dt,
    const char* cmname,
    const double* /*coordMp*/,
    const double* /*charLength*/,
    const double* props,
    const double* /*density*/,
    const double* strain_inc,
    const double* /*relSpinInc*/,
    const double* /*tempOld*/,
    const double* /*stretchOld*/,
    const double* /*defgradOld*/,
    const double* /*fieldOld*/,
    const double* stress_old,
    const double* state_old,
    const double* internal_old,
    const double* plastic_old,
    const double* /*tempNew*/,
    const double* /*stretchNew*/,
    const double* /*defgradNew*/,
    const double* /*fieldNew*/,
    double* stress_new,
    double* state_new,
    double* internal_new,
    double* plastic_new
) {
  const barreno_material* material = barreno::hosts::material_of(cmname);
  barreno::hosts::check_deck(material, *nstatev, nprops != nullptr ? *nprops : 0, props);
  if (*ndir != 3 || (*nshr != 3 && *nshr != 1)) {
    barreno::hosts::stop(
        "an element has " + std::to_string(*ndir) + " direct and " + std::to_string(*nshr) +
        " shear components, but this material supports only solid, plane strain and axisymmetric "
        "elements (3 direct, 3 or 1 shear)."
    );
  }
  Block block(*nblock, *nshr, *nstatev);
  block.gather(strain_inc, stress_old, state_old);
  const bool data_check =
      total_time != nullptr && step_time != nullptr && *total_time == 0.0 && *step_time == 0.0;
  if (data_check) {
    answer_elastically(material, block);
  } else {
    const barreno_batch b = block.batch(dt != nullptr ? *dt : 0.0);
    const int failed = barreno_material_update(material, &b);
    if (failed != 0) report_failures(material, block, failed);
  }
  block.scatter(stress_new, state_new);
  add_energies(
      block,
      barreno_material_density(material),
      internal_old,
      plastic_old,
      internal_new,
      plastic_new
  );
}

}  // extern "C"

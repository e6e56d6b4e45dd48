// SPDX-License-Identifier: BSD-3-Clause
// The C interface: one template over models.hpp, and nothing that throws across the boundary.
#include "barreno/find_card.hpp"
#include "barreno/input/units.hpp"
#include "barreno/models.hpp"
#include "barreno/registry.hpp"
#include "barreno_material.h"
#include "step_point.hpp"

#include <cstdio>
#include <exception>
#include <string>
#include <variant>
#include <vector>

using namespace barreno;
using namespace barreno::c_interface;

namespace barreno::c_interface {

/// follow_path.cpp
int follow_all(const barreno_material* material, const barreno_path& path);

struct StateVariable {
  std::string name, unit, meaning;
  double initial;
};

}  // namespace barreno::c_interface

namespace {

/// Text of the last error of a thread; an array, because it must outlive every destructor.
thread_local char last_error[2000] = "";

void set_error(const std::string& sentence) {
  std::snprintf(last_error, sizeof last_error, "%s", sentence.c_str());
}

/// f(), or `otherwise` and its text when it throws.
template <class Result, class F>
Result guarded(Result otherwise, const F& f) noexcept {
  try {
    return f();
  } catch (const std::exception& error) {
    std::snprintf(last_error, sizeof last_error, "%s", error.what());
  } catch (...) {
    std::snprintf(
        last_error, sizeof last_error, "an internal error without text; please report it."
    );
  }
  return otherwise;
}

template <class Model>
std::vector<StateVariable> state_variables(const Model& model) {
  std::vector<StateVariable> variables{
      {"initialized", "", "0: virgin, the library fills in the state; 1: state as it stands", 1.0},
      {"volume_ratio", "", "current over reference volume", 1.0}};
  HostPoint<Model> point;
  point.history = model.initial_history();
  double state[static_cast<std::size_t>(state_count<Model>())];
  write_state(point, state);
  int slot = first_of_history;
  for (const HistoryField& field : Model::history_table()) {
    variables.push_back(
        {field.name, input::si_unit_of(field.dimension), field.meaning, state[slot++]}
    );
  }
  return variables;
}

const char* reason(Status status) {
  switch (status) {
    case Status::ok:
      return "is sound";
    case Status::substep_limit:
      return "needs more substeps than are allowed; try a smaller step";
    case Status::not_converged:
      return "did not converge; try a smaller step";
    case Status::bad_input:
      break;
  }
  return "has an impossible step or state (not finite, too large, or a volume ratio, "
         "`initialized` or initial stress out of range); check what the host passed";
}

/// The same where the start of the point tells more.
template <class Model>
std::string reason(const Model& model, Status status, const double* stress, const double* state) {
  if (status != Status::bad_input || !lacks_initial_stress(model, stress, state))
    return reason(status);
  char text[400];
  std::snprintf(
      text,
      sizeof text,
      "starts unstressed, but the card's fluid_pressure_initial = %.6g Pa fills its pores (the "
      "rock would be torn apart); give the initial stress of rock and fluid together, -%.6g Pa in "
      "each direction if the rock carries no stress, or set fluid_pressure_initial to 0",
      virgin_pressure(model, 0),
      virgin_pressure(model, 0)
  );
  return text;
}

/// Advances a batch of one model; how many points failed.
template <class Model>
int step_points(const Model& model, const std::string& file, const barreno_batch& b) {
  constexpr int n = state_count<Model>();
  int failed = 0;
  for (int i = 0; i < b.count; ++i) {
    const std::ptrdiff_t k = i;
    const bool tangent = b.want != BARRENO_STRESS;
    const PointArrays arrays{
        b.strain_increment + 6 * k,
        b.stress_old + 6 * k,
        b.state_old + n * k,
        b.stress_new + 6 * k,
        b.state_new + n * k,
        tangent ? b.tangent + 36 * k : nullptr,
        b.work != nullptr ? b.work + 2 * k : nullptr};
    const Status status = step_point(model, b.time_increment, b.want, arrays);
    if (b.status != nullptr) b.status[i] = static_cast<int>(status);
    if (status == Status::ok) continue;
    if (failed++ > 0) continue;
    // Arrays that are old and new at once hold the old values of a point that failed.
    std::string sentence = file;
    sentence.append(": point ").append(std::to_string(i)).append(" of the batch ");
    sentence.append(reason(model, status, arrays.stress_old, arrays.state_old)).append(".");
    set_error(sentence);
  }
  return failed;
}

/// What makes a call impossible to serve; empty if nothing does.
std::string problem_of(const barreno_material* material, const barreno_batch* b) {
  if (material == nullptr || b == nullptr)
    return "the material or the batch is NULL (was the card opened?).";
  if (b->count < 0) return "the batch has " + std::to_string(b->count) + " points; give 0 or more.";
  if (b->want < BARRENO_STRESS || b->want > BARRENO_CONSISTENT)
    return "want = " + std::to_string(b->want) + " is not in enum barreno_want; give 0, 1 or 2.";
  if (b->count == 0) return {};
  if (!b->strain_increment || !b->stress_old || !b->stress_new || !b->state_old || !b->state_new)
    return "an array of the batch is NULL; give strain_increment, stress and state, old and new.";
  if (b->want != BARRENO_STRESS && !b->tangent)
    return "a tangent is wanted, but its array is NULL; give one, or want = BARRENO_STRESS.";
  return {};
}

/// The same of a path.
std::string problem_of(const barreno_material* material, const barreno_path* p) {
  if (material == nullptr || p == nullptr)
    return "the material or the path is NULL (was the card opened?).";
  if (p->count < 0 || p->steps < 0)
    return "the path has " + std::to_string(p->count) + " points and " + std::to_string(p->steps) +
           " steps; give 0 or more of each.";
  if (p->count == 0 || p->steps == 0) return {};
  if (!p->strain_increment || !p->stress_wanted || !p->stress_old || !p->state_old ||
      !p->strain_taken || !p->stress || !p->state_new)
    return "an array of the path is NULL; give strains and stresses, wanted and taken, and states.";
  return {};
}

}  // namespace

struct barreno_material {
  Material material;
  std::string file, model;
  std::vector<StateVariable> state;
};

namespace {
const StateVariable* variable(const barreno_material* m, int index) {
  const bool known = m != nullptr && index >= 0 && index < static_cast<int>(m->state.size());
  return known ? &m->state[static_cast<std::size_t>(index)] : nullptr;
}
}  // namespace

extern "C" {

int barreno_abi_version(void) {
  return BARRENO_ABI_VERSION;
}
const char* barreno_version(void) {
  return BARRENO_MATERIALS_VERSION;
}
const char* barreno_last_error(void) {
  return last_error;
}

barreno_material* barreno_material_open(const char* card) {
  return guarded<barreno_material*>(nullptr, [&]() -> barreno_material* {
    const std::string file = named_card(card != nullptr ? card : "");
    Material material = read_card(file);
    const auto describe = [](const auto& model) {
      using Model = std::decay_t<decltype(model)>;
      return std::make_pair(std::string(Model::name), state_variables(model));
    };
    auto [name, state] = std::visit(describe, material.model);
    return new barreno_material{std::move(material), file, std::move(name), std::move(state)};
  });
}

void barreno_material_close(barreno_material* material) {
  delete material;
}

const char* barreno_material_model(const barreno_material* m) {
  return m != nullptr ? m->model.c_str() : "";
}
const char* barreno_material_file(const barreno_material* m) {
  return m != nullptr ? m->file.c_str() : "";
}
double barreno_material_density(const barreno_material* m) {
  return m != nullptr ? m->material.density : 0.0;
}
int barreno_material_state_count(const barreno_material* m) {
  return m != nullptr ? static_cast<int>(m->state.size()) : 0;
}
const char* barreno_material_state_name(const barreno_material* m, int index) {
  const StateVariable* v = variable(m, index);
  return v != nullptr ? v->name.c_str() : nullptr;
}
const char* barreno_material_state_unit(const barreno_material* m, int index) {
  const StateVariable* v = variable(m, index);
  return v != nullptr ? v->unit.c_str() : nullptr;
}
const char* barreno_material_state_meaning(const barreno_material* m, int index) {
  const StateVariable* v = variable(m, index);
  return v != nullptr ? v->meaning.c_str() : nullptr;
}
double barreno_material_state_initial(const barreno_material* m, int index) {
  const StateVariable* v = variable(m, index);
  return v != nullptr ? v->initial : 0.0;
}

double barreno_material_longitudinal_modulus(
    const barreno_material* m, const double* stress, const double* state
) {
  if (m == nullptr || stress == nullptr || state == nullptr) return 0.0;
  return guarded(0.0, [&] {
    const auto modulus = [&](const auto& model) {
      HostPoint<std::decay_t<decltype(model)>> point;
      if (!read_point(model, stress, state, point)) return 0.0;
      const double value = model.longitudinal_modulus(point.stress, point.history, point.ratio);
      return std::isfinite(value) && value > 0.0 ? value : 0.0;
    };
    return std::visit(modulus, m->material.model);
  });
}

int barreno_material_update(const barreno_material* m, const barreno_batch* batch) {
  return guarded(-1, [&] {
    const std::string problem = problem_of(m, batch);
    if (!problem.empty()) {
      set_error(problem);
      return -1;
    }
    const auto step = [&](const auto& model) { return step_points(model, m->file, *batch); };
    return std::visit(step, m->material.model);
  });
}

int barreno_material_follow(const barreno_material* m, const barreno_path* path) {
  return guarded(-1, [&] {
    const std::string problem = problem_of(m, path);
    if (problem.empty()) return follow_all(m, *path);
    set_error(problem);
    return -1;
  });
}

}  // extern "C"

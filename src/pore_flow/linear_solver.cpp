// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/linear_solver.hpp"

#include "base/region.hpp"
#include "deck/sections/pore_flow_section.hpp"
#include "pore_flow/multigrid.hpp"

#include <BelosLinearProblem.hpp>
#include <BelosSolverFactory.hpp>
#include <BelosTpetraAdapter.hpp>
#include <Ifpack2_Factory.hpp>
#include <Ifpack2_Preconditioner.hpp>
#include <Tpetra_CrsMatrix.hpp>
#include <Tpetra_Map.hpp>
#include <Tpetra_MultiVector.hpp>

#include <algorithm>
#include <stdexcept>
#include <utility>

namespace barreno {
namespace {

using Map = Tpetra::Map<int, long long>;
using Vectors = Tpetra::MultiVector<double, int, long long>;
using RowMatrix = Tpetra::RowMatrix<double, int, long long>;
using Problem = Belos::LinearProblem<double, Vectors, SparseOperator>;
using Krylov = Belos::SolverManager<double, Vectors, SparseOperator>;
using Relaxation = Ifpack2::Preconditioner<double, int, long long>;

/// Below fewest_cells_for_multigrid in all, or so much flow to neighbours over what is stored (2 d
/// c dt/h^2 of a uniform rock in d dimensions), a smoother is cheaper than grids
/// (docs/performance.md).
constexpr double min_flow_for_multigrid = 500.0;

}  // namespace

struct LinearSolver {
  Teuchos::RCP<const Teuchos::Comm<int>> comm;
  Teuchos::ParameterList belos, ifpack2, muelu;
  std::string krylov = "CG";
  double tolerance = default_solver_tolerance;

  Teuchos::RCP<const Map> map;
  Teuchos::RCP<SparseMatrix> matrix;
  Teuchos::RCP<SparseOperator> preconditioner;
  bool with_multigrid = false;
  double flow_over_storage = 0.0;
  Teuchos::RCP<Vectors> x, b, residual, change, row_sums;
};

namespace {

/// The matrix with a new graph; what depended on the old one is forgotten.
void build_matrix(const LinearSystem& system, LinearSolver& solver) {
  const Region region("build_matrix");
  const auto count = static_cast<int>(system.ids.size());
  solver.map = Teuchos::rcp(new Map(
      Teuchos::OrdinalTraits<Tpetra::global_size_t>::invalid(),
      Teuchos::ArrayView<const long long>(system.ids.data(), count),
      0,
      solver.comm
  ));
  std::size_t most = 0;
  for (std::size_t i = 0; i < system.ids.size(); ++i)
    most = std::max(most, system.begin[i + 1] - system.begin[i]);
  solver.matrix = Teuchos::rcp(new SparseMatrix(solver.map, most));
  for (std::size_t i = 0; i < system.ids.size(); ++i) {
    const auto entries = static_cast<int>(system.begin[i + 1] - system.begin[i]);
    solver.matrix->insertGlobalValues(
        system.ids[i], entries, &system.value[system.begin[i]], &system.column[system.begin[i]]
    );
  }
  solver.matrix->fillComplete();
  solver.preconditioner = Teuchos::null;
  solver.x = Teuchos::rcp(new Vectors(solver.map, 1));
  solver.b = Teuchos::rcp(new Vectors(solver.map, 1));
  for (auto* v : {&solver.residual, &solver.change, &solver.row_sums})
    *v = Teuchos::rcp(new Vectors(solver.map, 1));
}

/// New values in the old graph.
void refill_matrix(const LinearSystem& system, LinearSolver& solver) {
  const Region region("refill_matrix");
  solver.matrix->resumeFill();
  for (std::size_t i = 0; i < system.ids.size(); ++i) {
    const auto entries = static_cast<int>(system.begin[i + 1] - system.begin[i]);
    const int replaced = solver.matrix->replaceGlobalValues(
        system.ids[i], entries, &system.value[system.begin[i]], &system.column[system.begin[i]]
    );
    if (replaced != entries) throw std::logic_error("a link of pore cells that the graph lacks");
  }
  solver.matrix->fillComplete();
}

/// The deck's own list decides; else what is cheaper.
bool wants_multigrid(const LinearSolver& solver) {
  if (solver.ifpack2.numParams() > 0) return false;
  if (solver.muelu.numParams() > 0) return true;
  return static_cast<long long>(solver.map->getGlobalNumElements()) >= fewest_cells_for_multigrid &&
         solver.flow_over_storage >= min_flow_for_multigrid;
}

void update_relaxation(LinearSolver& solver) {
  auto relaxation = Teuchos::rcp_dynamic_cast<Relaxation>(solver.preconditioner);
  if (relaxation.is_null()) {
    Teuchos::ParameterList list = solver.ifpack2;
    const std::string kind = list.get("Type", std::string("RELAXATION"));
    list.remove("Type");
    if (list.numParams() == 0 && kind == "RELAXATION")
      list.set("relaxation: type", std::string("Symmetric Gauss-Seidel"));
    const Teuchos::RCP<const RowMatrix> rows = solver.matrix;
    relaxation = Ifpack2::Factory::create<RowMatrix>(kind, rows);
    relaxation->setParameters(list);
    relaxation->initialize();
    solver.preconditioner = relaxation;
  }
  relaxation->compute();
}

void update_preconditioner(LinearSolver& solver) {
  const Region region("update_preconditioner");
  solver.with_multigrid = wants_multigrid(solver);
  if (solver.with_multigrid)
    solver.preconditioner = make_multigrid(solver.matrix, solver.muelu, solver.preconditioner);
  else
    update_relaxation(solver);
}

double norm(const Vectors& v) {
  Teuchos::Array<double> n(1);
  v.norm2(n());
  return n[0];
}

/// r = b - A x.
void find_residual(LinearSolver& solver) {
  solver.matrix->apply(*solver.x, *solver.residual);
  solver.residual->update(1.0, *solver.b, -1.0);
}

/// The constant that makes the rows' sum right. Where hardly anything leaves a rock, a small
/// residual of all rows together stands for a large pressure.
void correct_mean(LinearSolver& solver) {
  solver.change->putScalar(1.0);
  solver.matrix->apply(*solver.change, *solver.row_sums);
  Teuchos::Array<double> left(1), all(1);
  solver.residual->dot(*solver.change, left());
  solver.row_sums->dot(*solver.change, all());
  if (all[0] > 0.0) solver.x->update(left[0] / all[0], *solver.change, 1.0);
}

Teuchos::RCP<Teuchos::ParameterList> krylov_list(const LinearSolver& solver, double tolerance) {
  auto list = Teuchos::rcp(new Teuchos::ParameterList(solver.belos));
  list->remove("Solver", false);
  Teuchos::ParameterList usual;
  usual.set("Maximum Iterations", 1000);
  usual.set("Verbosity", static_cast<int>(Belos::Errors));
  list->setParametersNotAlreadySet(usual);
  list->set("Convergence Tolerance", tolerance);
  return list;
}

/// change = A^-1 residual to a tolerance. @return whether the method says so, and its iterations
std::pair<bool, int> solve_once(double tolerance, LinearSolver& solver) {
  solver.change->putScalar(0.0);
  const auto problem = Teuchos::rcp(new Problem(solver.matrix, solver.change, solver.residual));
  problem->setLeftPrec(solver.preconditioner);
  problem->setProblem();
  Belos::SolverFactory<double, Vectors, SparseOperator> factory;
  const Teuchos::RCP<Krylov> krylov = factory.create(solver.krylov, krylov_list(solver, tolerance));
  krylov->setProblem(problem);
  const bool said = krylov->solve() == Belos::Converged;
  return {said, krylov->getNumIters()};
}

/// The same where a method gives up, which it reports by an exception on every rank.
std::pair<bool, int> try_once(double tolerance, LinearSolver& solver) {
  try {
    return solve_once(tolerance, solver);
  } catch (const Belos::BelosError&) {
    return {false, 0};
  }
}

/// Solves for what is left until the true residual is small: what a method says of itself is its
/// own recurrence, which round-off parts from the truth.
SolveReport refine(double size, LinearSolver& solver) {
  constexpr int max_rounds = 4;
  SolveReport report;
  report.method = solver.krylov + (solver.with_multigrid ? " with MueLu" : " with Ifpack2");
  solver.x->putScalar(0.0);
  find_residual(solver);
  double left = size;
  for (int round = 0; round < max_rounds && left > solver.tolerance * size; ++round) {
    const auto [said, iterations] =
        try_once(std::min(0.5, 0.5 * solver.tolerance * size / left), solver);
    report.iterations += iterations;
    solver.x->update(1.0, *solver.change, 1.0);
    find_residual(solver);
    correct_mean(solver);
    find_residual(solver);
    left = norm(*solver.residual);
    if (!said) break;
  }
  report.residual = size > 0.0 ? left / size : 0.0;
  report.converged = left <= solver.tolerance * size;
  return report;
}

/// Multigrid bounds a spectrum by an estimate, and conductances that differ by many orders can make
/// it fail. Gauss-Seidel is positive on any of these matrices; slow, so only where grids fail that
/// nobody has asked for.
SolveReport solve_with_fallback(LinearSolver& solver) {
  const double size = norm(*solver.b);
  SolveReport first = refine(size, solver);
  if (first.converged || !solver.with_multigrid || solver.muelu.numParams() > 0) return first;
  solver.with_multigrid = false;
  solver.preconditioner = Teuchos::null;
  update_relaxation(solver);
  SolveReport second = refine(size, solver);
  second.iterations += first.iterations;
  return second;
}

}  // namespace

std::vector<std::string> known_names(const std::string& method) {
  Belos::SolverFactory<double, Vectors, SparseOperator> factory;
  const auto list = factory.create(method, Teuchos::parameterList())->getValidParameters();
  std::vector<std::string> names;
  for (auto item = list->begin(); item != list->end(); ++item) names.push_back(list->name(item));
  return names;
}

std::shared_ptr<LinearSolver> make_linear_solver(
    const Teuchos::RCP<const Teuchos::Comm<int>>& comm, const Teuchos::ParameterList& lists
) {
  auto solver = std::make_shared<LinearSolver>();
  solver->comm = comm;
  const auto part = [&](const char* name) {
    return lists.isSublist(name) ? lists.sublist(name) : Teuchos::ParameterList();
  };
  solver->belos = part("Belos");
  solver->ifpack2 = part("Ifpack2");
  solver->muelu = part("MueLu");
  solver->krylov = solver->belos.get("Solver", solver->krylov);
  solver->tolerance = solver->belos.get("Convergence Tolerance", solver->tolerance);
  return solver;
}

SolveReport solve(
    const LinearSystem& system, bool same_graph, LinearSolver& solver, std::vector<double>& solution
) {
  const Region region("solve_pore_pressure");
  if (same_graph && !solver.matrix.is_null())
    refill_matrix(system, solver);
  else
    build_matrix(system, solver);
  solver.flow_over_storage = flow_over_storage(system, *solver.comm);
  update_preconditioner(solver);
  {
    const auto b = solver.b->getDataNonConst(0);
    std::copy(system.right_side.begin(), system.right_side.end(), b.begin());
  }
  SolveReport report = solve_with_fallback(solver);
  const auto x = solver.x->getData(0);
  solution.assign(x.begin(), x.end());
  return report;
}

}  // namespace barreno

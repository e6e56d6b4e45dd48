// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/check_solver_lists.hpp"

#include "pore_flow/linear_solver.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>

namespace barreno {
namespace {

constexpr const char* flow = "Pore Flow/";

/// What matters of a message that may have many lines: the one after "Error:", or the last.
std::string line_of(const std::string& message) {
  std::string text = message;
  for (const char* mark : {"Throw test that evaluated to true:", "Error:"}) {
    const std::size_t at = text.rfind(mark);
    if (at != std::string::npos) text = text.substr(text.find('\n', at) + 1);
  }
  text.erase(0, text.find_first_not_of(" \n"));
  std::replace(text.begin(), text.end(), '\n', ' ');
  return text.substr(0, 300);
}

void check_belos(const Deck& deck, const Teuchos::ParameterList& list) {
  const std::string path = std::string(flow) + "Belos";
  const std::string method = list.isParameter("Solver") ? list.get<std::string>("Solver") : "CG";
  std::vector<std::string> known;
  try {
    known = known_names(method);
  } catch (const std::exception&) {
    deck.refuse_value(
        path + "/Solver",
        "is no method that Belos has; use CG, MINRES, GMRES or another of its factory"
    );
  }
  known.emplace_back("Solver");
  for (auto item = list.begin(); item != list.end(); ++item)
    if (std::find(known.begin(), known.end(), list.name(item)) == known.end())
      deck.refuse_value(
          path + "/" + list.name(item),
          "is not a parameter that Belos' " + method + " knows; " +
              input::suggest_name(list.name(item), known)
      );
}

/// A row of cells, drained at its end.
LinearSystem small_system() {
  constexpr long long count = 30;
  LinearSystem system;
  system.clear();
  for (long long i = 0; i < count; ++i) {
    if (i > 0) system.add(i - 1, -1.0);
    system.add(i, i > 0 ? 2.0 : 1.0);
    if (i + 1 < count) system.add(i + 1, -1.0);
    system.end_row(i, 1.0);
  }
  return system;
}

void try_package(
    const Deck& deck, const Teuchos::ParameterList& lists, const char* name, const Comm& comm
) {
  if (!lists.isSublist(name) || lists.sublist(name).numParams() == 0) return;
  try {
    Teuchos::ParameterList alone;
    alone.sublist(name) = lists.sublist(name);
    const auto solver = make_linear_solver(comm.split(comm.getRank(), 0), alone);
    std::vector<double> solution;
    solve(small_system(), false, *solver, solution);
  } catch (const std::exception& error) {
    deck.refuse(
        std::string(flow) + name,
        std::string("is refused by ") + name + " (" + line_of(error.what()) +
            "); correct the list or remove it"
    );
  }
}

}  // namespace

void check_solver_lists(const Deck& deck, const Scene& scene, const Comm& comm) {
  if (!scene.pore_flow.solver) return;
  const Teuchos::ParameterList& lists = *scene.pore_flow.solver;
  check_belos(deck, lists.sublist("Belos"));
  for (const char* name : {"Ifpack2", "MueLu"}) try_package(deck, lists, name, comm);
}

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#include "pore_flow/check_solver_lists.hpp"

#include "base/error.hpp"
#include "pore_flow/linear_solver.hpp"
#include "pore_flow/smoother_names.hpp"

#include <algorithm>
#include <barreno/input/nearest_name.hpp>
#include <barreno/input/scan_xml.hpp>

namespace barreno {
namespace {

constexpr const char* flow_list = "Pore Flow/";

/// What matters of a message that may have many lines: what follows its last mark.
std::string line_of(const std::string& message) {
  std::string text = message;
  for (const char* mark : {"Throw test that evaluated to true:", "Error:"}) {
    const std::size_t at = text.rfind(mark);
    if (at != std::string::npos) text = text.substr(text.find('\n', at) + 1);
  }
  text = text.substr(0, text.find("\n\nThrow number"));
  text.erase(0, text.find_first_not_of(" \n"));
  std::replace(text.begin(), text.end(), '\n', ' ');
  text = text.substr(0, 300);
  return text.substr(0, text.find_last_not_of(" .") + 1);
}

/// The names in quotes that follow a mark, each first on its line.
std::vector<std::string> quoted_after(const std::string& text, const std::string& mark) {
  std::vector<std::string> names;
  for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find('\n', at + 1)) {
    const std::size_t begin = text.find_first_not_of(" \n", at);
    if (begin == std::string::npos || text[begin] != '"') continue;
    names.push_back(text.substr(begin + 1, text.find('"', begin + 1) - begin - 1));
  }
  return names;
}

[[noreturn]] void refuse_name(
    const Deck& deck,
    const std::string& path,
    const std::string& name,
    const std::string& whose,
    const std::vector<std::string>& known
) {
  deck.refuse_value(
      path + "/" + name,
      "is not a parameter that " + whose + " knows; " + input::suggest_name(name, known)
  );
}

/// Passes on why a package refused its list: a name in a sentence of our own, the rest in the
/// package's words.
[[noreturn]] void pass_on(
    const Deck& deck, const std::string& package, const std::string& message
) {
  const std::string path = flow_list + package, named = "{name=\"";
  const std::size_t at = message.rfind(named);
  if (at != std::string::npos && message.find("was not found", at) != std::string::npos) {
    const std::size_t begin = at + named.size();
    const std::string name = message.substr(begin, message.find('"', begin) - begin);
    const auto known = quoted_after(message.substr(at), "The valid parameters");
    if (deck.has(path + "/" + name)) refuse_name(deck, path, name, package, known);
  }
  deck.refuse(
      path,
      "is refused by " + package + " (" + line_of(message) + "); correct the list or remove it"
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

/// Sets a package up for a small matrix, on this rank alone.
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
  } catch (const FileError&) {
    throw;  // the package is missing, whatever its list says
  } catch (const std::exception& error) {
    pass_on(deck, name, error.what());
  }
}

void check_belos(const Deck& deck, const Teuchos::ParameterList& list) {
  const std::string path = std::string(flow_list) + "Belos";
  const std::string method = list.isParameter("Solver") ? list.get<std::string>("Solver") : "CG";
  std::vector<std::string> known;
  try {
    known = known_names(method);
  } catch (const std::exception&) {
    deck.refuse_value(
        path + "/Solver",
        "is not a method of Belos; use CG, MINRES, GMRES or another that its factory offers"
    );
  }
  known.emplace_back("Solver");
  for (auto item = list.begin(); item != list.end(); ++item)
    if (std::find(known.begin(), known.end(), list.name(item)) == known.end())
      refuse_name(deck, path, list.name(item), "Belos' " + method, known);
  const std::string tolerance = "Convergence Tolerance";
  if (!list.isParameter(tolerance)) return;
  if (!list.isType<double>(tolerance) || !(list.get<double>(tolerance) > 0.0) ||
      !(list.get<double>(tolerance) < 1.0))
    deck.refuse_value(
        path + "/" + tolerance,
        "is not a double between 0 and 1; correct it, or remove it to use the default of " +
            input::exact_text(default_solver_tolerance)
    );
}

void check_smoother(
    const Deck& deck,
    const std::string& package,
    const std::string& below,
    const std::string& kind,
    const Teuchos::ParameterList& list
) {
  SmootherNames names;
  try {
    names = smoother_names(kind, list);
  } catch (const std::exception& error) {
    pass_on(deck, package, error.what());
  }
  if (!names.unread.empty())
    refuse_name(deck, flow_list + package + below, names.unread.front(), kind, names.known);
}

/// The kinds of smoother that MueLu takes from Ifpack2; others have lists of their own.
bool is_of_ifpack2(const std::string& kind) {
  const auto kinds = {"RELAXATION", "CHEBYSHEV", "ILUT", "RILUK"};
  return std::find(kinds.begin(), kinds.end(), kind) != kinds.end();
}

void check_smoothers(const Deck& deck, const Teuchos::ParameterList& lists) {
  Teuchos::ParameterList ifpack2 = lists.sublist("Ifpack2");
  const std::string kind = ifpack2.get("Type", std::string("RELAXATION"));
  ifpack2.remove("Type");
  check_smoother(deck, "Ifpack2", "", kind, ifpack2);
  const Teuchos::ParameterList& muelu = lists.sublist("MueLu");
  for (const std::string name : {"smoother", "coarse"}) {
    if (!muelu.isSublist(name + ": params")) continue;
    const std::string type = name + ": type", usual = name == "coarse" ? "RELAXATION" : "CHEBYSHEV";
    const std::string used = muelu.isParameter(type) ? muelu.get<std::string>(type) : usual;
    const std::string below = "/" + name + ": params";
    if (is_of_ifpack2(used))
      check_smoother(deck, "MueLu", below, used, muelu.sublist(name + ": params"));
  }
}

}  // namespace

void check_solver_lists(const Deck& deck, const Scene& scene, const Comm& comm) {
  if (!scene.pore_flow.solver) return;
  const Teuchos::ParameterList& lists = *scene.pore_flow.solver;
  check_belos(deck, lists.sublist("Belos"));
  check_smoothers(deck, lists);
  for (const char* name : {"Belos", "Ifpack2", "MueLu"}) try_package(deck, lists, name, comm);
}

}  // namespace barreno

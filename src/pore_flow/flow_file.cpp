// SPDX-License-Identifier: BSD-3-Clause
#include "base/error.hpp"
#include "base/gather.hpp"
#include "deck/files/read_on_root.hpp"
#include "files/text_file.hpp"
#include "pore_flow/steady_flow.hpp"

#include <cmath>
#include <nlohmann/json.hpp>

namespace barreno {
namespace {

using Json = nlohmann::json;

constexpr std::size_t largest_problem = std::size_t{1} << 28U;

RingCells cells_of(const Json& json) {
  RingCells cells;
  json.at("radii").get_to(cells.radii);
  json.at("depths").get_to(cells.depths);
  json.at("mobility").get_to(cells.mobility);
  for (const Json& one : json.at("hole")) cells.hole.push_back(one.get<int>() != 0 ? 1 : 0);
  cells.hole_pressure = json.at("hole_pressure").get<double>();
  for (const auto& [name, pressures] :
       {std::pair{"outside", &cells.outside},
        std::pair{"above", &cells.above},
        std::pair{"below", &cells.below}})
    if (json.contains(name)) json.at(name).get_to(*pressures);
  return cells;
}

RingCells read_cells(const std::string& text, const std::string& file) {
  const auto refuse = [&](const std::string& why) {
    throw DeckError(file + " is no problem of flow (" + why + "); barreno flow writes such files.");
  };
  RingCells cells;
  try {
    cells = cells_of(Json::parse(text));
  } catch (const Json::exception& error) {
    refuse(error.what());
  }
  const std::string problem = problem_of(cells);
  if (!problem.empty()) refuse(problem);
  return cells;
}

/// Pressures that are nan become null.
std::string answer_of(const SteadyFlow& flow) {
  Json pressure = Json::array();
  for (const double p : flow.pressure) pressure.push_back(std::isnan(p) ? Json() : Json(p));
  const Json answer = {
      {"pressure", pressure},
      {"into_hole", flow.into_hole},
      {"from_outside", flow.from_outside},
      {"from_above", flow.from_above},
      {"from_below", flow.from_below},
      {"method", flow.report.method},
      {"iterations", flow.report.iterations},
      {"residual", flow.report.residual}};
  return answer.dump() + "\n";
}

}  // namespace

void solve_flow_file(
    const std::string& problem,
    const std::string& out,
    const Teuchos::RCP<const Teuchos::Comm<int>>& comm
) {
  const std::string text =
      read_on_root([&] { return read_file(problem, largest_problem, "a problem of flow"); }, *comm);
  const SteadyFlow flow = solve_steady_flow(read_cells(text, problem), comm);
  if (!flow.report.converged)
    throw NumericalError(
        "the flow through the rock was not found (" + flow.report.method + " left " +
        to_text(flow.report.residual) + " of the right side after " +
        std::to_string(flow.report.iterations) +
        " iterations); permeabilities that differ by less may help."
    );
  RootWork work(*comm);
  work.run([&] { write_whole_file(out, answer_of(flow)); });
  work.agree();
}

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#include "output/warnings/numerical_energy.hpp"

#include "files/text_file.hpp"
#include "scene/tile_levels.hpp"
#include "state/balance.hpp"
#include "state/ledger_table.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <map>
#include <sstream>

namespace barreno {
namespace {

/// Whether a row of the ledger counts in Balance::put_in of the energy.
bool is_put_in(const LedgerRow& row) {
  return row.unit == Conserved::energy && (row.part == Part::supplied || row.part == Part::worked);
}

/// Energy put in until the start, which history.csv leaves out.
double put_in_at_start(const Ledger& ledger) {
  double sum = 0.0;
  for (const LedgerRow& row : ledger_table())
    if (is_put_in(row) && row.column == 0) sum += std::abs(row.value(ledger));
  return sum;
}

/// Energy put in until a row of history.csv, by the names of its columns.
double put_in_until(const Ledger& ledger, std::map<std::string, double>& numbers) {
  double sum = put_in_at_start(ledger);
  for (const LedgerRow& row : ledger_table())
    if (is_put_in(row) && row.column > 0) sum += std::abs(numbers[row.name]);
  return sum;
}

std::vector<std::string> words_of_line(const std::string& line) {
  std::vector<std::string> words;
  std::istringstream stream(line);
  for (std::string word; std::getline(stream, word, ',');) words.push_back(word);
  return words;
}

/// Numbers of a row by the column's name; empty where they do not belong to the header.
std::map<std::string, double> numbers_of_line(
    const std::vector<std::string>& header, const std::string& line
) {
  const std::vector<std::string> words = words_of_line(line);
  std::map<std::string, double> numbers;
  if (words.size() != header.size()) return numbers;
  for (std::size_t i = 0; i < words.size(); ++i)
    numbers[header[i]] = std::strtod(words[i].c_str(), nullptr);
  return numbers;
}

}  // namespace

std::vector<EnergyRow> energy_rows(
    const std::filesystem::path& history, const Ledger& ledger, double time
) {
  std::vector<EnergyRow> rows;
  std::ifstream stream(history);
  std::vector<std::string> header;
  for (std::string line; std::getline(stream, line);) {
    if (line.empty() || line[0] == '#') continue;
    if (header.empty()) {
      header = words_of_line(line);
      continue;
    }
    auto of = numbers_of_line(header, line);
    if (of.empty()) continue;
    rows.push_back({of["time"], put_in_until(ledger, of), of["stress_integration"], of["transfer"]}
    );
  }
  const double put_in = energy_balance(ledger).put_in;
  rows.push_back({time, put_in, ledger.stress_integration, ledger.transfer});
  return rows;
}

bool NumericalShares::too_large() const {
  return !std::isnan(since);
}

NumericalShares largest_shares(const std::vector<EnergyRow>& rows) {
  NumericalShares shares;
  double most = 0.0;
  for (const EnergyRow& row : rows) most = std::max(most, row.put_in);
  if (!(most > 0.0)) return shares;
  for (const EnergyRow& row : rows) {
    // At the end relative to what stays put in, as the balance has it: waves may have left again.
    const double whole = &row == &rows.back() ? row.put_in : most;
    if (!(whole > 0.0)) continue;
    const double stress = row.stress_integration / whole, transfer = row.transfer / whole;
    if (std::abs(stress) > std::abs(shares.stress_integration)) shares.stress_integration = stress;
    if (std::abs(transfer) > std::abs(shares.transfer)) shares.transfer = transfer;
    const double larger = std::max(std::abs(stress), std::abs(transfer));
    if (larger > largest_numerical_share && !shares.too_large()) shares.since = row.time;
  }
  return shares;
}

namespace {

std::string place_words(const Scene& scene, const ExtremeParticle& at) {
  std::string text = "particle " + std::to_string(at.id) + " of material '" +
                     scene.materials[static_cast<std::size_t>(at.material)].name() + "' at (";
  for (int d = 0; d < dimensions(scene.grid.mode); ++d)
    text += number_line(d == 0 ? "%.3g" : ", %.3g", 1e3 * at.position[static_cast<std::size_t>(d)]);
  return text + ") mm";
}

/// Where the state says that most happened.
std::string where_words(const Scene& scene, const Extremes& extremes) {
  std::string text;
  if (extremes.hottest.id >= 0)
    text = "the hottest is " + place_words(scene, extremes.hottest) +
           number_line(", %.4g K", extremes.hottest.value);
  if (extremes.most_stretched.id < 0) return text;
  return text + (text.empty() ? "" : "; ") + "the most stretched is " +
         place_words(scene, extremes.most_stretched) +
         number_line(", %.3g times its length", extremes.most_stretched.value);
}

/// What would make the errors less, without what the run does already.
std::string advice(const Scene& scene) {
  constexpr double short_steps = 0.4;  // half of the usual Courant Fraction
  const StepSpec& step = scene.step;
  std::vector<std::string> parts;
  for (const MaterialSpec& material : scene.materials)
    if (material.volume_relaxation > 0.0)
      parts.push_back("set the \"Volume Relaxation\" of '" + material.name() + "' to 0");
  if (step.transfer == Transfer::flip && step.pic_fraction > 0.0)
    parts.push_back(number_line("set \"PIC Fraction\" to 0 (%.3g now)", step.pic_fraction));
  parts.push_back(number_line(
      "take cells of half the size there (%.3g mm now)", 1e3 * smallest_cell(scene.grid)
  ));
  if (step.order == Order::stress_last && !step.return_losses)
    parts.emplace_back("set \"Order\" to modified stress last");
  if (step.courant_fraction > short_steps)
    parts.push_back(number_line("halve the \"Courant Fraction\" (%.3g now)", step.courant_fraction)
    );
  std::string text;
  for (std::size_t i = 0; i < parts.size(); ++i)
    text += (i == 0 ? "" : i + 1 == parts.size() ? ", or " : ", ") + parts[i];
  return text;
}

}  // namespace

std::string numerical_energy_sentence(
    const Scene& scene, const NumericalShares& shares, const Extremes& extremes
) {
  if (!shares.too_large()) return {};
  const double s = shares.stress_integration, t = shares.transfer;
  const bool cancel = s * t < 0.0 && std::min(std::abs(s), std::abs(t)) > largest_numerical_share;
  const std::string where = where_words(scene, extremes);
  return number_line(
             "numerical errors have exceeded %.0f %% of the energy put in since t = %.4g s",
             100.0 * largest_numerical_share,
             shares.since
         ) +
         number_line(
             " (stress integration %+.2g %%, transfer between particles and grid %+.2g %% at their "
             "largest",
             100.0 * s,
             100.0 * t
         ) +
         (cancel ? ", which cancel in the sum" : "") + ")" +
         (where.empty() ? "" : "; of the particles at the end " + where) +
         "; pressures and heat there are doubtful: " + advice(scene) + ".";
}

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#include "output/share_numbers.hpp"

#include "files/text_file.hpp"

#include <numeric>

namespace barreno {
namespace {

/// Entries that have some of the whole, each with the name of its place in the list.
template <class NameOf>
std::vector<NamedShare> named(const double* counts, int size, const NameOf& name_of) {
  const double all = std::accumulate(counts, counts + size, 0.0);
  std::vector<NamedShare> shares;
  for (int i = 0; i < size; ++i)
    if (counts[i] > 0.0) shares.emplace_back(name_of(i), counts[i] / all);
  return shares;
}

}  // namespace

std::vector<NamedShare> shares_by_cell_size(double cell_size, const StepShares& shares) {
  return named(shares.of_level, max_level + 1, [&](int level) {
    return number_line("%.6g mm", 1e3 * cell_size / (1 << level));
  });
}

std::vector<NamedShare> shares_by_step_length(const StepShares& shares) {
  const std::vector<NamedShare> all = named(shares.of_length, step_lengths, [](int length) {
    return length == 0 ? std::string("1 part") : std::to_string(1 << length) + " parts";
  });
  return all.size() > 1 || shares.of_length[0] == 0.0 ? all : std::vector<NamedShare>{};
}

std::vector<NamedShare> shares_of_limits(const Scene& scene, const StepLimits& limits) {
  const std::vector<std::string> names = step_limit_names(scene);
  return named(limits.time.data(), static_cast<int>(limits.time.size()), [&](int row) {
    return names[static_cast<std::size_t>(row)];
  });
}

std::string share_text(const std::vector<NamedShare>& shares) {
  std::string text;
  for (const auto& [name, share] : shares)
    text += (text.empty() ? "" : ", ") + name + number_line(" %.0f %%", 100.0 * share);
  return text;
}

}  // namespace barreno

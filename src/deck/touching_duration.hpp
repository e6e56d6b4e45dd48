// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/sections/jet_section.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace barreno {

/// How long a whole slug takes to cross the launch plane if it touches its whole neighbours: from
/// half-way to the slug before to half-way to the slug behind; beside one alone, as long as the
/// interval to it [time]. None for a piece, and for a slug without a whole neighbour.
std::optional<double> touching_duration(const std::vector<JetSlug>& slugs, std::size_t i);

}  // namespace barreno

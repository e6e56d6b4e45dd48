// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/surface.hpp"

#include <memory>
#include <string>

namespace barreno {

/// Files beyond this are refused before they cost memory: five million facets in binary.
inline constexpr std::size_t largest_surface = 256U << 20U;

/// The closed surface of an STL file, binary or text, every coordinate times `unit` plus `shift`
/// [length]. Equal corners become one point; facets with two equal corners are left out.
/// @param source  how sentences name the file
/// @throws DeckError if the text is not STL or its surface does not enclose a solid, with what to
/// do
std::shared_ptr<const Surface> read_surface(
    const std::string& text, double unit, const Vector& shift, const std::string& source
);

}  // namespace barreno

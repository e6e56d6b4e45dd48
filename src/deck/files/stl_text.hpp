// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno {

/// Whether the bytes begin as an STL file in text does, "solid" in any letters, behind a byte-order
/// mark and blanks that may stand there.
bool begins_as_stl_text(const std::string& bytes);

/// An STL file in text as readers expect it: words in small letters and in one ("endsolid"),
/// without names and normals. Corners keep their digits.
/// @throws DeckError  with the line of a word or a number that is none, or that the file ends in
std::string plain_stl_text(const std::string& bytes, const std::string& source);

}  // namespace barreno

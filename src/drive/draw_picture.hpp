// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno {

/// Throws DeckError unless the name ends with .png, .pdf or .svg.
void check_picture_name(const std::string& picture);

/// Name of the table of the yield surface beside a picture: answer.png, answer_surface.csv.
std::string surface_file_of(const std::string& picture);

/// Draws a picture of a plot_text() with plot_drive.py, which is searched beside the program (the
/// installation, also one that was moved) and in the source tree, and run by Python 3 with
/// Matplotlib. The picture appears whole or not at all.
///
/// Throws FileError with the reason: no Python, no Matplotlib, no script, a picture that cannot be
/// written.
void draw_picture(const std::string& picture, const std::string& text);

}  // namespace barreno

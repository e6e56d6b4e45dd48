// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jet/depth_tables.hpp"
#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// Whose depth it is that an error is asked for.
enum class DepthOf { run, estimate };

/// Whether a jet is like a measured one in a ratio of both: by no more than this factor away.
bool is_within(double ratio, double factor);

/// Between the errors with two sizes of cells, over the logarithm of the cells.
DepthError error_between(
    double cells, double from, const DepthError& coarse, double to, const DepthError& fine
);

/// By interpolation in tables without a problem: between cells over their logarithm, along the path
/// over depth in radii; deeper than measured it is that of the deepest.
/// @param cells_per_radius  of the thinnest part of the jet at impact; inside of
/// measured_cells(tables)
/// @param depth_over_radius  depth in radii of that part
DepthError measured_depth_error(
    const DepthTables& tables,
    double cells_per_radius,
    double depth_over_radius,
    DepthOf whose = DepthOf::run
);

/// The same of slugs that are longer or shorter than those of perforation_120us.xml, beside their
/// radius; longer than measured they count as the longest.
/// @param length_over_radius  of the thinnest part, at least shortest_measured_length(tables)
DepthError with_length(
    const DepthTables& tables, DepthError error, double cells_per_radius, double length_over_radius
);
/// In radii.
double shortest_measured_length(const DepthTables& tables);

struct CellRange {
  double fewest, most;
};
/// Cells per radius that were measured.
CellRange measured_cells(const DepthTables& tables);

/// The deepest that was measured, and the latest: no error is known beyond either. Depths and times
/// scale with the jet's radius.
struct MeasuredReach {
  double depth_over_radius;
  double time;  ///< of a jet with the measured radius and tip velocity [time]
};
MeasuredReach measured_reach(const DepthTables& tables);

/// Why the measurements say nothing of a time or depth; empty if they do.
/// @param time  since the first slug was launched
/// @param radius, velocity  of the thinnest part that digs, and of the tip
/// @param depth  that a run has; 0: none yet
std::string why_reach_unknown(
    const DepthTables& tables, double time, double radius, double velocity, double depth
);

/// The slowest slug of the measured jet that has dug when the measurements end, and the least share
/// of its flight that metal fills: slower slugs and wider gaps were never measured.
inline constexpr double measured_slowest = 3092.9;  ///< [velocity]
inline constexpr double measured_least_filled = 0.39;

/// Why the measurements say nothing of the slugs that dig; empty if they do.
/// @param slowest, least_filled  of those slugs, as in JetEstimate
std::string why_slugs_unknown(
    const DepthTables& tables, double length_over_radius, double slowest, double least_filled
);

/// Why no measurements say anything of this scene, or are not there; empty if some may. They are of
/// a round, discrete jet of tungsten in dry sandstone, axisymmetric, with FLIP, GIMP and without
/// contact.
std::string why_scene_unmeasured(const DepthTables& tables, const Scene& scene);

/// The same of a jet that does not break, and of its cells.
std::string why_depth_error_unknown(
    const DepthTables& tables, const Scene& scene, double cells_per_radius
);

/// The error in words, "-14 % (-15 to -3 %)".
std::string depth_error_text(const DepthError& error);

/// What to do where the error is unknown, for a sentence.
extern const char* const unknown_error_advice;

/// What was measured, for a sentence.
extern const char* const depth_error_source;

}  // namespace barreno

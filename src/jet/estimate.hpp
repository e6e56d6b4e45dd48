// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "jet/depth.hpp"
#include "jet/depth_error.hpp"
#include "jet/path.hpp"
#include "scene/scene.hpp"

#include <string>

namespace barreno {

/// How far a jet comes by the hydrodynamic theory of penetration: a slug of density rho_j digs at
/// u = v / (1 + k), k = sqrt(rho_t / rho_j), rho_j = digging_density(), and is consumed at v - u
/// (Birkhoff, MacDougall, Pugh and Taylor, J. Appl. Phys. 19, 563, 1948). No strength, no
/// compression, no afterflow: of the jet of perforation_120us.xml it finds 97 % of the depth at 10
/// us and 74 % at 90 us.
struct JetEstimate {
  double depth = 0.0;        ///< below the outer face [length]
  double time = 0.0;         ///< when the last slug was consumed, or that of the estimate [time]
  double mass_left = 1.0;    ///< share of the jet's mass that has not been consumed
  double energy_left = 1.0;  ///< share of its kinetic energy
  bool passed = false;       ///< it has come out of the back of the target
  double thinnest = 0.0;     ///< least radius of the slugs that have dug; 0: none has [length]
  double length = 0.0;       ///< of the slug with that radius [length]
  double slowest = 0.0;      ///< least velocity of the slugs that have dug [length/time]
  /// Least share of the flight that metal fills, of those slugs: length over the way that a slug
  /// flies until the next one is launched.
  double least_filled = 1.0;
};
/// @param slowest  slugs below this velocity do not dig
JetEstimate estimate_jet(const Scene& scene, double until, double slowest = 0.0);

/// When the leading face of a jet comes to its target in free flight [time].
double first_arrival(const Scene& scene, const JetPath& path);

/// When a launched jet's hole will be found at rest (jet/rest.hpp): after the last slug that is not
/// slower than cut_off_velocity() has dug, by the theory above; 0 without a target [time]. The hole
/// of a run is deeper, so that slugs arrive later: of divided particles divided_depth_ratio.
double predicted_rest(const Scene& scene);

/// The end of a run as far as it is known before: of a run to rest the predicted one, or its
/// longest time if that comes before [time].
double expected_end(const Scene& scene);

/// A length of the slugs in cells: slugs fly as they are launched, so this is at impact too.
struct SlugCells {
  double tip = 0.0, tail = 0.0, least = 0.0, most = 0.0;
};
SlugCells slug_cells(const Scene& scene, double JetSlug::*length);

/// What the cells do to the depth that a run has, or is expected to have, at a time.
struct DepthDoubt {
  double cells_per_radius = 0.0;  ///< of the thinnest slug that has dug by then
  double cells_per_length = 0.0;  ///< of the same
  std::string unknown;            ///< why the error is not known; empty: it is
  DepthError error;
};
/// @param depth  that a run has found; 0: as estimated
DepthDoubt depth_doubt(
    const Scene& scene, double time, double depth = 0.0, const DepthTables& tables = depth_tables()
);

/// Of a run. Nothing is known of a jet that is through its target, or that is formed.
DepthDoubt depth_doubt(const Scene& scene, double time, const Penetration& found);

/// One sentence without a full stop, after "error of the depth from the cells": "-14 % (...)", or
/// "unknown", why, and what to do.
std::string depth_doubt_text(const DepthDoubt& doubt);

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "deck/sections/jet_monitor_section.hpp"
#include "scene/scene.hpp"

#include <cstddef>
#include <optional>
#include <vector>

namespace barreno {

/// Whose particles are the jet, and where its path begins.
struct JetOrigin {
  /// Indices into Scene::bodies, whose size stands for a launched jet.
  std::vector<int> bodies;
  double plane = 0.0;  ///< y, of the launch or of the Jet Monitor [length]
  double direction = 1.0;
  bool formed = false;  ///< from bodies: what of them is beyond the plane is the jet
  double radius = 0.0;  ///< around the axis, in which a body is met [length]
  double mass = 0.0;    ///< no jet has more [mass]
};
/// Whether a body's particles are the jet, or would be once they form it.
bool is_jet_body(const JetOrigin& origin, int body);
JetOrigin launched_jet(const Scene& scene);
JetOrigin formed_jet(const Scene& scene, const JetMonitorSpec& monitor);

/// The path of the jet into the target: depths are measured from `face` along `direction` of y.
///
/// The face is the outer face, as the deck places it, of the first solid body that the jet meets on
/// the axis (the casing if there is one); `end` is the far face of the last such body. Liquids are
/// no target: the jet crosses them as it crosses a gap. Without a solid body on the axis there is
/// no target: the path has no length, and there are no depths.
struct JetPath {
  bool has_target = false;
  double face = 0.0, end = 0.0;  ///< coordinates along y [length]
  double direction = 1.0;
  double bin = 0.0;  ///< one cell [length]
  int bins = 0;      ///< from the face to the end
  JetOrigin origin{};
  double liquid = 0.0;  ///< length of the path that is in liquids [length]
  double depth(double y) const { return direction * (y - face); }
};
JetPath jet_path(const Scene& scene, const JetOrigin& origin);
/// Of a launched jet.
JetPath jet_path(const Scene& scene);

/// The path whose depths a run records: of a launched jet, else of one that forms, if a body is in
/// its way.
std::optional<JetPath> recorded_path(const Scene& scene, const JetMonitorSpec& monitor);

/// What a body takes of the jet's path: coordinates along the direction of flight, direction * y.
struct PathLayer {
  std::size_t body = 0;          ///< index into Scene::bodies
  double near = 0.0, far = 0.0;  ///< [length]
  bool liquid = false;
};
/// Bodies that a jet of this radius around the axis meets, the nearest first.
std::vector<PathLayer> path_layers(const Scene& scene, double radius);
/// Those of them that are solid: where depths are measured.
std::vector<PathLayer> solid_layers(std::vector<PathLayer> layers);

/// The longest body in the jet's path; there is one.
const BodySpec& longest_body(const Scene& scene, const std::vector<PathLayer>& layers);
/// The longest solid body that the jet meets, whose material decides its depth; null: it meets
/// none.
const BodySpec* longest_solid(const Scene& scene);

/// How much of a body's layer lies above a depth [length].
double depth_in(const PathLayer& layer, const JetPath& path, double depth);

/// Of the slugs; 0 without a jet [length].
double widest_radius(const Scene& scene);

}  // namespace barreno

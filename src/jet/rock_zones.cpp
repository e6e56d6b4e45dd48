// SPDX-License-Identifier: BSD-3-Clause
#include "jet/rock_zones.hpp"

#include "base/gather.hpp"
#include "jet/channel.hpp"
#include "jet/drawn_shape.hpp"
#include "jet/rock_permeability.hpp"

#include <barreno/models.hpp>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <type_traits>
#include <variant>

namespace barreno {
namespace {

/// As in the report (src/python/barreno/report/zones.py and porosity.py).
constexpr double half_height = 2.0;  ///< of a ring [cells]
constexpr double changed = 0.05;     ///< of the virgin porosity: less is no zone

/// Whole numbers add up the same in every order: parts of a cell's volume.
constexpr double bulk_quantum = 1.0 / 1099511627776.0;

template <class Parameters, class = void>
constexpr bool has_pores = false;
template <class Parameters>
constexpr bool has_pores<Parameters, std::void_t<decltype(Parameters::p3_crush_curve)>> = true;

/// 1 - exp(-p3) of a card of Arenisca; 0 of other materials.
double virgin_porosity(const MaterialSpec& material) {
  return std::visit(
      [](const auto& model) {
        using Parameters = typename std::decay_t<decltype(model)>::Parameters;
        if constexpr (has_pores<Parameters>)
          return -std::expm1(-model.parameters().p3_crush_curve);
        else
          return 0.0;
      },
      material.material().model
  );
}

/// Rings around the channel of one body.
struct Rings {
  const Scene& scene;
  const JetPath& path;
  double depth, wall;
  int count;
  double virgin;
  int strain;                   ///< column of the plastic volume strain
  std::optional<int> breakage;  ///< its column
};

/// Bulk of the rock in the rings, that of its pores, and its breakage times the bulk.
struct RingSums {
  std::vector<long long> bulk, pores, broken;

  explicit RingSums(int count) : bulk(static_cast<std::size_t>(count)), pores(bulk), broken(bulk) {}
  void sum(const Teuchos::Comm<int>& comm) {
    for (auto* values : {&bulk, &pores, &broken}) sum_over_ranks(comm, *values);
  }
  std::vector<RingRock> rocks() const {
    std::vector<RingRock> rocks;
    for (std::size_t ring = 0; ring < bulk.size(); ++ring) {
      const auto per_bulk = [&](long long sum) {
        return bulk[ring] > 0 ? static_cast<double>(sum) / static_cast<double>(bulk[ring])
                              : std::numeric_limits<double>::quiet_NaN();
      };
      rocks.push_back({per_bulk(pores[ring]), per_bulk(broken[ring])});
    }
    return rocks;
  }
};

/// The rock of one set, of this rank.
void add_set(const Rings& rings, const HostParticles& particles, double density, RingSums& sums) {
  const double cell = rings.path.bin, window = half_height * cell;
  for (int p = 0; p < particles.count; ++p) {
    const double depth = rings.path.depth(particles.position(p, 1));
    std::vector<double> corners;
    particles.append_corners(p, corners);
    const DrawnShape shape(corners, 1.0);
    const double high = shape.half_extent({0.0, 1.0, 0.0});
    const double along =
        overlap(depth - high, depth + high, rings.depth - window, rings.depth + window);
    if (!(along > 0.0)) continue;
    const auto [across, radius] = away_from_axis(particles, p);
    const double wide = shape.half_extent(across);
    if (!(wide > 0.0)) continue;  // squashed flat
    // Debris lies in pieces: what is between them is no pore.
    const double ratio = std::min(1.0, particles.mass(p, 0) / (density * particles.volume(p, 0)));
    const double around = rings.scene.grid.mode == Mode::axisymmetric ? radius : cell;
    const double size = shape.measure() * (particles.dimensions() == 2 ? around : 1.0) * ratio;
    const double share = size / (cell * cell * cell) * along / (2.0 * high);
    const double porosity =
        1.0 - (1.0 - rings.virgin) * std::exp(-particles.history(p, rings.strain));
    const double breakage = rings.breakage ? particles.history(p, *rings.breakage) : 0.0;
    if (!std::isfinite(share + porosity + breakage)) continue;  // a run that ends because of it
    for (int ring = 0; ring < rings.count; ++ring) {
      const double inner = rings.wall + ring * cell;
      const double part =
          share * overlap(radius - wide, radius + wide, inner, inner + cell) / (2.0 * wide);
      const auto index = static_cast<std::size_t>(ring);
      sums.bulk[index] += std::llround(part / bulk_quantum);
      sums.pores[index] += std::llround(part * std::clamp(porosity, 0.0, 1.0) / bulk_quantum);
      sums.broken[index] += std::llround(part * breakage / bulk_quantum);
    }
  }
}

/// The body's channel is looked at half-way down; without enough of it, or in no porous rock: none.
std::optional<RockZones> zones_in(
    const Scene& scene,
    const State& state,
    const JetPath& path,
    const Penetration& found,
    const PathLayer& layer
) {
  const MaterialSpec& rock =
      scene.materials[static_cast<std::size_t>(scene.bodies[layer.body].material)];
  const double virgin = virgin_porosity(rock), cell = path.bin;
  const double length = depth_in(layer, path, found.channel_depth);
  const std::optional<int> strain = rock.history_column("plastic_volume_strain");
  if (!(virgin > 0.0) || !strain || !(length > 2.0 * half_height * cell)) return {};
  const double depth = layer.near - path.direction * path.face + 0.5 * length;
  const double wall = wall_at(path, found, depth);
  const double across =
      std::max(std::abs(scene.grid.lower[0]), std::abs(scene.grid.upper[0])) - wall;
  const int count = std::max(1, static_cast<int>(across / cell));
  const Rings rings{
      scene, path, depth, wall, count, virgin, *strain, rock.history_column("breakage")};
  RingSums sums(count);
  for (std::size_t set = 0; set < state.particles.size(); ++set)
    if (static_cast<int>(set) == scene.bodies[layer.body].material)
      add_set(rings, HostParticles(state.particles[set]), rock.density(), sums);
  sums.sum(*state.grid.comm);
  RockZones zones = zones_of_rings(sums.rocks(), virgin, wall, cell);
  zones.body = layer.body;
  zones.depth = depth;
  if (scene.grid.mode == Mode::plane_strain) zones.skin = std::numeric_limits<double>::quiet_NaN();
  return zones;
}

}  // namespace

RockZones zones_of_rings(
    const std::vector<RingRock>& rings, double virgin, double wall, double width
) {
  using Law = PermeabilityLaw;
  RockZones zones;
  zones.wall = zones.crushed_from = zones.crushed_to = wall;
  zones.dilated_to = zones.impaired_to = wall;
  zones.least_porosity = zones.least_permeability = std::numeric_limits<double>::infinity();
  bool crushed = false;
  for (std::size_t ring = 0; ring < rings.size(); ++ring) {
    const auto [phi, breakage] = rings[ring];
    if (std::isnan(phi)) continue;
    const double inner = wall + static_cast<double>(ring) * width, outer = inner + width;
    const double k = rock_permeability(phi, virgin, breakage);
    zones.least_porosity = std::min(zones.least_porosity, phi);
    zones.least_permeability = std::min(zones.least_permeability, k);
    zones.greatest_breakage = std::max(zones.greatest_breakage, breakage);
    zones.skin += (1.0 / std::max(k, Law::least) - 1.0) * std::log(outer / inner);
    if (k < Law::impaired) zones.impaired_to = outer;
    if (phi > (1.0 + changed) * virgin) zones.dilated_to = outer;
    if (!(phi < (1.0 - changed) * virgin)) continue;
    if (!crushed) zones.crushed_from = inner;
    crushed = true;
    zones.crushed_to = outer;
  }
  return zones;
}

std::vector<RockZones> measure_zones(
    const Scene& scene, const State& state, const JetPath& path, const Penetration& found
) {
  std::vector<RockZones> zones;
  if (!path.has_target || !scene.jet.present) return zones;
  for (const PathLayer& layer : solid_layers(path_layers(scene, widest_radius(scene))))
    if (const auto one = zones_in(scene, state, path, found, layer)) zones.push_back(*one);
  return zones;
}

}  // namespace barreno

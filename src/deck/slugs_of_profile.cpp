// SPDX-License-Identifier: BSD-3-Clause
#include "deck/slugs_of_profile.hpp"

#include "base/numbers.hpp"
#include "deck/section_table.hpp"
#include "deck/touching_duration.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>

namespace barreno {
namespace {

/// A linear function of the velocity, a + b v.
struct Linear {
  double a, b;
};

/// Integral of v^k dv.
double power(int k, double low, double high) {
  if (k == -1) return std::log(high / low);
  return (std::pow(high, k + 1) - std::pow(low, k + 1)) / (k + 1);
}

/// Integral of v^k p q min(S / v, t_b) dv between velocities on one side of S / t_b.
double moment(
    const JetProfileSpec& profile, int k, const Linear& p, const Linear& q, double low, double high
) {
  const bool broken = 0.5 * (low + high) < broken_below(profile);
  const double factor = broken ? *profile.break_up_time : profile.virtual_origin;
  const int first = broken ? k : k - 1;
  return factor * (p.a * q.a * power(first, low, high) +
                   (p.a * q.b + p.b * q.a) * power(first + 1, low, high) +
                   p.b * q.b * power(first + 2, low, high));
}

/// The velocity, within the jet, at which broken metal begins; its end where there is none.
double border(const JetProfileSpec& profile) {
  return std::clamp(broken_below(profile), profile.tail_velocity, profile.tip_velocity);
}

double whole_moment(const JetProfileSpec& profile, int k, const Linear& p, const Linear& q) {
  const double middle = border(profile);
  return moment(profile, k, p, q, profile.tail_velocity, middle) +
         moment(profile, k, p, q, middle, profile.tip_velocity);
}

/// 1 at the tip and 0 at the tail, and the other way round.
struct Ends {
  Linear tip, tail;
};
Ends ends_of(const JetProfileSpec& profile) {
  const double v0 = profile.tip_velocity, v1 = profile.tail_velocity, span = v0 - v1;
  return {{-v1 / span, 1.0 / span}, {v0 / span, -1.0 / span}};
}

double density_of(const JetProfileSpec& profile, double metal_density) {
  return profile.density.value_or(metal_density);
}

/// Radii of tip and tail.
struct Radii {
  double tip, tail;
};

/// The radius at the other end, with which the jet has its mass; none: that end alone is heavier.
/// Root of J_known r_known^2 + 2 J_both r_known r + J_other r^2 = m / (rho pi).
std::optional<double> other_radius(
    const JetProfileSpec& profile,
    double known,
    const Linear& of_known,
    const Linear& of_other,
    double metal_density
) {
  const double of_density = density_of(profile, metal_density) * pi;
  const double c =
      whole_moment(profile, 0, of_known, of_known) * known * known - *profile.mass / of_density;
  const double b = whole_moment(profile, 0, of_known, of_other) * known;
  const double a = whole_moment(profile, 0, of_other, of_other);
  if (!(c < 0.0)) return std::nullopt;
  return -c / (b + std::sqrt(b * b - a * c));
}

/// Both radii; none: a radius that is given has more than the mass alone.
std::optional<Radii> radii_of(const JetProfileSpec& profile, double metal_density) {
  const Ends ends = ends_of(profile);
  if (profile.tip_radius && profile.tail_radius)
    return Radii{*profile.tip_radius, *profile.tail_radius};
  if (profile.tip_radius) {
    const auto tail =
        other_radius(profile, *profile.tip_radius, ends.tip, ends.tail, metal_density);
    return tail ? std::optional<Radii>(Radii{*profile.tip_radius, *tail}) : std::nullopt;
  }
  if (profile.tail_radius) {
    const auto tip =
        other_radius(profile, *profile.tail_radius, ends.tail, ends.tip, metal_density);
    return tip ? std::optional<Radii>(Radii{*tip, *profile.tail_radius}) : std::nullopt;
  }
  const Linear one{1.0, 0.0};
  const double all = density_of(profile, metal_density) * pi * whole_moment(profile, 0, one, one);
  const double radius = std::sqrt(*profile.mass / all);
  return Radii{radius, radius};
}

/// r as a function of v.
Linear radius_of(const JetProfileSpec& profile, double metal_density) {
  const Radii radii = *radii_of(profile, metal_density);
  const Ends ends = ends_of(profile);
  return {
      radii.tip * ends.tip.a + radii.tail * ends.tail.a,
      radii.tip * ends.tip.b + radii.tail * ends.tail.b};
}

/// Velocities between slugs, from tip to tail: of whole metal in equal ratios, and of pieces.
std::vector<double> edges_of(const JetProfileSpec& profile) {
  const double tip = profile.tip_velocity, middle = border(profile), tail = profile.tail_velocity;
  const double share = std::log(tip / middle) / std::log(tip / tail);
  int whole = static_cast<int>(std::lround(share * profile.rows));
  if (middle < tip) whole = std::max(whole, 1);
  if (middle > tail) whole = std::min(whole, profile.rows - 1);
  std::vector<double> edges{tip};
  for (int i = 1; i <= whole; ++i) edges.push_back(tip * std::pow(middle / tip, 1.0 * i / whole));
  const int broken = profile.rows - whole;
  for (int i = 1; i <= broken; ++i)
    edges.push_back(middle * std::pow(tail / middle, 1.0 * i / broken));
  return edges;
}

/// The slug of the liner, of the metal's density.
JetSlug liner_slug(const JetProfileSpec& profile, double first, double metal_density) {
  JetSlug slug;
  slug.velocity = *profile.slug_velocity;
  slug.radius = *profile.slug_radius;
  slug.density = metal_density;
  slug.length = *profile.slug_mass / (metal_density * pi * slug.radius * slug.radius);
  slug.time = profile.virtual_origin / slug.velocity - first;
  return slug;
}

std::string number(double x) {
  char buffer[40];
  std::snprintf(buffer, sizeof buffer, "%.4g", x);
  return buffer;
}

ProfileProblem problem_of_radii(const JetProfileSpec& profile, double metal_density) {
  const int given = static_cast<int>(profile.mass.has_value()) +
                    static_cast<int>(profile.tip_radius.has_value()) +
                    static_cast<int>(profile.tail_radius.has_value());
  if (given == 3)
    return {
        name_of(&JetProfileSpec::mass),
        "cannot be given beside Tip Radius and Tail Radius (they decide the mass); remove one of "
        "the three"};
  if (!profile.mass && given < 2)
    return {
        "",
        "needs Mass, or Tip Radius and Tail Radius (nothing says how thick the jet is); add them"};
  if (radii_of(profile, metal_density)) return {};
  const bool tip = profile.tip_radius.has_value();
  return {
      name_of(&JetProfileSpec::mass),
      "is less than a jet with that " + std::string(tip ? "Tip Radius" : "Tail Radius") +
          " has, even if its other end is a point; give a larger mass or a smaller radius"};
}

ProfileProblem problem_of_slug(const JetProfileSpec& profile, double metal_density) {
  const bool any = profile.slug_velocity || profile.slug_mass || profile.slug_radius;
  if (!any) return {};
  if (!(profile.slug_velocity && profile.slug_mass && profile.slug_radius))
    return {
        "",
        "has a part of the liner's slug only; give Slug Velocity, Slug Mass and Slug Radius, or "
        "none"};
  if (*profile.slug_velocity >= profile.tail_velocity)
    return {
        name_of(&JetProfileSpec::slug_velocity),
        "is not below Tail Velocity (the slug follows the tail); give a lower one"};
  const JetSlug slug = liner_slug(profile, 0.0, metal_density);
  const double front = slug.time - 0.5 * slug.length / slug.velocity;
  const double tail = profile.virtual_origin / profile.tail_velocity;
  if (front < tail)
    return {
        name_of(&JetProfileSpec::slug_mass),
        "makes the liner's slug " + number(slug.length) +
            " m long, so that it begins in the tail of the jet; give a lower Slug Velocity, or a "
            "larger Slug Radius"};
  return {};
}

}  // namespace

double broken_below(const JetProfileSpec& profile) {
  return profile.break_up_time ? profile.virtual_origin / *profile.break_up_time : 0.0;
}

double pieces_below(const JetProfileSpec& profile) {
  const double broken = broken_below(profile);
  if (!profile.slug_velocity) return broken;
  return std::max(broken, 0.5 * (*profile.slug_velocity + profile.tail_velocity));
}

ProfileProblem problem_of_profile(const JetProfileSpec& profile, double metal_density) {
  if (profile.tail_velocity >= profile.tip_velocity)
    return {
        name_of(&JetProfileSpec::tail_velocity),
        "is not below Tip Velocity (a jet stretches because its tail is slower); exchange them"};
  if (profile.density && *profile.density > metal_density)
    return {
        name_of(&JetProfileSpec::density),
        "exceeds " + number(metal_density) +
            " kg/m3, that of the jet's material; lower it, or leave it out"};
  ProfileProblem problem = problem_of_radii(profile, metal_density);
  return problem.sentence.empty() ? problem_of_slug(profile, metal_density) : problem;
}

ProfileSums sums_of_profile(const JetProfileSpec& profile, double metal_density) {
  const Linear radius = radius_of(profile, metal_density);
  const double factor = density_of(profile, metal_density) * pi;
  return {
      factor * whole_moment(profile, 0, radius, radius),
      factor * whole_moment(profile, 1, radius, radius),
      0.5 * factor * whole_moment(profile, 2, radius, radius)};
}

std::vector<JetSlug> slugs_of_profile(const JetProfileSpec& profile, double metal_density) {
  const Linear radius = radius_of(profile, metal_density);
  const double density = density_of(profile, metal_density);
  const std::vector<double> edges = edges_of(profile);
  const double first = profile.virtual_origin / profile.tip_velocity;
  std::vector<JetSlug> slugs;
  std::vector<double> masses;
  for (std::size_t i = 0; i + 1 < edges.size(); ++i) {
    const double low = edges[i + 1], high = edges[i];
    masses.push_back(density * pi * moment(profile, 0, radius, radius, low, high));
    JetSlug slug;
    slug.velocity = density * pi * moment(profile, 1, radius, radius, low, high) / masses.back();
    slug.time = profile.virtual_origin / slug.velocity - first;
    slug.density = density;
    slug.piece = slug.velocity < broken_below(profile);
    if (slug.piece) slug.length = *profile.break_up_time * (high - low);
    slugs.push_back(slug);
  }
  for (std::size_t i = 0; i < slugs.size(); ++i) {
    JetSlug& slug = slugs[i];
    if (!slug.piece) {
      const double alone = profile.virtual_origin * (1.0 / edges[i + 1] - 1.0 / edges[i]);
      slug.length = slug.velocity * touching_duration(slugs, i).value_or(alone);
    }
    slug.radius = std::sqrt(masses[i] / (density * pi * slug.length));
  }
  if (profile.slug_velocity) slugs.push_back(liner_slug(profile, first, metal_density));
  return slugs;
}

}  // namespace barreno

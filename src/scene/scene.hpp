// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "geometry/shape.hpp"
#include "scene/pore_flow_spec.hpp"
#include "scene/quasi_static_spec.hpp"
#include "scene/table.hpp"

#include <array>
#include <barreno/models.hpp>
#include <optional>
#include <string>
#include <vector>

namespace barreno {

/// What was asked, as plain structs in SI, checked and complete. Built once by build_scene, then
/// const.
///
/// In axisymmetry x = r, y = axial and z = hoop; vectors carry three components, two-dimensional
/// modes use the first two.

enum class Mode { axisymmetric, plane_strain, three_dimensional };

struct GridSpec {
  Mode mode = Mode::axisymmetric;
  Vector lower{}, upper{};  ///< corners of the box that particles may occupy [length]
  double cell_size = 0.0;   ///< [length]
};

/// What happens to a particle that went bad (inverted, not finite, failed material update).
enum class BadParticlePolicy { stop, hold, remove };

struct MaterialSpec {
  Material material;
  BadParticlePolicy bad_particles = BadParticlePolicy::remove;
};

/// Prescribed motion of a rigid body: velocity * factor(t).
struct MotionSpec {
  bool prescribed = false;
  Vector velocity{};  ///< [length/time]
  Table factor{{0.0}, {1.0}};
};

struct BodySpec {
  std::string name;
  int material = 0;  ///< index into Scene::materials
  Shape shape;  ///< in two dimensions a figure in the plane; in axisymmetry in the half plane {r,
                ///< axial}
  int particles_per_cell = 2;     ///< per direction
  Vector velocity{};              ///< [length/time]
  double initial_pressure = 0.0;  ///< the body starts in equilibrium under this pressure [stress]
  std::optional<double> pore_pressure;  ///< at the start; without: as its material has it [stress]
  /// Initial velocity v = amplitude * sin(wave_number . x): the standing wave of the bar tests.
  Vector velocity_wave_number{};  ///< all zero: uniform velocity [1/length]
  double spin = 0.0;              ///< about the body's own middle, plane strain only [1/time]
  /// Of a hollow ball's inner surface, outward; the field keeps every volume [length/time].
  double radial_velocity = 0.0;
  MotionSpec motion;
};

enum class Face { x_lower, x_upper, y_lower, y_upper, z_lower, z_upper };

/// Kinematic condition on the nodes of one face of the grid box (and beyond it).
enum class ConditionKind { symmetry, fixed, prescribed_velocity };
struct ConditionSpec {
  std::string name;
  Face face = Face::x_lower;
  ConditionKind kind = ConditionKind::symmetry;
  Vector velocity{};           ///< prescribed_velocity only [length/time]
  Table factor{{0.0}, {1.0}};  ///< of velocity, as time goes on [-]
};

/// Surfaces of a ball: that of its hollow and that around it.
enum class BallSurface { inner, outer };

enum class LoadKind { pressure, non_reflecting, pore_fluid };

/// Pressure that follows a body's own surface (pushes inward if > 0): faces of a box, surfaces of a
/// ball.
struct PressureLoadSpec {
  std::string name;
  int body = 0;                 ///< index into Scene::bodies
  std::array<bool, 6> faces{};  ///< of a Box, indexed by Face
  Table pressure;               ///< at the start if the kind is pore_fluid [stress]
  LoadKind kind = LoadKind::pressure;
  std::array<bool, 2> surfaces{};  ///< of a Ball, indexed by BallSurface
  double bulk_modulus = 0.0;       ///< pore_fluid: p = p0 - K ln(V / V0) [stress]
};
/// The loads of a scene, six faces each, are the bits of one double.
inline constexpr std::size_t most_loads = 8;

/// Force per mass on every particle: gravity, or what a manufactured motion needs (body_force.hpp).
enum class BodyForceKind { none, gravity, axis_aligned, vortex, ring };
struct BodyForceSpec {
  BodyForceKind kind = BodyForceKind::none;
  Vector acceleration{};   ///< gravity only [acceleration]
  double amplitude = 0.0;  ///< A of a manufactured motion [length]; of the vortex [-]
  int dimensions = 2;
  bool axisymmetric = false;
  double density = 0.0, young = 0.0, lambda = 0.0, shear = 0.0;  ///< of its material
  Vector centre{};                                               ///< of its disk [length]
  double inner_radius = 0.0, outer_radius = 0.0;                 ///< [length]
};

struct JetSlug {
  double time = 0.0;                  ///< its centre crosses the launch plane [time]
  double velocity = 0.0;              ///< [length/time]
  double radius = 0.0, length = 0.0;  ///< half-width instead of radius in plane strain [length]
  double density = 0.0;               ///< [mass/length^3]
};

struct JetSpec {
  bool present = false;
  int material = 0;
  std::string table_file;
  std::vector<JetSlug> slugs;    ///< launch times do not decrease
  double launch_position = 0.0;  ///< coordinate of the launch plane along y [length]
  double direction = 1.0;        ///< +1 or -1 along y
  int particles_per_cell = 4;    ///< per direction
};

/// How particles take the grid's velocities: as increments (FLIP, blended with PIC), as increments
/// of velocities that the grid can hold (XPIC), or with their first moments (APIC).
enum class Transfer { flip, xpic, apic };
/// When of a step the strain is found: from the velocities that forces gave (stress last), from
/// those that the moved particles give back to the grid (modified stress last), or at the start of
/// the next step (stress first).
enum class Order { stress_last, modified_stress_last, stress_first };

struct StepSpec {
  std::string shape = "GIMP";   ///< the word of one of the list in shape/visit_kernels.hpp
  double largest_domain = 1.0;  ///< l_crit: corners further from x_p are pulled in [cells]
  bool stable_alone = false;    ///< steps in which a particle is stable that flies alone
  double courant_fraction =
      0.8;                      ///< of the critical Courant number of shape and particles per cell
  double growth_limit = 1.1;    ///< largest ratio of successive steps
  double largest_strain = 0.5;  ///< per step: |D| dt stays below, the step is retried smaller [-]
  double largest_expansion = 10.0;  ///< V / V_ref beyond which the particle policy acts [-]
  Transfer transfer = Transfer::flip;
  double pic_fraction = 0.0;  ///< share of the grid's own velocity: 0 = FLIP, 1 = PIC, APIC
  int xpic_order = 2;         ///< m of XPIC(m), at least 2
  Order order = Order::stress_last;
  double damping = 0.0;               ///< f_I -= damping p_I [1/time]
  double linear_viscosity = 0.3;      ///< A1 of q = rho (A1 c h |tr D| + A2 h^2 (tr D)^2)
  double quadratic_viscosity = 2.0;   ///< A2
  double initial_step = 0.0;          ///< 0: the stable step [time]
  double largest_step = 0.0;          ///< 0: no limit [time]
  bool return_losses = false;         ///< losses of a step become heat (scene/heat.hpp)
  bool skip_dormant = true;           ///< tiles at rest (scene/dormant.hpp)
  std::optional<double> rest_motion;  ///< of their nodes in a step; without: rest_motion() [cells]
};

/// Longest Largest Domain that the patches of tiles are made for, which is what 0 in a deck means
/// [cells]. Domains of three dimensions reach 1.5 times as far as that.
inline double farthest_domain(Mode mode) {
  return mode == Mode::three_dimensional ? 16.0 / 3.0 : 8.0;
}

/// What the surfaces of two materials do to each other; bonded: what materials without a contact
/// do, they share one velocity.
enum class ContactKind { bonded, stick, friction, frictionless };
struct ContactSpec {
  std::string name;
  std::array<int, 2> materials{};  ///< indices into Scene::materials, different
  ContactKind kind = ContactKind::frictionless;
  double friction = 0.0;  ///< coefficient of friction [-]
};

enum class Glyph { deformed, point };

/// Where particles are written: one file, or as many as the run began with ranks.
enum class ParticleFiles { one, one_per_rank };

/// What may pass between two checkpoints; 0: no bound.
struct CheckpointSpec {
  double wall_interval = 600.0;  ///< [s], of the clock on the wall
  double interval = 0.0;         ///< [time]
  long steps = 0;
};

struct OutputSpec {
  double field_interval = 0.0;  ///< between Exodus steps; 0: first and last only [time]
  double history_interval =
      0.0;  ///< between rows of history.csv and depth.csv; 0: every step [time]
  Glyph glyph = Glyph::deformed;
  ParticleFiles files = ParticleFiles::one;
  CheckpointSpec checkpoint;
};

struct Scene {
  std::string title;
  GridSpec grid;
  std::vector<MaterialSpec> materials;
  std::vector<BodySpec> bodies;
  std::vector<ConditionSpec> conditions;
  std::vector<PressureLoadSpec> loads;
  std::vector<ContactSpec> contacts;
  JetSpec jet;
  BodyForceSpec body_force;
  PoreFlowSpec pore_flow;
  QuasiStaticSpec quasi_static;
  StepSpec step;
  double end_time = 0.0;  ///< [time]
  OutputSpec output;
};

/// The deck's words for the transfer of a step, and for its order.
inline const char* transfer_name(const StepSpec& step) {
  if (step.transfer == Transfer::xpic) return "XPIC";
  if (step.transfer == Transfer::apic) return "APIC";
  return step.pic_fraction == 1.0 ? "PIC" : "FLIP";
}
inline const char* order_name(Order order) {
  if (order == Order::modified_stress_last) return "modified stress last";
  return order == Order::stress_first ? "stress first" : "stress last";
}

/// The deck's word for a mode.
inline const char* mode_name(Mode mode) {
  switch (mode) {
    case Mode::axisymmetric:
      return "axisymmetric";
    case Mode::plane_strain:
      return "plane strain";
    case Mode::three_dimensional:
      break;
  }
  return "3D";
}

/// Coordinates of a mode.
inline int dimensions(Mode mode) {
  return mode == Mode::three_dimensional ? 3 : 2;
}

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#include "check.hpp"

#include "check_flow.hpp"
#include "geometry/piece.hpp"
#include "scene/build_scene.hpp"
#include "scene/velocity_fields.hpp"
#include "shape/shape_facts.hpp"
#include "shape/visit_kernels.hpp"
#include "state/body_particles.hpp"
#include "state/particles.hpp"
#include "state/step_rule.hpp"

#include <algorithm>
#include <cstdarg>
#include <cstdio>
#include <limits>
#include <variant>

namespace barreno {
namespace {

std::string format(const char* pattern, ...) {
  char text[256];
  std::va_list values;
  va_start(values, pattern);
  std::vsnprintf(text, sizeof(text), pattern, values);
  va_end(values);
  return text;
}

std::string box_text(const GridSpec& grid) {
  std::string text;
  for (std::size_t d = 0; d < static_cast<std::size_t>(dimensions(grid.mode)); ++d)
    text += format(d == 0 ? "%g" : " x %g", grid.upper[d] - grid.lower[d]);
  return text;
}

/// One row of the table: feature, on or off, why.
std::string feature(const char* name, bool on, const std::string& why) {
  return format("  %-22s %-4s %s\n", name, on ? "on" : "off", why.c_str());
}

const char* model_name(const Material& material) {
  return std::visit([](const auto& model) { return model.name; }, material.model);
}

/// Fastest particle that a material's bodies or the jet bring in.
double fastest(const Scene& scene, int material) {
  double speed = 0.0;
  for (const BodySpec& body : scene.bodies)
    if (body.material == material)
      speed = std::max(
          speed,
          std::hypot(body.velocity[0], body.velocity[1], body.velocity[2]) +
              std::abs(body.radial_velocity)
      );
  if (scene.jet.present && scene.jet.material == material)
    for (const JetSlug& slug : scene.jet.slugs) speed = std::max(speed, slug.velocity);
  return speed;
}

/// The step that the scene's materials allow before anything has deformed.
double first_stable_step(const Scene& scene) {
  double step = std::numeric_limits<double>::infinity();
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const Material& material = scene.materials[m].material;
    const double courant = visit_shape(scene.step.shape, [&](auto shape) {
      return decltype(shape)::critical_courant(smallest_half_size(scene, static_cast<int>(m)));
    });
    const double modulus = std::visit(
        [](const auto& model) {
          return model.longitudinal_modulus({}, model.initial_history(), 1.0);
        },
        material.model
    );
    const double speed = fastest(scene, static_cast<int>(m));
    step =
        std::min(step, StepRule(scene, courant).stable_step(material.density, modulus, 0.0, speed));
  }
  return step;
}

std::string material_lines(const Scene& scene) {
  std::string text;
  for (std::size_t m = 0; m < scene.materials.size(); ++m) {
    const Material& material = scene.materials[m].material;
    const std::size_t bytes = bytes_per_particle(make_particles(scene, static_cast<int>(m)));
    text += format(
        "  %-22s %s, %.6g kg/m3, %zu bytes per particle\n",
        material.name.c_str(),
        model_name(material),
        material.density,
        bytes
    );
  }
  return text;
}

/// Volumes as filled: how far they are known follows from the shape.
std::string body_lines(const Scene& scene) {
  std::string text;
  const bool plane = scene.grid.mode == Mode::plane_strain;
  for (const BodySpec& body : scene.bodies) {
    double volume = 0.0;
    long long count = 0;
    for_each_body_particle(scene.grid, body, 1, [&](const NewParticle& particle) {
      volume += particle.volume;
      ++count;
    });
    text += format(
        "  %-22s %.6g m3%s (%s), %lld particles\n",
        body.name.c_str(),
        volume,
        plane ? " per m" : "",
        has_exact_pieces(body.shape) ? "exact" : "estimated",
        count
    );
  }
  return text;
}

int count_loads(const Scene& scene, LoadKind kind) {
  return static_cast<int>(std::count_if(
      scene.loads.begin(),
      scene.loads.end(),
      [&](const PressureLoadSpec& load) { return load.kind == kind; }
  ));
}

std::string load_lines(const Scene& scene) {
  const auto line = [&](const char* name, LoadKind kind) {
    const int count = count_loads(scene, kind);
    return feature(name, count > 0, std::to_string(count) + " asked for");
  };
  const auto moves = [](const ConditionSpec& c) { return c.factor.time.size() > 1; };
  const bool tables = std::any_of(scene.conditions.begin(), scene.conditions.end(), moves);
  return line("pressure loads", LoadKind::pressure) +
         line("non-reflecting faces", LoadKind::non_reflecting) +
         line("fluid in cavities", LoadKind::pore_fluid) +
         feature(
             "walls moved by tables",
             tables,
             tables ? "a condition has Times" : "no condition has Times"
         );
}

/// What differs from FLIP, stress last.
std::string transfer_lines(const StepSpec& step) {
  const bool flip = step.transfer == Transfer::flip;
  const std::string name = transfer_name(step);
  return feature(
             "PIC share",
             flip && step.pic_fraction > 0.0,
             flip ? format("PIC Fraction = %g", step.pic_fraction) : "Transfer is " + name
         ) +
         feature(
             "XPIC",
             step.transfer == Transfer::xpic,
             step.transfer == Transfer::xpic
                 ? format("order %d: %d more projections", step.xpic_order, step.xpic_order - 1)
                 : "Transfer is " + name
         ) +
         feature(
             "APIC",
             step.transfer == Transfer::apic,
             step.transfer == Transfer::apic ? "particles keep first moments of the velocity"
                                             : "Transfer is " + name
         ) +
         feature(
             "second projection",
             step.order != Order::stress_last,
             std::string("Order is ") + order_name(step.order)
         );
}

std::string choice_line(const char* name, const Choice& choice) {
  return feature(name, choice.on, choice.why);
}

std::string feature_lines(const Scene& scene) {
  const bool space = scene.grid.mode == Mode::three_dimensional;
  const bool confined =
      std::any_of(scene.bodies.begin(), scene.bodies.end(), [](const BodySpec& body) {
        return body.initial_pressure > 0.0;
      });
  return feature(
             "jet", scene.jet.present, scene.jet.present ? "the deck has a Jet list" : "no Jet list"
         ) +
         feature(
             "initial confinement",
             confined,
             confined ? "bodies start in equilibrium" : "no Confinement list"
         ) +
         load_lines(scene) +
         feature(
             "artificial viscosity",
             scene.step.linear_viscosity + scene.step.quadratic_viscosity > 0.0,
             format("A1 = %g, A2 = %g", scene.step.linear_viscosity, scene.step.quadratic_viscosity)
         ) +
         transfer_lines(scene.step) +
         feature(
             "third dimension",
             space,
             space ? "nodes and particles have three coordinates"
                   : "the mode is two-dimensional: 2D data"
         ) +
         feature(
             "contact",
             !scene.contacts.empty(),
             scene.contacts.empty()
                 ? std::string("no Contact list: materials stick where they meet")
                 : std::to_string(velocity_fields(scene).count) + " velocity fields"
         ) +
         choice_line("pore flow", pore_flow_choice(scene)) +
         choice_line("dormant tiles", dormancy_choice(scene)) +
         choice_line("quasi-static", quasi_static_choice(scene));
}

}  // namespace

void refuse_short_domains(const Deck& deck, const Scene& scene) {
  const double corner = largest_corner(scene);
  // Round-off of the deck's numbers is no reason to refuse it.
  if (!follows_deformation(scene) || scene.step.largest_domain >= corner * (1.0 - 1e-9)) return;
  deck.refuse_value(
      "Step/Largest Domain",
      format(
          "is shorter than undeformed particles (their corners are %.3g cells from the centre); "
          "choose at least that, or more particles per cell",
          corner
      )
  );
}

std::vector<std::string> notes_of(const Deck& deck, const Scene& scene) {
  std::vector<std::string> notes = deck.notes;
  if (const char* const warning = shape_warning(scene)) notes.emplace_back(warning);
  return notes;
}

std::string plan_text(const Scene& scene, const std::vector<std::string>& notes) {
  const double particles = static_cast<double>(first_ids(scene).back() - 1);
  const double step = first_stable_step(scene);
  std::string text = scene.title.empty() ? std::string("The deck is sound.\n")
                                         : scene.title + "\nThe deck is sound.\n";
  text += format(
      "Grid      %s, %s m, cells of %g m\n",
      mode_name(scene.grid.mode),
      box_text(scene.grid).c_str(),
      scene.grid.cell_size
  );
  text += format(
      "Particles %.0f, the whole jet included; about %.0f MB in all\n",
      particles,
      memory_estimate(scene) * 1e-6
  );
  text += format(
      "Time      to %g s, first steps of %.3g s: about %.0f steps, %.3g particle-steps\n",
      scene.end_time,
      step,
      scene.end_time / step,
      particles * scene.end_time / step
  );
  if (!scene.bodies.empty()) text += "Bodies\n" + body_lines(scene);
  text += "Materials\n" + material_lines(scene) + "Features\n" + feature_lines(scene);
  for (const std::string& note : notes) text += "Note: " + note + "\n";
  return text;
}

}  // namespace barreno

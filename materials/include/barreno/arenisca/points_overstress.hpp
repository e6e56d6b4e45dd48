// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "barreno/arenisca/points_pores.hpp"
#include "barreno/arenisca/points_rate.hpp"

namespace barreno::arenisca {

// The overstress at the end of a step of one or several points, and what it does to the fluid and
// to the works (docs/method.md 20).

/// The fluid under the dynamic stress: overstress loads the grains too, and the volumes tell the
/// pressure. What little the difference strains the skeleton (over Km) is left out.
/// @param moves   where it is asked for
/// @param x       I1 of the effective quasi-static stress at the end [stress]
/// @param gained  change of I1 of the overstress [stress]
/// @param[in,out] pores  at the end of the quasi-static step; those under the dynamic stress
/// @return by how much the pressure is higher [stress]
template <class R, class Law>
BARRENO_FUNCTION R press_pores(
    const Law& rock,
    const MaskOf<R>& moves,
    const PoresOf<R>& begin,
    const R& volume_strain,
    const R& x,
    const R& gained,
    PoresOf<R>& pores
) {
  if (!real::any(moves)) return R{};
  const Constituents& c = rock.constituents;
  const R rise = pores.pressure - begin.pressure;
  // The grains of the quasi-static step, by their volume, and what is added to their load.
  GrainsOf<R> grains;
  // Their compliance is that of the end: overstress changes little of it.
  const R per_matrix = compliances_at(c, pores, x).whole;
  grains.slope = R{} - per_matrix;
  grains.begin = real::log(R(pores.solid / begin.solid)) + volume_strain - grains.slope * rise +
                 gained * R((1.0 / 3.0) * per_matrix) / begin.solid;
  const FilledOf<R> f =
      c.change ? fill_changing_pores(c, begin, TangentGrainsOf<R>{grains}, volume_strain, rise)
               : fill_pores(c, begin, grains, volume_strain, rise);
  assign_where(moves, f.end, pores);
  return real::select(moves, f.end.pressure - begin.pressure - rise, 0.0);
}

/// Stress and pores at the end of a step, and its works per current volume.
template <class R>
struct StepEnd {
  Sym3Of<R> stress;
  PoresOf<R> pores;
  R elastic_work, plastic_work;
};

/// The overstress of a step.
template <class R>
struct OverstressStepOf {
  RelaxationOf<R> relaxation;
  Sym3Of<R> before, after;
  Sym3Of<R> missed;  ///< change of the effective stress had the step been elastic, less what it was
  ModuliOf<R> moduli;
};

/// Works of the dynamic stress in rock with damage or heat, from those of the quasi-static answer:
/// what is dissipated is the dynamic stress times the viscoplastic strain (docs/method.md 20).
/// @param twice_mean  effective quasi-static stress before the step and after it
/// @param gained  work that overstress adds to that of the quasi-static stress
/// @param[in,out] end  where `some`
template <class R>
BARRENO_FUNCTION void add_dynamic_works(
    const OverstressStepOf<R>& o,
    const MaskOf<R>& some,
    const Sym3Of<R>& twice_mean,
    const R& gained,
    StepEnd<R>& end
) {
  const R taken = share_taken(o.relaxation);
  const Sym3Of<R> released = released_strain(o.relaxation, o.before, o.moduli);
  const Sym3Of<R> flow = taken * elastic_strain(o.missed, o.moduli) + released;
  const R dissipated = taken * end.plastic_work +
                       0.5 * (contract(twice_mean, released) + contract(o.before + o.after, flow));
  const R work = end.elastic_work + end.plastic_work + gained;
  end.elastic_work = real::select(some, work - dissipated, end.elastic_work);
  end.plastic_work = real::select(some, dissipated, end.plastic_work);
}

/// The overstress at the end of a step, and the works of the dynamic stress.
/// @param missed  change of the effective stress had the step been elastic, less what it was
/// @param begin   pores before the step
/// @param[in,out] end  under the quasi-static stress; under the dynamic one
template <class R, class Law, class Points>
BARRENO_FUNCTION void add_overstress(
    const Law& rock,
    const MaskOf<R>& choice,
    const Sym3Of<R>& missed,
    const ModuliOf<R>& moduli,
    const PoresOf<R>& begin,
    Points& p,
    StepEnd<R>& end
) {
  if (rock.T1 == 0.0) return;
  const Sym3Of<R> over = overstress_of<R>(p.history);
  const RelaxationOf<R> relaxation = relaxation_in(rock.T1, rock.T2, p.increment);
  const Sym3Of<R> new_over = relaxed(relaxation, missed, over);
  const MaskOf<R> over_any = contract(over, over) + contract(new_over, new_over) > 0.0;
  Sym3Of<R> strain = p.increment.strain;
  // What grains expand the law has not seen.
  if constexpr (Law::heated)
    strain = strain - isotropic(R(p.history.thermal_expansion * (1.0 / 3.0)));
  const Sym3Of<R> seen = strain;
  const Sym3Of<R> quasi_static = end.stress + isotropic(end.pores.pressure);
  const Sym3Of<R> quasi_static_total = end.stress;
  if constexpr (has_poroplastic_fluid<Law>) {
    const MaskOf<R> moves = over_any & (p.increment.dt > 0.0);
    const R gained = trace(new_over - over);
    const R x = trace(quasi_static);
    const R more = press_pores(rock, moves, begin, trace(strain), x, gained, end.pores);
    end.stress = end.stress - isotropic(more);
    const R rise = end.pores.pressure - begin.pressure;
    const R x_begin = trace(p.stress - over) + 3.0 * begin.pressure;
    const R per_matrix = per_matrix_between(
        rock.constituents, R(begin.pressure + end.pores.pressure), R(x_begin + x)
    );
    strain = strain + isotropic(R(rise * R((1.0 / 3.0) * per_matrix)));
  }
  const Sym3Of<R> before = p.stress + isotropic(begin.pressure);
  end.stress = end.stress + new_over;
  if constexpr (Law::damaged) {
    const R gained = 0.5 * contract(over + (end.stress - quasi_static_total), seen);
    const Sym3Of<R> twice_mean = (before - over) + quasi_static;
    add_dynamic_works<R>(
        {relaxation, over, new_over, missed, moduli}, over_any, twice_mean, gained, end
    );
  } else {
    const Sym3Of<R> after = end.stress + isotropic(end.pores.pressure);
    const R work = 0.5 * contract(p.stress + end.stress, p.increment.strain);
    const R dissipated = dissipated_work(strain, before, after, moduli);
    end.plastic_work = real::select(over_any, dissipated, end.plastic_work);
    end.elastic_work = real::select(over_any, work - dissipated, end.elastic_work);
  }
  set_overstress<R>(choice, new_over, p.history);
}

}  // namespace barreno::arenisca

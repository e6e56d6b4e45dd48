// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <type_traits>

namespace barreno {

/// Explosives: models that burn by a program of lighting times. They have burn(end of the step,
/// cell size, history), and say which columns of their history hold lighting time and fraction.
template <class Model, class = void>
inline constexpr bool burns_by_program = false;
template <class Model>
inline constexpr bool burns_by_program<Model, std::void_t<decltype(Model::lighting_column)>> = true;

/// Models whose particles are divided where they become wider than a cell: splits_column of the
/// history counts that, and Parameters::splits says how often it may be.
template <class Model, class = void>
inline constexpr bool divides_particles = false;
template <class Model>
inline constexpr bool divides_particles<Model, std::void_t<decltype(Model::splits_column)>> = true;

/// Expansion V / V_ref up to which a model's points are followed, where it differs from that of the
/// step.
template <class Model, class = void>
inline constexpr double own_largest_expansion = 0.0;
template <class Model>
inline constexpr double
    own_largest_expansion<Model, std::void_t<decltype(Model::largest_expansion)>> =
        Model::largest_expansion;

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "scene/scene.hpp"

#include <barreno/models.hpp>
#include <barreno/tensor.hpp>
#include <type_traits>
#include <utility>
#include <variant>

namespace barreno {

/// Models that know heat: correct_energy(history before, gain, history).
template <class Model, class = void>
inline constexpr bool keeps_heat = false;
template <class Model>
inline constexpr bool keeps_heat<
    Model,
    std::void_t<decltype(std::declval<const Model&>().correct_energy(
        std::declval<const typename Model::History&>(),
        0.0,
        std::declval<typename Model::History&>()
    ))>> = true;

/// Rock with heat: add_heat(heat, stress, history).
template <class Model, class = void>
inline constexpr bool is_heated_rock = false;
template <class Model>
inline constexpr bool is_heated_rock<Model, std::enable_if_t<Model::Law::heated>> = true;

/// What a step loses of the energy of a material's particles becomes their heat. docs/method.md
/// (2.13)
inline bool takes_losses(const Scene& scene, int material) {
  return scene.step.return_losses &&
         std::visit(
             [](const auto& model) {
               using Model = std::decay_t<decltype(model)>;
               if constexpr (is_heated_rock<Model>)
                 return model.parameters().specific_heat > 0.0;
               else
                 return keeps_heat<Model>;
             },
             scene.materials[static_cast<std::size_t>(material)].material().model
         );
}

}  // namespace barreno

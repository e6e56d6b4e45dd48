// SPDX-License-Identifier: BSD-3-Clause
// A finite element code in C++ that takes the models themselves: the same point as in consumer.c.
#include <barreno/find_card.hpp>
#include <barreno/tangent.hpp>
#include <cmath>
#include <cstdio>

template <class Model>
int squeeze(const Model& model) {
  barreno::Sym3 stress{};
  auto history = model.initial_history();
  barreno::Tangent tangent;
  double volume_ratio = 1.0;
  for (int i = 0; i < 10; ++i) {
    barreno::Increment increment{};
    increment.strain.xx = -1e-3;
    increment.dt = 1e-3;
    increment.volume_ratio_begin = volume_ratio;
    increment.volume_ratio_end = volume_ratio *= std::exp(trace(increment.strain));
    const barreno::Outcome outcome =
        barreno::update_with_tangent(model, increment, stress, history, tangent);
    if (outcome.failed()) return 1;
  }
  std::printf("%s %.17g %.17g %.17g\n", Model::name, stress.xx, stress.yy, tangent.c[0][0]);
  return 0;
}

int main(int argc, char** argv) {
  try {
    const barreno::Material material =
        barreno::material_open(argc > 1 ? argv[1] : "berea_sandstone");
    return std::visit([](const auto& model) { return squeeze(model); }, material.model);
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}

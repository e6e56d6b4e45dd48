// SPDX-License-Identifier: BSD-3-Clause
#include "unit/step/transfer_cases.hpp"

#include "shape/visit_kernels.hpp"

#include <cstdlib>

namespace barreno::testing {
namespace {

StepCase transfer_case(const char* name, Transfer transfer, double pic_fraction, int order) {
  StepCase out;
  out.name = name;
  out.step.transfer = transfer;
  out.step.pic_fraction = pic_fraction;
  out.step.xpic_order = order;
  return out;
}

}  // namespace

std::vector<StepCase> all_transfers() {
  return {
      transfer_case("FLIP", Transfer::flip, 0.0, 2),
      transfer_case("a tenth of PIC", Transfer::flip, 0.1, 2),
      transfer_case("PIC", Transfer::flip, 1.0, 2),
      transfer_case("XPIC(2)", Transfer::xpic, 0.0, 2),
      transfer_case("XPIC(3)", Transfer::xpic, 0.0, 3),
      transfer_case("APIC", Transfer::apic, 1.0, 2)};
}

std::vector<StepCase> all_steps(const std::string& shape) {
  std::vector<StepCase> out;
  for (const Order order : {Order::stress_last, Order::modified_stress_last, Order::stress_first})
    for (StepCase one : all_transfers()) {
      one.step.order = order;
      one.step.shape = shape;
      one.name += std::string(", ") + word_of(order) + ", " + shape;
      out.push_back(one);
    }
  return out;
}

std::vector<StepCase> steps_in_turn(const std::string& shape, int turn) {
  std::vector<StepCase> all = all_steps(shape);
  if (std::getenv("BARRENO_EVERY_STEP") != nullptr) return all;
  const std::size_t transfers = all_transfers().size();
  std::vector<StepCase> out;
  for (std::size_t i = 0; i < all.size(); ++i)
    if ((i / transfers + i % transfers + static_cast<std::size_t>(turn)) % 2 == 0)
      out.push_back(all[i]);
  return out;
}

std::vector<std::string> all_shapes() {
  std::vector<std::string> out;
  for_each_shape([&](auto shape) { out.emplace_back(decltype(shape)::word); });
  return out;
}

}  // namespace barreno::testing

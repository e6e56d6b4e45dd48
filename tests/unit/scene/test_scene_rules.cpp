// SPDX-License-Identifier: BSD-3-Clause
#include "deck/sections/pore_flow_section.hpp"
#include "deck/table.hpp"
#include "scene/dormant.hpp"
#include "scene/geometry.hpp"
#include "scene/heat.hpp"
#include "scene/input_speeds.hpp"
#include "scene/porous.hpp"
#include "scene/quasi_static_spec.hpp"
#include "scene/velocity_fields.hpp"
#include "support/scenes.hpp"

#include <gtest/gtest.h>

#include <barreno/models.hpp>

namespace barreno {
namespace {

const Vector low{0.0, 0.0, 0.0}, high{1.0, 1.0, 0.0};

/// So many materials without a body, all elastic.
Scene scene_of(int materials) {
  const MaterialSpec glass = testing::elastic(1e9, 0.2, 2500.0);
  Scene scene = testing::box_scene(Mode::plane_strain, 0.1, low, high, glass);
  for (int m = 1; m < materials; ++m) scene.materials.push_back(glass);
  return scene;
}

TEST(Table, IsLinearBetweenItsTimesAndConstantOutside) {
  const Table table{{1.0, 3.0, 4.0}, {10.0, 20.0, -20.0}};
  EXPECT_EQ(table(0.0), 10.0);
  EXPECT_EQ(table(1.0), 10.0);
  EXPECT_EQ(table(2.0), 15.0);
  EXPECT_EQ(table(3.0), 20.0);
  EXPECT_EQ(table(3.5), 0.0);
  EXPECT_EQ(table(9.0), -20.0);
  EXPECT_EQ(Table{}(5.0), 0.0);
}

TEST(InputSpeeds, AreThoseOfBodiesFacesAndSpin) {
  Scene scene = scene_of(1);
  EXPECT_EQ(largest_input_speed(scene), 0.0);
  BodySpec& body = scene.bodies.emplace_back();
  body.shape = Box{low, high};
  body.velocity = {3.0, -4.0, 0.0};
  body.radial_velocity = -1.0;
  EXPECT_DOUBLE_EQ(body_speed(body, scene.grid), 6.0);
  body.spin = -2.0;  // of a square of 1 m, whatever the size of the grid
  EXPECT_DOUBLE_EQ(rim_speed(body, scene.grid), 2.0 * std::sqrt(2.0));
  EXPECT_DOUBLE_EQ(largest_input_speed(scene), 6.0 + 2.0 * std::sqrt(2.0));
  ConditionSpec face;
  face.velocity = {0.0, 2.0, 0.0};
  face.factor = {{0.0, 1.0}, {1.0, -10.0}};
  scene.conditions.push_back(face);
  EXPECT_DOUBLE_EQ(face_speed(face), 20.0);
  EXPECT_DOUBLE_EQ(largest_input_speed(scene), 20.0);
}

TEST(Distance, IsEuclidean) {
  EXPECT_DOUBLE_EQ(distance({1.0, 2.0, 3.0}, {3.0, 5.0, 9.0}), 7.0);
}

TEST(DormantTiles, NeedForcesThatStayTheSame) {
  Scene scene = scene_of(1);
  EXPECT_EQ(why_all_awake(scene), "");
  scene.step.order = Order::stress_first;
  EXPECT_NE(why_all_awake(scene).find("Order is stress first"), std::string::npos);
  scene.step.order = Order::stress_last;
  scene.step.transfer = Transfer::apic;
  EXPECT_NE(why_all_awake(scene).find("APIC"), std::string::npos);
  scene.step.transfer = Transfer::flip;
  PressureLoadSpec load;
  scene.loads.push_back(load);
  EXPECT_EQ(why_all_awake(scene), "");
  scene.loads[0].pressure = {{0.0, 1.0}, {0.0, 1e6}};
  EXPECT_NE(why_all_awake(scene).find("load"), std::string::npos);
  scene.loads.clear();
  scene.body_force.kind = BodyForceKind::gravity;
  EXPECT_NE(why_all_awake(scene).find("body force"), std::string::npos);
}

TEST(DormantTiles, MayMoveByRoundOffWhereBodiesStartUnderPressure) {
  Scene scene = scene_of(1);
  testing::add_box(scene, "block", low, high, 2);
  EXPECT_EQ(rest_motion(scene), 0.0);
  scene.bodies[0].initial_pressure = 1e6;
  EXPECT_EQ(rest_motion(scene), 0x1p-53);
  scene.step.rest_motion = 1e-6;
  EXPECT_EQ(rest_motion(scene), 1e-6);
}

TEST(VelocityFields, AreSharedByMaterialsWithTheSameContacts) {
  Scene scene = scene_of(4);
  EXPECT_EQ(velocity_fields(scene).count, 1);
  scene.contacts.push_back({"a", {0, 2}, ContactKind::friction, 0.3});
  scene.contacts.push_back({"b", {2, 1}, ContactKind::friction, 0.3});
  const VelocityFields fields = velocity_fields(scene);
  // 0 and 1 both slide on 2; 3 is bonded to all.
  EXPECT_EQ(fields.of_material, (std::vector<int>{0, 0, 1, 2}));
  ASSERT_EQ(fields.pairs.size(), 3U);
  EXPECT_EQ(fields.pairs[0].kind, ContactKind::friction);
  EXPECT_EQ(fields.pairs[0].friction, 0.3);
  EXPECT_EQ(fields.pairs[1].kind, ContactKind::bonded);
  scene.contacts[1].friction = 0.4;
  EXPECT_EQ(velocity_fields(scene).of_material, (std::vector<int>{0, 1, 2, 3}));
}

TEST(VelocityFields, GiveARigidBodyOneOfItsOwn) {
  Scene scene = scene_of(3);
  for (const int material : {1, 2}) {
    BodySpec& body = testing::add_box(scene, "rigid", low, high, 2);
    body.material = material;
    body.motion.prescribed = true;
  }
  EXPECT_EQ(rigid_body_of(scene, 0), -1);
  EXPECT_EQ(rigid_body_of(scene, 2), 1);
  const VelocityFields fields = velocity_fields(scene);
  EXPECT_EQ(fields.rigid_body, (std::vector<int>{-1, 0, 1}));
  EXPECT_EQ(fields.pairs.size(), 2U);  // two rigid bodies do nothing to each other
}

TEST(Heat, IsTakenByModelsThatKnowIt) {
  Scene scene = scene_of(1);
  scene.materials.push_back(testing::copper());
  EXPECT_FALSE(takes_losses(scene, 1));
  scene.step.return_losses = true;
  EXPECT_FALSE(takes_losses(scene, 0));
  EXPECT_TRUE(takes_losses(scene, 1));
}

TEST(Porous, IsAMaterialWhoseFluidDrains) {
  EXPECT_FALSE(testing::copper().is_porous());
  EXPECT_FALSE(testing::elastic(1e9, 0.2, 2500.0).is_porous());
  BodySpec body;
  const LinearElastic glass({1e9, 0.6e9}, 2500.0);
  EXPECT_TRUE(initial_state_of(glass, body).possible);
  body.pore_pressure = 1e5;  // which glass cannot hold
  EXPECT_FALSE(initial_state_of(glass, body).possible);
}

TEST(Specs, AreOffUnlessAskedFor) {
  EXPECT_FALSE(PoreFlowSpec{}.on());
  EXPECT_FALSE(QuasiStaticSpec{}.on());
  QuasiStaticSpec slow;
  slow.transit_time = 1e-3;
  EXPECT_TRUE(slow.on());
}

}  // namespace
}  // namespace barreno

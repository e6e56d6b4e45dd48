// SPDX-License-Identifier: BSD-3-Clause
/// One material point under prescribed strains and stresses, against closed forms and other paths.
#include "base/error.hpp"
#include "drive/drive_mixed.hpp"
#include "materials/sample_models.hpp"

#include <gtest/gtest.h>

#include <barreno/input/scan_xml.hpp>
#include <cmath>

namespace barreno::test {
namespace {

constexpr double bulk = 16e9, shear = 12e9;

Material elastic() {
  return {"Glass", 2500.0, LinearElastic({bulk, shear}, 2500.0)};
}
template <class Model>
Material rock(const typename Model::Parameters& p) {
  return {"Rock", 2300.0, Model(p, 2300.0)};
}
Arenisca::Parameters fine_rock() {
  Arenisca::Parameters p = Sample<Arenisca>::parameters();
  p.tolerance = 1e-6;
  return p;
}
Arenisca::Parameters wet_rock(double pore_pressure) {
  Arenisca::Parameters p = Sample<WetArenisca>::parameters();
  p.tolerance = 1e-6;
  p.fluid_pressure_initial = pore_pressure;
  return p;
}
std::vector<MixedAnswer> drive_text(const Material& material, const std::string& text, int steps) {
  return drive_mixed(material, read_mixed_path(text, "path"), {steps}, "path");
}
template <class Error, class Call>
std::string sentence_of(const Call& call) {
  try {
    call();
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}
double shear_stress(const MixedAnswer& a) {
  return std::sqrt(0.5 * contract(deviator(a.stress), deviator(a.stress)));
}

TEST(MixedPath, BadHeadersAreRefusedWithWhatIsMeant) {
  const auto sentence = [](const std::string& header) {
    return sentence_of<InputError>([&] { read_mixed_path(header + "\n0,0\n1,0\n", "path"); });
  };
  EXPECT_NE(sentence("time,stres_xx").find("did you mean 'stress_xx'?"), std::string::npos);
  EXPECT_NE(sentence("stress_xx,stress_yy").find("begin with time"), std::string::npos);
  EXPECT_NE(sentence("time,stress_xx,stress_xx").find("is there twice"), std::string::npos);
  const auto first =
      sentence_of<InputError>([] { read_mixed_path("time,strain_xx\n0,1e-3\n1,2e-3\n", "path"); });
  EXPECT_NE(first.find("line 2, strain_xx = 0.001"), std::string::npos) << first;
}

TEST(MixedPath, ComponentsAndUnitsAreRead) {
  const MixedPath path =
      read_mixed_path("# a comment\ntime,strain_zx,stress_yy\n0,0,0\n2 ms,0.1,3 MPa\n", "path");
  EXPECT_EQ(path.rows[1].time, 2e-3);
  EXPECT_EQ(path.rows[1].target[5], 0.1);
  EXPECT_EQ(path.rows[1].target[1], 3e6);
  EXPECT_TRUE(path.rows[1].by_stress[1] && !path.rows[1].by_stress[5] && !path.rows[1].drained);
  EXPECT_TRUE(is_mixed_path("time,stress_xx\n", "p") && !is_mixed_path("time,F11\n", "p"));
}

TEST(MixedPath, ColumnsOfLaboratoriesPrescribeAxisAndSide) {
  const MixedPath path = read_mixed_path(
      "# compression: positive\nTime [s];Axial strain [%];Confinement [MPa]\n0;0;0\n1;2,5;40\n",
      "path"
  );
  const MixedRow& row = path.rows[1];
  EXPECT_DOUBLE_EQ(row.target[0], std::log1p(-0.025));
  EXPECT_EQ(row.target[1], -40e6);
  EXPECT_EQ(row.target[2], -40e6);
  EXPECT_TRUE(!row.by_stress[0] && row.by_stress[1] && row.by_stress[2]);
  EXPECT_FALSE(path.notes.empty());
  const MixedPath other = read_mixed_path(
      "# compression: negative\n# strain: logarithmic\ntime,axial_strain [%],radial_stress [MPa]\n"
      "0,0,0\n1,-2.5,-40\n",
      "path"
  );
  EXPECT_DOUBLE_EQ(other.rows[1].target[0], -0.025);
  EXPECT_EQ(other.rows[1].target[2], -40e6);
  EXPECT_EQ(read_mixed_path("time,strain_xx [%]\n0,0\n1,-3\n", "path").rows[1].target[0], -0.03);
}

TEST(MixedPath, WhatALaboratoryLeavesOpenIsAskedFor) {
  const auto sentence = [](const std::string& text) {
    return sentence_of<InputError>([&] { read_mixed_path(text, "path"); });
  };
  const std::string said = "# compression: positive\n", table = "time,axial_strain [%]\n0,0\n1,3\n";
  EXPECT_NE(sentence(table).find("add a line \"# compression: positive\""), std::string::npos);
  EXPECT_NE(
      sentence("# compression: up\n" + table).find("neither positive nor"), std::string::npos
  );
  EXPECT_NE(
      sentence(said + "time,axial_strain\n0,0\n1,3\n").find("line 4, axial_strain = 3 has no unit"),
      std::string::npos
  );
  EXPECT_NE(
      sentence(said + "time,axial_strain [-]\n0,0\n1,3\n").find("leaves nothing of the specimen"),
      std::string::npos
  );
  EXPECT_NE(
      sentence(said + "time,axial_strain [%],strain_xx\n0,0,0\n1,3,0\n").find("is there twice"),
      std::string::npos
  );
}

TEST(MixedPath, AnEmptyCellLeavesTheComponentToTheOtherControl) {
  const MixedPath path = read_mixed_path(
      "time,strain_xx,stress_xx,pore_pressure\n0,,0,1e6\n1, ,-5 MPa,1e6\n2,-0.1,,\n", "path"
  );
  EXPECT_TRUE(path.rows[1].by_stress[0] && path.rows[1].drained);
  EXPECT_EQ(path.rows[1].target[0], -5e6);
  EXPECT_TRUE(!path.rows[2].by_stress[0] && !path.rows[2].drained);
  EXPECT_EQ(path.rows[2].target[0], -0.1);
}

TEST(MixedPath, ACellTooManyOrTooFewIsRefusedWithItsLine) {
  const auto sentence = [](const std::string& text) {
    return sentence_of<InputError>([&] { read_mixed_path(text, "path"); });
  };
  const std::string both = "time,strain_xx,stress_xx\n0,0,\n";
  EXPECT_EQ(
      sentence(both + "1,-1e-3,-1e6\n"),
      "path: line 3 gives both strain_xx and stress_xx (a component is controlled by one of them); "
      "leave one of the two cells empty."
  );
  EXPECT_EQ(
      sentence(both + "1,,\n"),
      "path: line 3 gives neither strain_xx nor stress_xx (a component is controlled by one of "
      "them); fill one of the two cells."
  );
  EXPECT_EQ(
      sentence("time,stress_xy\n0,0\n1,\n"),
      "path: line 3 leaves stress_xy empty, and there is no column strain_xy that could control "
      "the "
      "component instead; write a value, or add that column."
  );
  const std::string timeless = sentence("time,stress_xx\n0,0\n,1e6\n");
  EXPECT_NE(timeless.find("path: line 3, time = \"\""), std::string::npos) << timeless;
}

/// The confinement by stress leaves the strain free, from which the strain of the next row counts
/// on.
TEST(DriveMixed, ControlChangesWhereThePointIs) {
  const auto rows = drive_text(
      elastic(),
      "time,strain_xx,stress_xx,stress_yy,stress_zz\n0,,0,0,0\n1,,-3e6,-3e6,-3e6\n"
      "2,-1e-3,,-3e6,-3e6\n3,,-3e6,-3e6,-3e6\n",
      4
  );
  const double young = 9.0 * bulk * shear / (3.0 * bulk + shear);
  const double squeezed = -3e6 / (3.0 * bulk);
  EXPECT_NEAR(rows[1].strain.xx / squeezed, 1.0, 1e-6);
  EXPECT_NEAR(rows[2].stress.xx / (-3e6 + young * (-1e-3 - squeezed)), 1.0, 1e-6);
  EXPECT_NEAR(rows[2].stress.yy / -3e6, 1.0, 1e-6);
  EXPECT_NEAR(rows[3].strain.xx / squeezed, 1.0, 1e-5);
}

TEST(DriveMixed, EveryStepHasARowWhoseLastOfARowIsThatOfThePath) {
  const Material material = rock<Arenisca>(fine_rock());
  const MixedPath path = read_mixed_path(
      "time,strain_xx,stress_xx,stress_yy,stress_zz\n0,,0,0,0\n1,,-30e6,-30e6,-30e6\n"
      "3,-0.03,,-30e6,-30e6\n",
      "path"
  );
  constexpr int steps = 25;
  const auto few = drive_mixed(material, path, {steps}, "path");
  const auto all = drive_mixed(material, path, {steps, true}, "path");
  ASSERT_EQ(few.size(), 3u);
  ASSERT_EQ(all.size(), 2u * steps + 1u);
  for (std::size_t i = 0; i < few.size(); ++i) {
    EXPECT_EQ(few[i].time, all[i * steps].time);
    EXPECT_EQ(few[i].stress.xx, all[i * steps].stress.xx);
    EXPECT_EQ(few[i].history, all[i * steps].history);
  }
  EXPECT_NEAR(all[steps + 1].time, 1.0 + 2.0 / steps, 1e-12);
  for (std::size_t i = 0; i <= steps; ++i) {
    EXPECT_NEAR(all[i].stress.xx, all[i].stress.yy, 1.0);  // hydrostatic on the way
    EXPECT_NEAR(all[i].stress.xx, -30e6 * static_cast<double>(i) / steps, 10.0);
  }
}

/// Consolidated and undrained: the tap is open, then closed, then opened again.
TEST(DriveMixed, AnEmptyPorePressureClosesTheTap) {
  const auto rows = drive_text(
      rock<WetArenisca>(wet_rock(20e6)),
      "time,stress_xx,stress_yy,stress_zz,pore_pressure\n0,-20e6,-20e6,-20e6,20e6\n"
      "1,-40e6,-40e6,-40e6,20e6\n2,-50e6,-50e6,-50e6,\n3,-50e6,-50e6,-50e6,20e6\n",
      20
  );
  const auto mass = [&](std::size_t i) { return rows[i].history[2]; };
  const auto pressure = [&](std::size_t i) { return rows[i].history[3]; };
  EXPECT_NEAR(pressure(1), 20e6, 10.0);
  EXPECT_LT(mass(1), 1.0);
  EXPECT_EQ(mass(2), mass(1));
  EXPECT_GT(pressure(2), 21e6);
  EXPECT_NEAR(pressure(3), 20e6, 10.0);
  EXPECT_LT(mass(3), mass(2));
}

TEST(DriveMixed, UniaxialStressHasYoungsModulusAndPoissonsRatio) {
  const auto rows =
      drive_text(elastic(), "time,strain_xx,stress_yy,stress_zz\n0,0,0,0\n1,1e-3,0,0\n", 1);
  const double young = 9.0 * bulk * shear / (3.0 * bulk + shear);
  const double nu = 0.5 * young / shear - 1.0;
  EXPECT_NEAR(rows[1].stress.xx / (young * 1e-3), 1.0, 1e-7);
  EXPECT_NEAR(rows[1].strain.yy / (-nu * 1e-3), 1.0, 1e-7);
  EXPECT_NEAR(rows[1].strain.zz / (-nu * 1e-3), 1.0, 1e-7);
}

TEST(DriveMixed, ShearStressGivesItsStrain) {
  const auto rows = drive_text(elastic(), "time,stress_xy\n0,0\n1,30 MPa\n", 1);
  EXPECT_NEAR(rows[1].strain.xy, 30e6 / (2.0 * shear), 1e-12);
}

/// A path in stress, a row for every step of a path in strain, leads through the same states.
TEST(DriveMixed, StressesLeadBackToStrains) {
  const Material material = rock<Arenisca>(fine_rock());
  constexpr int rows = 40;
  std::string strains = "time,strain_xx,strain_yy,strain_zz\n0,0,0,0\n";
  for (int i = 1; i <= rows; ++i) {
    const double part = static_cast<double>(i) / rows;
    strains += std::to_string(i);
    for (const double end : {-0.05, -0.03, -0.025}) strains += "," + input::exact_text(part * end);
    strains += "\n";
  }
  const auto by_strain = drive_text(material, strains, 1);
  std::string stresses = "time,stress_xx,stress_yy,stress_zz\n0,0,0,0\n";
  for (std::size_t i = 1; i < by_strain.size(); ++i) {
    const Sym3& s = by_strain[i].stress;
    stresses += std::to_string(i);
    for (const double value : {s.xx, s.yy, s.zz}) stresses += "," + input::exact_text(value);
    stresses += "\n";
  }
  const auto by_stress = drive_text(material, stresses, 1);
  for (std::size_t i = 1; i < by_strain.size(); ++i) {
    EXPECT_NEAR(by_stress[i].strain.xx, by_strain[i].strain.xx, 1e-6 * 0.05);
    EXPECT_NEAR(by_stress[i].strain.zz, by_strain[i].strain.zz, 1e-6 * 0.05);
  }
}

TEST(DriveMixed, ATriaxialTestEndsOnTheYieldSurface) {
  const Arenisca::Parameters p = fine_rock();
  const auto rows = drive_text(
      rock<Arenisca>(p),
      "time,strain_xx,stress_yy,stress_zz\n0,0,0,0\n1,-1e-3,-30 MPa,-30 MPa\n2,-0.04,-30 MPa,-30 "
      "MPa\n",
      50
  );
  const arenisca::Rock law = Arenisca(p, 2300.0).rock();
  arenisca::NoCounter none;
  const auto at = law.surface.at(trace(rows[2].stress), law.cap_at(rows[2].history[0]), none);
  EXPECT_NEAR(shear_stress(rows[2]) / (at.limit * std::sqrt(at.cap_squared)), 1.0, 1e-6);
  EXPECT_NEAR(rows[2].stress.yy / -30e6, 1.0, 1e-6);
}

/// Fluid flows after the strain of a step: first order in the steps.
TEST(DriveMixed, DrainedRockTendsToDryRockUnderTheEffectiveStress) {
  const auto dry = drive_text(
      rock<Arenisca>(fine_rock()),
      "time,strain_xx,stress_yy,stress_zz\n0,0,0,0\n1,-1e-3,-30e6,-30e6\n2,-0.03,-30e6,-30e6\n",
      400
  );
  const auto apart = [&](int steps) {
    const auto drained = drive_text(
        rock<WetArenisca>(wet_rock(20e6)),
        "time,strain_xx,stress_yy,stress_zz,pore_pressure\n0,0,-20e6,-20e6,20e6\n"
        "1,-1e-3,-50e6,-50e6,20e6\n2,-0.03,-50e6,-50e6,20e6\n",
        steps
    );
    EXPECT_NEAR(drained[1].stress.xx + 20e6, dry[1].stress.xx, 1e3);  // elastic
    EXPECT_NEAR(drained[2].history[3], 20e6, 10.0);
    return std::fabs((drained[2].stress.xx + 20e6) / dry[2].stress.xx - 1.0);
  };
  const double coarse = apart(100), fine = apart(400);
  EXPECT_LE(coarse, 2e-3);
  EXPECT_LE(fine, 0.35 * coarse);
}

TEST(DriveMixed, UndrainedPressureRisesBySkemptonsB) {
  const auto p = wet_rock(20e6);
  const WetArenisca model(p, 2300.0);
  const auto rows = drive_text(
      rock<WetArenisca>(p),
      "time,stress_xx,stress_yy,stress_zz\n0,-20e6,-20e6,-20e6\n1,-20.1e6,-20.1e6,-20.1e6\n",
      10
  );
  const auto start = model.initial_state(0.0);
  const PorePoint pores = model.pore_point(start.stress, start.history);
  const double drained = model.drained_moduli(start.stress, start.history).bulk;
  const double borne = pores.biot / pores.storage;
  const double skempton = borne / (drained + pores.biot * borne);
  const double rise = rows[1].history[3] - 20e6;
  EXPECT_NEAR(rise / (skempton * 0.1e6), 1.0, 1e-3);
}

TEST(DriveMixed, AStressBeyondTheStrengthIsRefusedWithTheLastThatWasReached) {
  const Arenisca::Parameters p = fine_rock();
  const auto text = sentence_of<NumericalError>([&] {
    drive_text(
        rock<Arenisca>(p),
        "time,stress_xx,stress_yy,stress_zz\n0,0,0,0\n1,-30e6,-30e6,-30e6\n2,-900e6,-30e6,-30e6\n",
        20
    );
  });
  EXPECT_NE(text.find("path: line 4 cannot be reached"), std::string::npos) << text;
  EXPECT_NE(text.find("prescribe strain_xx"), std::string::npos) << text;
}

TEST(DriveMixed, APathBeginsAtTheVirginPoint) {
  const auto loaded =
      sentence_of<InputError>([&] { drive_text(elastic(), "time,stress_xx\n0,1e6\n1,2e6\n", 1); });
  EXPECT_NE(loaded.find("line 2, stress_xx = 1e+06"), std::string::npos) << loaded;
  const auto dry = sentence_of<InputError>([&] {
    drive_text(elastic(), "time,pore_pressure\n0,0\n1,2e6\n", 1);
  });
  EXPECT_NE(dry.find("holds no fluid"), std::string::npos) << dry;
}

}  // namespace
}  // namespace barreno::test

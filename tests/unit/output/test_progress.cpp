// SPDX-License-Identifier: BSD-3-Clause
#include "output/progress.hpp"
#include "output/result_numbers.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <algorithm>

namespace barreno {
namespace {

TEST(Progress, SaysDurationsAsAPersonDoes) {
  EXPECT_EQ(duration_text(0.4), "0 s");
  EXPECT_EQ(duration_text(59.4), "59 s");
  EXPECT_EQ(duration_text(200.0), "3 min 20 s");
  EXPECT_EQ(duration_text(7500.0), "2 h 5 min");
  EXPECT_EQ(duration_text(-1.0), "?");
}

TEST(Progress, LogsALineEveryTenthAndEachWarningOnce) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder(*comm);
  if (comm->getRank() != 0) return;
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  {
    Progress progress(folder.path() / "run.log", {1.0, 1.0}, false);
    for (int i = 0; i <= 100; ++i) progress.show({0.01 * i, 0.01, i, 10.0, 10.0 * i, 0.0});
    progress.warn("odd things", "3 odd things by t = 1 s.", 3);
    progress.warn("odd things", "4 odd things by t = 2 s.");
    progress.list_warnings();
  }
  const std::string screen = testing::internal::GetCapturedStdout();
  const std::string log = synthetic::read_text(folder.path() / "run.log");
  const std::string warnings = testing::internal::GetCapturedStderr();
  EXPECT_EQ(screen + warnings, log);
  EXPECT_EQ(warnings.find("warning: 3 odd things"), 0U) << warnings;
  EXPECT_EQ(std::count(screen.begin(), screen.end(), '\n'), 11);
  EXPECT_NE(
      log.find("warning: 3 odd things by t = 1 s.\nwarning: odd things: 4 times in total\n"),
      std::string::npos
  );
}

TEST(Progress, TheLastLineSaysTheEnd) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder(*comm);
  if (comm->getRank() != 0) return;
  testing::internal::CaptureStdout();
  {
    Progress progress(folder.path() / "run.log", {1.0, 1.0}, false);
    for (const double time : {0.0, 0.5, 1.0 - 1e-12, 1.0}) progress.show({time, 0.5, 1, 1.0});
  }
  testing::internal::GetCapturedStdout();
  const std::string log = synthetic::read_text(folder.path() / "run.log");
  const std::string last = log.substr(log.rfind('\n', log.size() - 2) + 1);
  EXPECT_EQ(last.substr(0, 7), "100 %  ") << log;
  EXPECT_EQ(log.find("100 %"), log.rfind("100 %")) << log;
  EXPECT_NE(last.find(" 1 particle "), std::string::npos) << last;
}

/// The lines of run.log of a run to rest, predicted at 1 s and over at 3 s at the latest.
std::string log_of_run_to_rest(const std::filesystem::path& file) {
  testing::internal::CaptureStdout();
  {
    Progress progress(file, {3.0, 1.0, true}, false);
    ProgressNow now;
    now.step = 1;
    for (const double time : {0.0, 0.5, 0.95, 1.0, 1.5}) {
      now.time = time;
      progress.show(now);
    }
    now.finished = true;
    progress.show(now);
  }
  testing::internal::GetCapturedStdout();
  return synthetic::read_text(file);
}

TEST(Progress, OfARunToRestDoesNotSayTheEndBeforeItIsKnown) {
  const auto comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder(*comm);
  if (comm->getRank() != 0) return;
  const std::string log = log_of_run_to_rest(folder.path() / "run.log");
  EXPECT_EQ(std::count(log.begin(), log.end(), '\n'), 4) << log;  // 0, 50, 95 and 100 %
  EXPECT_NE(log.find(" 50 %  t 0.5 s"), std::string::npos) << log;
  EXPECT_NE(log.find("left 0 s if at rest at 1 s, at most 0 s"), std::string::npos) << log;
  EXPECT_NE(log.find("100 %  t 1.5 s"), std::string::npos) << log;
  EXPECT_EQ(log.find("100 %"), log.rfind("100 %")) << log;
}

TEST(Text, CountsHaveTheirNumber) {
  EXPECT_EQ(counted(1.0, "particles removed"), "1 particle removed");
  EXPECT_EQ(counted(0.0, "particles"), "0 particles");
  EXPECT_EQ(counted(2.0, "steps retried with a smaller dt"), "2 steps retried with a smaller dt");
}

TEST(Progress, TheEndNamesTheEnergyThatTheMethodTook) {
  const Scene scene = synthetic::make_scene();
  RunTotals totals;
  totals.ledger.initial_kinetic = 100.0;
  totals.ledger.kinetic = 92.0;
  totals.ledger.stress_integration = -3.0;
  totals.ledger.transfer = -5.0;
  std::string text;
  for (const std::string& line : result_numbers(scene, totals, {}, {}, {})) text += line + "\n";
  EXPECT_NE(
      text.find(
          "-8 % of the energy put in (stress integration -3 %, transfer between particles and "
          "grid -5 %)"
      ),
      std::string::npos
  ) << text;
  EXPECT_NE(text.find("leave over: energy +0.00e+00"), std::string::npos) << text;
}

TEST(Progress, FirstAndLastBlocksNameWhatAUserLooksFor) {
  const Scene scene = synthetic::make_scene();
  const RunDescription run{"runs/x-1", "x.xml", "", "1.0", {"a note"}};
  std::string text;
  for (const std::string& line : scene_lines(scene, run, 2, 848.0)) text += line + "\n";
  for (const char* word :
       {"axisymmetric", "casing: steel", "Arenisca", "6 slugs of tungsten", "a note", "2 ranks"})
    EXPECT_NE(text.find(word), std::string::npos) << word;
  State state;
  state.clock.time = 2e-6;
  text.clear();
  for (const std::string& line : result_lines(scene, state, run, {false, "it broke.", 3}, {}))
    text += line + "\n";
  EXPECT_NE(text.find("Stopped at t = 2e-06 s of 1e-05 s, step 0: it broke."), std::string::npos);
  EXPECT_NE(text.find("./barreno report runs/x-1"), std::string::npos);
}

}  // namespace
}  // namespace barreno

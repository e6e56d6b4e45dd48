// SPDX-License-Identifier: BSD-3-Clause
#include "output/progress.hpp"
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
  {
    Progress progress(folder.path() / "run.log", 1.0, false);
    for (int i = 0; i <= 100; ++i) progress.show({0.01 * i, 0.01, i, 10.0, 10.0 * i, 0.0});
    progress.warn("odd things", "3 odd things by t = 1 s.", 3);
    progress.warn("odd things", "4 odd things by t = 2 s.");
    progress.list_warnings();
  }
  const std::string screen = testing::internal::GetCapturedStdout();
  const std::string log = synthetic::read_text(folder.path() / "run.log");
  EXPECT_EQ(screen, log);
  EXPECT_EQ(std::count(log.begin(), log.end(), '%'), 11);
  EXPECT_NE(
      log.find("warning: 3 odd things by t = 1 s.\nwarning: odd things: 4 times in all\n"),
      std::string::npos
  );
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

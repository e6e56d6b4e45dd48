// SPDX-License-Identifier: BSD-3-Clause
#include "base/digest.hpp"
#include "base/error.hpp"
#include "files/text_file.hpp"
#include "output/copy_surfaces.hpp"
#include "output/pore_flow_columns.hpp"
#include "output/schedule.hpp"
#include "output/watch_ledger.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

namespace barreno {
namespace {

namespace fs = std::filesystem;

class RunFiles : public ::testing::Test {
protected:
  const Teuchos::RCP<const Teuchos::Comm<int>> comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder{*comm};
  const bool root = comm->getRank() == 0;
};

TEST_F(RunFiles, CopiesASurfaceThatIsStillTheSame) {
  if (!root) return;
  const fs::path stl = folder.path() / "part.stl", run = folder.path() / "run";
  fs::create_directory(run);
  write_whole_file(stl, "solid");
  const std::vector<SurfaceFile> files{{stl.string(), digest_of("solid"), "surface_1.stl"}};
  copy_surfaces(files, run);
  EXPECT_EQ(synthetic::read_text(run / "surface_1.stl"), "solid");
  write_whole_file(stl, "changed");
  EXPECT_THROW(copy_surfaces(files, run), FileError);
}

TEST(Schedule, IsDueAtMultiplesOfItsInterval) {
  Schedule schedule(0.1);
  EXPECT_TRUE(schedule.due(0.0));
  schedule.done(0.0);
  EXPECT_FALSE(schedule.due(0.0999));
  EXPECT_TRUE(schedule.due(0.3 - 0.2));  // 0.09999999999999998: round-off of 0.1
  EXPECT_DOUBLE_EQ(schedule.next(0.0), 0.1);
  EXPECT_DOUBLE_EQ(schedule.next(0.25), 0.3);
  schedule.done(0.37);  // three at once are one
  EXPECT_FALSE(schedule.due(0.39));
  EXPECT_TRUE(schedule.due(0.4));
  EXPECT_FALSE(Schedule(0.0).on());
  EXPECT_FALSE(Schedule(0.0).due(1.0));
  EXPECT_EQ(Schedule(0.0).next_until(1.0, 3.0), 3.0);
}

TEST(Schedule, ARoundingBeforeTheEndIsTheEnd) {
  const Schedule schedule(1e-6);
  ASSERT_LT(schedule.next(4.5e-6), 5e-6);  // 5 * 1e-6 is less than 5e-6
  EXPECT_EQ(schedule.next_until(4.5e-6, 5e-6), 5e-6);
  EXPECT_EQ(schedule.next_until(3.5e-6, 5e-6), schedule.next(3.5e-6));
  EXPECT_EQ(schedule.next_until(4.5e-6, 4.7e-6), 4.7e-6);
}

TEST_F(RunFiles, WatchLedgerWarnsOnceForEachCauseAndCounts) {
  if (!root) return;
  Progress progress(folder.path() / "run.log", {1.0, 1.0}, false);
  Ledger watched, ledger;
  watch_ledger(ledger, 0.1, watched, progress);
  EXPECT_TRUE(progress.warnings().empty());
  const auto expanded = static_cast<std::size_t>(RemovalCause::expanded);
  ledger.removed[expanded].count = 3.0;
  watch_ledger(ledger, 0.2, watched, progress);
  ledger.removed[expanded].count = 5.0;
  ledger.held = 1.0;
  watch_ledger(ledger, 0.3, watched, progress);
  watch_ledger(ledger, 0.4, watched, progress);
  const std::map<std::string, long> counted{
      {"particles held as debris", 1}, {"particles removed (expanded)", 5}};
  EXPECT_EQ(progress.warnings(), counted);
}

TEST(PoreFlowColumns, StandOnlyWhereFluidDrains) {
  Scene scene;
  EXPECT_TRUE(pore_flow_columns(scene).empty());
  scene.pore_flow.drainage = Drainage::on;
  State state;
  EXPECT_TRUE(pore_flow_values(state, {}).empty());
  state.pore_flow.on = true;
  state.pore_flow.initial_fluid = 4.0;
  state.pore_flow.fluid = 3.5;
  state.pore_flow.inflow = -1.0;
  state.pore_flow.removed = 0.25;
  Ledger ledger;
  ledger.fluid_work = 7.0;
  const std::vector<double> values = pore_flow_values(state, ledger);
  ASSERT_EQ(values.size(), pore_flow_columns(scene).size());
  EXPECT_DOUBLE_EQ(values[3], (3.5 + 0.25 - 4.0 + 1.0) / 4.0);
  EXPECT_EQ(values[4], 7.0);
}

}  // namespace
}  // namespace barreno

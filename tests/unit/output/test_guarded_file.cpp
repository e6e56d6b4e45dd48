// SPDX-License-Identifier: BSD-3-Clause
#include "base/digest.hpp"
#include "base/error.hpp"
#include "output/copy_surfaces.hpp"
#include "output/guarded_file.hpp"
#include "output/pore_flow_columns.hpp"
#include "output/schedule.hpp"
#include "output/text_file.hpp"
#include "output/watch_ledger.hpp"
#include "synthetic_run.hpp"

#include <Teuchos_DefaultComm.hpp>

#include <gtest/gtest.h>

#include <unistd.h>

namespace barreno {
namespace {

namespace fs = std::filesystem;

class GuardedFile : public ::testing::Test {
protected:
  const Teuchos::RCP<const Teuchos::Comm<int>> comm = Teuchos::DefaultComm<int>::getComm();
  const synthetic::TemporaryFolder folder{*comm};
  const bool root = comm->getRank() == 0;
};

TEST_F(GuardedFile, TakesThePlaceOfALinkAndNotWhatItNames) {
  if (!root) return;
  const fs::path victim = folder.path() / "victim", path = folder.path() / "history.csv";
  write_whole_file(victim, "keep me");
  fs::create_symlink(victim, path);
  const int handle = create_file(path, path);
  EXPECT_TRUE(write_all(handle, "rows"));
  EXPECT_TRUE(id_of(handle) == id_of(path));
  close(handle);
  EXPECT_EQ(synthetic::read_text(victim), "keep me");
  EXPECT_EQ(synthetic::read_text(path), "rows");
}

TEST_F(GuardedFile, IsMissedWhenItIsReplacedOrGone) {
  if (!root) return;
  const fs::path path = folder.path() / "depth.csv";
  const int handle = create_file(path, path);
  const FileId mine = id_of(handle);
  EXPECT_NO_THROW(refuse_if_gone(path, mine));
  fs::rename(path, folder.path() / "moved");
  EXPECT_THROW(refuse_if_gone(path, mine), FileError);
  write_whole_file(path, "another");
  EXPECT_THROW(refuse_if_gone(path, mine), FileError);
  close(handle);
  EXPECT_FALSE(FileId{} == FileId{});  // no file is not the same file as no file
}

TEST_F(GuardedFile, IsRefusedWhereItCannotBe) {
  if (!root) return;
  fs::create_directory(folder.path() / "taken");
  EXPECT_THROW(create_file(folder.path() / "taken", "taken"), FileError);
  EXPECT_THROW(create_file(folder.path() / "none" / "a", "none/a"), FileError);
  EXPECT_NO_THROW(remove_leftover(folder.path() / "none"));
}

TEST_F(GuardedFile, CopiesASurfaceThatIsStillTheSame) {
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

TEST_F(GuardedFile, WatchLedgerWarnsOnceForEachCauseAndCounts) {
  if (!root) return;
  Progress progress(folder.path() / "run.log", 1.0, false);
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

// SPDX-License-Identifier: BSD-3-Clause
#include "base/interrupt.hpp"
#include "base/region.hpp"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <string>
#include <thread>

namespace barreno {
namespace {

const char* const outer = "outer";
const char* const inner = "inner";

TEST(Region, CountsCallsAndSecondsUnderItsLabel) {
  clear_phase_times();
  {
    const Region one(outer);
    for (int i = 0; i < 3; ++i) {
      const Region two(inner);
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
  }
  ASSERT_EQ(phase_times().size(), 2U);
  const PhaseTime &first = phase_times()[0], &second = phase_times()[1];
  EXPECT_STREQ(first.label, outer);
  EXPECT_EQ(first.calls, 1);
  EXPECT_EQ(second.name, inner);
  EXPECT_EQ(second.calls, 3);
  EXPECT_GE(second.seconds, 3e-3);
  EXPECT_GE(first.seconds, second.seconds);
  clear_phase_times();
  EXPECT_TRUE(phase_times().empty());
}

TEST(Interrupt, NotesTheFirstSignalAndGoesOn) {
  catch_signals();
  ASSERT_EQ(received_signal(), 0);
  ASSERT_EQ(std::raise(SIGUSR2), 0);
  EXPECT_EQ(received_signal(), SIGUSR2);
  ASSERT_EQ(std::raise(SIGUSR1), 0);  // a second one that asks for nothing more
  EXPECT_EQ(received_signal(), SIGUSR2);
}

TEST(Interrupt, NamesSignalsAsPeopleKnowThem) {
  EXPECT_EQ(signal_name(SIGTERM), "SIGTERM");
  EXPECT_EQ(signal_name(SIGXCPU), "SIGXCPU");
  EXPECT_EQ(signal_name(SIGUSR1), "a signal (SIGUSR1)");
  EXPECT_EQ(signal_name(12345), "signal 12345");
}

}  // namespace
}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#include "base/interrupt.hpp"

#include <csignal>

namespace barreno {
namespace {

volatile std::sig_atomic_t noted = 0;

void note(int signal) {
  if (noted != 0) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  noted = signal;
}

}  // namespace

void note_signals() {
  std::signal(SIGINT, note);
  std::signal(SIGTERM, note);
}

int received_signal() {
  return noted;
}

}  // namespace barreno

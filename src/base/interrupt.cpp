// SPDX-License-Identifier: BSD-3-Clause
#include "base/interrupt.hpp"

#include <csignal>
#include <cstring>

namespace barreno {
namespace {

volatile std::sig_atomic_t noted = 0;

void note(int signal) {
  const bool asks = signal == SIGINT || signal == SIGTERM || signal == SIGHUP;
  if (noted != 0 && asks) {
    std::signal(signal, SIG_DFL);
    std::raise(signal);
  }
  if (noted == 0) noted = signal;
}

}  // namespace

void catch_signals() {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGPIPE, SIGXCPU, SIGXFSZ}) {
    struct sigaction before {};
    // Who has told the system to ignore these (nohup; a file that is too large is then an error of
    // the write, as on a full disk) means it.
    if ((signal == SIGHUP || signal == SIGXFSZ) && sigaction(signal, nullptr, &before) == 0 &&
        before.sa_handler == SIG_IGN)
      continue;
    struct sigaction action {};
    action.sa_handler = note;
    action.sa_flags = SA_RESTART;
    sigaction(signal, &action, nullptr);
  }
}

int received_signal() {
  return noted;
}

std::string signal_name(int signal) {
  const char* const name = sigabbrev_np(signal);
  if (name == nullptr) return "signal " + std::to_string(signal);
  // The launcher passes every signal on as this one.
  return signal == SIGUSR1 ? "a signal (SIGUSR1)" : std::string("SIG") + name;
}

}  // namespace barreno

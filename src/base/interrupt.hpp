// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <string>

namespace barreno {

/// From now on the signals that ask a process to end or that a system or a batch queue warns with
/// are noted, and the run ends after its step: SIGINT, SIGTERM, SIGHUP, SIGUSR1, SIGUSR2, SIGPIPE
/// (nobody reads the screen any more), SIGXCPU and SIGXFSZ (a limit is reached). A second SIGINT,
/// SIGTERM or SIGHUP ends it at once. A SIGHUP (nohup) or SIGXFSZ that is ignored stays ignored.
void catch_signals();

/// The signal that was noted, or 0.
int received_signal();

/// As a person knows it: SIGTERM.
std::string signal_name(int signal);

}  // namespace barreno

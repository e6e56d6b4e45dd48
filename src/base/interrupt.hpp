// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

/// From now on SIGINT and SIGTERM are noted and the run ends after its step; a second one ends it
/// at once.
void note_signals();

/// The signal that was noted, or 0.
int received_signal();

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "base/gather.hpp"

namespace barreno {

/// Work on files that each rank does on its own, between collective calls that every rank must
/// reach: what RootWork is where rank 0 alone has files.
class RankWork {
public:
  explicit RankWork(const Comm& comm) : comm_(comm) {}
  /// A FileError is kept, and this rank's later work is skipped.
  void run(const std::function<void()>& work);
  /// Collective. @throws FileError on every rank if any met one: that of the first of them
  void agree() const;

private:
  const Comm& comm_;
  std::string sentence_;
};

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#include "base/rank_work.hpp"

#include "base/error.hpp"

#include <Teuchos_CommHelpers.hpp>

#include <array>

namespace barreno {

void RankWork::run(const std::function<void()>& work) {
  if (!sentence_.empty()) return;
  try {
    work();
  } catch (const FileError& error) {
    sentence_ = error.what();
  }
}

void RankWork::agree() const {
  const int nobody = comm_.getSize();
  std::array<long long, 1> first{sentence_.empty() ? nobody : comm_.getRank()};
  min_over_ranks(comm_, first);
  const auto failed = static_cast<int>(first[0]);
  if (failed == nobody) return;
  auto length = static_cast<int>(sentence_.size());
  Teuchos::broadcast<int, int>(comm_, failed, 1, &length);
  std::string sentence = sentence_;
  sentence.resize(static_cast<std::size_t>(length));
  Teuchos::broadcast<int, char>(comm_, failed, length, sentence.data());
  throw FileError(sentence);
}

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#include "checkpoint/shared_file.hpp"

#include <Teuchos_CommHelpers.hpp>

namespace barreno {

Hdf5Size SharedFile::size_of(const std::string& name) const {
  Hdf5Size found;
  RootWork work(comm_);
  work.run([&] { found = file_->size_of(name); });
  work.agree();
  long long size[2] = {static_cast<long long>(found.rows), static_cast<long long>(found.columns)};
  Teuchos::broadcast<int, long long>(comm_, 0, 2, size);
  return {static_cast<std::size_t>(size[0]), static_cast<std::size_t>(size[1])};
}

template <class T>
std::vector<T> SharedFile::read_rows(
    const std::string& name, const Hdf5Size& part, std::size_t first
) const {
  std::vector<T> values(part.rows * part.columns);
  RootWork work(comm_);
  work.run([&] { values = file_->read_rows<T>(name, first, part.rows); });
  work.agree();
  if (!values.empty())
    Teuchos::broadcast<int, T>(comm_, 0, static_cast<int>(values.size()), values.data());
  return values;
}
template std::vector<double> SharedFile::read_rows(const std::string&, const Hdf5Size&, std::size_t)
    const;
template std::vector<long long> SharedFile::read_rows(
    const std::string&, const Hdf5Size&, std::size_t
) const;

}  // namespace barreno

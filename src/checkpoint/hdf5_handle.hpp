// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <hdf5.h>

namespace barreno {

/// What HDF5 gives out has to be given back.
class Hdf5Handle {
public:
  using Closer = herr_t (*)(hid_t);
  Hdf5Handle(hid_t id, Closer closer) : id_(id), closer_(closer) {}
  ~Hdf5Handle() {
    if (id_ >= 0) closer_(id_);
  }
  Hdf5Handle(const Hdf5Handle&) = delete;
  Hdf5Handle& operator=(const Hdf5Handle&) = delete;
  hid_t get() const { return id_; }
  bool failed() const { return id_ < 0; }

private:
  hid_t id_;
  Closer closer_;
};

}  // namespace barreno

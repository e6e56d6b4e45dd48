// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno::testing {

/// Requests for memory of this process so far, whoever made them: malloc, calloc, realloc and the
/// aligned ones, through which operator new and Kokkos go too. A program that links
/// support/count_allocations.cpp has them counted.
long allocations();

/// From now on every request ends the program with its call stack, for a debugger or a core file.
void abort_on_allocation(bool on);

}  // namespace barreno::testing

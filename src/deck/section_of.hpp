// SPDX-License-Identifier: BSD-3-Clause
#pragma once

namespace barreno {

template <class Spec>
struct SectionTable;

/// The table of the section that fills a struct, beside which it is declared.
template <class Spec>
const SectionTable<Spec>& table_of();

}  // namespace barreno

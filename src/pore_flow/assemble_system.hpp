// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "pore_flow/pore_network.hpp"

namespace barreno {

/// Links of all own cells at this time. (7.3)
void link_pore_cells(const PorousMedium& medium, PoreNetwork& network);

/// Rows of backward Euler for the change dp of every own cell over dt: (7.2)
///
///   S dp / dt + sum over faces G (dp - dp of the next cell) = sum over faces of the flow before dp
void assemble_system(double dt, PoreNetwork& network);

/// Flow into own cell i through a face, of the pressures before (`changed` false) or after dp
/// [volume/time].
double flow_through(const PoreNetwork& network, std::size_t i, std::size_t face, bool changed);

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "grid/grid.hpp"
#include "state/nodes.hpp"
#include "state/particles.hpp"

namespace barreno {

/// APIC: the momenta of what particles remember of the grid's velocity around them. docs/method.md
/// (2.12)
///
///   p_I += sum_p S_Ip m_p B_p D_p^-1 (x_I - x_p),   x_p = sum_I S_Ip x_I,
///   D_p = sum_I S_Ip (x_I - x_p) (x_I - x_p)^T
///
/// Linear and angular momentum of the particles, B's included, are the grid's for every shape
/// function, because x_p and D_p are those of the weights in use. Nothing to do for other
/// transfers.
///
/// Source: C. Jiang, C. Schroeder, A. Selle, J. Teran, A. Stomakhin, ACM Trans. Graph. 34
/// (2015) 51.
void project_affine(const Grid& grid, const Particles& particles, Nodes& nodes);

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/contact/contact_bodies.hpp"

namespace barreno {

/// Normals of the surfaces between the velocity fields at the nodes that they share: the plane that
/// best separates the particles of the two fields. docs/method.md 6
///
///   n ~ (C_a + C_b)^-1 (mu_b - mu_a),   mu, C: mean and scatter of the particles about a node,
///   weighted with S_Ip; C with each particle's own box
///
/// This is the first Newton step of a logistic regression of a or b on the position, with equal
/// weight for both and the particles' own size as its penalty: a step from sums alone.
///
/// @pre  detect_contact_nodes
/// @post contact.normal, of unit length from a to b, for every pair that is not bonded; zero at
/// nodes where not both have mass. Collective.
/// Source: J. Nairn, C. Hammerquist, G. Smith, Comput. Methods Appl. Mech. Eng. 362 (2020) 112859.
void fit_surface_normals(const ContactBodies& bodies, const ContactNodes& contact);

}  // namespace barreno

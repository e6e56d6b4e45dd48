// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "step/contact/contact_bodies.hpp"

namespace barreno {

/// Turn the fitted normals to where the particles of both fields are furthest apart, and find the
/// gaps. docs/method.md 6
///
///   gap(n) = min over b of (x_p . n - l_p(n)) - max over a of (x_p . n + l_p(n))
///
/// l_p(n) = |(F e_i . n)_i|, half the width of the ellipse in the particle's deformed box. At an
/// edge of a body the fit leans by some 20 degrees, because half of the cloud is missing; the
/// widest gap does not. A few directions about the normal are compared at once, three times, each
/// time closer together; the normal stays where it is unless another direction is better by a
/// thousandth of a cell, so that the fit's exact normals of plane surfaces are kept. Greatest and
/// smallest values do not depend on an order.
///
/// @pre  fit_surface_normals
/// @post contact.normal holds normal and gap [cells]. Collective.
void refine_surface_normals(const ContactBodies& bodies, const ContactNodes& contact);

}  // namespace barreno

// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <barreno/symmetric_functions.hpp>
#include <barreno/tensor.hpp>
#include <optional>

namespace barreno {

/// Functions of general 3x3 matrices, for one point at a time: exact to round-off rather than fast.

Mat3 identity();
Mat3 operator+(const Mat3& a, const Mat3& b);
Mat3 operator-(const Mat3& a, const Mat3& b);
Mat3 operator*(double c, const Mat3& a);
Mat3 operator*(const Mat3& a, const Mat3& b);
Mat3 transpose(const Mat3& a);
double determinant(const Mat3& a);
/// Largest sum of the sizes of a row's entries.
double norm(const Mat3& a);

/// By cofactors; entries are not finite when the determinant is zero.
Mat3 inverse(const Mat3& a);

/// Principal logarithm of I + g; nothing if there is none (an eigenvalue of I + g is negative, as
/// after half a turn) or when it is lost in round-off.
///
/// Takes g and not I + g, so that the logarithm of a small g keeps all its digits. Square roots
/// (Denman and Beavers, Appl. Math. Comput. 2 (1976) 63-94) until |g| <= 1/4, then
///   log(I + g) = 2 artanh z = 2 (z + z^3 / 3 + z^5 / 5 ...),   z = g (2 I + g)^-1
std::optional<Mat3> logarithm_1p(const Mat3& g);

/// exp(a) by scaling, Taylor series and squaring.
Mat3 exponential(const Mat3& a);

/// R of F = R U, det F > 0, by Newton's iteration R <- (R + R^-T) / 2 (Higham, SIAM J. Sci. Stat.
/// Comput. 7 (1986) 1160-1174). Entries are not finite when F is singular.
Mat3 polar_rotation(const Mat3& f);

/// R t R^T: from the unrotated to the space frame.
Sym3 rotate(const Mat3& r, const Sym3& t);
/// R^T t R: from the space to the unrotated frame.
Sym3 unrotate(const Mat3& r, const Sym3& t);

}  // namespace barreno

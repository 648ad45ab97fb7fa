#pragma once
#include <glm/glm.hpp>
#include <optional>

namespace laver {

/// Camera to world with +x left, +y up, +z towards `target`: columns left = normalize(up x dir),
/// dir x left, dir, origin. `up` may have any length. Nothing if `target` is at `origin` or `up`
/// is zero or along the view, up to the rounding of the given numbers.
std::optional<glm::dmat4> lookAt(const glm::dvec3& origin, const glm::dvec3& target,
                                 const glm::dvec3& up);

/// Rotation about an axis of any length but zero, angle in degrees. Nothing for a zero axis.
std::optional<glm::dmat4> rotation(const glm::dvec3& axis, double degrees);

/// Whether a matrix has no usable inverse: with every row and column scaled to a largest entry of
/// about 1, elimination meets a pivot of the size of its own rounding. Scales of any size, even or
/// not, before or after a rotation, are not singular by this rule. A matrix with the last row 0 0 0
/// 1 is judged by its 3x3 part. Non-finite entries are singular.
bool isSingular(const glm::dmat4& matrix);

/// Whether the last row is 0 0 0 1.
bool isAffine(const glm::dmat4& matrix);

/// The matrix that takes normals along with points: the inverse transpose of the linear part, up to
/// a positive factor. The matrix must not be singular.
glm::dmat3 normalMatrix(const glm::dmat4& matrix);

/// Unit length without overflow or underflow; zero and non-finite vectors give (0,0,0).
glm::dvec3 normalizedOrZero(const glm::dvec3& v);

}  // namespace laver

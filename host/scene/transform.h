#pragma once
#include <glm/glm.hpp>
#include <optional>

namespace laver {

/// Camera to world with +x left, +y up, +z towards `target`: columns left = normalize(up x dir),
/// dir x left, dir, origin. `up` may have any length. Nothing if `target` equals `origin`, or if
/// `up` is zero or parallel to the view, up to the rounding of the given numbers.
std::optional<glm::dmat4> lookAt(const glm::dvec3& origin, const glm::dvec3& target,
                                 const glm::dvec3& up);

/// The same as Nori 1 has it: left = normalize(up) x dir, so that left and up have the length of
/// the sine of the angle between `up` and the view, and a camera sees that much less.
std::optional<glm::dmat4> scaledLookAt(const glm::dvec3& origin, const glm::dvec3& target,
                                       const glm::dvec3& up);

/// Rotation about an axis of any length but zero, angle in degrees. Nothing for a zero axis.
std::optional<glm::dmat4> rotation(const glm::dvec3& axis, double degrees);

/// Whether a matrix has no usable inverse: after scaling every row and column to a largest entry of
/// about 1, elimination finds a pivot no larger than its rounding error. Scales of any size,
/// uniform or not, before or after a rotation, are not singular by this rule. For a matrix whose
/// last row is 0 0 0 1 only the 3x3 part is tested. Non-finite entries are singular.
bool isSingular(const glm::dmat4& matrix);

/// Whether the last row is 0 0 0 1.
bool isAffine(const glm::dmat4& matrix);

/// The matrix that transforms normals: the inverse transpose of the linear part, up to a positive
/// factor. The matrix must not be singular.
glm::dmat3 normalMatrix(const glm::dmat4& matrix);

/// Unit length without overflow or underflow; zero and non-finite vectors give (0,0,0).
glm::dvec3 normalizedOrZero(const glm::dvec3& v);

}  // namespace laver

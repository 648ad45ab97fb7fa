// The types that C++ and GLSL share. In C++ everything below lives in laver::shared.
#ifndef LAVER_SHARED_TYPES_H
#define LAVER_SHARED_TYPES_H

#ifdef __cplusplus
#include <bit>
#include <cmath>
#include <cstddef>
#include <glm/glm.hpp>
namespace laver::shared {
using glm::uvec2;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
using uint = unsigned int;
using std::abs;
using std::fma;
using std::sqrt;
inline uint floatBitsToUint(float x) { return std::bit_cast<uint>(x); }
inline float uintBitsToFloat(uint x) { return std::bit_cast<float>(x); }
#ifdef LAVER_NAN_PROPAGATES  // for tests: GLSL leaves the result for NaN open
inline float min(float a, float b) { return a != a || b != b ? a + b : (b < a ? b : a); }
inline float max(float a, float b) { return a != a || b != b ? a + b : (a < b ? b : a); }
#else
inline float min(float a, float b) { return b < a ? b : a; }
inline float max(float a, float b) { return a < b ? b : a; }
#endif
}  // namespace laver::shared
#define LAVER_SHARED_BEGIN namespace laver::shared {
#define LAVER_SHARED_END }
#define LAVER_CONST inline constexpr
#define LAVER_FN inline
#define LAVER_OUT(type) type&
#define LAVER_PRECISE
#else
#define LAVER_SHARED_BEGIN
#define LAVER_SHARED_END
#define LAVER_CONST const
#define LAVER_FN
#define LAVER_OUT(type) out type
#define LAVER_PRECISE precise
#endif

#endif

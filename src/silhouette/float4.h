#pragma once

#include <cmath>
#include <cstring>

#if defined(__SSE2__)
#include <emmintrin.h>
#elif defined(__wasm_simd128__)
#include <wasm_simd128.h>
#endif

namespace dimline {

/// Four floats that the compiler keeps in one vector register (SSE2 natively, simd128 in wasm); +, -, *, / and
/// comparisons work lane by lane. A compiler extension that g++ and clang share, so that one source serves both
/// builds; the few things that it has no good spelling for are functions below, with the machine's own instruction
/// where there is one.
using Float4 = float __attribute__((vector_size(16)));
/// What comparing them gives: all bits set where it holds.
using Int4 = int __attribute__((vector_size(16)));

inline constexpr Float4 kLanes{0, 1, 2, 3};

inline Float4 load4(const float* from) {
  Float4 v;
  std::memcpy(&v, from, sizeof v);
  return v;
}
inline void store4(float* to, Float4 v) { std::memcpy(to, &v, sizeof v); }
inline Float4 splat4(float v) { return Float4{v, v, v, v}; }

/// Lanes of a (0 to 3) and of b (4 to 7), in the order given.
template <int i0, int i1, int i2, int i3>
Float4 pick4(Float4 a, Float4 b) {
  return __builtin_shufflevector(a, b, i0, i1, i2, i3);
}

/// `yes` where the comparison held, `no` elsewhere.
inline Float4 choose4(Int4 held, Float4 yes, Float4 no) { return held ? yes : no; }

// With a NaN among the two, min4 and max4 give the second.
#if defined(__SSE2__)
inline Float4 sqrt4(Float4 v) { return _mm_sqrt_ps(v); }
inline Float4 min4(Float4 a, Float4 b) { return _mm_min_ps(a, b); }
inline Float4 max4(Float4 a, Float4 b) { return _mm_max_ps(a, b); }
/// One bit a lane: whether the comparison held there.
inline unsigned lanesOf(Int4 held) {
  return static_cast<unsigned>(_mm_movemask_ps(_mm_castsi128_ps(reinterpret_cast<__m128i>(held))));
}
#elif defined(__wasm_simd128__)
inline Float4 sqrt4(Float4 v) { return reinterpret_cast<Float4>(wasm_f32x4_sqrt(reinterpret_cast<v128_t>(v))); }
inline Float4 min4(Float4 a, Float4 b) {
  return reinterpret_cast<Float4>(wasm_f32x4_pmin(reinterpret_cast<v128_t>(b), reinterpret_cast<v128_t>(a)));
}
inline Float4 max4(Float4 a, Float4 b) {
  return reinterpret_cast<Float4>(wasm_f32x4_pmax(reinterpret_cast<v128_t>(b), reinterpret_cast<v128_t>(a)));
}
inline unsigned lanesOf(Int4 held) { return static_cast<unsigned>(wasm_i32x4_bitmask(reinterpret_cast<v128_t>(held))); }
#else
inline Float4 sqrt4(Float4 v) { return Float4{std::sqrt(v[0]), std::sqrt(v[1]), std::sqrt(v[2]), std::sqrt(v[3])}; }
inline Float4 min4(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 max4(Float4 a, Float4 b) { return a > b ? a : b; }
inline unsigned lanesOf(Int4 held) {
  return (held[0] != 0 ? 1U : 0U) | (held[1] != 0 ? 2U : 0U) | (held[2] != 0 ? 4U : 0U) | (held[3] != 0 ? 8U : 0U);
}
#endif

}  // namespace dimline

#pragma once

#include <cstring>

namespace dimline {

/// Four floats that the compiler keeps in one vector register (SSE2 natively, simd128 in wasm); +, -, * and comparisons work
/// lane by lane. A compiler extension that g++ and clang share, so that one source serves both builds.
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
inline Float4 min4(Float4 a, Float4 b) { return a < b ? a : b; }
inline Float4 max4(Float4 a, Float4 b) { return a < b ? b : a; }
inline bool any(Int4 v) { return (v[0] | v[1] | v[2] | v[3]) != 0; }

}  // namespace dimline

#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace dimline {

// Geometry that decides something is double; vertices and other bulk data are float (glm::vec3 and so on).
using Vec2 = glm::dvec2;  ///< on screen: CSS pixels from the viewport's top left, x right, y down
using Vec3 = glm::dvec3;  ///< in the world: metres, right-handed, y up
using Vec4 = glm::dvec4;
using Mat3 = glm::dmat3;
using Mat4 = glm::dmat4;

inline constexpr double kRadPerDeg = 0.017453292519943295;
inline constexpr double kDegPerRad = 57.29577951308232;

}  // namespace dimline

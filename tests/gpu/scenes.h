#pragma once

#include "model/scene.h"

namespace dimline::test {

/// Adds a box from `min` to `max`, as a closed part, to a mesh.
void addBox(Mesh& mesh, const glm::vec3& min, const glm::vec3& max, std::uint16_t material);

/// One box, at the origin where not said otherwise, of a light plain material.
Scene boxScene(const glm::vec3& size, const glm::vec3& min = glm::vec3(0.0F));

/// A small village: a house with a gable roof, a round tower, a balcony slab, and a row of posts as instances. About 12 x 9 x 10 m, standing
/// on y = 0; everything is at least 0.4 m thick.
Scene villageScene();

}  // namespace dimline::test

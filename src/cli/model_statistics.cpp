#include "cli/model_statistics.h"

#include <array>
#include <set>
#include <vector>

#include "placement/base_lines.h"
#include "placement/chains.h"

namespace dimline {

ModelStatistics statisticsOf(const Model& model, const Scene& scene) {
  // How many base lines a scope has does not depend on the camera.
  const View view(threeQuarterView(scene.bounds, 1000, 1000), 1000, 1000, scene.bounds);
  ModelStatistics statistics;
  statistics.triangles = scene.triangleCount();
  for (const auto& annotation : model.annotations) {
    if (!annotation || !isLine(annotation->type)) continue;
    std::vector<std::size_t> measured;
    for (std::size_t i = 0; i < scene.scopes.size(); ++i) {
      if (scene.scopes[i].name != annotation->scope) continue;
      measured.push_back(i);
      statistics.baseLines += baseSegments(*annotation, scene.scopes[i].box, view).size();
    }
    if (!annotation->chained) continue;
    const auto clusters = clusterBaseLines(*annotation, scene.scopes, measured, scene.bounds.diagonal());
    statistics.clusters += clusters.size();
    // A base line is in a cluster for each of its planes, and counts once.
    std::set<std::array<double, 7>> lines;
    for (const Cluster& cluster : clusters) {
      for (const ChainMember& member : cluster.members) {
        const auto& [start, end] = member.segment;
        lines.insert({static_cast<double>(member.scope), start.x, start.y, start.z, end.x, end.y, end.z});
      }
    }
    statistics.clusteredBaseLines += lines.size();
  }
  return statistics;
}

}  // namespace dimline

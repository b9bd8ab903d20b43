#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>

#include "model/builder.h"

// Skins over a grid of points: the planking over ribs, and sheets of cloth or boarding. Both are quadrilaterals
// first; the mesh builder smooths them once the whole part is there.

namespace dimline {

namespace {

using Rows = std::span<const std::vector<Vec3>>;

/// uv of a grid's points: u along the rows, v from row to row, each counted where it is longest.
struct GridUv {
  std::vector<double> u, v;

  GridUv(Rows rows, bool closed) {
    const std::size_t columns = rows[0].size();
    for (const std::vector<Vec3>& row : rows) {
      std::vector<double> along{0};
      for (std::size_t j = 0; j + (closed ? 0 : 1) < columns; ++j)
        along.push_back(along.back() + glm::length(row[(j + 1) % columns] - row[j]));
      if (u.empty() || along.back() > u.back()) u = std::move(along);
    }
    for (std::size_t j = 0; j < columns; ++j) {
      std::vector<double> along{0};
      for (std::size_t i = 0; i + 1 < rows.size(); ++i)
        along.push_back(along.back() + glm::length(rows[i + 1][j] - rows[i][j]));
      if (v.empty() || along.back() > v.back()) v = std::move(along);
    }
  }

  [[nodiscard]] glm::vec2 at(std::size_t row, std::size_t column) const { return {u[column], v[row]}; }
};

struct Quad {
  std::array<std::uint32_t, 4> points;
  std::array<glm::vec2, 4> uv;
  MaterialId material;
};

/// Six times the volume between a quad's two triangles and the origin.
double sixVolumes(const MeshBuilder& mesh, const std::array<std::uint32_t, 4>& q, const Vec3& origin) {
  const Vec3 a = mesh.at(q[0]) - origin, b = mesh.at(q[1]) - origin, c = mesh.at(q[2]) - origin,
             d = mesh.at(q[3]) - origin;
  return glm::dot(a, glm::cross(b, c)) + glm::dot(a, glm::cross(c, d));
}

/// The ring without points that repeat, and without stretches that lead out and back again.
std::vector<std::uint32_t> unfolded(std::vector<std::uint32_t> ring) {
  for (bool changed = true; changed && ring.size() > 2;) {
    changed = false;
    for (std::size_t i = 0; i < ring.size() && ring.size() > 2; ++i) {
      const std::size_t next = (i + 1) % ring.size(), second = (i + 2) % ring.size();
      const bool repeats = ring[i] == ring[next];
      if (!repeats && ring[i] != ring[second]) continue;
      ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(next));
      changed = true;
      break;
    }
  }
  if (ring.size() < 3) ring.clear();
  return ring;
}

/// Newell's normal, as long as twice the ring's area.
Vec3 areaNormal(const MeshBuilder& mesh, std::span<const std::uint32_t> ring) {
  Vec3 normal(0.0);
  for (std::size_t i = 0; i < ring.size(); ++i)
    normal += glm::cross(mesh.at(ring[i]) - mesh.at(ring[0]), mesh.at(ring[(i + 1) % ring.size()]) - mesh.at(ring[0]));
  return normal;
}

/// The flat face inside a rib, seen from where its points run counter-clockwise; none when it encloses nothing.
void cap(MeshBuilder& mesh, std::vector<std::uint32_t> rib, bool reversed, MaterialId material) {
  if (reversed) std::reverse(rib.begin(), rib.end());
  const std::vector<std::uint32_t> ring = unfolded(std::move(rib));
  if (ring.empty()) return;
  const Vec3 area = areaNormal(mesh, ring);
  if (!(glm::length(area) > MeshBuilder::kNothingM)) return;
  const Vec3 normal = glm::normalize(area);
  const PlaneAxes axes = planeAxes(normal);
  Polygon polygon;
  for (const std::uint32_t p : ring)
    polygon.outer.emplace_back(glm::dot(axes.u, mesh.at(p)), glm::dot(axes.v, mesh.at(p)));
  for (const auto& t : triangulate(polygon)) {
    const auto corner = [&](std::uint32_t i) {
      return MeshBuilder::Corner{ring[i], normal, planeUv(axes, mesh.at(ring[i]))};
    };
    mesh.triangle(corner(t[0]), corner(t[1]), corner(t[2]), material);
  }
}

/// Flat for now; smooth() follows when the part is whole.
void addQuad(MeshBuilder& mesh, const Quad& q, bool reversed) {
  std::array<MeshBuilder::Corner, 4> c;
  for (std::size_t k = 0; k < 4; ++k) {
    const std::size_t from = reversed ? 3 - k : k;
    c[k] = {q.points[from], Vec3(0, 1, 0), q.uv[from]};
  }
  mesh.quad(c[0], c[1], c[2], c[3], q.material);
}

}  // namespace

void Builder::loft(std::span<const std::vector<Vec3>> ribs, const SkinOptions& options) {
  if (ribs.size() < 2 || ribs[0].size() < 3) return;
  const std::size_t columns = ribs[0].size(), rows = ribs.size();
  const auto materialAt = [&](std::size_t column) {
    return column < options.materials.size() ? options.materials[column] : material();
  };
  MeshBuilder& out = mesh();
  out.beginPart();
  std::vector<std::vector<std::uint32_t>> points(rows);
  for (std::size_t i = 0; i < rows; ++i) {
    assert(ribs[i].size() == columns);
    for (const Vec3& p : ribs[i]) points[i].push_back(out.weld(toMesh(p)));
  }
  const GridUv uv(ribs, true);
  std::vector<Quad> quads;
  quads.reserve((rows - 1) * columns);
  double volumes = 0;
  const Vec3 origin = out.at(points[0][0]);
  for (std::size_t i = 0; i + 1 < rows; ++i) {
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t k = (j + 1) % columns;
      quads.push_back({{points[i][j], points[i][k], points[i + 1][k], points[i + 1][j]},
                       {uv.at(i, j), uv.at(i, j + 1), uv.at(i + 1, j + 1), uv.at(i + 1, j)},
                       materialAt(j)});
      volumes += sixVolumes(out, quads.back().points, origin);
    }
  }
  // With its caps the skin is closed, and a closed surface's volume tells which way its faces look. Seen from the
  // origin, a cap in its plane has none, the other has its area times its distance.
  volumes += glm::dot(out.at(points[rows - 1][0]) - origin, areaNormal(out, points[rows - 1]));
  const bool reversed = volumes < 0;
  for (const Quad& q : quads) addQuad(out, q, reversed);
  cap(out, points[0], !reversed, material());
  cap(out, points[rows - 1], reversed, material());
  out.smooth(options.creaseRad);
}

void Builder::sheet(std::span<const std::vector<Vec3>> input, double thicknessM, const SkinOptions& options) {
  if (input.size() < 2 || input[0].size() < 2 || thicknessM <= MeshBuilder::kNothingM) return;
  const std::size_t rows = input.size(), columns = input[0].size();
  // Equal points of neighbouring rows or columns are one: `same` names the first of them.
  std::vector<std::size_t> same(rows * columns);
  std::vector<Vec3> grid;
  grid.reserve(rows * columns);
  for (std::size_t i = 0; i < rows; ++i) {
    assert(input[i].size() == columns);
    for (std::size_t j = 0; j < columns; ++j) {
      const std::size_t here = i * columns + j;
      grid.push_back(toMesh(input[i][j]));
      same[here] = here;
      const auto meets = [&](std::size_t other) {
        return glm::length(grid[here] - grid[other]) <= MeshBuilder::kWeldM;
      };
      if (j > 0 && meets(here - 1)) {
        same[here] = same[here - 1];
      } else if (i > 0 && meets(here - columns)) {
        same[here] = same[here - columns];
      }
    }
  }
  // Normals of the front at each point: the mean of the faces around it.
  std::vector<Vec3> normals(grid.size(), Vec3(0.0));
  for (std::size_t i = 0; i + 1 < rows; ++i) {
    for (std::size_t j = 0; j + 1 < columns; ++j) {
      const std::size_t a = i * columns + j, b = a + 1, c = b + columns, d = a + columns;
      const Vec3 cross = glm::cross(grid[c] - grid[a], grid[d] - grid[b]);
      const double length = glm::length(cross);
      if (!(length > 0)) continue;
      for (const std::size_t p : {a, b, c, d}) normals[same[p]] += cross / length;
    }
  }

  MeshBuilder& out = mesh();
  out.beginPart();
  std::vector<std::uint32_t> front(grid.size()), back(grid.size());
  for (std::size_t p = 0; p < grid.size(); ++p) {
    if (same[p] != p) {
      front[p] = front[same[p]];
      back[p] = back[same[p]];
      continue;
    }
    const double length = glm::length(normals[p]);
    front[p] = out.point(grid[p]);
    back[p] = out.point(length > 0 ? grid[p] - normals[p] * (thicknessM / length) : grid[p]);
  }
  const GridUv uv(input, false);
  const auto materialAt = [&](std::size_t column) {
    return column < options.materials.size() ? options.materials[column] : material();
  };
  for (std::size_t i = 0; i + 1 < rows; ++i) {
    for (std::size_t j = 0; j + 1 < columns; ++j) {
      const std::size_t a = i * columns + j, b = a + 1, c = b + columns, d = a + columns;
      const std::array<glm::vec2, 4> corners{uv.at(i, j), uv.at(i, j + 1), uv.at(i + 1, j + 1), uv.at(i + 1, j)};
      addQuad(out, {{front[a], front[b], front[c], front[d]}, corners, materialAt(j)}, false);
      addQuad(out, {{back[a], back[b], back[c], back[d]}, corners, materialAt(j)}, true);
    }
  }
  // The rim, once around: along the first row, up the last column, back and down again.
  const auto rim = [&](std::size_t p, std::size_t q, const glm::vec2& from, const glm::vec2& to, MaterialId m) {
    const glm::vec2 deep(0.0F, static_cast<float>(thicknessM));
    addQuad(out, {{back[p], back[q], front[q], front[p]}, {from - deep, to - deep, to, from}, m}, false);
  };
  for (std::size_t j = 0; j + 1 < columns; ++j) {
    const std::size_t high = (rows - 1) * columns + j;
    rim(j, j + 1, uv.at(0, j), uv.at(0, j + 1), materialAt(j));
    rim(high + 1, high, uv.at(rows - 1, j + 1), uv.at(rows - 1, j), materialAt(j));
  }
  for (std::size_t i = 0; i + 1 < rows; ++i) {
    const std::size_t low = i * columns, far = low + columns - 1;
    rim(far, far + columns, uv.at(i, columns - 1), uv.at(i + 1, columns - 1), materialAt(columns - 2));
    rim(low + columns, low, uv.at(i + 1, 0), uv.at(i, 0), materialAt(0));
  }
  out.smooth(options.creaseRad);
}

}  // namespace dimline

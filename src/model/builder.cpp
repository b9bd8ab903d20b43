#include "model/builder.h"

#include <algorithm>
#include <cassert>
#include <cmath>

#include <glm/ext/matrix_transform.hpp>

#include "core/power.h"

namespace dimline {

namespace {

Vec3 unit(Axis axis) {
  Vec3 v(0.0);
  v[static_cast<int>(axis)] = 1;
  return v;
}

Mat4 matrixOf(const Obb& frame) {
  return {Vec4(frame.axes[0], 0), Vec4(frame.axes[1], 0), Vec4(frame.axes[2], 0), Vec4(frame.origin, 1)};
}

}  // namespace

std::vector<Interval> splitIntervals(double lengthM, std::span<const SplitSize> sizes) {
  double taken = 0, weights = 0;
  for (const SplitSize& s : sizes) {
    const double value = std::max(s.value, 0.0);
    switch (s.kind) {
      case SplitSize::Kind::kFixed:
        taken += value;
        break;
      case SplitSize::Kind::kRelative:
        taken += value * lengthM;
        break;
      case SplitSize::Kind::kFloating:
        weights += value;
        break;
    }
  }
  const double squeeze = taken > lengthM ? lengthM / taken : 1.0;
  const double rest = std::max(lengthM - taken, 0.0);
  std::vector<Interval> pieces;
  pieces.reserve(sizes.size());
  double at = 0;
  for (const SplitSize& s : sizes) {
    double length = std::max(s.value, 0.0);
    switch (s.kind) {
      case SplitSize::Kind::kFixed:
        length *= squeeze;
        break;
      case SplitSize::Kind::kRelative:
        length *= lengthM * squeeze;
        break;
      case SplitSize::Kind::kFloating:
        length *= weights > 0 ? rest / weights : 0;
        break;
    }
    pieces.push_back({at, length});
    at += length;
  }
  return pieces;
}

int repeatCount(double lengthM, double targetM) {
  assert(targetM > 0);
  return std::max(1, static_cast<int>(std::lround(lengthM / targetM)));
}

glm::vec3 linearFromSrgb(std::uint32_t rgb) {
  auto channel = [&](int shift) {
    const double c = ((rgb >> shift) & 0xFFU) / 255.0;
    return static_cast<float>(c <= 0.04045 ? c / 12.92 : power((c + 0.055) / 1.055, 2.4));
  };
  return {channel(16), channel(8), channel(0)};
}

Builder::Builder() {
  states_.emplace_back();
  targets_.emplace_back();
  materials_.emplace_back();
}

Scene Builder::finish() {
  assert(targets_.size() == 1 && states_.size() == 1 && "a push without its pop");
  Scene scene;
  scene.meshes.assign(std::make_move_iterator(meshes_.begin()), std::make_move_iterator(meshes_.end()));
  for (const Placed& placed : targets_[0].placed) scene.instances.push_back({placed.mesh, glm::mat4(placed.transform)});
  scene.scopes = std::move(targets_[0].scopes);
  scene.materials = std::move(materials_);
  dimline::finish(scene);
  *this = Builder();
  return scene;
}

// --- The scope ----------------------------------------------------------------------------------------------------------

void Builder::push() { states_.push_back(states_.back()); }

void Builder::pop() {
  assert(states_.size() > 1 && "a pop without its push");
  states_.pop_back();
}

Vec3 Builder::toMesh(const Vec3& p) const {
  const Obb& s = scope();
  return s.origin + s.axes[0] * p.x + s.axes[1] * p.y + s.axes[2] * p.z;
}

Vec3 Builder::directionToMesh(const Vec3& d) const {
  const Obb& s = scope();
  return s.axes[0] * d.x + s.axes[1] * d.y + s.axes[2] * d.z;
}

void Builder::translate(const Vec3& byM) { state().scope.origin = toMesh(byM); }

void Builder::rotate(Axis axis, double angleRad, const Vec3& pivot) {
  Obb& s = state().scope;
  const Vec3 fixedPoint = s.at(pivot);
  const Vec3 about = s.axes[static_cast<std::size_t>(axis)];
  const double c = std::cos(angleRad), n = std::sin(angleRad);
  auto turned = [&](const Vec3& v) {
    return v * c + glm::cross(about, v) * n + about * (glm::dot(about, v) * (1 - c));
  };
  s.origin = fixedPoint + turned(s.origin - fixedPoint);
  for (Vec3& a : s.axes) a = glm::normalize(turned(a));
}

void Builder::scale(const Vec3& sizeM) { state().scope.size = glm::max(sizeM, Vec3(0.0)); }

void Builder::scale(Axis axis, double sizeM) { state().scope.size[static_cast<int>(axis)] = std::max(sizeM, 0.0); }

void Builder::scaleCentered(const Vec3& sizeM) {
  const Vec3 old = size();
  translate({(old.x - sizeM.x) * 0.5, 0, (old.z - sizeM.z) * 0.5});
  scale(sizeM);
}

void Builder::extrude(double depthM) {
  if (depthM < 0) translate({0, 0, depthM});
  scale(Axis::kZ, std::abs(depthM));
}

void Builder::offset(double distanceM) {
  const Vec3 old = size();
  const Vec3 grown(std::max(old.x + 2 * distanceM, 0.0), std::max(old.y + 2 * distanceM, 0.0), old.z);
  translate((old - grown) * 0.5);
  scale(grown);
}

void Builder::slice(Axis axis, const Interval& piece) {
  translate(unit(axis) * piece.start);
  scale(axis, piece.length);
}

void Builder::enterFace(Face which) {
  const Obb s = scope();
  const auto& [x, y, z] = s.axes;
  const Vec3 n = s.size;
  switch (which) {
    case Face::kFront:
      setScope({s.at({0, 0, 1}), {x, y, z}, {n.x, n.y, 0}});
      break;
    case Face::kBack:
      setScope({s.at({1, 0, 0}), {-x, y, -z}, {n.x, n.y, 0}});
      break;
    case Face::kRight:
      setScope({s.at({1, 0, 1}), {-z, y, x}, {n.z, n.y, 0}});
      break;
    case Face::kLeft:
      setScope({s.at({0, 0, 0}), {z, y, -x}, {n.z, n.y, 0}});
      break;
    case Face::kTop:
      setScope({s.at({0, 1, 1}), {x, -z, y}, {n.x, n.z, 0}});
      break;
    case Face::kBottom:
      setScope({s.at({0, 0, 0}), {x, z, -y}, {n.x, n.z, 0}});
      break;
  }
}

void Builder::enterSlope(const Roof& roof, std::size_t i) {
  const std::vector<Vec3>& ring = roof.slopes[i];
  const Vec3 x = glm::normalize(ring[1] - ring[0]);
  const Vec3 z = glm::normalize(glm::cross(x, ring[2] - ring[1]));
  const Vec3 y = glm::cross(z, x);
  Vec2 low(0.0), high(0.0);
  for (const Vec3& p : ring) {
    const Vec2 q(glm::dot(p - ring[0], x), glm::dot(p - ring[0], y));
    low = glm::min(low, q);
    high = glm::max(high, q);
  }
  const Vec3 origin = toMesh(ring[0] + x * low.x + y * low.y);
  setScope({origin, {directionToMesh(x), directionToMesh(y), directionToMesh(z)}, {high.x - low.x, high.y - low.y, 0}});
}

void Builder::name(std::string_view name) { targets_.back().scopes.push_back({std::string(name), 0, scope()}); }

// --- Material -----------------------------------------------------------------------------------------------------------

MaterialId Builder::addMaterial(const Material& material) {
  const auto found = std::find(materials_.begin(), materials_.end(), material);
  if (found != materials_.end()) return static_cast<MaterialId>(found - materials_.begin());
  assert(materials_.size() < 0xFFFF);
  materials_.push_back(material);
  return static_cast<MaterialId>(materials_.size() - 1);
}

void Builder::color(const glm::vec3& linear) {
  Material changed = materials_[material()];
  changed.color = linear;
  material(changed);
}

// --- Parts and instances ------------------------------------------------------------------------------------------------

MeshBuilder& Builder::mesh() {
  Target& target = targets_.back();
  if (!target.mesh) {
    target.placed.push_back({static_cast<std::uint32_t>(meshes_.size()), Mat4(1.0)});
    target.mesh = std::make_unique<MeshBuilder>(meshes_.emplace_back());
  }
  return *target.mesh;
}

void Builder::reserve(std::size_t triangles) { mesh().reserve(triangles); }

void Builder::beginPart(const Vec3& sizeM) {
  push();
  setScope({});
  scale(sizeM);
  targets_.emplace_back();
}

PartId Builder::endPart() {
  parts_.push_back(std::move(targets_.back()));
  targets_.pop_back();
  pop();
  return static_cast<PartId>(parts_.size() - 1);
}

void Builder::place(PartId part) {
  assert(part < parts_.size());
  Target& target = targets_.back();
  const Target& source = parts_[part];
  const Mat4 frame = matrixOf(scope());
  for (const Placed& p : source.placed) target.placed.push_back({p.mesh, frame * p.transform});
  for (const Scope& s : source.scopes) {
    const Obb& box = s.box;
    target.scopes.push_back(
        {s.name,
         0,
         {toMesh(box.origin),
          {directionToMesh(box.axes[0]), directionToMesh(box.axes[1]), directionToMesh(box.axes[2])},
          box.size}});
  }
}

}  // namespace dimline

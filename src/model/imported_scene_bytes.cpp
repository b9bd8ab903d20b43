#include <algorithm>
#include <cstring>
#include <type_traits>
#include <utility>

#include "core/version.h"
#include "model/imported_scene.h"

// passThrough() lists what a scene is made of, once, for the Writer and for the Reader. A list is its length and its elements, a text a list of
// characters; numbers lie as memory has them, which is the same in every WebAssembly module.

namespace dimline {

namespace {

class Writer {
public:
  void raw(const void* from, std::size_t size) {
    const std::size_t at = bytes_.size();
    bytes_.resize(at + size);
    if (size != 0) std::memcpy(bytes_.data() + at, from, size);
  }
  template <typename List>
  void length(const List& list, std::size_t) {
    const auto count = static_cast<std::uint32_t>(list.size());
    raw(&count, sizeof count);
  }
  [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

private:
  std::vector<std::byte> bytes_;
};

class Reader {
public:
  explicit Reader(std::span<const std::byte> bytes) : rest_(bytes) {}

  /// What lies past the end leaves `to` as it is, and all that follows too.
  void raw(void* to, std::size_t size) {
    good_ = good_ && size <= rest_.size();
    if (!good_ || size == 0) return;
    std::memcpy(to, rest_.data(), size);
    rest_ = rest_.subspan(size);
  }
  /// A list is made no longer than it can be with `least` bytes an element, so that damaged bytes do not claim memory by a number alone.
  template <typename List>
  void length(List& list, std::size_t least) {
    std::uint32_t count = 0;
    raw(&count, sizeof count);
    good_ = good_ && count <= rest_.size() / least;
    list.resize(good_ ? count : 0);
  }
  [[nodiscard]] bool readAll() const { return good_ && rest_.empty(); }

private:
  std::span<const std::byte> rest_;
  bool good_ = true;
};

template <typename Stream, typename... Numbers>
void numbers(Stream& stream, Numbers&... of) {
  static_assert((std::is_trivially_copyable_v<Numbers> && ...));
  (stream.raw(&of, sizeof of), ...);
}

/// A byte that is neither 0 nor 1 would be no bool.
template <typename Stream, typename Flag>
void flag(Stream& stream, Flag& of) {
  std::uint8_t byte = of ? 1 : 0;
  stream.raw(&byte, 1);
  if constexpr (!std::is_const_v<Flag>) of = byte != 0;
}

template <typename Stream, typename List>
void listOfNumbers(Stream& stream, List& list) {
  using Number = typename List::value_type;
  static_assert(std::is_trivially_copyable_v<Number>);
  stream.length(list, sizeof(Number));
  stream.raw(list.data(), list.size() * sizeof(Number));
}

template <typename Stream, typename List, typename Each>
void listOf(Stream& stream, List& list, const Each& each) {
  stream.length(list, 1);
  for (auto& element : list) each(element);
}

template <typename Stream, typename SceneType>  // const for the Writer
void passThrough(Stream& stream, SceneType& scene) {
  listOfNumbers(stream, scene.name);
  listOf(stream, scene.meshes, [&](auto& mesh) {
    listOfNumbers(stream, mesh.positions);
    listOfNumbers(stream, mesh.triangles);
    listOfNumbers(stream, mesh.materials);
    listOfNumbers(stream, mesh.normals);
    listOfNumbers(stream, mesh.uvs);
  });
  listOf(stream, scene.materials, [&](auto& material) {  // files have no patterns
    numbers(stream, material.color, material.roughness, material.image);
    flag(stream, material.twoSided);
  });
  listOf(stream, scene.images, [&](auto& image) {
    numbers(stream, image.width, image.height);
    listOfNumbers(stream, image.rgba);
  });
  listOf(stream, scene.placed, [&](auto& placed) { numbers(stream, placed.mesh, placed.world); });
  listOf(stream, scene.parts, [&](auto& part) {
    listOfNumbers(stream, part.name);
    numbers(stream, part.world, part.firstPlaced, part.endPlaced);
  });
  numbers(stream, scene.bounds.min, scene.bounds.max);
  listOf(stream, scene.diagnostics, [&](auto& text) { listOfNumbers(stream, text); });
}

bool isSound(const Mesh& mesh, std::size_t materials) {
  const std::size_t triangles = mesh.triangles.size();
  if (mesh.materials.size() != triangles || mesh.normals.size() != triangles) return false;
  if (!mesh.uvs.empty() && mesh.uvs.size() != triangles) return false;
  return std::ranges::all_of(mesh.materials, [&](std::size_t material) { return material < materials; }) &&
         std::ranges::all_of(mesh.triangles, [&](const auto& corners) {
           return std::max({corners[0], corners[1], corners[2]}) < mesh.positions.size();
         });
}

/// Whether whatever one part of the scene refers to exists in it.
bool isSound(const ImportedScene& scene) {
  const auto hasImage = [&](const Material& material) { return material.image >= -1 && material.image < static_cast<int>(scene.images.size()); };
  return std::ranges::all_of(scene.meshes, [&](const Mesh& mesh) { return isSound(mesh, scene.materials.size()); }) &&
         std::ranges::all_of(scene.materials, hasImage) &&
         std::ranges::all_of(scene.images, [](const Image& image) { return image.rgba.size() / 4 == std::uint64_t{image.width} * image.height; }) &&
         std::ranges::all_of(scene.placed, [&](const auto& placed) { return placed.mesh < scene.meshes.size(); }) &&
         std::ranges::all_of(scene.parts, [&](const auto& part) { return part.firstPlaced <= part.endPlaced && part.endPlaced <= scene.placed.size(); });
}

}  // namespace

std::vector<std::byte> bytesOf(const ImportedScene& scene) {
  Writer writer;
  listOfNumbers(writer, kVersion);
  passThrough(writer, scene);
  return writer.take();
}

Result<ImportedScene> importedSceneFrom(std::span<const std::byte> bytes) {
  Reader reader(bytes);
  std::string version;
  ImportedScene scene;
  listOfNumbers(reader, version);
  if (version == kVersion) passThrough(reader, scene);
  if (version != kVersion || !reader.readAll() || !isSound(scene)) {
    return Error{"The scene's bytes are damaged, or they were read by another version of this core: serve files of one build together."};
  }
  return scene;
}

}  // namespace dimline

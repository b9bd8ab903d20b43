#include "gltf/accessor_reader.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace dimline {

namespace {

/// More elements than any mesh that could be shown: an accessor without data must not claim memory by its count alone.
constexpr std::size_t kMaxElements = 100'000'000;
/// The same where there is no data at all, or some sparse values only: the memory is claimed by a few bytes.
constexpr std::size_t kMaxElementsWithoutData = 1'000'000;

std::size_t sizeOfComponent(int type) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return 1;
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return 2;
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT:
      return 4;
    default:
      return 0;
  }
}

int componentsOf(int type) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR:
      return 1;
    case TINYGLTF_TYPE_VEC2:
      return 2;
    case TINYGLTF_TYPE_VEC3:
      return 3;
    case TINYGLTF_TYPE_VEC4:
      return 4;
    default:
      return 0;
  }
}

template <typename T>
T load(const unsigned char* bytes) {
  T value;
  std::memcpy(&value, bytes, sizeof value);
  return value;
}

template <typename T>
float loadInteger(const unsigned char* bytes, bool normalized) {
  const auto value = static_cast<float>(load<T>(bytes));
  if (!normalized) return value;
  return std::max(value / static_cast<float>(std::numeric_limits<T>::max()), -1.0F);
}

float loadFloat(const unsigned char* bytes, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
      return loadInteger<std::int8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
      return loadInteger<std::uint8_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_SHORT:
      return loadInteger<std::int16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
      return loadInteger<std::uint16_t>(bytes, normalized);
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return loadInteger<std::uint32_t>(bytes, normalized);
    default:
      return load<float>(bytes);
  }
}

bool isIndexType(int type) {
  return type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
         type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
}

std::uint32_t loadIndex(const unsigned char* bytes, int type) {
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return load<std::uint8_t>(bytes);
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return load<std::uint16_t>(bytes);
  return load<std::uint32_t>(bytes);
}

std::string labelOf(int accessor) { return "accessor " + std::to_string(accessor); }

}  // namespace

Result<const tinygltf::Accessor*> AccessorReader::find(int accessor) const {
  if (accessor < 0 || static_cast<std::size_t>(accessor) >= model_.accessors.size()) {
    return Error{labelOf(accessor) + " is used but does not exist."};
  }
  const tinygltf::Accessor* found = &model_.accessors[static_cast<std::size_t>(accessor)];
  if (found->count > (found->bufferView >= 0 ? kMaxElements : kMaxElementsWithoutData)) return Error{labelOf(accessor) + " has more elements than could be shown."};
  return found;
}

Result<AccessorReader::Elements> AccessorReader::elements(int bufferView, std::size_t byteOffset, std::size_t count,
                                                          std::size_t elementSize, const std::string& label) const {
  if (bufferView < 0 || static_cast<std::size_t>(bufferView) >= model_.bufferViews.size()) {
    return Error{label + " reads a buffer view that does not exist."};
  }
  // openGltf has seen to it that views lie within their buffers.
  const tinygltf::BufferView& view = model_.bufferViews[static_cast<std::size_t>(bufferView)];
  const std::vector<unsigned char>& data = model_.buffers[static_cast<std::size_t>(view.buffer)].data;
  const std::size_t stride = view.byteStride != 0 ? view.byteStride : elementSize;
  if (stride < elementSize) return Error{label + " has elements that overlap each other (byteStride)."};
  const bool fits = byteOffset <= view.byteLength && elementSize <= view.byteLength - byteOffset &&
                    (count == 0 || count - 1 <= (view.byteLength - byteOffset - elementSize) / stride);
  if (!fits) return Error{label + " reads past the end of buffer view " + std::to_string(bufferView) + "."};
  return Elements{std::span(data).subspan(view.byteOffset + byteOffset, view.byteLength - byteOffset), stride};
}

Status AccessorReader::fillSparse(const tinygltf::Accessor& accessor, int components, const std::string& label,
                                  std::vector<float>& values) const {
  const auto& sparse = accessor.sparse;
  const auto bad = [&] { return Error{label + " has sparse values that make no sense."}; };
  if (sparse.count < 0 || static_cast<std::size_t>(sparse.count) > accessor.count || sparse.indices.byteOffset < 0 ||
      sparse.values.byteOffset < 0 || !isIndexType(sparse.indices.componentType)) {
    return bad();
  }
  const auto count = static_cast<std::size_t>(sparse.count);
  const std::size_t size = sizeOfComponent(accessor.componentType);
  const auto indices = elements(sparse.indices.bufferView, static_cast<std::size_t>(sparse.indices.byteOffset), count,
                                sizeOfComponent(sparse.indices.componentType), label);
  if (!indices) return indices.error();
  const auto replacements = elements(sparse.values.bufferView, static_cast<std::size_t>(sparse.values.byteOffset),
                                     count, size * static_cast<std::size_t>(components), label);
  if (!replacements) return replacements.error();
  for (std::size_t i = 0; i < count; ++i) {
    const std::size_t index = loadIndex(indices->at(i), sparse.indices.componentType);
    if (index >= accessor.count) return bad();
    for (std::size_t c = 0; c < static_cast<std::size_t>(components); ++c) {
      values[index * static_cast<std::size_t>(components) + c] =
          loadFloat(replacements->at(i) + c * size, accessor.componentType, accessor.normalized);
    }
  }
  return okStatus();
}

Result<std::vector<float>> AccessorReader::floats(int index, int components) const {
  const auto found = find(index);
  if (!found) return found.error();
  const tinygltf::Accessor& accessor = **found;
  const std::string label = labelOf(index);
  const std::size_t size = sizeOfComponent(accessor.componentType);
  if (componentsOf(accessor.type) != components || size == 0) {
    return Error{label + " should hold " + std::to_string(components) +
                 " numbers an element, but holds something else."};
  }

  const auto width = static_cast<std::size_t>(components);
  std::vector<float> values(accessor.count * width, 0.0F);
  // Without a buffer view all are zero, save for the sparse ones.
  if (accessor.bufferView >= 0) {
    const auto source = elements(accessor.bufferView, accessor.byteOffset, accessor.count, size * width, label);
    if (!source) return source.error();
    for (std::size_t i = 0; i < accessor.count; ++i) {
      for (std::size_t c = 0; c < width; ++c) {
        values[i * width + c] = loadFloat(source->at(i) + c * size, accessor.componentType, accessor.normalized);
      }
    }
  }
  if (accessor.sparse.isSparse) {
    if (Status status = fillSparse(accessor, components, label, values); !status) return status.error();
  }
  for (const float value : values) {
    if (!std::isfinite(value)) return Error{label + " holds a number that is not finite."};
  }
  return values;
}

Result<std::vector<std::uint32_t>> AccessorReader::indices(int index) const {
  const auto found = find(index);
  if (!found) return found.error();
  const tinygltf::Accessor& accessor = **found;
  const std::string label = labelOf(index);
  if (accessor.type != TINYGLTF_TYPE_SCALAR || !isIndexType(accessor.componentType) || accessor.sparse.isSparse) {
    return Error{label + " should hold vertex indices, but holds something else."};
  }
  const auto source = elements(accessor.bufferView, accessor.byteOffset, accessor.count,
                               sizeOfComponent(accessor.componentType), label);
  if (!source) return source.error();
  std::vector<std::uint32_t> values(accessor.count);
  for (std::size_t i = 0; i < accessor.count; ++i) values[i] = loadIndex(source->at(i), accessor.componentType);
  return values;
}

}  // namespace dimline

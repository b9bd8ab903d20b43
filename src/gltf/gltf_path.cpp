#include <algorithm>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/text.h"
#include "gltf/gltf_container.h"
#include "gltf/gltf_reader.h"

// readGltfFile stands in a file of its own, so that the page, which never calls it, carries no file system.

namespace dimline {

namespace {

int hexDigit(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

std::string percentDecoded(std::string_view uri) {
  std::string decoded;
  for (std::size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] == '%' && i + 2 < uri.size() && hexDigit(uri[i + 1]) >= 0 && hexDigit(uri[i + 2]) >= 0) {
      decoded += static_cast<char>(hexDigit(uri[i + 1]) * 16 + hexDigit(uri[i + 2]));
      i += 2;
    } else {
      decoded += uri[i];
    }
  }
  return decoded;
}

Result<std::vector<std::byte>> readWhole(const std::filesystem::path& path, const std::string& shownName) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) return Error{shownName + " is a folder, not a file."};
  std::ifstream stream(path, std::ios::binary | std::ios::ate);
  if (!stream) return Error{"there is no file " + shownName + ", or it may not be read."};
  const std::streamoff size = stream.tellg();
  if (size > static_cast<std::streamoff>(kMaxGltfSize)) return Error{shownName + " has more than 2 GB; only smaller ones are read."};
  std::vector<std::byte> bytes(static_cast<std::size_t>(std::max<std::streamoff>(size, 0)));
  stream.seekg(0);
  stream.read(reinterpret_cast<char*>(bytes.data()), static_cast<std::streamsize>(bytes.size()));
  if (!stream) return Error{shownName + " cannot be read to its end."};
  return bytes;
}

}  // namespace

Result<Model> readGltfFile(const std::string& path) {
  const auto bytes = readWhole(path, inQuotes(path, kWholePath));
  if (!bytes) return bytes.error();
  const std::filesystem::path folder = std::filesystem::path(path).parent_path();
  return readGltf(path, *bytes, [&](std::string_view uri) -> Result<std::vector<std::byte>> {
    if (uri.find("://") != std::string_view::npos) {
      return Error{"it names " + inQuotes(uri) + ", and only files beside it are read; put that one there and name it by its file name."};
    }
    return readWhole(folder / percentDecoded(uri), inQuotes(uri));
  });
}

}  // namespace dimline

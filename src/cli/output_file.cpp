#include "cli/output_file.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <system_error>

#include "core/text.h"

namespace dimline {

namespace {

Error cannot(std::string_view what, const std::string& path, int reason) {
  return Error{"Cannot " + std::string(what) + " " + inQuotes(path) + ": " + std::strerror(reason) + "."};
}

/// Where a file comes to be.
struct Place {
  bool inPlace = false;            ///< no plain file (a terminal, a pipe): it cannot be replaced and is written to as it stands
  std::filesystem::path target;    ///< where a link leads: it stays one
  std::string partial;             ///< what is written, which then takes the target's name; its own is short enough wherever the target's is
};

Place placeOf(const std::string& path) {
  std::error_code code;
  Place place;
  place.inPlace = std::filesystem::exists(path, code) && !std::filesystem::is_regular_file(path, code);
  const std::filesystem::path resolved = std::filesystem::weakly_canonical(path, code);
  place.target = code ? std::filesystem::path(path) : resolved;
  place.partial = place.inPlace ? path : (place.target.parent_path() / (".dimline-partial-" + std::to_string(getpid()))).string();
  return place;
}

bool isFolder(const std::string& path) {
  std::error_code code;
  return std::filesystem::is_directory(path, code);
}

}  // namespace

Status checkWritable(const std::string& path) {
  if (isFolder(path)) return cannot("write", path, EISDIR);
  const Place place = placeOf(path);
  if (place.inPlace) return okStatus();
  std::FILE* file = std::fopen(place.partial.c_str(), "wb");
  if (file == nullptr) return cannot("write", path, errno);
  std::fclose(file);
  std::remove(place.partial.c_str());
  return okStatus();
}

Status writeFile(const std::string& path, std::string_view bytes) {
  if (isFolder(path)) return cannot("write", path, EISDIR);
  const auto [inPlace, target, partial] = placeOf(path);
  std::error_code code;
  std::FILE* file = std::fopen(partial.c_str(), "wb");
  if (file == nullptr) return cannot("write", path, errno);
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  int reason = written ? 0 : errno;
  if (std::fclose(file) != 0 && reason == 0) reason = errno;
  if (reason == 0 && !inPlace) {
    if (const auto old = std::filesystem::status(target, code); std::filesystem::exists(old)) std::filesystem::permissions(partial, old.permissions(), code);
    if (std::rename(partial.c_str(), target.c_str()) != 0) reason = errno;
  }
  if (reason == 0) return okStatus();
  if (!inPlace) std::remove(partial.c_str());
  return cannot("write", path, reason);
}

Status makeFolder(const std::string& path) {
  std::error_code code;
  std::filesystem::create_directories(path, code);
  if (std::filesystem::is_directory(path)) return okStatus();
  return cannot("make the folder", path, code ? code.value() : ENOTDIR);
}

Result<std::string> readFile(const std::string& path, std::size_t mostBytes) {
  if (isFolder(path)) return cannot("read", path, EISDIR);
  errno = 0;
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return cannot("read", path, errno != 0 ? errno : ENOENT);
  std::string content;
  std::array<char, 65536> block;
  while (stream.read(block.data(), block.size()) || stream.gcount() > 0) {
    content.append(block.data(), static_cast<std::size_t>(stream.gcount()));
    if (content.size() > mostBytes)
      return Error{inQuotes(path, kWholePath) + " has more than " + std::to_string(mostBytes >> 20U) + " MB, which is more than is read of such a file."};
  }
  return content;
}

}  // namespace dimline

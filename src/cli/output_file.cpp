#include "cli/output_file.h"

#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <system_error>

#include "core/text.h"

namespace dimline {

namespace {

Error cannot(std::string_view what, const std::string& path, int reason) {
  return Error{"Cannot " + std::string(what) + " " + inQuotes(path) + ": " + std::strerror(reason) + "."};
}

}  // namespace

Status writeFile(const std::string& path, std::string_view bytes) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) return cannot("write", path, EISDIR);
  // What is no plain file (a terminal, a pipe) cannot be replaced and is written to as it stands.
  const bool inPlace = std::filesystem::exists(path, code) && !std::filesystem::is_regular_file(path, code);
  const std::string partial = inPlace ? path : path + ".partial-" + std::to_string(getpid());

  std::FILE* file = std::fopen(partial.c_str(), "wb");
  if (file == nullptr) return cannot("write", path, errno);
  const bool written = std::fwrite(bytes.data(), 1, bytes.size(), file) == bytes.size();
  int reason = written ? 0 : errno;
  if (std::fclose(file) != 0 && reason == 0) reason = errno;
  if (reason == 0 && !inPlace && std::rename(partial.c_str(), path.c_str()) != 0) reason = errno;
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

Result<std::string> readFile(const std::string& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) return cannot("read", path, EISDIR);
  errno = 0;
  const std::ifstream stream(path, std::ios::binary);
  if (!stream) return cannot("read", path, errno != 0 ? errno : ENOENT);
  std::ostringstream content;
  content << stream.rdbuf();
  return content.str();
}

}  // namespace dimline

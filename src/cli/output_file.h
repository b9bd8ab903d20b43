#pragma once

#include <cstddef>
#include <string>
#include <string_view>

#include "core/result.h"

namespace dimline {

/// Writes a whole file, or leaves what was there as it was: the bytes go to a file beside it, which then takes its name.
Status writeFile(const std::string& path, std::string_view bytes);

/// What writeFile() would say of a path that cannot be written, before there is anything to write.
Status checkWritable(const std::string& path);

/// Sees to it that a folder is there, and those above it.
Status makeFolder(const std::string& path);

/// The whole of a file, or of a device, that has no more than so many bytes.
Result<std::string> readFile(const std::string& path, std::size_t mostBytes);

}  // namespace dimline

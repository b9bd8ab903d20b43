#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/result.h"

/// The punctuation of annotations: what annotation.cpp reads before it asks what the words mean.
namespace dimline {

/// Lines and columns count from 1; a column is a character, however many bytes it has.
struct TextPlace {
  int line = 1;
  int column = 1;
};

/// "line 2, column 7: ", which every message about an annotation starts with.
std::string messageStart(const TextPlace& place);

/// NAME or NAME=VALUE. The views point into the annotation's text.
struct AnnotationEntry {
  enum class Kind { kNoValue, kWord, kString, kBraces };

  std::string_view name;
  TextPlace namePlace;
  Kind kind = Kind::kNoValue;
  std::string_view value;  ///< without the quotes or braces
  TextPlace valuePlace;
};

/// The entries of @Handle(...), in their order; an error that names line and column where the punctuation is broken.
Result<std::vector<AnnotationEntry>> scanAnnotation(std::string_view text);

}  // namespace dimline

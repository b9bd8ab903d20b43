#pragma once

#include <optional>
#include <vector>

#include "math/camera.h"
#include "model/parameter.h"
#include "placement/placer.h"

namespace dimline {

/// Where all lines lay for the values that a document had lately, so that undo and redo bring back the very picture and not only the values. Of one model.
class PlaceMemory {
 public:
  /// A picture: the same camera in a viewport of the same size.
  struct Picture {
    Camera camera;
    double widthPx = 0, heightPx = 0;
    bool operator==(const Picture&) const = default;
  };

  /// What was known of these values before is forgotten, and the oldest of more than kMost as well.
  void remember(const Values& values, const Picture& picture, Placer::Memory places);
  /// Nothing when these values have not been seen lately, or in another picture.
  [[nodiscard]] std::optional<Placer::Memory> placesOf(const Values& values, const Picture& picture) const;
  void clear() { entries_.clear(); }

 private:
  /// Steps back that look as they did. Each costs some hundred bytes a parameter and some dozen a scope: a tenth of a megabyte in the largest models.
  static constexpr std::size_t kMost = 16;
  struct Entry {
    Values values;
    Picture picture;
    Placer::Memory places;
  };
  std::vector<Entry> entries_;   ///< oldest first
};

}  // namespace dimline

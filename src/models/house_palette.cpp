#include "models/house_parts.h"
#include "models/vocabulary.h"

namespace dimline::house {

// Warm and quiet: cream walls, clay tiles, sage shutters; white only where the light should catch an edge.
Palette::Palette(Builder& b) {
  using enum Material::Pattern;
  plaster = paint(b, 0xEFE5D2, 0.9F, kPlaster);
  plinth = paint(b, 0x9B938A, 0.9F, kStone);
  stone = paint(b, 0xD9CFBE, 0.85F);
  paving = paint(b, 0xB8AEA0, 0.9F, kStone);
  trim = paint(b, 0xF6F1E6, 0.7F);
  frame = paint(b, 0xF4F1EA, 0.5F);
  glass = paint(b, 0x3E5562, 0.06F, kGlass);
  door = paint(b, 0x335F66, 0.4F);
  shutter = paint(b, 0x7E9482, 0.65F, kPlanks);
  tiles = paint(b, 0xA9644B, 0.8F, kRoofTiles);
  timber = paint(b, 0x7A5C40, 0.75F, kPlanks);
  soffit = paint(b, 0xE6DCC8, 0.8F, kPlanks);
  brick = paint(b, 0xA0604A, 0.9F, kBrick);
  metal = paint(b, 0x8F979B, 0.4F, kMetal);
  darkMetal = paint(b, 0x3B4246, 0.4F, kMetal);
  gravel = paint(b, 0xA7A299, 0.95F);
  clay = paint(b, 0x9C5A43, 0.8F);
  lamp = paint(b, 0xFFF0CF, 0.3F);
}

}  // namespace dimline::house

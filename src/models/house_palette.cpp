#include "models/house_parts.h"

namespace dimline::house {

namespace {

MaterialId make(Builder& b, std::uint32_t srgb, float roughness,
                Material::Pattern pattern = Material::Pattern::kPlain) {
  Material m;
  m.color = linearFromSrgb(srgb);
  m.roughness = roughness;
  m.pattern = pattern;
  return b.addMaterial(m);
}

}  // namespace

// Warm and quiet: cream walls, clay tiles, sage shutters; white only where the light should catch an edge.
Palette::Palette(Builder& b) {
  using enum Material::Pattern;
  plaster = make(b, 0xEFE5D2, 0.9F, kPlaster);
  plinth = make(b, 0x9B938A, 0.9F, kStone);
  stone = make(b, 0xD9CFBE, 0.85F);
  paving = make(b, 0xB8AEA0, 0.9F, kStone);
  trim = make(b, 0xF6F1E6, 0.7F);
  frame = make(b, 0xF4F1EA, 0.5F);
  glass = make(b, 0x3E5562, 0.06F, kGlass);
  door = make(b, 0x335F66, 0.4F);
  shutter = make(b, 0x7E9482, 0.65F, kPlanks);
  tiles = make(b, 0xA9644B, 0.8F, kRoofTiles);
  timber = make(b, 0x7A5C40, 0.75F, kPlanks);
  soffit = make(b, 0xE6DCC8, 0.8F, kPlanks);
  brick = make(b, 0xA0604A, 0.9F, kBrick);
  metal = make(b, 0x8F979B, 0.4F, kMetal);
  darkMetal = make(b, 0x3B4246, 0.4F, kMetal);
  gravel = make(b, 0xA7A299, 0.95F);
  clay = make(b, 0x9C5A43, 0.8F);
  lamp = make(b, 0xFFF0CF, 0.3F);
}

}  // namespace dimline::house

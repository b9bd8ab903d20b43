#include "model/builder.h"

#include <algorithm>
#include <cmath>
#include <limits>

// All pitched roofs are outer faces plus the same faces lowered, tied together by an upright band along the edges
// that no two of them share. Only the outer faces differ from roof to roof.

namespace dimline {

double RoofOptions::eaveDropM() const { return overhangM * std::tan(pitchRad); }

double Roof::heightAt(double x, double z) const {
  // Every roof here is the lower hull of its planes.
  double lowest = std::numeric_limits<double>::infinity();
  for (const std::vector<Vec3>& ring : slopes) {
    const Vec3 normal = glm::cross(ring[1] - ring[0], ring[2] - ring[0]);
    lowest = std::min(lowest, ring[0].y - (normal.x * (x - ring[0].x) + normal.z * (z - ring[0].z)) / normal.y);
  }
  return lowest;
}

Roof Builder::slab(Roof roof, double dropM, const RoofOptions& options) {
  const MaterialId top = material(), edge = options.edge.value_or(top), underside = options.underside.value_or(top);
  const Vec3 drop(0, dropM, 0);
  Bounds box;
  std::vector<Segment> border;
  for (const std::vector<Vec3>& ring : roof.slopes) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Segment e{ring[i], ring[(i + 1) % ring.size()]};
      box.add(e.start);
      box.add(e.start - drop);
      const auto opposite = std::find_if(border.begin(), border.end(),
                                         [&](const Segment& o) { return o.start == e.end && o.end == e.start; });
      if (opposite == border.end()) {
        border.push_back(e);
      } else {
        border.erase(opposite);
      }
    }
  }
  roof.min = box.min;
  roof.max = box.max;
  solid([&](Solid& s) {
    for (const std::vector<Vec3>& ring : roof.slopes) {
      s.face(ring, top);
      std::vector<Vec3> below(ring.rbegin(), ring.rend());
      for (Vec3& p : below) p -= drop;
      s.face(below, underside);
    }
    for (const Segment& e : border) s.face(std::vector<Vec3>{e.start - drop, e.end - drop, e.end, e.start}, edge);
  });
  return roof;
}

Roof Builder::roofGable(const RoofOptions& options) {
  const double w = size().x, d = size().z, o = options.overhangM, slope = std::tan(options.pitchRad);
  const double drop = options.thicknessM / std::cos(options.pitchRad);
  const double eave = drop - o * slope, ridge = drop + d * 0.5 * slope;
  Roof roof;
  roof.slopes = {{{-o, eave, d + o}, {w + o, eave, d + o}, {w + o, ridge, d * 0.5}, {-o, ridge, d * 0.5}},
                 {{w + o, eave, -o}, {-o, eave, -o}, {-o, ridge, d * 0.5}, {w + o, ridge, d * 0.5}}};
  roof.ridges = {{{-o, ridge, d * 0.5}, {w + o, ridge, d * 0.5}}};
  roof.eaves = {{{-o, eave, d + o}, {w + o, eave, d + o}}, {{w + o, eave, -o}, {-o, eave, -o}}};
  return slab(std::move(roof), drop, options);
}

Roof Builder::roofHip(const RoofOptions& options) {
  const double w = size().x, d = size().z, o = options.overhangM, slope = std::tan(options.pitchRad);
  const double drop = options.thicknessM / std::cos(options.pitchRad);
  const double run = std::min(w, d) * 0.5;
  const double eave = drop - o * slope, ridge = drop + run * slope;
  const Vec3 a(-o, eave, d + o), b(w + o, eave, d + o), c(w + o, eave, -o), e(-o, eave, -o);
  // The two ends of the ridge: p at the left or front, q at the right or back; one point over a square.
  const bool square = std::abs(w - d) < MeshBuilder::kWeldM;
  const Vec3 p = w >= d ? Vec3(run, ridge, run) : Vec3(run, ridge, d - run);
  const Vec3 q = square ? p : w >= d ? Vec3(w - run, ridge, run) : Vec3(run, ridge, run);
  Roof roof;
  if (square) {
    roof.slopes = {{a, b, p}, {b, c, p}, {c, e, p}, {e, a, p}};
  } else if (w > d) {
    roof.slopes = {{a, b, q, p}, {b, c, q}, {c, e, p, q}, {e, a, p}};
  } else {
    roof.slopes = {{a, b, p}, {b, c, q, p}, {c, e, q}, {e, a, p, q}};
  }
  if (!square) roof.ridges.push_back({p, q});
  const bool across = w >= d;
  for (const Segment& hip : {Segment{a, p}, Segment{b, across ? q : p}, Segment{c, q}, Segment{e, across ? p : q}})
    roof.ridges.push_back(hip);
  roof.eaves = {{a, b}, {b, c}, {c, e}, {e, a}};
  return slab(std::move(roof), drop, options);
}

Roof Builder::roofShed(const RoofOptions& options) {
  const double w = size().x, d = size().z, o = options.overhangM, slope = std::tan(options.pitchRad);
  const double drop = options.thicknessM / std::cos(options.pitchRad);
  const double over = options.topOverhangM.value_or(o);
  const double eave = drop - o * slope, top = drop + (d + over) * slope;
  Roof roof;
  roof.slopes = {{{-o, eave, d + o}, {w + o, eave, d + o}, {w + o, top, -over}, {-o, top, -over}}};
  roof.eaves = {{{-o, eave, d + o}, {w + o, eave, d + o}}};
  return slab(std::move(roof), drop, options);
}

// A tray: what the parapet encloses is lower than its rim.
Roof Builder::roofFlat(const FlatRoofOptions& options) {
  const double o = options.overhangM, t = options.thicknessM;
  const Vec3 low(-o, 0, -o), high(size().x + o, t + std::max(options.parapetHeightM, 0.0), size().z + o);
  const double rim = std::min({options.parapetWidthM, (high.x - low.x) * 0.49, (high.z - low.z) * 0.49});
  const MaterialId top = material(), edge = options.edge.value_or(top), underside = options.underside.value_or(top);
  auto ringAt = [&](double inset, double y) {
    return std::vector<Vec3>{{low.x + inset, y, high.z - inset},
                             {high.x - inset, y, high.z - inset},
                             {high.x - inset, y, low.z + inset},
                             {low.x + inset, y, low.z + inset}};
  };
  const std::vector<Vec3> bottom = ringAt(0, 0), outer = ringAt(0, high.y), inner = ringAt(rim, high.y),
                          floor = ringAt(rim, t);
  const bool tray = options.parapetHeightM > 0 && rim > 0;
  solid([&](Solid& s) {
    s.face(std::vector<Vec3>(bottom.rbegin(), bottom.rend()), underside);
    for (std::size_t i = 0; i < 4; ++i) {
      const std::size_t j = (i + 1) % 4;
      s.face(std::vector<Vec3>{bottom[i], bottom[j], outer[j], outer[i]}, edge);
      if (!tray) continue;
      s.face(std::vector<Vec3>{outer[i], outer[j], inner[j], inner[i]}, edge);
      s.face(std::vector<Vec3>{inner[i], inner[j], floor[j], floor[i]}, edge);
    }
    s.face(tray ? floor : outer, top);
  });
  Roof roof;
  roof.slopes = {tray ? floor : outer};
  for (std::size_t i = 0; i < 4; ++i) roof.eaves.push_back({outer[i], outer[(i + 1) % 4]});
  roof.min = low;
  roof.max = high;
  return roof;
}

}  // namespace dimline

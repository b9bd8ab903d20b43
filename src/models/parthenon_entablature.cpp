#include <array>
#include <numbers>

#include "models/mouldings.h"
#include "models/parthenon_parts.h"
#include "models/vocabulary.h"

// What the columns carry. A frieze is a row of equal pieces, each a triglyph with the metope to its right and all that belongs to
// them above and below; one more triglyph ends the row at the corner.
//
//     ________________ geison        mutules hang under it, one over each triglyph and each metope
//     |#|    |#|    |                frieze: # triglyph
//     --------------- taenia         a regula with six guttae under each triglyph
//                     architrave

namespace dimline::parthenon {

namespace {

constexpr double kFriezeBack = 0.16;   // the metopes' face behind the architrave's (m)

struct Heights {
  double architrave, frieze, geison;
};

Heights heightsOf(const Plan& p) { return {0.41 * p.entablature, 0.41 * p.entablature, 0.18 * p.entablature}; }

/// A slab under the geison's soffit. Scope: a row's, with y = 0 at the foot of the frieze.
void drawMutule(const Parthenon& t, double x) {
  const Heights h = heightsOf(t.plan);
  t.b.material(t.m.blue);
  t.b.box({x, h.frieze + 0.14 * h.geison, 0.05}, {t.plan.triglyph(), 0.2 * h.geison, t.plan.overhang - 0.2});
}

void drawTriglyph(const Parthenon& t) {
  Builder& b = t.b;
  const Heights h = heightsOf(t.plan);
  const double w = t.plan.triglyph(), groove = w / 7.5, flat = (w - 3 * groove) / 3, deep = 0.5 * groove, face = 0.06;
  b.push([&] {
    b.scale(Axis::kY, 0.88 * h.frieze);
    b.material(t.m.blue);
    Ring ring{{0, -kFriezeBack - 0.1}, {0, face - deep}, {0.5 * groove, face}};
    for (int i = 0; i < 3; ++i) {
      const double x = 0.5 * groove + i * (flat + groove);
      if (i > 0) {
        ring.emplace_back(x - 0.5 * groove, face - deep);
        ring.emplace_back(x, face);
      }
      ring.emplace_back(x + flat, face);
    }
    ring.emplace_back(w, face - deep);
    ring.emplace_back(w, -kFriezeBack - 0.1);
    b.extrudePolygon(ring, Axis::kY);
  });
  b.box({0, 0.88 * h.frieze, -kFriezeBack - 0.1}, {w, 0.12 * h.frieze, kFriezeBack + 0.1 + face + 0.02});
  // Regula and guttae, under the taenia.
  b.material(t.m.marble);
  const double taenia = 0.075 * h.architrave, regula = 0.06 * h.architrave, gutta = 0.05 * h.architrave;
  b.box({0, -taenia - regula, -0.05}, {w, regula, 0.11});
  for (int i = 0; i < 6; ++i) {
    b.push([&] {
      const double d = 0.7 * w / 6;
      b.translate({(i + 0.5) * w / 6 - 0.5 * d, -taenia - regula - gutta, 0});
      b.scale({d, gutta, 0.07});
      b.cone(0.75, {.segments = 6});
    });
  }
  drawMutule(t, 0);
}

/// Painted ground under a band.
void drawMetope(const Parthenon& t, double x, double w) {
  Builder& b = t.b;
  const Heights h = heightsOf(t.plan);
  b.material(t.m.red);
  b.box({x - 0.02, 0, -kFriezeBack - 0.1}, {w + 0.04, h.frieze, 0.1});
  b.material(t.m.marble);
  b.box({x - 0.02, 0.9 * h.frieze, -kFriezeBack - 0.05}, {w + 0.04, 0.1 * h.frieze, kFriezeBack + 0.05});
}

}  // namespace

void drawEntablature(const Parthenon& t) {
  Builder& b = t.b;
  const Plan& p = t.plan;
  const Heights h = heightsOf(p);
  const double inset = p.faceInset(), w = p.width - 2 * inset, l = p.length - 2 * inset, depth = 1.6 * p.radius, out = p.overhang;
  b.translate({inset, p.architrave(), inset});
  b.scale({w, p.entablature, l});
  b.name("Entablature");

  b.material(t.m.marble);
  const double taenia = 0.925 * h.architrave, frieze = h.architrave + h.frieze;
  drawMoulding(b, {w, l}, {{-depth, 0}, {0, 0}, {0, taenia}, {0.06, taenia}, {0.06, h.architrave}, {-kFriezeBack - 0.05, h.architrave},
                           {-kFriezeBack - 0.05, frieze}, {-depth, frieze}});
  b.push([&] {
    b.translate({0, frieze, 0});
    const double g = h.geison;
    drawMoulding(b, {w, l}, {{-depth, 0}, {0.03, 0}, {0.1, 0.16 * g}, {0.1, 0.3 * g}, {out - 0.12, 0.3 * g}, {out - 0.12, 0.2 * g}, {out - 0.06, 0.2 * g},
                             {out - 0.06, 0.8 * g}, {out, 0.88 * g}, {out, g}, {-depth, g}});
  });

  const auto pitchOf = [&](double length, int bays) { return (length - p.triglyph()) / (2 * bays); };
  std::array<PartId, 2> pieces{};
  for (const std::size_t side : {0U, 1U}) {
    const double pitch = side == 0 ? pitchOf(w, p.baysAcross) : pitchOf(l, p.baysAlong);
    pieces[side] = b.part({pitch, h.frieze, 0}, [&] {
      drawTriglyph(t);
      drawMetope(t, p.triglyph(), pitch - p.triglyph());
      drawMutule(t, 0.5 * pitch);
    });
  }
  const PartId last = b.part({p.triglyph(), h.frieze, 0}, [&] { drawTriglyph(t); });
  // Shields of bronze along the architrave of the east front, as Alexander gave them.
  const PartId shield = b.part({0, 0, 0}, [&] {
    b.material(t.m.gold);
    const double r = 0.3 * h.architrave;
    b.lathe(std::array<Vec2, 5>{{{r, 0}, {r, 0.05}, {0.84 * r, 0.05}, {0.5 * r, 0.13}, {0, 0.16}}}, {.segments = 20, .creaseRad = 0.5});
  });
  b.faces(kSideFaces, [&](Face face) {
    const bool front = face == Face::kFront || face == Face::kBack;
    const int bays = front ? p.baysAcross : p.baysAlong;
    const double length = front ? w : l, pitch = pitchOf(length, bays);
    b.translate({0, h.architrave, 0});
    for (int i = 0; i < 2 * bays; ++i) {
      b.push([&] {
        b.translate({i * pitch, 0, 0});
        b.place(pieces[front ? 0 : 1]);
        if (face != Face::kFront) return;
        b.translate({0.5 * (pitch + p.triglyph()), -0.55 * h.architrave, -0.02});
        b.rotate(Axis::kX, std::numbers::pi / 2);
        b.place(shield);
      });
    }
    b.push([&] {
      b.translate({length - p.triglyph(), 0, 0});
      b.place(last);
    });
    // Measured where it turns the corner to the right: there it stands out against the sky.
    nameBox(b, "Geison", {length, h.frieze, 0}, {length + out, h.frieze + h.geison, out});
  });
}

}  // namespace dimline::parthenon

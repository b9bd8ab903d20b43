#pragma once

#include <array>
#include <numbers>
#include <optional>
#include <vector>

#include "model/builder.h"
#include "model/model.h"

// The galleon in numbers, before anything is drawn: the form of her hull, her decks, masts, spars and guns. Inner
// header of the boat model.
//
// She lies along x, her bow towards +x; starboard is +z; y = 0 is the underside of her planking amidships, x = 0 where
// her main deck meets the stern and x = Length where it meets the stem.

namespace dimline::boat {

/// The parameters, in the order of their definition.
enum Parameter : std::size_t {
  kLength,
  kBeam,
  kDepth,
  kDraught,
  kSheer,
  kBeakLength,
  kGunPortSpacing,
  kGunsRunOut,
  kForecastleLength,
  kForecastleHeight,
  kSternDecks,
  kSternDeckHeight,
  kGalleryDepth,
  kForeMastHeight,
  kMainMastHeight,
  kMizzenMastHeight,
  kBonaventureMastHeight,
  kBowspritLength,
  kBowspritSteeve,
  kForeSailWidth,
  kMainSailWidth,
  kTopsailWidth,
  kSailBelly,
  kParameterCount
};

inline constexpr double kPi = std::numbers::pi;

// Fixed sizes that more than one part of the ship depends on (m).
inline constexpr double kKeel = 0.45;      ///< depth of the keel below the planking
inline constexpr double kBlocks = 0.55;    ///< and the blocks that it stands on
inline constexpr double kBulwark = 1.1;    ///< height of the sides above each deck
inline constexpr double kPlank = 0.16;     ///< thickness of the topsides
inline constexpr double kPortSize = 0.78;  ///< a gun port, square
inline constexpr double kSternRake = 0.2;  ///< how far the stern leans aft in a metre of its height
inline constexpr double kCamber = 0.045;   ///< how far a deck is higher in its middle, as a share of half its breadth
/// A ship of this length carries a mizzen mast, and one of that a bonaventure mizzen abaft it.
inline constexpr double kMizzenFromLength = 30;
inline constexpr double kBonaventureFromLength = 44;

/// The form of the hull. A height h runs along the strakes: it is the y of a strake amidships, and strakes rise to
/// both ends by the sheer.
///
///      y  |\            h = depth           _/|
///         | '--.._____________________..--'' /
///         |  '-..___     the wale   ___..-'_/      stem
///          \_     '''-----------'''    _.-'
///            '-----------------------''    h = 0
///         x = 0                            x = length
struct HullForm {
  double length = 0, beam = 0, depth = 0, sheer = 0, draught = 0;

  [[nodiscard]] double wale() const { return 0.52 * depth; }  ///< the height of the greatest breadth
  [[nodiscard]] double tuck() const { return 0.45 * depth; }  ///< below it the stern is as sharp as the bow
  /// Half the ship's breadth amidships.
  [[nodiscard]] double midship(double h) const;
  [[nodiscard]] double sternX(double h) const;
  [[nodiscard]] double stemX(double h) const;
  /// The starboard side's outer face; u runs from 0 at the stern to 1 at the stem.
  [[nodiscard]] Vec3 side(double u, double h) const;
  [[nodiscard]] double uAt(double x, double h) const;
  [[nodiscard]] Vec3 sideAt(double x, double h) const;
};

/// The line along the hull's starboard side at one height, for many points of it: what depends on the height alone is worked
/// out once.
class HullLine {
public:
  HullLine(const HullForm& hull, double h);

  [[nodiscard]] double sternX() const { return sternX_; }
  [[nodiscard]] double stemX() const { return stemX_; }
  [[nodiscard]] double uAt(double x) const;
  [[nodiscard]] Vec3 side(double u) const;
  [[nodiscard]] Vec3 sideAt(double x) const { return side(uAt(x)); }

private:
  double h_, sheerThere_, sternX_, stemX_, broadest_, transom_;
  double runPower_, runFullness_;            ///< abaft the broadest place
  double entrancePower_, entranceFullness_;  ///< before it
};

/// A deck of the castles. It and the sides below reach from `fromX` to `toX`, sides to the bulwark's rail.
struct Deck {
  double h = 0;
  double fromX = 0, toX = 0;
};

/// A square sail between its yard and the feet of its leeches.
struct SquareSail {
  double yardY = 0, footY = 0;
  double headWidth = 0, footWidth = 0;
  double belly = 0;
  double roach = 0;  ///< how far its foot is hollowed in the middle: an upper sail's clears the top behind it
};

/// The surface of a square sail whose head is at `x`: across runs from -1 on the port side to 1, down from 0 at the yard to 1 at the foot.
struct SailSurface {
  const SquareSail& sail;
  double x;
  [[nodiscard]] Vec3 at(double across, double down) const;
};

/// A stay from a mast's head forward to `end`, or to as far above that as it takes to pass kStayClearM before a full sail.
Segment stayBefore(const SailSurface& sail, const Vec3& head, Vec3 end);
inline constexpr double kStayClearM = 0.35;

struct Mast {
  double x = 0;
  double deckY = 0;               ///< of the deck that it rises from
  double height = 0;              ///< from there to the truck
  double radius = 0;              ///< at the deck
  double channelH = 0;            ///< the strake that carries its shrouds
  int shrouds = 0;                ///< on each side
  std::vector<SquareSail> sails;  ///< course, topsail, topgallant; none for the lateen masts
  double lateenYard = 0;          ///< its length
  [[nodiscard]] double topY() const { return deckY + 0.45 * height; }
  [[nodiscard]] double topRadius() const { return 0.62 + 0.022 * height; }
  [[nodiscard]] double truckY() const { return deckY + height; }
  [[nodiscard]] double topmastX() const { return x + 1.55 * radius; }
  [[nodiscard]] double gallantX() const { return topmastX() + radius; }
  [[nodiscard]] double yardRadius(std::size_t i) const { return 0.06 + 0.0095 * sails[i].headWidth; }
  [[nodiscard]] double yardX(std::size_t i) const;
  [[nodiscard]] SailSurface sailSurface(std::size_t i) const { return {sails[i], yardX(i) + 0.3 * yardRadius(i)}; }
};

struct Battery {
  double fromX = 0, spacing = 0;
  int bays = 0;
  double h = 0;  ///< of the sills
};

struct Plan {
  HullForm hull;
  double beak = 0;
  Deck forecastle;
  std::vector<Deck> stern;  ///< half deck, quarterdeck, poop: as many as there are
  double sternDeckHeight = 0, gallery = 0;
  Mast fore, main;
  std::optional<Mast> mizzen, bonaventure;
  Vec3 bowspritFoot{0.0}, bowspritTip{0.0};
  double bowspritLength = 0, steeveRad = 0;
  Battery battery;
  bool gunsRunOut = false;

  /// The upper edge of the sides at x: the rail's strake.
  [[nodiscard]] double railH(double x) const;
  /// Of the highest deck at x.
  [[nodiscard]] double deckH(double x) const;
};

Plan planBoat(const Values& values);

}  // namespace dimline::boat

#pragma once

#include <memory>

#include "placement/guides.h"
#include "placement/landed.h"
#include "placement/layout.h"

namespace dimline {

/// What one frame's lines and handles have taken up so far (silhouette updating, paper 4.5). The fields stand twice more than they are measured: padded by
/// handleSpacing, and padded with all that has landed, each thing grown by what later lines keep from it. A line that clears those keeps
/// its distance from everything, so no step after the query needs to add padding.
class Occupied {
 public:
  /// A frame begins.
  void begin(const DistanceFields& model);
  /// How far (px) lines that come after a label stand from it; kLabelClearancePx unless told.
  void keepFromLabels(double px) { labelClearancePx_ = px; }
  /// Nothing but the model is there: before each attempt at the frame.
  void clear();
  /// What has landed, with its fields and guides. It can be kept, to go back to it in the same frame.
  struct Contents {
    DistanceFields padded;
    Landed landed;
    Guides guides;

    /// Room for as much as another one has room for, so that neither allocates when it is copied to the other.
    void makeRoomLike(const Contents& other);
  };
  [[nodiscard]] const Contents& contents() const { return *contents_; }
  void goBackTo(const Contents& kept) { *contents_ = kept; }
  void makeRoomLike(const Occupied& other) { contents_->makeRoomLike(*other.contents_); }
  /// Exchanges it with that of another one of the same frame.
  void swapLanded(Occupied& other) { contents_.swap(other.contents_); }

  [[nodiscard]] const DistanceFields& paddedModel() const { return paddedModel_; }   ///< the model alone, with handleSpacing
  [[nodiscard]] const DistanceFields& padded() const { return contents_->padded; }    ///< model and all that has landed
  [[nodiscard]] const Landed& landed() const { return contents_->landed; }
  [[nodiscard]] const Guides& guides() const { return contents_->guides; }

  /// A new guide through a line on a plane; returns its number.
  int addGuide(const Plane& plane, const Segment& line) { return contents_->guides.add(plane, line); }
  /// A label that stands there, of a line that takes up nothing else.
  void add(const Box2& label) { contents_->landed.addLabel(label); }
  /// A line that will stand there, whatever comes before it; to be released at its turn.
  void reserve(const PlacedLine& line) { contents_->landed.reserve(line); }
  void release(const PlacedLine& line) { contents_->landed.release(line); }
  /// `guide`: the number of the guide that the line lies on; -1 for a line inside the model, which takes up nothing outside.
  void add(const PlacedLine& line, int guide);
  void add(const PlacedHandle& handle, const View& view);

 private:
  DistanceFields paddedModel_;
  double labelClearancePx_ = kLabelClearancePx;
  std::unique_ptr<Contents> contents_ = std::make_unique<Contents>();
};

}  // namespace dimline

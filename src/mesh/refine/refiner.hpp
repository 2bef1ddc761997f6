// The passes of an adaptive subdivision: measure new pieces, choose edges, split them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "mesh/refine/deviation.hpp"
#include "mesh/refine/surface.hpp"

namespace warpjet {

class Refiner {
 public:
  Refiner(const Mesh& mesh, const Refinement& refinement, const WarpFunction& warp);

  Refined run() &&;

 private:
  struct Need {
    float score = 0;  // as a multiple of the tolerance
    SurfaceError error;
    bool canSplit = true;

    bool isWanted() const { return score > 1 && canSplit; }
  };

  void warpNewVertices();
  void findScale();
  void measureSides();
  void measureInsides();

  // See scrutiny.cpp.
  struct Scrutiny {
    // The second measurement takes at least `minSamples`, and at least `samplesIfDoubtful` if the
    // first measurement leaves doubts.
    std::uint32_t samplesIfDoubtful, minSamples;
    float warpedLength;  // of the edge that would be split
  };
  struct Finding {
    SurfaceError error;
    float score = 0;
    bool isCreased = false;
  };
  // Measures pieces, and measures those that seem fine again with more samples.
  std::vector<Finding> measureInTwoPasses(std::span<const Piece> pieces,
                                          std::span<const Scrutiny> scrutinies);
  void findCreases(std::span<const Piece> pieces, std::span<const Scrutiny> scrutinies,
                   std::span<const Deviation> deviations, std::vector<Finding>& findings) const;
  // Updates `isDefined_` and `unresolved_`.
  void recordLimits(const Deviation& deviation);
  float score(const SurfaceError& error, bool countsAngle) const;
  bool countsAngle(const Finding& finding, const Scrutiny& scrutiny) const;

  // See choice.cpp.
  std::vector<std::uint32_t> chooseEdges();
  void keepShape(std::vector<bool>& chosen) const;
  std::vector<std::uint32_t> keepWorst(std::vector<std::uint32_t> edges, std::size_t room);

  bool hasWantedSide(const Triangle& triangle) const;
  bool isTorn(const Triangle& triangle) const;
  bool hasRoom(const Edge& edge) const;

  Refinement refinement_;
  const WarpFunction& warp_;
  Surface surface_;
  bool hasNormals_ = false;
  Moved warped_;                     // by vertex
  Moved middles_;                    // by side
  std::vector<Need> needs_;          // by edge
  std::uint32_t measuredSides_ = 0;  // the number of measured sides, which come first
  double samplesPerLength_ = 0, samplesPerArea_ = 0, bumpSamplesPerArea_ = 0;  // in model units
  double minTornStretch_ = 0;   // the stretch above which an edge counts as torn
  float maxCreaseLength_ = 0;   // creases are only searched for on warped edges up to this length
  float minNormalsLength_ = 0;  // warped edges up to this length aren't split for their normals
  float unresolved_ = 0;        // a distance above the tolerance that floats can't resolve
  bool isFull_ = false, isDefined_ = true;
};

}  // namespace warpjet

// The passes of an adaptive subdivision: measure what is new, choose edges, split them.
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
    float score = 0;  // as a multiple of what is allowed
    Off off;
    bool canSplit = true;

    bool isWanted() const { return score > 1 && canSplit; }
  };

  void warpNewVertices();
  void findScale();
  void measureSides();
  void measureInsides();

  // In scrutiny.cpp.
  struct Scrutiny {
    std::uint32_t inDoubt, always;  // samples of the closer look
    float warpedLength;             // of the edge that would be split
  };
  struct Finding {
    Off off;
    float score = 0;
    bool isCreased = false;
  };
  std::vector<Finding> look(std::span<const Piece> pieces, std::span<const Scrutiny> scrutinies);
  void findCreases(std::span<const Piece> pieces, std::span<const Scrutiny> scrutinies,
                   std::span<const Deviation> deviations, std::vector<Finding>& findings) const;
  void note(const Deviation& deviation);
  float score(const Off& off, bool countsAngle) const;
  bool countsAngle(const Finding& finding, const Scrutiny& scrutiny) const;

  // In choice.cpp.
  std::vector<std::uint32_t> chooseEdges();
  void keepShape(std::vector<bool>& chosen) const;
  std::vector<std::uint32_t> worst(std::vector<std::uint32_t> edges, std::size_t room);

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
  std::uint32_t measuredSides_ = 0;  // the first so many
  double samplesOfLength_ = 0, samplesOfArea_ = 0, bumpSamplesOfArea_ = 0;
  double tear_ = 0;       // the stretch of an edge from which on the warp tears it
  float crease_ = 0;      // the length of a warped edge that is short enough at a crease
  float shortest_ = 0;    // the length of one that is not split for its normals
  float unresolved_ = 0;  // a distance above the tolerance that floats cannot resolve
  bool isFull_ = false, isDefined_ = true;
};

}  // namespace warpjet

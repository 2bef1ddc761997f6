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
    std::uint32_t inDoubt, always;  // samples of the closer look
    float warpedLength;             // of the edge that would be split
  };
  struct Finding {
    SurfaceError error;
    float score = 0;
    bool isCreased = false;
  };
  std::vector<Finding> look(std::span<const Piece> pieces, std::span<const Scrutiny> scrutinies);
  void findCreases(std::span<const Piece> pieces, std::span<const Scrutiny> scrutinies,
                   std::span<const Deviation> deviations, std::vector<Finding>& findings) const;
  void note(const Deviation& deviation);
  float score(const SurfaceError& error, bool countsAngle) const;
  bool countsAngle(const Finding& finding, const Scrutiny& scrutiny) const;

  // See choice.cpp.
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
  std::uint32_t measuredSides_ = 0;  // the number of measured sides, which come first
  double samplesOfLength_ = 0, samplesOfArea_ = 0, bumpSamplesOfArea_ = 0;
  double tear_ = 0;       // the stretch above which an edge counts as torn
  float crease_ = 0;      // the length of a warped edge that is short enough at a crease
  float shortest_ = 0;    // the length below which an edge isn't split for its normals
  float unresolved_ = 0;  // a distance above the tolerance that floats can't resolve
  bool isFull_ = false, isDefined_ = true;
};

}  // namespace warpjet

// The passes of an adaptive subdivision: measure what is new, choose edges, split them.
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/deviation.hpp"
#include "mesh/surface.hpp"

namespace warpjet {

// So that every vertex has a number of 32 bits. js-bindings/mesh/subdivide.ts refuses more.
constexpr std::size_t mostTriangles = std::size_t{1} << 28;

class Refiner {
 public:
  Refiner(const Mesh& mesh, const Refinement& refinement, const WarpFunction& warp);

  Refined run() &&;

 private:
  struct Need {
    float score = 0;     // as a multiple of what is allowed
    float distance = 0;  // model units
    bool canSplit = true;

    bool isWanted() const { return score > 1 && canSplit; }
  };

  void warpNewVertices();
  void findScale();
  void measureSides();
  void measureInsides();

  // In choice.cpp.
  std::vector<std::uint32_t> chooseEdges() const;
  void keepShape(std::vector<bool>& chosen) const;
  std::vector<std::uint32_t> worst(std::vector<std::uint32_t> edges, std::size_t room) const;

  bool hasWantedSide(const Triangle& triangle) const;
  float score(const Deviation& deviation, float warpedLength) const;
  bool hasRoom(const Edge& edge) const;

  Refinement refinement_;
  const WarpFunction& warp_;
  Surface surface_;
  Moved warped_;
  std::vector<Need> needs_;        // by edge
  std::size_t measuredSides_ = 0;  // the first so many
  double totalLength_ = 0;         // of the edges that came
  double totalArea_ = 0;           // of the triangles that came
  double tear_ = 0;                // the stretch of an edge from which on the warp tears it
};

}  // namespace warpjet

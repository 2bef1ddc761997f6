#include "detail/needs.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "detail/criterion.hpp"
#include "detail/tessellation.hpp"

namespace warpjet {

std::uint32_t roundUp(float need) {
  const auto found = std::find_if(pieceCounts.begin(), pieceCounts.end(), [&](std::uint32_t count) {
    return static_cast<float>(count) >= need;
  });
  return found == pieceCounts.end() ? maxPieces : *found;
}

void Needs::update(const WarpedMesh& mesh, std::span<const ScreenView> views, float tolerance) {
  const BaseMesh& base = mesh.base;
  std::swap(squares_, formerSquares_);
  squares_.assign(base.edgeCount(), 0);
  bentSides_.assign(base.triangles().size(), {});
  float squaredUniform = 0;
  for (std::size_t first = 0; first < mesh.triangles.size(); first += Lanes::count) {
    const FourTriangles triangles = fourAt(mesh.triangles, first);
    const TriangleNeeds needs = needsOf(mesh, triangles, views, tolerance);
    for (std::size_t lane = 0; lane < triangles.size(); ++lane) {
      const std::uint32_t t = triangles[lane];
      squaredUniform = std::max(squaredUniform, needs.squaredUniform[lane]);
      for (int i = 0; i < 3; ++i) {
        float& square = squares_[base.edgeOf(t, i)];
        square = std::max(square, needs.squaredSides[i][lane]);
        bentSides_[t][i] = needs.bentSides[i][lane];
      }
    }
  }
  // Half of the former change counts, too: a need that falls to zero and grows again can be the
  // same in two measurements. An infinite former change says nothing about the next one.
  const float change = std::abs(squaredUniform - squaredUniform_);
  const float formerChange = std::isfinite(uniformChange_) ? uniformChange_ / 2 : 0;
  uniformChange_ = change >= formerChange ? change : formerChange;
  squaredUniform_ = squaredUniform;
  pieces_.resize(base.edgeCount(), 1);
  formerPieces_ = pieces_;
  choosePieces();
}

void Needs::lower(float divisor) {
  for (float& square : squares_) square /= divisor;
  squaredUniform_ /= divisor;
  choosePieces();
}

void Needs::choosePieces() {
  for (std::size_t edge = 0; edge < squares_.size(); ++edge) {
    const float need = std::sqrt(squares_[edge]);
    pieces_[edge] =
        std::clamp(formerPieces_[edge], roundUp(need), roundUp(need * criterion.hysteresis));
  }
}

// An edge without a former need was invisible or flat, so its change predicts nothing. Within the
// margins of a view, edges get their pieces before they are seen. So such edges count only if they
// are more than a slow motion reveals.
bool Needs::piecesStayExact() const {
  constexpr float maxRevealed = 0.05f;
  if (formerSquares_.size() != squares_.size()) return false;
  std::size_t divided = 0, revealed = 0;
  for (std::size_t edge = 0; edge < squares_.size(); ++edge) {
    const float square = squares_[edge], former = formerSquares_[edge];
    const auto pieces = static_cast<float>(pieces_[edge]);
    if (square > 1) ++divided;
    if (former == 0) {
      if (square > 1) ++revealed;
    } else if (!(criterion.aim * (square + std::abs(square - former)) <= pieces * pieces)) {
      return false;
    }
  }
  return static_cast<float>(revealed) <= maxRevealed * static_cast<float>(divided);
}

bool Needs::uniformStaysExact(std::uint32_t pieces) const {
  const auto count = static_cast<float>(pieces);
  return squaredUniform_ + uniformChange_ <= count * count;
}

}  // namespace warpjet

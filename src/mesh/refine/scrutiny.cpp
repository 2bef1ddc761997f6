// The part of the refiner that measures pieces: all of them once, and those that seem fine a second
// time with more samples.
#include <algorithm>
#include <utility>

#include "mesh/refine/crease.hpp"
#include "mesh/refine/refiner.hpp"
#include "mesh/surface/points.hpp"

namespace warpjet {

namespace {

// The share of the residual that the second measurement may have missed, and the share of the
// tolerance that a measured deviation may reach: between samples of noise, the deviation is up to a
// twentieth larger.
constexpr float missedShare = 0.1f, margin = 0.95f;

}  // namespace

std::vector<Refiner::Finding> Refiner::measureInTwoPasses(std::span<const Piece> pieces,
                                                          std::span<const Scrutiny> scrutinies) {
  auto deviations = measure(surface_.mesh(), warped_, middles_, pieces, warp_);
  std::vector<Finding> findings(pieces.size());
  findCreases(pieces, scrutinies, deviations, findings);

  std::vector<Piece> closer;
  std::vector<std::size_t> pieceIndices;
  std::vector<bool> isInDoubt;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    if (findings[i].score > 1) continue;
    const float residual = score(deviations[i].residual, countsAngle(findings[i], scrutinies[i]));
    const bool mayBeMore = findings[i].score + 4 * residual > 1;
    const std::uint32_t samples =
        std::max(scrutinies[i].minSamples, mayBeMore ? scrutinies[i].samplesIfDoubtful : 0);
    if (samples <= pieces[i].samples) continue;
    // All samples of an edge but the middle move if their number changes.
    const std::uint32_t known = pieces[i].isEdge() ? 1 : pieces[i].samples;
    closer.push_back({pieces[i].corners, pieces[i].sides, samples, known});
    pieceIndices.push_back(i);
    isInDoubt.push_back(mayBeMore);
  }
  const auto again = measure(surface_.mesh(), warped_, middles_, closer, warp_);
  for (std::size_t i = 0; i < closer.size(); ++i) {
    Deviation& deviation = deviations[pieceIndices[i]];
    if (again[i].max.angle > deviation.max.angle)
      deviation.maxAngleSample = again[i].maxAngleSample;
    deviation.max.raise(again[i].max);
    deviation.residual.raise(again[i].residual);
    deviation.unresolved = std::max(deviation.unresolved, again[i].unresolved);
    deviation.isDefined = deviation.isDefined && again[i].isDefined;
  }
  findCreases(pieces, scrutinies, deviations, findings);
  for (std::size_t i = 0; i < closer.size(); ++i) {
    Finding& finding = findings[pieceIndices[i]];
    if (isInDoubt[i])
      finding.score += missedShare * score(deviations[pieceIndices[i]].residual,
                                           countsAngle(finding, scrutinies[pieceIndices[i]]));
  }
  for (const Deviation& deviation : deviations) recordLimits(deviation);
  return findings;
}

// Finds creases and computes the scores, which exclude the angle across a crease.
void Refiner::findCreases(std::span<const Piece> pieces, std::span<const Scrutiny> scrutinies,
                          std::span<const Deviation> deviations,
                          std::vector<Finding>& findings) const {
  std::vector<Turn> turns;
  std::vector<std::size_t> pieceIndices;
  for (std::size_t i = 0; i < pieces.size(); ++i) {
    findings[i].error = deviations[i].max;
    if (!countsAngle(findings[i], scrutinies[i]) || scrutinies[i].warpedLength > maxCreaseLength_ ||
        findings[i].error.angle <= refinement_.angle)
      continue;
    turns.push_back({pieces[i].corners, deviations[i].maxAngleSample});
    pieceIndices.push_back(i);
  }
  const auto hasJump = findJumps(surface_.mesh(), turns, refinement_.angle, warp_);
  for (std::size_t i = 0; i < turns.size(); ++i) findings[pieceIndices[i]].isCreased = hasJump[i];
  for (std::size_t i = 0; i < pieces.size(); ++i)
    findings[i].score = score(findings[i].error, countsAngle(findings[i], scrutinies[i]));
}

void Refiner::recordLimits(const Deviation& deviation) {
  isDefined_ = isDefined_ && deviation.isDefined;
  if (deviation.unresolved > refinement_.tolerance)
    unresolved_ = std::max(unresolved_, deviation.unresolved);
}

bool Refiner::countsAngle(const Finding& finding, const Scrutiny& scrutiny) const {
  return !finding.isCreased && scrutiny.warpedLength > minNormalsLength_;
}

float Refiner::score(const SurfaceError& error, bool countsAngle) const {
  return std::max(error.distance / (margin * refinement_.tolerance),
                  countsAngle ? error.angle / refinement_.angle : 0);
}

}  // namespace warpjet

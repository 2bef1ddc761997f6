#include "detail/detail.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <utility>

#include "detail/criterion.hpp"
#include "detail/cut_lengths.hpp"

namespace warpjet {

namespace {

constexpr std::size_t numbersPerView = 19;

// The approximate max number of triangles of a divided mesh. A surface that needs more is drawn
// less exactly.
constexpr double maxDrawnTriangles = 1 << 20;

ScreenView readView(std::span<const float> numbers) {
  ScreenView view;
  for (int i = 0; i < 16; ++i) view.clip[i / 4][i % 4] = numbers[i];
  view.halfSize = {numbers[16], numbers[17]};
  view.facing = numbers[18];
  return view;
}

// Replaces each segment of a line by the pieces of the side between its vertices.
void divideLine(std::vector<std::uint32_t>& line, const BaseMesh& mesh,
                std::span<const std::uint32_t> pieces,
                std::span<const std::uint32_t> firstVertices) {
  std::vector<std::uint32_t> divided{line[0]};
  for (std::size_t i = 1; i < line.size(); ++i) {
    const std::uint32_t side = mesh.sideBetween(line[i - 1], line[i]);
    const std::uint32_t count = side == none ? 1 : pieces[mesh.sides()[side].edge];
    for (std::uint32_t k = 0; k + 1 < count; ++k) {
      const bool isForward = mesh.startsAt(side, line[i - 1]);
      divided.push_back(firstVertices[side] + (isForward ? k : count - 2 - k));
    }
    divided.push_back(line[i]);
  }
  line = std::move(divided);
}

}  // namespace

Detail::Detail(std::vector<Attribute> attributes, std::uint32_t triangles,
               std::vector<std::uint32_t> groups, bool isCurved)
    : given_(std::move(attributes)),
      givenIndices_(3 * std::size_t{triangles}),
      givenGroups_(std::move(groups)),
      isCurved_(isCurved) {}

void Detail::begin() {
  std::vector<Corners> triangles;
  for (std::size_t i = 0; i < givenIndices_.size(); i += 3)
    triangles.push_back({givenIndices_[i], givenIndices_[i + 1], givenIndices_[i + 2]});
  baseGroups_ = givenGroups_;
  cuts_.clear();
  phases_.areCreasesCut = false;
  BaseMesh mesh(given_, std::move(triangles));
  surface_.reset();
  const auto normals = std::find_if(given_.begin(), given_.end(), [](auto& a) { return a.isUnit; });
  if (isCurved_ && normals != given_.end()) {
    surface_.emplace(mesh, static_cast<std::size_t>(normals - given_.begin()));
  }
  std::vector<Patch> patches = makeWholePatches(mesh.triangles().size());
  setBase(std::move(mesh), std::move(patches));
}

Interpolation Detail::makeInterpolation(const BaseMesh& mesh,
                                        const std::vector<Patch>& patches) const {
  return Interpolation(mesh, surface_ ? &*surface_ : nullptr, patches);
}

void Detail::setBase(BaseMesh base, std::vector<Patch> patches) {
  base_.emplace(std::move(base));
  patches_ = std::move(patches);
  samples_ = makeInterpolation().samples();
  warped_.resize(samples_[0].values.size());
  phases_.settled.clear();
  forgetSamples();
  needs_ = {};
  uniformPieces_ = 0;
  indices_.clear();
}

void Detail::pose() {
  if (surface_) surface_->setAttributes(given_);
  const std::vector<Attribute>* attributes = &given_;
  for (Cut& cut : cuts_) {
    cut.mesh.setAttributes(*attributes);
    division_.write(makeInterpolation(cut.mesh, cut.patches), cut.pieces, tessellations_);
    attributes = &division_.attributes;
  }
  base_->setAttributes(*attributes);
  samples_ = makeInterpolation().samples();
  phases_.settled.clear();
  forgetSamples();
  indices_.clear();
}

std::uint32_t Detail::sampleCount() const {
  return static_cast<std::uint32_t>(samples_[0].values.size() / 3);
}

void Detail::setPhases(std::vector<std::uint32_t> sizes, std::vector<float> steps,
                       std::vector<Front> fronts) {
  phases_ = {std::move(sizes), std::move(steps), std::move(fronts)};
}

std::uint32_t Detail::cutSampleCount() const {
  return phases_.fronts.empty() ? base_->sampleOfTriangle(0, 0) : sampleCount();
}

std::vector<float>& Detail::phases() {
  phases_.values.resize(std::size_t{phases_.stride()} * cutSampleCount());
  return phases_.values;
}

std::vector<std::uint32_t> Detail::piecesToCut(float maxLength) const {
  constexpr float maxPiece = 1.1f;
  std::vector<std::uint32_t> pieces;
  for (const float length : cutLengths(*base_, phases_, maxLength))
    pieces.push_back(length > maxPiece ? roundUp(length) : 1);
  const bool isCut = std::any_of(pieces.begin(), pieces.end(), [](auto each) { return each > 1; });
  return isCut ? pieces : std::vector<std::uint32_t>();
}

bool Detail::cut(float maxLength) {
  std::vector<std::uint32_t> pieces = piecesToCut(maxLength);
  if (pieces.empty()) {
    if (!phases_.fronts.empty()) phases_.settleFronts();
    return false;
  }
  division_.write(makeInterpolation(), pieces, tessellations_);
  std::vector<Patch> patches = dividePatches(makeInterpolation(), pieces, tessellations_);
  for (std::uint32_t& group : baseGroups_) group = division_.firstTriangles[group];
  cuts_.push_back({std::move(*base_), std::move(patches_), std::move(pieces),
                   division_.firstTriangles, division_.firstVertices});
  setBase(BaseMesh(division_.attributes, division_.triangles), std::move(patches));
  return true;
}

double Detail::countTriangles() {
  double count = 0;
  for (std::size_t t = 0; t < base_->triangles().size(); ++t)
    count += static_cast<double>(
        tessellations_.get(piecesOf(*base_, t, needs_.pieces())).triangles.size());
  return count;
}

// A uniform division of the given mesh is better where the surface bends about equally everywhere:
// it does without the cuts, which only serve to measure, and can have any number of pieces. It is
// chosen once it has fewer triangles, and given up once it has 1.2 times as many, so that the
// choice doesn't alternate.
std::uint32_t Detail::chooseUniform(double adaptiveTriangles) {
  constexpr float maxUniform = 256;
  // A surface that starts to move away from a flat one soon needs more pieces: its error, which is
  // inversely proportional to the square of their number, grows by several tenths in a frame.
  constexpr float spare = 0.5f;
  const float need = std::max(1.0f, std::sqrt(needs_.squaredUniform()) + spare);
  if (cuts_.empty() || need > maxUniform) return 0;
  const auto pieces =
      std::clamp(uniformPieces_, static_cast<std::uint32_t>(std::ceil(need)),
                 static_cast<std::uint32_t>(std::ceil(need * criterion.hysteresis)));
  const auto givenTriangles =
      static_cast<double>(makeInterpolationOfGiven().base().triangles().size());
  const double uniformTriangles = givenTriangles * pieces * pieces;
  const double advantage = uniformPieces_ != 0 ? 1.2 : 1;
  return uniformTriangles < advantage * adaptiveTriangles ? pieces : 0;
}

const std::vector<std::uint32_t>& Detail::show(bool listsSamples) {
  views_.clear();
  for (std::span<const float> views = viewNumbers_; !views.empty();
       views = views.subspan(numbersPerView))
    views_.push_back(readView(views));
  return visible_.add(*base_, warped_, views_, listsSamples);
}

bool Detail::update(float tolerance) {
  const std::span<const Patch> patches = cuts_.empty() ? std::span<const Patch>() : patches_;
  const std::span<const Corners> given =
      cuts_.empty() ? std::span<const Corners>() : cuts_[0].mesh.triangles();
  const WarpedMesh mesh{*base_, patches, warped_, phases_, given, visible_.triangles()};
  needs_.update(mesh, views_, tolerance);
  double triangles = countTriangles();
  // The error is inversely proportional to the number of triangles.
  for (int i = 0; i < 4 && triangles > maxDrawnTriangles; ++i, triangles = countTriangles())
    needs_.lower(static_cast<float>(1.1 * triangles / maxDrawnTriangles));
  const std::uint32_t uniform = chooseUniform(triangles);
  const bool isSame = uniform == uniformPieces_ && (uniform != 0 || !needs_.areChanged());
  if (isSame && !indices_.empty()) return false;
  uniformPieces_ = uniform;
  write();
  return true;
}

void Detail::divideBase() {
  if (uniformPieces_ == 0) return;
  uniformPieces_ = 0;
  write();
}

void Detail::write() {
  if (uniformPieces_ == 0) {
    pieces_.assign(needs_.pieces().begin(), needs_.pieces().end());
    division_.write(makeInterpolation(), pieces_, tessellations_, needs_.bentSides());
  } else {
    pieces_.assign(makeInterpolationOfGiven().base().edgeCount(), uniformPieces_);
    division_.write(makeInterpolationOfGiven(), pieces_, tessellations_);
  }
  indices_.clear();
  for (const Corners& corners : division_.triangles)
    indices_.insert(indices_.end(), corners.begin(), corners.end());
  groups_.clear();
  for (const std::uint32_t group : uniformPieces_ == 0 ? baseGroups_ : givenGroups_)
    groups_.push_back(division_.firstTriangles[group]);
}

std::span<const Detail::Cut> Detail::usedCuts() const {
  return uniformPieces_ == 0 ? std::span<const Cut>(cuts_) : std::span<const Cut>();
}

std::vector<std::uint32_t> Detail::origins() const {
  std::vector<std::uint32_t> origins(givenIndices_.size() / 3);
  std::iota(origins.begin(), origins.end(), 0);
  const auto follow = [&](const std::vector<std::uint32_t>& firstTriangles) {
    std::vector<std::uint32_t> next(firstTriangles.back());
    for (std::size_t t = 0; t < origins.size(); ++t)
      std::fill(next.begin() + firstTriangles[t], next.begin() + firstTriangles[t + 1], origins[t]);
    origins = std::move(next);
  };
  for (const Cut& cut : usedCuts()) follow(cut.firstTriangles);
  follow(division_.firstTriangles);
  return origins;
}

std::vector<std::uint32_t> Detail::lines(const std::vector<std::uint32_t>& ends) const {
  const BaseMesh& divided = uniformPieces_ == 0 ? *base_ : makeInterpolationOfGiven().base();
  std::vector<std::uint32_t> all;
  for (std::size_t i = 0; i < ends.size(); i += 2) {
    std::vector line{ends[i], ends[i + 1]};
    for (const Cut& cut : usedCuts()) divideLine(line, cut.mesh, cut.pieces, cut.firstVertices);
    divideLine(line, divided, pieces_, division_.firstVertices);
    all.push_back(static_cast<std::uint32_t>(line.size()));
    all.insert(all.end(), line.begin(), line.end());
  }
  return all;
}

}  // namespace warpjet

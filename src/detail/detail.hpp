// A mesh with as many triangles as its warped surface needs on the screen. It is cut where its
// samples would be too far apart to show how the surface bends, and divided anew when the camera or
// the surface change enough.
#pragma once

#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "detail/base_mesh.hpp"
#include "detail/division.hpp"
#include "detail/interpolation.hpp"
#include "detail/needs.hpp"
#include "detail/phase_samples.hpp"
#include "detail/pn_triangles.hpp"
#include "detail/tessellation.hpp"
#include "detail/visible_triangles.hpp"

namespace warpjet {

class Detail {
 public:
  // `groups` are the indices of the triangles at which groups begin, in ascending order. If
  // `isCurved` and the mesh has normals, its surface consists of PN triangles instead of flat ones.
  Detail(std::vector<Attribute> attributes, std::uint32_t triangles,
         std::vector<std::uint32_t> groups, bool isCurved = false);

  // The arrays of the mesh, to be filled before `begin`.
  std::vector<float>& given(std::size_t attribute) { return given_[attribute].values; }
  std::vector<std::uint32_t>& givenIndices() { return givenIndices_; }

  // Starts from the given mesh, uncut.
  void begin();
  // Reads the arrays of `given` again, whose numbers have changed. Keeps triangles and cuts.
  void pose();

  // The vertices of the cut mesh, and three samples for each side and each triangle.
  std::uint32_t sampleCount() const;
  std::span<const Attribute> samples() const { return samples_; }
  // The number of samples that `cut` compares. They come first: the vertices, then the samples of
  // sides, and those of triangles if there are fronts.
  std::uint32_t cutSampleCount() const;
  // Sets the numbers per sample of each phase, the distance that it may move between samples, and
  // the fronts.
  void setPhases(std::vector<std::uint32_t> sizes, std::vector<float> steps,
                 std::vector<Front> fronts = {});
  // The array for the phases at these samples, to be filled before `cut`.
  std::vector<float>& phases();
  // The array for warped positions of the samples.
  std::vector<float>& warped() { return warped_; }

  // Cuts sides that are longer than `maxLength`, along which a phase changes by more than its step,
  // or at a front. Returns true if it cut any, so that phases at new samples are needed; false if
  // none is too long, or if there would be too many triangles.
  bool cut(float maxLength);
  // Returns true if `cut` would cut the mesh.
  bool isCoarse(float maxLength) const { return !piecesToCut(maxLength).empty(); }

  // Forgets the warped positions, since the surface has changed.
  void forgetSamples() { visible_.clear(); }
  // The array for the numbers of the views, 19 each (see the bindings), to be filled before `show`.
  std::vector<float>& viewNumbers() { return viewNumbers_; }
  // Shows the views. The warped positions of the vertices must be known. If `listsSamples`, returns
  // the other samples that the views may show, and whose warped positions are not known yet.
  const std::vector<std::uint32_t>& show(bool listsSamples = true);
  // Returns what `show` returned last.
  const std::vector<std::uint32_t>& missingSamples() const { return visible_.samples(); }
  // Divides the mesh for the views. These samples must be warped, too. Returns true if the divided
  // mesh changed.
  bool update(float tolerance);
  // Tests whether the division will be within the tolerance if camera and surface change once more
  // as they did before the last update: see `Needs::piecesStayExact`.
  bool staysExact() const {
    return uniformPieces_ == 0 ? needs_.piecesStayExact()
                               : needs_.uniformStaysExact(uniformPieces_);
  }

  // The mesh after all cuts, and the numbers of pieces of its edges.
  const BaseMesh& base() const { return *base_; }
  std::span<const std::uint32_t> pieces() const { return needs_.pieces(); }
  bool isCurved() const { return surface_.has_value(); }
  // Divides the cut mesh into these pieces if the present division is a uniform one.
  void divideBase();

  // The divided mesh.
  const Division& division() const { return division_; }
  const std::vector<std::uint32_t>& indices() const { return indices_; }
  // The indices of the divided triangles at which groups begin.
  const std::vector<std::uint32_t>& groups() const { return groups_; }
  // For each divided triangle, the index of the given triangle that it is a part of.
  std::vector<std::uint32_t> origins() const;
  // The divided vertices along lines, each between two vertices of the given mesh: for each line
  // the number of its vertices, then the vertices. A line that is no side of a triangle is one
  // piece.
  std::vector<std::uint32_t> lines(const std::vector<std::uint32_t>& ends) const;

 private:
  // A mesh, and the numbers of pieces into which its edges were cut. The other arrays are as in
  // `Division`.
  struct Cut {
    BaseMesh mesh;
    std::vector<Patch> patches;
    std::vector<std::uint32_t> pieces, firstTriangles, firstVertices;
  };

  // Returns the numbers of pieces into which `cut` divides each edge; empty if it divides none.
  std::vector<std::uint32_t> piecesToCut(float maxLength) const;
  void setBase(BaseMesh base, std::vector<Patch> patches);
  Interpolation makeInterpolation(const BaseMesh& mesh, const std::vector<Patch>& patches) const;
  Interpolation makeInterpolation() const { return makeInterpolation(*base_, patches_); }
  // Interpolates in the given mesh, without cuts.
  Interpolation makeInterpolationOfGiven() const {
    return cuts_.empty() ? makeInterpolation() : makeInterpolation(cuts_[0].mesh, cuts_[0].patches);
  }
  // Returns the number of pieces per side of a uniform division of the given mesh, if that has
  // fewer triangles than a division by the needs of each edge; otherwise 0.
  std::uint32_t chooseUniform(double adaptiveTriangles);
  // Returns the number of triangles of a division by the needs of each edge.
  double countTriangles();
  void write();
  std::span<const Cut> usedCuts() const;

  std::vector<Attribute> given_;
  std::vector<std::uint32_t> givenIndices_, givenGroups_;
  std::vector<Cut> cuts_;  // in order
  bool isCurved_;
  std::optional<PnTriangles> surface_;  // present if it is curved
  std::optional<BaseMesh> base_;        // after all cuts
  std::vector<Patch> patches_;          // of the base
  std::vector<std::uint32_t> baseGroups_;
  std::vector<Attribute> samples_;
  PhaseSamples phases_;
  std::vector<float> warped_, viewNumbers_;
  std::vector<ScreenView> views_;
  VisibleTriangles visible_;
  Needs needs_;
  Tessellations tessellations_;
  std::uint32_t uniformPieces_ = 0;  // what `chooseUniform` returned
  // By edge of the mesh that is divided: of the given mesh if the division is uniform, otherwise of
  // the base.
  std::vector<std::uint32_t> pieces_;
  Division division_;
  std::vector<std::uint32_t> indices_, groups_;
};

}  // namespace warpjet

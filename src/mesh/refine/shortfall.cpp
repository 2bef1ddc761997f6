#include "mesh/refine/shortfall.hpp"

#include <array>
#include <cstdio>

#include "mesh/messages.hpp"

namespace warpjet {

namespace {

std::string describeNumber(float number) {
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), "%.3g", static_cast<double>(number));
  return text.data();
}

}  // namespace

std::vector<std::string> shortfallOf(const Refined& refined, const Refinement& refinement) {
  std::vector<std::string> messages;
  std::string shortfall;
  if (!refined.reachedTolerance)
    shortfall = "the warped surface is still up to " + describeNumber(refined.worst) +
                " away from them, above the tolerance of " + describeNumber(refinement.tolerance);
  if (!refined.reachedAngle)
    shortfall += (shortfall.empty() ? "" : ", and ") + std::string("its normals are still up to ") +
                 describeNumber(refined.worstAngle) + " radians off, above the angle of " +
                 describeNumber(refinement.angle);
  if (!shortfall.empty())
    messages.push_back(
        "With " + groupDigits(refined.mesh.triangleCount()) + " triangles " + shortfall + "; " +
        (refined.isFull
             ? "raise maxTriangles, which is " + groupDigits(refinement.maxTriangles) + '.'
             : "more would not help, as the warp creases or tears the surface there, or float32 "
               "is not fine enough."));
  if (!refined.isDefined)
    messages.push_back(
        "At some points the warp gives no finite position; nothing was split for them.");
  return messages;
}

}  // namespace warpjet

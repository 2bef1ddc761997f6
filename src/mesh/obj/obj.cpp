#include "mesh/obj/obj.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/files.hpp"
#include "mesh/obj/buckets.hpp"
#include "mesh/obj/obj_text.hpp"
#include "mesh/obj/polygon.hpp"
#include "mesh/sentences.hpp"
#include "mesh/surface/normals.hpp"

namespace warpjet {

namespace {

// What the faces' corners point at. Colours are as long as positions, or empty.
struct Lists {
  std::vector<float> positions, colors, uvs, normals;
};

// IEC 61966-2-1.
float linearOf(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

constexpr float noColor = std::numeric_limits<float>::quiet_NaN();

// Four linear numbers from 0 to 1 for each three of the file. Some programs write bytes, whole
// numbers to 255. A position without a colour is white.
std::vector<float> linearColors(const std::vector<float>& colors,
                                std::vector<std::string>& warnings) {
  const auto all = [&](auto isRight) {
    return std::all_of(colors.begin(), colors.end(),
                       [&](float part) { return std::isnan(part) || isRight(part); });
  };
  float most = 1;
  if (!all([](float part) { return part >= 0 && part <= 1; })) {
    if (all([](float part) { return part >= 0 && part <= 255 && part == std::floor(part); }))
      most = 255;
    warnings.push_back(most == 255
                           ? "The colours of the .obj are read as whole numbers from 0 to 255."
                           : "Colours of the .obj that lie outside 0 to 1 are clamped to it.");
  }
  std::vector<float> linear(colors.size() / 3 * 4, 1.0f);
  for (std::size_t i = 0; i < colors.size(); ++i)
    if (!std::isnan(colors[i]))
      linear[i / 3 * 4 + i % 3] = linearOf(std::clamp(colors[i] / most, 0.0f, 1.0f));
  return linear;
}

void readPosition(ObjLine& line, Lists& lists) {
  const auto numbers = line.numbers<6>();
  if (numbers.count < 3) line.fail("has a position of fewer than 3 numbers");
  lists.positions.insert(lists.positions.end(), numbers.values.begin(), numbers.values.begin() + 3);
  // A fourth number alone is a weight, which only curves have.
  const bool hasColor = numbers.count == 6;
  if (!hasColor && lists.colors.empty()) return;
  lists.colors.resize(lists.positions.size(), noColor);
  if (hasColor) std::copy_n(numbers.values.begin() + 3, 3, lists.colors.end() - 3);
}

void readUv(ObjLine& line, Lists& lists) {
  const auto numbers = line.numbers<2>();
  if (numbers.count < 1) line.fail("has a uv without numbers");
  lists.uvs.insert(lists.uvs.end(), {numbers.values[0], 1 - numbers.values[1]});
}

void readNormal(ObjLine& line, Lists& lists) {
  const auto numbers = line.numbers<3>();
  if (numbers.count < 3) line.fail("has a normal of fewer than 3 numbers");
  const auto [x, y, z] = numbers.values;
  // Files round normals to a few digits.
  const double length = std::hypot(double{x}, double{y}, double{z});
  for (const float number : {x, y, z})
    lists.normals.push_back(length > 0 ? static_cast<float>(number / length) : 0);
}

// Three corners a triangle.
void appendTriangles(const std::vector<ObjCorner>& face, const std::vector<float>& positions,
                     std::vector<ObjCorner>& corners) {
  std::vector<glm::dvec3> polygon;
  for (const ObjCorner& corner : face) {
    const float* p = &positions[std::size_t{corner.position} * 3];
    polygon.emplace_back(p[0], p[1], p[2]);
  }
  for (const auto& triangle : trianglesOfPolygon(polygon))
    for (const std::uint32_t i : triangle) corners.push_back(face[i]);
}

// Gives each combination that faces use its vertex.
class Corners {
 public:
  explicit Corners(std::size_t most) : buckets_(most) {}

  std::uint32_t vertexOf(const ObjCorner& corner) {
    const auto [position, uv, normal] = corner;
    const auto next = static_cast<std::uint32_t>(corners_.size());
    const std::uint64_t hash = mixed(std::uint64_t{position} << 32 | uv, normal);
    const std::uint32_t vertex = buckets_.findOrAdd(
        hash, next, [&](std::uint32_t other) { return corners_[other] == corner; });
    if (vertex == next) corners_.push_back(corner);
    return vertex;
  }

  const std::vector<ObjCorner>& all() const { return corners_; }

 private:
  Buckets buckets_;
  std::vector<ObjCorner> corners_;
};

// Appends `width` numbers of each corner's element of a list; zeros where the corner has none.
void gather(const std::vector<ObjCorner>& corners, std::uint32_t ObjCorner::*part,
            const std::vector<float>& list, std::size_t width, std::vector<float>& numbers) {
  if (list.empty()) return;
  numbers.resize(corners.size() * width);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t element = corners[i].*part;
    if (element != none)
      std::copy_n(list.begin() + element * width, width, numbers.begin() + i * width);
  }
}

}  // namespace

Mesh meshOfObj(std::string_view text, std::vector<std::string>& warnings) {
  Lists lists;
  std::vector<ObjCorner> faces;  // three corners a triangle
  std::vector<ObjCorner> face;
  bool usesMaterials = false, hasFlatFaces = false, hasLongFaces = false, hasAll = true;
  for (ObjLines lines(text); std::optional<ObjLine> line = lines.next();) {
    const std::string_view word = line->word();
    if (word == "v") readPosition(*line, lists);
    if (word == "vt") readUv(*line, lists);
    if (word == "vn") readNormal(*line, lists);
    usesMaterials |= word == "usemtl";
    if (word != "f") continue;
    hasAll &= line->corners(
        {lists.positions.size() / 3, lists.uvs.size() / 2, lists.normals.size() / 3}, face);
    hasFlatFaces |= face.size() < 3;
    hasLongFaces |= face.size() > mostCutCorners;
    appendTriangles(face, lists.positions, faces);
  }
  if (lists.positions.empty())
    throw FileProblem("this is no .glb, .gltf or .obj file; export the model as .glb.");
  if (faces.empty())
    throw FileProblem("there is nothing to draw: the .obj has no faces; export it with its faces.");
  if (usesMaterials) warnings.push_back("The materials of the .obj are ignored.");
  if (hasFlatFaces) warnings.push_back("Faces of fewer than three corners are left out.");
  if (hasLongFaces)
    warnings.push_back("Faces of more than " + grouped(mostCutCorners) +
                       " corners are taken for convex ones.");
  if (!hasAll) warnings.push_back("Faces name uvs or normals that are not there; they go without.");

  // As if each corner had a vertex of its own.
  constexpr std::size_t bytesPerCorner = 12 * sizeof(float) + sizeof(std::uint32_t);
  if (faces.size() > mostMeshBytes / bytesPerCorner)
    throw FileProblem("the model has " + grouped(faces.size() / 3) + " triangles, but at most " +
                      grouped(mostMeshBytes / bytesPerCorner / 3) +
                      " are read of an .obj; export it as .glb or with fewer triangles.");
  Mesh mesh;
  Corners corners(faces.size());
  mesh.indices.reserve(faces.size());
  for (const ObjCorner& corner : faces) mesh.indices.push_back(corners.vertexOf(corner));

  gather(corners.all(), &ObjCorner::position, lists.positions, 3, mesh.positions);
  gather(corners.all(), &ObjCorner::position, linearColors(lists.colors, warnings), 4, mesh.colors);
  gather(corners.all(), &ObjCorner::uv, lists.uvs, 2, mesh.uvs);
  gather(corners.all(), &ObjCorner::normal, lists.normals, 3, mesh.normals);
  std::vector<bool> hasNormal;
  for (const ObjCorner& corner : corners.all()) hasNormal.push_back(corner.normal != none);
  addMissingNormals(mesh, hasNormal);
  return mesh;
}

}  // namespace warpjet

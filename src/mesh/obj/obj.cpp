#include "mesh/obj/obj.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "mesh/files.hpp"
#include "mesh/messages.hpp"
#include "mesh/obj/colors.hpp"
#include "mesh/obj/corners.hpp"
#include "mesh/obj/polygon.hpp"
#include "mesh/obj/srgb.hpp"
#include "mesh/surface/normals.hpp"
#include "mesh/text/lines.hpp"

namespace warpjet {

namespace {

// The elements that corners of faces refer to. Colors are as long as positions, or empty. If an
// element has an invalid number, its first number is NaN.
struct Lists {
  std::vector<float> positions, colors, uvs, normals;
  std::string firstProblem;  // the message about the first such element
};

constexpr float noColor = std::numeric_limits<float>::quiet_NaN();

// Converts every three colors of the file to four linear numbers from 0 to 1. Some programs write
// bytes, integers up to 255. Positions without a color are white.
std::vector<float> linearColors(const std::vector<float>& colors,
                                std::vector<std::string>& warnings) {
  const auto all = [&](auto isValid) {
    return std::all_of(colors.begin(), colors.end(),
                       [&](float channel) { return std::isnan(channel) || isValid(channel); });
  };
  float maxChannel = 1;
  if (!all([](float channel) { return channel >= 0 && channel <= 1; })) {
    if (all([](float channel) {
          return channel >= 0 && channel <= 255 && channel == std::floor(channel);
        }))
      maxChannel = 255;
    warnings.push_back(maxChannel == 255
                           ? "The colours of the .obj are read as whole numbers from 0 to 255."
                           : "Colours of the .obj outside 0 to 1 are clamped.");
  }
  std::vector<float> linear(colors.size() / 3 * 4, 1.0f);
  for (std::size_t i = 0; i < colors.size(); ++i)
    if (!std::isnan(colors[i]))
      linear[i / 3 * 4 + i % 3] = linearOf(std::clamp(colors[i] / maxChannel, 0.0f, 1.0f));
  return linear;
}

// Sets the first number of a line to NaN if any of its numbers is invalid, and keeps the message
// about the first such line.
template <std::size_t maxCount>
void markInvalid(const TextLine& line, LineNumbers<maxCount>& numbers, Lists& lists) {
  if (numbers.isFinite) return;
  numbers.values[0] = std::numeric_limits<float>::quiet_NaN();
  if (lists.firstProblem.empty()) lists.firstProblem = line.problemOfNumber();
}

void readPosition(TextLine& line, Lists& lists) {
  auto numbers = line.parseNumbers<6>();
  if (numbers.count < 3) line.fail("has a position of fewer than 3 numbers");
  const auto& values = numbers.values;
  // A fourth number alone is a weight, which is only for curves.
  const auto areNumbers = [&](std::size_t first) {
    return std::none_of(&values[first], &values[first] + 3, [](float n) { return std::isnan(n); });
  };
  const bool hasColor = numbers.count == 6 && areNumbers(3);
  numbers.isFinite = areNumbers(0);
  markInvalid(line, numbers, lists);
  lists.positions.insert(lists.positions.end(), values.begin(), values.begin() + 3);
  if (!hasColor && lists.colors.empty()) return;
  lists.colors.resize(lists.positions.size(), noColor);
  if (hasColor) std::copy_n(values.begin() + 3, 3, lists.colors.end() - 3);
}

void readUv(TextLine& line, Lists& lists) {
  auto numbers = line.parseNumbers<2>();
  if (numbers.count < 1) line.fail("has a uv without numbers");
  markInvalid(line, numbers, lists);
  lists.uvs.insert(lists.uvs.end(), {numbers.values[0], 1 - numbers.values[1]});
}

void readNormal(TextLine& line, Lists& lists) {
  auto numbers = line.parseNumbers<3>();
  if (numbers.count < 3) line.fail("has a normal of fewer than 3 numbers");
  markInvalid(line, numbers, lists);
  const auto [x, y, z] = numbers.values;
  // Normalized, since files round normals to a few digits.
  const double length = std::hypot(double{x}, double{y}, double{z});
  for (const float number : {x, y, z})
    lists.normals.push_back(length == 0 ? 0 : static_cast<float>(number / length));
}

// Records which invalid elements were left out or replaced in a file whose numbers are mostly
// valid.
struct Losses {
  bool positions = false, uvs = false, normals = false;

  void warn(std::vector<std::string>& warnings) const {
    if (positions) warnings.push_back("Triangles with invalid positions are left out.");
    if (normals)
      warnings.push_back("The .obj has invalid normals, which were replaced by computed ones.");
    if (uvs) warnings.push_back("Invalid uvs of the .obj are set to 0.");
  }
};

// Removes invalid elements from the corners of a face; removes all corners of a face without valid
// positions.
void mend(std::vector<ObjCorner>& face, const Lists& lists, Losses& losses) {
  const auto isInvalid = [](const std::vector<float>& list, std::uint32_t place,
                            std::size_t width) {
    return place != none && std::isnan(list[place * width]);
  };
  bool hasPositions = true;
  for (ObjCorner& corner : face) {
    hasPositions &= !isInvalid(lists.positions, corner.position, 3);
    if (isInvalid(lists.normals, corner.normal, 3)) {
      corner.normal = none;
      losses.normals = true;
    }
    if (isInvalid(lists.uvs, corner.uv, 2)) {
      corner.uv = none;
      losses.uvs = true;
    }
  }
  if (hasPositions) return;
  face.clear();
  losses.positions = true;
}

// Appends the triangles of a face, three corners each.
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

// Appends `width` numbers of each corner's element of a list; zeros if the corner has none.
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

// Throws if the file has no face that can be drawn.
[[noreturn]] void failEmpty(const Lists& lists) {
  if (!lists.firstProblem.empty()) throw FileProblem(lists.firstProblem);
  if (lists.positions.empty())
    throw FileProblem("this is not a .glb, .gltf, .obj or .stl file; export the model as .glb.");
  throw FileProblem("there is nothing to draw: the .obj has no faces; export it with its faces.");
}

void checkSize(std::size_t corners) {
  // Assumes a separate vertex for each corner.
  constexpr std::size_t bytesPerCorner = 12 * sizeof(float) + sizeof(std::uint32_t);
  if (corners > maxMeshBytes / bytesPerCorner)
    throw FileProblem("the model has " + groupDigits(corners / 3) +
                      " triangles; the maximum for an .obj is " +
                      groupDigits(maxMeshBytes / bytesPerCorner / 3) +
                      "; export it as .glb or with fewer triangles.");
}

// Multiplies different material colors into the vertices; `painted` marks vertices that have one.
void writeColors(Mesh& mesh, const std::vector<ObjCorner>& corners, const ObjColors& colors) {
  if (!colors.hasColors()) return;
  if (!colors.isUniform()) mesh.colors.resize(corners.size() * 4, 1.0f);
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const std::uint32_t index = corners[i].color;
    mesh.painted.push_back(index != none);
    if (colors.isUniform() || index == none) continue;
    const std::array<float, 3>& color = colors.colorAt(index);
    for (std::size_t k = 0; k < 3; ++k) mesh.colors[i * 4 + k] *= color[k];
  }
}

}  // namespace

Mesh meshOfObj(std::string_view text, const Files& files, std::vector<std::string>& warnings) {
  Lists lists;
  ObjColors colors(text, files);
  Losses losses;
  std::vector<ObjCorner> faces;  // three corners per triangle
  std::vector<ObjCorner> face;
  bool hasFlatFaces = false, hasLongFaces = false, hasAll = true;
  for (TextLines lines(text, "obj"); std::optional<TextLine> line = lines.next();) {
    const std::string_view word = line->word();
    if (word == "v") readPosition(*line, lists);
    if (word == "vt") readUv(*line, lists);
    if (word == "vn") readNormal(*line, lists);
    if (word == "usemtl") colors.useMaterial(line->rest());
    if (word != "f") continue;
    hasAll &= readCorners(
        *line, {lists.positions.size() / 3, lists.uvs.size() / 2, lists.normals.size() / 3}, face);
    hasFlatFaces |= face.size() < 3;
    hasLongFaces |= face.size() > maxCutCorners;
    mend(face, lists, losses);
    if (face.size() < 3) continue;
    for (ObjCorner& corner : face) corner.color = colors.currentIndex();
    appendTriangles(face, lists.positions, faces);
  }
  if (faces.empty()) failEmpty(lists);
  colors.warn(warnings);
  if (hasFlatFaces) warnings.push_back("Faces of fewer than three corners are left out.");
  if (hasLongFaces)
    warnings.push_back("Faces of more than " + groupDigits(maxCutCorners) +
                       " corners are treated as convex.");
  if (!hasAll)
    warnings.push_back("Faces refer to uvs or normals that do not exist; these are ignored.");
  losses.warn(warnings);

  checkSize(faces.size());
  Mesh mesh;
  ObjVertices vertices(faces.size());
  mesh.indices.reserve(faces.size());
  for (ObjCorner& corner : faces) {
    if (colors.isUniform()) corner.color = colors.hasColors() ? 0 : none;
    mesh.indices.push_back(vertices.vertexOf(corner));
  }

  const std::vector<ObjCorner>& corners = vertices.all();
  gather(corners, &ObjCorner::position, lists.positions, 3, mesh.positions);
  gather(corners, &ObjCorner::position, linearColors(lists.colors, warnings), 4, mesh.colors);
  gather(corners, &ObjCorner::uv, lists.uvs, 2, mesh.uvs);
  gather(corners, &ObjCorner::normal, lists.normals, 3, mesh.normals);
  writeColors(mesh, corners, colors);
  mesh.material = colors.material(files, warnings);
  std::vector<bool> hasNormal;
  for (const ObjCorner& corner : corners) hasNormal.push_back(corner.normal != none);
  addMissingNormals(mesh, hasNormal);
  return mesh;
}

}  // namespace warpjet

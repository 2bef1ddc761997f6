// Loading skinned meshes from glTF files; expected numbers are computed by hand.
#include <gtest/gtest.h>

#include <cmath>

#include "load_support.hpp"

namespace warpjet {
namespace {

// Returns a file with a skin of two joints. Node 0 moves the mesh, which has no effect on a skin.
// The first joint is at x = 1, where it was bound. The second one, bound 2 above the first, is
// rotated by 90 degrees around z: x to y, y to -x.
GltfBuilder skinFile() {
  const auto moved = [](float x, float y) {
    return Floats{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, x, y, 0, 1};
  };
  Floats inverses = moved(-1, 0);
  const Floats second = moved(-1, -2);
  inverses.insert(inverses.end(), second.begin(), second.end());
  const double half = std::sqrt(0.5);
  GltfBuilder file;
  file.mesh(
      {{"POSITION", file.floats({0, 0, 0, 2, 2, 0, 2, 2, 3}, "VEC3")},
       {"NORMAL", file.floats({0, 0, 1, 1, 0, 0, 1, 0, 0}, "VEC3")},
       {"TANGENT", file.floats({1, 0, 0, 1, 0, 0, 1, -1, 0, 1, 0, 1}, "VEC4")},
       {"JOINTS_0", file.accessor<std::uint8_t>({0, 0, 0, 0, 0, 1, 0, 0, 1, 0, 9, 0}, "VEC4")},
       {"WEIGHTS_0", file.floats({1, 0, 0, 0, 0, 1, 0, 0, 0.5f, 0.5f, 0, 0}, "VEC4")}});
  file.node({{"mesh", 0}, {"skin", 0}, {"translation", {100, 0, 0}}, {"scale", {-1, 1, 1}}});
  file.node({{"translation", {1, 0, 0}}, {"children", {2}}});
  file.node({{"translation", {0, 2, 0}}, {"rotation", {0, 0, half, half}}});
  const int matrices = file.accessor<float>(inverses, "VEC4", {{"type", "MAT4"}, {"count", 2}});
  file.tree["skins"] = {{{"joints", {1, 2}}, {"inverseBindMatrices", matrices}}};
  return file;
}

TEST(LoadMesh, PosesSkinsByTheirJoints) {
  const Mesh mesh = loadValid(skinFile().glb());
  // The last vertex follows both joints: half of (2, 2, 3), its original position, and half of (1,
  // 3, 3).
  expectNear(mesh.positions, {0, 0, 0, 1, 3, 0, 1.5f, 2.5f, 3});
  const float half = std::sqrt(0.5f);
  expectNear(mesh.normals, {0, 0, 1, 0, 1, 0, half, half, 0});
  expectNear(mesh.tangents, {1, 0, 0, 1, 0, 0, 1, -1, -half, half, 0, 1});
  EXPECT_TRUE(mesh.indices.empty());
  EXPECT_TRUE(warningsOf(skinFile().glb()).empty());
}

TEST(LoadMesh, PosesSkinsOfUnusualFiles) {
  GltfBuilder unbound = skinFile();
  unbound.tree["skins"][0].erase("inverseBindMatrices");
  // Joints without matrices are bound at the origin. So the second one rotates (2, 2, 0) and then
  // adds (1, 2, 0); the last vertex is half of that, with z = 3, and half of (3, 2, 3).
  expectNear(loadValid(unbound.glb()).positions, {1, 0, 0, -1, 4, 0, 1, 3, 3});

  GltfBuilder mirrored = skinFile();
  mirrored.tree["nodes"][1]["scale"] = {1, 1, -1};
  EXPECT_EQ(loadValid(mirrored.glb()).indices, (Indices{0, 2, 1}));
  expectNear(loadValid(mirrored.glb()).positions, {0, 0, 0, 1, 3, 0, 1.5f, 2.5f, -3});
  expectNear(loadValid(mirrored.glb()).normals,
             {0, 0, -1, 0, 1, 0, std::sqrt(0.5f), std::sqrt(0.5f), 0});

  GltfBuilder scenes = skinFile();  // another scene shows its joints
  scenes.tree["scenes"] = {{{"nodes", {0}}}, {{"nodes", {1}}}};
  EXPECT_EQ(loadValid(scenes.glb()).positions, loadValid(skinFile().glb()).positions);

  GltfBuilder boneless = skinFile();
  boneless.tree["meshes"][0]["primitives"][0]["attributes"].erase("WEIGHTS_0");
  expectNear(loadValid(boneless.glb()).positions, {100, 0, 0, 98, 2, 0, 98, 2, 3});

  GltfBuilder heavy = skinFile();
  heavy.tree["meshes"][0]["primitives"][0]["attributes"]["WEIGHTS_0"] =
      heavy.floats({0, 0, 0, 0, 0, 7, 0, 0, 3, 3, 0, 0}, "VEC4");
  expectNear(loadValid(heavy.glb()).positions, {0, 0, 0, 1, 3, 0, 1.5f, 2.5f, 3});

  GltfBuilder many = skinFile();
  many.tree["meshes"][0]["primitives"][0]["attributes"]["JOINTS_1"] = 3;
  EXPECT_EQ(warningsOf(many.glb()),
            std::vector<std::string>{
                "Vertices that follow more than four bones follow only the first four."});
}

TEST(LoadMesh, RejectsInconsistentSkins) {
  const auto problemWith = [](auto change) {
    GltfBuilder file = skinFile();
    change(file.tree);
    return loadMesh(file.glb()).problem;
  };
  const auto contains = [](const std::string& problem, const char* part) {
    EXPECT_NE(problem.find(part), std::string::npos) << problem;
  };
  contains(problemWith([](json& t) { t["skins"][0]["joints"] = {1}; }),
           "a vertex follows a joint that its skin, of 1, does not have");
  contains(problemWith([](json& t) { t["skins"][0]["joints"] = {1, 7}; }), "node 7");
  contains(problemWith([](json& t) {
             t["skins"][0]["joints"] = {1, 2, 2};
           }),
           "3 joints, but 2 inverse bind matrices");
  contains(problemWith([](json& t) { t["skins"][0]["inverseBindMatrices"] = 0; }),
           "4 by 4 matrices");
  contains(problemWith([](json& t) { t["accessors"][5]["count"] = 9; }), "reads up to byte 576");
  contains(problemWith([](json& t) { t["nodes"][0]["skin"] = 3; }), "skin 3");
  contains(problemWith([](json& t) { t["skins"][0].erase("joints"); }), "joints is missing");
  contains(problemWith([](json& t) { t["nodes"][2]["children"] = {1}; }), "");
  contains(problemWith([](json& t) {
             const std::vector<int> all(1000000, 1);
             t["skins"] = {{{"joints", all}}, {{"joints", all}}};
           }),
           "more than 1,048,576 joints");
}

}  // namespace
}  // namespace warpjet

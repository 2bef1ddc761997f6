// Writes mesh files, one for each way in which glTF, OBJ and STL can store a few triangles.
#include "cpp/gltf_builder.hpp"
#include "fuzz/seeds.hpp"

namespace warpjet {

namespace {

void write(const std::string& name, const File& bytes) { writeSeed("mesh", name, bytes); }

// Two triangles.
const std::vector<float> square{0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
const std::vector<float> upwards{0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1};
const std::vector<std::uint16_t> corners{0, 1, 2, 0, 2, 3};

const File png{0x89, 'P', 'N', 'G', '\r', '\n', 0x1A, '\n', 0, 0, 0, 13};

GltfBuilder squareFile(const json& primitiveMembers = {}) {
  GltfBuilder file;
  const int positions = file.floats(square, "VEC3");
  json primitive = {{"indices", file.accessor(corners, "SCALAR")}};
  if (primitiveMembers.is_object()) primitive.update(primitiveMembers);
  file.mesh({{"POSITION", positions}}, primitive);
  file.node({{"mesh", 0}});
  return file;
}

json& attributesOf(GltfBuilder& file) {
  return file.tree["meshes"][0]["primitives"][0]["attributes"];
}

GltfBuilder allAttributes() {
  GltfBuilder file = squareFile();
  attributesOf(file)["NORMAL"] = file.floats(upwards, "VEC3");
  attributesOf(file)["TANGENT"] =
      file.floats({1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, 1, 1, 0, 0, -1}, "VEC4");
  attributesOf(file)["TEXCOORD_0"] = file.floats({0, 0, 1, 0, 1, 1, 0, 1}, "VEC2");
  attributesOf(file)["COLOR_0"] = file.accessor<std::uint8_t>(
      {255, 0, 0, 0, 255, 0, 0, 0, 255, 9, 9, 9}, "VEC3", {{"normalized", true}});
  return file;
}

GltfBuilder textured() {
  GltfBuilder file = allAttributes();
  file.tree["images"] = {{{"bufferView", file.view(png)}, {"mimeType", "image/png"}}};
  file.tree["textures"] = {{{"source", 0}}};
  file.tree["materials"] = {{{"pbrMetallicRoughness",
                              {{"baseColorTexture", {{"index", 0}, {"texCoord", 0}}},
                               {"baseColorFactor", {1, 0.5, 0, 1}}}}}};
  file.tree["meshes"][0]["primitives"][0]["material"] = 0;
  return file;
}

GltfBuilder quantized() {
  GltfBuilder file;
  file.tree["extensionsUsed"] = file.tree["extensionsRequired"] = {"KHR_mesh_quantization"};
  const int positions = file.accessor<std::int16_t>({0, 0, 0, 32767, 0, 0, 0, 32767, 0}, "VEC3",
                                                    {{"normalized", true}});
  const int normals =
      file.accessor<std::int8_t>({0, 0, 127, 0, 0, 127, 0, 0, 127}, "VEC3", {{"normalized", true}});
  file.mesh({{"POSITION", positions}, {"NORMAL", normals}});
  file.node({{"mesh", 0}, {"scale", {3, -1, 2}}});
  return file;
}

GltfBuilder sparse() {
  GltfBuilder file = squareFile();
  file.tree["accessors"][0]["sparse"] = {
      {"count", 2},
      {"indices", {{"bufferView", file.view<std::uint8_t>({1, 3})}, {"componentType", 5121}}},
      {"values", {{"bufferView", file.view<float>({7, 8, 9, 1, 2, 3})}}}};
  return file;
}

json sparseReplacement(int indices, int componentType, int values) {
  return {{"count", 1},
          {"indices", {{"bufferView", indices}, {"componentType", componentType}}},
          {"values", {{"bufferView", values}}}};
}

// Makes accessors with sparse replacements, whose numbers have type T and whose indices type Index.
template <typename T, typename Index>
GltfBuilder sparseOf() {
  GltfBuilder file;
  file.tree["extensionsUsed"] = file.tree["extensionsRequired"] = {"KHR_mesh_quantization"};
  const int vertexIndex = file.view<Index>({2}), values = file.view<T>({1, 2, 3, 0});
  const int position = file.view<Index>({1});
  const int positions = file.accessor<T>(
      {0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0}, "VEC3",
      {{"count", 3}, {"sparse", sparseReplacement(vertexIndex, componentTypeOf<Index>(), values)}});
  file.tree["bufferViews"].back()["byteStride"] = 4 * sizeof(T);
  const int corner = file.view<Index>({1});
  const int indices = file.accessor<Index>(
      {0, 0, 2}, "SCALAR",
      {{"sparse", sparseReplacement(position, componentTypeOf<Index>(), corner)}});
  const int uvs =
      file.accessor<std::uint16_t>({0, 0, 65535, 0, 0, 65535}, "VEC2", {{"normalized", true}});
  file.mesh({{"POSITION", positions}, {"TEXCOORD_0", uvs}}, {{"indices", indices}});
  file.node({{"mesh", 0}});
  file.tree["accessors"][0]["normalized"] = sizeof(T) == 1;
  return file;
}

GltfBuilder interleaved() {
  GltfBuilder file;
  file.accessor<float>({0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1}, "VEC3",
                       {{"count", 3}});
  file.tree["bufferViews"][0]["byteStride"] = 24;
  file.add("accessors", {{"bufferView", 0},
                         {"byteOffset", 12},
                         {"componentType", 5126},
                         {"count", 3},
                         {"type", "VEC3"}});
  file.mesh({{"POSITION", 0}, {"NORMAL", 1}});
  file.node({{"mesh", 0}});
  return file;
}

GltfBuilder scene() {
  GltfBuilder file = squareFile();
  file.tree["nodes"] = {
      {{"children", {1, 2}}, {"translation", {1, 2, 3}}},
      {{"mesh", 0}, {"rotation", {0, 0, 0.7071068, 0.7071068}}},
      {{"mesh", 0}, {"matrix", {1, 0, 0, 0, 0, -1, 0, 0, 0, 0, 1, 0, 5, 6, 7, 1}}}};
  file.tree["scenes"] = {{{"nodes", {0}}}};
  file.tree["scene"] = 0;
  return file;
}

GltfBuilder twoMaterials() {
  GltfBuilder file = squareFile({{"material", 0}});
  file.mesh({{"POSITION", file.floats(triangle, "VEC3")}}, {{"material", 1}});
  file.node({{"mesh", 1}});
  file.tree["materials"] = {{{"pbrMetallicRoughness", {{"baseColorFactor", {1, 0, 0, 1}}}}},
                            {{"pbrMetallicRoughness", {{"baseColorFactor", {0, 1, 0, 1}}}}}};
  return file;
}

GltfBuilder skinned() {
  GltfBuilder file = squareFile();
  auto& attributes = file.tree["meshes"][0]["primitives"][0]["attributes"];
  attributes["JOINTS_0"] = file.accessor(std::vector<std::uint8_t>(16), "VEC4");
  attributes["WEIGHTS_0"] = file.floats(std::vector<float>(16, 0.25f), "VEC4");
  const std::vector<float> identity{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};
  const int matrices = file.accessor(identity, "VEC4", {{"type", "MAT4"}, {"count", 1}});
  file.tree["skins"] = {{{"joints", {0}}, {"inverseBindMatrices", matrices}}};
  file.tree["nodes"][0]["skin"] = 0;
  return file;
}

GltfBuilder ignored() {
  GltfBuilder file = squareFile();
  file.tree["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", 0}}};
  file.tree["animations"] = {{{"channels", json::array()}, {"samplers", json::array()}}};
  file.tree["extensionsUsed"] = {"KHR_materials_unlit"};
  return file;
}

GltfBuilder morphed() {
  GltfBuilder file = squareFile();
  const int place = file.view<std::uint8_t>({2}), value = file.view<float>({0, 0, 2});
  const int target = file.add(
      "accessors", {{"componentType", 5126},
                    {"count", 4},
                    {"type", "VEC3"},
                    {"sparse", sparseReplacement(place, componentTypeOf<std::uint8_t>(), value)}});
  file.tree["meshes"][0]["primitives"][0]["targets"] = {{{"POSITION", target}}};
  file.tree["meshes"][0]["weights"] = {0.5};
  file.tree["nodes"][0]["weights"] = {-1};
  return file;
}

GltfBuilder instanced() {
  GltfBuilder file = squareFile();
  const json attributes{{"TRANSLATION", file.floats({0, 0, 0, 3, 0, 0}, "VEC3")},
                        {"ROTATION", file.accessor<std::int8_t>({0, 0, 0, 127, 90, 0, 0, 90},
                                                                "VEC4", {{"normalized", true}})},
                        {"SCALE", file.floats({1, 1, 1, -1, 2, 1}, "VEC3")}};
  auto& extensions = file.tree["nodes"][0]["extensions"];
  extensions["EXT_mesh_gpu_instancing"]["attributes"] = attributes;
  extensions["KHR_node_visibility"]["visible"] = true;
  file.node({{"mesh", 0}, {"extensions", {{"KHR_node_visibility", {{"visible", false}}}}}});
  return file;
}

GltfBuilder glossy() {
  GltfBuilder file = textured();
  file.tree["materials"][0]["extensions"]["KHR_materials_pbrSpecularGlossiness"] = {
      {"diffuseFactor", {1, 0, 0, 1}}, {"diffuseTexture", {{"index", 0}}}};
  file.tree["textures"][0] = {{"extensions", {{"EXT_texture_webp", {{"source", 0}}}}}};
  return file;
}

// A view of floats, declared as compressed.
GltfBuilder meshopt(const char* extension, const char* filter) {
  GltfBuilder file = squareFile();
  file.tree["bufferViews"][0]["extensions"][extension] = {
      {"buffer", 0}, {"byteLength", 48},     {"byteStride", 12},
      {"count", 4},  {"mode", "ATTRIBUTES"}, {"filter", filter}};
  file.tree["bufferViews"][0]["buffer"] = 1;
  file.tree["buffers"] = {
      {{"byteLength", file.binary.size()}},
      {{"byteLength", 48}, {"extensions", {{extension, {{"fallback", true}}}}}}};
  return file;
}

GltfBuilder draco() {
  GltfBuilder file;
  const int view = file.view<std::uint8_t>({3, 0, 128, 63});
  file.add("accessors", {{"componentType", 5126}, {"count", 3}, {"type", "VEC3"}});
  file.mesh({{"POSITION", 0}}, {{"extensions",
                                 {{"KHR_draco_mesh_compression",
                                   {{"bufferView", view}, {"attributes", {{"POSITION", 0}}}}}}}});
  file.node({{"mesh", 0}});
  return file;
}

File binaryStl(const std::string& header) {
  File file = bytesOf(header);
  file.resize(80);
  append32(file, 1);
  for (const std::uint32_t bits :
       {0u, 0u, 0x3F800000u, 0u, 0u, 0u, 0x3F800000u, 0u, 0u, 0u, 0x3F800000u, 0u})
    append32(file, bits);
  file.resize(file.size() + 2);
  return file;
}

// Joins a file and its external files in the format of split_files.hpp.
File joinFiles(const std::vector<File>& externals, const File& file) {
  File all{static_cast<std::uint8_t>(externals.size())};
  for (const File& external : externals) {
    all.push_back(static_cast<std::uint8_t>(external.size()));
    all.push_back(static_cast<std::uint8_t>(external.size() >> 8));
    all.insert(all.end(), external.begin(), external.end());
  }
  all.insert(all.end(), file.begin(), file.end());
  return all;
}

}  // namespace

void writeMeshSeeds() {
  write("triangle.glb", triangleFile().glb());
  write("square.glb", squareFile().glb());
  write("strip.glb", squareFile({{"mode", 5}}).glb());
  write("fan.glb", squareFile({{"mode", 6}}).glb());
  write("lines.glb", squareFile({{"mode", 1}}).glb());
  write("attributes.glb", allAttributes().glb());
  write("textured.glb", textured().glb());
  write("quantized.glb", quantized().glb());
  write("sparse.glb", sparse().glb());
  write("sparse-byte.glb", sparseOf<std::int8_t, std::uint8_t>().glb());
  write("sparse-unsigned-byte.glb", sparseOf<std::uint8_t, std::uint16_t>().glb());
  write("sparse-short.glb", sparseOf<std::int16_t, std::uint32_t>().glb());
  write("sparse-unsigned-short.glb", sparseOf<std::uint16_t, std::uint8_t>().glb());
  write("interleaved.glb", interleaved().glb());
  write("scene.glb", scene().glb());
  write("materials.glb", twoMaterials().glb());
  write("skinned.glb", skinned().glb());
  write("ignored.glb", ignored().glb());
  write("embedded.gltf", allAttributes().embedded());
  GltfBuilder pictured = textured();
  pictured.tree["images"] = {{{"uri", "a%20picture.png"}}};
  write("external", joinFiles({pictured.binary, png}, pictured.external("a.bin")));
  write("missing.gltf", squareFile().external("a.bin"));

  write("morphed.glb", morphed().glb());
  write("instanced.glb", instanced().glb());
  write("glossy.glb", glossy().glb());
  write("meshopt.glb", meshopt("EXT_meshopt_compression", "NONE").glb());
  write("meshopt-exponential.glb", meshopt("KHR_meshopt_compression", "EXPONENTIAL").glb());
  write("draco.glb", draco().glb());

  write("text.stl", bytesOf("solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\n"
                            "vertex 0 1 0\nendloop\nendfacet\nendsolid a\n"));
  write("binary.stl", binaryStl("a"));
  write("solid.stl", binaryStl("solid a"));
  const File materials = bytesOf("newmtl red\nKd 1 0 0\nmap_Kd -s 1 1 1 a.png\nnewmtl b\nKd 0.5\n");
  write("materials",
        joinFiles({materials, png},
                  bytesOf("\xEF\xBB\xBFmtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nvn nan 0 0\n"
                          "usemtl red\nf 1//1 2//1 3//1\nusemtl b\nf 1 3 2\n")));
  File wide{0xFF, 0xFE};
  for (const char c : std::string("v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"))
    wide.insert(wide.end(), {static_cast<std::uint8_t>(c), 0});
  write("utf-16.obj", wide);
  write("square.obj", bytesOf("v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nf 1 2 3 4\n"));
  write("full.obj", bytesOf("# a comment\nmtllib a.mtl\no thing\nv 0 0 0\nv 1 0 0\nv 0 1 0.5e-1\n"
                            "vt 0 0\nvt 1 0\nvt 0 1\nvn 0 0 1\ng part\nusemtl red\ns 1\n"
                            "f 1/1/1 2/2/1 3/3/1\nf -3//-1 -2//-1 \\\n -1//-1\nf 1/1 2/2 3/3\n"));
  write("colours.obj", bytesOf("v 0 0 0 1 0 0\r\nv 1 0 0 0 1 0\r\nv 0 1 0 0 0 1\r\nf 1 2 3\r\n"));
}

}  // namespace warpjet

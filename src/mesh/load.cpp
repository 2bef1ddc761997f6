#include "mesh/load.hpp"

#include <exception>
#include <new>
#include <set>
#include <stdexcept>

#include "mesh/check.hpp"
#include "mesh/container.hpp"
#include "mesh/gltf.hpp"
#include "mesh/look.hpp"
#include "mesh/merge.hpp"
#include "mesh/obj.hpp"
#include "mesh/sentences.hpp"
#include "mesh/uri.hpp"

namespace warpjet {

namespace {

Chunks chunksOf(Bytes bytes, Format format) {
  return format == Format::Glb ? chunksOfGlb(bytes) : Chunks{textOf(bytes), std::nullopt};
}

Mesh read(Bytes bytes, const Files& files, std::vector<std::string>& warnings) {
  const Format format = formatOf(bytes);
  if (format == Format::Obj) return meshOfObj(textOf(bytes), warnings);
  const Chunks chunks = chunksOf(bytes, format);
  Gltf gltf = describedGltf(chunks.json);
  findBuffers(gltf, chunks.binary, files);
  Mesh mesh = mergedMesh(gltf, files);
  warnings = gltf.warnings;
  return mesh;
}

}  // namespace

Loaded loadMesh(Bytes bytes, const Files& files) {
  Loaded loaded;
  try {
    Mesh mesh = read(bytes, files, loaded.warnings);
    if (const std::string problem = problemOf(mesh); !problem.empty())
      throw FileProblem("export the model again, for its " + problem);
    loaded.mesh = std::move(mesh);
  } catch (const FileProblem& problem) {
    loaded.problem = problem.what();
  } catch (const std::bad_alloc&) {
    loaded.problem = "there is not enough memory for this model; export it with fewer triangles.";
  } catch (const std::length_error&) {
    loaded.problem = "the model says that it is larger than any memory; export it again.";
  } catch (const std::exception& error) {
    loaded.problem =
        "the file cannot be read (" + quotedText(error.what()) + "); export the model again.";
  }
  if (!loaded.mesh) {
    loaded.problem = "loadMesh: " + loaded.problem;
    loaded.warnings.clear();
  }
  return loaded;
}

std::vector<std::string> externalFiles(Bytes bytes) {
  try {
    const Format format = formatOf(bytes);
    if (format == Format::Obj) return {};
    const Gltf gltf = describedGltf(chunksOf(bytes, format).json);
    std::vector<std::string> uris;
    std::set<std::string> known;
    const auto add = [&](const std::string& uri) {
      if (!uri.empty() && !isDataUri(uri) && known.insert(uri).second) uris.push_back(uri);
    };
    for (const Buffer& buffer : gltf.buffers) add(buffer.uri);
    for (const std::string& uri : picturesOf(gltf)) add(uri);
    return uris;
  } catch (const std::exception&) {
    return {};
  }
}

}  // namespace warpjet

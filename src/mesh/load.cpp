#include "mesh/load.hpp"

#include <exception>
#include <new>
#include <set>
#include <stdexcept>
#include <utility>

#include "mesh/check.hpp"
#include "mesh/format.hpp"
#include "mesh/gltf/container.hpp"
#include "mesh/gltf/gltf.hpp"
#include "mesh/gltf/look.hpp"
#include "mesh/gltf/merge.hpp"
#include "mesh/gltf/packed.hpp"
#include "mesh/messages.hpp"
#include "mesh/obj/colors.hpp"
#include "mesh/obj/obj.hpp"
#include "mesh/stl/stl.hpp"
#include "mesh/text/encoding.hpp"
#include "mesh/uri.hpp"

namespace warpjet {

struct ModelFile::Description {
  Gltf gltf;
  std::optional<Bytes> binary;
  bool hasBuffers = false;
  std::vector<PackedPart> parts;
};

ModelFile::ModelFile(Bytes bytes) : bytes_(bytes) {
  if (hasStlSize(bytes)) return;
  if (std::optional<std::string> text = utf8OfUtf16(bytes)) {
    converted_ = std::move(*text);
    bytes_ = {reinterpret_cast<const std::uint8_t*>(converted_.data()), converted_.size()};
  }
}
ModelFile::~ModelFile() = default;

ModelFile::Description& ModelFile::description() {
  if (!description_) {
    const bool isGlb = formatOf(bytes_) == Format::Glb;
    const Chunks chunks = isGlb ? chunksOfGlb(bytes_) : Chunks{textOf(bytes_), std::nullopt};
    description_ = std::make_unique<Description>(
        Description{parseDescription(chunks.json), chunks.binary, false, {}});
  }
  return *description_;
}

ModelFile::Description& ModelFile::descriptionWithBuffers(const Files& files) {
  Description& ready = description();
  if (!std::exchange(ready.hasBuffers, true)) {
    findBuffers(ready.gltf, ready.binary, files);
    ready.parts = findPacked(ready.gltf);
  }
  return ready;
}

std::vector<PackedPart> ModelFile::packedParts(const Files& files) {
  const Format format = formatOf(bytes_);
  if (format != Format::Glb && format != Format::Gltf) return {};
  return descriptionWithBuffers(files).parts;
}

void ModelFile::unpack(std::size_t part, Pieces pieces) {
  warpjet::unpack(description().gltf, part, std::move(pieces));
}

Mesh ModelFile::read(const Files& files, std::vector<std::string>& warnings) {
  switch (formatOf(bytes_)) {
    case Format::Obj:
      return meshOfObj(textOf(bytes_), files, warnings);
    case Format::TextStl:
      return meshOfTextStl(textOf(bytes_), warnings);
    case Format::BinaryStl:
      return meshOfBinaryStl(bytes_, warnings);
    default:
      break;
  }
  Gltf& gltf = descriptionWithBuffers(files).gltf;
  rejectPacked(gltf);
  Mesh mesh = mergeDraws(gltf, files);
  warnings = gltf.warnings;
  return mesh;
}

Loaded ModelFile::load(const Files& files) {
  Loaded loaded;
  try {
    Mesh mesh = read(files, loaded.warnings);
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
        "the file cannot be read (" + quoteText(error.what()) + "); export the model again.";
  }
  if (!loaded.mesh) {
    loaded.problem = "loadMesh: " + loaded.problem;
    loaded.warnings.clear();
  }
  return loaded;
}

std::vector<std::string> ModelFile::externalFiles(const Files& files) {
  try {
    const Format format = formatOf(bytes_);
    if (format == Format::Obj) return filesOfObj(textOf(bytes_), files);
    if (format == Format::TextStl || format == Format::BinaryStl) return {};
    const Gltf& gltf = description().gltf;
    std::vector<std::string> uris;
    std::set<std::string> known;
    const auto add = [&](const std::string& uri) {
      if (!uri.empty() && !isDataUri(uri) && known.insert(uri).second) uris.push_back(uri);
    };
    for (const Buffer& buffer : gltf.buffers) add(buffer.uri);
    for (const std::string& uri : imageUris(gltf)) add(uri);
    return uris;
  } catch (const std::exception&) {
    return {};
  }
}

Loaded loadMesh(Bytes bytes, const Files& files) { return ModelFile(bytes).load(files); }

std::vector<std::string> externalFiles(Bytes bytes, const Files& files) {
  return ModelFile(bytes).externalFiles(files);
}

}  // namespace warpjet

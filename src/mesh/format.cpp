#include "mesh/format.hpp"

#include <algorithm>
#include <string_view>

#include "mesh/messages.hpp"
#include "mesh/stl/stl.hpp"
#include "mesh/text/encoding.hpp"

namespace warpjet {

Format formatOf(Bytes bytes) {
  std::string_view text = textOf(bytes);
  if (text.empty()) throw FileProblem("the file is empty; export or download it again.");
  if (text.starts_with("glTF")) return Format::Glb;
  if (isBinaryStl(bytes)) return Format::BinaryStl;
  while (text.starts_with(utf8Mark)) text.remove_prefix(utf8Mark.size());
  text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n"), text.size()));
  if (text.starts_with('{')) return Format::Gltf;
  if (text.starts_with('<'))
    throw FileProblem(
        "this is a web page or XML, not a .glb, .gltf, .obj or .stl file; check the address of the "
        "model.");
  if (text.find('\0') != text.npos)
    throw FileProblem("this is not a .glb, .gltf, .obj or .stl file; export the model as .glb.");
  return isTextStl(text) ? Format::TextStl : Format::Obj;
}

}  // namespace warpjet

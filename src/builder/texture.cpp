// Calls of images.
#include "texture/texture.hpp"

#include "builder/builder.hpp"
#include "builder/sentences.hpp"
#include "emit/names.hpp"

namespace warpjet {

int Builder::callTexture(std::string_view image, const Sampling& sampling) {
  constexpr std::string_view name = "texture";
  const Value uv = operands_[0];
  const auto refused = [&](Parts parts) { return finish(refuse(name, parts), 0, name); };
  if (uv.shape() != vectorOf(2))
    return refused({"argument 2 must be a vec2, but is ", shapeName(uv.shape()), "."});
  if (const std::string why = outputProblem(dialect_, image); !why.empty())
    return refused({quotedShort(image), " cannot name an image: ", why, "."});
  if (input(name, image, oneImage) == failed) return failed;

  Numbers arguments{uv[0], uv[1]};
  const NodeId node = graph_.component(graph_.input(image, oneImage), 0);
  arguments.push_back({&graph_, node});
  // Only WebGL 1 cannot ask an image for its size.
  const bool takesSize = dialect_.language == ops::Language::Glsl100;
  if (takesSize) {
    const int handle = input(name, std::string(image) + "Size", vectorOf(2));
    if (handle == failed) return failed;
    const Value size = values_.get(graph_, handle);
    arguments.insert(arguments.end(), {size[0], size[1]});
  }
  const std::size_t before = graph_.size();
  const Numbers values = library_.call(definitionOf(sampling, takesSize), arguments);
  return finish(fill(graph_, vectorOf(static_cast<int>(values.size())),
                     [&](int i) { return values[i]; }),
                before, name);
}

}  // namespace warpjet

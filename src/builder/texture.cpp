// Calls of images.
#include "texture/texture.hpp"

#include "builder/builder.hpp"

namespace warpjet {

int Builder::callTexture(const Sampling& sampling) {
  const std::size_t before = graph_.size();
  const Value size = operands_[2], place = operands_[0] * size - constantLike(size, 0.5);
  const Numbers arguments{place[0], place[1], operands_[1][0], size[0], size[1]};
  const Numbers values = library_.call(definitionOf(sampling), arguments);
  return finish(fill(graph_, vectorOf(4), [&](int i) { return values[i]; }), before, "texture");
}

}  // namespace warpjet

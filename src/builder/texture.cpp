// Samples images at a vec2; host settings of the image, if any, are passed as a vec3. Also reads
// their sizes.
#include "texture/texture.hpp"

#include <utility>

#include "builder/builder.hpp"

namespace warpjet {

// The size is an input without a label: each language writes it from the label of the image.
Value Builder::sizeOf(std::uint32_t image) {
  const std::uint32_t number = graph_.sizeOf(image);
  if (number >= labels_.size()) nameInput(number, {}, "texture");
  return allComponents(number);
}

int Builder::imageSize(std::string_view image) {
  const int handle = input("texture", image, imageShape);
  if (handle == failed) return failed;
  const std::size_t before = graph_.size();
  return addResult(sizeOf(inputOf(handle)), before, "texture");
}

int Builder::callTexture(const Sampling& sampling, std::string_view image) {
  const std::vector<Value> operands = std::exchange(operands_, {});
  const Value& uv = operands[0];
  const int handle = input("texture", image, imageShape);
  if (handle == failed) return failed;
  const std::size_t before = graph_.size();
  const Value texels = values_.get(graph_, handle);
  const Value size = sizeOf(inputOf(handle)), place = uv * size - constantLike(size, 0.5);
  Numbers arguments{place[0], place[1], texels[0], size[0], size[1]};
  if (sampling.isByHost())
    for (int i = 0; i < 3; ++i) arguments.push_back(operands[1][i]);
  const Numbers values = module_.library.call(definitionOf(sampling), arguments);
  return addResult(fill(graph_, vectorOf(4), [&](int i) { return values[i]; }), before, "texture");
}

}  // namespace warpjet

#include "emit/dialect.hpp"

#include "emit/screen.hpp"
#include "texture/texture.hpp"

namespace warpjet {

namespace {

constexpr std::array<const Dialect*, ops::languageCount> everyDialect{&glsl300, &glsl100, &wgsl};

}  // namespace

std::span<const Dialect* const> dialects() { return everyDialect; }

const Dialect* findDialect(std::string_view name) {
  for (const Dialect* dialect : everyDialect) {
    if (dialect->name == name) return dialect;
  }
  return nullptr;
}

std::string_view Dialect::typeName(ops::Type type, Shape shape) const {
  const auto kind = static_cast<std::size_t>(type);
  if (shape == imageShape) return image;
  if (shape.isMatrix()) return matrices[shape.columns - 2u][shape.rows - 2u];
  return shape.isNumber() ? numbers[kind] : vectors[kind][shape.rows - 2u];
}

std::string_view Dialect::sourceOf(std::string_view functionName) const {
  if (functionName == acrossName) return across;
  if (functionName == downName) return down;
  return functionName == sampledTexelName ? sampledTexel : texel;
}

void appendExpanded(std::string& text, std::string_view form, Parts parts) {
  for (std::size_t dollar; (dollar = form.find('$')) != form.npos;) {
    text += form.substr(0, dollar);
    text += parts.begin()[form[dollar + 1] - '0'];
    form.remove_prefix(dollar + 2);
  }
  text += form;
}

std::string expand(std::string_view form, Parts parts) {
  std::string text;
  appendExpanded(text, form, parts);
  return text;
}

}  // namespace warpjet

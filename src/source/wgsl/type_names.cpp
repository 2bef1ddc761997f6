// Names of types in messages.
#include "source/wgsl/parser.hpp"
#include "source/wgsl/scalar_names.hpp"

namespace warpjet::source::wgsl {

std::string Parser::nameOf(Type type) const {
  if (type.isArray()) {
    const Type element = type.element();
    return "array<" + nameOf(element) + (type.length ? ", " + std::to_string(type.length) : "") +
           ">";
  }
  if (type.base == Base::Struct) {
    const Structure& structure = tree_.types.structure(type);
    return structure.name.empty() ? nameOf(structure.fields[0].type) : std::string(structure.name);
  }
  if (type.base == Base::Void) return "nothing";
  if (type.base == Base::Sampler) return "texture_2d<f32>";
  for (const ScalarName& each : scalarNames) {
    if (each.type.base != type.base) continue;
    if (type.isScalar()) return std::string(each.word);
    const std::string name =
        type.isMatrix() ? "mat" + std::to_string(type.columns) + "x" + std::to_string(type.rows)
                        : "vec" + std::to_string(type.rows);
    return each.suffix ? name + each.suffix : name + "<bool>";
  }
  return "nothing";
}

std::string Parser::nameOf(const Operand& operand) const {
  if (operand.isPointer()) return "pointer to " + nameOf(operand.type);
  if (!operand.isAbstract()) return nameOf(operand.type);
  const std::string scalar = operand.type.base == Base::Int ? "abstract int" : "abstract float";
  if (operand.type.isScalar()) return scalar;
  if (operand.type.isArray()) return "array of abstract numbers";
  return "vec" + std::to_string(operand.type.rows) + " of " + scalar + "s";
}

std::string Parser::withArticle(const std::string& name) const {
  if (name == "nothing") return name;
  const bool isVowel = std::string_view("aeioAEIO").find(name[0]) != std::string_view::npos ||
                       name.starts_with("f32");
  return (isVowel ? "an " : "a ") + name;
}

}  // namespace warpjet::source::wgsl

// Calls of functions that are not in the table: their results have special types, or a warp can't
// call them, or they exist only in GLSL.
#include <array>

#include "source/nearest.hpp"
#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

namespace {

// A function of GLSL, and its counterpart in WGSL.
struct Advice {
  std::string_view name, instead;
};
constexpr std::array advices{
    Advice{"mod", "x - y * floor(x / y), or x % y, which has the sign of x"},
    Advice{"inversesqrt", "inverseSqrt"},
    Advice{"faceforward", "faceForward"},
    Advice{"texture", "textureSampleLevel(image, sampler, uv, 0)"},
    Advice{"texture2D", "textureSampleLevel(image, sampler, uv, 0)"},
    Advice{"textureLod", "textureSampleLevel(image, sampler, uv, level)"},
    Advice{"texelFetch", "textureLoad"},
    Advice{"textureSize", "textureDimensions"},
    Advice{"dFdx", "dpdx"},
    Advice{"dFdy", "dpdy"},
    Advice{"lessThan", "a < b"},
    Advice{"lessThanEqual", "a <= b"},
    Advice{"greaterThan", "a > b"},
    Advice{"greaterThanEqual", "a >= b"},
    Advice{"equal", "a == b"},
    Advice{"notEqual", "a != b"},
    Advice{"not", "!a"},
    Advice{"isnan", "x != x"},
    Advice{"roundEven", "round"},
    Advice{"inverse", "a function of your own"},
    Advice{"floatBitsToInt", "bitcast<i32>(x)"},
    Advice{"floatBitsToUint", "bitcast<u32>(x)"},
    Advice{"intBitsToFloat", "bitcast<f32>(x)"},
    Advice{"uintBitsToFloat", "bitcast<f32>(x)"},
};

}  // namespace

// Makes a call of modf or frexp, which return a structure whose type has no name in WGSL.
Operand Parser::withStructure(const Token& name, const Operand& operand) {
  const bool isModf = name.is("modf");
  if (!operand.type.isNumeric() || operand.type.base != Base::Float || operand.type.isMatrix())
    return failOperand(name.location,
                       quote(name.text) + " cannot be called with (" + nameOf(operand) + ")");
  const int size = operand.type.rows;
  tree_.made.push_back("__" + std::string(name.text) + "_result_" + nameOf(operand.type));
  Structure made{.name = tree_.made.back()};
  made.add({"fract", operand.type, 0});
  made.add({isModf ? "whole" : "exp", vectorType(isModf ? Base::Float : Base::Int, size), size});
  made.size = 2 * size;
  Type type;
  type.base = Base::Struct;
  for (std::size_t i = 0; i < tree_.types.count(); ++i) {
    type.structure = static_cast<std::uint16_t>(i);
    if (tree_.types.structure(type).name == made.name) break;
    type.structure = 0xFFFF;
  }
  if (type.structure == 0xFFFF || tree_.types.count() == 0)
    type.structure = tree_.types.add(std::move(made));
  const auto found = findBuiltIn(tree_.builtIns, name.text, std::array{operand.type});
  return make({.kind = Code::BuiltIn,
               .type = type,
               .index = found->row,
               .location = name.location,
               .operands = {operand.id}});
}

Operand Parser::bitcast(const Token& name) {
  if (!expect("<", "bitcast")) return failOperand(name.location, "");
  const Type type = this->type();
  expect(">", "the type of a bitcast");
  Operands operands = arguments();
  if (problems_.any()) return failOperand(name.location, "");
  const bool isOne = operands.size() == 1 && operands[0].type.isNumeric() &&
                     !operands[0].isPointer() && !type.isMatrix() && type.isNumeric() &&
                     type.base != Base::Bool;
  if (!isOne || operands[0].type.layout() != type.layout() || operands[0].type.base == Base::Bool)
    return failOperand(name.location, "expected " + std::to_string(type.rows) +
                                          " numbers of 32 bits for bitcast<" + nameOf(type) +
                                          ">, got (" + typesOf(operands) + ")");
  // An abstract whole number is taken as an i32; if it is not negative and the result is a u32, as
  // a u32.
  const bool isWide =
      type.base == Base::Uint && operands[0].isAbstract() && operands[0].type.base == Base::Int;
  const Operand given = isWide && operands[0].known[0] >= 0
                            ? Operand{.id = convert(operands[0], type, name.location), .type = type}
                            : concrete(operands[0], name.location);
  if (problems_.any() || given.type == type) return given;
  if (given.type.isInteger() && type.isInteger())
    return make(
        {.kind = Code::Construct, .type = type, .location = name.location, .operands = {given.id}});
  const std::string row = "bitcast<" + nameOf(scalarOf(type.base)) + ">";
  const auto found = findBuiltIn(tree_.builtIns, row, std::array{given.type});
  return make({.kind = Code::BuiltIn,
               .type = type,
               .index = found->row,
               .location = name.location,
               .operands = {given.id}});
}

// Rejects calls of functions for memory that shaders share, and of names that WGSL doesn't have.
Operand Parser::callOther(const Token& name, const Operands& operands) {
  const std::string reason =
      quote(name.text) + " is for memory that shaders share, which a warp cannot read";
  if (name.text.starts_with("atomic") && !operands.empty() && operands[0].isPointer())
    return unsupported(name.location, name.is("atomicStore") ? voidType : operands[0].type, reason);
  if (name.is("arrayLength"))
    return unsupported(name.location, uintType,
                       "the length of this array is known only when the shader runs");
  if (name.is("workgroupBarrier") || name.is("storageBarrier") || name.is("textureBarrier"))
    return unsupported(name.location, voidType, reason);
  for (const auto& [glsl, instead] : advices)
    if (name.text == glsl)
      return failOperand(name.location,
                         quote(glsl) + " is a function of GLSL; write " + std::string(instead));
  Nearest nearest(name.text);
  for (const BuiltIn& row : tree_.builtIns) nearest.offer(row.name);
  for (const std::string_view other : order_) nearest.offer(other);
  return failOperand(name.location,
                     "there is no function " + quote(name.text) + nearest.question());
}

}  // namespace warpjet::source::wgsl

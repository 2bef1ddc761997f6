// Calls that read textures: WGSL, section 17.7.
#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

// Parses a call that reads a texture. Of a texture_2d<f32>, textureSampleLevel, textureLoad and
// textureDimensions work without the neighboring fragments; other calls fail when they are
// evaluated.
Operand Parser::callTexture(const Token& name, Operands operands) {
  const Location location = name.location;
  if (operands.empty() || operands[0].type != samplerType)
    return failOperand(location, "expected a texture as the first argument of " +
                                     std::string(name.text) + ", got (" + typesOf(operands) + ")");
  const Operand& image = operands[0];
  const bool isLevel = name.is("textureSampleLevel"), isLoad = name.is("textureLoad");
  const bool isSize = name.is("textureDimensions");
  const bool isCount = name.text.starts_with("textureNum");
  const bool isReadable = tree_.expressions[image.id].kind == Code::Variable;
  const Type texel = name.text.starts_with("textureSampleCompare") ? floatType
                     : image.texel.base == Base::Void              ? vectorType(Base::Float, 4)
                                                                   : image.texel;
  if (!isReadable || !(isLevel || isLoad || isSize)) {
    const Type result = isSize                    ? vectorType(Base::Uint, 2)
                        : isCount                 ? uintType
                        : name.is("textureStore") ? voidType
                                                  : texel;
    return unsupported(location, result,
                       isReadable ? quote(name.text) +
                                        " cannot be used in a warp; write "
                                        "textureSampleLevel(image, sampler, uv, 0)"
                                  : "only a texture_2d<f32> can be read in a warp");
  }
  const auto failArguments = [&](const std::string& wanted) {
    return failOperand(location, quote(name.text) + " expected (texture_2d<f32>, " + wanted +
                                     "), got (" + typesOf(operands) + ")");
  };
  const auto makeCall = [&](std::string_view row, std::initializer_list<ExpressionId> arguments,
                            std::initializer_list<Type> types) {
    const auto found = findBuiltIn(tree_.builtIns, row, {types.begin(), types.size()});
    return make({.kind = Code::BuiltIn,
                 .type = found->result,
                 .index = found->row,
                 .location = location,
                 .operands = arguments});
  };
  const auto asInts = [&](const Operand& given) {
    Type type = given.type;
    type.base = Base::Int;
    if (given.isAbstract() || given.type == type) return convert(given, type, location);
    return add(
        {.kind = Code::Construct, .type = type, .location = location, .operands = {given.id}});
  };
  const auto isWhole = [](const Operand& given, int size) {
    return given.type.isInteger() && given.type.rows == size && !given.isPointer();
  };
  constexpr Type vec2 = vectorType(Base::Float, 2), ivec2 = vectorType(Base::Int, 2);
  if (isSize) {
    if (operands.size() > 2 || (operands.size() == 2 && !isWhole(operands[1], 1)))
      return failArguments("level");
    const ExpressionId level =
        operands.size() == 2 ? asInts(operands[1]) : zero(intType, location).id;
    const Operand size = makeCall("textureDimensions", {image.id, level}, {samplerType, intType});
    return make({.kind = Code::Construct,
                 .type = vectorType(Base::Uint, 2),
                 .location = location,
                 .operands = {size.id}});
  }
  if (isLoad) {
    if (operands.size() != 3 || !isWhole(operands[1], 2) || !isWhole(operands[2], 1))
      return failArguments("vec2i, level");
    return makeCall("textureLoad", {image.id, asInts(operands[1]), asInts(operands[2])},
                    {samplerType, ivec2, intType});
  }
  const bool hasOffset = operands.size() == 5;
  if ((operands.size() != 4 && !hasOffset) || operands[1].type != voidType ||
      !canConvert(operands[2], vec2) || !canConvert(operands[3], floatType))
    return failArguments("sampler, vec2f, f32");
  const ExpressionId uv = convert(operands[2], vec2, location),
                     level = convert(operands[3], floatType, location);
  if (!hasOffset)
    return makeCall("textureSampleLevel", {image.id, uv, level}, {samplerType, vec2, floatType});
  if (!canConvert(operands[4], ivec2)) return failArguments("sampler, vec2f, f32, vec2i");
  const ExpressionId offset = convert(operands[4], ivec2, location);
  for (const std::int32_t number : constants_.integers(offset))
    if (number < -8 || number > 7) fail(location, "expected an offset from -8 to 7");
  if (constants_.integers(offset).empty()) fail(location, "the offset must be a constant");
  return makeCall("textureSampleLevelOffset", {image.id, uv, level, offset},
                  {samplerType, vec2, floatType, ivec2});
}

}  // namespace warpjet::source::wgsl

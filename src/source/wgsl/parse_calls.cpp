// Calls of functions: WGSL, section 17.
#include <algorithm>

#include "source/wgsl/abstract.hpp"
#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

namespace {

constexpr std::size_t maxOperands = 5;
constexpr const char* noValue = "this function has no value for these arguments";

}  // namespace

std::string Parser::typesOf(const Operands& operands) const {
  std::string text;
  for (const Operand& each : operands) text += (text.empty() ? "" : ", ") + nameOf(each);
  return text;
}

Operand Parser::call(const Token& name) {
  const Entity known = resolve(name.text);
  Operands operands = arguments();
  if (problems_.any()) return failOperand(name.location, "");
  if (known.kind == Entity::Kind::Function) return callFunction(name, known.index, operands);
  if (known.kind != Entity::Kind::None)
    return failOperand(name.location, quote(name.text) + " cannot be called");
  if (name.text.starts_with("texture")) return callTexture(name, std::move(operands));
  if (name.is("modf") || name.is("frexp"))
    if (operands.size() == 1) return withStructure(name, asFloats(operands[0], name.location));
  if (isBuiltIn(tree_.builtIns, name.text)) return callBuiltIn(name, std::move(operands));
  return callOther(name, operands);
}

Operand Parser::callFunction(const Token& name, FunctionId index, const Operands& operands) {
  const Function& function = tree_.functions[index];
  const auto fits = [&](const Parameter& parameter, const Entity& entity, const Operand& operand) {
    if (!entity.value.isPointer()) return canConvert(operand, parameter.type);
    const bool isWritten = parameter.direction != Parameter::Direction::In;
    return operand.isPointer() && operand.type == parameter.type &&
           operand.space == entity.value.space && (!isWritten || operand.isWritable);
  };
  const std::vector<Entity>& wanted = parameters_[index];
  bool matches = operands.size() == wanted.size();
  for (std::size_t i = 0; matches && i < wanted.size(); ++i)
    matches = fits(function.parameters[i], wanted[i], operands[i]);
  if (!matches) {
    std::string expected;
    for (const Entity& each : wanted)
      expected += (expected.empty() ? "" : ", ") + nameOf(each.value);
    return failOperand(name.location, quote(name.text) + " expected (" + expected + "), got (" +
                                          typesOf(operands) + ")");
  }
  std::vector<ExpressionId> arguments;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    Operand operand = operands[i];
    if (operand.isPointer()) operand.kind = Operand::Kind::Reference;
    arguments.push_back(convert(operand, function.parameters[i].type, name.location));
  }
  if (current_ == nothing)
    return failOperand(name.location,
                       quote(name.text) + " cannot be called here, where a constant is expected");
  calls_.push_back({current_, index, name.location});
  return make({.kind = Code::Call,
               .type = tree_.functions[index].type,
               .index = index,
               .location = name.location,
               .operands = std::move(arguments)});
}

// Finds the built-in function for these operands, and sets `types` to their types. Abstract
// operands get the first types that fit, in the order i32, u32, f32.
std::optional<Found> Parser::matchBuiltIn(std::string_view name, const Operands& operands,
                                          std::vector<Type>& types) const {
  std::vector<std::size_t> open;
  for (const Operand& each : operands) {
    if (each.isPointer()) return std::nullopt;
    if (each.isAbstract()) open.push_back(types.size());
    types.push_back(each.type);
  }
  if (operands.size() > maxOperands) return std::nullopt;
  int choices = 1;
  for (std::size_t i = 0; i < open.size(); ++i) choices *= 3;
  for (int choice = 0; choice < choices; ++choice) {
    int rest = choice;
    bool fits = true;
    for (std::size_t i = open.size(); i-- > 0; rest /= 3) {
      Type& type = types[open[i]];
      type.base = rest % 3 == 0 ? Base::Int : rest % 3 == 1 ? Base::Uint : Base::Float;
      fits = fits && canConvert(operands[open[i]], type);
    }
    if (!fits) continue;
    if (const auto found = findBuiltIn(tree_.builtIns, name, types)) return found;
  }
  return std::nullopt;
}

// Folds a call if its operands are abstract and the function works component by component: then the
// result is abstract, too. Otherwise returns an empty operand.
Operand Parser::foldBuiltIn(const BuiltIn& row, const Operands& operands, Type type,
                            Location location) {
  const bool areAbstract = std::all_of(operands.begin(), operands.end(),
                                       [](const Operand& each) { return each.isAbstract(); });
  if (!areAbstract || type.base == Base::Uint || type.base == Base::Bool) return {};
  if (auto numbers = foldAbstract(row, operands, type))
    return abstractOf(type, std::move(*numbers), location);
  if (row.way == Way::Each) return failOperand(location, noValue);
  return {};
}

Operand Parser::callBuiltIn(const Token& name, Operands operands) {
  std::vector<Type> types;
  const auto found = matchBuiltIn(name.text, operands, types);
  if (!found)
    return failOperand(name.location, quote(name.text) + " cannot be called with (" +
                                          typesOf(operands) +
                                          "); WGSL has no implicit conversions");
  const BuiltIn& row = tree_.builtIns[static_cast<std::size_t>(found->row)];
  if (row.way == Way::Unsupported)
    return unsupported(
        name.location, found->result,
        quote(name.text) + " cannot be used in a warp, which needs exact derivatives per vertex");
  checkLimits(row, operands, name.location);
  if (Operand folded = foldBuiltIn(row, operands, found->result, name.location);
      folded.isAbstract() || folded.id != nothing)
    return folded;
  std::vector<ExpressionId> arguments;
  for (std::size_t i = 0; i < operands.size(); ++i)
    arguments.push_back(convert(operands[i], types[i], name.location));
  Operand made = make({.kind = Code::BuiltIn,
                       .type = found->result,
                       .index = found->row,
                       .location = name.location,
                       .operands = std::move(arguments)});
  if (!problems_.any() && constants_.isConstant(made.id) && constants_.numbers(made.id).empty())
    return failOperand(name.location, noValue);
  return made;
}

// Checks that constant limits of clamp and smoothstep are in order.
void Parser::checkLimits(const BuiltIn& row, const Operands& operands, Location location) {
  const bool isClamp = row.name == "clamp";
  if (problems_.any() || (!isClamp && row.name != "smoothstep")) return;
  const auto numbersOf = [&](const Operand& operand) {
    return operand.isAbstract() ? operand.known : constants_.numbers(operand.id);
  };
  const auto low = numbersOf(operands[isClamp ? 1 : 0]),
             high = numbersOf(operands[isClamp ? 2 : 1]);
  for (std::size_t i = 0; i < low.size() && i < high.size(); ++i)
    if (isClamp ? low[i] > high[i] : low[i] == high[i])
      fail(location, "expected a lower limit below the upper one in " + std::string(row.name));
}

// Converts an operand of a function that exists only for floats.
Operand Parser::asFloats(const Operand& operand, Location location) {
  Type wanted = operand.type;
  wanted.base = Base::Float;
  if (!operand.isAbstract() || !canConvert(operand, wanted)) return load(operand, location);
  return {.id = convert(operand, wanted, location), .type = wanted};
}

}  // namespace warpjet::source::wgsl

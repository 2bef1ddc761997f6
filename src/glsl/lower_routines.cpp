// Calls of functions that stay functions.
#include <algorithm>
#include <utility>

#include "glsl/lower.hpp"

namespace warpjet::glsl {

// Those that somebody assigns to: what reads them depends on more than its arguments.
void Lowering::findAssigned() {
  isAssigned_.resize(tree_.variables.size());
  const auto mark = [&](ExpressionId target) {
    const Expression* node = &tree_.expressions[target];
    using enum Expression::Kind;
    while (node->kind == Part || node->kind == Swizzle || node->kind == Element)
      node = &tree_.expressions[node->operands[0]];
    if (node->kind == Variable) isAssigned_[node->index] = true;
  };
  for (const Expression& node : tree_.expressions) {
    using enum Expression::Kind;
    if (node.kind == Assign || node.kind == Increment) mark(node.operands[0]);
    if (node.kind == BuiltIn)
      for (std::size_t i = 0; i < node.operands.size(); ++i)
        if (isOut(builtIns[static_cast<std::size_t>(node.index)], i)) mark(node.operands[i]);
    if (node.kind != Call) continue;
    const auto& parameters = tree_.functions[node.index].parameters;
    for (std::size_t i = 0; i < node.operands.size(); ++i)
      if (parameters[i].direction != Parameter::Direction::In) mark(node.operands[i]);
  }
}

// What a call gives and then what it writes to; nothing if it is to be entered.
std::optional<Lowering::Value> Lowering::callRoutine(FunctionId number,
                                                     const std::vector<Value>& arguments) {
  RoutineKey key{1.0 * number};
  Value floats;
  bool areKnown = true;
  for (const Value& argument : arguments) {
    for (const Id id : argument) {
      const bool isFloat = recorder_.base(id) == Base::Float;
      const bool isKnown = recorder_.isConstant(id) || recorder_.isUndefined(id);
      if (!isFloat && !recorder_.isConstant(id)) return std::nullopt;
      areKnown = areKnown && isKnown;
      if (isFloat) {
        floats.push_back(id);
      } else {
        key.push_back(recorder_.value(id));
      }
    }
  }
  if (areKnown || floats.size() > mostNumbers || inlined_.contains(key)) return std::nullopt;
  const auto known = routineNumbers_.find(key);
  const int routine =
      known == routineNumbers_.end() ? recordRoutine(number, arguments, key) : known->second;
  routineNumbers_[key] = routine;
  if (routine < 0) return std::nullopt;

  const Routine& found = routines_[static_cast<std::size_t>(routine)];
  Value operands = floats;
  operands.insert(operands.end(), found.outside.begin(), found.outside.end());
  const Id made = recorder_.call(static_cast<std::uint32_t>(routine), operands);
  Value results;
  for (std::size_t i = 0; i < found.results.size(); ++i) {
    const Id result = found.results[i];
    const Operation& operation = recorder_.at(result);
    if (recorder_.isConstant(result) || recorder_.isUndefined(result)) {
      results.push_back(result);
    } else if (operation.code == Code::Parameter) {
      results.push_back(floats[static_cast<std::uint32_t>(operation.value) >> 8 & 255]);
    } else {
      results.push_back(recorder_.result(made, i));
    }
  }
  return results;
}

// Its number, or -1 if it cannot be one, or is too short: what writes to globals or reads what
// changes, and whose values are no floats.
int Lowering::recordRoutine(FunctionId number, const std::vector<Value>& arguments,
                            const RoutineKey& key) {
  if (routineCount_ >= Recorder::mostLoops || problems_.any()) return -1;
  const Function& function = tree_.functions[number];
  const std::uint32_t mine = ++routineCount_;
  const Problems before = problems_;
  std::vector<std::uint32_t> outer = std::exchange(openLoops_, {});
  store_.open();
  for (std::size_t i = 0; i < tree_.variables.size(); ++i) {
    const Variable& variable = tree_.variables[i];
    if (variable.kind != Variable::Kind::Global || !isAssigned_[i]) continue;
    for (int k = 0; k < sizeOf(variable.type); ++k) {
      const Slot slot = slots_[i] + static_cast<Slot>(k);
      store_.set(slot, recorder_.convert(recorder_.parameter(mine, unknowable),
                                         recorder_.base(store_.get(slot))));
    }
  }
  store_.open();
  std::vector<Value> parameters = arguments;
  std::size_t count = 0;
  for (Value& each : parameters)
    for (Id& id : each)
      if (recorder_.base(id) == Base::Float) id = recorder_.parameter(mine, count++);
  Value results = enter(number, std::move(parameters));
  for (const Parameter& each : function.parameters)
    if (each.direction != Parameter::Direction::In)
      for (const Id id : get(slotOf(each.variable), sizeOf(each.type))) results.push_back(id);
  const bool changesOthers = !store_.close().empty();
  store_.close();
  openLoops_ = std::move(outer);
  if (problems_.any() || changesOthers) {
    problems_ = before;
    return -1;
  }
  Routine routine{key, std::string(function.name), mine, count, {}, std::move(results)};
  if (!isRoutine(routine)) return -1;
  routines_.push_back(std::move(routine));
  return static_cast<int>(routines_.size() - 1);
}

// Finds what it reads from outside, too.
bool Lowering::isRoutine(Routine& routine) const {
  const auto isFloat = [&](Id id) { return recorder_.base(id) == Base::Float; };
  const Value& results = routine.results;
  if (results.empty() || results.size() > mostNumbers ||
      !std::all_of(results.begin(), results.end(), isFloat))
    return false;
  const std::vector<Id> needed = recorder_.neededBy(results);
  for (const Id id : needed) {
    const Operation& operation = recorder_.at(id);
    if (operation.code == Code::Uniform) routine.outside.push_back(id);
    if (operation.code == Code::Image || operation.code == Code::Argument) return false;
    if (operation.code == Code::Parameter &&
        (static_cast<std::uint32_t>(operation.value) >> 8 & 255) == unknowable)
      return false;
  }
  return needed.size() > shortest * results.size() &&
         routine.parameters + routine.outside.size() <= mostNumbers;
}

}  // namespace warpjet::glsl

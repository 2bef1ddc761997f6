// Lowers calls of functions that are not inlined, but remain functions in the shader: routines.
#include <algorithm>
#include <utility>

#include "source/lower.hpp"

namespace warpjet::source {

// Finds globals that are assigned somewhere: functions that read them depend on more than their
// arguments.
void Lowering::findAssigned() {
  std::vector<bool> isAssigned(tree_.variables.size());
  const auto mark = [&](ExpressionId target) {
    const Expression* node = &tree_.expressions[target];
    using enum Expression::Kind;
    while (node->kind == Part || node->kind == Swizzle || node->kind == Element)
      node = &tree_.expressions[node->operands[0]];
    if (node->kind == Variable) isAssigned[node->index] = true;
  };
  for (const Expression& node : tree_.expressions) {
    using enum Expression::Kind;
    if (node.kind == Assign || node.kind == Increment) mark(node.operands[0]);
    if (node.kind == BuiltIn)
      for (std::size_t i = 0; i < node.operands.size(); ++i)
        if (isOut(tree_.builtIns[static_cast<std::size_t>(node.index)], i)) mark(node.operands[i]);
    if (node.kind != Call) continue;
    const auto& parameters = tree_.functions[node.index].parameters;
    for (std::size_t i = 0; i < node.operands.size(); ++i)
      if (parameters[i].direction != Parameter::Direction::In) mark(node.operands[i]);
  }
  for (std::size_t i = 0; i < isAssigned.size(); ++i)
    if (isAssigned[i] && tree_.variables[i].kind == Variable::Kind::Global)
      assignedGlobals_.push_back(static_cast<VariableId>(i));
}

// Visits every expression within a statement.
template <class Visit>
void Lowering::visitExpressions(StatementId body, const Visit& visit) const {
  std::vector<StatementId> statements{body};
  std::vector<ExpressionId> expressions;
  while (!statements.empty()) {
    const StatementId next = statements.back();
    statements.pop_back();
    if (next == nothing) continue;
    const Statement& statement = tree_.statements[next];
    statements.insert(statements.end(), statement.children.begin(), statement.children.end());
    if (statement.expression != nothing) expressions.push_back(statement.expression);
    while (!expressions.empty()) {
      const Expression& node = tree_.expressions[expressions.back()];
      expressions.pop_back();
      visit(node);
      expressions.insert(expressions.end(), node.operands.begin(), node.operands.end());
    }
  }
}

// Finds the pure functions: those that write to no parameter, name no global that is assigned, and
// call only pure functions.
void Lowering::findPure() {
  std::vector<bool> isChanging(tree_.variables.size());
  for (const VariableId each : assignedGlobals_) isChanging[each] = true;
  isPure_.assign(tree_.functions.size(), true);
  std::vector<std::vector<FunctionId>> callers(tree_.functions.size());
  std::vector<FunctionId> impure;
  for (std::size_t i = 0; i < tree_.functions.size(); ++i) {
    const auto number = static_cast<FunctionId>(i);
    bool isPure = tree_.functions[i].body != nothing;
    for (const Parameter& each : tree_.functions[i].parameters)
      isPure = isPure && each.direction == Parameter::Direction::In;
    visitExpressions(tree_.functions[i].body, [&](const Expression& node) {
      if (node.kind == Expression::Kind::Variable && isChanging[node.index]) isPure = false;
      if (node.kind == Expression::Kind::Call) callers[node.index].push_back(number);
    });
    if (!isPure) impure.push_back(number);
  }
  while (!impure.empty()) {
    const FunctionId number = impure.back();
    impure.pop_back();
    if (!isPure_[number]) continue;
    isPure_[number] = false;
    impure.insert(impure.end(), callers[number].begin(), callers[number].end());
  }
}

// Returns the result of a call, followed by the parameters that it writes; nullopt if the call has
// to be inlined.
std::optional<Lowering::Value> Lowering::callRoutine(FunctionId number,
                                                     const std::vector<Value>& arguments) {
  RoutineKey key{1.0 * number};
  Value floats;
  bool areConstant = true;
  for (const Value& argument : arguments) {
    if (floats.size() + argument.size() > 2 * maxNumbers) return std::nullopt;
    for (const Id id : argument) {
      const bool isFloat = recorder_.base(id) == Base::Float;
      const bool isConstant = recorder_.isConstant(id) || recorder_.isUndefined(id);
      if (!isFloat && !recorder_.isConstant(id)) return std::nullopt;
      areConstant = areConstant && isConstant;
      if (isFloat) {
        floats.push_back(id);
      } else {
        key.push_back(recorder_.value(id));
      }
    }
  }
  if (areConstant || floats.size() > maxNumbers || inlined_.contains(key)) return std::nullopt;
  const auto recorded = routineNumbers_.find(key);
  const int routine =
      recorded == routineNumbers_.end() ? recordRoutine(number, arguments, key) : recorded->second;
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

// Records a function as a routine. Returns its number; -1 if the function is too short, or if it
// can't be a routine because it writes globals, reads assigned globals, or has results that aren't
// floats.
int Lowering::recordRoutine(FunctionId number, const std::vector<Value>& arguments,
                            const RoutineKey& key) {
  if (routineCount_ >= Recorder::maxLoops || problems_.any()) return -1;
  const Function& function = tree_.functions[number];
  const std::uint32_t routineId = ++routineCount_;
  const Problems before = problems_;
  std::vector<std::uint32_t> outer = std::exchange(openLoops_, {});
  const std::size_t unknownLoops = std::exchange(unknownLoops_, 0);
  store_.open();
  for (const VariableId each : assignedGlobals_) {
    for (int k = 0; k < sizeOf(tree_.variables[each].type); ++k) {
      const Slot slot = slotOf(each) + static_cast<Slot>(k);
      store_.set(slot, recorder_.convert(recorder_.parameter(routineId, unknowable),
                                         recorder_.base(store_.get(slot))));
    }
  }
  store_.open();
  std::vector<Value> parameters = arguments;
  std::size_t count = 0;
  for (Value& each : parameters)
    for (Id& id : each)
      if (recorder_.base(id) == Base::Float) id = recorder_.parameter(routineId, count++);
  Value results = inlineCall(number, std::move(parameters));
  for (const Parameter& each : function.parameters)
    if (each.direction != Parameter::Direction::In)
      for (const Id id : get(slotOf(each.variable), sizeOf(each.type))) results.push_back(id);
  const bool changesOthers = !store_.close().empty();
  store_.close();
  openLoops_ = std::move(outer);
  unknownLoops_ = unknownLoops;
  if (problems_.any() || changesOthers) {
    problems_.restore(before);
    return -1;
  }
  Routine routine{key, std::string(function.name), routineId, count, {}, std::move(results)};
  if (!completeRoutine(routine)) return -1;
  routines_.push_back(std::move(routine));
  return static_cast<int>(routines_.size() - 1);
}

// Finds the values that a recorded function reads from outside. Returns false if the function
// cannot be a routine, or is too short for one.
bool Lowering::completeRoutine(Routine& routine) const {
  const auto isFloat = [&](Id id) { return recorder_.base(id) == Base::Float; };
  const Value& results = routine.results;
  if (results.empty() || results.size() > maxNumbers ||
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
  return needed.size() > minOperationsPerResult * results.size() &&
         routine.parameters + routine.outside.size() <= maxNumbers;
}

}  // namespace warpjet::source

// Lowers whole functions and their calls.
#include "source/lower.hpp"

#include <algorithm>
#include <utility>

#include "source/assumption.hpp"

namespace warpjet::source {

namespace {

// No real shader needs that many steps; lowering them takes half a second.
constexpr std::size_t maxSteps = 250'000;
constexpr int maxDepth = 600;

}  // namespace

Lowering::Lowering(const Tree& tree, Problems& problems, int maxIterations,
                   std::set<RoutineKey> inlined)
    : tree_(tree),
      problems_(problems),
      maxIterations_(maxIterations),
      inlined_(std::move(inlined)) {
  findAssigned();
  findPure();
}

Lowered Lowering::lower(FunctionId number) {
  start();
  // The store records changes only in a branch.
  store_.open();
  const Function& function = tree_.functions[number];
  std::vector<Value> arguments;
  for (std::size_t i = 0; i < function.parameters.size(); ++i) {
    const Type type = function.parameters[i].type;
    Value argument;
    for (int k = 0; k < std::min(type.components(), sizeOf(type)); ++k)
      argument.push_back(recorder_.leafOf(Code::Argument, static_cast<int>(i), k, type));
    arguments.push_back(std::move(argument));
  }
  Value results = inlineCall(number, std::move(arguments));
  for (Id& result : results) {
    if (recorder_.isUndefined(result)) result = recorder_.constant(Base::Float, 0);
    result = recorder_.convert(result, Base::Float);
  }
  if (!problems_.any()) exceedsLimits(function.location);
  return {std::move(recorder_),  std::move(results),   function.type,
          std::move(externals_), std::move(routines_), std::move(cutOff_)};
}

// Allocates the slots of all variables, which are fixed, since no function calls itself, and
// executes the initializers of globals.
void Lowering::start() {
  for (const Variable& variable : tree_.variables) {
    const auto size = static_cast<std::size_t>(sizeOf(variable.type));
    slots_.push_back(store_.allocate(size, recorder_.undefined(Base::Float)));
    using enum Variable::Kind;
    if (variable.kind == Uniform || variable.kind == Attribute) {
      declareExternal(variable, slots_.back());
    } else {
      set(slots_.back(), undefined(variable.type));
    }
  }
  for (const StatementId statement : tree_.globals) execute(statement);
}

void Lowering::declareExternal(const Variable& variable, Slot first) {
  std::vector<Id> leaves;
  addExternal(std::string(variable.name), variable.type, variable.kind == Variable::Kind::Attribute,
              leaves);
  set(first, leaves);
}

void Lowering::addExternal(const std::string& name, Type type, bool isAttribute,
                           std::vector<Id>& leaves) {
  if (type.isArray()) {
    for (int i = 0; i < type.length; ++i)
      addExternal(name + '[' + std::to_string(i) + ']', type.element(), isAttribute, leaves);
  } else if (type.isStruct()) {
    for (const Field& field : tree_.types.structure(type).fields) {
      // An array of arrays is represented as an array of structures whose only field has no name.
      const std::string part = field.name.empty() ? "" : '.' + std::string(field.name);
      addExternal(name + part, field.type, isAttribute, leaves);
    }
  } else {
    const auto number = static_cast<int>(externals_.size());
    externals_.push_back({name, type, isAttribute});
    if (type == samplerType) {
      leaves.push_back(recorder_.leaf(Code::Image, number));
      return;
    }
    for (int k = 0; k < type.components(); ++k)
      leaves.push_back(recorder_.leafOf(Code::Uniform, number, k, type));
  }
}

Lowering::Value Lowering::get(Slot first, int count) const {
  Value value;
  for (int i = 0; i < count; ++i) value.push_back(store_.get(first + i));
  return value;
}

void Lowering::set(Slot first, const Value& value) {
  for (std::size_t i = 0; i < value.size(); ++i) store_.set(static_cast<Slot>(first + i), value[i]);
}

Lowering::Value Lowering::undefined(Type type) {
  Value value;
  fillUndefined(type, value);
  return value;
}

void Lowering::fillUndefined(Type type, Value& value) {
  if (type.isArray()) {
    for (int i = 0; i < type.length; ++i) fillUndefined(type.element(), value);
  } else if (type.isStruct()) {
    for (const Field& field : tree_.types.structure(type).fields) fillUndefined(field.type, value);
  } else if (type.base != Base::Void) {
    value.insert(value.end(), type.components(), recorder_.undefined(type.base));
  }
}

void Lowering::merge(Id condition, Store::Changes yes, Store::Changes no) {
  const Assumption ifYes(recorder_, condition, true), ifNo(recorder_, condition, false);
  std::size_t i = 0, k = 0;
  while (i < yes.size() || k < no.size()) {
    const bool hasYes = i < yes.size() && (k == no.size() || yes[i].slot <= no[k].slot);
    const bool hasNo = k < no.size() && (i == yes.size() || no[k].slot <= yes[i].slot);
    const Slot slot = hasYes ? yes[i].slot : no[k].slot;
    const Id before = store_.get(slot);
    const Id inYes = hasYes ? yes[i++].value : before, inNo = hasNo ? no[k++].value : before;
    // The branches may know more about a value that neither has changed.
    const bool isSame = (inYes == before || inYes == ifYes.apply(before)) &&
                        (inNo == before || inNo == ifNo.apply(before));
    store_.set(slot, isSame ? before : recorder_.choose(condition, inYes, inNo));
  }
}

// Replaces choices among the values that have changed since that point in the store's history: the
// current branch knows the condition.
void Lowering::assume(Id condition, bool isTrue, std::size_t since) {
  if (recorder_.isConstant(condition) || recorder_.isUndefined(condition)) return;
  const Assumption assumption(recorder_, condition, isTrue);
  store_.revise(since, [&](Id value) { return assumption.apply(value); });
}

bool Lowering::exceedsLimits(Location location) {
  if (problems_.any()) return true;
  if (++steps_ > maxSteps || recorder_.isFull()) {
    problems_.add(location, "this needs more than 250,000 steps once its loops are unrolled");
  } else if (depth_ > maxDepth) {
    problems_.add(location, "calls and expressions are nested too deeply here");
  }
  return problems_.any();
}

// Lowers a call. `targets` are the destinations of `out` and `inout` parameters, in the order of
// parameters.
Lowering::Value Lowering::call(FunctionId number, std::vector<Value> arguments,
                               const std::vector<LValue>& targets, Location location) {
  const Function& function = tree_.functions[number];
  if (function.body == nothing) {
    problems_.add(location, quote(function.name) + " is declared, but has no body");
    return undefined(function.type);
  }
  // The previous value of an out parameter is invisible to the function.
  for (std::size_t i = 0; i < arguments.size(); ++i)
    if (function.parameters[i].direction == Parameter::Direction::Out)
      arguments[i] = undefined(function.parameters[i].type);
  const int size = sizeOf(function.type);
  for (const Value& argument : arguments) steps_ += argument.size() / 32;
  if (const auto results = callRoutine(number, arguments)) {
    auto next = results->begin() + size;
    std::size_t target = 0;
    for (const Parameter& parameter : function.parameters) {
      if (parameter.direction == Parameter::Direction::In) continue;
      const auto end = next + sizeOf(parameter.type);
      store(targets[target++], {next, end});
      next = end;
    }
    return {results->begin(), results->begin() + size};
  }
  if (isPure_[number]) return inlineOnce(number, arguments);
  Value result = inlineCall(number, std::move(arguments));
  std::size_t next = 0;
  for (const Parameter& parameter : function.parameters)
    if (parameter.direction != Parameter::Direction::In)
      store(targets[next++], get(slotOf(parameter.variable), sizeOf(parameter.type)));
  return result;
}

// Inlines a pure function once per list of arguments and innermost loop: the operations of a call
// that contains loops belong to the enclosing loop.
Lowering::Value Lowering::inlineOnce(FunctionId number, const std::vector<Value>& arguments) {
  std::vector<std::uint32_t> key{static_cast<std::uint32_t>(number),
                                 openLoops_.empty() ? 0 : openLoops_.back()};
  for (const Value& argument : arguments)
    for (const Id id : argument) key.push_back(index(id));
  const auto known = results_.find(key);
  if (known != results_.end()) return known->second;
  Value result = inlineCall(number, arguments);
  if (!problems_.any()) results_.emplace(std::move(key), result);
  return result;
}

// Inlines the body of a function.
Lowering::Value Lowering::inlineCall(FunctionId number, std::vector<Value> arguments) {
  const Function& function = tree_.functions[number];
  for (std::size_t i = 0; i < arguments.size(); ++i) {
    const Parameter& parameter = function.parameters[i];
    const Slot slot = slotOf(parameter.variable);
    store_.declare(slot, arguments[i].size());
    set(slot, arguments[i]);
  }
  const int size = sizeOf(function.type);
  const Id no = recorder_.constant(Base::Bool, 0);
  const Slot returned = store_.allocate(1, no);
  const Slot result = store_.allocate(static_cast<std::size_t>(size), no);
  set(result, undefined(function.type));
  frames_.push_back({returned, result, number});
  const std::vector<Breakable> outer = std::exchange(breakables_, {});
  execute(function.body);
  breakables_ = outer;
  frames_.pop_back();
  return get(result, size);
}

}  // namespace warpjet::source

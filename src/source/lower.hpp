// Lowers the tree to operations: executes one function of the source symbolically. Calls are
// inlined, short loops unrolled, and if a condition is unknown, both branches are executed and
// every variable becomes a choice between its two values. An early end of a loop or function is a
// condition on everything that follows.
//
// `loop` in lower_loops.cpp is the only place that repeats statements. If a loop remains a loop in
// the shader, its body is recorded once, in terms of the variables that it changes; see
// lower_folds.cpp.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "source/builtins.hpp"
#include "source/loops.hpp"
#include "source/recorder.hpp"
#include "source/routines.hpp"
#include "source/store.hpp"
#include "source/tree.hpp"

namespace warpjet::source {

// An input of the host by name: a uniform or an attribute, or a part of one such as `light.color`.
struct External {
  std::string name;
  Type type;
  bool isAttribute;
};

struct Lowered {
  Recorder recorder;
  std::vector<Id> results;
  Type type;
  std::vector<External> externals;
  // Callees precede callers.
  std::vector<Routine> routines;
  // The first loop that is cut off before its end.
  Problems cutOff;
};

class Lowering {
 public:
  // A loop whose end is unknown gets at most `maxIterations` iterations, a number or a value in
  // loops.hpp. Calls of the functions in `inlined` are always inlined.
  Lowering(const Tree& tree, Problems& problems, int maxIterations,
           std::set<RoutineKey> inlined = {});

  // Makes a lowering for constant expressions of a tree that is still growing.
  Lowering(const Tree& tree, Problems& problems);

  Lowered lower(FunctionId function);
  // Returns the numbers of a constant expression; empty if it has no value, like 1 / 0.
  std::vector<double> constant(ExpressionId expression);

 private:
  using Value = std::vector<Id>;
  using Slot = Store::Slot;

  // The target of an assignment. It has one choice per possible value of an unknown index:
  // consecutive slots, from `first` on. For a swizzle, `picked` has the offsets of those slots that
  // are assigned.
  struct LValue {
    struct Choice {
      Id condition;
      Slot first;
    };
    std::vector<Choice> choices;
    Type type;
    std::vector<std::uint8_t> picked{};

    Slot slot(const Choice& choice, std::size_t i) const {
      return static_cast<Slot>(choice.first + (picked.empty() ? i : picked[i]));
    }
  };

  // A call that hasn't returned, and its result.
  struct Frame {
    Slot returned, result;
    FunctionId function;
  };
  // An enclosing loop or switch. A switch has no continue; both of its slots are the same.
  struct Breakable {
    Slot broken, continued;
    bool isSwitch;
  };

  // lower.cpp
  void start();
  void declareExternal(const Variable& variable, Slot first);
  void addExternal(const std::string& name, Type type, bool isAttribute, std::vector<Id>& leaves);
  Value call(FunctionId function, std::vector<Value> arguments, const std::vector<LValue>& targets,
             Location location);
  Value inlineCall(FunctionId function, std::vector<Value> arguments);
  Value inlineOnce(FunctionId function, const std::vector<Value>& arguments);
  bool exceedsLimits(Location location);
  Slot slotOf(VariableId variable) const { return slots_[variable]; }
  int sizeOf(Type type) const { return tree_.types.size(type); }
  Value get(Slot first, int count) const;
  void set(Slot first, const Value& value);
  Value undefined(Type type);
  void fillUndefined(Type type, Value& value);
  // Runs `yes` and `no` as the branches of a condition.
  template <class Yes, class No>
  void branch(Id condition, const Yes& yes, const No& no);
  void merge(Id condition, Store::Changes yes, Store::Changes no);
  void assume(Id condition, bool isTrue, std::size_t since);

  // lower_constants.cpp
  Value expandFunction(Code code, const std::vector<Value>& x);
  Id determinant(const Value& matrix);
  Id minorOf(const Value& matrix, std::size_t column, std::size_t row);
  Value inverse(const Value& matrix);

  // lower_statements.cpp
  void execute(StatementId statement);
  void executeAll(const std::vector<StatementId>& statements, std::size_t from);
  void declare(const Statement& statement);
  void initialize(const Statement& statement);
  std::vector<const Statement*> declarationsOf(StatementId child) const;
  void choose(const Statement& statement);
  void select(const Statement& statement);
  void returnFrom(const Statement& statement);
  Id stopCondition();
  void resume();
  // Runs `next` in a branch, unless statements since that point in the store's history have
  // stopped.
  template <class Next>
  void unlessStopped(std::size_t since, const Next& next);

  // lower_routines.cpp
  void findAssigned();
  void findPure();
  template <class Visit>
  void visitExpressions(StatementId body, const Visit& visit) const;
  std::optional<Value> callRoutine(FunctionId function, const std::vector<Value>& arguments);
  int recordRoutine(FunctionId function, const std::vector<Value>& arguments,
                    const RoutineKey& key);
  bool completeRoutine(Routine& routine) const;

  // lower_loops.cpp
  std::string enterUnknown();
  void loop(const Statement& statement);
  bool hasNoEnd(const Statement& statement) const;
  void unroll(const Statement& statement);

  // lower_folds.cpp
  template <class End>
  Id iterate(const Statement& statement, bool evaluatesTest, const End& end);
  bool foldLoop(const Statement& statement);
  void evaluateTest(Folding& folding);
  bool record(const Statement& statement, Folding& folding);
  bool confirmGuesses(const Statement& statement, Folding& folding, const Store::Changes& changes);
  bool declares(const Statement& loop, Slot slot) const;
  std::optional<std::uint32_t> stepsOf(const Statement& statement, const Folding& folding) const;
  bool isWorthIt(const Folding& folding, std::size_t once) const;

  // lower_states.cpp
  Id valueIfContinued(Id value, Id start) const;
  std::vector<Changing> changesOf(const Store::Changes& changes) const;
  bool isRepresentable(const Changing& counter, const Folding& folding) const;
  Id valueInStep(const Changing& each, const Folding& folding, std::size_t location);
  template <class At>
  Id fromState(const Changing& each, Id state, const At& at);
  Value toStates(const Changing& each, Id value);
  std::optional<double> changePerStep(Id next, Id before, int depth) const;
  bool onlyCounts(const Changing& each, const Folding& folding) const;
  bool widenStates(Folding& folding) const;
  bool close(const Statement& statement, const Folding& folding);

  // lower_expressions.cpp
  Value evaluate(ExpressionId expression);
  Value evaluateInner(const Expression& node);
  Id condition(ExpressionId expression) { return evaluate(expression)[0]; }
  Value chain(const Expression& node);
  Value logical(const Expression& node);
  Value choice(const Expression& node);
  Value assign(const Expression& node);
  Value increment(const Expression& node);
  Value construct(const Expression& node);
  Value callOf(const Expression& node);
  Value element(const Expression& node);
  Value hostElement(const Expression& node);
  Value part(const Expression& node);
  Value pick(const std::vector<Value>& elements, Id index);

  // lower_operators.cpp
  Value binary(Operator op, Type a, const Value& x, Type b, const Value& y);
  Value product(Type a, const Value& x, Type b, const Value& y);
  Id floatRemainder(Id x, Id y);
  Id scalar(Operator op, Base base, Id x, Id y);
  Id equal(const Value& x, const Value& y);

  // lower_lvalues.cpp
  LValue lvalue(ExpressionId expression);
  LValue elementOf(LValue whole, ExpressionId index);
  Value load(const LValue& from);
  void store(const LValue& to, const Value& value);
  // Returns the slot of a variable; fails if a warp doesn't have it.
  Slot slotToRead(const Expression& node);
  // Returns the slot of a variable, a field or an element with a known index, so that reading one
  // number doesn't copy an array. Returns nullopt if that requires evaluating side effects.
  std::optional<Slot> knownSlot(const Expression& node);
  bool isPlain(ExpressionId expression) const;

  // lower_builtins.cpp
  Value builtIn(const Expression& node);
  Value each(const BuiltIn& row, const std::vector<Value>& x, Base base);
  Value applyToVectors(const BuiltIn& row, const std::vector<Value>& x, const Expression& node);
  Id packGroup(Type type, const Value& value);
  Value unpackGroup(Id group, Type type);
  Id number(Base base, double value) { return recorder_.constant(base, value); }
  Id compare(Code code, Base base, Id x, Id y);
  Value lookUp(const BuiltIn& row, const std::vector<Value>& x);
  Value texture(Code code, const Value& image, const Value& at);
  Value imageSize(const Value& image);

  // lower_bits.cpp
  Value lowerWgslBuiltIn(const BuiltIn& builtIn, const std::vector<Value>& x,
                         const Expression& node);
  Value bytes(const BuiltIn& builtIn, const std::vector<Value>& x, const Expression& node);
  Id bit(Way way, Base base, Id x);
  Id countOnes(Id bits);
  Id smear(Id bits);
  Id reverse(Id bits);
  Id extract(Base base, Id x, Id offset, Id count);
  Id insert(Id x, Id bits, Id offset, Id count);
  Id ldexp(Id x, Id exponent);
  Id exponentOf(Id x);

  // lower_packing.cpp
  Value pack(const Value& numbers, bool isSigned);
  Value unpack(Id bits, bool isSigned, int count);
  Id partOfBits(Id bits, Base base, double width, int i);
  Id packHalf(Id x);
  Id unpackHalf(Id bits);

  const Tree& tree_;
  Problems& problems_;
  Problems cutOff_;
  int maxIterations_;
  Recorder recorder_;
  Store store_;
  std::vector<Slot> slots_;  // by variable
  std::vector<External> externals_;
  // Maps the names of elements of storage buffers to their numbers.
  std::map<std::string, Value> hostElements_;
  std::vector<Frame> frames_;
  std::vector<Breakable> breakables_;
  std::vector<std::uint32_t> openLoops_;
  // The number of enclosing loops whose ends only the shader knows, and of those among them that
  // may still be unrolled.
  std::size_t unknownLoops_ = 0, unknownFolds_ = 0;
  // Represents, in a key, the unknown value of a global that is assigned somewhere.
  static constexpr std::size_t unknowable = 255;
  std::set<RoutineKey> inlined_;
  std::map<RoutineKey, int> routineNumbers_;
  std::vector<Routine> routines_;
  std::uint32_t routineCount_ = 0;
  // Globals that are assigned somewhere, and functions whose results depend only on their
  // arguments.
  std::vector<VariableId> assignedGlobals_;
  std::vector<bool> isPure_;
  // The results of inlined pure functions, by function, innermost loop and arguments.
  std::map<std::vector<std::uint32_t>, Value> results_;
  std::size_t steps_ = 0;
  int depth_ = 0;
};

template <class Yes, class No>
void Lowering::branch(Id condition, const Yes& yes, const No& no) {
  if (recorder_.isConstant(condition) || recorder_.isUndefined(condition))
    return recorder_.isTrue(condition) ? yes() : no();
  store_.open();
  yes();
  Store::Changes inYes = store_.close();
  store_.open();
  no();
  merge(condition, std::move(inYes), store_.close());
}

template <class Next>
void Lowering::unlessStopped(std::size_t since, const Next& next) {
  const Id isOver = stopCondition();
  branch(
      isOver, [] {},
      [&] {
        resume();
        assume(isOver, false, since);
        next();
      });
}

}  // namespace warpjet::source

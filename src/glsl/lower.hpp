// From the tree to operations: one function of the text is run, on numbers that nobody knows yet.
// Calls are entered, short loops unrolled, and where a condition decides, both ways are run and
// every variable becomes the choice of the two. An early end of a loop or function is a condition
// of all that follows it.
//
// Loops: `loop` in lower_loops.cpp is the only place that repeats anything. A loop that stays one
// has its body recorded once there, between the variables that it changes.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "glsl/builtins.hpp"
#include "glsl/loops.hpp"
#include "glsl/recorder.hpp"
#include "glsl/routines.hpp"
#include "glsl/store.hpp"
#include "glsl/tree.hpp"

namespace warpjet::glsl {

// What the host gives by name: a uniform or an attribute, or a part of one such as `light.color`.
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
  // Callees first.
  std::vector<Routine> routines;
};

class Lowering {
 public:
  // A loop whose end depends on what is not known runs `maxIterations` times, or is refused for 0.
  // Functions that are `inlined` are entered wherever they are called.
  Lowering(const Tree& tree, Problems& problems, int maxIterations,
           std::set<RoutineKey> inlined = {});

  // For constant expressions of a tree that is still growing.
  Lowering(const Tree& tree, Problems& problems);

  Lowered lower(FunctionId function);
  // The numbers of a constant expression; empty where one has none, as 1 / 0.
  std::vector<double> constant(ExpressionId expression);

 private:
  using Value = std::vector<Id>;
  using Slot = Store::Slot;

  // What is assigned to: slots in a row from the first of each choice on, one choice for each that
  // an index may be; of a swizzle only some of them.
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

  // A call that has not returned, and what it gives.
  struct Frame {
    Slot returned, result;
    FunctionId function;
  };
  // A loop or switch that is running; nothing goes on with a switch, whose slots are one.
  struct Breakable {
    Slot broken, continued;
    bool isSwitch;
  };

  // lower.cpp
  void start();
  void declareExternal(const Variable& variable, Slot first);
  void addExternal(const std::string& name, Type type, bool isAttribute, std::vector<Id>& leaves);
  Value call(FunctionId function, std::vector<Value> arguments, const std::vector<LValue>& targets,
             Location place);
  Value enter(FunctionId function, std::vector<Value> arguments);
  Value enterOnce(FunctionId function, const std::vector<Value>& arguments);
  bool isTooMuch(Location place);
  Slot slotOf(VariableId variable) const { return slots_[variable]; }
  int sizeOf(Type type) const { return tree_.types.size(type); }
  Value get(Slot first, int count) const;
  void set(Slot first, const Value& value);
  Value undefined(Type type);
  void fillUndefined(Type type, Value& value);
  // Runs `yes` and `no` where a condition decides between them.
  template <class Yes, class No>
  void branch(Id condition, const Yes& yes, const No& no);
  void merge(Id condition, Store::Changes yes, Store::Changes no);

  // lower_constants.cpp
  Value expanded(Code code, const std::vector<Value>& x);
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
  Id stopped();
  void resume();

  // lower_routines.cpp
  void findAssigned();
  void findPure();
  template <class Visit>
  void visitExpressions(StatementId body, const Visit& visit) const;
  std::optional<Value> callRoutine(FunctionId function, const std::vector<Value>& arguments);
  int recordRoutine(FunctionId function, const std::vector<Value>& arguments,
                    const RoutineKey& key);
  bool isRoutine(Routine& routine) const;

  // lower_loops.cpp
  void loop(const Statement& statement);
  void unroll(const Statement& statement);
  template <class End>
  Id iterate(const Statement& statement, bool asks, const End& end);
  bool foldLoop(const Statement& statement);
  std::vector<Changing> changesOf(const Store::Changes& changes) const;
  Id duringLoop(const Changing& each, std::uint32_t loop, std::size_t place);
  Id fromState(Id state, Base base);
  bool counts(Id next, Id before, std::uint32_t steps, int depth) const;
  bool record(const Statement& statement, Folding& folding);
  bool isRight(const Statement& statement, Folding& folding, const Store::Changes& changes);
  bool declares(const Statement& loop, Slot slot) const;
  std::optional<std::uint32_t> stepsOf(const Statement& statement, const Folding& folding) const;
  bool hasNoEnd(const Statement& statement) const;
  bool isWorthIt(const Folding& folding, std::size_t once) const;
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
  Value part(const Expression& node);
  Value binary(Operator op, Type a, const Value& x, Type b, const Value& y);
  Value product(Type a, const Value& x, Type b, const Value& y);
  Id scalar(Operator op, Base base, Id x, Id y);
  Id equal(const Value& x, const Value& y);
  Value pick(const std::vector<Value>& elements, Id index);

  // lower_lvalues.cpp
  LValue lvalue(ExpressionId expression);
  LValue elementOf(LValue whole, ExpressionId index);
  Value load(const LValue& from);
  void store(const LValue& to, const Value& value);
  // Of a variable; fails where a warp has no such.
  Slot slotToRead(const Expression& node);
  // Of a variable, a field or an element whose index is known, so that an array is not copied to
  // read one of its numbers. Nothing of what cannot be told without side effects.
  std::optional<Slot> knownSlot(const Expression& node);
  bool isPlain(ExpressionId expression) const;

  // lower_builtins.cpp
  Value builtIn(const Expression& node);
  Value each(const BuiltIn& row, const std::vector<Value>& x, Base base);
  Value grouped(const BuiltIn& row, const std::vector<Value>& x, const Expression& node);
  Id packed(Type type, const Value& value);
  Value unpacked(Id group, Type type);
  Id number(Base base, double value) { return recorder_.constant(base, value); }
  Id compare(Code code, Base base, Id x, Id y);
  Value lookUp(const BuiltIn& row, const std::vector<Value>& x);
  Value texture(Code code, const Value& image, const Value& at);
  Value imageSize(const Value& image);

  // lower_packing.cpp
  Value pack(const Value& numbers, bool isSigned);
  Value unpack(Id bits, bool isSigned);
  Id packHalf(Id x);
  Id unpackHalf(Id bits);

  const Tree& tree_;
  Problems& problems_;
  int maxIterations_;
  Recorder recorder_;
  Store store_;
  std::vector<Slot> slots_;  // by variable
  std::vector<External> externals_;
  std::vector<Frame> frames_;
  std::vector<Breakable> breakables_;
  std::vector<std::uint32_t> openLoops_;
  // In the place of a parameter, what a global holds that somebody assigns to.
  static constexpr std::size_t unknowable = 255;
  std::set<RoutineKey> inlined_;
  std::map<RoutineKey, int> routineNumbers_;
  std::vector<Routine> routines_;
  std::uint32_t routineCount_ = 0;
  // Globals that somebody assigns to, and functions whose results follow from their arguments
  // alone.
  std::vector<VariableId> changing_;
  std::vector<bool> isPure_;
  // What such functions gave where they were entered: by function, innermost loop and arguments.
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

}  // namespace warpjet::glsl

// Lowers statements: which ones run, and under which condition.
#include <algorithm>

#include "source/lower.hpp"

namespace warpjet::source {

void Lowering::execute(StatementId child) {
  if (child == nothing) return;
  const Statement& statement = tree_.statements[child];
  if (exceedsLimits(statement.location)) return;
  ++depth_;
  using enum Statement::Kind;
  switch (statement.kind) {
    case Block:
      executeAll(statement.children, 0);
      break;
    case Evaluate:
      evaluate(statement.expression);
      break;
    case Declare:
      declare(statement);
      break;
    case If:
      choose(statement);
      break;
    case Loop:
      loop(statement);
      break;
    case Switch:
      select(statement);
      break;
    case Case:
      break;
    case Return:
      returnFrom(statement);
      break;
    case Break:
      store_.set(breakables_.back().broken, number(Base::Bool, 1));
      break;
    case Continue: {
      std::size_t i = breakables_.size();
      while (breakables_[i - 1].isSwitch) --i;
      store_.set(breakables_[i - 1].continued, number(Base::Bool, 1));
      break;
    }
  }
  --depth_;
}

// Returns the condition under which the following statements are skipped.
Id Lowering::stopCondition() {
  Id any = frames_.empty() ? number(Base::Bool, 0) : store_.get(frames_.back().returned);
  for (const Breakable& each : breakables_)
    any = recorder_.logicalOr(recorder_.logicalOr(any, store_.get(each.broken)),
                              store_.get(each.continued));
  return any;
}

// Enters a branch that only runs if nothing has stopped.
void Lowering::resume() {
  const Id no = number(Base::Bool, 0);
  if (!frames_.empty()) store_.set(frames_.back().returned, no);
  for (const Breakable& each : breakables_) {
    store_.set(each.broken, no);
    store_.set(each.continued, no);
  }
}

void Lowering::executeAll(const std::vector<StatementId>& statements, std::size_t from) {
  for (std::size_t i = from; i < statements.size() && !problems_.any(); ++i) {
    const std::size_t before = store_.now();
    execute(statements[i]);
    const Id isOver = stopCondition();
    if (recorder_.isTrue(isOver)) return;
    if (recorder_.isConstant(isOver)) continue;
    if (i + 1 == statements.size()) return;
    return unlessStopped(before, [&] {
      ++depth_;
      executeAll(statements, i + 1);
      --depth_;
    });
  }
}

void Lowering::declare(const Statement& statement) {
  const Variable& variable = tree_.variables[statement.index];
  if (variable.kind == Variable::Kind::Uniform || variable.kind == Variable::Kind::Attribute)
    return;
  if (variable.kind != Variable::Kind::Global)
    store_.declare(slotOf(statement.index), static_cast<std::size_t>(sizeOf(variable.type)));
  initialize(statement);
}

// Sets a variable to its initial value; without one, it is undefined.
void Lowering::initialize(const Statement& statement) {
  set(slotOf(statement.index), statement.expression == nothing
                                   ? undefined(tree_.variables[statement.index].type)
                                   : evaluate(statement.expression));
}

void Lowering::choose(const Statement& statement) {
  const auto& children = statement.children;
  branch(
      condition(statement.expression), [&] { execute(children[0]); },
      [&] {
        if (children.size() > 1) execute(children[1]);
      });
}

void Lowering::returnFrom(const Statement& statement) {
  if (statement.expression != nothing) set(frames_.back().result, evaluate(statement.expression));
  store_.set(frames_.back().returned, number(Base::Bool, 1));
}

// Returns the declarations in a statement: `float x = 1.0, y;` is a block of two. Empty for other
// statements.
std::vector<const Statement*> Lowering::declarationsOf(StatementId child) const {
  const Statement& statement = tree_.statements[child];
  const auto isDeclaration = [&](StatementId each) {
    return tree_.statements[each].kind == Statement::Kind::Declare;
  };
  if (isDeclaration(child)) return {&statement};
  std::vector<const Statement*> all;
  if (statement.kind == Statement::Kind::Block &&
      std::all_of(statement.children.begin(), statement.children.end(), isDeclaration))
    for (const StatementId each : statement.children) all.push_back(&tree_.statements[each]);
  return all;
}

// Executes a switch, from the matching case until a break. Declarations in a case are visible in
// all later cases, so they are outside of the branches.
void Lowering::select(const Statement& statement) {
  const Id value = evaluate(statement.expression)[0];
  const Id no = number(Base::Bool, 0);
  const Slot broken = store_.allocate(1, no);
  const auto fits = [&](const Statement& label) {
    return scalar(Operator::Equal, recorder_.base(value), value, evaluate(label.expression)[0]);
  };
  Id fitsAny = no;
  for (const StatementId child : statement.children) {
    const Statement& label = tree_.statements[child];
    if (label.kind == Statement::Kind::Case && label.expression != nothing)
      fitsAny = recorder_.logicalOr(fitsAny, fits(label));
    for (const Statement* each : declarationsOf(child)) {
      const Type type = tree_.variables[each->index].type;
      store_.declare(slotOf(each->index), static_cast<std::size_t>(sizeOf(type)));
      set(slotOf(each->index), undefined(type));
    }
  }
  breakables_.push_back({broken, broken, true});
  Id reached = no;
  for (const StatementId child : statement.children) {
    const Statement& label = tree_.statements[child];
    if (label.kind == Statement::Kind::Case) {
      reached = recorder_.logicalOr(
          reached, label.expression == nothing ? recorder_.logicalNot(fitsAny) : fits(label));
      continue;
    }
    branch(
        recorder_.logicalAnd(reached, recorder_.logicalNot(stopCondition())),
        [&] {
          resume();
          const auto declarations = declarationsOf(child);
          for (const Statement* each : declarations) initialize(*each);
          if (declarations.empty()) execute(child);
        },
        [] {});
  }
  breakables_.pop_back();
}

}  // namespace warpjet::source

// Declarations of variables in functions, assignments, and calls as statements.
#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

StatementId Parser::declareLocal(const Token& name, Type type, Variable::Kind kind,
                                 ExpressionId start, bool isWritable) {
  if (problems_.any()) return nothing;
  if (type.length == 0 || type == voidType || type.base == Base::Sampler) {
    fail(name.location, quote(name.text) + " cannot be " + describe(type));
    return nothing;
  }
  const VariableId variable = addVariable(name.text, type, kind, name.location);
  tree_.variables[variable].start = start;
  const ExpressionId node = add({.kind = Code::Variable,
                                 .isAssignable = isWritable,
                                 .type = type,
                                 .index = variable,
                                 .location = name.location});
  declare(name, {.kind = Entity::Kind::Value,
                 .value = {.kind = isWritable ? Operand::Kind::Reference : Operand::Kind::Value,
                           .isWritable = isWritable,
                           .id = node,
                           .type = type}});
  return add({.kind = Statement::Kind::Declare,
              .index = variable,
              .expression = start,
              .location = name.location});
}

StatementId Parser::variableStatement() {
  take();
  if (accept("<")) {
    const Token space = take();
    if (!space.is("function"))
      fail(space.location, quote(space.text) + " is for variables outside of functions");
    expect(">", "the address space of a var");
  }
  const Token name = takeName("a variable");
  std::optional<DeclaredType> declared;
  if (accept(":")) declared = declaredType();
  if (declared && declared->isPointer) fail(name.location, "a pointer is a constant; write let");
  if (!accept("=")) {
    if (!declared) fail(name.location, quote(name.text) + " needs a type or a value");
    if (problems_.any()) return nothing;
    if (!declared->unsupported.empty()) fail(name.location, declared->unsupported);
    return declareLocal(name, declared->type, Variable::Kind::Local,
                        zero(declared->type, name.location).id, true);
  }
  const Operand start = value();
  if (problems_.any()) return nothing;
  if (start.isPointer()) fail(name.location, "a pointer is a constant; write let");
  const Type type = initialType(declared, start, name.location, name.text);
  return declareLocal(name, type, Variable::Kind::Local, convert(start, type, name.location), true);
}

// Fixes the place that a pointer refers to, as WGSL does when a pointer is made: returns the
// reference with each index stored in a variable, and appends their declarations to `before`.
Operand Parser::freeze(const Operand& reference, std::vector<StatementId>& before) {
  if (reference.id == nothing) return reference;
  Expression node = tree_.expressions[reference.id];
  if (node.kind != Code::Part && node.kind != Code::Element) return reference;
  Operand whole = reference;
  whole.id = node.operands[0];
  node.operands[0] = freeze(whole, before).id;
  if (node.kind == Code::Element && !constants_.isConstant(node.operands[1])) {
    const Type type = tree_.expressions[node.operands[1]].type;
    const VariableId index = addVariable("index", type, Variable::Kind::Local, node.location);
    before.push_back(add({.kind = Statement::Kind::Declare,
                          .index = index,
                          .expression = node.operands[1],
                          .location = node.location}));
    node.operands[1] =
        add({.kind = Code::Variable, .type = type, .index = index, .location = node.location});
  }
  Operand parsed = reference;
  parsed.id = add(std::move(node));
  return parsed;
}

StatementId Parser::letStatement() {
  take();
  const Token name = takeName("a let");
  std::optional<DeclaredType> declared;
  if (accept(":")) declared = declaredType();
  if (!accept("=")) fail(name.location, "the let " + quote(name.text) + " needs a value");
  Operand start = value();
  if (problems_.any()) return nothing;
  if (start.isPointer()) {
    if (declared && (!declared->isPointer || declared->type != start.type))
      fail(name.location, "expected " + describe(declared->type) + " as the value of " +
                              quote(name.text) + ", got " + describe(start));
    std::vector<StatementId> before;
    start = freeze(start, before);
    declare(name, {.kind = Entity::Kind::Value, .value = start});
    return makeBlock(name.location, std::move(before));
  }
  if (declared && declared->isPointer)
    fail(name.location,
         "expected a pointer as the value of " + quote(name.text) + ", got " + describe(start));
  const bool isHandle =
      start.type.base == Base::Sampler ||
      (start.type == voidType && tree_.expressions[start.id].kind == Code::Variable);
  if (isHandle) {
    declare(name, {.kind = Entity::Kind::Value, .value = start});
    return nothing;
  }
  const Type type = initialType(declared, start, name.location, name.text);
  return declareLocal(name, type, Variable::Kind::Local, convert(start, type, name.location),
                      false);
}

StatementId Parser::constStatement() {
  take();
  const Token name = takeName("a constant");
  std::optional<DeclaredType> declared;
  if (accept(":")) declared = declaredType();
  if (!accept("=")) fail(name.location, "the constant " + quote(name.text) + " needs a value");
  Operand start = value();
  StatementId parsed = nothing;
  declare(name, constant(name, declared, std::move(start), &parsed));
  return parsed;
}

// Parses a statement that a `for` may have in its head.
StatementId Parser::simpleStatement() {
  const Token token = peek();
  if (token.is("var")) return variableStatement();
  if (token.is("let")) return letStatement();
  if (token.is("const")) return constStatement();
  const bool isCall = token.kind == Token::Kind::Name && peek(1).is("(");
  if (!isCall) return assignment();
  const Entity known = resolve(token.text);
  const Operand parsed = value();
  if (problems_.any()) return nothing;
  if (peek().is("=") || !parsed.host.empty()) fail(peek().location, "a value cannot be assigned");
  const bool isUnsupported =
      parsed.id != nothing && tree_.expressions[parsed.id].kind == Code::Unsupported;
  if (known.kind != Entity::Kind::Function && !(isUnsupported && parsed.type == voidType) &&
      !token.text.starts_with("atomic"))
    fail(token.location,
         "the result of " + quote(token.text) + " must be used; write _ = before it");
  return evaluate(parsed.id, token.location);
}

StatementId Parser::assignment() {
  const Token start = peek();
  if (start.is("_") && peek(1).is("=")) {
    take();
    take();
    const Operand parsed = concrete(value(), start.location);
    return problems_.any() ? nothing : evaluate(parsed.id, start.location);
  }
  // People who know GLSL write `float x = 1.0;`.
  if (start.kind == Token::Kind::Name && peek(1).kind == Token::Kind::Name &&
      !isDeclared(start.text)) {
    fail(start.location, "expected a statement, got " + quote(start.text) +
                             "; WGSL declares a variable by let or var: write let " +
                             std::string(peek(1).text) + " = and its value");
    return nothing;
  }
  const Operand target = unary();
  const std::string_view symbol = peekOperator();
  const Location location = peek().location;
  if (problems_.any()) return nothing;
  const bool isStep = symbol == "++" || symbol == "--";
  const bool isPlain = symbol == "=";
  const OperatorRow* row = !isPlain && symbol.size() > 1 && symbol.back() == '='
                               ? findOperator(symbol.substr(0, symbol.size() - 1))
                               : nullptr;
  if (row && (row->level == 7 || row->level == 8)) row = nullptr;
  if (!isStep && !isPlain && !row) {
    fail(location, "expected = or another assignment, " + describeNext());
    return nothing;
  }
  takeOperator(symbol);
  const std::string name =
      target.id != nothing && tree_.expressions[target.id].kind == Code::Variable
          ? quote(tree_.variables[tree_.expressions[target.id].index].name)
          : "this";
  if (target.kind != Operand::Kind::Reference || !target.isWritable) {
    fail(location, target.isPointer()     ? "a pointer cannot be changed; write * before it"
                   : !target.host.empty() ? quote(target.host) +
                                                " is given by the host and cannot be "
                                                "changed"
                                          : name +
                                                " is a value and cannot be changed; copy it to a "
                                                "var first, or assign one component at a time");
    return nothing;
  }
  const Type type = target.type;
  if (isStep) {
    if (!type.isScalar() || !type.isInteger())
      fail(location, quote(symbol) + " does not take " + describe(type) + "; write += 1");
    return evaluate(add({.kind = Code::Increment,
                         .op = symbol == "++" ? Operator::Add : Operator::Subtract,
                         .type = type,
                         .index = 1,
                         .location = location,
                         .operands = {target.id}}),
                    location);
  }
  Operand given = value();
  if (problems_.any()) return nothing;
  ExpressionId right = nothing;
  if (isPlain) {
    if (!canConvert(given, type)) {
      fail(location, "expected " + describe(type) + ", got " + describe(given));
      return nothing;
    }
    right = convert(given, type, location);
  } else {
    // Only for its type and its converted right operand; the node itself is unused.
    const Operand parsed = makeBinary(row->op, target, given, location);
    if (problems_.any()) return nothing;
    if (parsed.type != type) {
      fail(location,
           quote(symbol) + " does not take " + describe(type) + " and " + describe(given));
      return nothing;
    }
    right = tree_.expressions[parsed.id].operands[1];
  }
  if (tree_.expressions[target.id].kind == Code::Unsupported) return evaluate(target.id, location);
  return evaluate(add({.kind = Code::Assign,
                       .op = row ? row->op : Operator{},
                       .isCombined = row != nullptr,
                       .type = type,
                       .location = location,
                       .operands = {target.id, right}}),
                  location);
}

}  // namespace warpjet::source::wgsl

// Declarations of variables.
#include "source/glsl/parser.hpp"

namespace warpjet::source::glsl {

// Parses `float x = 1.0, y;` from the first name on.
StatementId Parser::declarations(const Qualifiers& given, Type base) {
  const Location location = peek().location;
  std::vector<StatementId> all;
  do {
    const Token name = peek();
    if (!checkFree(name)) return nothing;
    take();
    if (peek().is("(")) {
      fail(name.location, "a function cannot be declared inside another one");
      return nothing;
    }
    if (base.isArray() && peek().is("[")) {
      fail(peek().location, "GLSL has no arrays of arrays");
      return nothing;
    }
    const Type each = peek().is("[") ? arrayOf(base) : base;
    all.push_back(declaration(given, each, name));
  } while (accept(","));
  expect(";", "a declaration");
  return all.size() == 1 ? all[0] : makeBlock(location, std::move(all));
}

StatementId Parser::declaration(const Qualifiers& given, Type type, const Token& name) {
  using enum Variable::Kind;
  const bool isGlobal = current_ == nothing;
  if (isGlobal) {
    checkGlobal(given, type, name.location);
  } else {
    allowOnly(given, {QualifierRole::Const, QualifierRole::Precision}, "a variable of a function");
    checkPrecision(given, type);
  }
  if (problems_.any()) return nothing;
  const GlobalKind global = kindOf(given);
  const Variable::Kind kind = isGlobal || global.kind == Constant ? global.kind : Local;
  ExpressionId start = nothing;
  if (accept("=")) {
    // The variable is added below, since it isn't visible in its own initializer.
    start = assignment();
    if (problems_.any()) return nothing;
    if (tree_.types.hasArray(typeOf(start)))
      requireVersion("an assignment of arrays", name.location);
    if (type.length == 0 && typeOf(start).isArray() && typeOf(start).element() == type.element())
      type = typeOf(start);
    if (kind == Uniform || kind == Attribute) {
      fail(name.location,
           "the host sets the value of " + quote(name.text) + "; remove its initializer");
    } else if (global.isOutput && isGlobal) {
      fail(name.location,
           "main sets the value of " + quote(name.text) + "; remove its initializer");
    } else if (typeOf(start) != type) {
      fail(name.location, "expected " + tree_.types.withArticle(type) + " as the value of " +
                              quote(name.text) + ", got " + tree_.types.withArticle(typeOf(start)) +
                              "; GLSL has no implicit conversions");
    } else {
      checkStart(kind, start, name);
    }
  } else if (given.isConst()) {
    fail(name.location, "the constant " + quote(name.text) + " needs a value");
  }
  if (type.length == 0) fail(name.location, "the array " + quote(name.text) + " needs a length");
  if (tree_.types.hasSampler(type) && (kind != Uniform || type != samplerType))
    fail(name.location, "an image can only be declared as a uniform sampler2D of its own");
  if (problems_.any()) return nothing;
  const VariableId variable = addVariable(name, type, kind);
  tree_.variables[variable].start = start;
  tree_.variables[variable].isOutput = isGlobal && global.isOutput;
  return add(Statement{.kind = Statement::Kind::Declare,
                       .index = variable,
                       .expression = start,
                       .location = name.location});
}

// Checks the initial value of a constant or a global; in 1.00 the initial value of a global may be
// a uniform or another global.
void Parser::checkStart(Variable::Kind kind, ExpressionId start, const Token& name) {
  using enum Variable::Kind;
  if (kind == Constant && !constants_.isConstant(start))
    return fail(name.location, quote(name.text) +
                                   " is const, but its value is known only when the "
                                   "shader runs; remove const");
  if (kind != Global) return;
  const auto isAllowed = [&](VariableId other) {
    const Variable::Kind otherKind = tree_.variables[other].kind;
    return text_.version != 300 && (otherKind == Global || otherKind == Uniform);
  };
  if (!constants_.isConstant(start, isAllowed))
    fail(name.location,
         "the initial value of a global variable must be known before the shader runs; "
         "assign " +
             quote(name.text) + " in a function");
}

}  // namespace warpjet::source::glsl

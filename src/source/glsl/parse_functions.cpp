// Functions: their heads, their parameters, and the check for recursion.
#include <algorithm>

#include "source/glsl/built_in_table.hpp"
#include "source/glsl/parser.hpp"
#include "source/glsl/versions.hpp"

namespace warpjet::source::glsl {

namespace {

using Role = QualifierRole;

std::string_view wordOf(const Parameter& parameter) {
  return parameter.isConst                                  ? "const"
         : parameter.direction == Parameter::Direction::In  ? "in"
         : parameter.direction == Parameter::Direction::Out ? "out"
                                                            : "inout";
}

// Describes how the parameters of two declarations of a function differ; empty if they don't.
std::string differenceOf(const Function& before, const Function& now) {
  for (std::size_t i = 0; i < now.parameters.size(); ++i) {
    const std::string_view oldWord = wordOf(before.parameters[i]);
    const std::string_view newWord = wordOf(now.parameters[i]);
    if (oldWord != newWord)
      return "parameter " + std::to_string(i + 1) + " of " + quote(now.name) + " was declared " +
             std::string(oldWord) + " before, and is " + std::string(newWord) +
             " here; make both declarations equal";
  }
  return {};
}

}  // namespace

void Parser::function(const Qualifiers& given, Type result, const Token& name) {
  allowOnly(given, {QualifierRole::Precision}, "a function");
  checkPrecision(given, result);
  if (problems_.any()) return;
  if (!scope_.isGlobal())
    return fail(name.location, "a function cannot be declared inside another one");
  const Meaning known = scope_.find(name.text);
  if (known.kind != Meaning::Kind::Function && !checkFree(name)) return;
  if (isBuiltIn(builtIns, name.text) && versionProblem(text_.version, name.text).empty())
    requireVersion("a function with the name of a built-in one", name.location);
  if (result.length == 0)
    return fail(name.location, "an array returned by a function needs a length");
  if (tree_.types.hasArray(result))
    requireVersion("an array returned by a function", name.location);
  if (tree_.types.hasSampler(result))
    return fail(name.location, "a function cannot return an image; return the result of texture()");
  if (tree_.types.size(result) > maxValueSize)
    return fail(name.location, "the result of " + quote(name.text) + " is too large");
  take();
  scope_.open();
  Function made{name.text, result, parameters(), name.location};
  expect(")", "the parameters of a function");
  if (made.name == "main" && (result != voidType || !made.parameters.empty()))
    fail(name.location, "main has no parameters and returns nothing: write void main()");
  if (redefines(made))
    fail(name.location, quote(name.text) + " is a built-in function; give yours another name");
  if (!problems_.any()) {
    const FunctionId number = declareFunction(made);
    if (!problems_.any() && !accept(";")) {
      current_ = number;
      hasReturn_ = false;
      const StatementId body = block();
      if (result != voidType && !hasReturn_)
        fail(name.location, "expected " + quote(name.text) + " to return " +
                                tree_.types.withArticle(result) +
                                ", but it has no return statement");
      if (number != nothing && !problems_.any()) tree_.functions[number].body = body;
      current_ = nothing;
    }
  }
  scope_.close();
}

std::vector<Parameter> Parser::parameters() {
  std::vector<Parameter> all;
  if (peek().is(")")) return all;
  if (peek().is("void") && peek(1).is(")")) {
    take();
    return all;
  }
  do {
    const Qualifiers given = qualifiers();
    const Location location = peek().location;
    const std::string_view storage = given.word(Role::Storage);
    allowOnly(given, {Role::Const, Role::Storage, Role::Precision}, "a parameter");
    if (!storage.empty() && storage != "in" && storage != "out" && storage != "inout")
      fail(location, quote(storage) + " is not allowed before a parameter; remove it");
    if (peek().is("struct"))
      fail(location, "a structure cannot be declared here; declare it above");
    const auto direction = storage == "out"     ? Parameter::Direction::Out
                           : storage == "inout" ? Parameter::Direction::InOut
                                                : Parameter::Direction::In;
    Type each = type();
    checkPrecision(given, each);
    Token name = peek();
    if (name.kind == Kind::Name) {
      take();
    } else {
      name.text = {};
    }
    if (peek().is("[")) each = arrayOf(each);
    if (problems_.any()) break;
    if (each.base == Base::Void || each.length == 0) {
      fail(location, "a parameter cannot be " + tree_.types.name(each));
      break;
    }
    if (!name.text.empty() && !checkFree(name)) break;
    if (tree_.types.hasSampler(each) && direction != Parameter::Direction::In) {
      fail(location, "an image can only be read; remove out or inout");
      break;
    }
    if (given.isConst() && direction != Parameter::Direction::In) {
      fail(location, "a parameter cannot be both const and " + std::string(storage));
      break;
    }
    const VariableId variable = addVariable(
        name, each, given.isConst() ? Variable::Kind::Constant : Variable::Kind::Parameter);
    all.push_back({direction, variable, each, given.isConst()});
  } while (accept(","));
  return all;
}

// Returns true for a built-in function with the same parameters; in 3.00 the name alone is
// rejected.
bool Parser::redefines(const Function& made) const {
  std::vector<Type> types;
  for (const Parameter& each : made.parameters) types.push_back(each.type);
  const auto found = findBuiltIn(builtIns, made.name, types);
  if (!found) return false;
  const BuiltIn& row = builtIns[static_cast<std::size_t>(found->row)];
  return versionProblem(100, builtInFeature(row)).empty() && versionProblem(100, row.name).empty();
}

FunctionId Parser::declareFunction(const Function& made) {
  const auto isSame = [&](const Function& other) {
    return other.parameters.size() == made.parameters.size() &&
           std::equal(other.parameters.begin(), other.parameters.end(), made.parameters.begin(),
                      [](const Parameter& a, const Parameter& b) { return a.type == b.type; });
  };
  const bool isDefinition = peek().is("{");
  for (const FunctionId i : overloads_[made.name]) {
    Function& other = tree_.functions[i];
    if (!isSame(other)) continue;
    if (other.type != made.type) {
      fail(made.location, quote(made.name) + " was declared before with another result, " +
                              tree_.types.withArticle(other.type));
    } else if (std::string why = differenceOf(other, made); !why.empty()) {
      fail(made.location, std::move(why));
    } else if (!isDefinition && other.body == nothing && text_.version == 100) {
      fail(made.location, quote(made.name) + " is already declared; remove this line");
    } else if (isDefinition && other.body != nothing) {
      fail(made.location, quote(made.name) + " already has a body for these parameters");
    } else if (isDefinition) {
      other = made;
    }
    return i;
  }
  tree_.functions.push_back(made);
  const auto index = static_cast<FunctionId>(tree_.functions.size() - 1);
  overloads_[made.name].push_back(index);
  // Adds the name to the scope outside of its parameters.
  scope_.close();
  if (scope_.find(made.name).kind != Meaning::Kind::Function)
    scope_.add(made.name, {Meaning::Kind::Function, nothing});
  scope_.open();
  for (const Parameter& parameter : made.parameters)
    scope_.add(tree_.variables[parameter.variable].name,
               {Meaning::Kind::Variable, parameter.variable});
  return index;
}

// Fails for a call of a function without a body.
void Parser::rejectMissing() {
  for (const FunctionCall& call : calls_)
    if (const Function& function = tree_.functions[call.to]; function.body == nothing)
      return fail(call.location, quote(function.name) + " is declared, but has no body");
}

void Parser::rejectRecursion() {
  if (const auto call = findRecursion(tree_.functions.size(), calls_))
    fail(call->location, quote(tree_.functions[call->to].name) +
                             " calls itself, which shaders do not support; write a loop");
}

}  // namespace warpjet::source::glsl

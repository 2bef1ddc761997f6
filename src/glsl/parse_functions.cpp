// Functions: their heads, their parameters, and that none calls itself.
#include <algorithm>

#include "glsl/builtins.hpp"
#include "glsl/parser.hpp"
#include "glsl/versions.hpp"

namespace warpjet::glsl {

void Parser::function(Type result, const Token& name) {
  if (!scope_.isGlobal()) return fail(name.place, "a function cannot stand inside another one");
  const Meaning known = scope_.find(name.text);
  if (known.kind != Meaning::Kind::Function && !checkFree(name)) return;
  if (isBuiltIn(name.text) && versionProblem(text_.version, name.text).empty())
    requireVersion("a function with the name of a built-in one", name.place);
  if (result.length == 0) return fail(name.place, "the array that a function gives needs a length");
  if (tree_.types.hasArray(result)) requireVersion("an array that a function gives", name.place);
  if (tree_.types.hasSampler(result))
    return fail(name.place, "a function cannot give an image; give what texture() reads of it");
  if (tree_.types.size(result) > largestValue)
    return fail(name.place, "what " + quoted(name.text) + " gives is too large");
  take();
  scope_.open();
  Function made{name.text, result, parameters(), name.place};
  expect(")", "the parameters of a function");
  if (!problems_.any()) {
    const FunctionId number = declareFunction(made);
    if (!problems_.any() && !accept(";")) {
      current_ = number;
      const StatementId body = block();
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
    const Location place = peek().place;
    Type each = type();
    Token name = peek();
    if (name.kind == Kind::Name) {
      take();
    } else {
      name.text = {};
    }
    if (peek().is("[")) each = arrayOf(each);
    if (problems_.any()) break;
    if (each == voidType || each.length == 0) {
      fail(place, "a parameter cannot be " + tree_.types.name(each));
      break;
    }
    if (!name.text.empty() && !checkFree(name)) break;
    if (tree_.types.hasSampler(each) && given.direction != Parameter::Direction::In) {
      fail(place, "an image can only be read; leave out and inout away");
      break;
    }
    if (given.isConst && given.direction != Parameter::Direction::In) {
      fail(place, "a parameter cannot be both const and " +
                      std::string(given.direction == Parameter::Direction::Out ? "out" : "inout"));
      break;
    }
    const VariableId variable = addVariable(
        name, each, given.isConst ? Variable::Kind::Constant : Variable::Kind::Parameter);
    all.push_back({given.direction, variable, each});
  } while (accept(","));
  return all;
}

FunctionId Parser::declareFunction(const Function& made) {
  const auto isSame = [&](const Function& other) {
    return other.name == made.name && other.parameters.size() == made.parameters.size() &&
           std::equal(other.parameters.begin(), other.parameters.end(), made.parameters.begin(),
                      [](const Parameter& a, const Parameter& b) { return a.type == b.type; });
  };
  const bool isDefinition = peek().is("{");
  for (std::size_t i = 0; i < tree_.functions.size(); ++i) {
    Function& other = tree_.functions[i];
    if (!isSame(other)) continue;
    const auto directions = [](const Parameter& a, const Parameter& b) {
      return a.direction == b.direction;
    };
    if (other.type != made.type || !std::equal(other.parameters.begin(), other.parameters.end(),
                                               made.parameters.begin(), directions)) {
      fail(made.place, quoted(made.name) + " was declared otherwise before");
    } else if (isDefinition && other.body != nothing) {
      fail(made.place, quoted(made.name) + " has a body with these parameters already");
    } else if (isDefinition) {
      other = made;
    }
    return static_cast<FunctionId>(i);
  }
  tree_.functions.push_back(made);
  const auto index = static_cast<FunctionId>(tree_.functions.size() - 1);
  // Of the scope outside of its parameters.
  scope_.close();
  if (scope_.find(made.name).kind != Meaning::Kind::Function)
    scope_.add(made.name, {Meaning::Kind::Function, nothing});
  scope_.open();
  for (const Parameter& parameter : made.parameters)
    scope_.add(tree_.variables[parameter.variable].name,
               {Meaning::Kind::Variable, parameter.variable});
  return index;
}

// Functions that are reached from themselves. Each function is looked at once.
void Parser::refuseRecursion() {
  enum class State : std::uint8_t { New, Open, Done };
  std::vector<State> states(tree_.functions.size(), State::New);
  std::vector<std::vector<std::size_t>> from(tree_.functions.size());
  for (std::size_t i = 0; i < calls_.size(); ++i) from[calls_[i].from].push_back(i);
  for (std::size_t root = 0; root < states.size(); ++root) {
    if (states[root] != State::New) continue;
    std::vector<std::pair<std::size_t, std::size_t>> way{{root, 0}};
    states[root] = State::Open;
    while (!way.empty()) {
      auto& [function, next] = way.back();
      if (next == from[function].size()) {
        states[function] = State::Done;
        way.pop_back();
        continue;
      }
      const Call& call = calls_[from[function][next++]];
      if (states[call.to] == State::Open) {
        return fail(call.place, quoted(tree_.functions[call.to].name) +
                                    " calls itself, which no shader can; write a loop");
      }
      if (states[call.to] == State::New) {
        states[call.to] = State::Open;
        way.push_back({static_cast<std::size_t>(call.to), 0});
      }
    }
  }
}

}  // namespace warpjet::glsl

// Tokens, types, and what stands above functions.
#include "glsl/parser.hpp"

#include <algorithm>

#include "glsl/builtins.hpp"
#include "glsl/constants.hpp"
#include "glsl/keywords.hpp"
#include "glsl/versions.hpp"

namespace warpjet::glsl {

namespace {

constexpr std::int32_t longestArray = 4096;

}  // namespace

Parser::Parser(Preprocessed text, Problems& problems)
    : text_(std::move(text)), problems_(problems), end_(text_.tokens.back()) {
  tree_.made = std::move(text_.made);
}

const Token& Parser::peek(std::size_t ahead) const {
  return problems_.any() || at_ + ahead >= text_.tokens.size() ? end_ : text_.tokens[at_ + ahead];
}

const Token& Parser::take() {
  const Token& token = peek();
  if (at_ + 1 < text_.tokens.size()) ++at_;
  return token;
}

bool Parser::accept(std::string_view text) {
  if (!peek().is(text)) return false;
  take();
  return true;
}

std::string Parser::found() const {
  return peek().kind == Kind::End ? "the text ends here" : quoted(peek().text) + " stands here";
}

bool Parser::expect(std::string_view text, std::string_view after) {
  if (accept(text)) return true;
  fail(peek().place,
       "a " + std::string(text) + " is missing after " + std::string(after) + "; " + found());
  return false;
}

void Parser::requireVersion(std::string_view what, Location place) {
  std::string problem = versionProblem(text_.version, what);
  if (!problem.empty()) fail(place, std::move(problem));
}

std::string_view Parser::takeName(std::string_view what) {
  if (peek().kind != Kind::Name || isKeyword(peek().text, text_.version)) {
    fail(peek().place, "a name is missing for " + std::string(what) + "; " + found());
    return {};
  }
  return take().text;
}

bool Parser::goDeeper() {
  if (depth_ < deepest) return true;
  fail(peek().place, "this is nested more than " + std::to_string(deepest) + " deep");
  return false;
}

Tree Parser::parse() {
  using enum Variable::Kind;
  struct BuiltInVariable {
    std::string_view name;
    Type type;
    Variable::Kind kind;
  };
  for (const auto& [name, type, kind] :
       {BuiltInVariable{"gl_Position", vectorType(Base::Float, 4), Global},
        {"gl_PointSize", floatType, Global},
        {"gl_VertexID", intType, Attribute},
        {"gl_InstanceID", intType, Attribute},
        {"gl_FragColor", vectorType(Base::Float, 4), Global},
        {"gl_FragCoord", vectorType(Base::Float, 4), Fragment}}) {
    const auto isMeant = [&name = name](const Token& token) { return token.text == name; };
    if (std::none_of(text_.tokens.begin(), text_.tokens.end(), isMeant)) continue;
    Token token = end_;
    token.text = name;
    addVariable(token, type, kind);
  }
  while (peek().kind != Kind::End) global();
  if (!problems_.any()) refuseRecursion();
  return std::move(tree_);
}

void Parser::global() {
  if (accept(";")) return;
  if (accept("precision")) {
    if (!accept("highp") && !accept("mediump") && !accept("lowp"))
      fail(peek().place, "a precision is missing, such as highp; " + found());
    // An image of any kind has one, though it may not be read here.
    if (peek().text.find("sampler") != std::string_view::npos) {
      take();
    } else {
      type();
    }
    expect(";", "a precision");
    return;
  }
  // `invariant gl_Position;` asks the driver for care with what is declared already.
  if (peek().is("invariant") && (peek(2).is(";") || peek(2).is(","))) {
    while (peek().kind != Kind::End && !accept(";")) take();
    return;
  }
  const Qualifiers given = qualifiers();
  if (given.any && accept(";")) return;
  const Location place = peek().place;
  const Type base = type();
  if (problems_.any()) return;
  if (base.isStruct() && accept(";")) return;
  const Token& name = peek();
  if (name.kind == Kind::Name && peek(1).is("(")) {
    take();
    function(base, name);
    return;
  }
  if (base == voidType) return fail(place, "a variable cannot be void");
  tree_.globals.push_back(declarations(given, base));
}

Parser::Qualifiers Parser::qualifiers() {
  using enum Variable::Kind;
  Qualifiers found;
  const auto set = [&](Variable::Kind kind) { found.kind = kind; };
  for (;; take(), found.any = true) {
    const Token& token = peek();
    if (isDeclared(token)) return found;
    if (token.is("const")) {
      found.isConst = true;
    } else if (token.is("uniform")) {
      set(Uniform);
    } else if (token.is("attribute") || token.is("in")) {
      set(Attribute);
      found.direction = Parameter::Direction::In;
    } else if (token.is("out") || token.is("varying")) {
      set(Global);
      found.direction = Parameter::Direction::Out;
    } else if (token.is("inout")) {
      found.direction = Parameter::Direction::InOut;
    } else if (token.is("layout")) {
      take();
      expect("(", "layout");
      while (!peek().is(")") && peek().kind != Kind::End) take();
    } else if (!token.is("highp") && !token.is("mediump") && !token.is("lowp") &&
               !token.is("invariant") && !token.is("flat") && !token.is("smooth") &&
               !token.is("centroid")) {
      return found;
    }
    requireVersion(token.text, token.place);
    if (scope_.isGlobal() && token.is("in"))
      requireVersion("in before a global variable", token.place);
    if (scope_.isGlobal() && token.is("out"))
      requireVersion("out before a global variable", token.place);
  }
}

bool Parser::isDeclared(const Token& token) const {
  return scope_.find(token.text).kind != Meaning::Kind::None;
}

bool Parser::startsType() const {
  const Token& token = peek();
  if (token.kind != Kind::Name) return false;
  if (isDeclared(token)) return scope_.find(token.text).kind == Meaning::Kind::Structure;
  return token.is("struct") || findType(token.text);
}

Type Parser::type() {
  if (accept("struct")) return structure();
  const Token& word = peek();
  Type found;
  if (scope_.find(word.text).kind == Meaning::Kind::Structure) {
    found.base = Base::Struct;
    found.structure = static_cast<std::uint16_t>(scope_.find(word.text).index);
  } else if (const NamedType* row = findType(word.text); row && word.kind == Kind::Name) {
    requireVersion(word.text, word.place);
    found = row->type;
  } else {
    const bool isOther = word.kind == Kind::Name && word.text.find("sampler") != word.text.npos;
    fail(word.place, isOther ? quoted(word.text) + " cannot be read in a warp; only sampler2D can"
                             : "a type was expected; " + this->found());
    return voidType;
  }
  take();
  if (!peek().is("[")) return found;
  const Location place = peek().place;
  const Type array = arrayOf(found);
  // What a function gives has it nowhere else.
  if (!peek(1).is("(")) requireVersion("the length of an array before its name", place);
  return array;
}

Type Parser::arrayOf(Type element) {
  const Location place = take().place;
  if (element.isArray()) fail(place, "an array of arrays is not in the language");
  Type array = element;
  array.length = 0;
  if (peek().is("]")) {
    requireVersion("an array without a length", place);
  } else {
    const ExpressionId size = expression();
    if (problems_.any()) return element;
    const auto length = constantInt(tree_, size);
    if (!length || *length < 1 || *length > longestArray) {
      fail(place, "the length of an array must be a constant whole number from 1 to " +
                      std::to_string(longestArray));
      return element;
    }
    array.length = *length;
  }
  expect("]", "the length of an array");
  if (peek().is("[")) fail(peek().place, "an array of arrays is not in the language");
  return array;
}

Type Parser::structure() {
  Structure made;
  const Token& name = peek();
  if (name.kind == Kind::Name) {
    if (!checkFree(name)) return voidType;
    made.name = take().text;
  }
  expect("{", "struct");
  while (!peek().is("}") && peek().kind != Kind::End) {
    qualifiers();
    const Type base = type();
    do {
      const Location place = peek().place;
      const std::string_view field = takeName("a field");
      const Type each = peek().is("[") ? arrayOf(base) : base;
      if (each == voidType || each.length == 0)
        fail(place, "a field of a structure cannot be " + tree_.types.name(each));
      if (made.find(field)) fail(place, quoted(field) + " is a field of this structure already");
      if (problems_.any()) return voidType;
      made.fields.push_back({field, each, made.size});
      made.size += tree_.types.size(each);
      if (made.size > largestValue) fail(place, "this structure is too large");
    } while (accept(","));
    expect(";", "a field");
  }
  const Location end = peek().place;
  expect("}", "the fields of a structure");
  if (made.fields.empty()) fail(end, "a structure must have a field");
  if (problems_.any()) return voidType;
  Type type;
  type.base = Base::Struct;
  type.structure = tree_.types.add(made);
  if (!made.name.empty()) scope_.add(made.name, {Meaning::Kind::Structure, type.structure});
  return type;
}

bool Parser::checkFree(const Token& name) {
  if (name.kind != Kind::Name) {
    fail(name.place, "a name is missing here; " + found());
  } else if (isKeyword(name.text, text_.version)) {
    fail(name.place, quoted(name.text) + " cannot be a name: it is a word of the language");
  } else if (name.text.starts_with("gl_")) {
    fail(name.place, quoted(name.text) + " cannot be a name: those with gl_ are the language's");
  } else if (!scope_.isFree(name.text)) {
    fail(name.place, quoted(name.text) + " is declared here already");
  }
  return !problems_.any();
}

VariableId Parser::addVariable(const Token& name, Type type, Variable::Kind kind) {
  const int size = tree_.types.size(type);
  if (size > largestValue) {
    fail(name.place, quoted(name.text) + " is too large");
  } else if ((held_ += size) > mostHeld) {
    fail(name.place, "the variables of this text are too large together");
  } else if (kind == Variable::Kind::Uniform || kind == Variable::Kind::Attribute) {
    // Even if each is a float.
    if ((heldOutside_ += type.isNumeric() ? 1 : size) > largestValue)
      fail(name.place, "this text has too much from outside: more than 65,536 uniforms");
  }
  const auto index = static_cast<VariableId>(tree_.variables.size());
  tree_.variables.push_back({name.text, type, name.place, kind});
  scope_.add(name.text, {Meaning::Kind::Variable, index});
  return index;
}

}  // namespace warpjet::glsl

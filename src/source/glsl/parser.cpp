// Tokens, types, and global declarations.
#include "source/glsl/parser.hpp"

#include "source/glsl/built_in_table.hpp"
#include "source/glsl/keywords.hpp"
#include "source/glsl/versions.hpp"

namespace warpjet::source::glsl {

namespace {

constexpr std::int32_t maxArrayLength = 4096;

}  // namespace

Parser::Parser(PreprocessedSource text, Problems& problems)
    : text_(std::move(text)), problems_(problems), end_(text_.tokens.back()) {
  tree_.builtIns = builtIns;
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

std::string Parser::describeNext() const {
  return peek().kind == Kind::End ? "got the end of the source" : "got " + quote(peek().text);
}

bool Parser::expect(std::string_view text, std::string_view after) {
  if (accept(text)) return true;
  fail(peek().location,
       "expected " + std::string(text) + " after " + std::string(after) + ", " + describeNext());
  return false;
}

void Parser::requireVersion(std::string_view what, Location location) {
  std::string problem = versionProblem(text_.version, what);
  if (!problem.empty()) fail(location, std::move(problem));
}

std::string_view Parser::takeName(std::string_view what) {
  if (peek().kind != Kind::Name || isKeyword(peek().text, text_.version)) {
    fail(peek().location, "expected a name for " + std::string(what) + ", " + describeNext());
    return {};
  }
  return take().text;
}

bool Parser::checkDepth() {
  if (depth_ < maxDepth) return true;
  fail(peek().location, "this is nested more than " + std::to_string(maxDepth) + " deep");
  return false;
}

Tree Parser::parse() {
  if (text_.version) findStage();
  declareBuiltIns();
  while (peek().kind != Kind::End) global();
  if (!problems_.any()) rejectRecursion();
  if (!problems_.any()) rejectMissing();
  return std::move(tree_);
}

void Parser::global() {
  // Without #version, where no browser is meant to read the source unchanged, a stray ; after a
  // function is tolerated.
  if (text_.version == 0 && accept(";")) return;
  if (peek().is("precision")) return precision();
  if (peek().is("invariant") && peek(2).is(";")) return invariant();
  const Qualifiers given = qualifiers();
  if (given.word(QualifierRole::Storage) == "uniform" && given.isForBlocks && accept(";")) return;
  if (given.any() && startsBlock()) return uniformBlock(given);
  const Location location = peek().location;
  const Type base = type();
  if (problems_.any()) return;
  if (accept(";")) return checkPrecision(given, base);
  const Token& name = peek();
  if (name.kind == Kind::Name && peek(1).is("(")) {
    take();
    function(given, base, name);
    return;
  }
  if (base == voidType) return fail(location, "a variable cannot be void");
  tree_.globals.push_back(declarations(given, base));
}

bool Parser::isDeclared(const Token& token) const {
  return scope_.find(token.text).kind != Meaning::Kind::None;
}

bool Parser::startsType(std::size_t ahead) const {
  const Token& token = peek(ahead);
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
    requireVersion(word.text, word.location);
    found = row->type;
  } else {
    const bool isOther = word.kind == Kind::Name && word.text.find("sampler") != word.text.npos;
    fail(word.location, isOther ? quote(word.text) + " cannot be read in a warp; only sampler2D can"
                                : "expected a type, " + this->describeNext() +
                                      (word.is("fn") ? "; this looks like WGSL, which wgslOffset "
                                                       "reads, and differentiate with the option "
                                                       "language: 'wgsl'"
                                                     : ""));
    return voidType;
  }
  take();
  if (!peek().is("[")) return found;
  const Location location = peek().location;
  const Type array = arrayOf(found);
  // The result type of a function has no other place for the length.
  if (!peek(1).is("(")) requireVersion("the length of an array before its name", location);
  return array;
}

Type Parser::arrayOf(Type element) {
  const Location location = take().location;
  if (element.isArray()) fail(location, "GLSL has no arrays of arrays");
  Type array = element;
  array.length = 0;
  if (peek().is("]")) {
    requireVersion("an array without a length", location);
  } else {
    const ExpressionId size = expression();
    if (problems_.any()) return element;
    const auto length = constants_.integer(size);
    if (!length || *length < 1 || *length > maxArrayLength) {
      fail(location, "the length of an array must be a constant whole number from 1 to " +
                         std::to_string(maxArrayLength));
      return element;
    }
    array.length = *length;
  }
  expect("]", "the length of an array");
  if (peek().is("[")) fail(peek().location, "GLSL has no arrays of arrays");
  return array;
}

Type Parser::structure() {
  Structure structure;
  const Token& name = peek();
  if (name.kind == Kind::Name) {
    if (!checkFree(name)) return voidType;
    structure.name = take().text;
  }
  expect("{", "struct");
  while (!peek().is("}") && peek().kind != Kind::End) {
    const Qualifiers given = qualifiers();
    allowOnly(given, {QualifierRole::Precision}, "a field of a structure");
    fields(given, structure);
  }
  const Location end = peek().location;
  expect("}", "the fields of a structure");
  if (structure.fields.empty()) fail(end, "a structure must have a field");
  if (problems_.any()) return voidType;
  Type type;
  type.base = Base::Struct;
  type.structure = tree_.types.add(structure);
  if (!structure.name.empty())
    scope_.add(structure.name, {Meaning::Kind::Structure, type.structure});
  return type;
}

// Parses `float x, y[2];` up to its semicolon.
void Parser::fields(const Qualifiers& given, Structure& structure) {
  if (peek().is("struct"))
    return fail(peek().location, "a structure cannot be declared inside another; declare it above");
  const Type base = type();
  checkPrecision(given, base);
  do {
    const Token name = peek();
    std::string why = name.kind == Kind::Name ? nameProblem(name.text, text_.version) : "";
    if (!why.empty()) fail(name.location, std::move(why));
    const std::string_view field = takeName("a field");
    if (base.isArray() && peek().is("[")) fail(peek().location, "GLSL has no arrays of arrays");
    const Type each = peek().is("[") ? arrayOf(base) : base;
    if (each == voidType || each.length == 0)
      fail(name.location, "a field cannot be " + tree_.types.name(each));
    if (structure.find(field))
      fail(name.location,
           quote(field) + (structure.isBlock ? " is already a member of this block"
                                             : " is already a field of this structure"));
    if (problems_.any()) return;
    structure.add({field, each, structure.size});
    structure.size += tree_.types.size(each);
    if (structure.size > maxValueSize) fail(name.location, "this structure is too large");
  } while (accept(","));
  expect(";", "a field");
}

bool Parser::checkFree(const Token& name) {
  if (name.kind != Kind::Name) {
    fail(name.location, "expected a name, " + describeNext());
  } else if (std::string why = nameProblem(name.text, text_.version); !why.empty()) {
    fail(name.location, std::move(why));
  } else if (!scope_.isFree(name.text)) {
    fail(name.location, quote(name.text) + " is already declared here");
  }
  return !problems_.any();
}

VariableId Parser::addVariable(const Token& name, Type type, Variable::Kind kind) {
  const int size = tree_.types.size(type);
  if (size > maxValueSize) {
    fail(name.location, quote(name.text) + " is too large");
  } else if ((totalSize_ += size) > maxHeld) {
    fail(name.location, "the variables of this source are too large in total");
  } else if (kind == Variable::Kind::Uniform || kind == Variable::Kind::Attribute) {
    // Numbers count as 1, so that the total is limited even if every input is a float.
    if ((inputSize_ += type.isNumeric() ? 1 : size) > maxValueSize)
      fail(name.location, "this source has too many inputs: more than 65,536 uniforms");
  }
  const auto index = static_cast<VariableId>(tree_.variables.size());
  tree_.variables.push_back({name.text, type, name.location, kind});
  scope_.add(name.text, {Meaning::Kind::Variable, index});
  return index;
}

}  // namespace warpjet::source::glsl

// Qualifiers of types: their order, and which of them each kind of declaration allows.
// GLSL ES 3.00, section 4.
#include <algorithm>
#include <array>

#include "glsl/keywords.hpp"
#include "glsl/parser.hpp"

namespace warpjet::glsl {

namespace {

using Role = QualifierRole;

struct QualifierRow {
  std::string_view word;
  Role role;
};

constexpr std::array rows{
    QualifierRow{"invariant", Role::Invariant},  QualifierRow{"flat", Role::Interpolation},
    QualifierRow{"smooth", Role::Interpolation}, QualifierRow{"layout", Role::Layout},
    QualifierRow{"const", Role::Const},          QualifierRow{"centroid", Role::Centroid},
    QualifierRow{"in", Role::Storage},           QualifierRow{"out", Role::Storage},
    QualifierRow{"inout", Role::Storage},        QualifierRow{"uniform", Role::Storage},
    QualifierRow{"attribute", Role::Storage},    QualifierRow{"varying", Role::Storage},
    QualifierRow{"highp", Role::Precision},      QualifierRow{"mediump", Role::Precision},
    QualifierRow{"lowp", Role::Precision},
};

// More than any machine has.
constexpr std::uint32_t mostLocations = 64;

}  // namespace

std::string_view Qualifiers::word(Role role) const {
  for (const Word& each : words)
    if (each.role == role) return each.text;
  return {};
}

Qualifiers Parser::qualifiers() {
  Qualifiers found;
  for (;;) {
    const Token token = peek();
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const QualifierRow& each) { return token.is(each.word); });
    if (row == rows.end() || isDeclared(token)) return found;
    requireVersion(token.text, token.place);
    if (scope_.isGlobal() && token.is("in"))
      requireVersion("in before a global variable", token.place);
    if (scope_.isGlobal() && token.is("out"))
      requireVersion("out before a global variable", token.place);
    for (const Qualifiers::Word& before : found.words) checkOrder(before, token, row->role);
    found.words.push_back({token.text, row->role, token.place});
    take();
    if (row->role == Role::Layout) layout(found);
  }
}

void Parser::checkOrder(const Qualifiers::Word& before, const Token& token, Role role) {
  if (before.text == token.text)
    return fail(token.place, quoted(token.text) + " stands here twice; take one away");
  if (before.role == role)
    return fail(token.place, quoted(before.text) + " and " + quoted(token.text) +
                                 " cannot stand together; take one away");
  if (before.role > role)
    fail(token.place, quoted(token.text) + " must stand before " + quoted(before.text) +
                          ": the order is invariant, flat or smooth, layout, const, centroid, in "
                          "or out or uniform, highp");
}

// Reads `(location = 0)`, or the memory layout of a block of uniforms.
void Parser::layout(Qualifiers& found) {
  expect("(", "layout");
  do {
    const Token name = peek();
    const std::string_view word = takeName("a layout");
    const bool isOfBlocks = word == "std140" || word == "shared" || word == "packed" ||
                            word == "row_major" || word == "column_major";
    if (word == "location") {
      found.hasLocation = true;
      expect("=", "location");
      const Token number = peek();
      const bool isNumber = number.kind == Kind::Int || number.kind == Kind::Uint;
      if (!isNumber || intValue(number, problems_) >= mostLocations)
        return fail(number.place, "a location is a whole number below " +
                                      std::to_string(mostLocations) + "; " + this->found());
      take();
    } else if (isOfBlocks) {
      found.isOfBlocks = true;
      found.isWhole = found.isWhole || !word.ends_with("_major");
    } else {
      fail(name.place, "there is no layout " + quoted(word) +
                           "; there are location, std140, shared, packed, row_major and "
                           "column_major");
    }
  } while (accept(","));
  expect(")", "layout");
}

// Fails at the first qualifier that has another role than these.
void Parser::allowOnly(const Qualifiers& given, std::initializer_list<Role> roles,
                       std::string_view where) {
  for (const Qualifiers::Word& each : given.words)
    if (std::find(roles.begin(), roles.end(), each.role) == roles.end())
      return fail(each.place, quoted(each.text) + " cannot stand before " + std::string(where) +
                                  "; take it away");
}

void Parser::checkPrecision(const Qualifiers& given, Type type) {
  const bool hasNone =
      type.base == Base::Bool || type.base == Base::Void || type.base == Base::Struct;
  for (const Qualifiers::Word& each : given.words)
    if (each.role == Role::Precision && hasNone)
      fail(each.place, tree_.types.withArticle(type) + " has no precision; take " +
                           quoted(each.text) + " away");
}

void Parser::checkGlobal(const Qualifiers& given, Type type, Location place) {
  const std::string_view storage = given.word(Role::Storage);
  const bool isOut = storage == "out" || storage == "varying";
  const bool isIn = storage == "in" || storage == "attribute";
  const auto refuse = [&](Role role, const std::string& why) {
    for (const Qualifiers::Word& each : given.words)
      if (each.role == role) fail(each.place, quoted(each.text) + " " + why);
  };
  if (storage == "inout") refuse(Role::Storage, "is for parameters; write in or out");
  if (given.isConst() && !storage.empty())
    refuse(Role::Const, "and " + quoted(storage) + " cannot stand together; take one away");
  if (!isOut)
    refuse(Role::Invariant, "is for what a vertex shader hands on, out or varying; take it away");
  if (!isOut && !isIn) {
    refuse(Role::Interpolation, "is for in and out; take it away");
    refuse(Role::Centroid, "is for in and out; take it away");
  }
  if (given.isOfBlocks || (given.hasLocation && !isOut && !isIn))
    refuse(Role::Layout, given.isOfBlocks ? "of this kind is for blocks of uniforms; take it away"
                                          : "with a location is for in and out; take it away");
  if (stage_ == Stage::Vertex && isIn) {
    refuse(Role::Interpolation, "is for out in a vertex shader; take it away");
    refuse(Role::Centroid, "is for out in a vertex shader; take it away");
  }
  if (stage_ == Stage::Vertex && isOut && given.hasLocation)
    refuse(Role::Layout, "with a location is for in in a vertex shader; take it away");
  checkPrecision(given, type);
  const auto refuseType = [&](bool isWrong, const std::string& why) {
    if (isWrong)
      fail(place,
           quoted(storage) + " cannot stand before " + tree_.types.withArticle(type) + "; " + why);
  };
  const bool isFloats = type.base == Base::Float;
  if (storage == "attribute") refuseType(!isFloats || type.isArray(), "take floats");
  if (storage == "varying") refuseType(!isFloats, "take floats");
  if (stage_ == Stage::Vertex && isIn)
    refuseType(type.isArray() || type.base == Base::Struct, "take numbers and vectors");
  const bool isFlat = given.word(Role::Interpolation) == "flat";
  const bool isHandedOn = (stage_ == Stage::Vertex && isOut) || (stage_ == Stage::Fragment && isIn);
  if (isHandedOn && !isFlat)
    refuseType(tree_.types.hasBase(type, Base::Int) || tree_.types.hasBase(type, Base::Uint),
               "write flat before it");
  if (isOut || isIn) refuseType(tree_.types.hasBase(type, Base::Bool), "take a number");
  if (storage == "out" && type.base == Base::Struct)
    refuseType(type.isArray() || tree_.types.hasArray(type) || tree_.types.hasNested(type),
               "take its fields one by one");
}

Parser::GlobalKind Parser::kindOf(const Qualifiers& given) {
  using enum Variable::Kind;
  const std::string_view storage = given.word(Role::Storage);
  if (given.isConst()) return {Constant};
  if (storage == "uniform") return {Uniform};
  if (storage == "attribute" || storage == "in") return {Attribute};
  return {Global, storage == "out" || storage == "varying"};
}

// `precision highp float;`
void Parser::precision() {
  take();
  if (!accept("highp") && !accept("mediump") && !accept("lowp"))
    fail(peek().place, "a precision is missing, such as highp; " + found());
  const Token word = peek();
  // An image of any kind has one, though it may not be read here.
  const bool isImage = word.kind == Kind::Name && word.text.find("sampler") != word.text.npos &&
                       !isReserved(word.text, text_.version);
  if (!isImage && !word.is("float") && !word.is("int"))
    fail(word.place,
         "float, int or an image such as sampler2D is missing after the precision; " + found());
  take();
  expect(";", "a precision");
}

// `invariant gl_Position;` asks the driver for care with what is declared already.
void Parser::invariant() {
  take();
  const Token name = peek();
  const Meaning meaning = scope_.find(name.text);
  if (meaning.kind != Meaning::Kind::Variable || !tree_.variables[meaning.index].isOutput)
    fail(name.place,
         "what stands after invariant must be declared above as out or varying, or be "
         "gl_Position; " +
             found());
  take();
  expect(";", "invariant");
}

}  // namespace warpjet::glsl

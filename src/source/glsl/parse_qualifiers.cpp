// Type qualifiers: their order, and which of them each kind of declaration allows. GLSL ES 3.00,
// section 4.
#include <algorithm>
#include <array>

#include "source/glsl/keywords.hpp"
#include "source/glsl/parser.hpp"

namespace warpjet::source::glsl {

namespace {

using Role = QualifierRole;

struct QualifierRow {
  std::string_view word;
  Role role;
};

constexpr std::array qualifierRows{
    QualifierRow{"invariant", Role::Invariant},  QualifierRow{"flat", Role::Interpolation},
    QualifierRow{"smooth", Role::Interpolation}, QualifierRow{"layout", Role::Layout},
    QualifierRow{"const", Role::Const},          QualifierRow{"centroid", Role::Centroid},
    QualifierRow{"in", Role::Storage},           QualifierRow{"out", Role::Storage},
    QualifierRow{"inout", Role::Storage},        QualifierRow{"uniform", Role::Storage},
    QualifierRow{"attribute", Role::Storage},    QualifierRow{"varying", Role::Storage},
    QualifierRow{"highp", Role::Precision},      QualifierRow{"mediump", Role::Precision},
    QualifierRow{"lowp", Role::Precision},
};

// More than any device has.
constexpr std::uint32_t maxLocations = 64;

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
    const auto row = std::find_if(qualifierRows.begin(), qualifierRows.end(),
                                  [&](const QualifierRow& each) { return token.is(each.word); });
    if (row == qualifierRows.end() || isDeclared(token)) return found;
    requireVersion(token.text, token.location);
    if (scope_.isGlobal() && token.is("in"))
      requireVersion("in before a global variable", token.location);
    if (scope_.isGlobal() && token.is("out"))
      requireVersion("out before a global variable", token.location);
    for (const Qualifiers::Word& before : found.words) checkOrder(before, token, row->role);
    found.words.push_back({token.text, row->role, token.location});
    take();
    if (row->role == Role::Layout) layout(found);
  }
}

void Parser::checkOrder(const Qualifiers::Word& before, const Token& token, Role role) {
  if (before.text == token.text)
    return fail(token.location, quote(token.text) + " occurs twice; remove one");
  if (before.role == role)
    return fail(token.location, quote(before.text) + " and " + quote(token.text) +
                                    " cannot be combined; remove one");
  if (before.role > role)
    fail(token.location,
         quote(token.text) + " must come before " + quote(before.text) +
             ": the order is invariant, flat or smooth, layout, const, centroid, in "
             "or out or uniform, highp");
}

// Parses `(location = 0)`, or the memory layout of a uniform block.
void Parser::layout(Qualifiers& found) {
  expect("(", "layout");
  do {
    const Token name = peek();
    const std::string_view word = takeName("a layout");
    const bool isForBlocks = word == "std140" || word == "shared" || word == "packed" ||
                             word == "row_major" || word == "column_major";
    if (word == "location") {
      found.hasLocation = true;
      expect("=", "location");
      const Token number = peek();
      const bool isNumber = number.kind == Kind::Int || number.kind == Kind::Uint;
      if (!isNumber || intValue(number, problems_) >= maxLocations)
        return fail(number.location, "expected a whole number below " +
                                         std::to_string(maxLocations) + " as location, " +
                                         this->describeNext());
      take();
    } else if (isForBlocks) {
      found.isForBlocks = true;
      found.isWhole = found.isWhole || !word.ends_with("_major");
    } else {
      fail(name.location, "there is no layout " + quote(word) +
                              "; the layouts are location, std140, shared, packed, row_major and "
                              "column_major");
    }
  } while (accept(","));
  expect(")", "layout");
}

// Fails for the first qualifier that has none of these roles.
void Parser::allowOnly(const Qualifiers& given, std::initializer_list<Role> roles,
                       std::string_view where) {
  for (const Qualifiers::Word& each : given.words)
    if (std::find(roles.begin(), roles.end(), each.role) == roles.end())
      return fail(each.location, quote(each.text) + " is not allowed before " + std::string(where) +
                                     "; remove it");
}

void Parser::checkPrecision(const Qualifiers& given, Type type) {
  const bool hasNone =
      type.base == Base::Bool || type.base == Base::Void || type.base == Base::Struct;
  for (const Qualifiers::Word& each : given.words)
    if (each.role == Role::Precision && hasNone)
      fail(each.location,
           tree_.types.withArticle(type) + " has no precision; remove " + quote(each.text));
}

void Parser::checkGlobal(const Qualifiers& given, Type type, Location location) {
  const std::string_view storage = given.word(Role::Storage);
  const bool isOut = storage == "out" || storage == "varying";
  const bool isIn = storage == "in" || storage == "attribute";
  const auto reject = [&](Role role, const std::string& why) {
    for (const Qualifiers::Word& each : given.words)
      if (each.role == role) fail(each.location, quote(each.text) + " " + why);
  };
  if (storage == "inout") reject(Role::Storage, "is for parameters; write in or out");
  if (given.isConst() && !storage.empty())
    reject(Role::Const, "and " + quote(storage) + " cannot be combined; remove one");
  if (!isOut)
    reject(Role::Invariant, "is for outputs of a vertex shader, out or varying; remove it");
  if (!isOut && !isIn) {
    reject(Role::Interpolation, "is for in and out; remove it");
    reject(Role::Centroid, "is for in and out; remove it");
  }
  if (given.isForBlocks || (given.hasLocation && !isOut && !isIn))
    reject(Role::Layout, given.isForBlocks ? "of this kind is for blocks of uniforms; remove it"
                                           : "with a location is for in and out; remove it");
  if (stage_ == Stage::Vertex && isIn) {
    reject(Role::Interpolation, "is for out in a vertex shader; remove it");
    reject(Role::Centroid, "is for out in a vertex shader; remove it");
  }
  if (stage_ == Stage::Vertex && isOut && given.hasLocation)
    reject(Role::Layout, "with a location is for in in a vertex shader; remove it");
  checkPrecision(given, type);
  const auto rejectTypeIf = [&](bool isInvalid, const std::string& why) {
    if (isInvalid)
      fail(location,
           quote(storage) + " is not allowed before " + tree_.types.withArticle(type) + "; " + why);
  };
  const bool isFloats = type.base == Base::Float;
  if (storage == "attribute") rejectTypeIf(!isFloats || type.isArray(), "use floats");
  if (storage == "varying") rejectTypeIf(!isFloats, "use floats");
  if (stage_ == Stage::Vertex && isIn)
    rejectTypeIf(type.isArray() || type.base == Base::Struct, "use numbers and vectors");
  const bool isFlat = given.word(Role::Interpolation) == "flat";
  const bool isInterpolated =
      (stage_ == Stage::Vertex && isOut) || (stage_ == Stage::Fragment && isIn);
  if (isInterpolated && !isFlat)
    rejectTypeIf(tree_.types.hasBase(type, Base::Int) || tree_.types.hasBase(type, Base::Uint),
                 "write flat before it");
  if (isOut || isIn) rejectTypeIf(tree_.types.hasBase(type, Base::Bool), "use a number");
  if (storage == "out" && type.base == Base::Struct)
    rejectTypeIf(type.isArray() || tree_.types.hasArray(type) || tree_.types.hasNested(type),
                 "use its fields one by one");
}

Parser::GlobalKind Parser::kindOf(const Qualifiers& given) {
  using enum Variable::Kind;
  const std::string_view storage = given.word(Role::Storage);
  if (given.isConst()) return {Constant};
  if (storage == "uniform") return {Uniform};
  if (storage == "attribute" || storage == "in") return {Attribute};
  return {Global, storage == "out" || storage == "varying"};
}

// Parses `precision highp float;`.
void Parser::precision() {
  take();
  if (!accept("highp") && !accept("mediump") && !accept("lowp"))
    fail(peek().location, "expected a precision such as highp, " + describeNext());
  const Token word = peek();
  // All image types have a precision, even those that can't be read here.
  const bool isImage = word.kind == Kind::Name && word.text.find("sampler") != word.text.npos &&
                       !isReserved(word.text, text_.version);
  if (!isImage && !word.is("float") && !word.is("int"))
    fail(word.location,
         "expected float, int or an image type such as sampler2D after the precision, " +
             describeNext());
  take();
  expect(";", "a precision");
}

// Parses `invariant gl_Position;`, which redeclares a variable.
void Parser::invariant() {
  take();
  const Token name = peek();
  const Meaning meaning = scope_.find(name.text);
  if (meaning.kind != Meaning::Kind::Variable || !tree_.variables[meaning.index].isOutput)
    fail(name.location,
         "expected gl_Position, or a variable declared above as out or varying, after "
         "invariant, " +
             describeNext());
  take();
  expect(";", "invariant");
}

}  // namespace warpjet::source::glsl

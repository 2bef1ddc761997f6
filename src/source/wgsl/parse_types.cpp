// Types.
#include <algorithm>
#include <array>

#include "source/wgsl/parser.hpp"
#include "source/wgsl/scalar_names.hpp"

namespace warpjet::source::wgsl {

namespace {

constexpr std::int32_t maxArrayLength = 65536;

int digitOf(char c) { return c >= '2' && c <= '4' ? c - '0' : 0; }

// Returns the columns and rows of vec3 or mat2x3; zeros for other words. A suffix may follow.
std::array<int, 2> shapeOf(std::string_view word) {
  if (word.starts_with("vec") && word.size() >= 4 && digitOf(word[3])) return {1, digitOf(word[3])};
  if (word.starts_with("mat") && word.size() >= 6 && word[4] == 'x' && digitOf(word[3]) &&
      digitOf(word[5]))
    return {digitOf(word[3]), digitOf(word[5])};
  return {0, 0};
}

constexpr const char* noHalf = "f16 is not supported; write f32";

}  // namespace

// Returns the type that a word names without a template list: a scalar, or a type with a suffix,
// such as vec3f.
std::optional<Type> Parser::shorthand(std::string_view word) const {
  for (const ScalarName& each : scalarNames)
    if (each.word == word) return each.type;
  const auto [columns, rows] = shapeOf(word);
  if (columns == 0) return std::nullopt;
  const std::string_view suffix = word.substr(columns > 1 ? 6 : 4);
  for (const ScalarName& each : scalarNames) {
    if (suffix.size() != 1 || suffix[0] != each.suffix) continue;
    if (columns > 1)
      return each.type == floatType ? std::optional(matrixType(columns, rows)) : std::nullopt;
    return vectorType(each.type.base, rows);
  }
  return std::nullopt;
}

// Returns true for a word that a template list may follow: vec3, mat4x4, array, and so on.
bool Parser::isGenerator(std::string_view word) const {
  const auto [columns, rows] = shapeOf(word);
  return (columns && word.size() == (columns > 1 ? 6 : 4)) || word == "array" || word == "ptr" ||
         word == "atomic";
}

bool Parser::startsType(std::size_t ahead) {
  const Token& token = peek(ahead);
  if (token.kind != Token::Kind::Name) return false;
  if (isDeclared(token.text)) return resolve(token.text).kind == Entity::Kind::Type;
  return isGenerator(token.text) || shorthand(token.text).has_value();
}

Type Parser::vectorOrMatrix(const Token& word) {
  const auto [columns, rows] = shapeOf(word.text);
  if (!expect("<", word.text)) return floatType;
  const Location location = peek().location;
  if (peek().is("f16")) fail(location, noHalf);
  const Type scalar = type();
  expect(">", "the type in " + std::string(word.text) + "<");
  if (problems_.any()) return floatType;
  if (!scalar.isScalar() || (columns > 1 && scalar != floatType)) {
    fail(location, "expected " + std::string(columns > 1 ? "f32" : "f32, i32, u32 or bool") +
                       " in " + std::string(word.text) + "< >, got " + nameOf(scalar));
    return floatType;
  }
  return columns > 1 ? matrixType(columns, rows) : vectorType(scalar.base, rows);
}

// Parses the constant length of an array, in a template list.
std::int32_t Parser::arrayLength() {
  const Location location = peek().location;
  Operand length = load(additive(unary()), location);
  if (problems_.any()) return 1;
  const auto known = constantInteger(length);
  if (!known || *known < 1 || *known > maxArrayLength) {
    fail(location, "the length of an array must be a constant whole number from 1 to " +
                       std::to_string(maxArrayLength));
    return 1;
  }
  return static_cast<std::int32_t>(*known);
}

// Returns the type of an array. An array of arrays is represented as an array of structures whose
// only field has no name.
Type Parser::arrayOf(Type element, std::int32_t length) {
  if (element.isArray()) {
    for (std::size_t i = 0; i < tree_.types.count(); ++i) {
      Type wrapped;
      wrapped.base = Base::Struct;
      wrapped.structure = static_cast<std::uint16_t>(i);
      const Structure& made = tree_.types.structure(wrapped);
      if (made.name.empty() && made.fields[0].type == element) {
        wrapped.length = length;
        return wrapped;
      }
    }
    Structure made;
    made.add({"", element, 0});
    made.size = tree_.types.size(element);
    Type wrapped;
    wrapped.base = Base::Struct;
    wrapped.structure = tree_.types.add(std::move(made));
    wrapped.length = length;
    return wrapped;
  }
  element.length = length;
  return element;
}

// Parses from `<` on. An array without a length has the length 0.
Type Parser::arrayType(Location location) {
  if (!expect("<", "array")) return floatType;
  const Type element = type();
  std::int32_t length = 0;
  if (accept(",") && !peek().is(">")) {
    length = arrayLength();
    accept(",");
  }
  expect(">", "the type of an array");
  if (problems_.any()) return floatType;
  if (element.length == 0) {
    fail(location, "the elements of an array need a length of their own");
    return floatType;
  }
  if (static_cast<std::int64_t>(tree_.types.size(element)) * length > maxValueSize)
    fail(location, "this array is too large");
  return arrayOf(element, length);
}

Parser::DeclaredType Parser::pointerType() {
  expect("<", "ptr");
  const Token word = take();
  const std::string_view space = word.text;
  constexpr std::array spaces{std::string_view("function"), std::string_view("private"),
                              std::string_view("workgroup"), std::string_view("uniform"),
                              std::string_view("storage")};
  if (std::find(spaces.begin(), spaces.end(), space) == spaces.end())
    fail(word.location, "there is no address space " + quote(space));
  expect(",", "the address space of a ptr");
  DeclaredType made = declaredType();
  std::string_view access;
  if (accept(",")) access = take().text;
  expect(">", "the type of a ptr");
  made.isPointer = true;
  made.space = space;
  made.isWritable = space == "function" || space == "private";
  if (space == "workgroup" || access == "read_write" || access == "write") {
    made.unsupported = "a pointer to memory that shaders share cannot be used in a warp";
    made.isWritable = true;
  }
  return made;
}

Parser::DeclaredType Parser::textureType(const Token& word) {
  DeclaredType made{samplerType};
  if (word.text.starts_with("sampler")) return {.type = voidType, .isSampler = true};
  made.texel = word.text.starts_with("texture_depth") ? floatType : vectorType(Base::Float, 4);
  if (accept("<")) {
    if (peek().is("i32") || peek().is("u32"))
      made.texel.base = peek().is("i32") ? Base::Int : Base::Uint;
    const bool isFloat = peek().is("f32");
    while (!accept(">") && peek().kind != Token::Kind::End) take();
    if (word.is("texture_2d") && isFloat) return made;
  }
  made.unsupported = quote(word.text) + " cannot be read in a warp; only texture_2d<f32> can";
  return made;
}

// Parses the type in a declaration: there, it may also be a pointer, a texture or a sampler.
Parser::DeclaredType Parser::declaredType() {
  const Token word = peek();
  if (word.kind != Token::Kind::Name || !checkDepth()) {
    fail(word.location, "expected a type, " + describeNext());
    return {floatType};
  }
  if (!isDeclared(word.text)) {
    if (word.is("ptr")) return take(), pointerType();
    if (word.text.starts_with("texture_") || word.is("sampler") || word.is("sampler_comparison"))
      return take(), textureType(word);
  } else if (Entity known = resolve(word.text); known.kind == Entity::Kind::Unsupported) {
    take();
    return {.type = floatType, .unsupported = known.reason};
  }
  return {type()};
}

Type Parser::type() {
  const Token word = peek();
  if (!checkDepth()) return floatType;
  return withDepth([&]() -> Type {
    if (word.kind != Token::Kind::Name) {
      fail(word.location, "expected a type, " + describeNext());
      return floatType;
    }
    take();
    if (isDeclared(word.text)) {
      const Entity known = resolve(word.text);
      if (known.kind == Entity::Kind::Type) return known.type;
      fail(word.location, known.kind == Entity::Kind::Unsupported
                              ? known.reason
                              : "expected a type, got " + quote(word.text));
      return floatType;
    }
    if (const auto found = shorthand(word.text)) return *found;
    if (word.is("array")) return arrayType(word.location);
    if (word.is("atomic")) {
      // Only memory that shaders share has atomics, which no warp can read.
      expect("<", "atomic");
      const Type made = type();
      expect(">", "the type of an atomic");
      return made;
    }
    if (word.is("ptr")) {
      fail(word.location, quote(word.text) + " is not allowed here");
      return floatType;
    }
    if (isGenerator(word.text)) return vectorOrMatrix(word);
    constexpr std::array<std::array<std::string_view, 2>, 12> glslTypes{{{"float", "f32"},
                                                                         {"int", "i32"},
                                                                         {"uint", "u32"},
                                                                         {"mat2", "mat2x2f"},
                                                                         {"mat3", "mat3x3f"},
                                                                         {"mat4", "mat4x4f"},
                                                                         {"ivec2", "vec2i"},
                                                                         {"ivec3", "vec3i"},
                                                                         {"ivec4", "vec4i"},
                                                                         {"uvec2", "vec2u"},
                                                                         {"uvec3", "vec3u"},
                                                                         {"uvec4", "vec4u"}}};
    for (const auto& [glsl, wgsl] : glslTypes)
      if (word.text == glsl) {
        fail(word.location, quote(glsl) + " is a type of GLSL; write " + std::string(wgsl));
        return floatType;
      }
    const bool isHalf = word.is("f16") || (shapeOf(word.text)[0] && word.text.ends_with("h"));
    fail(word.location,
         isHalf ? noHalf : "there is no type " + quote(word.text) + nearestName(word.text));
    return floatType;
  });
}

}  // namespace warpjet::source::wgsl

// GLSL types, and the structures that a source declares.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace warpjet::source {

enum class Base : std::uint8_t { Void, Bool, Int, Uint, Float, Sampler, Struct };

struct Type {
  Base base = Base::Void;
  // A vector has one column, whose rows are its components.
  std::uint8_t columns = 1, rows = 1;
  std::uint16_t structure = 0;
  // The length of an array; 0 if its initializer determines the length.
  std::int32_t length = notArray;

  static constexpr std::int32_t notArray = -1;

  bool operator==(const Type&) const = default;

  bool isArray() const { return length != notArray; }
  bool isNumeric() const { return !isArray() && base >= Base::Bool && base <= Base::Float; }
  bool isScalar() const { return isNumeric() && columns * rows == 1; }
  bool isVector() const { return isNumeric() && columns == 1 && rows > 1; }
  bool isMatrix() const { return isNumeric() && columns > 1; }
  bool isInteger() const { return isNumeric() && (base == Base::Int || base == Base::Uint); }
  bool isFloat() const { return isNumeric() && base == Base::Float; }
  bool isBool() const { return isScalar() && base == Base::Bool; }
  bool isStruct() const { return !isArray() && base == Base::Struct; }
  // Returns the number of components of a scalar, vector or matrix.
  int components() const { return columns * rows; }
  // Returns columns and rows, four bits each.
  int layout() const { return columns << 4 | rows; }

  Type element() const {
    Type type = *this;
    type.length = notArray;
    return type;
  }
};

constexpr Type scalarOf(Base base) { return {base, 1, 1, 0, Type::notArray}; }
constexpr Type vectorType(Base base, int size) {
  return {base, 1, static_cast<std::uint8_t>(size), 0, Type::notArray};
}
constexpr Type matrixType(int columns, int rows) {
  return {Base::Float, static_cast<std::uint8_t>(columns), static_cast<std::uint8_t>(rows), 0,
          Type::notArray};
}

inline constexpr Type voidType = scalarOf(Base::Void), boolType = scalarOf(Base::Bool),
                      intType = scalarOf(Base::Int), uintType = scalarOf(Base::Uint),
                      floatType = scalarOf(Base::Float), samplerType = scalarOf(Base::Sampler);

struct Field {
  std::string_view name;
  Type type;
  // The offset in the components of the structure.
  int offset = 0;
};

struct Structure {
  std::string_view name{};
  std::vector<Field> fields{};
  int size = 0;
  // A uniform block has members, but no value of its own.
  bool isBlock = false;
  // Maps name → index in `fields`.
  std::map<std::string_view, std::size_t> indices{};

  void add(Field field) {
    indices.emplace(field.name, fields.size());
    fields.push_back(field);
  }

  const Field* find(std::string_view field) const {
    const auto index = indices.find(field);
    return index == indices.end() ? nullptr : &fields[index->second];
  }
};

class Types {
 public:
  std::uint16_t add(Structure structure) {
    structures_.push_back(std::move(structure));
    return static_cast<std::uint16_t>(structures_.size() - 1);
  }

  const Structure& structure(Type type) const { return structures_[type.structure]; }
  std::size_t count() const { return structures_.size(); }

  // Returns the size of a type, in numbers.
  int size(Type type) const;
  // Returns the type as written in GLSL; with an article for messages.
  std::string name(Type type) const;
  std::string withArticle(Type type) const;
  bool hasSampler(Type type) const;
  bool hasArray(Type type) const;
  bool hasBase(Type type, Base base) const;
  // Returns true if a field of the structure is itself a structure.
  bool hasNested(Type type) const;
  // Returns true for a uniform block or an array of blocks.
  bool isBlock(Type type) const {
    return type.base == Base::Struct && structures_[type.structure].isBlock;
  }

 private:
  std::vector<Structure> structures_;
};

// A keyword that is the name of a type; `void` is one, too.
struct NamedType {
  std::string_view word;
  Type type;
};
// Returns the type with that keyword, or null.
const NamedType* findType(std::string_view word);

}  // namespace warpjet::source

#include "source/types.hpp"

#include <array>

namespace warpjet::source {

namespace {

using enum Base;

constexpr std::array named{
    NamedType{"void", voidType},
    NamedType{"float", floatType},
    NamedType{"int", intType},
    NamedType{"uint", uintType},
    NamedType{"bool", boolType},
    NamedType{"vec2", vectorType(Float, 2)},
    NamedType{"vec3", vectorType(Float, 3)},
    NamedType{"vec4", vectorType(Float, 4)},
    NamedType{"ivec2", vectorType(Int, 2)},
    NamedType{"ivec3", vectorType(Int, 3)},
    NamedType{"ivec4", vectorType(Int, 4)},
    NamedType{"uvec2", vectorType(Uint, 2)},
    NamedType{"uvec3", vectorType(Uint, 3)},
    NamedType{"uvec4", vectorType(Uint, 4)},
    NamedType{"bvec2", vectorType(Bool, 2)},
    NamedType{"bvec3", vectorType(Bool, 3)},
    NamedType{"bvec4", vectorType(Bool, 4)},
    NamedType{"mat2", matrixType(2, 2)},
    NamedType{"mat3", matrixType(3, 3)},
    NamedType{"mat4", matrixType(4, 4)},
    NamedType{"mat2x2", matrixType(2, 2)},
    NamedType{"mat2x3", matrixType(2, 3)},
    NamedType{"mat2x4", matrixType(2, 4)},
    NamedType{"mat3x2", matrixType(3, 2)},
    NamedType{"mat3x3", matrixType(3, 3)},
    NamedType{"mat3x4", matrixType(3, 4)},
    NamedType{"mat4x2", matrixType(4, 2)},
    NamedType{"mat4x3", matrixType(4, 3)},
    NamedType{"mat4x4", matrixType(4, 4)},
    NamedType{"sampler2D", samplerType},
};

}  // namespace

const NamedType* findType(std::string_view word) {
  for (const NamedType& row : named)
    if (row.word == word) return &row;
  return nullptr;
}

int Types::size(Type type) const {
  const int one = type.base == Struct ? structures_[type.structure].size
                  : type.base == Void ? 0
                                      : type.components();
  return type.isArray() ? one * type.length : one;
}

std::string Types::name(Type type) const {
  std::string text;
  if (type.base == Struct) {
    text = structures_[type.structure].name;
  } else {
    for (const NamedType& row : named)
      if (row.type == type.element()) {
        text = row.word;
        break;
      }
  }
  if (!type.isArray()) return text;
  return text + '[' + (type.length ? std::to_string(type.length) : "") + ']';
}

std::string Types::withArticle(Type type) const {
  const std::string text = name(type);
  return (std::string_view("aeioAEIO").find(text[0]) == std::string_view::npos ? "a " : "an ") +
         text;
}

bool Types::hasSampler(Type type) const { return hasBase(type, Sampler); }

bool Types::hasBase(Type type, Base base) const {
  if (type.base == base) return true;
  if (type.base != Struct) return false;
  for (const Field& field : structures_[type.structure].fields)
    if (hasBase(field.type, base)) return true;
  return false;
}

bool Types::hasNested(Type type) const {
  for (const Field& field : structures_[type.structure].fields)
    if (field.type.base == Struct) return true;
  return false;
}

bool Types::hasArray(Type type) const {
  if (type.isArray()) return true;
  if (type.base != Struct) return false;
  for (const Field& field : structures_[type.structure].fields)
    if (hasArray(field.type)) return true;
  return false;
}

}  // namespace warpjet::source

// An expression of WGSL while it is parsed.
#pragma once

#include <string>
#include <vector>

#include "source/tree.hpp"

namespace warpjet::source::wgsl {

struct Operand {
  // A Reference is a variable or a part of one; a Pointer points to one.
  enum class Kind : std::uint8_t { Value, Reference, Pointer };

  Kind kind = Kind::Value;
  bool isWritable = false;
  // The address space of a reference or a pointer.
  std::string_view space = "function";
  // `nothing` if the value is abstract, or if it is still only the name `host`.
  ExpressionId id = nothing;
  Type type{};
  // The numbers of a value without a concrete type, which follows from its use: `1`, `vec2(1,
  // 0.5)`. Its type has Int or Float as base.
  std::vector<double> known{};
  // The host's name of a uniform, a storage buffer or a part of one: `lights[2].color`.
  std::string host{};
  // The indices that are not constants in the source. `host` has [] for each.
  std::vector<ExpressionId> hostIndices{};
  // The type of a texture's texels.
  Type texel{};

  bool isAbstract() const { return !known.empty(); }
  bool isPointer() const { return kind == Kind::Pointer; }
};

}  // namespace warpjet::source::wgsl

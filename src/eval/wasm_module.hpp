// Builds a WebAssembly module: takes functions, returns its bytes.
#pragma once

#include <string_view>

#include "eval/wasm_bytes.hpp"

namespace warpjet {

// The function types, in the order of the section. Their first parameter is the memory address.
enum FunctionType : std::uint32_t {
  Piece,     // part of the program, with the byte offset of four vertices: 16 times their index
  Kernel,    // an imported operation with one operand
  Kernel2,   // the same with two operands
  EachLane,  // the import that applies any operation lane by lane
  Routine,   // an operation with one operand that is generated once per module
  Routine2,  // the same with two operands
};

class WasmModule {
 public:
  // Returns the number of the next function.
  std::uint32_t functionCount() const { return functionCount_; }

  // Returns the number of the imported function. Imports must be added before the first function.
  std::uint32_t import(std::string_view name, FunctionType type);
  void add(FunctionType type, const WasmBytes& body);

  // Exports this function as `start`, and the following one as `run`.
  WasmBytes bytes(std::uint32_t start) const;

 private:
  std::uint32_t functionCount_ = 0, importCount_ = 0;
  WasmBytes imports_, types_, code_;
};

}  // namespace warpjet

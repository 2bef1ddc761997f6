// A WebAssembly module in the making: functions enter, its bytes leave.
#pragma once

#include <string_view>

#include "eval/wasm_bytes.hpp"

namespace warpjet {

// The types of functions, in the order of the section. The first number is the memory's address.
enum FunctionType : std::uint32_t {
  Piece,     // of the program: that, and 16 times the number of the four vertices
  Kernel,    // of so many operands
  Kernel2,   //
  EachLane,  // the operation and its operands
  Routine,   //
  Routine2,  //
};

class WasmModule {
 public:
  // The number of the next function.
  std::uint32_t functionCount() const { return functionCount_; }

  // All imports come before the first function. Returns the number.
  std::uint32_t import(std::string_view name, FunctionType type);
  void add(FunctionType type, const WasmBytes& body);

  // Exported as `start`; the function after it as `run`.
  WasmBytes bytes(std::uint32_t start) const;

 private:
  std::uint32_t functionCount_ = 0, importCount_ = 0;
  WasmBytes imports_, types_, code_;
};

}  // namespace warpjet

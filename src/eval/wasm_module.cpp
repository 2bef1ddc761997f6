#include "eval/wasm_module.hpp"

#include <initializer_list>
#include <utility>

namespace warpjet {

namespace {

void type(WasmBytes& types, std::initializer_list<std::uint8_t> operands, bool hasResult) {
  types.byte(wasm::functionType);
  types.number(static_cast<std::uint32_t>(operands.size()));
  for (const std::uint8_t operand : operands) types.byte(operand);
  types.number(hasResult);
  if (hasResult) types.byte(wasm::v128);
}

}  // namespace

std::uint32_t WasmModule::import(std::string_view name, FunctionType type) {
  imports_.text("");
  imports_.text("lanes_", name);
  imports_.byte(wasm::OfFunction);
  imports_.number(type);
  ++importCount_;
  return functionCount_++;
}

void WasmModule::add(FunctionType type, const WasmBytes& body) {
  types_.number(type);
  code_.appendCounted(body);
  ++functionCount_;
}

WasmBytes WasmModule::bytes(std::uint32_t start) const {
  using namespace wasm;
  WasmBytes module;
  for (const char x : {'\0', 'a', 's', 'm', '\1', '\0', '\0', '\0'})
    module.byte(static_cast<std::uint8_t>(x));

  WasmBytes types;
  types.number(6);
  type(types, {i32, i32}, false);
  type(types, {v128}, true);
  type(types, {v128, v128}, true);
  type(types, {i32, v128, v128, v128}, true);
  type(types, {i32, v128}, true);
  type(types, {i32, v128, v128}, true);
  module.section(Types, types);

  WasmBytes imports;
  imports.number(importCount_ + 1);
  imports.append(imports_);
  imports.text("");
  imports.text("memory");
  imports.byte(OfMemory);
  imports.number(0);
  imports.number(0);
  module.section(Imports, imports);

  WasmBytes functions;
  functions.number(functionCount_ - importCount_);
  functions.append(types_);
  module.section(Functions, functions);

  WasmBytes exports;
  exports.number(2);
  for (const auto& [name, number] : {std::pair{"start", start}, {"run", start + 1}}) {
    exports.text(name);
    exports.byte(OfFunction);
    exports.number(number);
  }
  module.section(Exports, exports);

  WasmBytes code;
  code.number(functionCount_ - importCount_);
  code.append(code_);
  module.section(Code, code);
  return module;
}

}  // namespace warpjet

// Compares the encoding of numbers and a whole module with bytes written by hand.
// tests/cpu/machine-code.test.js runs machine code and compares it with the interpreter.
#include "eval/machine_code.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "eval/program.hpp"
#include "eval/wasm_bytes.hpp"
#include "support.hpp"

namespace warpjet {
namespace {

using Bytes = std::vector<std::uint8_t>;

Bytes encodeUnsigned(std::uint32_t x) {
  WasmBytes bytes;
  bytes.number(x);
  return bytes.bytes();
}

Bytes encodeSigned(std::int32_t x) {
  WasmBytes bytes;
  bytes.signedNumber(x);
  return bytes.bytes();
}

// Checks the examples of the DWARF standard, which defines LEB128, and the limits of 32 bits.
TEST(WasmBytes, EncodesNumbersAsLEB128) {
  EXPECT_EQ(encodeUnsigned(2), (Bytes{2}));
  EXPECT_EQ(encodeUnsigned(127), (Bytes{127}));
  EXPECT_EQ(encodeUnsigned(128), (Bytes{0x80, 1}));
  EXPECT_EQ(encodeUnsigned(12857), (Bytes{0x80 + 57, 100}));
  EXPECT_EQ(encodeUnsigned(~0u), (Bytes{0xff, 0xff, 0xff, 0xff, 0x0f}));
  EXPECT_EQ(encodeSigned(2), (Bytes{2}));
  EXPECT_EQ(encodeSigned(-2), (Bytes{0x7e}));
  EXPECT_EQ(encodeSigned(63), (Bytes{63}));
  EXPECT_EQ(encodeSigned(64), (Bytes{0xc0, 0}));
  EXPECT_EQ(encodeSigned(127), (Bytes{0xff, 0}));
  EXPECT_EQ(encodeSigned(-127), (Bytes{0x81, 0x7f}));
  EXPECT_EQ(encodeSigned(-128), (Bytes{0x80, 0x7f}));
  EXPECT_EQ(encodeSigned(INT32_MIN), (Bytes{0x80, 0x80, 0x80, 0x80, 0x78}));
}

TEST(WasmBytes, PrefixesStringsAndSectionsWithTheirLength) {
  WasmBytes contents, module;
  contents.text("run");
  contents.text("lanes_", "exp");
  module.section(7, contents);
  EXPECT_EQ(module.bytes(),
            (Bytes{7, 14, 3, 'r', 'u', 'n', 9, 'l', 'a', 'n', 'e', 's', '_', 'e', 'x', 'p'}));
}

class MachineCodeTest : public testing::Test {
 protected:
  Graph graph;
  Expression x = scalar(graph, "x"), time = scalar(graph, "time");

  MachineCode codeOf(Expression result) {
    const auto compiled = program(graph, std::array{result.id});
    const RegisterProgram registers =
        allocateRegisters(compiled->words, compiled->instructions, std::array{0u}, {false, true});
    // The memory: x of 4 vertices, the time, and space for 4 results.
    const Placement inputs[] = {{0, 1}, {16, 1, true}}, results[] = {{20, 1}};
    return machineCode(registers, inputs, results, 36);
  }

  static bool contains(const Bytes& bytes, const Bytes& part) {
    return std::search(bytes.begin(), bytes.end(), part.begin(), part.end()) != bytes.end();
  }
};

// x + 2, assembled with the specification's tables of opcodes.
TEST_F(MachineCodeTest, MatchesAModuleAssembledByHand) {
  const MachineCode made = codeOf(x + 2.0);
  EXPECT_EQ(made.sharedAt, 36u);
  EXPECT_EQ(made.shared, (std::vector<std::uint32_t>{0x40000000})) << "2.0f";
  const Bytes head{0, 'a', 's', 'm', 1, 0, 0, 0};
  EXPECT_TRUE(std::equal(head.begin(), head.end(), made.module.begin()));

  // The address of x, four lanes of it, the constant, which stays in a local, the sum, and four
  // stores.
  const Bytes address{0x20, 0, 0x20, 1, 0x41, 1, 0x6c, 0x6a, 0x21, 2};
  Bytes body{2, 1, 0x7f, 3, 0x7b};
  const auto add = [&](const Bytes& more) { body.insert(body.end(), more.begin(), more.end()); };
  add(address);
  add({0x20, 2, 0x20, 2, 0x20, 2, 0x20, 2});
  add({0xfd, 0x5c, 2, 0, 0xfd, 0x56, 2, 4, 1, 0xfd, 0x56, 2, 8, 2, 0xfd, 0x56, 2, 12, 3});
  add({0x21, 3});
  add({0x20, 3, 0x20, 0, 0xfd, 0x09, 2, 36, 0x22, 4, 0xfd, 0xe4, 0x01, 0x21, 5});
  add(address);
  for (std::uint8_t lane = 0; lane < 4; ++lane)
    add({0x20, 2, 0x20, 5, 0xfd, 0x5a, 2, static_cast<std::uint8_t>(20 + 4 * lane), lane});
  add({0x0b});
  body.insert(body.begin(), static_cast<std::uint8_t>(body.size()));
  EXPECT_TRUE(contains(made.module, body));
}

// `start` computes the values that all vertices share: they are among the shared numbers, after the
// constants and before those of formulas.
TEST_F(MachineCodeTest, OrdersSharedNumbers) {
  const MachineCode made = codeOf(x * (time * 3.0 + 1.0));
  ASSERT_EQ(made.shared.size(), 5u);
  EXPECT_EQ(made.shared[0], __builtin_bit_cast(std::uint32_t, 3.0f));
  EXPECT_EQ(made.shared[1], __builtin_bit_cast(std::uint32_t, 1.0f));
  // Number 2 is the time. `start` stores its multiple as number 3: v128.store32_lane at 36 + 4 · 3.
  EXPECT_TRUE(contains(made.module, {0xfd, 0x5a, 2, 36 + 12, 0}));
  EXPECT_GT(codeOf(sin(x)).shared.size(), 5u) << "the coefficients of a sine";
}

// The names of imported functions are those that js-bindings/wasm/evaluation.cpp exports.
TEST_F(MachineCodeTest, ImportsOnlyTheFunctionsItCalls) {
  const auto name = [](std::string_view text) { return Bytes(text.begin(), text.end()); };
  EXPECT_TRUE(contains(codeOf(exp(x)).module, name("lanes_exp")));
  EXPECT_FALSE(contains(codeOf(exp(x)).module, name("lanes_log")));
  EXPECT_FALSE(contains(codeOf(x * x).module, name("lanes_exp")));
}

// Many instructions are split into several functions, with registers in memory between them.
TEST_F(MachineCodeTest, SplitsALongProgramIntoFunctions) {
  Expression sum = x;
  for (int i = 0; i < 1200; ++i) sum = sum * sum + x;
  const MachineCode made = codeOf(sum);
  EXPECT_GT(made.sharedAt, 36u);
  EXPECT_EQ(codeOf(x * x).sharedAt, 36u);
}

}  // namespace
}  // namespace warpjet

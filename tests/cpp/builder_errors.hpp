// A fixture that checks what the builder rejects, and that the builder continues to work
// afterwards.
#pragma once

#include <gtest/gtest.h>

#include "bench.hpp"

namespace warpjet {

class BuilderErrors : public testing::Test, protected Bench {
 protected:
  void TearDown() override {
    if (builder.graph().isFull()) return;
    EXPECT_EQ(text(call("sin", {x})), "sin(x)");
  }

  // Expects an invalid handle, and that the builder continues to work afterwards.
  void expectRejected(int handle, const std::string& message) {
    EXPECT_EQ(handle, Builder::failed) << message;
    EXPECT_EQ(builder.problem(), message);
    EXPECT_GE(call("sin", {x}), 0) << "after: " << message;
  }
  // Expects that there is no shader code.
  void expectCodeRejected(const Bench& bench, const std::string& message) {
    EXPECT_FALSE(bench.writeResults().text) << message;
    EXPECT_EQ(bench.problemOfText(), message);
  }
  // Expects that shader code can be written before a change, but not after it.
  template <class Change>
  void expectWriteRejected(Change change, const std::string& message) {
    Bench bench;
    bench.builder.output("gen", "fine", bench.x);
    EXPECT_TRUE(bench.writeResults().text) << bench.problemOfText();
    change(bench);
    expectCodeRejected(bench, message);
  }
};

}  // namespace warpjet

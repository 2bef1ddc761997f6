// The typed tree of a source: created by the parser, read by the lowering. Nodes are stored in
// lists and refer to each other by index.
#pragma once

#include <cstdint>
#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "source/builtins.hpp"
#include "source/operators.hpp"
#include "source/problems.hpp"
#include "source/types.hpp"

namespace warpjet::source {

// Indices into the lists of a tree, or `nothing`.
using ExpressionId = std::int32_t;
using StatementId = std::int32_t;
using VariableId = std::int32_t;
using FunctionId = std::int32_t;
inline constexpr std::int32_t nothing = -1;

struct Expression {
  enum class Kind : std::uint8_t {
    Constant,  // `value`, a number of any type
    Variable,  // `index`
    Part,      // `index` is the offset of a field
    Swizzle,   // `index` packs the components, two bits each
    Element,   // the element of an array, vector or matrix; the index is an operand
    Negate,
    Plus,
    Not,
    Complement,
    Increment,  // `op` is Add or Subtract; `index` is 1 for the postfix form, which returns the old
                // value
    Binary,
    Choose,
    Assign,  // `isCombined` with `op`
    Sequence,
    Construct,
    Call,         // the index of the function
    BuiltIn,      // row number `index`
    HostElement,  // a part of a storage buffer; `index` is the number of its name in `made`, in
                  // which each [] needs an operand
    Unsupported,  // fails with reason number `index` when it is evaluated
  };

  Kind kind;
  Operator op{};
  bool isCombined = false;
  // True if the expression may be the target of an assignment.
  bool isAssignable = false;
  std::uint16_t depth = 0;
  Type type{};
  std::int32_t index = 0;
  double value = 0;
  Location location{};
  std::vector<ExpressionId> operands{};
};

struct Statement {
  enum class Kind : std::uint8_t {
    Block,     // `children`
    Evaluate,  // `expression`
    Declare,   // the variable `index`, `expression` or nothing
    If,        // `expression`; `children` one or two
    Loop,      // children: start, step, body, of which the first two may be nothing
    Switch,    // `expression`; `children`
    Case,      // `expression`, nothing for default
    Return,
    Break,
    Continue,
  };

  Kind kind;
  // For a loop: true if its condition comes after the body.
  bool testsAfterBody = false;
  VariableId index = nothing;
  ExpressionId expression = nothing;
  Location location{};
  std::vector<StatementId> children{};
};

struct Variable {
  std::string_view name;
  Type type;
  Location location{};
  enum class Kind : std::uint8_t {
    Local,
    Constant,
    Uniform,
    Attribute,
    Parameter,
    Global,
    Fragment,  // a built-in input of fragment shaders, which other functions of a source may read
  } kind;
  // The initializer of a constant or a global.
  ExpressionId start = nothing;
  // True if the next stage reads this global.
  bool isOutput = false;
};

struct Parameter {
  enum class Direction : std::uint8_t { In, Out, InOut } direction = Direction::In;
  VariableId variable = nothing;
  Type type;
  bool isConst = false;
};

struct Function {
  std::string_view name;
  Type type;
  std::vector<Parameter> parameters;
  Location location;
  StatementId body = nothing;
};

struct Tree {
  Types types;
  // The table of the language, whose rows calls refer to.
  BuiltIns builtIns;
  std::vector<Expression> expressions;
  std::vector<Statement> statements;
  std::vector<Variable> variables;
  std::vector<Function> functions;
  // Global declarations, in order.
  std::vector<StatementId> globals;
  // Text that is not in the source: tokens created by macros, and names of parts of uniforms.
  std::deque<std::string> made;
  // Why the expressions of the kind Unsupported fail.
  std::vector<std::string> reasons;
};

}  // namespace warpjet::source

// From tokens to the typed tree: a recursive descent, as deep as `deepest` and no deeper. Past the
// first problem every token is the end of the text, so that it comes home at once.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "glsl/preprocess.hpp"
#include "glsl/scope.hpp"
#include "glsl/tree.hpp"

namespace warpjet::glsl {

class Parser {
 public:
  Parser(Preprocessed text, Problems& problems);

  Tree parse();

 private:
  using Kind = Token::Kind;
  using Code = Expression::Kind;

  static constexpr int deepest = 128;
  // Numbers of one variable or structure, and of all variables together.
  static constexpr int largestValue = 1 << 16, mostHeld = 1 << 20;

  // What stands before a type.
  struct Qualifiers {
    bool isConst = false;
    Variable::Kind kind = Variable::Kind::Local;
    Parameter::Direction direction = Parameter::Direction::In;
    bool any = false;
  };

  // parser.cpp
  const Token& peek(std::size_t ahead = 0) const;
  const Token& take();
  bool accept(std::string_view text);
  bool expect(std::string_view text, std::string_view after);
  void fail(Place place, std::string sentence) { problems_.add(place, std::move(sentence)); }
  std::string found() const;
  std::string_view takeName(std::string_view what);
  bool goDeeper();
  void global();
  Qualifiers qualifiers();
  bool startsType() const;
  Type type();
  Type structure();
  Type arrayOf(Type element);
  bool checkFree(const Token& name);
  Number addVariable(const Token& name, Type type, Variable::Kind kind);

  // parse_functions.cpp
  void function(Type result, const Token& name);
  std::vector<Parameter> parameters();
  Number declareFunction(const Function& function);
  void refuseRecursion();

  // parse_statements.cpp
  Number statement(bool opensScope = true);
  Number simpleStatement();
  Number block();
  Number declarations(Qualifiers qualifiers, Type base);
  Number declaration(Qualifiers qualifiers, Type type, const Token& name);
  Number ifStatement();
  Number forStatement();
  Number whileStatement();
  Number doStatement();
  Number switchStatement();
  Number returnStatement();
  Number jump();
  Number condition(std::string_view after);
  Number add(Statement statement);
  Number makeBlock(Place place, std::vector<Number> children);

  // parse_expressions.cpp
  Number expression();
  Number assignment();
  Number choice();
  Number binary(int level);
  Number unary();
  Number makeBinary(Operator op, Number left, Number right, Place place);
  Number makePlace(Number operand, Place place, std::string_view what);
  Number increment(Number operand, Operator op, Place place, bool isPostfix);
  Number failed(Place place, std::string sentence);
  Number add(Expression expression);

  // parse_operands.cpp
  Number postfix();
  Number primary();
  Number number();
  Number named();
  Number construct(Type type, Place place);
  Number call(const Token& name);
  Number member(Number operand);
  Number element(Number operand);
  std::vector<Number> arguments();
  Number callFunction(const Token& name, std::vector<Number> operands,
                      const std::vector<Type>& types);
  std::string typesOf(const std::vector<Type>& types) const;
  Type typeOf(Number expression) const {
    return expression == nothing ? floatType : tree_.expressions[expression].type;
  }

  Preprocessed text_;
  Problems& problems_;
  Tree tree_;
  Scope scope_;
  Token end_;
  std::size_t at_ = 0;
  int depth_ = 0, loops_ = 0, switches_ = 0;
  // Numbers of all variables, and of those from outside.
  int held_ = 0, heldOutside_ = 0;
  // The function that is being read, and who calls whom.
  Number current_ = nothing;
  struct Call {
    Number from, to;
    Place place;
  };
  std::vector<Call> calls_;
};

}  // namespace warpjet::glsl

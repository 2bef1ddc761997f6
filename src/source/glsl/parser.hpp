// Parses tokens to the typed tree by recursive descent, up to a depth of `maxDepth`. After the
// first problem every token is the end of the source, so that parsing ends at once.
#pragma once

#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "source/builtins.hpp"
#include "source/constants.hpp"
#include "source/glsl/preprocess.hpp"
#include "source/glsl/qualifiers.hpp"
#include "source/recursion.hpp"
#include "source/scope.hpp"
#include "source/tree.hpp"

namespace warpjet::source::glsl {

class Parser {
 public:
  Parser(PreprocessedSource text, Problems& problems);

  Tree parse();

 private:
  using Kind = Token::Kind;
  using Code = Expression::Kind;

  static constexpr int maxDepth = 128;
  // The max size of one variable or structure, and of all variables together, as counts of numbers.
  static constexpr int maxValueSize = 1 << 16, maxHeld = 1 << 20;

  struct GlobalKind {
    Variable::Kind kind;
    bool isOutput = false;
  };

  // parser.cpp
  const Token& peek(std::size_t ahead = 0) const;
  const Token& take();
  bool accept(std::string_view text);
  bool expect(std::string_view text, std::string_view after);
  void fail(Location location, std::string message) { problems_.add(location, std::move(message)); }
  // Fails if the version of the source lacks the feature.
  void requireVersion(std::string_view what, Location location);
  std::string describeNext() const;
  std::string_view takeName(std::string_view what);
  bool checkDepth();
  void global();
  // Returns true if the source declares the name: a keyword of one language may be a name in the
  // other.
  bool isDeclared(const Token& token) const;
  bool startsType(std::size_t ahead = 0) const;
  Type type();
  Type structure();
  void fields(const Qualifiers& given, Structure& structure);
  Type arrayOf(Type element);
  bool checkFree(const Token& name);
  VariableId addVariable(const Token& name, Type type, Variable::Kind kind);

  // parse_qualifiers.cpp
  Qualifiers qualifiers();
  void checkOrder(const Qualifiers::Word& before, const Token& token, QualifierRole role);
  void layout(Qualifiers& found);
  void allowOnly(const Qualifiers& given, std::initializer_list<QualifierRole> roles,
                 std::string_view where);
  void checkPrecision(const Qualifiers& given, Type type);
  void checkGlobal(const Qualifiers& given, Type type, Location location);
  static GlobalKind kindOf(const Qualifiers& given);
  void precision();
  void invariant();

  // parse_builtins.cpp
  void findStage();
  void declareBuiltIns();
  VariableId declareBuiltIn(std::string_view name, Type type, Variable::Kind kind);
  void declareGlobally(VariableId variable, ExpressionId initializer);

  // parse_blocks.cpp
  bool startsBlock() const;
  void uniformBlock(const Qualifiers& given);
  void declareUniform(const Token& name, Type type);
  Structure blockMembers(std::string_view name);

  // parse_functions.cpp
  void function(const Qualifiers& given, Type result, const Token& name);
  bool redefines(const Function& made) const;
  void rejectMissing();
  std::vector<Parameter> parameters();
  FunctionId declareFunction(const Function& function);
  void rejectRecursion();

  // parse_statements.cpp
  StatementId statement(bool opensScope = true);
  StatementId simpleStatement();
  StatementId block();
  StatementId ifStatement();
  StatementId switchStatement();
  ExpressionId caseLabel(ExpressionId label, Type wanted, std::set<std::int32_t>& labels,
                         Location location);
  StatementId returnStatement();
  StatementId jump();
  StatementId add(Statement statement);
  StatementId makeBlock(Location location, std::vector<StatementId> children);

  // parse_declarations.cpp
  StatementId declarations(const Qualifiers& given, Type base);
  StatementId declaration(const Qualifiers& given, Type type, const Token& name);
  void checkStart(Variable::Kind kind, ExpressionId start, const Token& name);

  // parse_loops.cpp
  StatementId forStatement();
  StatementId whileStatement();
  StatementId doStatement();
  void requireCounting(StatementId start, ExpressionId test, StatementId step, Location location);
  ExpressionId condition(std::string_view after);
  ExpressionId declaredCondition(StatementId& declared);
  bool startsDeclaration(std::size_t ahead = 0) const;

  // parse_expressions.cpp
  ExpressionId expression();
  ExpressionId assignment();
  ExpressionId choice();
  ExpressionId binary(int level);
  ExpressionId unary();
  ExpressionId makeBinary(Operator op, ExpressionId left, ExpressionId right, Location location);
  ExpressionId makeAssignable(ExpressionId operand, Location location, std::string_view what);
  ExpressionId increment(ExpressionId operand, Operator op, Location location, bool isPostfix);
  ExpressionId failExpression(Location location, std::string message);
  ExpressionId add(Expression expression);

  // parse_operands.cpp
  ExpressionId postfix();
  ExpressionId primary();
  ExpressionId number();
  ExpressionId named();
  ExpressionId construct(Type type, Location location);
  ExpressionId call(const Token& name);
  ExpressionId member(ExpressionId operand);
  ExpressionId element(ExpressionId operand);
  bool isUniform(ExpressionId operand) const;
  std::vector<ExpressionId> arguments();
  void checkOffset(const BuiltIn& row, ExpressionId offset, Location location);
  ExpressionId callFunction(const Token& name, std::vector<ExpressionId> operands,
                            const std::vector<Type>& types);
  std::string typesOf(const std::vector<Type>& types) const;
  Type typeOf(ExpressionId expression) const {
    return expression == nothing ? floatType : tree_.expressions[expression].type;
  }

  PreprocessedSource text_;
  Problems& problems_;
  Tree tree_;
  Constants constants_{tree_, text_.version};
  Scope scope_;
  Token end_;
  std::size_t at_ = 0;
  int depth_ = 0, loops_ = 0, switches_ = 0;
  // The stage of a whole shader, which is determined by its built-in variables.
  enum class Stage : std::uint8_t { Unknown, Vertex, Fragment } stage_ = Stage::Unknown;
  bool hasReturn_ = false;  // true if the current function has a return
  // The size of all variables, and of uniforms and attributes.
  int totalSize_ = 0, inputSize_ = 0;
  // The counters of the enclosing loops, as GLSL ES 1.00 defines them.
  std::vector<VariableId> counters_;
  std::map<std::string_view, std::vector<FunctionId>> overloads_;
  // The function being parsed, and all calls.
  FunctionId current_ = nothing;
  std::vector<FunctionCall> calls_;
};

}  // namespace warpjet::source::glsl

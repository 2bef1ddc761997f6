// Parses WGSL into a typed tree. References are to sections of the W3C's specification.
//
// Declarations outside of functions may be in any order: `findGlobals` finds where each one is, and
// `resolve` parses it when its name is first used. Bodies of functions are parsed last.
//
// Features of WGSL that no warp can use become expressions that fail when they are evaluated, so
// that a whole shader can be parsed even if only one of its functions is used.
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "source/constants.hpp"
#include "source/problems.hpp"
#include "source/recursion.hpp"
#include "source/tree.hpp"
#include "source/wgsl/entity.hpp"
#include "source/wgsl/tokens.hpp"

namespace warpjet::source::wgsl {

class Parser {
 public:
  Parser(std::vector<Token> tokens, Problems& problems);

  Tree parse();

 private:
  using Code = Expression::Kind;
  using Operands = std::vector<Operand>;

  static constexpr int maxDepth = 100;
  // The max size of one variable or structure, and of all variables together, in numbers.
  static constexpr int maxValueSize = 1 << 16, maxHeld = 1 << 20;

  // A type as written where a variable or a parameter is declared.
  struct DeclaredType {
    Type type{};
    bool isPointer = false, isWritable = false;
    std::string_view space{};
    bool isSampler = false;
    // The type of a texture's texels.
    Type texel{};
    // Why a warp can't have a value of the type; empty if it can.
    std::string unsupported{};
  };

  // parser.cpp
  const Token& peek(std::size_t ahead = 0) const;
  Token take();
  bool accept(std::string_view text);
  bool expect(std::string_view text, std::string_view after);
  void fail(Location location, std::string message) { problems_.add(location, std::move(message)); }
  std::string describeNext() const;
  Token takeName(std::string_view what);
  bool checkDepth();
  void attributes();
  Entity resolve(std::string_view name);
  bool isDeclared(std::string_view name) const;
  std::string nearestName(std::string_view name) const;
  void declare(const Token& name, Entity entity);
  VariableId addVariable(std::string_view name, Type type, Variable::Kind kind, Location location);
  template <class Work>
  auto withDepth(const Work& work);

  // parse_globals.cpp
  void directives();
  void findGlobals();
  void skipTo(std::string_view end);
  void global(Global& found);
  Entity structure();
  Entity alias();
  void constAssert();

  // parse_global_variables.cpp
  Entity globalVariable();
  Entity globalConstant();
  Entity overrideConstant();
  void declareGlobally(VariableId variable, ExpressionId initializer);
  Type initialType(const std::optional<DeclaredType>& declared, const Operand& value,
                   Location location, std::string_view name);
  Entity constant(const Token& name, const std::optional<DeclaredType>& declared, Operand value,
                  StatementId* statement);

  // parse_types.cpp
  DeclaredType declaredType();
  Type type();
  Type vectorOrMatrix(const Token& word);
  std::optional<Type> shorthand(std::string_view word) const;
  Type arrayType(Location location);
  Type arrayOf(Type element, std::int32_t length);
  DeclaredType pointerType();
  DeclaredType textureType(const Token& word);
  bool startsType(std::size_t ahead = 0);
  bool isGenerator(std::string_view word) const;
  std::int32_t arrayLength();

  // type_names.cpp
  std::string nameOf(Type type) const;
  std::string nameOf(const Operand& operand) const;
  std::string withArticle(const std::string& name) const;
  std::string describe(const Operand& operand) const { return withArticle(nameOf(operand)); }
  std::string describe(Type type) const { return withArticle(nameOf(type)); }

  // parse_functions.cpp
  Entity functionHead();
  Parameter parameter(std::vector<Entity>& entities);
  void functionBody(std::size_t index);
  void rejectRecursion();

  // behavior.cpp: how a statement may end, as a union of values of Behavior. WGSL, section 9.7.
  enum Behavior : unsigned { Next = 1, Returns = 2, Breaks = 4, Continues = 8 };
  unsigned behaviorOf(StatementId statement) const;
  unsigned behaviorOfLoop(const Statement& loop) const;

  // parse_statements.cpp
  StatementId statement();
  StatementId block();
  std::vector<StatementId> blockStatements();
  StatementId ifStatement();
  StatementId returnStatement();
  StatementId jump();
  StatementId add(Statement statement);
  StatementId makeBlock(Location location, std::vector<StatementId> children);
  StatementId evaluate(ExpressionId expression, Location location);
  ExpressionId condition(std::string_view after);

  // parse_variables.cpp
  StatementId variableStatement();
  StatementId letStatement();
  StatementId constStatement();
  StatementId declareLocal(const Token& name, Type type, Variable::Kind kind, ExpressionId start,
                           bool isWritable);
  Operand freeze(const Operand& reference, std::vector<StatementId>& before);
  StatementId simpleStatement();
  StatementId assignment();

  // parse_loops.cpp
  StatementId loopStatement();
  StatementId forStatement();
  StatementId whileStatement();
  StatementId continuing(ExpressionId& breakIf);
  // The numbers of expressions and statements in the tree.
  struct TreeSize {
    std::size_t expressions, statements;
  };
  StatementId hoist(std::vector<StatementId>& body, const TreeSize& sizeBefore,
                    ExpressionId breakIf);
  StatementId switchStatement();
  void caseLabels(Type type, std::vector<StatementId>& children, std::vector<std::int32_t>& labels,
                  bool& hasDefault);

  // parse_expressions.cpp
  Operand expression();
  Operand value();
  Operand relational(Operand first);
  Operand shift(Operand first);
  Operand additive(Operand first);
  Operand multiplicative(Operand first);
  Operand bitwise(Operand first, std::string_view symbol);
  Operand unary();
  std::string_view peekOperator() const;
  void takeOperator(std::string_view text);
  void rejectMixed(std::string_view before);
  void rejectConditional();

  // parse_operators.cpp
  Operand makeBinary(Operator op, Operand left, Operand right, Location location);
  Operand makeUnary(const Token& symbol, Operand operand);
  Operand compare(Operator op, const Operand& left, const Operand& right, Location location);
  std::optional<Type> typeOfBinary(Operator op, Type left, Type right) const;
  void checkKnown(Operator op, const Operand& right, Location location);
  bool unify(Operand& left, Operand& right);

  // parse_operands.cpp
  Operand postfix(Operand operand);
  Operand primary();
  Operand named();
  Operand member(const Operand& operand);
  Operand element(const Operand& operand);
  Operand elementOf(const Operand& whole, const Operand& index, Location location);
  Operand addressOf(const Operand& operand, Location location);
  Operand dereference(const Operand& operand, Location location);

  // operands.cpp
  ExpressionId add(Expression expression);
  Operand make(Expression expression);
  Operand failOperand(Location location, std::string message);
  Operand unsupported(Location location, Type type, std::string reason);
  Operand unsupportedMemory(Type type, Location location, std::string reason);
  Operand load(Operand operand, Location location);
  Operand hostVariable(const Operand& operand, Location location);
  Operand concrete(const Operand& operand, Location location);
  bool canConvert(const Operand& operand, Type type) const;
  ExpressionId convert(const Operand& operand, Type type, Location location);
  ExpressionId constantOf(Type type, const double* numbers, Location location);
  Operand zero(Type type, Location location);
  Operand abstractOf(Type type, std::vector<double> numbers, Location location);
  std::optional<std::int64_t> constantInteger(const Operand& operand);

  // parse_construct.cpp
  Operand construct(Location location);
  Operand constructType(Type type, Operands operands, Location location);
  Operand constructScalar(Type type, const Operand& operand, Location location);
  Operand inferred(const Token& word, int columns, int rows, Operands operands);
  Operand inferredArray(Operands operands, Location location);
  std::optional<Type> commonType(const Operands& operands) const;
  Operands arguments();

  // parse_calls.cpp
  Operand call(const Token& name);
  Operand callFunction(const Token& name, FunctionId function, const Operands& operands);
  Operand callBuiltIn(const Token& name, Operands operands);
  void checkLimits(const BuiltIn& row, const Operands& operands, Location location);
  Operand asFloats(const Operand& operand, Location location);
  std::optional<Found> matchBuiltIn(std::string_view name, const Operands& operands,
                                    std::vector<Type>& types) const;
  std::string typesOf(const Operands& operands) const;
  Operand foldBuiltIn(const BuiltIn& row, const Operands& operands, Type type, Location location);

  // parse_other_calls.cpp
  Operand callOther(const Token& name, const Operands& operands);
  Operand withStructure(const Token& name, const Operand& operand);
  Operand bitcast(const Token& name);

  // parse_textures.cpp
  Operand callTexture(const Token& name, Operands operands);

  std::vector<Token> tokens_;
  Problems& problems_;
  Tree tree_;
  Constants constants_{tree_, 300};
  Scopes scopes_;
  std::map<std::string_view, Global> globals_;
  std::vector<std::string_view> order_;          // the names of globals
  std::vector<std::size_t> assertions_;          // the positions of const_assert
  std::vector<std::size_t> bodies_;              // the positions of bodies, by function
  std::vector<std::vector<Entity>> parameters_;  // by function
  std::map<std::string, VariableId> hostVariables_;
  std::size_t at_ = 0;
  int depth_ = 0, loops_ = 0, switches_ = 0;
  bool isContinuing_ = false;
  int totalSize_ = 0;
  FunctionId current_ = nothing;
  std::vector<FunctionCall> calls_;
};

template <class Work>
auto Parser::withDepth(const Work& work) {
  ++depth_;
  auto made = work();
  --depth_;
  return made;
}

}  // namespace warpjet::source::wgsl

// Built-in variables and constants: GLSL ES 3.00, section 7.
#include <algorithm>
#include <array>
#include <set>

#include "source/glsl/parser.hpp"
#include "source/glsl/versions.hpp"

namespace warpjet::source::glsl {

namespace {

// A constant, and the minimum that all browsers must support, by version; 0 if the version lacks
// it.
struct Limit {
  std::string_view name;
  int in100, in300;
};
constexpr Limit limits[]{
    {"gl_MaxVertexAttribs", 8, 16},
    {"gl_MaxVertexUniformVectors", 128, 256},
    {"gl_MaxVaryingVectors", 8, 0},
    {"gl_MaxVertexOutputVectors", 0, 16},
    {"gl_MaxFragmentInputVectors", 0, 15},
    {"gl_MaxVertexTextureImageUnits", 0, 16},
    {"gl_MaxCombinedTextureImageUnits", 8, 32},
    {"gl_MaxTextureImageUnits", 8, 16},
    {"gl_MaxFragmentUniformVectors", 16, 224},
    {"gl_MaxDrawBuffers", 1, 4},
    {"gl_MinProgramTexelOffset", 0, -8},
    {"gl_MaxProgramTexelOffset", 0, 7},
};

struct BuiltInVariable {
  std::string_view name;
  Type type;
  Variable::Kind kind;
  bool isOutput = false;
};
constexpr BuiltInVariable variables[]{
    {"gl_Position", vectorType(Base::Float, 4), Variable::Kind::Global, true},
    {"gl_PointSize", floatType, Variable::Kind::Global, true},
    {"gl_VertexID", intType, Variable::Kind::Attribute},
    {"gl_InstanceID", intType, Variable::Kind::Attribute},
    {"gl_FragColor", vectorType(Base::Float, 4), Variable::Kind::Global},
    {"gl_FragDepth", floatType, Variable::Kind::Global},
    {"gl_FragCoord", vectorType(Base::Float, 4), Variable::Kind::Fragment},
    {"gl_FrontFacing", boolType, Variable::Kind::Fragment},
    {"gl_PointCoord", vectorType(Base::Float, 2), Variable::Kind::Fragment},
};

bool existsIn100(std::string_view name) { return versionProblem(100, name).empty(); }

}  // namespace

void Parser::findStage() {
  constexpr std::array ofVertices{std::string_view("gl_Position"), std::string_view("gl_PointSize"),
                                  std::string_view("gl_VertexID"),
                                  std::string_view("gl_InstanceID"), std::string_view("attribute")};
  const Token* stageToken = nullptr;
  for (const Token& token : text_.tokens) {
    const bool isOfVertex =
        std::find(ofVertices.begin(), ofVertices.end(), token.text) != ofVertices.end();
    const bool isOfFragment = token.text.starts_with("gl_Frag") || token.text == "gl_PointCoord" ||
                              token.text == "discard";
    if (!isOfVertex && !isOfFragment) continue;
    const Stage stage = isOfVertex ? Stage::Vertex : Stage::Fragment;
    if (stageToken && stage != stage_)
      return fail(token.location,
                  quote(token.text) + " and " + quote(stageToken->text) +
                      " cannot be used in one shader: one is of vertex shaders, the other "
                      "of fragment shaders");
    stage_ = stage;
    stageToken = &token;
  }
}

// Declares the built-in variables and constants that the source mentions.
void Parser::declareBuiltIns() {
  std::set<std::string_view> named;
  for (const Token& token : text_.tokens)
    if (token.text.starts_with("gl_")) named.insert(token.text);
  for (const auto& [name, type, kind, isOutput] : variables)
    if (named.contains(name)) tree_.variables[declareBuiltIn(name, type, kind)].isOutput = isOutput;
  for (const auto& [name, in100, in300] : limits) {
    if (!named.contains(name)) continue;
    const int value = text_.version == 300 || !existsIn100(name) ? in300 : in100;
    const VariableId variable = declareBuiltIn(name, intType, Variable::Kind::Constant);
    const ExpressionId initializer = add(Expression{
        .kind = Code::Constant, .type = intType, .value = 1.0 * value, .location = end_.location});
    tree_.variables[variable].start = initializer;
    declareGlobally(variable, initializer);
  }
  if (named.contains("gl_FragData")) {
    Type type = vectorType(Base::Float, 4);
    type.length = 1;
    declareBuiltIn("gl_FragData", type, Variable::Kind::Global);
  }
  if (named.contains("gl_DepthRange")) {
    Structure structure{.name = "gl_DepthRangeParameters"};
    for (const std::string_view field : {"near", "far", "diff"})
      structure.add({field, floatType, structure.size++});
    Type type;
    type.base = Base::Struct;
    type.structure = tree_.types.add(structure);
    declareGlobally(declareBuiltIn("gl_DepthRange", type, Variable::Kind::Uniform), nothing);
  }
}

void Parser::declareGlobally(VariableId variable, ExpressionId initializer) {
  tree_.globals.push_back(add(Statement{.kind = Statement::Kind::Declare,
                                        .index = variable,
                                        .expression = initializer,
                                        .location = tree_.variables[variable].location}));
}

VariableId Parser::declareBuiltIn(std::string_view name, Type type, Variable::Kind kind) {
  Token token = end_;
  token.text = name;
  return addVariable(token, type, kind);
}

}  // namespace warpjet::source::glsl

// Tokens, names, and the order in which declarations are parsed.
#include "source/wgsl/parser.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "source/nearest.hpp"
#include "source/wgsl/built_in_table.hpp"
#include "source/wgsl/keywords.hpp"

namespace warpjet::source::wgsl {

Parser::Parser(std::vector<Token> tokens, Problems& problems)
    : tokens_(std::move(tokens)), problems_(problems) {
  tree_.builtIns = builtIns;
}

const Token& Parser::peek(std::size_t ahead) const {
  return problems_.any() || at_ + ahead >= tokens_.size() ? tokens_.back() : tokens_[at_ + ahead];
}

Token Parser::take() {
  const Token& token = peek();
  if (at_ + 1 < tokens_.size()) ++at_;
  return token;
}

bool Parser::accept(std::string_view text) {
  if (!peek().is(text)) return false;
  take();
  return true;
}

std::string Parser::describeNext() const {
  return peek().kind == Token::Kind::End ? "got the end of the source"
                                         : "got " + quote(peek().text);
}

bool Parser::expect(std::string_view text, std::string_view after) {
  if (accept(text)) return true;
  fail(peek().location,
       "expected " + std::string(text) + " after " + std::string(after) + ", " + describeNext());
  return false;
}

Token Parser::takeName(std::string_view what) {
  const Token token = peek();
  if (token.kind != Token::Kind::Name)
    fail(token.location, "expected a name for " + std::string(what) + ", " + describeNext());
  else if (std::string why = nameProblem(token.text); !why.empty())
    fail(token.location, std::move(why));
  take();
  return token;
}

bool Parser::checkDepth() {
  if (depth_ < maxDepth) return !problems_.any();
  fail(peek().location, "this is nested more than " + std::to_string(maxDepth) + " deep");
  return false;
}

// Skips attributes such as `@location(0)`: they are for the pipeline.
void Parser::attributes() {
  while (accept("@")) {
    const Token name = peek();
    constexpr std::array plain{std::string_view("compute"),  std::string_view("const"),
                               std::string_view("fragment"), std::string_view("invariant"),
                               std::string_view("must_use"), std::string_view("vertex")};
    constexpr std::array withArguments{std::string_view("align"),
                                       std::string_view("binding"),
                                       std::string_view("blend_src"),
                                       std::string_view("builtin"),
                                       std::string_view("color"),
                                       std::string_view("diagnostic"),
                                       std::string_view("group"),
                                       std::string_view("id"),
                                       std::string_view("input_attachment_index"),
                                       std::string_view("interpolate"),
                                       std::string_view("location"),
                                       std::string_view("size"),
                                       std::string_view("workgroup_size")};
    const bool isPlain = std::find(plain.begin(), plain.end(), name.text) != plain.end();
    const bool isKnown = isPlain || std::find(withArguments.begin(), withArguments.end(),
                                              name.text) != withArguments.end();
    if (name.kind != Token::Kind::Name || !isKnown)
      return fail(name.location, "expected the name of an attribute after @, " + describeNext());
    take();
    if (isPlain) continue;
    if (!peek().is("(")) {
      expect("(", "@" + std::string(name.text));
      return;
    }
    int open = 0;
    do {
      if (peek().kind == Token::Kind::End) return fail(name.location, "this attribute has no )");
      const Token token = take();
      open += token.is("(") ? 1 : token.is(")") ? -1 : 0;
    } while (open > 0);
  }
}

Tree Parser::parse() {
  directives();
  findGlobals();
  for (const std::string_view name : order_) resolve(name);
  for (const std::size_t at : assertions_) {
    if (problems_.any()) break;
    at_ = at;
    constAssert();
  }
  for (std::size_t i = 0; i < bodies_.size() && !problems_.any(); ++i) functionBody(i);
  if (!problems_.any()) rejectRecursion();
  return std::move(tree_);
}

// Returns the meaning of a name at this point, where a declaration below it may first have to be
// parsed.
Entity Parser::resolve(std::string_view name) {
  if (problems_.any()) return {};
  if (const Entity* local = scopes_.find(name)) return *local;
  const auto found = globals_.find(name);
  if (found == globals_.end()) return {};
  Global& global = found->second;
  if (global.state == Global::State::Open) {
    fail(global.location, quote(name) + " depends on itself");
    return {};
  }
  if (global.state == Global::State::New && checkDepth()) {
    global.state = Global::State::Open;
    const std::size_t at = std::exchange(at_, global.start);
    Scopes outer = std::exchange(scopes_, {});
    const FunctionId current = std::exchange(current_, nothing);
    ++depth_;
    this->global(global);
    --depth_;
    current_ = current;
    scopes_ = std::move(outer);
    at_ = at;
    global.state = Global::State::Done;
  }
  return global.entity;
}

bool Parser::isDeclared(std::string_view name) const {
  return scopes_.find(name) || globals_.contains(name);
}

// Suggests a name that is visible here.
std::string Parser::nearestName(std::string_view name) const {
  Nearest nearest(name);
  scopes_.each([&](std::string_view other, const Entity&) { nearest.offer(other); });
  for (const std::string_view other : order_) nearest.offer(other);
  return nearest.question();
}

void Parser::declare(const Token& name, Entity entity) {
  if (problems_.any()) return;
  if (!scopes_.isFree(name.text))
    return fail(name.location, quote(name.text) + " is already declared here");
  scopes_.add(name.text, std::move(entity));
}

VariableId Parser::addVariable(std::string_view name, Type type, Variable::Kind kind,
                               Location location) {
  const int size = tree_.types.size(type);
  if (size > maxValueSize)
    fail(location, quote(name) + " is too large");
  else if ((totalSize_ += size) > maxHeld)
    fail(location, "the variables of this source are too large in total");
  tree_.variables.push_back({name, type, location, kind});
  return static_cast<VariableId>(tree_.variables.size() - 1);
}

}  // namespace warpjet::source::wgsl

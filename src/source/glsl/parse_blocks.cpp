// Uniform blocks: GLSL ES 3.00, section 4.3.7. If a block has no instance name, its members are
// variables; otherwise they are parts of the instance.
#include "source/glsl/parser.hpp"

namespace warpjet::source::glsl {

using Role = QualifierRole;

bool Parser::startsBlock() const {
  return peek().kind == Kind::Name && peek(1).is("{") && !peek().is("struct");
}

void Parser::uniformBlock(const Qualifiers& given) {
  const Token name = peek();
  requireVersion("a block of uniforms", name.location);
  if (given.word(Role::Storage) != "uniform")
    fail(name.location, "only uniforms have blocks; write uniform before " + quote(name.text));
  allowOnly(given, {Role::Layout, Role::Storage}, "a block of uniforms");
  if (given.hasLocation) fail(name.location, "a block of uniforms has no location; remove it");
  if (!checkFree(name)) return;
  take();
  scope_.add(name.text, {Meaning::Kind::Block});
  const Structure members = blockMembers(name.text);
  if (problems_.any()) return;
  if (accept(";")) {
    for (const Field& each : members.fields) {
      Token member = name;
      member.text = each.name;
      if (!checkFree(member)) return;
      declareUniform(member, each.type);
    }
    return;
  }
  const Token instance = peek();
  if (!checkFree(instance)) return;
  take();
  Type type;
  type.base = Base::Struct;
  type.structure = tree_.types.add(members);
  if (peek().is("[")) type = arrayOf(type);
  if (type.length == 0) fail(instance.location, "an array of blocks needs a length");
  expect(";", "a block of uniforms");
  if (!problems_.any()) declareUniform(instance, type);
}

void Parser::declareUniform(const Token& name, Type type) {
  declareGlobally(addVariable(name, type, Variable::Kind::Uniform), nothing);
}

Structure Parser::blockMembers(std::string_view name) {
  Structure structure{.name = name, .isBlock = true};
  expect("{", "a block of uniforms");
  while (!peek().is("}") && peek().kind != Kind::End) {
    const Qualifiers given = qualifiers();
    allowOnly(given, {Role::Layout, Role::Storage, Role::Precision}, "a member of a block");
    if (given.isWhole)
      fail(peek().location,
           "std140, shared and packed are for whole blocks; write them before uniform");
    const std::string_view storage = given.word(Role::Storage);
    if (!storage.empty() && storage != "uniform")
      fail(peek().location, "a member of a block is a uniform; remove " + quote(storage));
    fields(given, structure);
  }
  const Location end = peek().location;
  expect("}", "the members of a block");
  if (structure.fields.empty()) fail(end, "a block must have a member");
  for (const Field& each : structure.fields)
    if (tree_.types.hasSampler(each.type))
      fail(end, "a block holds numbers; declare the image " + quote(each.name) + " outside of it");
  return structure;
}

}  // namespace warpjet::source::glsl

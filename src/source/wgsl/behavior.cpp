// Determines how statements end: by reaching the next statement, or by a return, break or continue.
// WGSL, section 9.7. A function with a result must not reach its end.
#include "source/wgsl/parser.hpp"

namespace warpjet::source::wgsl {

namespace {

enum Behavior : unsigned { Next = 1, Return = 2, Breaks = 4, Continues = 8 };

}  // namespace

unsigned Parser::behaviorOfLoop(const Statement& loop) const {
  unsigned all = behaviorOf(loop.children[2]);
  if (loop.children[1] != nothing) all |= behaviorOf(loop.children[1]);
  const bool hasEnd = loop.expression != nothing || (all & Breaks);
  return (all & Return) | (hasEnd ? Next : 0u);
}

unsigned Parser::behaviorOf(StatementId id) const {
  if (id == nothing) return Next;
  const Statement& statement = tree_.statements[id];
  using enum Statement::Kind;
  switch (statement.kind) {
    case Block: {
      unsigned all = Next;
      for (const StatementId child : statement.children) {
        if (!(all & Next)) break;
        all = (all & ~Next) | behaviorOf(child);
      }
      return all;
    }
    case If:
      return behaviorOf(statement.children[0]) |
             (statement.children.size() > 1 ? behaviorOf(statement.children[1]) : Next);
    case Loop:
      return behaviorOfLoop(statement);
    case Switch: {
      // The body of each case is a block, followed by a break that the parser has added.
      unsigned all = 0;
      for (const StatementId child : statement.children)
        if (tree_.statements[child].kind == Block) all |= behaviorOf(child);
      return (all & ~Breaks) | (all & Breaks ? Next : 0u);
    }
    case Return:
      return Behavior::Return;
    case Break:
      return Breaks;
    case Continue:
      return Continues;
    default:
      return Next;
  }
}

}  // namespace warpjet::source::wgsl

#include "emit/statement_writer.hpp"

#include <algorithm>

#include "emit/early_end.hpp"
#include "graph/schedule.hpp"

namespace warpjet {

void StatementWriter::bindInput(std::uint32_t input, const std::string& text) {
  if (isPlainVariable(text)) {
    writer_.nameInput(input, text);
    return;
  }
  const std::string name = temporaries_.next();
  define(plan_.dialect.typeName(ops::Type::Float, graph_.input(input).shape), name);
  code_ += text + ";\n";
  writer_.nameInput(input, name);
  ++temporaryCount_;
}

void StatementWriter::define(std::string_view type, std::string_view name) {
  begin(plan_.dialect.definition, type, name);
}

void StatementWriter::begin(std::string_view form, std::string_view type, std::string_view name) {
  code_ += indent_;
  appendExpanded(code_, form, {type, name});
}

void StatementWriter::write(const Statements& statements) {
  const std::size_t firstMatrix = writer_.matrixCount();
  for (const Statement& statement : statements.all) {
    if (const auto rotation = rotationOf(statement))
      writer_.countMatrix(rotation->matrix, firstMatrix);
  }
  for (const std::uint32_t i : schedule(statements.work)) {
    const Statement& statement = statements.all[i];
    const auto rotation = rotationOf(statement);
    if (rotation && writer_.wantsName(rotation->matrix)) nameMatrix(rotation->matrix);
    if (statement.node == noNode)
      assign(*statement.output);
    else if (graph_.isFold(statement.node))
      writeLoop(graph_.loopOf(statement.node));
    else
      compute(statement);
  }
  writer_.forgetMatrices(firstMatrix);
}

std::optional<Packs::Rotation> StatementWriter::rotationOf(const Statement& statement) const {
  if (statement.pack == none) return {};
  const Lanes lanes = plan_.packs[statement.pack];
  const auto rotation = plan_.packs.rotationOf(lanes);
  if (!rotation ||
      plan_.packs.chooseLayout(lanes, Packs::As::Statement).form != Packs::Form::Operation)
    return {};
  return rotation;
}

void StatementWriter::nameMatrix(const Packs::Matrix& matrix) {
  const std::string name = temporaries_.next();
  define(plan_.dialect.typeName(ops::Type::Float, matrixOf(2, 2)), name);
  writer_.writeMatrix(code_, matrix);
  code_ += ";\n";
  writer_.nameMatrix(matrix, name);
  ++temporaryCount_;
}

// Writes a loop. Its variables are declared before it, so that the outcomes can be read after it.
[[gnu::noinline, gnu::cold]] void StatementWriter::writeLoop(std::uint32_t loop) {
  const std::vector<State>& states = plan_.loops->statesOf(loop);
  const std::string_view type = plan_.dialect.typeName(ops::Type::Float, scalarShape);
  std::vector<std::string> variables;
  for (const State& state : states) {
    variables.push_back(temporaries_.next());
    begin(plan_.dialect.variable, type, variables.back());
    writer_.writeValue(code_, scalarShape, {&state.start, 1});
    code_ += ";\n";
  }
  for (std::size_t i = 0; i < states.size(); ++i) writer_.name(states[i].local, variables[i]);
  const std::string counter = temporaries_.next();
  const auto flag = earlyEnd(graph_, states);
  // If no state that is needed reads the end of the loop, steps after the first change nothing.
  const std::uint32_t steps = graph_.loop(loop).isCounted() || flag ? graph_.loop(loop).steps : 1;
  code_ += indent_;
  appendExpanded(code_, plan_.dialect.loop, {counter, std::to_string(steps)});
  indent_ += "  ";
  if (const auto step = plan_.loops->stepOf(loop)) {
    const std::string stepName = temporaries_.next();
    define(type, stepName);
    appendExpanded(code_, plan_.dialect.construction, {type, counter});
    code_ += ";\n";
    writer_.name(*step, stepName);
  }
  write(plan_.statements[loop + 1]);
  assignStates(states);
  if (flag) code_ += indent_ + "if (" + writer_.nameOf(*flag) + " > 0.5) { break; }\n";
  indent_.resize(indent_.size() - 2);
  code_ += indent_ + "}\n";
  temporaryCount_ += states.size();
}

// Assigns all states at once: a new value that reads variables of the loop is computed into a
// temporary before any of them changes.
void StatementWriter::assignStates(std::span<const State> states) {
  std::vector<std::string> sources;
  for (const auto& [local, start, next] : states) {
    std::string& source = sources.emplace_back();
    if (next == local) continue;
    writer_.writeValue(source, scalarShape, {&next, 1});
    const bool isComputed = !graph_.isLocal(next) && !graph_.is(next, ops::find("neg"));
    if (isComputed || graph_.isStep(next) || (writer_.isNamed(next) && !graph_.isLocal(next)))
      continue;
    const std::string copy = temporaries_.next();
    define(plan_.dialect.typeName(ops::Type::Float, scalarShape), copy);
    code_ += source + ";\n";
    source = copy;
  }
  for (std::size_t i = 0; i < states.size(); ++i) {
    if (!sources[i].empty())
      code_ += indent_ + writer_.nameOf(states[i].local) + " = " + sources[i] + ";\n";
  }
}

void StatementWriter::compute(const Statement& statement) {
  const bool isVector = statement.pack != none;
  const Lanes lanes = isVector ? plan_.packs[statement.pack] : Lanes({&statement.node, 1});
  writeComments({lanes.begin(), lanes.end()});
  const std::string name = statement.output ? statement.output->name : temporaries_.next();
  if (statement.output) {
    code_ += indent_ + name + " = ";
  } else {
    const auto vector = plan_.dialect.typeName(ops::Type::Float, vectorOf(lanes.count));
    define(isVector ? std::string(vector) : writer_.typeOf(lanes[0]), name);
    ++temporaryCount_;
    vectorCount_ += isVector;
  }
  if (isVector)
    writer_.writeLanes(code_, lanes, Packs::As::Statement);
  else
    writer_.writeOperation(code_, lanes[0]);
  code_ += ";\n";
  for (int i = 0; i < lanes.count; ++i)
    writer_.name(lanes[i], isVector ? name + '.' + "xyzw"[i] : name);
}

void StatementWriter::assign(const Output& output) {
  writeComments(output.components);
  code_ += indent_ + output.name + " = ";
  if (const auto& sum = plan_.sums[static_cast<std::size_t>(&output - plan_.outputs.data())]) {
    code_ += writer_.inputName(sum->input) + " + " + plan_.outputs[sum->output].name;
  } else {
    writer_.writeValue(code_, output.shape, output.components);
  }
  code_ += ";\n";
}

// Writes the comments of all nodes in a statement, each once.
[[gnu::noinline, gnu::cold]] void StatementWriter::writeComments(std::span<const NodeId> roots) {
  if (plan_.comments.ranges.empty()) return;
  std::vector<NodeId> nodes(roots.begin(), roots.end());
  std::vector<std::uint32_t> written;
  while (!nodes.empty()) {
    const NodeId id = nodes.back();
    nodes.pop_back();
    if (writer_.isNamed(id) || graph_.isLeaf(id)) continue;
    const Comments::Range* comment = plan_.comments.find(id);
    if (comment && std::find(written.begin(), written.end(), comment->text) == written.end()) {
      written.push_back(comment->text);
      code_ += indent_ + "// " + plan_.comments.texts[comment->text] + '\n';
    }
    if (graph_.isOutcome(id)) continue;
    for (int i = 0; i < graph_.arity(id); ++i) nodes.push_back(graph_.operand(id, i));
  }
}

}  // namespace warpjet

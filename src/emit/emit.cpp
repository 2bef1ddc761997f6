#include "emit/emit.hpp"

#include <algorithm>

#include "emit/names.hpp"
#include "emit/schedule.hpp"
#include "emit/writer.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

namespace {

class Emitter {
 public:
  Emitter(const Graph& graph, const Dialect& dialect, std::span<const Output> outputs,
          const EmitOptions& options)
      : graph_(graph),
        dialect_(dialect),
        outputs_(outputs),
        options_(options),
        nodes_(reachable(graph, roots(outputs))),
        writer_(graph, dialect) {}

  Emitted run() {
    constexpr std::size_t usualLength = 24;
    statements_.reserve(nodes_.size() * usualLength);
    reserveNames();
    bindInputs();
    bindScalarOutputs();
    bindTemporaries();
    writeStatements();
    result_.nodes = nodes_.size();
    result_.operations = static_cast<std::size_t>(
        std::count_if(nodes_.begin(), nodes_.end(), [&](NodeId id) { return computes(id); }));
    result_.code = assemble();
    return std::move(result_);
  }

 private:
  bool computes(NodeId id) const { return !graph_.isLeaf(id) && !graph_.isList(id); }

  static std::vector<NodeId> roots(std::span<const Output> outputs) {
    std::vector<NodeId> roots;
    for (const Output& output : outputs) {
      if (!output.sum)
        roots.insert(roots.end(), output.components.begin(), output.components.end());
    }
    return roots;
  }

  void reserveNames() {
    std::vector<bool> used(graph_.inputCount()), called(graph_.functionCount());
    for (const NodeId id : nodes_) {
      if (graph_.isInput(id)) used[graph_.node(id).operands[0]] = true;
      if (graph_.isCall(id)) called[graph_.node(id).operands[1]] = true;
    }
    for (const Output& output : outputs_) {
      if (output.sum) used[output.sum->input] = true;
      temporaries_.reserve(output.name);
    }
    for (std::uint32_t i = 0; i < used.size(); ++i) {
      if (!used[i]) continue;
      result_.inputs.push_back(i);
      temporaries_.reserve(graph_.input(i).label);
    }
    for (std::uint32_t i = 0; i < called.size(); ++i) {
      if (!called[i]) continue;
      result_.functions.push_back(i);
      temporaries_.reserve(graph_.function(i).name);
    }
  }

  // An expression of the host that is more than a variable is computed once.
  void bindInputs() {
    for (const std::uint32_t i : result_.inputs) {
      const Input& input = graph_.input(i);
      if (isPlainVariable(input.label)) {
        writer_.nameInput(i, input.label);
        continue;
      }
      const std::string name = temporaries_.next();
      define(dialect_.typeName(ops::Type::Float, input.shape), name);
      statements_ += input.label + ";\n";
      writer_.nameInput(i, name);
      ++result_.temporaries;
    }
  }

  // The beginning of a statement.
  void define(const std::string& type, const std::string& name) {
    statements_ += "  " + dialect_.definition(type, name);
  }

  // A scalar result is its own temporary.
  void bindScalarOutputs() {
    for (const Output& output : outputs_) {
      const NodeId id = output.components[0];
      if (!output.sum && output.shape.isNumber() && !graph_.isLeaf(id) && !writer_.isNamed(id))
        writer_.name(id, output.name);
    }
  }

  void bindTemporaries() {
    std::vector<std::uint32_t> uses(graph_.size());
    for (const NodeId root : roots(outputs_)) ++uses[index(root)];
    for (const NodeId id : nodes_) {
      for (int i = 0; i < graph_.arity(id); ++i) ++uses[index(graph_.operand(id, i))];
    }

    const std::vector<NodeId> order = schedule(graph_, nodes_);
    std::vector<int> depths(graph_.size());
    for (const NodeId id : order) {
      if (graph_.isLeaf(id)) continue;
      int& depth = depths[index(id)];
      for (int i = 0; i < graph_.arity(id); ++i)
        depth = std::max(depth, depths[index(graph_.operand(id, i))]);
      if (graph_.isList(id)) continue;
      ++depth;
      const bool shared = uses[index(id)] > 1 && !isCheap(id);
      const bool isOutput = writer_.isNamed(id);
      if (!shared && !isOutput && depth < options_.maxDepth) continue;
      depth = 0;
      writeTemporary(id, isOutput);
    }
  }

  // Not worth a temporary: the negative of a variable.
  bool isCheap(NodeId id) const {
    return graph_.is(id, ops::find("neg")) && graph_.isLeaf(graph_.operand(id, 0));
  }

  void writeTemporary(NodeId id, bool isOutput) {
    writeComment(id);
    if (isOutput) {
      statements_ += "  " + writer_.nameOf(id) + " = ";
      writer_.writeOperation(statements_, id);
    } else {
      const std::string name = temporaries_.next();
      define(dialect_.typeName(graph_.type(id), oneNumber), name);
      writer_.writeOperation(statements_, id);
      writer_.name(id, name);
      ++result_.temporaries;
    }
    statements_ += ";\n";
  }

  void writeComment(NodeId id) {
    const auto& comments = options_.comments;
    // What was lowered is younger than all comments, and belongs to the node that it stands for.
    if (!comments.empty() && comments.back().end <= id) id = graph_.origin(id);
    const auto at =
        std::lower_bound(comments.begin(), comments.end(), id,
                         [](const Comment& comment, NodeId node) { return comment.end <= node; });
    if (at != comments.end() && at->first <= id) statements_ += "  // " + at->text + '\n';
  }

  void writeStatements() {
    for (const Output& output : outputs_) {
      const NodeId first = output.components[0];
      if (output.shape.isNumber() && writer_.isNamed(first) && writer_.nameOf(first) == output.name)
        continue;
      statements_ += "  " + output.name + " = ";
      if (output.sum) {
        statements_ +=
            writer_.inputName(output.sum->input) + " + " + outputs_[output.sum->output].name;
      } else {
        writer_.writeValue(statements_, output.shape, output.components);
      }
      statements_ += ";\n";
    }
  }

  // Results are declared outside of a block that holds the temporaries, so that two texts can be
  // spliced into one function, and no temporary can meet a variable of the host.
  std::string assemble() const {
    std::string code;
    std::string group;
    for (const Output& output : outputs_) {
      const std::string type = dialect_.typeName(graph_.type(output.components[0]), output.shape);
      if (type == group && !dialect_.declaresWithVar) {
        code += ", " + output.name;
      } else {
        code += (group.empty() ? "" : ";\n") + dialect_.declaration(type, output.name);
      }
      group = type;
    }
    return code + ";\n{\n" + statements_ + "}\n";
  }

  const Graph& graph_;
  const Dialect& dialect_;
  std::span<const Output> outputs_;
  const EmitOptions& options_;
  std::vector<NodeId> nodes_;
  Writer writer_;
  Temporaries temporaries_;
  std::string statements_;
  Emitted result_;
};

}  // namespace

Emitted emit(const Graph& graph, const Dialect& dialect, std::span<const Output> outputs,
             const EmitOptions& options) {
  if (outputs.empty()) return {};
  return Emitter(graph, dialect, outputs, options).run();
}

}  // namespace warpjet

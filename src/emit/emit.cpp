#include "emit/emit.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "emit/products.hpp"
#include "emit/statement_writer.hpp"
#include "emit/sums.hpp"
#include "graph/flags.hpp"
#include "graph/reachable.hpp"

namespace warpjet {

namespace {

class Emitter {
 public:
  Emitter(const Graph& graph, const Dialect& dialect, std::span<const Output> outputs,
          const EmitOptions& options, const Comments& comments, std::span<const std::string> inputs)
      : graph_(graph),
        dialect_(dialect),
        outputs_(outputs),
        sums_(findSums(graph, outputs)),
        options_(options),
        comments_(comments),
        inputs_(inputs),
        nodes_(reachable(graph, roots())),
        uses_(countUses()),
        products_(
            findProducts(graph, std::span(nodes_).first(hasProducts() ? nodes_.size() : 0), uses_)),
        packs_(graph, dialect, products_.all),
        writer_(graph, dialect, packs_) {
    if (graph.has(foldOp)) loops_.emplace(graph, nodes_);
  }

  EmittedCode run() {
    findOrders();
    findHelpers();
    reserveNames();
    writeStatements();
    result_.nodes = nodes_.size();
    result_.operations = static_cast<std::size_t>(
        std::count_if(nodes_.begin(), nodes_.end(), [&](NodeId id) { return computes(id); }));
    return std::move(result_);
  }

 private:
  // With loops, no products are sought: a loop may compute a term of a sum in its body before the
  // loop, which splits the product.
  bool hasProducts() const { return options_.vectors && !graph_.has(foldOp); }
  bool computes(NodeId id) const { return graph_.isOperation(id) || graph_.isCall(id); }

  std::vector<NodeId> roots() const {
    std::vector<NodeId> roots;
    for (std::size_t i = 0; i < outputs_.size(); ++i) {
      const std::vector<NodeId>& components = outputs_[i].components;
      if (!sums_[i]) roots.insert(roots.end(), components.begin(), components.end());
    }
    return roots;
  }

  // Counts how often each node is read.
  std::vector<std::uint32_t> countUses() const {
    std::vector<std::uint32_t> uses(graph_.size());
    for (const NodeId id : roots()) ++uses[index(id)];
    for (const NodeId id : nodes_) {
      for (int i = 0; i < graph_.arity(id); ++i) ++uses[index(graph_.operand(id, i))];
    }
    return uses;
  }

  // Finds the order of derivatives that each call of our own functions must return.
  void findOrders() {
    for (const NodeId id : nodes_) {
      if (graph_.isResult(id))
        writer_.requestResult(graph_.operand(id, 0), graph_.resultNumber(id));
    }
    for (const NodeId id : nodes_) {
      if (!graph_.isLibraryCall(id)) continue;
      const OurFunction called{graph_.node(id).operands[1], writer_.orderOf(id)};
      if (std::find(result_.ourFunctions.begin(), result_.ourFunctions.end(), called) ==
          result_.ourFunctions.end())
        result_.ourFunctions.push_back(called);
    }
  }

  void findHelpers() {
    Flags isUsed(ops::count);
    for (const NodeId id : nodes_) {
      if (graph_.isOperation(id)) isUsed[index(graph_.node(id).op)] = true;
    }
    for (std::size_t i = 0; i < ops::count; ++i) {
      const Op op{static_cast<std::uint8_t>(i)};
      if (isUsed[i] && !ops::helpers(op, dialect_.language).empty())
        result_.opsWithHelpers.push_back(op);
    }
  }

  void reserveNames() {
    Flags used(graph_.inputCount()), called(graph_.functionCount());
    for (const NodeId id : nodes_) {
      if (graph_.isInput(id)) used[graph_.node(id).operands[0]] = true;
      if (graph_.isCall(id) && !graph_.isLibraryCall(id))
        called[graph_.node(id).operands[1]] = true;
    }
    for (const Output& output : outputs_) temporaries_.reserve(output.name);
    for (const auto& sum : sums_) {
      if (sum) used[sum->input] = true;
    }
    for (std::uint32_t i = 0; i < used.size(); ++i) {
      if (!used[i]) continue;
      result_.inputs.push_back(i);
      temporaries_.reserve(inputs_[i]);
    }
    for (std::uint32_t i = 0; i < called.size(); ++i) {
      if (!called[i]) continue;
      result_.functions.push_back(i);
      temporaries_.reserve(graph_.function(i).name);
    }
  }

  void writeStatements() {
    Plan plan{graph_, dialect_, outputs_, sums_, comments_, packs_, loops_ ? &*loops_ : nullptr};
    StatementWriter writer(plan, writer_, temporaries_);
    constexpr std::size_t typicalLength = 24;
    writer.reserve(nodes_.size() * typicalLength);
    for (const std::uint32_t i : result_.inputs) writer.bindInput(i, inputs_[i]);
    plan.statements =
        makeStatements(graph_, nodes_, uses_, plan.loops, outputs_, sums_, products_, options_);
    packStatements(graph_, nodes_, packs_, plan.statements, options_);
    writer.write();
    result_.temporaries = writer.temporaryCount();
    result_.vectors = writer.vectorCount();
    result_.code = assemble(writer.code());
  }

  // Results are declared outside of a block that holds the temporaries, so that two pieces of code
  // can be spliced into one function and no temporary can clash with a variable of the host.
  std::string assemble(const std::string& statements) const {
    std::string code;
    std::string_view group;
    for (const Output& output : outputs_) {
      const auto type = dialect_.typeName(graph_.type(output.components[0]), output.shape);
      if (type == group && dialect_.declaresSeveral) {
        code += ", " + output.name;
      } else {
        code += (group.empty() ? "" : ";\n") + expand(dialect_.declaration, {type, output.name});
      }
      group = type;
    }
    return code + ";\n{\n" + statements + "}\n";
  }

  const Graph& graph_;
  const Dialect& dialect_;
  std::span<const Output> outputs_;
  std::vector<std::optional<Sum>> sums_;
  const EmitOptions& options_;
  const Comments& comments_;
  std::span<const std::string> inputs_;
  std::vector<NodeId> nodes_;
  std::vector<std::uint32_t> uses_;  // by node
  std::optional<Loops> loops_;
  MatrixProducts products_;
  Packs packs_;
  Writer writer_;
  Temporaries temporaries_;
  EmittedCode result_;
};

}  // namespace

EmittedCode emit(const Graph& graph, const Dialect& dialect, std::span<const Output> outputs,
                 const EmitOptions& options, const Comments& comments,
                 std::span<const std::string> inputs) {
  if (outputs.empty()) return {};
  return Emitter(graph, dialect, outputs, options, comments, inputs).run();
}

std::vector<std::string> inputExpressions(const Graph& graph, const Dialect& dialect) {
  std::vector<std::string> texts;
  for (std::uint32_t i = 0; i < graph.inputCount(); ++i) {
    const Input& input = graph.input(i);
    texts.push_back(input.image ? expand(dialect.imageSize, {texts[*input.image]}) : input.label);
  }
  return texts;
}

}  // namespace warpjet

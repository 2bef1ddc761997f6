#include "emit/emit.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include "emit/names.hpp"
#include "emit/packs.hpp"
#include "emit/products.hpp"
#include "emit/statements.hpp"
#include "emit/sums.hpp"
#include "emit/writer.hpp"
#include "graph/flags.hpp"
#include "graph/folds.hpp"
#include "graph/reachable.hpp"
#include "graph/schedule.hpp"

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

  Emitted run() {
    constexpr std::size_t usualLength = 24;
    statements_.reserve(nodes_.size() * usualLength);
    findOrders();
    findHelped();
    reserveNames();
    bindInputs();
    writeStatements();
    result_.nodes = nodes_.size();
    result_.operations = static_cast<std::size_t>(
        std::count_if(nodes_.begin(), nodes_.end(), [&](NodeId id) { return computes(id); }));
    result_.code = assemble();
    return std::move(result_);
  }

 private:
  // A loop may compute before it what a sum within it has as a term.
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

  // How often each node is read.
  std::vector<std::uint32_t> countUses() const {
    std::vector<std::uint32_t> uses(graph_.size());
    for (const NodeId id : roots()) ++uses[index(id)];
    for (const NodeId id : nodes_) {
      for (int i = 0; i < graph_.arity(id); ++i) ++uses[index(graph_.operand(id, i))];
    }
    return uses;
  }

  // How many derivatives each call of a function of ours has to give.
  void findOrders() {
    for (const NodeId id : nodes_) {
      if (graph_.isResult(id)) writer_.need(graph_.operand(id, 0), graph_.resultNumber(id));
    }
    for (const NodeId id : nodes_) {
      if (!graph_.isOurCall(id)) continue;
      const OurFunction called{graph_.node(id).operands[1], writer_.orderOf(id)};
      if (std::find(result_.ourFunctions.begin(), result_.ourFunctions.end(), called) ==
          result_.ourFunctions.end())
        result_.ourFunctions.push_back(called);
    }
  }

  void findHelped() {
    Flags isUsed(ops::count);
    for (const NodeId id : nodes_) {
      if (graph_.isOperation(id)) isUsed[index(graph_.node(id).op)] = true;
    }
    for (std::size_t i = 0; i < ops::count; ++i) {
      const Op op{static_cast<std::uint8_t>(i)};
      if (isUsed[i] && !ops::helpers(op, dialect_.language).empty()) result_.helped.push_back(op);
    }
  }

  void reserveNames() {
    Flags used(graph_.inputCount()), called(graph_.functionCount());
    for (const NodeId id : nodes_) {
      if (graph_.isInput(id)) used[graph_.node(id).operands[0]] = true;
      if (graph_.isCall(id) && !graph_.isOurCall(id)) called[graph_.node(id).operands[1]] = true;
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

  // An expression of the host that is more than a variable is computed once.
  void bindInputs() {
    for (const std::uint32_t i : result_.inputs) {
      if (isPlainVariable(inputs_[i])) {
        writer_.nameInput(i, inputs_[i]);
        continue;
      }
      const std::string name = temporaries_.next();
      define(dialect_.typeName(ops::Type::Float, graph_.input(i).shape), name);
      statements_ += inputs_[i] + ";\n";
      writer_.nameInput(i, name);
      ++result_.temporaries;
    }
  }

  // The beginning of a statement.
  void define(std::string_view type, std::string_view name) {
    begin(dialect_.definition, type, name);
  }
  void begin(std::string_view form, std::string_view type, std::string_view name) {
    statements_ += indent_;
    fill(statements_, form, {type, name});
  }

  void writeStatements() {
    all_ = makeStatements(graph_, nodes_, uses_, loops_ ? &*loops_ : nullptr, outputs_, sums_,
                          products_, options_);
    packStatements(graph_, nodes_, packs_, all_, options_);
    writeBody(all_[0]);
  }

  void writeBody(const Statements& statements) {
    const std::size_t known = writer_.matrixCount();
    for (const Statement& statement : statements.all) {
      if (const auto turn = turnOf(statement)) writer_.countMatrix(turn->matrix, known);
    }
    for (const std::uint32_t i : schedule(statements.work)) {
      const Statement& statement = statements.all[i];
      const auto turn = turnOf(statement);
      if (turn && writer_.wantsName(turn->matrix)) nameMatrix(turn->matrix);
      if (statement.node == noNode)
        assign(*statement.output);
      else if (graph_.isFold(statement.node))
        writeLoop(graph_.loopOf(statement.node));
      else
        compute(statement);
    }
    writer_.forgetMatrices(known);
  }

  std::optional<Packs::Turn> turnOf(const Statement& statement) const {
    if (statement.pack == none) return {};
    const Lanes lanes = packs_[statement.pack];
    const auto turn = packs_.turnOf(lanes);
    if (!turn || packs_.written(lanes, Packs::As::Statement).form != Packs::Form::Operation)
      return {};
    return turn;
  }

  void nameMatrix(const Packs::Matrix& matrix) {
    const std::string name = temporaries_.next();
    define(dialect_.typeName(ops::Type::Float, matrixOf(2, 2)), name);
    writer_.writeMatrix(statements_, matrix);
    statements_ += ";\n";
    writer_.nameMatrix(matrix, name);
    ++result_.temporaries;
  }

  // Variables live on behind the loop, where they are the outcome.
  [[gnu::noinline, gnu::cold]] void writeLoop(std::uint32_t loop) {
    const std::vector<State>& states = loops_->statesOf(loop);
    const std::string_view type = dialect_.typeName(ops::Type::Float, oneNumber);
    std::vector<std::string> variables;
    for (const State& state : states) {
      variables.push_back(temporaries_.next());
      begin(dialect_.variable, type, variables.back());
      writer_.writeValue(statements_, oneNumber, {&state.start, 1});
      statements_ += ";\n";
    }
    for (std::size_t i = 0; i < states.size(); ++i) writer_.name(states[i].local, variables[i]);
    const std::string counter = temporaries_.next();
    statements_ += indent_;
    fill(statements_, dialect_.loop, {counter, std::to_string(graph_.loop(loop).steps)});
    indent_ += "  ";
    if (const auto step = loops_->stepOf(loop)) {
      const std::string number = temporaries_.next();
      define(type, number);
      fill(statements_, dialect_.construction, {type, counter});
      statements_ += ";\n";
      writer_.name(*step, number);
    }
    writeBody(all_[loop + 1]);
    assignStates(states);
    indent_.resize(indent_.size() - 2);
    statements_ += indent_ + "}\n";
    result_.temporaries += states.size();
  }

  // All at once: what is read from a variable that is assigned too is kept before.
  void assignStates(std::span<const State> states) {
    std::vector<std::string> sources;
    for (const auto& [local, start, next] : states) {
      std::string& source = sources.emplace_back();
      if (next == local) continue;
      writer_.writeValue(source, oneNumber, {&next, 1});
      const bool isOwn = !graph_.isLocal(next) && !graph_.is(next, ops::find("neg"));
      if (isOwn || graph_.isStep(next) || (writer_.isNamed(next) && !graph_.isLocal(next)))
        continue;
      const std::string kept = temporaries_.next();
      define(dialect_.typeName(ops::Type::Float, oneNumber), kept);
      statements_ += source + ";\n";
      source = kept;
    }
    for (std::size_t i = 0; i < states.size(); ++i) {
      if (!sources[i].empty())
        statements_ += indent_ + writer_.nameOf(states[i].local) + " = " + sources[i] + ";\n";
    }
  }

  void compute(const Statement& statement) {
    const bool isVector = statement.pack != none;
    const Lanes lanes = isVector ? packs_[statement.pack] : Lanes({&statement.node, 1});
    writeComments({lanes.begin(), lanes.end()});
    const std::string name = statement.output ? statement.output->name : temporaries_.next();
    if (statement.output) {
      statements_ += indent_ + name + " = ";
    } else {
      const auto vector = dialect_.typeName(ops::Type::Float, vectorOf(lanes.count));
      define(isVector ? std::string(vector) : writer_.typeOf(lanes[0]), name);
      ++result_.temporaries;
      result_.vectors += isVector;
    }
    if (isVector)
      writer_.writeLanes(statements_, lanes, Packs::As::Statement);
    else
      writer_.writeOperation(statements_, lanes[0]);
    statements_ += ";\n";
    for (int i = 0; i < lanes.count; ++i)
      writer_.name(lanes[i], isVector ? name + '.' + "xyzw"[i] : name);
  }

  void assign(const Output& output) {
    writeComments(output.components);
    statements_ += indent_ + output.name + " = ";
    if (const auto& sum = sums_[static_cast<std::size_t>(&output - outputs_.data())]) {
      statements_ += writer_.inputName(sum->input) + " + " + outputs_[sum->output].name;
    } else {
      writer_.writeValue(statements_, output.shape, output.components);
    }
    statements_ += ";\n";
  }

  // Of all nodes that a statement has in it, each once.
  [[gnu::noinline, gnu::cold]] void writeComments(std::span<const NodeId> roots) {
    if (comments_.ranges.empty()) return;
    std::vector<NodeId> nodes(roots.begin(), roots.end());
    std::vector<std::uint32_t> said;
    while (!nodes.empty()) {
      const NodeId id = nodes.back();
      nodes.pop_back();
      if (writer_.isNamed(id) || graph_.isLeaf(id)) continue;
      const Comments::Range* comment = comments_.find(id);
      if (comment && std::find(said.begin(), said.end(), comment->text) == said.end()) {
        said.push_back(comment->text);
        statements_ += indent_ + "// " + comments_.texts[comment->text] + '\n';
      }
      if (graph_.isOutcome(id)) continue;
      for (int i = 0; i < graph_.arity(id); ++i) nodes.push_back(graph_.operand(id, i));
    }
  }

  // Results are declared outside of a block that holds the temporaries, so that two texts can be
  // spliced into one function, and no temporary can meet a variable of the host.
  std::string assemble() const {
    std::string code;
    std::string_view group;
    for (const Output& output : outputs_) {
      const auto type = dialect_.typeName(graph_.type(output.components[0]), output.shape);
      if (type == group && dialect_.declaresSeveral) {
        code += ", " + output.name;
      } else {
        code += (group.empty() ? "" : ";\n") + filled(dialect_.declaration, {type, output.name});
      }
      group = type;
    }
    return code + ";\n{\n" + statements_ + "}\n";
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
  std::vector<Statements> all_;  // outside of all loops, then by loop
  std::string indent_ = "  ";
  std::string statements_;
  Emitted result_;
};

}  // namespace

Emitted emit(const Graph& graph, const Dialect& dialect, std::span<const Output> outputs,
             const EmitOptions& options, const Comments& comments,
             std::span<const std::string> inputs) {
  if (outputs.empty()) return {};
  return Emitter(graph, dialect, outputs, options, comments, inputs).run();
}

std::vector<std::string> inputTexts(const Graph& graph, const Dialect& dialect) {
  std::vector<std::string> texts;
  for (std::uint32_t i = 0; i < graph.inputCount(); ++i) {
    const Input& input = graph.input(i);
    texts.push_back(input.image ? filled(dialect.imageSize, {texts[*input.image]}) : input.label);
  }
  return texts;
}

}  // namespace warpjet

#include "source/constants.hpp"

#include "source/lower.hpp"

namespace warpjet::source {

Constants::Constants(const Tree& tree, int version) : tree_(tree), version_(version) {}
Constants::~Constants() = default;

bool Constants::mayBeConstant(const Expression& node) const {
  using enum Expression::Kind;
  switch (node.kind) {
    case Call:
    case Assign:
    case Increment:
    case HostElement:
    case Unsupported:
      return false;
    case Sequence:
      return version_ != 300;
    case BuiltIn:
      return !readsImage(tree_.builtIns[static_cast<std::size_t>(node.index)]);
    default:
      return true;
  }
}

std::vector<double> Constants::numbers(ExpressionId expression) {
  if (!isConstant(expression)) return {};
  if (!lowering_) lowering_ = std::make_unique<Lowering>(tree_, problems_);
  return lowering_->constant(expression);
}

std::vector<std::int32_t> Constants::integers(ExpressionId expression) {
  if (!tree_.expressions[expression].type.isInteger()) return {};
  std::vector<std::int32_t> bits;
  for (const double number : numbers(expression))
    bits.push_back(
        static_cast<std::int32_t>(static_cast<std::uint32_t>(static_cast<std::int64_t>(number))));
  return bits;
}

std::optional<std::int32_t> Constants::integer(ExpressionId expression) {
  const std::vector<std::int32_t> all = integers(expression);
  return all.size() == 1 ? std::optional(all[0]) : std::nullopt;
}

}  // namespace warpjet::source

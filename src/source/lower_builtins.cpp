// Calls of built-in functions.
#include "source/lower.hpp"

namespace warpjet::source {

Lowering::Value Lowering::builtIn(const Expression& node) {
  const BuiltIn& row = tree_.builtIns[node.index];
  std::vector<Value> x;
  for (std::size_t i = 0; i < node.operands.size(); ++i)
    x.push_back(isOut(row, i) ? Value() : evaluate(node.operands[i]));
  if (problems_.any()) return undefined(node.type);
  const Base base = node.type.base;
  const auto at = [&](std::size_t k, std::size_t i) {
    return x[k].size() == 1 ? x[k][0] : x[k][i];
  };
  const auto forEach = [&](const auto& make) {
    Value value;
    for (int i = 0; i < node.type.components(); ++i)
      value.push_back(make(static_cast<std::size_t>(i)));
    return value;
  };
  const auto min = [&](Id a, Id b) {
    return recorder_.choose(scalar(Operator::Less, base, b, a), b, a);
  };
  const auto max = [&](Id a, Id b) {
    return recorder_.choose(scalar(Operator::Less, base, a, b), b, a);
  };
  const auto multiply = [&](Id a, Id b) { return scalar(Operator::Multiply, Base::Float, a, b); };
  using enum Way;
  switch (row.way) {
    case Each:
      return each(row, x, base);
    case Grouped:
      return applyToVectors(row, x, node);
    case AbsInt:
      return forEach([&](std::size_t i) {
        const Id minus = scalar(Operator::Subtract, base, number(base, 0), x[0][i]);
        return recorder_.choose(scalar(Operator::Less, base, x[0][i], number(base, 0)), minus,
                                x[0][i]);
      });
    case SignInt:
      return forEach([&](std::size_t i) {
        const Id zero = number(base, 0);
        const Id above =
            recorder_.choose(scalar(Operator::Less, base, zero, x[0][i]), number(base, 1), zero);
        return recorder_.choose(scalar(Operator::Less, base, x[0][i], zero), number(base, -1),
                                above);
      });
    case MinInt:
      return forEach([&](std::size_t i) { return min(at(0, i), at(1, i)); });
    case MaxInt:
      return forEach([&](std::size_t i) { return max(at(0, i), at(1, i)); });
    case ClampInt:
      return forEach([&](std::size_t i) { return min(max(at(0, i), at(1, i)), at(2, i)); });
    case MixBool:
      return forEach([&](std::size_t i) { return recorder_.choose(at(2, i), x[1][i], x[0][i]); });
    case PackSigned:
    case PackUnsigned:
      return pack(x[0], row.way == PackSigned);
    case UnpackSigned:
    case UnpackUnsigned:
      return unpack(x[0][0], row.way == UnpackSigned, node.type.rows);
    case PackHalf:
      return {scalar(
          Operator::BitOr, Base::Uint, packHalf(x[0][0]),
          scalar(Operator::ShiftLeft, Base::Uint, packHalf(x[0][1]), number(Base::Int, 16)))};
    case UnpackHalf:
      return {unpackHalf(x[0][0]),
              unpackHalf(scalar(Operator::ShiftRight, Base::Uint, x[0][0], number(Base::Int, 16)))};
    case Modf: {
      const Value whole =
          forEach([&](std::size_t i) { return recorder_.apply(Code::Trunc, base, {x[0][i]}); });
      store(lvalue(node.operands[1]), whole);
      return forEach(
          [&](std::size_t i) { return scalar(Operator::Subtract, base, x[0][i], whole[i]); });
    }
    case Dot: {
      Id sum = scalar(Operator::Multiply, base, x[0][0], x[1][0]);
      for (std::size_t i = 1; i < x[0].size(); ++i)
        sum = scalar(Operator::Add, base, sum, scalar(Operator::Multiply, base, x[0][i], x[1][i]));
      return {sum};
    }
    case Cross:
      return forEach([&](std::size_t i) {
        const std::size_t a = (i + 1) % 3, b = (i + 2) % 3;
        return scalar(Operator::Subtract, base, multiply(x[0][a], x[1][b]),
                      multiply(x[0][b], x[1][a]));
      });
    case MatrixCompMult:
      return forEach([&](std::size_t i) { return multiply(x[0][i], x[1][i]); });
    case OuterProduct:
      return forEach(
          [&](std::size_t i) { return multiply(x[0][i % x[0].size()], x[1][i / x[0].size()]); });
    case Transpose: {
      const std::size_t rows = node.type.rows, columns = node.type.columns;
      return forEach([&](std::size_t i) { return x[0][(i % rows) * columns + i / rows]; });
    }
    case Compare: {
      const Base compared = recorder_.base(x[0][0]);
      return forEach([&](std::size_t i) { return compare(row.code, compared, x[0][i], x[1][i]); });
    }
    case Any:
    case All: {
      Id value = x[0][0];
      for (const Id each : x[0])
        value =
            row.way == Any ? recorder_.logicalOr(value, each) : recorder_.logicalAnd(value, each);
      return {value};
    }
    case Not:
      return forEach([&](std::size_t i) { return recorder_.logicalNot(x[0][i]); });
    // Assumes that the values of a warp are numbers; otherwise there would be no position.
    case IsNan:
      // In WGSL, != of NaN may be false.
      return forEach([&](std::size_t i) {
        return recorder_.logicalNot(recorder_.apply(Code::Eq, base, {x[0][i], x[0][i]}));
      });
    case IsInf:
      return forEach([&](std::size_t i) {
        const Id size = recorder_.apply(Code::Abs, Base::Float, {x[0][i]});
        return recorder_.apply(Code::Gt, base, {size, number(Base::Float, 3.4028234663852886e38)});
      });
    case Texture:
    case TextureProj:
      return lookUp(row, x);
    case TextureSize:
    case TexelFetch: {
      const Id level = x[row.way == TextureSize ? 1 : 2][0];
      if (!recorder_.isConstant(level) || recorder_.value(level) != 0) {
        problems_.add(node.location, "only level 0 of an image can be read; write " +
                                         std::string(row.name) + "(…, 0)");
        return undefined(node.type);
      }
      if (row.way == TextureSize) return imageSize(x[0]);
      return lookUp(row, x);
    }
    case Unsupported:
      break;
    default:
      return lowerWgslBuiltIn(row, x, node);
  }
  problems_.add(
      node.location,
      quote(row.name) + " cannot be used in a warp; read the image by texture(image, uv)");
  return undefined(node.type);
}

// Applies the operation componentwise; scalars are broadcast.
Lowering::Value Lowering::each(const BuiltIn& row, const std::vector<Value>& x, Base base) {
  std::size_t size = 1;
  for (const Value& operand : x) size = std::max(size, operand.size());
  const auto at = [&](std::size_t k, std::size_t i) {
    return x[k].size() == 1 ? x[k][0] : x[k][i];
  };
  Value value;
  for (std::size_t i = 0; i < size; ++i)
    value.push_back(x.size() == 1 ? recorder_.apply(row.code, base, {at(0, i)})
                    : x.size() == 2
                        ? recorder_.apply(row.code, base, {at(0, i), at(1, i)})
                        : recorder_.apply(row.code, base, {at(0, i), at(1, i), at(2, i)}));
  return value;
}

Id Lowering::compare(Code code, Base base, Id x, Id y) {
  switch (code) {
    case Code::Lt:
      return scalar(Operator::Less, base, x, y);
    case Code::Le:
      return scalar(Operator::AtMost, base, x, y);
    case Code::Gt:
      return scalar(Operator::Greater, base, x, y);
    case Code::Ge:
      return scalar(Operator::AtLeast, base, x, y);
    case Code::Eq:
      return scalar(Operator::Equal, base, x, y);
    default:
      return scalar(Operator::Unequal, base, x, y);
  }
}

Id Lowering::packGroup(Type type, const Value& value) {
  if (type.isScalar()) return value[0];
  const int first = static_cast<int>(type.isMatrix() ? Code::Mat2 : Code::Vec2);
  return recorder_.group(static_cast<Code>(first + type.rows - 2), value);
}

Lowering::Value Lowering::unpackGroup(Id group, Type type) {
  if (type.isScalar()) return {group};
  Value value;
  for (int i = 0; i < type.components(); ++i)
    value.push_back(recorder_.component(group, i, type.layout()));
  return value;
}

Lowering::Value Lowering::applyToVectors(const BuiltIn& row, const std::vector<Value>& x,
                                         const Expression& node) {
  const Type first = tree_.expressions[node.operands[0]].type;
  if (recorder_.foldsAll()) return expandFunction(row.code, x);
  if (first.isScalar()) {
    // The formulas are simpler for scalars.
    const auto minus = [&](Id a, Id b) { return scalar(Operator::Subtract, Base::Float, a, b); };
    const auto times = [&](Id a, Id b) { return scalar(Operator::Multiply, Base::Float, a, b); };
    const Id two = number(Base::Float, 2), zero = number(Base::Float, 0);
    switch (row.code) {
      case Code::Length:
        return {recorder_.apply(Code::Abs, Base::Float, {x[0][0]})};
      case Code::Distance:
        return {recorder_.apply(Code::Abs, Base::Float, {minus(x[0][0], x[1][0])})};
      case Code::Normalize:
        return {recorder_.apply(Code::Sign, Base::Float, {x[0][0]})};
      case Code::Reflect:
        return {minus(x[0][0], times(times(two, times(x[1][0], x[0][0])), x[1][0]))};
      case Code::Faceforward: {
        const Id isFacing = scalar(Operator::Less, Base::Float, times(x[2][0], x[1][0]), zero);
        return {recorder_.choose(isFacing, x[0][0],
                                 recorder_.apply(Code::Neg, Base::Float, {x[0][0]}))};
      }
      default: {
        // Uses a vector with one significant component.
        std::vector<Id> operands;
        for (std::size_t i = 0; i < 2; ++i)
          operands.push_back(packGroup(vectorType(Base::Float, 2), {x[i][0], zero}));
        operands.push_back(x[2][0]);
        return {recorder_.component(recorder_.group(row.code, operands), 0,
                                    vectorType(Base::Float, 2).layout())};
      }
    }
  }
  std::vector<Id> operands;
  for (std::size_t i = 0; i < x.size(); ++i)
    operands.push_back(packGroup(tree_.expressions[node.operands[i]].type, x[i]));
  return unpackGroup(recorder_.group(row.code, operands), node.type);
}

// Reads an image at a vec2 or ivec2, or, in projections, at a vector divided by its last component;
// adds the offset, if there is one.
Lowering::Value Lowering::lookUp(const BuiltIn& row, const std::vector<Value>& x) {
  const bool isFetched = row.way == Way::TexelFetch;
  Value at(x[1].begin(), x[1].begin() + 2);
  const Id last = x[1].back();
  const Value size = hasOffset(row) && !isFetched ? imageSize(x[0]) : Value();
  for (std::size_t i = 0; i < 2; ++i) {
    Id& each = at[i];
    each = recorder_.convert(each, Base::Float);
    if (row.way == Way::TextureProj) each = scalar(Operator::Divide, Base::Float, each, last);
    if (!hasOffset(row)) continue;
    Id offset = recorder_.convert(x.back()[i], Base::Float);
    if (!isFetched)
      offset =
          scalar(Operator::Divide, Base::Float, offset, recorder_.convert(size[i], Base::Float));
    each = scalar(Operator::Add, Base::Float, each, offset);
  }
  return texture(isFetched ? Code::FetchedTexel : Code::Texel, x[0], at);
}

Lowering::Value Lowering::texture(Code code, const Value& image, const Value& at) {
  const std::vector<Id> operands{image[0], packGroup(vectorType(Base::Float, 2), at)};
  return unpackGroup(recorder_.group(code, operands), vectorType(Base::Float, 4));
}

Lowering::Value Lowering::imageSize(const Value& image) {
  Value size = unpackGroup(recorder_.group(Code::ImageSize, image), vectorType(Base::Float, 2));
  for (Id& each : size) each = recorder_.convert(each, Base::Int);
  return size;
}

}  // namespace warpjet::source

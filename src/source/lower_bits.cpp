// Lowers the built-in functions that only WGSL has: those of bits and bytes, of the parts of a
// float, and some others.
#include "source/lower.hpp"

namespace warpjet::source {

Lowering::Value Lowering::lowerWgslBuiltIn(const BuiltIn& builtIn, const std::vector<Value>& x,
                                           const Expression& node) {
  using enum Way;
  const auto forEach = [&](const auto& make) {
    Value value;
    for (std::size_t i = 0; i < x[0].size(); ++i) value.push_back(make(i));
    return value;
  };
  const auto joined = [](Value first, const Value& second) {
    first.insert(first.end(), second.begin(), second.end());
    return first;
  };
  const auto apply = [&](Code code, Id value) {
    return recorder_.apply(code, Base::Float, {value});
  };
  const auto floatOf = [&](Operator op, Id a, Id b) { return scalar(op, Base::Float, a, b); };
  const Base base = node.type.base;
  switch (builtIn.way) {
    case Same:
      return x[0];
    case Saturate:
      return forEach([&](std::size_t i) {
        return recorder_.apply(Code::Clamp, base, {x[0][i], number(base, 0), number(base, 1)});
      });
    case Fma:
      return forEach([&](std::size_t i) {
        return floatOf(Operator::Add, floatOf(Operator::Multiply, x[0][i], x[1][i]), x[2][i]);
      });
    case Ldexp:
      return forEach([&](std::size_t i) { return ldexp(x[0][i], x[1][i]); });
    case QuantizeToHalf:
      return forEach([&](std::size_t i) { return unpackHalf(packHalf(x[0][i])); });
    case ModfPair: {
      const Value whole = forEach([&](std::size_t i) { return apply(Code::Trunc, x[0][i]); });
      return joined(
          forEach([&](std::size_t i) { return floatOf(Operator::Subtract, x[0][i], whole[i]); }),
          whole);
    }
    case Frexp: {
      const Value exponents = forEach([&](std::size_t i) { return exponentOf(x[0][i]); });
      return joined(forEach([&](std::size_t i) {
                      return ldexp(x[0][i], scalar(Operator::Subtract, Base::Int,
                                                   number(Base::Int, 0), exponents[i]));
                    }),
                    exponents);
    }
    case ExtractBits:
      return forEach([&](std::size_t i) { return extract(base, x[0][i], x[1][0], x[2][0]); });
    case InsertBits:
      return forEach([&](std::size_t i) {
        return recorder_.convert(insert(recorder_.convert(x[0][i], Base::Uint),
                                        recorder_.convert(x[1][i], Base::Uint), x[2][0], x[3][0]),
                                 base);
      });
    case DotBytes:
    case PackBytes:
    case PackBytesClamped:
    case UnpackBytes:
      return bytes(builtIn, x, node);
    default:
      return forEach([&](std::size_t i) { return bit(builtIn.way, base, x[0][i]); });
  }
}

// Lowers a function of the four bytes of a uint.
Lowering::Value Lowering::bytes(const BuiltIn& builtIn, const std::vector<Value>& x,
                                const Expression& node) {
  const auto byte = [&](Id bits, Base base, int i) { return partOfBits(bits, base, 8, i); };
  if (builtIn.way == Way::UnpackBytes) {
    Value value;
    for (int i = 0; i < 4; ++i) value.push_back(byte(x[0][0], node.type.base, i));
    return value;
  }
  const Base base = builtIn.way == Way::DotBytes ? node.type.base : recorder_.base(x[0][0]);
  Id all = number(builtIn.way == Way::DotBytes ? base : Base::Uint, 0);
  for (int i = 0; i < 4; ++i) {
    if (builtIn.way == Way::DotBytes) {
      all =
          scalar(Operator::Add, base, all,
                 scalar(Operator::Multiply, base, byte(x[0][0], base, i), byte(x[1][0], base, i)));
      continue;
    }
    Id each = x[0][static_cast<std::size_t>(i)];
    if (builtIn.way == Way::PackBytesClamped) {
      const Id low = number(base, base == Base::Int ? -128 : 0);
      const Id high = number(base, base == Base::Int ? 127 : 255);
      each = recorder_.choose(scalar(Operator::Less, base, each, low), low, each);
      each = recorder_.choose(scalar(Operator::Less, base, high, each), high, each);
    }
    const Id part = scalar(Operator::BitAnd, Base::Uint, recorder_.convert(each, Base::Uint),
                           number(Base::Uint, 255));
    all = scalar(Operator::BitOr, Base::Uint, all,
                 scalar(Operator::ShiftLeft, Base::Uint, part, number(Base::Int, 8.0 * i)));
  }
  return {all};
}

// Lowers a function that counts or finds bits in an int or uint.
Id Lowering::bit(Way way, Base base, Id x) {
  const auto uint = [&](double value) { return number(Base::Uint, value); };
  const auto uintOf = [&](Operator op, Id a, Id b) { return scalar(op, Base::Uint, a, b); };
  const Id bits = recorder_.convert(x, Base::Uint);
  // Returns all bits below the lowest one that is set.
  const auto below = [&] {
    return uintOf(Operator::BitAnd, recorder_.apply(Code::BitNot, Base::Uint, {bits}),
                  uintOf(Operator::Subtract, bits, uint(1)));
  };
  const Id isZero = uintOf(Operator::Equal, bits, uint(0));
  const Id none = uint(4294967295.0);
  const auto result = [&]() -> Id {
    using enum Way;
    switch (way) {
      case CountOneBits:
        return countOnes(bits);
      case CountLeadingZeros:
        return uintOf(Operator::Subtract, uint(32), countOnes(smear(bits)));
      case CountTrailingZeros:
        return countOnes(below());
      case FirstTrailingBit:
        return recorder_.choose(isZero, none, countOnes(below()));
      case FirstLeadingBit: {
        // For a negative int, the first bit that differs from the sign.
        Id significant = bits;
        if (base == Base::Int) {
          const Id isNegative = scalar(Operator::Less, Base::Int, x, number(Base::Int, 0));
          significant =
              recorder_.choose(isNegative, recorder_.apply(Code::BitNot, Base::Uint, {bits}), bits);
        }
        const Id position = uintOf(Operator::Subtract, countOnes(smear(significant)), uint(1));
        return recorder_.choose(uintOf(Operator::Equal, significant, uint(0)), none, position);
      }
      default:
        return reverse(bits);
    }
  }();
  return recorder_.convert(result, base);
}

// Sets all bits below the highest one that is set.
Id Lowering::smear(Id bits) {
  for (int width = 1; width < 32; width *= 2)
    bits = scalar(Operator::BitOr, Base::Uint, bits,
                  scalar(Operator::ShiftRight, Base::Uint, bits, number(Base::Int, width)));
  return bits;
}

// Counts the bits that are set: adds neighboring bits, then neighboring pairs, and so on.
Id Lowering::countOnes(Id bits) {
  constexpr double masks[]{1431655765, 858993459, 252645135, 16711935, 65535};
  int width = 1;
  for (const double mask : masks) {
    const Id every = number(Base::Uint, mask);
    const Id upper = scalar(Operator::ShiftRight, Base::Uint, bits, number(Base::Int, width));
    bits = scalar(Operator::Add, Base::Uint, scalar(Operator::BitAnd, Base::Uint, bits, every),
                  scalar(Operator::BitAnd, Base::Uint, upper, every));
    width *= 2;
  }
  return bits;
}

// Reverses the bits: swaps neighboring bits, then neighboring pairs, and so on.
Id Lowering::reverse(Id bits) {
  constexpr double masks[]{1431655765, 858993459, 252645135, 16711935, 65535};
  int width = 1;
  for (const double mask : masks) {
    const Id every = number(Base::Uint, mask), shift = number(Base::Int, width);
    const Id down = scalar(Operator::BitAnd, Base::Uint,
                           scalar(Operator::ShiftRight, Base::Uint, bits, shift), every);
    const Id up = scalar(Operator::ShiftLeft, Base::Uint,
                         scalar(Operator::BitAnd, Base::Uint, bits, every), shift);
    bits = scalar(Operator::BitOr, Base::Uint, down, up);
    width *= 2;
  }
  return bits;
}

// Returns `count` bits from `offset` on, as a number; for an int, the highest of these bits is the
// sign.
Id Lowering::extract(Base base, Id x, Id offset, Id count) {
  const auto uintOf = [&](Operator op, Id a, Id b) { return scalar(op, Base::Uint, a, b); };
  const auto min = [&](Id a, Id b) { return recorder_.choose(uintOf(Operator::Less, b, a), b, a); };
  const Id wordSize = number(Base::Uint, 32);
  const Id start = min(offset, wordSize);
  const Id size = min(count, uintOf(Operator::Subtract, wordSize, start));
  const Id isEmpty = uintOf(Operator::Equal, size, number(Base::Uint, 0));
  const Id unused = uintOf(Operator::Subtract, wordSize, size);
  const Id up = scalar(Operator::ShiftLeft, base, x, uintOf(Operator::Subtract, unused, start));
  return recorder_.choose(isEmpty, number(base, 0), scalar(Operator::ShiftRight, base, up, unused));
}

// Replaces `count` bits of x from `offset` on by the lowest bits of `bits`.
Id Lowering::insert(Id x, Id bits, Id offset, Id count) {
  const auto uintOf = [&](Operator op, Id a, Id b) { return scalar(op, Base::Uint, a, b); };
  const auto min = [&](Id a, Id b) { return recorder_.choose(uintOf(Operator::Less, b, a), b, a); };
  const Id wordSize = number(Base::Uint, 32);
  const Id start = min(offset, wordSize);
  const Id size = min(count, uintOf(Operator::Subtract, wordSize, start));
  const Id isEmpty = uintOf(Operator::Equal, size, number(Base::Uint, 0));
  const Id ones = uintOf(Operator::ShiftRight, number(Base::Uint, 4294967295.0),
                         uintOf(Operator::Subtract, wordSize, size));
  const Id mask = uintOf(Operator::ShiftLeft, ones, start);
  const Id kept = uintOf(Operator::BitAnd, x, recorder_.apply(Code::BitNot, Base::Uint, {mask}));
  const Id placed = uintOf(Operator::BitAnd, uintOf(Operator::ShiftLeft, bits, start), mask);
  return recorder_.choose(isEmpty, x, uintOf(Operator::BitOr, kept, placed));
}

// Multiplies x by a power of two, in two steps, since the power alone may be too large for a float.
Id Lowering::ldexp(Id x, Id exponent) {
  const auto intOf = [&](Operator op, Id a, Id b) { return scalar(op, Base::Int, a, b); };
  const auto powerOfTwo = [&](Id part) {
    const Id bits = intOf(Operator::ShiftLeft, intOf(Operator::Add, part, number(Base::Int, 127)),
                          number(Base::Int, 23));
    return recorder_.apply(Code::FloatOfBits, Base::Float, {bits});
  };
  const Id half = intOf(Operator::ShiftRight, exponent, number(Base::Int, 1));
  const Id rest = intOf(Operator::Subtract, exponent, half);
  return scalar(Operator::Multiply, Base::Float,
                scalar(Operator::Multiply, Base::Float, x, powerOfTwo(half)), powerOfTwo(rest));
}

// Returns the exponent of frexp: |x| is 2 to that exponent times a number from 0.5 to 1. For 0 it
// is 0.
Id Lowering::exponentOf(Id x) {
  const Id bits = recorder_.apply(Code::FloatBits, Base::Int, {x});
  const Id biased = scalar(Operator::BitAnd, Base::Int,
                           scalar(Operator::ShiftRight, Base::Int, bits, number(Base::Int, 23)),
                           number(Base::Int, 255));
  const Id isZero = recorder_.apply(Code::Eq, Base::Bool, {x, number(Base::Float, 0)});
  return recorder_.choose(isZero, number(Base::Int, 0),
                          scalar(Operator::Subtract, Base::Int, biased, number(Base::Int, 126)));
}

}  // namespace warpjet::source

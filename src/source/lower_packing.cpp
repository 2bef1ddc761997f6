// Packs numbers into the bits of a uint, and unpacks them.
#include "source/lower.hpp"

namespace warpjet::source {

namespace {

// Returns the number whose lowest `bits` bits are ones.
double ones(double bits) {
  return static_cast<double>((std::uint64_t{1} << static_cast<int>(bits)) - 1);
}

}  // namespace

// Packs numbers from 0 or -1 to 1 into equal parts of a uint; the first one is the lowest part.
Lowering::Value Lowering::pack(const Value& numbers, bool isSigned) {
  const auto constant = [&](double value) { return number(Base::Float, value); };
  const double width = 32.0 / static_cast<double>(numbers.size());
  const double maxPart = ones(isSigned ? width - 1 : width);
  Id all = number(Base::Uint, 0);
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const Id clamped = recorder_.apply(Code::Clamp, Base::Float,
                                       {numbers[i], constant(isSigned ? -1 : 0), constant(1)});
    const Id scaled = scalar(Operator::Multiply, Base::Float, clamped, constant(maxPart));
    const Id whole =
        recorder_.convert(recorder_.apply(Code::Round, Base::Float, {scaled}), Base::Int);
    const Id part = scalar(Operator::BitAnd, Base::Uint, recorder_.convert(whole, Base::Uint),
                           number(Base::Uint, ones(width)));
    all = scalar(Operator::BitOr, Base::Uint, all,
                 scalar(Operator::ShiftLeft, Base::Uint, part,
                        number(Base::Int, width * static_cast<double>(i))));
  }
  return {all};
}

Lowering::Value Lowering::unpack(Id bits, bool isSigned, int count) {
  Value value;
  const double width = 32.0 / count;
  const double maxPart = ones(isSigned ? width - 1 : width);
  for (int i = 0; i < count; ++i) {
    const Id part = partOfBits(bits, isSigned ? Base::Int : Base::Uint, width, i);
    const Id scaled = scalar(Operator::Divide, Base::Float, recorder_.convert(part, Base::Float),
                             number(Base::Float, maxPart));
    value.push_back(isSigned
                        ? recorder_.apply(Code::Max, Base::Float, {scaled, number(Base::Float, -1)})
                        : scaled);
  }
  return value;
}

// Returns part number `i` of the bits. Shifts it to the upper end and back, which extends the sign
// of an int.
Id Lowering::partOfBits(Id bits, Base base, double width, int i) {
  const Id up = scalar(Operator::ShiftLeft, base, recorder_.convert(bits, base),
                       number(Base::Int, 32 - width - width * i));
  return scalar(Operator::ShiftRight, base, up, number(Base::Int, 32 - width));
}

// Rounds a number to the 16 bits of a half float: a sign, five bits of exponent, ten of fraction.
// Ties round to even.
Id Lowering::packHalf(Id x) {
  using enum Operator;
  const auto uint = [&](double value) { return number(Base::Uint, value); };
  const auto uintOf = [&](Operator op, Id a, Id b) { return scalar(op, Base::Uint, a, b); };
  const Id bits = recorder_.apply(Code::FloatBits, Base::Uint, {x});
  const Id size = uintOf(BitAnd, bits, uint(0x7fffffff));
  const Id sign = uintOf(BitAnd, uintOf(ShiftRight, bits, number(Base::Int, 16)), uint(0x8000));
  const Id odd = uintOf(BitAnd, uintOf(ShiftRight, size, number(Base::Int, 13)), uint(1));
  const Id normal =
      uintOf(ShiftRight,
             uintOf(Subtract, uintOf(Add, size, uintOf(Add, odd, uint(0xfff))), uint(0x38000000)),
             number(Base::Int, 13));
  // Below 2^-14, half floats have the same spacing as at 2^-14.
  const Id scaled = scalar(Multiply, Base::Float, recorder_.apply(Code::Abs, Base::Float, {x}),
                           number(Base::Float, 16777216));
  const Id bounded = recorder_.apply(Code::Min, Base::Float, {scaled, number(Base::Float, 1024)});
  const Id tiny =
      recorder_.convert(recorder_.apply(Code::Round, Base::Float, {bounded}), Base::Uint);
  Id half = recorder_.choose(uintOf(Less, size, uint(0x38800000)), tiny, normal);
  // Numbers from 65520 up become infinite.
  half = recorder_.choose(uintOf(Less, size, uint(0x477ff000)), half, uint(0x7c00));
  return uintOf(BitOr, sign, half);
}

// Unpacks the lower 16 bits. Infinity and NaN become numbers from 65536 up, with their sign: no
// vertex is that far away, and infinite constants can't be written.
Id Lowering::unpackHalf(Id bits) {
  using enum Operator;
  const auto uint = [&](double value) { return number(Base::Uint, value); };
  const auto uintOf = [&](Operator op, Id a, Id b) { return scalar(op, Base::Uint, a, b); };
  const Id size = uintOf(BitAnd, bits, uint(0x7fff));
  const Id normal = recorder_.apply(
      Code::FloatOfBits, Base::Float,
      {uintOf(Add, uintOf(ShiftLeft, size, number(Base::Int, 13)), uint(0x38000000))});
  const Id tiny = scalar(Multiply, Base::Float, recorder_.convert(size, Base::Float),
                         number(Base::Float, 1.0 / 16777216));
  const Id value = recorder_.choose(uintOf(Less, size, uint(0x400)), tiny, normal);
  const Id isNegative = uintOf(Equal, uintOf(BitAnd, bits, uint(0x8000)), uint(0x8000));
  return recorder_.choose(isNegative, recorder_.apply(Code::Neg, Base::Float, {value}), value);
}

}  // namespace warpjet::source

// Packs two numbers into the bits of a uint, and unpacks them.
#include "source/lower.hpp"

namespace warpjet::source {

// Packs two numbers from 0 or -1 to 1 into the halves of a uint; the first one is the lower half.
Lowering::Value Lowering::pack(const Value& numbers, bool isSigned) {
  const auto constant = [&](double value) { return number(Base::Float, value); };
  Id all = number(Base::Uint, 0);
  for (int i = 0; i < 2; ++i) {
    const Id clamped = recorder_.apply(
        Code::Clamp, Base::Float,
        {numbers[static_cast<std::size_t>(i)], constant(isSigned ? -1 : 0), constant(1)});
    const Id scaled =
        scalar(Operator::Multiply, Base::Float, clamped, constant(isSigned ? 32767 : 65535));
    const Id whole =
        recorder_.convert(recorder_.apply(Code::Round, Base::Float, {scaled}), Base::Int);
    const Id half = scalar(Operator::BitAnd, Base::Uint, recorder_.convert(whole, Base::Uint),
                           number(Base::Uint, 65535));
    all = scalar(Operator::BitOr, Base::Uint, all,
                 scalar(Operator::ShiftLeft, Base::Uint, half, number(Base::Int, 16.0 * i)));
  }
  return {all};
}

Lowering::Value Lowering::unpack(Id bits, bool isSigned) {
  Value value;
  const Base base = isSigned ? Base::Int : Base::Uint;
  for (int i = 0; i < 2; ++i) {
    // Shifts to the upper end and back, which extends the sign.
    const Id up = scalar(Operator::ShiftLeft, base, recorder_.convert(bits, base),
                         number(Base::Int, 16.0 - 16.0 * i));
    const Id half = scalar(Operator::ShiftRight, base, up, number(Base::Int, 16));
    const Id scaled = scalar(Operator::Divide, Base::Float, recorder_.convert(half, Base::Float),
                             number(Base::Float, isSigned ? 32767 : 65535));
    value.push_back(isSigned
                        ? recorder_.apply(Code::Max, Base::Float, {scaled, number(Base::Float, -1)})
                        : scaled);
  }
  return value;
}

// Rounds a number to the 16 bits of a half float: a sign, five bits of exponent, ten of fraction.
// Ties round to even.
Id Lowering::packHalf(Id x) {
  using enum Operator;
  const auto uint = [&](double value) { return number(Base::Uint, value); };
  const auto of = [&](Operator op, Id a, Id b) { return scalar(op, Base::Uint, a, b); };
  const Id bits = recorder_.apply(Code::FloatBits, Base::Uint, {x});
  const Id size = of(BitAnd, bits, uint(0x7fffffff));
  const Id sign = of(BitAnd, of(ShiftRight, bits, number(Base::Int, 16)), uint(0x8000));
  const Id odd = of(BitAnd, of(ShiftRight, size, number(Base::Int, 13)), uint(1));
  const Id normal =
      of(ShiftRight, of(Subtract, of(Add, size, of(Add, odd, uint(0xfff))), uint(0x38000000)),
         number(Base::Int, 13));
  // Below 2^-14, they are spaced as at 2^-14.
  const Id scaled = scalar(Multiply, Base::Float, recorder_.apply(Code::Abs, Base::Float, {x}),
                           number(Base::Float, 16777216));
  const Id bounded = recorder_.apply(Code::Min, Base::Float, {scaled, number(Base::Float, 1024)});
  const Id tiny =
      recorder_.convert(recorder_.apply(Code::Round, Base::Float, {bounded}), Base::Uint);
  Id half = recorder_.choose(of(Less, size, uint(0x38800000)), tiny, normal);
  // Numbers from 65520 up become infinite.
  half = recorder_.choose(of(Less, size, uint(0x477ff000)), half, uint(0x7c00));
  return of(BitOr, sign, half);
}

// Unpacks the lower 16 bits. Infinity and NaN become 65536 and more, with their sign: no vertex
// goes there, and infinite constants can't be written.
Id Lowering::unpackHalf(Id bits) {
  using enum Operator;
  const auto uint = [&](double value) { return number(Base::Uint, value); };
  const auto of = [&](Operator op, Id a, Id b) { return scalar(op, Base::Uint, a, b); };
  const Id size = of(BitAnd, bits, uint(0x7fff));
  const Id normal =
      recorder_.apply(Code::FloatOfBits, Base::Float,
                      {of(Add, of(ShiftLeft, size, number(Base::Int, 13)), uint(0x38000000))});
  const Id tiny = scalar(Multiply, Base::Float, recorder_.convert(size, Base::Float),
                         number(Base::Float, 1.0 / 16777216));
  const Id value = recorder_.choose(of(Less, size, uint(0x400)), tiny, normal);
  const Id isBelow = of(Equal, of(BitAnd, bits, uint(0x8000)), uint(0x8000));
  return recorder_.choose(isBelow, recorder_.apply(Code::Neg, Base::Float, {value}), value);
}

}  // namespace warpjet::source

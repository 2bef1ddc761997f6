#include "source/fold.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace warpjet::source {

namespace {

std::uint32_t bits(double x) { return static_cast<std::uint32_t>(static_cast<std::int64_t>(x)); }
std::int32_t wrapInt(double x) { return static_cast<std::int32_t>(bits(x)); }

std::optional<double> foldWhole(Code code, std::span<const double> x) {
  using enum Code;
  const double divisor = x.size() > 1 ? x[1] : 1;
  switch (code) {
    case IntAdd:
      return x[0] + x[1];
    case IntSub:
      return x[0] - x[1];
    case IntMult:
      return static_cast<double>(bits(x[0]) * bits(x[1]));
    case IntDiv:
      return divisor == 0 ? std::nullopt : std::optional(std::trunc(x[0] / divisor));
    case IntMod:
      return divisor == 0 ? std::nullopt : std::optional(std::fmod(x[0], divisor));
    case UintDiv:
      return bits(divisor) == 0 ? std::nullopt : std::optional<double>(bits(x[0]) / bits(divisor));
    case UintMod:
      return bits(divisor) == 0 ? std::nullopt : std::optional<double>(bits(x[0]) % bits(divisor));
    case BitAnd:
      return static_cast<double>(bits(x[0]) & bits(x[1]));
    case BitOr:
      return static_cast<double>(bits(x[0]) | bits(x[1]));
    case BitXor:
      return static_cast<double>(bits(x[0]) ^ bits(x[1]));
    case BitNot:
      return static_cast<double>(~bits(x[0]));
    case ShiftLeft:
      return static_cast<double>(bits(x[0]) << (bits(x[1]) & 31));
    case ShiftRight:
      return static_cast<double>(wrapInt(x[0]) >> (bits(x[1]) & 31));
    case UintShiftRight:
      return static_cast<double>(bits(x[0]) >> (bits(x[1]) & 31));
    case IntLt:
      return wrapInt(x[0]) < wrapInt(x[1]);
    case UintLt:
      return bits(x[0]) < bits(x[1]);
    case IntEq:
      return bits(x[0]) == bits(x[1]);
    case IntOf:
    case UintOf:
      if (!(std::abs(x[0]) < 4294967296.0)) return std::nullopt;
      return std::trunc(x[0]);
    case FloatOf:
    case FloatOfUint:
    case SameBits:
      return x[0];
    case FloatBits:
      return static_cast<double>(__builtin_bit_cast(std::int32_t, static_cast<float>(x[0])));
    case FloatOfBits:
      return static_cast<double>(__builtin_bit_cast(float, bits(x[0])));
    default:
      return std::nullopt;
  }
}

std::optional<double> foldFloat(Code code, std::span<const double> x) {
  using enum Code;
  switch (code) {
    case Neg:
      return -x[0];
    case Add:
      return x[0] + x[1];
    case Sub:
      return x[0] - x[1];
    case Mult:
      return x[0] * x[1];
    case Div:
      return x[1] == 0 ? std::nullopt : std::optional(x[0] / x[1]);
    case Abs:
      return std::abs(x[0]);
    case Sign:
      return x[0] > 0 ? 1 : x[0] < 0 ? -1 : 0;
    case Floor:
      return std::floor(x[0]);
    case Ceil:
      return std::ceil(x[0]);
    case Trunc:
      return std::trunc(x[0]);
    case Fract:
      return x[0] - std::floor(x[0]);
    case Mod:
      return x[1] == 0 ? std::nullopt : std::optional(x[0] - x[1] * std::floor(x[0] / x[1]));
    case Min:
      return std::min(x[0], x[1]);
    case Max:
      return std::max(x[0], x[1]);
    case Clamp:
      return std::min(std::max(x[0], x[1]), x[2]);
    case Step:
      return x[1] < x[0] ? 0 : 1;
    case Sqrt:
      return x[0] < 0 ? std::nullopt : std::optional(std::sqrt(x[0]));
    case Lt:
      return x[0] < x[1];
    case Le:
      return x[0] <= x[1];
    case Gt:
      return x[0] > x[1];
    case Ge:
      return x[0] >= x[1];
    case Eq:
      return x[0] == x[1];
    case Ne:
      return x[0] != x[1];
    default:
      return std::nullopt;
  }
}

std::optional<double> foldTranscendental(Code code, std::span<const double> x) {
  using enum Code;
  constexpr double degree = 3.14159265358979323846 / 180, ln2 = 0.69314718055994530942;
  switch (code) {
    case Radians:
      return x[0] * degree;
    case Degrees:
      return x[0] / degree;
    case Sin:
      return std::sin(x[0]);
    case Cos:
      return std::cos(x[0]);
    case Tan:
      return std::tan(x[0]);
    case Asin:
      return std::asin(x[0]);
    case Acos:
      return std::acos(x[0]);
    case Atan:
      return x.size() == 2 ? std::atan2(x[0], x[1]) : std::atan(x[0]);
    case Sinh:
      return std::sinh(x[0]);
    case Cosh:
      return std::cosh(x[0]);
    case Tanh:
      return std::tanh(x[0]);
    case Asinh:
      return std::asinh(x[0]);
    case Acosh:
      return std::acosh(x[0]);
    case Atanh:
      return std::atanh(x[0]);
    case Pow:
      return std::pow(x[0], x[1]);
    case Exp:
      return std::exp(x[0]);
    case Exp2:
      return std::exp(x[0] * ln2);
    case Log:
      return std::log(x[0]);
    case Log2:
      return std::log(x[0]) / ln2;
    case InverseSqrt:
      return 1 / std::sqrt(x[0]);
    case Round:
      return std::nearbyint(x[0]);
    case Mix:
      return x[0] * (1 - x[2]) + x[1] * x[2];
    case Smoothstep: {
      const double t = std::clamp((x[2] - x[0]) / (x[1] - x[0]), 0.0, 1.0);
      return t * t * (3 - 2 * t);
    }
    default:
      return std::nullopt;
  }
}

}  // namespace

std::optional<double> foldFunction(Code code, std::span<const double> x) {
  const auto known = fold(code, x);
  return known ? known : foldTranscendental(code, x);
}

std::optional<double> fold(Code code, std::span<const double> x) {
  return code >= Code::IntOf ? foldWhole(code, x) : foldFloat(code, x);
}

}  // namespace warpjet::source

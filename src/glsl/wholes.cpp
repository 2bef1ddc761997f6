// Whole numbers that only the shader knows. The compiler has floats, which hold them exactly up to
// 2^24: so each has a bound of its size, and what may go beyond is refused, as is what looks at
// bits. Numbers made of floats are taken to be as large as `usual`, which is what meshes and
// sketches have. A type of their own in src/ops would take the place of this file.
#include <algorithm>
#include <array>

#include "glsl/recorder.hpp"

namespace warpjet::glsl {

namespace {

constexpr double usual = 1e4, mostExact = 16777216, mostDivided = 1048576;

}  // namespace

Id Recorder::bounded(Code code, Base base, std::span<const Id> operands, double bound) {
  if (bound > mostExact && refusal_.empty())
    refusal_ =
        "this may pass 2^24, up to which a warp computes whole numbers that only the shader knows";
  Operation operation{code, base};
  operation.bound = bound;
  return intern(operation, operands);
}

// Towards zero. A shader's quotient is not exact: half of a unit more keeps it on the right side.
Id Recorder::quotient(Base base, Id x, Id y) {
  if (at(x).bound > mostDivided && refusal_.empty())
    refusal_ = "this may divide a whole number above 2^20, which a shader does not exactly";
  const double bound = at(x).bound;
  const Id half = constant(Base::Float, 0.5);
  const Id sign = bounded(Code::Sign, Base::Float, std::array{x}, 1);
  const Id rest = bounded(Code::Mult, Base::Float, std::array{sign, half}, 1);
  const Id more = bounded(Code::Add, Base::Float, std::array{x, rest}, bound);
  const Id exact = bounded(Code::Div, Base::Float, std::array{more, y}, bound);
  return bounded(Code::Trunc, base, std::array{exact}, bound);
}

Id Recorder::whole(Code code, Base base, std::span<const Id> x) {
  const double a = at(x[0]).bound, b = x.size() > 1 ? at(x[1]).bound : 0;
  const auto refused = [&](std::string_view why) {
    if (refusal_.empty()) refusal_ = why;
    return constant(base, 0);
  };
  switch (code) {
    case Code::IntOf:
    case Code::UintOf:
      return bounded(Code::Trunc, base, x, usual);
    // The same number, of another type.
    case Code::FloatOf:
    case Code::FloatOfUint:
      return bounded(Code::Add, base, std::array{x[0], constant(Base::Float, 0)}, a);
    case Code::IntAdd:
      return bounded(Code::Add, base, x, a + b);
    case Code::IntSub:
      if (base == Base::Uint)
        return refused(
            "a uint that only the shader knows may wrap around below 0 here; use an int");
      return bounded(Code::Sub, base, x, a + b);
    case Code::IntMult:
      return bounded(Code::Mult, base, x, a * b);
    case Code::IntDiv:
    case Code::UintDiv:
      return quotient(base, x[0], x[1]);
    case Code::IntMod:
    case Code::UintMod: {
      const Id whole = quotient(base, x[0], x[1]);
      const Id product = bounded(Code::Mult, base, std::array{x[1], whole}, a);
      return bounded(Code::Sub, base, std::array{x[0], product}, std::min(a, b));
    }
    case Code::IntLt:
    case Code::UintLt:
      return bounded(Code::Lt, base, x, 0);
    case Code::IntEq:
      return bounded(Code::Eq, base, x, 0);
    case Code::IntIfElse:
      return bounded(Code::IfElse, base, x, std::max(b, at(x[2]).bound));
    case Code::BitOr:
      if (isConstant(x[1]) && value(x[1]) == 0)
        return refused(
            "an int that only the shader knows cannot become a uint here; use ints alone");
      [[fallthrough]];
    default:
      return refused(
          "& | ^ ~ << >> need whole numbers that are known; only the shader knows these");
  }
}

}  // namespace warpjet::glsl

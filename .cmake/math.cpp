// The functions that -sJS_MATH leaves to musl, from JavaScript too: 1 KB less.
extern "C" {

double emscripten_math_sinh(double x);
double emscripten_math_cosh(double x);
double emscripten_math_tanh(double x);
double emscripten_math_asinh(double x);
double emscripten_math_acosh(double x);
double emscripten_math_atanh(double x);

double sinh(double x) { return emscripten_math_sinh(x); }
double cosh(double x) { return emscripten_math_cosh(x); }
double tanh(double x) { return emscripten_math_tanh(x); }
double asinh(double x) { return emscripten_math_asinh(x); }
double acosh(double x) { return emscripten_math_acosh(x); }
double atanh(double x) { return emscripten_math_atanh(x); }
}

// GLSL functions of nearly float32 accuracy that replace inaccurate built-in functions: SwiftShader computes sin and cos to 2e-4 and
// acos to 6e-5.

// π in three parts: k times the first two is exact in float32 for integers k up to 2^13.
const first = 201 / 64
const second = Math.floor((Math.PI - first) * 2 ** 21) / 2 ** 21
const third = Math.PI - first - second

// x = kπ + r with |r| ≤ π/2, then Taylor's series in r².
const declarations = `
float series(float x, float s, float a, float b, float c, float d, float e) {
  return x + x * s * (a + s * (b + s * (c + s * (d + s * e))));
}
float subtractMultipleOfPi(float x, float k) { return x - k * ${first} - k * ${second} - k * ${third}; }
float negateIfOdd(float y, float k) { return mod(k, 2.0) > 0.5 ? -y : y; }
float exactSin(float x) {
  float k = floor(x * ${1 / Math.PI} + 0.5);
  float r = subtractMultipleOfPi(x, k);
  return negateIfOdd(series(r, r * r, -1.0 / 6.0, 1.0 / 120.0, -1.0 / 5040.0, 1.0 / 362880.0, -1.0 / 39916800.0), k);
}
float exactCos(float x) {
  float k = floor(x * ${1 / Math.PI} + 0.5);
  float r = subtractMultipleOfPi(x, k);
  return negateIfOdd(series(1.0, r * r, -0.5, 1.0 / 24.0, -1.0 / 720.0, 1.0 / 40320.0, -1.0 / 3628800.0), k);
}
float exactTan(float x) { return exactSin(x) / exactCos(x); }
float exactAcos(float x) { return ${Math.PI / 2} - asin(x); }
${['Sin', 'Cos', 'Tan', 'Acos'].flatMap((name) => ['xy', 'xyz', 'xyzw'].map((components) => declareForVectors(name, components))).join('')}`

/** Returns an overload that applies a function to each component; `components` are 'xy', 'xyz' or 'xyzw'. */
function declareForVectors(name, components) {
  const vector = `vec${components.length}`
  const values = [...components].map((component) => `exact${name}(x.${component})`)
  return `${vector} exact${name}(${vector} x) { return ${vector}(${values.join(', ')}); }\n`
}

/** Replaces sin, cos, tan and acos in compiled statements with these functions. */
export const withAccurateSine = (compiled) => ({
  code: compiled.code.replace(
    /\b(sin|cos|tan|acos)\(/g,
    (_, name) => `exact${name[0].toUpperCase()}${name.slice(1)}(`,
  ),
  declarations: declarations + compiled.declarations,
})

/** Since each sine becomes a polynomial, SwiftShader takes too long to compile more of them. */
const maxSines = 100

/** Returns statements with an accurate sine if they compile in reasonable time, otherwise the original ones. */
export const withAccurateSineIfShort = (compiled) =>
  (compiled.code.match(/\b(sin|cos|tan)\(/g)?.length ?? 0) <= maxSines
    ? withAccurateSine(compiled)
    : compiled

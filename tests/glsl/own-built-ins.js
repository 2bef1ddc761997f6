// Functions that call every built-in function, differentiable or not, with numbers, vectors and matrices; see own.js.
export const builtInCalls = {
  angles: `vec3 own(vec3 p) { return radians(p * 90.0) + degrees(p.zxy) * 0.01; }`,
  'tan, asin, acos and atan': `vec3 own(vec3 p) {
    return vec3(tan(p.x), asin(p.y * 0.9) + acos(p.z * 0.9), atan(p.x * 3.0) + atan(p.y, p.z + 1.5));
  }`,
  'atan of two arguments, in all quadrants': `vec2 own(vec3 p) { return atan(p.xy, p.yz) * 0.5 + atan(p.zz, vec2(0.3, -2.0) * p.x); }`,
  'powers and roots': `vec4 own(vec3 p) {
    vec4 q = vec4(p, p.x * p.y) + 1.5;
    return exp2(q) + log2(q) * 0.5 + inversesqrt(q) - sqrt(q.wzyx) + exp(-q) + log(q.yxwz) + pow(q, q.zwxy * 0.5);
  }`,
  'rounding functions, times a slope': `vec3 own(vec3 p) {
    return ceil(p * 3.0) * p + round(p * 2.7) * p.yzx + trunc(p * 4.0) * p.zxy + floor(p * 1.7) * p
      + roundEven(p.zyx * 3.3) * 0.5 * p;
  }`,
  'roundEven of numbers halfway between integers': `vec3 own(vec3 p) { return roundEven(floor(p * 4.0) + 0.5); }`,
  'fract, mod, sign and step by component': `vec3 own(vec3 p) {
    return fract(p * 2.3) + mod(p * 3.0, 0.7) + mod(p, p.yzx + 1.7) + sign(p) * p.zxy + step(p, p.zxy) * p + step(0.1, p) * p.y;
  }`,
  'smoothstep by numbers and by vectors': `vec3 own(vec3 p) {
    return smoothstep(-0.5, 0.7, p) + smoothstep(vec3(-0.8, -0.6, -0.4), vec3(0.9, 0.5, 0.3) + p.x * 0.1, p.zxy);
  }`,
  'min, max, clamp and mix of vectors': `vec3 own(vec3 p) {
    vec3 q = p.yzx * 0.7;
    return min(p, q) + 2.0 * max(p, 0.2) + clamp(p * 2.0, q - 0.5, q + 0.5) + clamp(p, -0.3, 0.4)
      + mix(p, q * q, p.zxy) + mix(p, q, 0.3) + min(q, -0.1) + mix(p, q, lessThan(p, vec3(0.2)));
  }`,
  'functions of vectors, of single numbers': `float own(vec3 p) {
    return abs(p.x) * length(p.y) + normalize(p.z) * p.x + dot(p.x, p.y) + distance(p.x, p.z) + reflect(p.x, p.y);
  }`,
  'NaN and infinity': `float own(vec3 p) {
    float none = intBitsToFloat(p.x > 0.2 ? 0x7fc00000 : 0x40000000);
    float much = uintBitsToFloat(p.y > 0.1 ? 0x7f800000u : 0x40000000u);
    bvec2 b = isnan(vec2(none, p.z));
    return (b.x ? p.z : 2.0 * p.y) + (b.y ? 9.0 : 0.0) + (isinf(much) ? p.x : 3.0 * p.z) + (any(isinf(p)) ? 9.0 : 0.0);
  }`,
  'bits of floats': `vec3 own(vec3 p) {
    ivec3 bits = floatBitsToInt(p) & 0x7fffffff;
    return intBitsToFloat(bits) + uintBitsToFloat(floatBitsToUint(p.yzx) ^ 0x80000000u) + vec3(bits >> 23) * 0.1;
  }`,
  'matrixCompMult and outerProduct': `vec3 own(vec3 p) {
    mat3 m = matrixCompMult(mat3(p, p.yzx, p.zxy), outerProduct(p, vec3(0.5, 1.0, p.y)));
    return m * p.zyx + matrixCompMult(mat2x3(p, p.zxy), mat2x3(2.0, 1.0, 0.5, p)) * p.xy;
  }`,
  'transposed matrices of all sizes': `vec4 own(vec3 p) {
    mat3x2 m = transpose(mat2x3(p, p.yzx));
    mat4x3 n = transpose(mat3x4(vec4(p, 0.5), vec4(p.zxy, p.x), vec4(1.0, p)));
    return vec4(m * p, transpose(mat2(p.xyzx)) * p.yz) + transpose(n) * p + p * n + transpose(mat4(2.0) + p.x)[1];
  }`,
  determinants: `vec3 own(vec3 p) {
    mat4 m = mat4(vec4(p, 1.0), vec4(p.yzx, 0.3), vec4(0.2, p.zxy), vec4(1.0, 0.5, p.xy));
    return vec3(determinant(mat2(p.xyzx)), determinant(mat3(p, p.yzx + 1.0, vec3(0.2, p.zy))), determinant(m));
  }`,
  'inverses of all sizes': `vec4 own(vec3 p) {
    mat2 a = mat2(2.0 + p.x, p.y, p.z, -1.5);
    mat3 b = mat3(p, p.yzx, p.zxy) + mat3(3.0);
    mat4 c = mat4(vec4(p, 1.0), vec4(p.yzx, 0.3), vec4(0.2, p.zxy), vec4(1.0, 0.5, p.xy)) + mat4(4.0);
    return vec4(inverse(a) * p.xy, 0.0, 1.0) + vec4(inverse(b) * p, 0.0) + inverse(c) * vec4(p, 0.5);
  }`,
  'comparisons by component': `vec3 own(vec3 p) {
    vec3 q = p.yzx;
    return p * vec3(lessThan(p, q)) + 2.0 * q * vec3(lessThanEqual(p, vec3(0.2))) + 4.0 * vec3(greaterThan(p, q))
      + 8.0 * vec3(greaterThanEqual(q, vec3(-0.3))) + p * vec3(equal(sign(p), sign(q))) - q * vec3(notEqual(sign(q), sign(p.zxy)));
  }`,
  'comparisons of integers': `vec3 own(vec3 p) {
    ivec3 n = ivec3(floor(p * 3.0)), m = n.yzx;
    return p * vec3(lessThan(n, m)) + 2.0 * vec3(lessThanEqual(n, m)) + 4.0 * vec3(greaterThan(n, m.zxy))
      + p.zxy * vec3(greaterThanEqual(n, ivec3(-1, 0, 1))) + p * vec3(equal(n, m)) + vec3(notEqual(n, m.yzx));
  }`,
  'comparisons of unsigned integers': `vec3 own(vec3 p) {
    uvec3 n = uvec3(ivec3(floor(p * 3.0))), m = n.zxy;
    return p * vec3(lessThan(n, m)) + 2.0 * vec3(lessThanEqual(n, m)) + 4.0 * vec3(greaterThan(n, uvec3(2)))
      + p.zxy * vec3(greaterThanEqual(n, m)) + p * vec3(equal(n, m)) + vec3(notEqual(n, uvec3(1)));
  }`,
  'any, all and not': `vec3 own(vec3 p) {
    bvec3 a = greaterThan(p, vec3(0.3));
    bvec2 b = equal(not(a).xy, bvec2(true, false));
    bvec4 c = notEqual(bvec4(a, true), bvec4(b, b.yx));
    return vec3(any(a) ? p.x : p.y, all(b) ? p.z : 2.0 * p.x, all(not(c)) || any(bvec2(c.xw)) ? p.y : 3.0 * p.z);
  }`,
  'modf of a vector': `vec3 own(vec3 p) {
    vec3 whole;
    vec3 part = modf(p * 3.0, whole);
    return part + whole * p.yzx;
  }`,
  'abs, sign, min, max and clamp of integer vectors': `vec3 own(vec3 p) {
    ivec3 n = ivec3(floor(p * 7.0));
    uvec3 u = uvec3(n + 9);
    return p * vec3(abs(n) * sign(n.zxy)) + vec3(min(n, n.yzx) + max(n, -2) + clamp(n, ivec3(-3), n.zxy + 2) + clamp(n, 0, 3)) * 0.3
      + vec3(min(u, 8u) + max(u, u.yzx) + clamp(u, 3u, 9u) + clamp(u, uvec3(1, 2, 3), uvec3(7))) * 0.1;
  }`,
  'geometric functions of vec2 and vec4': `vec4 own(vec3 p) {
    vec4 q = vec4(p, 0.4);
    vec2 n = normalize(p.xy + vec2(0.1, 2.0));
    return normalize(q) + vec4(reflect(p.yz, n), refract(n, normalize(p.zx + 1.5), 0.6)) + faceforward(q, q.wzyx, q.yxwz)
      + length(q.xw) * distance(q, vec4(0.5)) + dot(q, q.zwxy);
  }`,
}

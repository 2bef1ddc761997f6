// Features of GLSL ES 1.00, of 3.00, or of both, each in a function `vec3 offset(vec3 p)` without #version. The list does not say which
// version has which feature: tests ask a browser.
const withBody = (statements, above = '') => `${above}\nvec3 offset(vec3 p) { ${statements} }`
const withResult = (expression, above) => withBody(`return vec3(${expression});`, above)
const fillArray = 'float a[3]; for (int i = 0; i < 3; i++) a[i] = p.x;'

/** Words that are reserved in one version or in both, and some that are reserved in neither. */
export const words = `
  const uniform attribute varying layout centroid flat smooth break continue do for while switch case default if else in out inout
  true false invariant discard return lowp mediump highp precision struct goto class union enum typedef template this inline
  noinline volatile public static extern external interface long short double half fixed unsigned superp input output sizeof cast
  namespace using float int bool void vec2 vec3 vec4 ivec2 ivec3 ivec4 bvec2 bvec3 bvec4 uint uvec2 uvec3 uvec4 mat2 mat3 mat4
  mat2x2 mat2x3 mat2x4 mat3x2 mat3x3 mat3x4 mat4x2 mat4x3 mat4x4 sampler2D sampler3D samplerCube sampler2DArray sampler2DShadow
  isampler2D usampler2D texture texture2D time offsets`
  .trim()
  .split(/\s+/)

/** Returns source with a variable of that name. */
export const sourceWithName = (word) =>
  withBody(`float x = 1.0; float ${word} = p.x; ${word} += x; return vec3(${word});`)

export const versions = {
  'a plain function': withResult('sin(p.x)'),

  // declarations
  attribute: withResult('0.0', 'attribute vec3 aPosition;'),
  varying: withResult('0.0', 'varying vec2 vUv;'),
  'an input of the stage': withResult('0.0', 'in vec3 aPosition;'),
  'an output of the stage': withResult('0.0', 'out vec2 vUv;'),
  layout: withResult('0.0', 'layout(location = 0) in vec3 aPosition;'),
  flat: withResult('0.0', 'flat out float f;'),
  'an in and an out parameter': withBody(
    'vec3 q; f(p, q); return q;',
    'void f(in vec3 a, out vec3 b) { b = a; }',
  ),
  'the precision of a variable': withBody('highp float x = p.x; return vec3(x);'),

  // types
  uint: withBody('uint n = uint(p.x); return vec3(n == n ? 1.0 : 0.0);'),
  uvec3: withBody('uvec3 n = uvec3(p); return vec3(n);'),
  'ivec2 and bvec2': withBody(
    'ivec2 n = ivec2(p.xy); bvec2 b = bvec2(n); return vec3(b.x ? 1.0 : 0.0);',
  ),
  mat2x3: withBody('mat2x3 m = mat2x3(p, p); return m[0];'),
  mat3x3: withBody('mat3x3 m = mat3x3(p, p, p); return m[0];'),

  // numbers
  'a number with u': withBody('int n = int(3u); return vec3(n);'),
  'a number with f': withResult('1.5f * p.x'),
  'a number in base 16': withBody('int n = 0x1F; return vec3(n);'),

  // arrays
  'an array written at the counter of a loop': withBody(
    `${fillArray} return vec3(a[0], a[1], a[2]);`,
  ),
  'an array made in one expression': withBody(
    'float a[2] = float[2](p.x, p.y); return vec3(a[0]);',
  ),
  'an array without a length': withBody('float a[] = float[](p.x, p.y); return vec3(a[0]);'),
  'a length after the type': withBody('float[2] a; a[0] = p.x; return vec3(a[0]);'),
  'the length of an array': withBody('float a[2]; a[0] = p.x; return vec3(float(a.length()));'),
  'an array that is assigned': withBody(`${fillArray} float b[3]; b = a; return vec3(b[1]);`),
  'arrays that are compared': withBody(
    `${fillArray} float b[3]; b[0] = b[1] = b[2] = p.y; return vec3(a == b ? 1.0 : 0.0);`,
  ),
  'a structure with an array, assigned': withBody(
    'S a; a.x[0] = p.x; a.x[1] = p.y; S b; b = a; return vec3(b.x[0]);',
    'struct S { float x[2]; };',
  ),
  'structures with arrays, compared': withBody(
    'S a; a.x[0] = p.x; a.x[1] = p.y; return vec3(a == a ? 1.0 : 0.0);',
    'struct S { float x[2]; };',
  ),
  'a structure, assigned and compared': withBody(
    'S a = S(p.x); S b; b = a; return vec3(a == b ? 1.0 : 0.0);',
    'struct S { float x; };',
  ),
  'a function that returns an array': withResult(
    'f(p.x)[0]',
    'float[2] f(float x) { return float[2](x, x); }',
  ),
  'a function that returns a structure with an array': withResult(
    'f(p.x).x[0]',
    'struct S { float x[2]; }; S f(float x) { S s; s.x[0] = x; s.x[1] = x; return s; }',
  ),
  'an array as a parameter': withBody(
    `${fillArray} return vec3(f(a));`,
    'float f(float x[3]) { return x[0] + x[2]; }',
  ),

  // indices
  'an index of a sum of constants and counters': withBody(
    'float a[4]; for (int i = 0; i < 2; i++) { a[i + 2] = p.x; a[2 * i] = p.y; } return vec3(a[3]);',
  ),
  'an index that depends on the vertex': withBody(
    `${fillArray} int k = int(p.x); return vec3(a[k]);`,
  ),
  'a component at an index that depends on the vertex': withBody(
    'int k = int(p.x); return vec3(p[k]);',
  ),
  'a column at an index that depends on the vertex': withBody(
    'mat3 m = mat3(p, p, p); int k = int(p.x); return m[k];',
  ),
  'a uniform at an index that depends on the vertex': withBody(
    'int k = int(p.x); return vec3(heights[k]);',
    'uniform float heights[3];',
  ),

  // operators
  '%': withBody('int n = int(p.x) % 3; return vec3(n);'),
  '%=': withBody('int n = int(p.x); n %= 3; return vec3(n);'),
  '<<': withBody('int n = int(p.x) << 2; return vec3(n);'),
  '>>=': withBody('int n = int(p.x); n >>= 1; return vec3(n);'),
  '&': withBody('int n = int(p.x) & 3; return vec3(n);'),
  '|': withBody('int n = int(p.x) | 3; return vec3(n);'),
  '^': withBody('int n = int(p.x) ^ 3; return vec3(n);'),
  '^=': withBody('int n = int(p.x); n ^= 3; return vec3(n);'),
  '~': withBody('int n = ~int(p.x); return vec3(n);'),
  '&& || ^^ !': withBody(
    'bool b = p.x > 0.0 && !(p.y > 0.0) || p.z > 0.0 ^^ true; return vec3(b ? 1.0 : 0.0);',
  ),
  'integers, added and divided': withBody('int n = int(p.x) * 3 / 2 - 1; return vec3(n);'),

  // statements
  switch: withBody('switch (int(p.x)) { case 0: return p; default: break; } return -p;'),
  'a while loop': withBody('int i = 0; while (i < 3) { i++; } return vec3(i);'),
  'a do loop': withBody('int i = 0; do { i++; } while (i < 3); return vec3(i);'),
  'a loop that counts up': withBody(
    'float s = 0.0; for (int i = 0; i < 4; i++) { s += p.x; } return vec3(s);',
  ),
  'a loop that counts down': withBody(
    'float s = 0.0; for (int i = 4; i > 0; --i) { s += p.x; } return vec3(s);',
  ),
  'a loop that counts by floats and a constant': withBody(
    'const float step = 0.25; float s = 0.0; for (float t = 0.0; t <= 2.0 * step; t += step) { s += t; } return vec3(s);',
  ),
  'a loop up to a constant that a function returns': withBody(
    'float s = 0.0; for (float t = 0.0; t < max(1.0, 2.0); t += 0.5) { s += t; } return vec3(s);',
  ),
  'a loop with a break and a continue': withBody(
    'float s = 0.0; for (int i = 0; i < 4; i++) { if (p.x > s) continue; if (p.y > s) break; s += 1.0; } return vec3(s);',
  ),
  'a loop whose end depends on the vertex': withBody(
    'float s = 0.0; for (int i = 0; i < int(p.x); i++) { if (i >= 8) break; s += 1.0; } return vec3(s);',
  ),
  'a loop whose start depends on the vertex': withBody(
    'float s = 0.0; for (int i = int(p.x); i < 4; i++) { if (s > 8.0) break; s += 1.0; } return vec3(s);',
  ),
  'a loop that multiplies its counter': withBody(
    'float s = 0.0; for (int i = 1; i < 9; i *= 2) { s += p.x; } return vec3(s);',
  ),
  'a loop without a step': withBody(
    'float s = 0.0; for (int i = 0; i < 4;) { s += p.x; i++; } return vec3(s);',
  ),
  'a loop without a condition': withBody(
    'float s = 0.0; for (int i = 0; ; i++) { if (i > 3) break; s += p.x; } return vec3(s);',
  ),
  'a loop whose counter is declared before it': withBody(
    'int i = 0; float s = 0.0; for (; i < 4; i++) { s += p.x; } return vec3(s);',
  ),
  'a loop with two counters': withBody(
    'float s = 0.0; for (int i = 0, j = 4; i < 4; i++) { s += float(j); } return vec3(s);',
  ),
  'a loop whose body changes its counter': withBody(
    'float s = 0.0; for (int i = 0; i < 4; i++) { i++; s += p.x; } return vec3(s);',
  ),
  'a loop whose counter is written by a function': withBody(
    'float s = 0.0; for (int i = 0; i < 4; i++) { f(i); s += p.x; } return vec3(s);',
    'void f(inout int n) { n++; }',
  ),
  'a loop whose condition is !=': withBody(
    'float s = 0.0; for (int i = 0; i != 4; i++) { s += p.x; } return vec3(s);',
  ),

  // built-in functions
  ...Object.fromEntries(
    Object.entries({
      sinh: 'sinh(p)',
      cosh: 'cosh(p)',
      tanh: 'tanh(p)',
      asinh: 'asinh(p)',
      acosh: 'acosh(p + 2.0)',
      atanh: 'atanh(p * 0.5)',
      atan: 'atan(p.x, p.y) + atan(p)',
      trunc: 'trunc(p)',
      round: 'round(p)',
      roundEven: 'roundEven(p)',
      'floor, ceil, fract, mod, sign': 'floor(p) + ceil(p) + fract(p) + mod(p, 2.0) + sign(p)',
      'mix and smoothstep': 'mix(p, p.zyx, 0.5) + smoothstep(0.0, 1.0, p)',
      'mix by a bvec3': 'mix(p, p.zyx, bvec3(true, false, true))',
      isnan: 'isnan(p.x) ? 1.0 : 0.0',
      isinf: 'isinf(p.x) ? 1.0 : 0.0',
      floatBitsToInt: 'floatBitsToInt(p.x) == 0 ? 1.0 : 0.0',
      floatBitsToUint: 'floatBitsToUint(p)',
      intBitsToFloat: 'intBitsToFloat(int(p.x))',
      uintBitsToFloat: 'uintBitsToFloat(uint(p.x))',
      packHalf2x16: 'unpackHalf2x16(packHalf2x16(p.xy)).x',
      packSnorm2x16: 'unpackSnorm2x16(packSnorm2x16(p.xy)).x',
      packUnorm2x16: 'unpackUnorm2x16(packUnorm2x16(p.xy)).x',
      outerProduct: 'outerProduct(p, p)[0]',
      transpose: 'transpose(mat3(p, p, p))[0]',
      determinant: 'determinant(mat2(p.xyyz))',
      inverse: 'inverse(mat2(p.xyyz))[0].x',
      matrixCompMult: 'matrixCompMult(mat2(p.xyyz), mat2(1.0))[0].x',
      'any, all, not, lessThan': 'any(not(lessThan(p, p.yzx))) && all(equal(p, p)) ? 1.0 : 0.0',
      'abs of an int': 'abs(int(p.x))',
      'sign of an int': 'sign(int(p.x))',
      'min of ints': 'min(int(p.x), 3)',
      'max of ints': 'max(ivec3(p), 3)',
      'clamp of ints': 'clamp(int(p.x), 0, 3)',
      'reflect, refract, faceforward': 'reflect(p, p) + refract(p, p, 0.5) + faceforward(p, p, p)',
    }).map(([name, expression]) => [name, withResult(expression)]),
  ),
  modf: withBody('float whole; return vec3(modf(p.x, whole));'),
  texture: withResult('texture(image, p.xy).x', 'uniform sampler2D image;'),
  textureLod: withResult('textureLod(image, p.xy, 0.0).x', 'uniform sampler2D image;'),
  textureSize: withResult('textureSize(image, 0)', 'uniform sampler2D image;').replace(
    'vec3(',
    'vec3(1.0, ',
  ),
  texelFetch: withResult('texelFetch(image, ivec2(p.xy), 0).x', 'uniform sampler2D image;'),
  texture2D: withResult('texture2D(image, p.xy).x', 'uniform sampler2D image;'),
  texture2DLod: withResult('texture2DLod(image, p.xy, 0.0).x', 'uniform sampler2D image;'),
  'a function of the source called transpose': withResult(
    'transpose(mat2(p.xyyz))[0].x',
    'mat2 transpose(mat2 m) { return mat2(m[0][0], m[1][0], m[0][1], m[1][1]); }',
  ),
  'a function of the source called texture2D': withResult(
    'texture2D(p.x)',
    'float texture2D(float x) { return x; }',
  ),
  'an overload of a built-in function': withResult(
    'sin(int(p.x))',
    'float sin(int x) { return float(x); }',
  ),
  'a variable called round': withBody('float round = p.x; return vec3(round);'),
  'a variable called inverse, assigned': withBody(
    'float inverse = 1.0; inverse = 2.0; return p * inverse;',
  ),
  'a variable called texture2D, assigned by components': withBody(
    'vec3 texture2D = p; texture2D.x = 1.0; return texture2D;',
  ),
  'a parameter called trunc, changed': withResult(
    'f(p.x)',
    'float f(float trunc) { trunc += 1.0; return trunc; }',
  ),
  'a statement that calls such a function': withBody(
    'vec2 q = p.xy; transpose(q); return vec3(q, 0.0);',
    'void transpose(inout vec2 v) { v = v.yx; }',
  ),
  'a variable called texture': withBody('float texture = p.x; return vec3(texture);'),

  // names of the language
  gl_VertexID: withResult('gl_VertexID'),
  gl_InstanceID: withResult('gl_InstanceID'),
  gl_PointSize: withBody('gl_PointSize = 2.0; return p;'),

  // the preprocessor
  __VERSION__: withResult(
    '0.0',
    '#if __VERSION__ == 300\n#define A\n#endif\n#ifdef A\nin vec3 aPosition;\n#else\nattribute vec3 aPosition;\n#endif',
  ),
  'an extension': withResult('0.0', '#extension GL_OES_standard_derivatives : warn'),
  GL_ES: withResult('0.0', '#ifdef GL_ES\nprecision mediump float;\nprecision highp int;\n#endif'),
}

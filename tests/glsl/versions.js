// Features of GLSL ES 1.00, of 3.00, or of both, each as a function `vec3 offset(vec3 p)` without its #version. It does not say
// which version has which: tests ask a browser.
const body = (statements, above = '') => `${above}\nvec3 offset(vec3 p) { ${statements} }`
const value = (expression, above) => body(`return vec3(${expression});`, above)
const array = 'float a[3]; for (int i = 0; i < 3; i++) a[i] = p.x;'

/** Words that one of the languages, or both, reserve, and some that neither does. */
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
  body(`float x = 1.0; float ${word} = p.x; ${word} += x; return vec3(${word});`)

export const versions = {
  'a plain function': value('sin(p.x)'),

  // declarations
  attribute: value('0.0', 'attribute vec3 aPosition;'),
  varying: value('0.0', 'varying vec2 vUv;'),
  'an input of the stage': value('0.0', 'in vec3 aPosition;'),
  'an output of the stage': value('0.0', 'out vec2 vUv;'),
  layout: value('0.0', 'layout(location = 0) in vec3 aPosition;'),
  flat: value('0.0', 'flat out float f;'),
  'a parameter that is in and one that is out': body(
    'vec3 q; f(p, q); return q;',
    'void f(in vec3 a, out vec3 b) { b = a; }',
  ),
  'the precision of a number': body('highp float x = p.x; return vec3(x);'),

  // types
  uint: body('uint n = uint(p.x); return vec3(n == n ? 1.0 : 0.0);'),
  uvec3: body('uvec3 n = uvec3(p); return vec3(n);'),
  'ivec2 and bvec2': body(
    'ivec2 n = ivec2(p.xy); bvec2 b = bvec2(n); return vec3(b.x ? 1.0 : 0.0);',
  ),
  mat2x3: body('mat2x3 m = mat2x3(p, p); return m[0];'),
  'mat3x3 by that name': body('mat3x3 m = mat3x3(p, p, p); return m[0];'),

  // numbers
  'a number with u': body('int n = int(3u); return vec3(n);'),
  'a number with f': value('1.5f * p.x'),
  'a number in base 16': body('int n = 0x1F; return vec3(n);'),

  // arrays
  'an array, written by a counter': body(`${array} return vec3(a[0], a[1], a[2]);`),
  'an array made in one expression': body('float a[2] = float[2](p.x, p.y); return vec3(a[0]);'),
  'an array without a length': body('float a[] = float[](p.x, p.y); return vec3(a[0]);'),
  'a length after the type': body('float[2] a; a[0] = p.x; return vec3(a[0]);'),
  'the length of an array': body('float a[2]; a[0] = p.x; return vec3(float(a.length()));'),
  'an array that is assigned': body(`${array} float b[3]; b = a; return vec3(b[1]);`),
  'arrays that are compared': body(
    `${array} float b[3]; b[0] = b[1] = b[2] = p.y; return vec3(a == b ? 1.0 : 0.0);`,
  ),
  'a structure with an array, assigned': body(
    'S a; a.x[0] = p.x; a.x[1] = p.y; S b; b = a; return vec3(b.x[0]);',
    'struct S { float x[2]; };',
  ),
  'structures with arrays, compared': body(
    'S a; a.x[0] = p.x; a.x[1] = p.y; return vec3(a == a ? 1.0 : 0.0);',
    'struct S { float x[2]; };',
  ),
  'a structure, assigned and compared': body(
    'S a = S(p.x); S b; b = a; return vec3(a == b ? 1.0 : 0.0);',
    'struct S { float x; };',
  ),
  'a function that gives an array': value(
    'f(p.x)[0]',
    'float[2] f(float x) { return float[2](x, x); }',
  ),
  'a function that gives a structure with an array': value(
    'f(p.x).x[0]',
    'struct S { float x[2]; }; S f(float x) { S s; s.x[0] = x; s.x[1] = x; return s; }',
  ),
  'an array as a parameter': body(
    `${array} return vec3(f(a));`,
    'float f(float x[3]) { return x[0] + x[2]; }',
  ),

  // indices
  'an index of a sum of constants and counters': body(
    'float a[4]; for (int i = 0; i < 2; i++) { a[i + 2] = p.x; a[2 * i] = p.y; } return vec3(a[3]);',
  ),
  'an index that the vertex decides': body(`${array} int k = int(p.x); return vec3(a[k]);`),
  'a component by an index of the vertex': body('int k = int(p.x); return vec3(p[k]);'),
  'a column by an index of the vertex': body(
    'mat3 m = mat3(p, p, p); int k = int(p.x); return m[k];',
  ),
  'a uniform by an index of the vertex': body(
    'int k = int(p.x); return vec3(heights[k]);',
    'uniform float heights[3];',
  ),

  // operators
  '%': body('int n = int(p.x) % 3; return vec3(n);'),
  '%=': body('int n = int(p.x); n %= 3; return vec3(n);'),
  '<<': body('int n = int(p.x) << 2; return vec3(n);'),
  '>>=': body('int n = int(p.x); n >>= 1; return vec3(n);'),
  '&': body('int n = int(p.x) & 3; return vec3(n);'),
  '|': body('int n = int(p.x) | 3; return vec3(n);'),
  '^': body('int n = int(p.x) ^ 3; return vec3(n);'),
  '^=': body('int n = int(p.x); n ^= 3; return vec3(n);'),
  '~': body('int n = ~int(p.x); return vec3(n);'),
  '&& || ^^ !': body(
    'bool b = p.x > 0.0 && !(p.y > 0.0) || p.z > 0.0 ^^ true; return vec3(b ? 1.0 : 0.0);',
  ),
  'whole numbers, added and divided': body('int n = int(p.x) * 3 / 2 - 1; return vec3(n);'),

  // statements
  switch: body('switch (int(p.x)) { case 0: return p; default: break; } return -p;'),
  'a while loop': body('int i = 0; while (i < 3) { i++; } return vec3(i);'),
  'a do loop': body('int i = 0; do { i++; } while (i < 3); return vec3(i);'),
  'a loop that counts up': body(
    'float s = 0.0; for (int i = 0; i < 4; i++) { s += p.x; } return vec3(s);',
  ),
  'a loop that counts down': body(
    'float s = 0.0; for (int i = 4; i > 0; --i) { s += p.x; } return vec3(s);',
  ),
  'a loop that counts by floats and a constant': body(
    'const float step = 0.25; float s = 0.0; for (float t = 0.0; t <= 2.0 * step; t += step) { s += t; } return vec3(s);',
  ),
  'a loop to a constant that a function gives': body(
    'float s = 0.0; for (float t = 0.0; t < max(1.0, 2.0); t += 0.5) { s += t; } return vec3(s);',
  ),
  'a loop with a break and a continue': body(
    'float s = 0.0; for (int i = 0; i < 4; i++) { if (p.x > s) continue; if (p.y > s) break; s += 1.0; } return vec3(s);',
  ),
  'a loop whose end the vertex decides': body(
    'float s = 0.0; for (int i = 0; i < int(p.x); i++) { if (i >= 8) break; s += 1.0; } return vec3(s);',
  ),
  'a loop whose start the vertex decides': body(
    'float s = 0.0; for (int i = int(p.x); i < 4; i++) { if (s > 8.0) break; s += 1.0; } return vec3(s);',
  ),
  'a loop that multiplies': body(
    'float s = 0.0; for (int i = 1; i < 9; i *= 2) { s += p.x; } return vec3(s);',
  ),
  'a loop without a step': body(
    'float s = 0.0; for (int i = 0; i < 4;) { s += p.x; i++; } return vec3(s);',
  ),
  'a loop without a condition': body(
    'float s = 0.0; for (int i = 0; ; i++) { if (i > 3) break; s += p.x; } return vec3(s);',
  ),
  'a loop whose counter stands before it': body(
    'int i = 0; float s = 0.0; for (; i < 4; i++) { s += p.x; } return vec3(s);',
  ),
  'a loop of two counters': body(
    'float s = 0.0; for (int i = 0, j = 4; i < 4; i++) { s += float(j); } return vec3(s);',
  ),
  'a loop whose body changes its counter': body(
    'float s = 0.0; for (int i = 0; i < 4; i++) { i++; s += p.x; } return vec3(s);',
  ),
  'a loop whose counter is written by a function': body(
    'float s = 0.0; for (int i = 0; i < 4; i++) { f(i); s += p.x; } return vec3(s);',
    'void f(inout int n) { n++; }',
  ),
  'a loop with an equation': body(
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
    }).map(([name, expression]) => [name, value(expression)]),
  ),
  modf: body('float whole; return vec3(modf(p.x, whole));'),
  texture: value('texture(image, p.xy).x', 'uniform sampler2D image;'),
  textureLod: value('textureLod(image, p.xy, 0.0).x', 'uniform sampler2D image;'),
  textureSize: value('textureSize(image, 0)', 'uniform sampler2D image;').replace(
    'vec3(',
    'vec3(1.0, ',
  ),
  texelFetch: value('texelFetch(image, ivec2(p.xy), 0).x', 'uniform sampler2D image;'),
  texture2D: value('texture2D(image, p.xy).x', 'uniform sampler2D image;'),
  texture2DLod: value('texture2DLod(image, p.xy, 0.0).x', 'uniform sampler2D image;'),
  'a function of its own called transpose': value(
    'transpose(mat2(p.xyyz))[0].x',
    'mat2 transpose(mat2 m) { return mat2(m[0][0], m[1][0], m[0][1], m[1][1]); }',
  ),
  'a function of its own called texture2D': value(
    'texture2D(p.x)',
    'float texture2D(float x) { return x; }',
  ),
  'an overload of a built-in function': value(
    'sin(int(p.x))',
    'float sin(int x) { return float(x); }',
  ),
  'a variable called round': body('float round = p.x; return vec3(round);'),
  'a variable called inverse, assigned': body(
    'float inverse = 1.0; inverse = 2.0; return p * inverse;',
  ),
  'a variable called texture2D, assigned by components': body(
    'vec3 texture2D = p; texture2D.x = 1.0; return texture2D;',
  ),
  'a parameter called trunc, changed': value(
    'f(p.x)',
    'float f(float trunc) { trunc += 1.0; return trunc; }',
  ),
  'a statement that calls a function of its own called transpose': body(
    'vec2 q = p.xy; transpose(q); return vec3(q, 0.0);',
    'void transpose(inout vec2 v) { v = v.yx; }',
  ),
  'a variable called texture': body('float texture = p.x; return vec3(texture);'),

  // names of the language
  gl_VertexID: value('gl_VertexID'),
  gl_InstanceID: value('gl_InstanceID'),
  gl_PointSize: body('gl_PointSize = 2.0; return p;'),

  // the preprocessor
  __VERSION__: value(
    '0.0',
    '#if __VERSION__ == 300\n#define A\n#endif\n#ifdef A\nin vec3 aPosition;\n#else\nattribute vec3 aPosition;\n#endif',
  ),
  'an extension': value('0.0', '#extension GL_OES_standard_derivatives : warn'),
  GL_ES: value('0.0', '#ifdef GL_ES\nprecision mediump float;\nprecision highp int;\n#endif'),
}

// Invalid source of every kind: the message has line, column and a caret.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { WarpError, compileWarp } from 'warpjet'
import { glslOffset } from 'warpjet/glsl'

const body = (text) => `vec3 offset(vec3 p) {\n  ${text}\n}`
const nest = (open, inner, close, count) => open.repeat(count) + inner + close.repeat(count)

/** [source, line of the mistake, part of the message]. */
const wrong = [
  // the source ends too early
  ['vec3 offset(vec3 p) {', 1, 'this { has no }'],
  ['vec3 offset(vec3 p', 1, 'expected )'],
  ['vec3 offset', 1, 'expected ; after a declaration, got the end of the source'],
  ['vec3', 1, 'expected a name, got the end of the source'],
  [body('return p'), 3, 'expected ; after return, got "}"'],
  [body('return vec3(1., 2., 3.;'), 2, 'expected ) after the arguments, got ";"'],
  [body('return p['), 3, 'expected a value, got "}"'],
  [body('return p.;'), 2, 'after the point'],
  [body('float x = ;return p;'), 2, 'expected a value'],
  [body('if (p.x > 1. return p;'), 2, 'expected ) after a condition'],
  [body('for (int i = 0; i < 3) {} return p;'), 2, 'expected ;'],
  [body('do { } p.x;'), 2, 'expected while'],
  [body('switch (1) { case 0 return p; }'), 2, 'expected :'],
  ['/* never', 1, 'this comment never ends'],
  ['struct S { float x; }', 1, 'expected a name'],
  ['float x', 1, 'expected ;'],
  // names
  [body('return q;'), 2, '"q" is not declared'],
  [body('float p2 = p; return p;'), 2, 'expected a float as the value of "p2", got a vec3'],
  [body('float x; float x; return p;'), 2, '"x" is already declared here'],
  [body('return missing(p);'), 2, 'there is no function "missing"'],
  [body('return vec3(sine(p.x));'), 2, 'there is no function "sine"; did you mean sin?'],
  [body('float height = 1.; return vec3(heigth);'), 2, 'not declared; did you mean height?'],
  [body('float for = 1.; return p;'), 2, 'it is a keyword'],
  [
    body('float half = 1.; return p;'),
    2,
    '"half" cannot be a name: GLSL reserves this word; use another name',
  ],
  ['#version 300 es\nfloat sample;', 2, '"sample" cannot be a name: GLSL reserves this word'],
  ['#version 100\nfloat packed;', 2, 'GLSL reserves this word'],
  ['struct S { float input; };', 1, 'GLSL reserves this word'],
  [`float ${'a'.repeat(1025)};`, 1, 'it is longer than 1024 characters'],
  [`#version 100\nfloat ${'a'.repeat(257)};`, 2, 'it is longer than 256 characters'],
  ['void f(void a[2]) { }', 1, 'a parameter cannot be void'],
  [
    '#version 300 es\nvoid f() { float a[2]; a, a; }',
    2,
    'a float[2] is not allowed in a comma expression',
  ],
  ['float a__b;', 1, 'names with two consecutive underscores are reserved'],
  ['float f(float webgl_x) { return 1.; }', 1, 'names that start with webgl_ are reserved'],
  [body('float gl_x = 1.; return p;'), 2, 'names that start with gl_'],
  [
    body('return p * gl_FragCoord.x;'),
    2,
    '"gl_FragCoord" exists only in fragment shaders; a warp moves vertices: use position or uv.',
  ],
  [body('gl_FragCoord.x = 1.0; return p;'), 2, 'is given by the host and cannot be changed'],
  [body('return p * gl_FragCoord[1];'), 2, '"gl_FragCoord" exists only in fragment shaders'],
  [
    'float f() { return gl_FragCoord.x; }\nvec3 offset(vec3 p) { return p * f(); }',
    1,
    '"gl_FragCoord" exists only in fragment shaders',
  ],
  [body('return p.w;'), 2, 'a vec3 has no component "w"'],
  [body('return p.xg;'), 2, 'has no component "xg"'],
  [body('return p.xyzxy;'), 2, 'has no component'],
  [body('{ float y = 1.; } return vec3(y);'), 2, '"y" is not declared'],
  [body('float x = x; return p;'), 2, '"x" is not declared'],
  [body('return sin;'), 2, 'is a function; call it'],
  [body('float sin = 1.; return p * sin(1.);'), 2, 'is a variable and cannot be called'],
  [body('return offset2(p);') + '\nvec3 offset2(vec3 p) { return p; }', 2, 'no function'],
  ['struct S { float a; };\n' + body('S s; return vec3(s.b);'), 3, 'has no field "b"'],
  ['struct S { float a; float a; };', 1, 'is already a field of this structure'],
  ['Thing offset(vec3 p) { }', 1, 'expected a type'],
  // types
  [body('float x = 1; return p;'), 2, 'expected a float as the value of "x", got an int'],
  [body('return p + 1;'), 2, 'write 1.0 for 1'],
  [body('return p * mat2(1.);'), 2, '"*" does not take a vec3 and a mat2'],
  [body('return 1.0;'), 2, 'expected this function to return a vec3, got a float'],
  [body('return;'), 2, 'got nothing'],
  ['void f() { return 1.; }\n' + body('return p;'), 1, 'is void and returns nothing'],
  [
    body('if (p.x) return p; return p;'),
    2,
    'expected a bool as the condition of this if, got a float',
  ],
  [
    body('return p.x > 1. ? p : p.x;'),
    2,
    'expected two values of the same type in ? :, got a vec3 and a float',
  ],
  [body('return p.x ? p : p;'), 2, 'expected a bool before ?, got a float'],
  [body('bool b = p > p; return p;'), 2, '">" does not take'],
  [body('return !p;'), 2, '"!" does not take a vec3'],
  [body('return ~p;'), 2, '"~" does not take'],
  [body('return -true;'), 2, '"-" does not take a bool'],
  [body('int i = 3 % 2.; return p;'), 2, '"%" does not take'],
  [body('return vec3(1., 2.);'), 2, 'expected 3 components for vec3, got 2'],
  [body('return vec3(p, 1.);'), 2, 'one too many'],
  [body('return vec3();'), 2, 'needs a value'],
  [body('return mat3(1., 2.)[0];'), 2, 'expected 9 components for mat3'],
  [body('return vec3(float[2](1., 2.));'), 2, 'expected numbers and vectors for vec3'],
  [body('return p[0][0];'), 2, 'a float has no elements'],
  [body('return vec3(p[1.]);'), 2, 'expected an int or uint as index'],
  [body('return vec3(p[3]);'), 2, 'expected an index from 0 to 2, got 3'],
  [body('float a[2]; return vec3(a[-1]);'), 2, 'expected an index from 0 to 1, got -1'],
  [body('float a[0]; return p;'), 2, 'the length of an array'],
  [body('float a[int(p.x)]; return p;'), 2, 'the length of an array'],
  [body('float a[2][2]; return p;'), 2, 'arrays of arrays'],
  [body('float a[]; return p;'), 2, 'needs a length'],
  [
    body('float a[3] = float[2](1., 2.); return p;'),
    2,
    'expected a float[3] as the value of "a", got a float[2]',
  ],
  [body('void v; return p;'), 2, 'cannot be void'],
  ['vec3 offset(void p) { return vec3(0.); }', 1, 'a parameter cannot be void'],
  [
    'uniform sampler2D a, b;\nvec3 offset(vec3 p) { return texture(p.x > 0. ? a : b, p.xy).xyz; }',
    2,
    'an image cannot be chosen by ? :',
  ],
  ['void f(sampler2D a, sampler2D b) { a = b; }', 1, 'an image cannot be assigned'],
  ['void f(inout sampler2D a) { }', 1, 'an image can only be read'],
  ['uniform sampler2D s;\nsampler2D f() { return s; }', 2, 'a function cannot return an image'],
  [
    'uniform sampler2D a, b;\n' + body('return texture(sampler2D[](a, b)[int(p.x)], p.xy).xyz;'),
    3,
    'there is no constructor of sampler2D[2]',
  ],
  // sizes
  [
    'struct A { float a[4096]; };\nstruct B { A a[16]; };\n' + body('B b[4096]; return p;'),
    4,
    'is too large',
  ],
  ['struct A { float a[4096]; };\nvoid f(A a[17]) { }', 2, 'is too large'],
  ['struct A { float a[4096]; };\nA[17] f() { }', 2, 'is too large'],
  [
    'struct A { float a[4096]; };\n' + Array.from({ length: 300 }, (_, i) => `A a${i};`).join('\n'),
    258,
    'too large in total',
  ],
  [
    'uniform vec4 a[4096], b[4096], c[4096], d[4096],\n e[4096], f[4096], g[4096], h[4096], i[4096], j[4096], k[4096], l[4096], m[4096], n[4096], o[4096], o2[4096], p[4096];',
    2,
    'too many inputs',
  ],
  // overloads
  [body('return sin(p, p);'), 2, '"sin" cannot be called with (vec3, vec3)'],
  [body('return vec3(dot(p, p.xy));'), 2, '"dot" cannot be called with (vec3, vec2)'],
  [body('return vec3(max(1, 2.));'), 2, '"max" cannot be called'],
  [
    'float f(float x) { return x; }\n' + body('return vec3(f(p));'),
    3,
    '"f" expected (float), got (vec3)',
  ],
  [
    'float f(float x) { return x; }\nfloat f(float y) { return y; }',
    2,
    'already has a body for these parameters',
  ],
  [
    'float f(float x);\nint f(float x) { return 1; }',
    2,
    'declared before with another result, a float',
  ],
  ['float f(float x);\n' + body('return vec3(f(p.x));'), 3, 'is declared, but has no body'],
  [
    'void f(const float x);\nvoid f(float x) { }',
    2,
    'parameter 1 of "f" was declared const before, and is in here; make both declarations equal',
  ],
  [
    'void f(out float x);\nvoid f(inout float x) { x = 1.; }',
    2,
    'was declared out before, and is inout here',
  ],
  ['float f(float x) { }', 1, 'expected "f" to return a float, but it has no return statement'],
  ['#version 100\nvoid f();\nvoid f();', 3, '"f" is already declared; remove this line'],
  [
    '#version 100\nfloat sin(float x) { return x; }',
    2,
    '"sin" is a built-in function; give yours another name',
  ],
  ['float main(float x) { return x; }', 1, 'write void main()'],
  ['void f(struct S { float x; } s) { }', 1, 'declare it above'],
  // qualifiers
  ['const const float a = 1.;', 1, '"const" occurs twice; remove one'],
  ['smooth flat in float a;', 1, '"smooth" and "flat" cannot be combined; remove one'],
  ['in out float a;', 1, '"in" and "out" cannot be combined'],
  ['varying invariant vec3 a;', 1, '"invariant" must come before "varying"'],
  ['highp uniform float a;', 1, '"uniform" must come before "highp": the order is'],
  ['void f(in const float a) { }', 1, '"const" must come before "in"'],
  ['const uniform float a = 1.;', 1, '"const" and "uniform" cannot be combined'],
  ['inout float a;', 1, '"inout" is for parameters; write in or out'],
  [
    'invariant uniform float a;',
    1,
    '"invariant" is for outputs of a vertex shader, out or varying',
  ],
  [
    'float a;\ninvariant a;',
    2,
    'expected gl_Position, or a variable declared above as out or varying, after invariant, got "a"',
  ],
  ['flat float a;', 1, '"flat" is for in and out; remove it'],
  ['highp bool a;', 1, 'a bool has no precision; remove "highp"'],
  ['attribute ivec3 a;', 1, '"attribute" is not allowed before an ivec3; use floats'],
  ['in bool a;', 1, '"in" is not allowed before a bool; use a number'],
  ['varying float a = 1.;', 1, 'main sets the value of "a"; remove its initializer'],
  ['const float f() { return 1.; }', 1, '"const" is not allowed before a function; remove it'],
  [body('flat float a; return p;'), 2, '"flat" is not allowed before a variable of a function'],
  [
    body('uniform float a; return p;'),
    2,
    '"uniform" is not allowed before a variable of a function',
  ],
  ['struct S { const float x; };', 1, '"const" is not allowed before a field of a structure'],
  ['void f(uniform float a) { }', 1, '"uniform" is not allowed before a parameter'],
  ['struct S { struct T { float x; } t; };', 1, 'declare it above'],
  [
    'precision highp vec3;',
    1,
    'expected float, int or an image type such as sampler2D after the precision, got "vec3"',
  ],
  ['layout(location = x) in float a;', 1, 'expected a whole number below 64 as location, got "x"'],
  ['layout(other) in float a;', 1, 'there is no layout "other"'],
  ['layout(location = 0) uniform float a;', 1, 'with a location is for in and out'],
  ['layout(std140) uniform float a;', 1, 'of this kind is for blocks of uniforms'],
  [
    '#version 300 es\nflat in int a;\nvoid main() { gl_Position = vec4(1.); }',
    2,
    '"flat" is for out in a vertex shader',
  ],
  [
    '#version 300 es\nout int a;\nvoid main() { gl_Position = vec4(1.); }',
    2,
    'write flat before it',
  ],
  [
    '#version 100\nvoid main() { gl_Position = vec4(1.); gl_FragColor = vec4(1.); }',
    2,
    'one is of vertex shaders, the other of fragment shaders',
  ],
  // blocks of uniforms
  ['uniform B { };', 1, 'a block must have a member'],
  ['uniform B { sampler2D x; };', 1, 'declare the image "x" outside of it'],
  ['in B { float x; };', 1, 'only uniforms have blocks; write uniform before "B"'],
  ['uniform B { const float x; };', 1, '"const" is not allowed before a member of a block'],
  ['uniform B { float x; };\nfloat x;', 2, '"x" is already declared here'],
  ['uniform B { float x; } b;\nuniform C { float x; } b;', 2, '"b" is already declared here'],
  ['uniform B { float x; } b;\n' + body('b.x = 1.; return p;'), 3, '"b" is given by the host'],
  [
    'uniform B { float x; } b;\n' + body('b; return p;'),
    3,
    'a block of uniforms has no value; read one of its members',
  ],
  ['uniform B { float x; } b[2];\n' + body('return p * b[int(p.x)].x;'), 3, 'must be a constant'],
  ['#version 100\nuniform B { float x; };', 2, 'declare them one by one'],
  // constants
  [
    body('const float x = p.x; return p;'),
    2,
    '"x" is const, but its value is known only when the shader runs; remove const',
  ],
  ['uniform float u;\nconst float x = u;', 2, '"x" is const, but'],
  ['float f() { return 1.; }\nfloat x = f();', 2, 'assign "x" in a function'],
  ['#version 300 es\nuniform float u;\nfloat x = u;', 3, 'assign "x" in a function'],
  // assignments
  [body('const float x = 1.; x = 2.; return p;'), 2, '"x" is a constant and cannot be changed'],
  ['const float x = 1.;\n' + body('x += 2.; return p;'), 3, 'is a constant'],
  ['uniform float x;\n' + body('x++; return p;'), 3, 'is given by the host and cannot be changed'],
  ['vec3 offset(const vec3 p) { p.x = 1.; return p; }', 1, 'is a constant'],
  [
    body('1. = p.x; return p;'),
    2,
    'expected a variable before =, got a value that cannot be changed',
  ],
  [body('(p + p).x = 1.; return p;'), 2, 'got a value that cannot be changed'],
  [body('p.xx = p.xy; return p;'), 2, 'a component occurs twice'],
  [body('const float x; return p;'), 2, 'needs a value'],
  ['uniform float x = 1.;\n' + body('return p;'), 1, 'remove its initializer'],
  [
    'void f(out float x) { x = 1.; }\n' + body('f(1.); return p;'),
    3,
    'got a value that cannot be changed',
  ],
  [body('true = false; return p;'), 2, 'got a value that cannot be changed'],
  // control flow
  ['vec3 offset(vec3 p) { return offset(p); }', 1, 'calls itself'],
  [
    'float b(float x);\nfloat a(float x) { return b(x); }\nfloat b(float x) { return a(x); }\n' +
      body('return vec3(a(p.x));'),
    2,
    'calls itself',
  ],
  [body('for (;;) { } return p;'), 2, 'has not ended after 20000 iterations'],
  [body('while (true) p.x += 1.; return p;'), 2, 'has not ended'],
  [body('while (p.x < 1.) p.x += .1; return p;'), 2, 'is known only when the shader runs'],
  [
    body('for (int i = 0; i < 9000; i++) for (int j = 0; j < 9000; j++) p.x += 1.; return p;'),
    2,
    '250,000 steps',
  ],
  [body('break; return p;'), 2, 'outside of a loop'],
  [body('if (true) continue; return p;'), 2, 'outside of a loop'],
  [body('case 1: return p;'), 2, 'outside of a switch'],
  [
    body('switch (p.x) { case 1: break; } return p;'),
    2,
    'expected an int or uint as the value of this switch, got a float',
  ],
  [body('switch (1) { p.x = 1.; } return p;'), 2, 'expected a case before this, got "p"'],
  [body('switch (1) { case 1.: break; } return p;'), 2, 'expected a constant int after case'],
  [body('switch (1) { default: break; default: break; } return p;'), 2, 'already has a default'],
  [
    body('switch (1) {\n case 2: break;\n case 1 + 1: break; } return p;'),
    4,
    'this switch already has a case 2; remove one',
  ],
  [
    body('switch (1u) { case 4294967295u: break; case 0xffffffffu: break; } return p;'),
    2,
    'already has a case 4294967295',
  ],
  [
    body('switch (1) { case 2:\n } return p;'),
    2,
    'there is no statement after this label; write break; there',
  ],
  [
    body('int i = 1; switch (1) { case i: break; } return p;'),
    2,
    'expected a constant int after case',
  ],
  [body('while (float x = 1.) { } return p;'), 2, 'expected a bool as condition, got "x", a float'],
  [
    body('for (;;) { if (p.x > 1.) break; p.x += 1.; } return p;'),
    2,
    'or set the option maxIterations',
  ],
  [
    body('do { p.x += 1.; if (p.x > 9.) break; } while (true); return p;'),
    2,
    'or set the option maxIterations',
  ],
  [
    body('int n = int(p.x); for (;;) { n = n * 3 ^ 5; if (n > 9) break; } return p;'),
    2,
    'or set the option maxIterations',
  ],
  [body('discard; return p;'), 2, 'discard is for fragments'],
  [
    body('int i = int(p.x) << 3.; return vec3(float(i));'),
    2,
    '"<<" does not take an int and a float',
  ],
  [
    body('uint i = uint(p.x) + 1; return vec3(float(i));'),
    2,
    '"+" does not take a uint and an int',
  ],
  [body('return dFdx(p);'), 2, 'cannot be used in a warp'],
  // characters and numbers
  ['\0', 1, 'shaders do not allow this character (number 0)'],
  [body('return p; \0'), 2, 'shaders do not allow this character'],
  [body('return p @ p;'), 2, 'shaders do not allow this character: "@"'],
  [body('return p * 1.0é;'), 2, 'shaders do not allow this character'],
  [body('return p * 08.0f5;'), 2, 'is not a number'],
  [body('int i = 99999999999; return p;'), 2, 'is not a whole number of 32 bits'],
  [body('int i = 0x; return p;'), 2, 'is not a whole number'],
  [body('"text"; return p;'), 2, 'GLSL has no strings'],
  ['#include "noise.glsl"', 1, 'replace it with the source in the file'],
  // nesting depth
  [body(`return ${nest('(', 'p', ')', 100_000)};`), 2, 'nested more than 128 deep'],
  [body(`return ${'-'.repeat(50_001)}p;`.replaceAll('--', '- -')), 2, 'nested more than 128 deep'],
  [body(nest('{', '', '}', 50_000)), 2, 'nested more than 128 deep'],
  [body(`return ${nest('sin(', 'p', ')', 30_000)};`), 2, 'nested more than 128 deep'],
  [body(`return ${'p.x > 0. ? p : '.repeat(20_000)}p;`), 2, 'nested'],
  [body(`p.x = ${'p.x = '.repeat(20_000)}1.;`), 2, 'nested more than 128 deep'],
  [body(`${'if (p.x > 0.) '.repeat(20_000)} return p;`), 2, 'nested more than 128 deep'],
  [body(`return p${'.xyz'.repeat(20_000)};`), 2, 'nested too deep'],
  // the preprocessor
  ['#if 1\n' + body('return p;'), 1, 'this #if has no #endif'],
  ['#endif', 1, '#endif has no #if before it'],
  ['#if 1\n#else\n#else\n#endif', 3, 'comes after #else'],
  ['#if (1\n#endif', 1, 'expected ) in this #if'],
  ['#if 1 / 0\n#endif', 1, 'divides by zero'],
  [`#if ${nest('(', '1', ')', 5000)}\n#endif`, 1, 'nested more than 200 deep'],
  ['#define', 1, '#define needs a name'],
  ['#define F(1) 2', 1, 'must be names in ( )'],
  ['#define F(x, x) x', 1, '"x" is already a parameter of "F"'],
  [
    '#define WAVES 4\n\n#define WAVES 5',
    3,
    '"WAVES" was defined with another value in line 1; write #undef WAVES before this line, or use another name',
  ],
  ['#define F(x) x\n#define F(y) y', 2, '"F" was defined with another value in line 1'],
  [
    '#define FANCY 1\n#if FANYC\n#endif',
    2,
    'no #define gives "FANYC" a value; define it, or write defined(FANYC); did you mean FANCY?',
  ],
  ['#if 0\n#elif FANCY == 2\n#endif', 2, 'no #define gives "FANCY" a value'],
  ['#if 1 ^^ 0\n#endif', 1, '^^ is not allowed in #if; write !='],
  ['#if 1 << 40\n#endif', 1, 'shifts by less than 0 or more than 31'],
  ['#ifdef A B\n#endif', 1, 'unexpected "B" after #ifdef; put it into a comment'],
  ['#ifdef A\n#endif A', 2, 'unexpected "A" after #endif'],
  ['#ifdef A\n#else B\n#endif', 2, 'unexpected "B" after #else'],
  ['#undef __LINE__', 1, '"__LINE__" cannot be undefined'],
  ['#undef GL_ES', 1, '"GL_ES" cannot be undefined'],
  ['#undef A B', 1, '#undef takes one name'],
  ['#extension GL_OES_standard_derivatives', 1, 'write it as #extension NAME : enable'],
  ['#extension GL_OES_standard_derivatives : on', 1, '"on" is not a behavior of an extension'],
  ['#extension all : enable', 1, 'all extensions can only be disabled or warned of'],
  ['#extension GL_OWN_thing : require', 1, 'WebGL has no extension "GL_OWN_thing"'],
  [
    '#version 300 es\nfloat x;\n#extension GL_EXT_x : enable',
    3,
    'must come before everything but other directives',
  ],
  ['#pragma optimize', 1, 'write #pragma optimize(on) or (off)'],
  ['#line 1 2 3', 1, '#line takes a line number and a file number, and nothing else'],
  ['#define GL_X 1', 1, 'it is predefined'],
  ['#define F(a, b) a\n' + body('return F(p);'), 3, 'takes 2 arguments'],
  ['#error not today', 1, '#error: not today'],
  ['#nonsense', 1, 'there is no directive #nonsense'],
  ['#version 450', 1, 'write #version 300 es or #version 100; WebGL has no other.'],
  ['float x;\n#version 300 es', 2, 'must come before everything else'],
  ['#line x', 1, 'expected a line number after #line, got "x"'],
  [
    Array.from({ length: 30 }, (_, i) => `#define A${i + 1} A${i} A${i}`).join('\n') +
      '\n#define A0 +\nA30',
    32,
    'too long once its macros are expanded',
  ],
]

test('there are at least 100 cases', () => assert.ok(wrong.length >= 100, `${wrong.length}`))

for (const [source, line, piece] of wrong)
  test(`reports an error in line ${line}: ${piece}`, () => {
    assert.throws(
      () => compileWarp(glslOffset(source)),
      (error) => {
        assert.ok(error instanceof WarpError, error.stack)
        const [first, ...rest] = error.message.split('\n')
        assert.match(first, new RegExp(`^glslOffset: line ${line}, column [0-9]+: .*[.?]$`))
        assert.ok(first.includes(piece), first)
        assert.equal(rest.length, 2)
        assert.match(rest[1], /^\s*\^$/)
        assert.ok(error.message.length < 600)
        return true
      },
    )
  })

test('#line changes the reported line number, but not the line that is shown', () => {
  assert.throws(
    () => glslOffset('#line 70\nfloat x = y;'),
    /line 70, column 11: "y" is not declared\.\n {2}float x = y;\n {12}\^/,
  )
})

test('random bytes and random tokens end in a message or a warp', () => {
  let state = 12345
  const random = (n) => (state = (state * 1103515245 + 12345) % 2147483648) % n
  const pieces =
    'vec3 offset ( ) { } return p ; . x float int = + - * / if else for while [ ] , 1.0 1 < # define \n struct const uniform switch case : ? mat3 sin out'.split(
      ' ',
    )
  for (let i = 0; i < 1500; i++) {
    const text = Array.from({ length: random(40) }, () => pieces[random(pieces.length)]).join(' ')
    try {
      glslOffset(i % 2 ? text : body(text))
    } catch (error) {
      if (!(error instanceof WarpError)) throw new Error(`${error.stack}\n${text}`)
    }
  }
})

// Valid and invalid qualifiers and types: qualifiers in all orders, and each type in all places.
import { makeCases, withBody, withTop } from './sources.js'

const qualifiers =
  'const uniform attribute varying in out inout invariant flat smooth centroid highp layout(location=0)'.split(
    ' ',
  )
const pairs = qualifiers.flatMap((first) => qualifiers.map((second) => `${first} ${second}`))
const triples = qualifiers.flatMap((first, i) =>
  qualifiers.flatMap((second, k) =>
    k === i ? [] : `${first} ${second} ${qualifiers[(3 * i + 5 * k) % qualifiers.length]}`,
  ),
)

/** Qualifiers before types, in many orders. */
export const qualifierOrders = [
  ...makeCases('qualifiers of a global', [...qualifiers, ...pairs, ...triples], (words) =>
    withTop(`${words} float a${words.includes('const') ? ' = 1.0' : ''};`),
  ),
  ...makeCases('qualifiers of a parameter', [...qualifiers, ...pairs], (words) =>
    withTop(`void f(${words} float a) {}`),
  ),
  ...makeCases('qualifiers of a local', [...qualifiers, ...pairs], (words) =>
    withBody(`${words} float a${words.includes('const') ? ' = 1.0' : ''};`),
  ),
  ...makeCases('qualifiers of a field', qualifiers, (words) =>
    withTop(`struct S { ${words} float a; };`),
  ),
  ...makeCases('qualifiers of a function', [...qualifiers, ...pairs], (words) =>
    withTop(`${words} float f() { return 1.0; }`),
  ),
  ...makeCases('qualifiers of a structure', qualifiers, (words) =>
    withTop(`${words} struct S { float x; } s;`),
  ),
]

const types =
  'void bool int float vec2 ivec3 bvec4 mat2 mat3 sampler2D S uint uvec2 mat2x3 mat4x2 samplerCube T'.split(
    ' ',
  )
const structures = 'struct S { float x; }; struct T { float x[2]; };'

/** Each type in each place where a type may be. */
export const typeUses = types.flatMap((type) =>
  makeCases(
    `a ${type}`,
    [
      'X a;',
      'X a[2];',
      'uniform X a;',
      'uniform X a[2];',
      'attribute X a;',
      'varying X a;',
      'in X a;',
      'out X a;',
      'flat out X a;',
      'const X a = X(1.0);',
      'highp X a;',
      'precision highp X;',
      'void f(X a) {}',
      'void f(out X a) {}',
      'void f(X a[2]) {}',
      'X f();',
      'X[2] f();',
      'struct U { X a; };',
      'uniform B { X a; };',
      'void f() { X a; }',
      'void f() { X a = X(1.0); }',
      'void f() { X(1.0); }',
      'void f() { X(X(1.0)); }',
      'void f() { X a; a = a; }',
      'void f() { X a; a == a; }',
      'void f() { X a; a + a; }',
      'void f() { X a; a < a; }',
      'void f() { X a; a++; }',
      'void f() { X a; -a; }',
      'void f() { X a; !a; }',
      'void f() { X a; a[0]; }',
      'void f() { X a; a.x; }',
      'void f() { X a; a.length(); }',
      'void f() { X a; if (a) {} }',
      'void f() { X a; true ? a : a; }',
      'void f() { X a; a, a; }',
      'void f() { X a[2]; a[1] = a[0]; }',
      'X f() { X a; return a; }',
      'void f() { X a; float(a); }',
      'void f() { X a; vec2(a, 1.0); }',
      'void f() { X a; float[2](a, a); }',
      'void f() { X a; a * a; }',
      'void f() { X a; a % a; }',
      'void f() { X a; a *= 2.0; }',
      'void f() { X a; 2.0 * a; }',
      'void f() { X a; a && a; }',
      'void f() { X a; abs(a); }',
      'void f() { X a; min(a, a); }',
      'void f() { X a; sin(a); }',
      'void f() { X a; length(a); }',
      'void f() { X a; mix(a, a, 0.5); }',
      'void f() { X a; not(a); }',
      'void f() { X a; lessThan(a, a); }',
      'void f() { X a; equal(a, a); }',
      'void f() { X a; dot(a, a); }',
      'void f() { X a; any(a); }',
      'void f() { X a; switch (a) { default: break; } }',
    ],
    (text) => withTop(`${structures} ${text.replaceAll('X', type)}`),
  ),
)

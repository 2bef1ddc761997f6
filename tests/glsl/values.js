// Functions `vec3 own(vec3 p)` whose values depend on a rule of the language, valid in version 3.00 or in both versions. Tests compare the
// values with a browser's. Source that begins with `#line` has the same line numbers wherever it is inserted.
const withBody = (statements, above = '') => `${above}\nvec3 own(vec3 p) { ${statements} }`
const withResult = (expression, above) => withBody(`return vec3(${expression});`, above)

const inBothVersions = {
  'a backslash continues a comment': `#line 1
vec3 own(vec3 p) {
  float x = 1.0; // this goes on \\
  x = 2.0;
  return p * x;
}`,
  'a backslash within a word, a number and a directive': `#define LO\\
NG 1.\\
5
vec3 own(vec3 p) { flo\\
at x = 2\\
.5; return p * x * LONG; }`,
  'lines that end with \\r':
    'vec3 own(vec3 p) {\r  // a comment\r  float x = p.x;\r  return vec3(x, 2.0, 3.0);\r}\r',
  '__LINE__ after #line': `#line 20
float a = float(__LINE__);
float b = float(__LINE__);
vec3 own(vec3 p) { return vec3(a, b, __LINE__); }`,
  '__FILE__ after #line': `#line 1 7
vec3 own(vec3 p) { return vec3(__FILE__, __LINE__, 0); }`,
  '#line with expressions': `#define TEN 10
#line (TEN + 2) (TEN - 7)
vec3 own(vec3 p) { return vec3(__FILE__, __LINE__, 0); }`,
  'a #line directive over two lines': `#line 5 \\
 3
vec3 own(vec3 p) { return vec3(__FILE__, __LINE__, 0); }`,
  'a macro over several lines': `#line 50
#define F(x, y) vec3(x, y, __LINE__)
#define G(x) F(x, __LINE__)
vec3 own(vec3 p) {
  return F(1.0,
           __LINE__
           ) + G(
    3.0
  );
}`,
  'a macro called by a macro over several lines': `#line 60
#define LINE __LINE__
#define F(x) vec3(LINE, x, LINE)
vec3 own(vec3 p) { return F(
  LINE
) + vec3(LINE); }`,
  __VERSION__: withResult('__VERSION__, 0, 0'),
  'operands in #if that && and || do not evaluate': `#if 0 && NOTHING
#define X 1.0
#elif 1 || NOTHING / 0
#define X 2.0
#endif
vec3 own(vec3 p) { return p * X; }`,
  'a loop that only a break ends': withBody(
    'float x = p.x; for (int i = 0; i < 100; i++) { x = x * 0.5 + 1.0; if (float(i) > 3.0 + p.y) break; } return vec3(x);',
  ),
  'a matrix of surplus components': withResult('mat2(p.xy, p) * p.yz, mat2(p, p)[1].y'),
  'array lengths that are constants': withBody(
    'float a[3]; for (int i = 0; i < 3; i++) a[i] = p.x * float(i); float b[v.y]; b[1] = a[2]; return vec3(b[1], a[1], p.z);',
    'const ivec2 v = ivec2(1, 2);',
  ),
  'an array length from a built-in function': withBody(
    'float a[int(max(2.0, 3.0)) + int(cos(0.0))]; for (int i = 0; i < 4; i++) a[i] = p.x; return vec3(a[3], a[0], p.z);',
  ),
  'an array length from a field': withBody(
    'float a[s.y]; for (int i = 0; i < 5; i++) a[i] = p.x; return vec3(a[4], p.yz);',
    'struct S { float x; int y; }; const S s = S(1.5, 5);',
  ),
  'an infinite literal': withResult('1e60 > 3e38 ? p.x : 0.0, 1.0 / 1e60, min(p.y, 1e60)'),
  'a variable that shadows its function': withBody('float own = 2.0; return p * own;'),
  'a conditional expression': withBody(
    'bool b = p.x > 0.0; float x = b ? 1.0 : 2.0; return vec3(x);',
  ),
  'a structure within a function': withBody('struct S { vec3 v; } s = S(p * 2.0); return s.v;'),
  'a parameter in the scope of its body': withBody(
    '{ float p = 3.0; if (p > 2.0) return vec3(p); } return p;',
  ),
}

const onlyIn300 = {
  'a while with a break before its counter': withBody(
    'vec3 s = p; int i = 0; while (i < 7) { s = sin(s.yzx * 1.5) + p * float(i) * 0.2; if (s.x > 1.1) break; if (s.y < -0.9) { s.z += 2.0; break; } s.y += 0.1; i++; } return s + float(i);',
  ),
  'a while with a return before its counter': withBody(
    'vec3 s = p; int i = 0; while (i < 9) { if (s.x + s.y > 1.5) return s * float(i); s = s.yzx + 0.3 * p; i++; } return s;',
  ),
  'a condition of while that declares a variable': withBody(
    'float x = p.x; int n = 0; while (bool more = n < 4) { x += more ? 1.0 : 9.0; n++; } return vec3(x);',
  ),
  'a condition of for that declares a variable': withBody(
    'float x = p.x; for (int i = 0; bool more = i < 5; i++) { x = x * 0.5 + float(more); } return vec3(x);',
  ),
  'a do loop with a constant number of iterations': withBody(
    'float x = p.x; int i = 0; do { x = sin(x) + 0.5; i++; } while (i < 30); return vec3(x, float(i), 0.0);',
  ),
  'a do loop whose condition has a side effect': withBody(
    'float x = p.x; int i = 0; do { x = x * 0.5 + 1.0; } while (++i < 25); return vec3(x, float(i), 0.0);',
  ),
  'a do loop with continue and break': withBody(
    'float x = p.x; int i = 0; do { i++; if (i % 3 == 0) continue; x = sin(x) + 0.5 * p.y; if (x > 1.2) break; } while (i < 40); return vec3(x, float(i), 0.0);',
  ),
  'nested do loops': withBody(
    'float x = p.x; int i = 0; do { int j = 0; do { x = sin(x + p.y) * 0.9; j++; } while (j < 4); i++; } while (i < 6); return vec3(x, float(i), 0.0);',
  ),
  'a do loop that runs once': withBody(
    'float x = p.x; do { x += 1.0; } while (false); return vec3(x);',
  ),
  'case labels that are constants': withBody(
    'int k = int(floor(p.x * 4.0)); switch (k) { case max(-9, -3): return vec3(1.0); case ivec2(2, -2).y: return vec3(2.0); case v.x: return vec3(3.0); case S(0).x: return vec3(4.0); case w[1]: return vec3(5.0); case int(uint(2)): return vec3(6.0); default: return vec3(k); }',
    'struct S { int x; }; const ivec2 v = ivec2(-1, 7); const int w[2] = int[2](9, 1);',
  ),
  'case labels of type uint': withBody(
    'switch (uint(abs(p.x) * 4.0)) { case 0u: return vec3(1.0); case 1u + 0u: return vec3(2.0); default: return vec3(3.0); }',
  ),
  'array lengths from other constants': withBody(
    `float a[abs(-2)], b[w.length()], c[w[0]], d[int(transpose(mat2(1, 2, 3, 4))[1][0])], e[floatBitsToInt(2.0) / 536870912], f[int(inverse(mat2(0.5))[1][1])], g[int(length(vec2(3, 4)))], h[int(determinant(mat3(2.0)))];
     return vec3(a.length() + b.length() * 10 + c.length() * 100, d.length() + e.length() * 10 + f.length() * 100, g.length() + h.length() * 10);`,
    'const int w[3] = int[3](3, 4, 5);',
  ),
  'array lengths from vector functions': withBody(
    `float a[int(reflect(vec2(1, -3), vec2(0, 1)).y)], b[int(dot(vec3(1), vec3(2)))], c[int(cross(vec3(1, 0, 0), vec3(0, 2, 0)).z)], d[int(pow(2.0, 3.0) + sqrt(4.0))], e[int(mix(2.0, 6.0, 0.5))], f[int(smoothstep(0.0, 2.0, 1.0) * 6.0)], g[any(bvec2(false, true)) ? 4 : 5], h[int(refract(vec2(0, -3), vec2(0, 1), 1.0).x) + 1], k[int(faceforward(vec2(3), vec2(1), vec2(-1)).x)], m[int(outerProduct(vec2(2), vec2(3))[1][1])];
     return vec3(a.length() + 10 * b.length() + 100 * c.length() + 1000 * d.length(), e.length() + 10 * f.length() + 100 * g.length(), h.length() + 10 * k.length() + 100 * m.length());`,
  ),
  'isinf and isnan of an infinite literal': withResult(
    'isinf(1e60) ? 1.0 : 0.0, isinf(-1e60) ? 1.0 : 0.0, isnan(1e60) ? 1.0 : 0.0',
  ),
  'a constant array': withResult(
    'w[1] * p.x, w[0], w.length()',
    'const float w[2] = float[](2.5, 3.5);',
  ),
}

export const values = {
  100: inBothVersions,
  300: { ...inBothVersions, ...onlyIn300 },
}

/** Maps the title of a block of uniforms → its declaration, and the function that reads it. */
export const blocks = {
  'without a name': [
    'layout(std140) uniform Waves { vec4 way; float height; float length_; };',
    'vec3 own(vec3 p) { return way.xyz * height * sin(p.x * length_); }',
  ],
  'with a name': [
    'layout(std140) uniform Waves { vec4 way; float height; float length; } waves;',
    'vec3 own(vec3 p) { return waves.way.xyz * waves.height * sin(p.x * waves.length); }',
  ],
  'of matrices and arrays': [
    'struct Wave { vec4 way; float height; };\nlayout(std140) uniform Waves { Wave all[2]; mat2x3 turn; mat4 view; int count; } waves;',
    'vec3 own(vec3 p) { vec3 sum = waves.turn * p.xy + (waves.view * vec4(p, 1.0)).xyz; for (int i = 0; i < 2; i++) sum += waves.all[i].way.xyz * waves.all[i].height; return sum * float(waves.count & 3); }',
  ],
  'with row-major matrices': [
    'layout(std140, row_major) uniform Waves { mat3 turn; } waves;',
    'vec3 own(vec3 p) { return waves.turn * p; }',
  ],
  'several in an array': [
    'layout(std140) uniform Waves { vec4 way; } waves[2];',
    'vec3 own(vec3 p) { return waves[0].way.xyz + waves[1].way.yzw * p; }',
  ],
}

// Functions `fn own(p: vec3f) -> vec3f` in WGSL, one or more per construct. Their points have coordinates from -1 to 1.
const fn = (statements, above = '') => `${above}\nfn own(p: vec3f) -> vec3f {\n  ${statements}\n}`

export const ownFunctions = {
  'operators of floats': fn('return (p + 1.5) * vec3f(2, -1, 0.5) / (2 - p.zxy) - p * 0.25;'),
  'the remainder has the sign of its dividend': fn(
    'return (p * 7.3) % vec3(2.5, -1.25, 2) + p.x % 0.3;',
  ),
  'negation and precedence': fn('return -p * 2 + vec3f(-p.x * -p.y, 1 - -p.z, -(p.x - p.y));'),
  'both spellings of types': fn(
    'let a: vec3<f32> = vec3f(p); let b: vec2<i32> = vec2i(1, 2); let m: mat2x2<f32> = mat2x2f(1, 2, 3, 4); return a + vec3<f32>(m * vec2<f32>(b), 0);',
  ),
  'abstract numbers': fn(
    'return p * n / 3 + vec3(1, half, n) + f32(n << 2) + vec3f(vec2(1 / 2, 1.0 / 2), 7 % 4);',
    'const n = 5; const half = 0.5;',
  ),
  'abstract vectors and arrays': fn(
    'const a = array(1, 2.5, 3); const v = vec3(1, 2, 3); let i = u32(p.x > 0); return p * a[1] + vec3f(v) * v.zyx + a[i];',
  ),
  'numbers in hexadecimal': fn('return p * 0x1p-3f + f32(0xFF) + f32(0x10u) + 0x1.8p1;'),
  integers: fn(
    'let i = i32(p.x * 10); let j = i32(p.y * 10) | 1; return vec3f(f32(i / j), f32(i % j), f32(i * j - 3)) + f32(-7 / 2) + f32(-i);',
  ),
  'unsigned integers wrap': fn(
    'let u = bitcast<u32>(p.x) * 1664525u + 1013904223u; return vec3f(f32(u >> 8u), f32((u ^ (u << 13u)) & 0xFFFFu), f32(~u >> 16u)) / 65536;',
  ),
  shifts: fn(
    'let i = i32(p.x * 1000); let n = u32(abs(p.y) * 8); return vec3f(f32(i << n), f32(i >> 2u), f32((5u << n) | 1u));',
  ),
  'bits of booleans': fn(
    'let a = p.x > 0; let b = p.y > 0; return vec3f(f32(a & b), f32(a | !b), f32(a != b)) + select(0., 1., a && (b || p.z > 0));',
  ),
  'comparisons of vectors': fn(
    'let less = p < vec3f(0.1); let same = vec3i(p * 2) == vec3i(0, 1, -1); return select(p, vec3f(5), less) + vec3f(f32(any(same)), f32(all(!less)), 0) + vec3f(less | same);',
  ),
  'select with one condition': fn(
    'return select(p, p.zyx * 2, p.x > p.y) + f32(select(1i, 2i, p.z < 0));',
  ),
  'let, var and shadowing': fn(
    'let x = p.x; var y = x; { let x = p.y * 2; y += x; { var y = 3.0; y *= 2; } } return vec3f(x, y, p.z);',
  ),
  'a variable starts at zero': fn(
    'var v: vec3f; var a: array<i32, 2>; v.x += p.x; a[1] += 1; return v + f32(a[0] + a[1]);',
  ),
  'compound assignments': fn(
    'var v = p; v += p.x; v -= 0.5; v *= vec3f(1, 2, 3); v /= 1.5; v.y += 1; v[2] *= 2; var i = 7; i %= 4; i <<= 2u; i >>= 1u; i |= 8; i &= 13; i ^= 3; i++; i--; i++; return v + f32(i); ',
  ),
  swizzles: fn('let v = vec4f(p, 1); return v.wzyx.xyz + v.rgb * v.gbr - p.xxy;'),
  matrices: fn(
    'let m = mat3x3f(p, p.yzx, vec3f(1, 2, 3)); let n = transpose(m) * 0.5 + m - m; return m * p + p * n + m[1] * determinant(m) + vec3f(m[0][2]);',
  ),
  'matrices that are not square': fn(
    'let m = mat2x3f(vec3f(1, 2, 3), p); let n = mat3x2<f32>(1, 2, 3, 4, 5, 6); return (m * n) * p + m * (p * m);',
  ),
  structures: fn(
    'var w = Wave(vec2f(1, 0.5), array<f32, 3>(p.x, p.y, 2), 0.25); w.way.y *= 2; w.heights[1] = w.heights[0] * 3; let c = w; return vec3f(c.way, c.heights[1]) * c.size + height(w);',
    'struct Wave { way: vec2f, @align(16) heights: array<f32, 3>, size: f32, }; fn height(w: Wave) -> f32 { return w.heights[1] * w.way.y; }',
  ),
  'arrays of arrays': fn(
    'var a = array<array<f32, 2>, 3>(array<f32, 2>(p.x, 1), array<f32, 2>(2, p.y), array(3f, p.z)); a[1][0] += 0.5; let i = u32(p.x > 0); let row = a[i + 1]; return vec3f(a[2][1], a[i][1], row[0]);',
  ),
  'arrays with an index that varies': fn(
    'var a = array(p.x, p.y, p.z, 4); let i = u32(abs(p.y) * 3.9); a[i] *= 2; return vec3f(a[i], a[3 - i], a[0]) + p[i % 3];',
  ),
  'zero values': fn(
    'return vec3f() + mat3x3f() * p + Empty().a[1] + p;',
    'struct Empty { a: array<vec3f, 2> }',
  ),
  constructors: fn(
    'let a = vec3(p.xy, 1); let b = vec4f(0.5, a); let c = vec3f(vec3i(p * 9)); let d = mat2x2(b.xy, b.zw); return a + b.yzw + c + vec3f(d[1], f32(true));',
  ),
  conversions: fn(
    'return vec3f(f32(i32(p.x * 5)), f32(u32(abs(p.y) * 5)), f32(bool(i32(p.z * 2)))) + f32(i32(4000000000u)) * 1e-9 + f32(u32(-1i)) * 1e-9;',
  ),
  bitcast: fn(
    'return bitcast<vec3f>(bitcast<vec3i>(p) & vec3i(0x7FFFFFFF)) + bitcast<f32>(0x3F800000u) + f32(bitcast<i32>(4294967295u));',
  ),
  'early returns': fn(
    'if p.x < -0.5 { return p * p; } else if (p.x < 0.3) { return sin(p); } return cos(p) * 2;',
  ),
  'for with break and continue': fn(
    'var sum = p; for (var i = 0; i < 8; i++) { if i == 3 { continue; } sum += sin(p * f32(i)) / f32(i + 1); if sum.x > 1.2 { break; } sum.y += 0.1 * p.y; } return sum;',
  ),
  'for with parts missing': fn(
    'var i = 0; var s = p; for (;;) { if (i > 3) { break; } s += p.zxy; i++; } for (; i < 6; ) { s *= 0.5; i += 1; } return s;',
  ),
  while: fn('var n = 5; var s = vec3f(1); while n > 0 { s = s * p + 1; n--; } return s;'),
  'while with a break before its counter': fn(
    'var i = 0; var s = p; while i < 7 { s = sin(s.yzx * 1.5) + p * f32(i) * 0.2; if s.x > 1.1 { break; } if s.y < -0.9 { s.z += 2; break; } s.y += 0.1; i++; } return s + f32(i);',
  ),
  'loop with two breaks before its counter': fn(
    'var i = 0; var s = p; loop { if i >= 5 { break; } if s.x > 1.1 { s.y += 3; break; } s = s.yzx + 0.4 * p; i += 1; } return s + f32(i);',
  ),
  'loop with break': fn(
    'var i = 0u; var s = p; loop { if i == 4u { break; } s += p * f32(i); i += 1u; } return s;',
  ),
  'loop with continuing': fn(
    'var i = 0; var s = vec3f(); loop { if i % 2 == 1 { continue; } s += p / f32(i + 1); continuing { i += 1; if i > 100 { i = 0; } break if i >= 7; } } return s;',
  ),
  'continuing reads the variables of the body': fn(
    'var i = 0; var s = vec3f(); loop { if s.x > 1.5 { break; } let step = p * f32(i) + 0.1; var twice = step.x; twice *= 2; continuing { s += step; s.y += twice; i++; break if i >= 9; } } return s;',
  ),
  'nested loops': fn(
    'var s = vec3f(); for (var i = -1; i <= 1; i++) { for (var j = -1; j <= 1; j++) { if i == j { continue; } let d = p.xy - vec2f(vec2(i, j)); s += exp(-dot(d, d)); } } return s;',
  ),
  switch: fn(
    'var s = p; for (var i = 0; i < 6; i++) { switch i { case 0, 3: { s.x += 1; } case 1 { s.y *= 2; if p.x > 0 { break; } s.y -= 1; } case 4, default: { s.z += f32(i); continue; } } s += 0.125; } return s;',
  ),
  'switch of an unsigned number, default first': fn(
    'switch u32(abs(p.x) * 4) { default: { return p; } case 0: { return p.zyx; } case 1u, 2: { return -p; } }',
  ),
  'pointers to variables': fn(
    'var v = p; let q = &v; *q += 1; (*q).x *= 2; q.y = 5 * p.y; twice(q); twice(&v); return v;',
    'fn twice(v: ptr<function, vec3f>) { *v = *v * 2; v.z += 0.25; v[0] -= 1; }',
  ),
  'a pointer to an element keeps its index': fn(
    'var a = array(p.x, p.y, p.z); var i = 0; let q = &a[i]; i = 2; *q = 5; add(&a[i], p.x); return vec3f(a[0], a[1], a[2]);',
    'fn add(x: ptr<function, f32>, y: f32) { let z = x; *z += y; }',
  ),
  'private variables': fn(
    'count(); count(); bump(&total); return p * f32(calls) + total;',
    'var<private> calls: i32 = 1; var<private> total = vec3f(0.5); fn count() { calls++; total.x += 1; } fn bump(v: ptr<private, vec3f>) { (*v).y += 2; }',
  ),
  'declarations in any order':
    fn('return wave(p) * amount;') +
    '\nfn wave(p: Point) -> Point { return sin(p * speed) + shift(); }\nconst amount = f32(half) * 3;\nalias Point = vec3f;\nconst speed: f32 = 2 * amount;\nconst half = 0.5;\nfn shift() -> Point { return table[1]; }\nconst table = array(vec3f(1), vec3f(0, 1, 2));',
  'assertions, phony assignments and comments': fn(
    'const_assert 2 * 3 == 6; _ = sin(p); /* a /* nested */ one */ ; let x = p; // ends here\n return x;',
    'const_assert vec2(1, 2).y == 2;',
  ),
  'names of built-in functions': fn(
    'let sin = p.x; return vec3f(sin, fract(p.y), max.x);',
    'const max = vec2f(3); fn fract(x: f32) -> f32 { return x * 2; }',
  ),
  'attributes and entry points': fn(
    'return p;',
    'struct Out { @builtin(position) at: vec4f, @location(0) @interpolate(flat) n: u32 }; @vertex fn vertexMain(@builtin(vertex_index) i: u32, @location(0) at: vec3f) -> Out { var o: Out; o.at = vec4f(at, 1); o.n = i; return o; } @fragment fn fragmentMain(v: Out) -> @location(0) vec4f { if v.n > 3 { discard; } return vec4f(dpdx(v.at.x)); }',
  ),

  // built-in functions
  angles: fn(
    'return sin(p) + cos(p) * tan(p * 0.5) + radians(degrees(p)) + vec3f(asin(p.x), acos(p.y), atan(p.z)) + atan2(p, p.yzx);',
  ),
  'hyperbolic functions': fn(
    'return sinh(p) + cosh(p) - tanh(p) + asinh(p) + acosh(p + 2.5) + atanh(p * 0.5);',
  ),
  powers: fn(
    'let q = abs(p) + 0.25; return pow(q, vec3f(1.7)) + exp(p) + log(q) + exp2(p) + log2(q) + sqrt(q) + inverseSqrt(q);',
  ),
  steps: fn(
    'return floor(p * 3) + ceil(p * 3) + round(p * 3.1) + trunc(p * 3) + fract(p) + sign(p) + step(vec3f(0.2), p) + smoothstep(vec3f(-1), vec3f(1), p);',
  ),
  limits: fn(
    'return min(p, p.yzx) + max(p, vec3f()) + clamp(p, vec3f(-0.5), vec3f(0.25)) + saturate(p) + mix(p, p.zxy, 0.25) + mix(p, p.yxz, abs(p)) + abs(p) + fma(p, p.yzx, p.zxy);',
  ),
  'limits of integers': fn(
    'let i = vec3i(p * 9); let u = vec3u(abs(p) * 9); return vec3f(min(i, i.yzx) + max(i, vec3i(2)) * clamp(i, vec3i(-3), vec3i(3)) + abs(i) + sign(i)) + vec3f(min(u, u.zxy) + clamp(u, vec3u(1), vec3u(4)) + abs(u)) + f32(max(1, 2) * abs(-3) + clamp(7, 1, 5) + min(4, 2));',
  ),
  vectors: fn(
    'let q = p.zxy + 0.5; return cross(p, q) + normalize(q) + length(p) + distance(p, q) * dot(p, q) + reflect(p, normalize(q)) + refract(normalize(p), normalize(q), 0.8) + faceForward(p, q, p.yzx) + length(p.x);',
  ),
  'products of integers': fn(
    'return vec3f(f32(dot(vec3i(p * 9), vec3i(1, 2, 3))), f32(dot(vec2u(3, 4), vec2u(5, 6))), 0);',
  ),
  'parts of floats': fn(
    'let m = modf(p * 5); let f = frexp(p * 40); return m.fract + m.whole * 2 + f.fract + vec3f(f.exp) + ldexp(p, vec3i(3, -2, 0)) + ldexp(p.x, 2) + quantizeToF16(p);',
  ),
  'counting bits': fn(
    'let u = vec3u(abs(p) * 1000000); let i = vec3i(p * 100000); return vec3f(countOneBits(u) + countLeadingZeros(u) + countTrailingZeros(u)) + vec3f(firstLeadingBit(i)) * 100 + vec3f(firstTrailingBit(i)) * 1000 + vec3f(firstLeadingBit(u)) + f32(firstLeadingBit(0u) == 4294967295u) + f32(firstTrailingBit(0i)) + f32(countLeadingZeros(0u) + u32(countTrailingZeros(0)));',
  ),
  'moving bits': fn(
    'let u = vec3u(abs(p) * 1000000); let i = vec3i(p * 100000); return vec3f(reverseBits(u) >> vec3u(8)) + vec3f(extractBits(i, 3, 7)) + vec3f(extractBits(u, 2u, 9u)) + vec3f(insertBits(u, u.yzx, 4, 6)) + vec3f(insertBits(i, i.zxy, 0, 32) & vec3i(0xFFFF)) + f32(extractBits(-1, 5, 0));',
  ),
  packing: fn(
    'let a = unpack2x16snorm(pack2x16snorm(p.xy)); let b = unpack2x16unorm(pack2x16unorm(p.yz)); let c = unpack2x16float(pack2x16float(p.xz)); let d = unpack4x8snorm(pack4x8snorm(vec4f(p, 2))); let e = unpack4x8unorm(pack4x8unorm(vec4f(p, 0.4))); return vec3f(a, b.x) + vec3f(c, b.y) + d.xyw + e.yzw;',
  ),
  'packing bytes': fn(
    'let i = vec4i(vec4f(p, 1.9) * 100); let u = vec4u(abs(vec4f(p, 3)) * 100); let a = pack4xI8(i); let b = pack4xU8Clamp(u); return vec3f(unpack4xI8(a).xyw) + vec3f(unpack4xU8(b).xyw) + f32(dot4I8Packed(a, pack4xI8Clamp(i * 3))) + f32(dot4U8Packed(b, pack4xU8(u)));',
  ),
}

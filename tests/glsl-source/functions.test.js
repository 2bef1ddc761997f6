// Tests parts of GLSL source that keep their structure in the code: functions that are called several times, and loops.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compileWarp } from 'warpjet'
import { differentiate, glslOffset } from 'warpjet/glsl'

const targets = ['glsl300', 'glsl100', 'wgsl']

const bumps = `
uniform float steepness;
float bump(vec2 q, float k) {
  vec2 c = q - floor(q + 0.5);
  float d = exp(-k * dot(c, c)) + steepness * sin(q.x * 1.3) * cos(q.y * 0.7);
  return d * d + 0.25 * d;
}
`

/** The function bump in JavaScript. */
const bump = (x, y, k, steepness) => {
  const [cx, cy] = [x - Math.floor(x + 0.5), y - Math.floor(y + 0.5)]
  const d = Math.exp(-k * (cx * cx + cy * cy)) + steepness * Math.sin(x * 1.3) * Math.cos(y * 0.7)
  return d * d + 0.25 * d
}

const thrice = `${bumps}
vec3 offset(vec3 p) { return vec3(bump(p.xy, 3.0), bump(p.yz * 2.0, 3.0), bump(p.zx, 3.0)); }`

const uniforms = { steepness: 0.4 }

/** Computes the expected normal from central differences of `move`. */
function normalOf(move, [x, y, z], normal) {
  const h = 1e-5
  const column = (k) => {
    const moveBy = (s) => move([x, y, z].map((c, i) => (i === k ? c + s : c)))
    const [high, low] = [moveBy(h), moveBy(-h)]
    return high.map((c, i) => (c - low[i]) / (2 * h))
  }
  const [a, b, c] = [0, 1, 2].map(column)
  const cross = (u, v) => [
    u[1] * v[2] - u[2] * v[1],
    u[2] * v[0] - u[0] * v[2],
    u[0] * v[1] - u[1] * v[0],
  ]
  const cofactor = [cross(b, c), cross(c, a), cross(a, b)]
  const transformed = [0, 1, 2].map((i) =>
    normal.reduce((sum, n, k) => sum + n * cofactor[k][i], 0),
  )
  return transformed.map((n) => n / Math.hypot(...transformed))
}

const assertNear = (actual, expected, tolerance) =>
  expected.forEach((value, i) =>
    assert.ok(Math.abs(actual[i] - value) <= tolerance, `${Array.from(actual)} is not ${expected}`),
  )

function assertMoves(source, move, options = {}) {
  const warp = compileWarp(glslOffset(source, options), { uniforms })
  for (const p of [
    [0.3, 0.1, -0.2],
    [1.2, -0.7, 0.4],
    [-2.1, 0.9, 1.6],
  ]) {
    const normal = [0.48, 0.6, 0.64]
    const actual = warp.evaluateAt(p, { normal })
    assertNear(actual.position, move(p), 2e-5)
    assertNear(actual.normal, normalOf(move, p, normal), 2e-4)
  }
}

test('a function that is called three times is in the code once, under its own name, with its derivatives', () => {
  for (const target of targets) {
    const { code, declarations } = compileWarp(glslOffset(thrice), { target, uniforms })
    const names = [...declarations.matchAll(/\b(bump_\w+)\(/g)].map(([, name]) => name)
    assert.equal(names.length, 1, `${names}`)
    assert.match(names[0], /Gradient$/)
    assert.equal(code.split(names[0]).length - 1, 3)
    // The function returns its value and three derivatives: for two numbers and the uniform, but not for the constant argument.
    assert.doesNotMatch(declarations, /Results/)
  }
})

test('a function that is called three times gives the right positions, and normals that agree with central differences', () => {
  const move = ([x, y, z]) => [
    x + bump(x, y, 3, 0.4),
    y + bump(y * 2, z * 2, 3, 0.4),
    z + bump(z, x, 3, 0.4),
  ]
  assertMoves(thrice, move)
})

test('a function that is called once, short, or constant is inlined', () => {
  const declarationsOf = (body, above = bumps) =>
    compileWarp(glslOffset(`${above}\nvec3 offset(vec3 p) { ${body} }`), { uniforms }).declarations
  assert.equal(declarationsOf('return vec3(bump(p.xy, 3.0));'), '')
  assert.equal(declarationsOf('return vec3(bump(p.xy, 3.0), bump(p.xy, 3.0), 0.0);'), '')
  const half = 'float half_(float x) { return 0.5 * x; }'
  assert.equal(declarationsOf('return vec3(half_(p.x), half_(p.y), half_(p.z));', half), '')
})

test('functions may call functions and have out parameters', () => {
  const source = `${bumps}
  void both(vec2 q, out float high, inout vec2 way) {
    high = bump(q, 2.0) + bump(q.yx + 0.5, 2.0);
    way += vec2(bump(q * 0.5, 2.0), sin(high * 2.0) + high * high * 0.1 + cos(high));
    way = way * 0.5 + way.yx * way.xy * 0.1 + sin(way) * cos(way.yx) + vec2(high * 0.2, high * 0.3);
  }
  vec3 offset(vec3 p) {
    float a, b;
    vec2 w = p.xy;
    both(p.xy, a, w);
    both(p.yz, b, w);
    return vec3(a, b, w.x - w.y) * 0.3;
  }`
  const both = (q, way) => {
    const k = (x, y) => bump(x, y, 2, 0.4)
    const high = k(q[0], q[1]) + k(q[1] + 0.5, q[0] + 0.5)
    const [a, b] = [
      way[0] + k(q[0] * 0.5, q[1] * 0.5),
      way[1] + Math.sin(high * 2) + high * high * 0.1 + Math.cos(high),
    ]
    const one = (u, v, by) => u * 0.5 + u * v * 0.1 + Math.sin(u) * Math.cos(v) + high * by
    return [high, [one(a, b, 0.2), one(b, a, 0.3)]]
  }
  const move = ([x, y, z]) => {
    const [a, first] = both([x, y], [x, y])
    const [b, w] = both([y, z], first)
    return [x + a * 0.3, y + b * 0.3, z + (w[0] - w[1]) * 0.3]
  }
  assertMoves(source, move)
  const { declarations } = compileWarp(glslOffset(source), { uniforms })
  assert.match(declarations, /both_\w+/)
  assert.match(declarations, /bump_\w+/)
})

test('a function that reads and changes a global variable is inlined correctly', () => {
  const source = `float seed = 0.0;
  float next(float x) {
    seed += 1.0;
    float y = sin(x * seed) + cos(x + seed) * exp(-x * x) + x * x * x * 0.1 + sin(x) * cos(x * 2.0);
    return y * y + 0.5 * y;
  }
  vec3 offset(vec3 p) { return vec3(next(p.x), next(p.y), next(p.z)) * 0.2; }`
  const next = (x, seed) => {
    const y =
      Math.sin(x * seed) +
      Math.cos(x + seed) * Math.exp(-x * x) +
      x * x * x * 0.1 +
      Math.sin(x) * Math.cos(x * 2)
    return (y * y + 0.5 * y) * 0.2
  }
  assertMoves(source, (p) => p.map((x, i) => x + next(x, i + 1)))
})

test('equal functions have the same name in two warps, different ones do not', () => {
  const nameIn = (text) =>
    /bump_\w+/.exec(compileWarp(glslOffset(text), { uniforms }).declarations)[0]
  assert.equal(nameIn(thrice), nameIn(thrice.replace('p.zx', 'p.zy')))
  assert.notEqual(nameIn(thrice), nameIn(thrice.replace('0.25', '0.26')))
})

test('differentiate keeps functions that are called several times, too', () => {
  const text = differentiate(
    `${bumps}\nfloat map(vec3 p) { return p.y - bump(p.xz, 2.0) - bump(p.zx * 2.0, 2.0); }`,
  )
  assert.match(text, /bump_\w+Gradient\(.*\{/)
  assert.match(text, /vec4 mapGradient\(vec3 p\)/)
})

const loop = (head, body) =>
  `vec3 offset(vec3 p) { float s = 0.0; float a = 0.5; vec3 q = p; ${head} { ${body} } return vec3(0.0, s, 0.0); }`

const wave =
  's += a * sin(q.x * 1.7 + cos(q.z)) * cos(q.y + sin(q.x)); q = q.yzx * 1.3 + 0.2; a *= 0.5;'

const waves =
  (steps, stop = () => false, weight = () => 1) =>
  (p) => {
    let [s, a, q] = [0, 0.5, [...p]]
    for (let i = 0; i < steps; i++) {
      if (stop(q, i)) break
      s += weight(i) * a * Math.sin(q[0] * 1.7 + Math.cos(q[2])) * Math.cos(q[1] + Math.sin(q[0]))
      q = [q[1] * 1.3 + 0.2, q[2] * 1.3 + 0.2, q[0] * 1.3 + 0.2]
      a *= 0.5
    }
    return [p[0], p[1] + s, p[2]]
  }

const hasLoop = (source, target = 'glsl300', options = {}) =>
  /\bfor \(/.test(compileWarp(glslOffset(source, options), { target, uniforms }).code)

test('a long loop stays a loop, in each language', () => {
  const source = loop('for (int i = 0; i < 8; i++)', wave)
  for (const target of targets) assert.ok(hasLoop(source, target), target)
  assertMoves(source, waves(8))
})

test('a short loop is unrolled', () => {
  assert.ok(!hasLoop(loop('for (int i = 0; i < 2; i++)', wave)))
  assert.ok(!hasLoop(loop('for (int i = 0; i < 8; i++)', 's += p.x * a; a *= 0.5;')))
})

test('counters have the right values in the loop, for any step', () => {
  const weighed = wave.replace('a * sin', 'float(i) * a * sin')
  const source = (head) => loop(head, weighed)
  const wavesOfCounter = (start, step) => waves(7, undefined, (i) => start + step * i)
  for (const [head, start, step] of [
    ['for (int i = 0; i < 7; i++)', 0, 1],
    ['for (int i = 9; i > -12; i -= 3)', 9, -3],
    ['for (int i = 1; i <= 7; ++i)', 1, 1],
    ['for (float i = 2.0; i < 8.5; i += 1.0)', 2, 1],
    ['for (float i = 0.0; i < 3.4; i += 0.5)', 0, 0.5],
    ['int i = 5; while (i-- > -2)', 4, -1],
  ]) {
    assert.ok(hasLoop(source(head)), head)
    assertMoves(source(head), wavesOfCounter(start, step))
  }
})

test('the condition of a loop keeps its side effects', () => {
  const source = loop('int i = 5; while (i-- > -2)', wave).replace(
    'vec3(0.0, s,',
    'vec3(0.0, s + float(i),',
  )
  assert.ok(hasLoop(source))
  const move = waves(7)
  assertMoves(source, (p) => move(p).map((x, k) => (k === 1 ? x - 3 : x)))
  const stops = source.replace('s += a', 'if (q.x > 2.5) break; s += a')
  const stopped = ([x, y, z]) => {
    let [s, a, q, i] = [0, 0.5, [x, y, z], 5]
    while (i-- > -2) {
      if (q[0] > 2.5) break
      s += a * Math.sin(q[0] * 1.7 + Math.cos(q[2])) * Math.cos(q[1] + Math.sin(q[0]))
      q = [q[1] * 1.3 + 0.2, q[2] * 1.3 + 0.2, q[0] * 1.3 + 0.2]
      a *= 0.5
    }
    return [x, y + s + i, z]
  }
  assertMoves(stops, stopped)
})

test('break, continue and return work in a loop', () => {
  const breakIfFar = 'if (q.x > 2.5) break;'
  const source = loop('for (int i = 0; i < 12; i++)', `${breakIfFar} ${wave}`)
  assert.ok(hasLoop(source))
  assertMoves(
    source,
    waves(12, (q) => q[0] > 2.5),
  )
  assertMoves(
    loop('for (int i = 0; i < 9; i++)', wave.replace('a *=', 'if (i == 4) break; a *=')),
    waves(5),
  )
  assertMoves(
    loop(
      'for (int i = 0; i < 9; i++)',
      `float k = i == 3 ? 0.0 : 1.0; ${wave.replace('a * sin', 'k * a * sin')}`,
    ),
    waves(9, undefined, (i) => (i === 3 ? 0 : 1)),
  )
  const returns = `float f(vec3 p) { float s = 0.0; float a = 0.5; vec3 q = p;
    for (int i = 0; i < 12; i++) { if (q.x > 2.5) return s; ${wave} } return s; }
    vec3 offset(vec3 p) { return vec3(0.0, f(p), 0.0); }`
  assert.ok(hasLoop(returns))
  assertMoves(
    returns,
    waves(12, (q) => q[0] > 2.5),
  )
})

test('a counter that a while increments after a break is known, as in a for', () => {
  const breakIfFar = 'if (q.x > 2.5) break;'
  const source = loop('int i = 0; while (i < 12)', `${breakIfFar} ${wave} i++;`)
  assert.ok(hasLoop(source))
  assertMoves(
    source,
    waves(12, (q) => q[0] > 2.5),
  )
  const short = loop('int i = 0; while (i < 3)', `${breakIfFar} ${wave} ${breakIfFar} i++;`)
  assertMoves(
    short,
    waves(3, (q) => q[0] > 2.5),
  )
})

test('a loop whose end depends on values in the shader stays a loop, too', () => {
  const source = loop('while (q.x < 2.5)', wave)
  assert.ok(hasLoop(source, 'glsl300', { maxIterations: 12 }))
  assertMoves(
    source,
    waves(12, (q) => q[0] >= 2.5),
    { maxIterations: 12 },
  )
})

test('the number of iterations is right, also if it is read as an int after the loop', () => {
  const source = `vec3 offset(vec3 p) { vec3 q = p; int n = 0;
    for (int i = 0; i < 20; i++) { if (dot(q, q) > 9.0) break; q = q.yzx * 1.2 + sin(q) * cos(q.zxy) * 0.3 + 0.1; n++; }
    return vec3(float(n), 0.0, 0.0); }`
  assert.ok(hasLoop(source))
  const count = (p) => {
    let [q, n] = [p, 0]
    while (n < 20 && q.reduce((sum, c) => sum + c * c, 0) <= 9) {
      q = q.map((c, i) => q[(i + 1) % 3] * 1.2 + Math.sin(c) * Math.cos(q[(i + 2) % 3]) * 0.3 + 0.1)
      n++
    }
    return n
  }
  assertMoves(source, (p) => [p[0] + count(p), p[1], p[2]])
})

test('loops that compute with bits stay loops', () => {
  const source = `vec3 offset(vec3 p) { uint h = floatBitsToUint(p.x); float s = 0.0;
    for (int i = 0; i < 6; i++) { h = h * 1664525u + 1013904223u; h ^= h >> 13; h ^= h << 7;
      s += float(h >> 8) / 16777216.0 * sin(p.y * float(i)) * cos(p.z + float(i)) + sin(p.x * s); }
    return vec3(0.0, s, 0.0); }`
  assert.ok(hasLoop(source))
})

test('an inner loop can read the counter of the outer loop', () => {
  const body =
    'vec2 c = vec2(float(i), float(j)); s += exp(-dot(p.xz - c, p.xz - c)) * sin(p.y + c.x);'
  const source = loop('for (int i = -2; i <= 2; i++) for (int j = -2; j <= 2; j++)', body)
  assert.ok(hasLoop(source))
  const cells = ([x, y, z]) => {
    let s = 0
    for (let i = -2; i <= 2; i++)
      for (let j = -2; j <= 2; j++) s += Math.exp(-((x - i) ** 2) - (z - j) ** 2) * Math.sin(y + i)
    return [x, y + s, z]
  }
  assertMoves(source, cells)
  const triangle = source.replace('j <= 2', 'j <= i')
  assertMoves(triangle, ([x, y, z]) => {
    let s = 0
    for (let i = -2; i <= 2; i++)
      for (let j = -2; j <= i; j++) s += Math.exp(-((x - i) ** 2) - (z - j) ** 2) * Math.sin(y + i)
    return [x, y + s, z]
  })
})

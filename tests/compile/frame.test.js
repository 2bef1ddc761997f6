// Frame constants in loops: in shader code, and in the values that a host computes.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compile, compileWarp } from '../../dist/warpjet.js'
import { runGlsl } from '../glsl/run.js'

const week = 6e8
const perFrame = { perFrame: true, normals: false }

/** Returns the warped position at `millis`, computed like the shader but in double precision. */
function placeOf({ code, declarations, frameUniforms }, position, millis) {
  const frame = frameUniforms({ millis })
  return runGlsl(`${declarations}${code}`, { position, millis, ...frame }).warpedPosition
}

test('a loop whose steps add different phases is unrolled, with a frame constant per step', () => {
  const offset = ({ glsl, position, millis }) => {
    const sum = glsl.repeat(5, 0, (sum, i) =>
      sum.add(position.x.add(millis.mult(i.add(1)).div(700)).sin()),
    )
    return glsl.vec3(0, sum, 0)
  }
  const warp = compileWarp(offset, perFrame)
  assert.doesNotMatch(warp.code, /millis|\bfor\b/)
  const phases = Object.values(warp.frameUniforms({ millis: week })).flat()
  assert.ok(phases.every((phase) => Math.abs(phase) <= Math.PI))
  const expected = [0, 1, 2, 3, 4].map((i) => Math.sin(0.3 + (week * (i + 1)) / 700))
  const [, y] = placeOf(warp, [0.3, 0, 0], week)
  assert.ok(Math.abs(y - expected.reduce((a, b) => a + b)) < 1e-6)
})

test('a loop whose state depends on the time is unrolled, too', () => {
  const offset = ({ glsl, position, millis }) => {
    const start = glsl.vec2(position.x.add(millis.div(900)), 0)
    const step = (state) => glsl.vec2(state.x.mult(2), state.y.add(state.x.sin()))
    const sum = glsl.repeat(4, start, step).y
    return glsl.vec3(0, sum, 0)
  }
  const warp = compileWarp(offset, perFrame)
  assert.doesNotMatch(warp.code, /millis|\bfor\b/)
  const expected = [1, 2, 4, 8].map((k) => Math.sin(k * (0.3 + week / 900)))
  const [, y] = placeOf(warp, [0.3, 0, 0], week)
  assert.ok(Math.abs(y - expected.reduce((a, b) => a + b)) < 1e-5)
})

test('a loop whose steps share their frame constants remains a loop', () => {
  const offset =
    (steps) =>
    ({ glsl, position, millis, uniforms }) => {
      const sum = glsl.repeat(steps, 0, (sum, i) =>
        sum.add(position.x.mult(i).add(millis.div(700)).sin().mult(uniforms.amount.mult(i))),
      )
      return glsl.vec3(0, sum, 0)
    }
  const warp = compileWarp(offset(5), { ...perFrame, uniforms: { amount: 0.1 } })
  assert.match(warp.code, /\bfor\b/)
  assert.doesNotMatch(warp.code, /millis/)
  assert.ok(Object.keys(warp.frameUniforms({ millis: week })).length > 0)
})

test('a long loop remains a loop', () => {
  const offset = ({ glsl, position, millis }) => {
    const sum = glsl.repeat(5000, 0, (sum, i) => sum.add(position.x.add(millis.mult(i)).sin()))
    return glsl.vec3(0, sum, 0)
  }
  const { code } = compileWarp(offset, perFrame)
  assert.match(code, /\bfor\b/)
})

/** A wave. `waveAt` returns its warped position at `millis`, in double precision. */
const wave = ({ glsl, position, millis, uniforms }) =>
  glsl.vec3(0, position.x.mult(3).add(millis.mult(uniforms.speed)).sin(), 0)
const waveAt = ([x, y, z], millis, speed) => [x, y + Math.sin(3 * x + millis * speed), z]

test('all CPU methods are accurate after a week', () => {
  const warp = compileWarp(wave, { perFrame: true, uniforms: { speed: 0.01 } })
  const assertNear = (actual, expected, tolerance = 1e-6) =>
    assert.ok(
      expected.every((x, i) => Math.abs(actual[i] - x) < tolerance),
      `${actual}, not ${expected}`,
    )
  for (const millis of [week, week + 16]) {
    const uniforms = { millis }
    const place = [0.3, 0.5, 0.7]
    const expected = waveAt(place, millis, 0.01)
    const { position, normal } = warp.evaluateAt(place, { uniforms, normal: [0, 1, 0] })
    assertNear(position, expected)
    const slope = 3 * Math.cos(0.9 + millis * 0.01)
    assertNear(normal, [-slope / Math.hypot(slope, 1), 1 / Math.hypot(slope, 1), 0])
    assertNear(
      warp.evaluate({ positions: [...place, ...place] }, { uniforms }).positions.slice(3),
      expected,
    )
    const { min, max } = warp.bounds({ min: place, max: place }, { uniforms })
    assert.ok(
      min[1] <= expected[1] + 1e-7 && max[1] >= expected[1] - 1e-7 && max[1] - min[1] < 1e-4,
    )
    assertNear(warp.inverseAt(expected, { uniforms }).position, place)
    assert.equal(warp.foldover({ positions: place }, { uniforms }).count, 0)
  }
  assertNear(
    warp.evaluateAt([0.3, 0, 0], { uniforms: { millis: week, speed: 0.02 } }).position,
    waveAt([0.3, 0, 0], week, 0.02),
  )
})

test('a function in the option `uniforms` is called once per evaluation, for all its uses', () => {
  let calls = 0
  const speed = () => [0.25, 0.5, 0.75][calls++]
  const offset = (inputs) => wave(inputs).mult(inputs.uniforms.speed)
  const warp = compileWarp(offset, { ...perFrame, uniforms: { speed } })
  const { position } = warp.evaluateAt([0, 0, 0], { uniforms: { millis: 1 } })
  assert.equal(calls, 2)
  assert.ok(Math.abs(position[1] - 0.5 * Math.sin(0.5)) < 1e-6, `${position}`)
})

test('a message names a missing input on the CPU', () => {
  const warp = compileWarp(wave, { ...perFrame, uniforms: { speed: 0.01 } })
  assert.throws(
    () => warp.evaluateAt([0, 0, 0]),
    /^WarpError: evaluateAt: the warp reads "millis"; pass a value, as in \{ millis: 0 \}\.$/,
  )
  assert.throws(() => warp.evaluateAt([0, 0, 0], { uniforms: { milis: 1 } }), /no uniform "milis"/)
})

test('noise far from the origin is as accurate as near it: cells and positions in cells are separate', () => {
  const kinds = {
    noise: ({ glsl, at }) => glsl.noise(at),
    valueNoise: ({ glsl, at }) => glsl.valueNoise(at),
    worley: ({ glsl, at }) => glsl.worley(at).x,
    fbm: ({ glsl, at }) => glsl.fbm(at, { octaves: 4 }),
    ridged: ({ glsl, at }) => glsl.ridged(at, { octaves: 3, lacunarity: 3 }),
    curl: ({ glsl, at }) => glsl.curl(at).y,
    'in a plane': ({ glsl, at }) => glsl.noise(at.xy),
    'that depends only on time': ({ glsl, position, cells }) =>
      glsl.noise(glsl.vec4(position, cells)),
  }
  for (const [name, kind] of Object.entries(kinds)) {
    const offset = ({ glsl, position, uniforms }) => {
      const cells = uniforms.cells.mult(1)
      return glsl.vec3(0, kind({ glsl, position, cells, at: position.add(cells) }), 0)
    }
    const options = { perFrame: true, uniforms: { cells: 0 } }
    const warp = compileWarp(offset, options)
    assert.match(warp.declarations, /Cells/, name)
    const place = [0.3, 0.55, 0.7]
    // This noise is evaluated in double precision. It repeats every 4,091 cells, so a shift and its remainder give the same values.
    const reference = compile((glsl) => {
      const position = glsl.vec3Param('position')
      return { y: offset({ glsl, position, uniforms: { cells: glsl.param('cells') } }).y() }
    })
    const normal = [0, 1, 0]
    for (const cells of [2000.3, -1777.7, 20000.0625, 4091 * 5 + 0.25]) {
      const evaluateOptions = { uniforms: { cells }, normal }
      const { position } = warp.evaluateAt(place, evaluateOptions)
      const y = reference.evaluate({ position: place, cells: cells % 4091 }).y
      assert.ok(
        Math.abs(position[1] - place[1] - y) < 2e-6,
        `${name}, ${cells}: ${position[1] - place[1]}, not ${y}`,
      )
    }
  }
})

test('noise whose cells float32 cannot represent, or that does not repeat by cells, is unchanged', () => {
  for (const kind of [
    ({ glsl, at }) => glsl.fbm(at, { octaves: 14 }),
    ({ glsl, at }) => glsl.fbm(at, { octaves: 3, lacunarity: 2.5 }),
    ({ glsl, at }) => glsl.simplex(at),
    ({ glsl, at }) => glsl.fbm(at.xy, { noise: 'simplex' }),
    ({ glsl, position }) => glsl.noise(position),
  ]) {
    const offset = ({ glsl, position, millis }) =>
      glsl.vec3(0, kind({ glsl, position, at: position.add(millis.div(500)) }), 0)
    const { code, declarations } = compileWarp(offset, perFrame)
    assert.doesNotMatch(declarations + code, /Cells/)
  }
})

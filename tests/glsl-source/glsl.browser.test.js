// Runs GLSL source on real pipelines, and compares the original as compiled by Chromium with our code for it.
import assert from 'node:assert/strict'
import { after, before, test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { differentiate, glslOffset } from '../../dist/glsl.js'
import { compile, compileWarp } from '../../dist/warpjet.js'
import { corpus } from '../glsl/corpus.js'
import { randomFunction, sharedDeclarations } from '../glsl/generate.js'
import { pointsOfCube } from '../glsl/points.js'
import { openPipelines, targetsInThisRun } from '../support/browser/pipelines.js'

let pipelines
before(async () => (pipelines = await openPipelines()))
after(() => pipelines.close())

const inputs = [{ name: 'p', shape: 3 }]

const points = pointsOfCube(60)

/** Runs our code for a function, and in glsl300 also the original, at all points. Returns the compiled function and the values. */
async function valuesOf({ text }, target) {
  const compiled = compile(
    (glsl) => {
      const p = glsl.vec3Param('p')
      const ours = glsl.source(text, { function: 'corpus' })(p)
      return { ours, jacobian: glsl.jacobian(ours, p) }
    },
    { target },
  )
  const isOriginal = target === 'glsl300'
  const outputs = [
    { name: 'ours', shape: 3 },
    { name: 'jacobian', shape: 'mat3' },
  ]
  if (isOriginal) outputs.push({ name: 'original', shape: 3 })
  const values = await pipelines.run(
    target,
    {
      code: `${compiled.code}${isOriginal ? 'vec3 original = corpus(p);' : ''}`,
      declarations: (isOriginal ? text : '') + compiled.declarations,
      inputs,
      outputs,
    },
    points,
  )
  const columns = (from, to) => values.map((numbers) => [...numbers.subarray(from, to)])
  return { compiled, ours: columns(0, 3), jacobian: columns(3, 12), original: columns(12) }
}

/** Evaluates the offset of a function on the CPU, in float32, at all points. */
function evaluateOnCpu({ text }) {
  const warp = compileWarp(glslOffset(text, { function: 'corpus' }), { normals: false })
  const moved = warp.evaluate({ positions: Float32Array.from(points.flat()) }).positions
  return points.map((point, i) => point.map((x, k) => moved[3 * i + k] - x))
}

const tolerance = (value) => 2e-3 * Math.max(1, Math.abs(value))

/** Matches source that uses bit operations, which GLSL 1.00 lacks. */
const bitOperations =
  /\b(?:floatBitsTo\w+|u?intBitsTo\w+|u(?:int|vec\d)|pack\w+2x16)\(|\bint \w+ = .*&/

/** Counts the numbers that differ significantly; ignores undefined values such as 0/0. */
function countDiffering(values, expected, compared = { count: 0 }) {
  let wrong = 0
  values.forEach((numbers, i) =>
    expected[i].forEach((value, k) => {
      if (!Number.isFinite(value) || Math.abs(value) > 1e6) return
      compared.count++
      if (!(Math.abs(numbers[k] - value) <= tolerance(value))) wrong++
    }),
  )
  return wrong
}

test('there are at least 60 functions', () => assert.ok(corpus.length >= 60, `${corpus.length}`))

test('every function of the corpus equals the original, in each language and on the CPU, and so do its derivatives', async () => {
  const problems = []
  const compared = { count: 0 }
  let sameSides = 0
  for (const source of corpus) {
    try {
      const { compiled, original, ...first } = await valuesOf(source, 'glsl300')
      const cpu = points.map((p) => compiled.evaluate({ p }))
      const check = (name, ours, expected = original) => {
        const wrong = countDiffering(ours, expected, compared)
        // A point may be on the edge between two branches.
        if (wrong > expected[0].length) problems.push(`${source.name}, ${name}: ${wrong} differ`)
      }
      // We compare derivatives only at points where the float32 and double values agree: elsewhere, as in a hash, they are on different
      // sides of a jump.
      const isSameSide = cpu.map(({ ours }, i) =>
        ours.every((x, k) => !(Math.abs(x - original[i][k]) > tolerance(x) / 10)),
      )
      sameSides += isSameSide.filter(Boolean).length
      const onSameSide = (rows) => rows.filter((_, i) => isSameSide[i])
      // tests/glsl-source/derivatives.test.js compares the Jacobians of the CPU with finite differences.
      const jacobians = onSameSide(cpu.map(({ jacobian }) => [...jacobian]))
      const checkBoth = (name, { ours, jacobian }) => {
        check(name, ours)
        check(`derivatives in ${name}`, onSameSide(jacobian), jacobians)
      }
      checkBoth('glsl300', first)
      for (const target of targetsInThisRun)
        if (target !== 'glsl300' && !(target === 'glsl100' && bitOperations.test(source.text)))
          checkBoth(target, await valuesOf(source, target))
      check('CPU', evaluateOnCpu(source))
    } catch (error) {
      problems.push(`${source.name}: ${error.message.slice(0, 300)}`)
    }
  }
  assert.deepEqual(problems, [])
  assert.ok(compared.count > corpus.length * 11 * points.length)
  const share = sameSides / (corpus.length * points.length)
  assert.ok(share > 0.99, `derivatives were compared at ${share} of the points`)
})

/** The number of functions per shader. */
const batchSize = 25

/**
 * Runs a batch of functions in a language. Returns a Map from `ours<seed>` and, in glsl300, `original<seed>` to the values at all points.
 * Functions that the language does not support are missing.
 */
async function runRandom(cases, target) {
  const isOriginal = target === 'glsl300'
  const compiled = cases.flatMap(({ seed, glsl }) => {
    const warp = compileIfSupported(glsl, seed, target)
    return warp ? [{ seed, warp }] : []
  })
  const outputs = compiled.flatMap(({ seed }) => [
    { name: `ours${seed}`, shape: 3 },
    ...(isOriginal ? [{ name: `original${seed}`, shape: 3 }] : []),
  ])
  if (outputs.length === 0) return new Map()
  const code = ({ seed, warp }) =>
    `${warp.code}\n${isOriginal ? `vec3 original${seed} = random${seed}(p);` : ''}`
  const values = await pipelines.run(
    target,
    {
      code: compiled.map(code).join('\n'),
      declarations: [
        isOriginal ? sharedDeclarations + cases.map(({ glsl }) => glsl).join('\n') : '',
        ...new Set(compiled.map(({ warp }) => warp.declarations)),
      ].join('\n'),
      inputs,
      outputs,
    },
    points,
  )
  return new Map(
    outputs.map(({ name }, i) => [
      name,
      values.map((numbers) => [...numbers.subarray(3 * i, 3 * i + 3)]),
    ]),
  )
}

/** Returns `undefined` if the function needs bit operations, which glsl100 lacks. */
function compileIfSupported(glsl, seed, target) {
  try {
    return compileWarp(glslOffset(sharedDeclarations + glsl), {
      target,
      normals: false,
      names: { position: 'p' },
      outputs: { offset: `ours${seed}`, position: `moved${seed}` },
    })
  } catch (error) {
    if (target === 'glsl100' && /glsl100 has no/.test(error.message)) return undefined
    throw error
  }
}

test('random functions equal the original, in each language', async () => {
  const count = isRun('every random expression') ? 2000 : 400
  const problems = []
  const compared = Object.fromEntries(targetsInThisRun.map((target) => [target, 0]))
  for (let first = 1; first <= count && problems.length < 5; first += batchSize) {
    const cases = Array.from({ length: batchSize }, (_, i) => randomFunction(first + i))
    const originals = await runRandom(cases, 'glsl300')
    for (const target of targetsInThisRun) {
      const values = target === 'glsl300' ? originals : await runRandom(cases, target)
      for (const { seed, glsl } of cases) {
        const ours = values.get(`ours${seed}`)
        if (!ours) continue
        const wrong = countDiffering(ours, originals.get(`original${seed}`))
        compared[target]++
        // Some points may be on the edge between two branches.
        if (wrong > 6)
          problems.push(`${seed} in ${target}: ${wrong} of ${3 * points.length}\n${glsl}`)
      }
    }
  }
  assert.equal(problems.length, 0, problems.join('\n').slice(0, 4000))
  for (const [target, times] of Object.entries(compared))
    assert.ok(
      times >= (target === 'glsl100' ? count / 5 : count),
      `${target}: ${times} of ${count}`,
    )
})

test('differentiate makes a function that returns the value and the gradient of a field, in each language', async () => {
  const field = `float blend(float a, float b, float k) {
      float h = clamp(0.5 + 0.5 * (b - a) / k, 0.0, 1.0);
      return mix(b, a, h) - k * h * (1.0 - h);
    }
    float map(vec3 p) {
      float d = length(p) - 0.5;
      for (int i = 0; i < 3; i++) d = blend(d, length(p - 0.4 * vec3(i, 1 - i, 0.3)) - 0.2, 0.3);
      return d;
    }`
  // The same computation by hand, in double.
  const map = (p) => {
    let d = Math.hypot(...p) - 0.5
    for (let i = 0; i < 3; i++) {
      const b = Math.hypot(p[0] - 0.4 * i, p[1] - 0.4 * (1 - i), p[2] - 0.12) - 0.2
      const h = Math.min(Math.max(0.5 + (0.5 * (b - d)) / 0.3, 0), 1)
      d = b + (d - b) * h - 0.3 * h * (1 - h)
    }
    return d
  }
  const slope = (p, k) => {
    const at = (step) => map(p.map((x, i) => (i === k ? x + step : x)))
    return (at(1e-5) - at(-1e-5)) / 2e-5
  }
  const expected = points.map((p) => [map(p), ...[0, 1, 2].map((k) => slope(p, k))])
  for (const target of targetsInThisRun) {
    const text = differentiate(field, { by: 'p', target })
    const values = await pipelines.run(
      target,
      {
        code: target === 'wgsl' ? 'let ours = mapGradient(p);' : 'vec4 ours = mapGradient(p);',
        declarations: text,
        inputs,
        outputs: [{ name: 'ours', shape: 4 }],
      },
      points,
    )
    // A point may be at the start of a blend.
    assert.ok(countDiffering(values, expected) <= 2, target)
  }
})

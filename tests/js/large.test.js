// What a sketch may have thousands of takes time in proportion to how many there are.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compile, compileWarp } from '../../dist/warpjet.js'

/** The processor's time, which other programs disturb little; the shorter of two runs. */
function timeOf(work, count) {
  const times = [0, 1].map(() => {
    const start = process.cpuUsage()
    work(count)
    const { user, system } = process.cpuUsage(start)
    return user + system
  })
  return Math.min(...times)
}

const few = 1500
const many = 12000

/**
 * Eight times as many take eight times as long; where each is looked for among all, sixty-four times, each time that one
 * looks. A garbage collection or the engine's compiler may lengthen a run: then it is run again.
 */
function isLinear(work) {
  let ratio
  for (let attempt = 0; attempt < 5; attempt++) {
    ratio = timeOf(work, many) / timeOf(work, few)
    if (ratio < 24) return
  }
  assert.fail(`eight times as many take ${ratio.toFixed(1)} times as long`)
}

const sumOf = (glsl, count, operand) => {
  let sum = glsl.param('first')
  for (let i = 0; i < count; i++) sum = sum.add(operand(i)).sin()
  return sum
}
const compileSum = (operand) => (count) =>
  compile((glsl) => ({ y: sumOf(glsl, count, (i) => operand(glsl, i)) }))

test('parameters', () => isLinear(compileSum((glsl, i) => glsl.param(`p${i}`))))

test('parameters named like temporaries', () =>
  isLinear(compileSum((glsl, i) => glsl.param(`t${i}`))))

test('results', () =>
  isLinear((count) =>
    compile((glsl) => {
      const x = glsl.param('x')
      return Object.fromEntries(Array.from({ length: count }, (_, i) => [`r${i}`, x.add(i).sin()]))
    }),
  ))

test('functions', () => {
  const source = (i) => `float f${i}(float x) { return x; }`
  isLinear(compileSum((glsl, i) => glsl.fn({ name: `f${i}`, arity: 1, source: source(i) })(i)))
})

test('derivatives by parameters', () => {
  isLinear(
    compileSum((glsl, i) => {
      const p = glsl.param(`p${i}`)
      return glsl.derivative(p.sin().mult(p), p)
    }),
  )
})

test('the option uniforms, also on the CPU', () => {
  const offset = (count) => (inputs) =>
    inputs.glsl.vec3(
      0,
      0,
      sumOf(inputs.glsl, count, (i) => inputs.uniforms[`u${i}`]),
    )
  const uniforms = (count) =>
    Object.fromEntries(Array.from({ length: count }, (_, i) => [`u${i}`, i / count]))
  const make = (count) => compileWarp(offset(count), { uniforms: uniforms(count) })
  isLinear(make)
  const warps = new Map([few, many].map((count) => [count, make(count)]))
  isLinear((count) =>
    warps.get(count).evaluateAt([0, 0, 0], { uniforms: { ...uniforms(count), first: 0 } }),
  )
})

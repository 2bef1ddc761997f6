// glsl.fn rejects names that are reserved by a language, used by shaders, or used by warpjet.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { compile, targets } from '../../dist/warpjet.js'
import { functions } from '../operations/names.js'
import { throwsWarpError } from '../support/warp-errors.js'

const declare = (name, target) =>
  compile(
    (glsl) => {
      const source = { glsl: `float ${name}(float x) {}`, wgsl: `fn ${name}(x: f32) -> f32 {}` }
      return { height: glsl.fn({ name, arity: 1, source })(glsl.param('steepness')) }
    },
    { target },
  )

for (const target of targets) {
  test(`names of built-in functions of ${target} are rejected`, () => {
    assert.ok(functions[target].length > 40)
    for (const name of functions[target])
      throwsWarpError(
        () => declare(name, target),
        new RegExp(`^fn: "${name}" cannot name a function: .* (WGSL|GLSL)`),
      )
  })

  test(`main and names reserved for warpjet are rejected in ${target}`, () => {
    throwsWarpError(() => declare('main', target), /"main" cannot .* the entry point of a shader/)
    throwsWarpError(
      () => declare('warpjetHash', target),
      /such names are reserved for warpjet; rename it/,
    )
    assert.match(declare('bump', target).code, /height = bump\(steepness\)/)
  })

  test(`names of functions that warpjet generates cannot name results or variables in ${target}`, () => {
    const compileNamed = (result, variable) => () =>
      compile(
        (glsl) => ({ [result]: glsl.noise(glsl.vec2Param('place')).add(glsl.param(variable)) }),
        { target },
      )
    const { declarations } = compileNamed('height', 'shift')()
    const generatedNames = [...new Set(declarations.match(/\bwarpjet\w+(?=\()/g))]
    assert.ok(generatedNames.includes('warpjetHash'), generatedNames.join())
    for (const name of generatedNames) {
      throwsWarpError(
        compileNamed(name, 'shift'),
        /cannot name a result|has the name of a variable or function/,
      )
      throwsWarpError(
        compileNamed('height', name),
        /cannot be read in a shader|is both a variable and a function/,
      )
    }
  })
}

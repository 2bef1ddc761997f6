// Helpers that the tests of operators share: functions of p5, and translation in a page and by the plugin.
import assert from 'node:assert/strict'
import { translateModule } from '../../dist/operators-plugin.js'
import * as runtime from '../../dist/operators-runtime.js'
import { operators } from '../../dist/operators.js'
import { compileWarp } from '../../dist/warpjet.js'

/** p5's functions in global mode, which work only on numbers. */
export const p5Functions = {
  sin: Math.sin,
  cos: Math.cos,
  max: Math.max,
  min: Math.min,
  abs: Math.abs,
  map: () => NaN,
  round: Math.round,
  noise: () => NaN,
  dist: () => NaN,
  createVector: (x = 0, y = 0, z = 0) => ({ x, y, z }),
  lerp: (a, b, t) => a + (b - a) * t,
}
// Bound functions have no source code, like p5's own.
for (const [name, known] of Object.entries(p5Functions)) globalThis[name] = known.bind(null)

/** Translates a module with the plugin, and runs it. */
export function runTranslated(code, names = {}) {
  const translated = translateModule(code) ?? code
  const [last, all, one] =
    /\nimport \{ (?:operators as (\w+), )?withOperators as (\w+) \} from .*\n$/.exec(translated)
  const imports = `const ${one} = runtime.withOperators${all ? `, ${all} = runtime.operators` : ''}; `
  const body = imports + translated.replace(last, '')
  assert.equal(translated.split('\n').length - 2, code.split('\n').length, 'lines')
  const out = []
  new Function('runtime', 'createWarp', 'out', ...Object.keys(names), body)(
    runtime,
    (offset) => compileWarp(offset).code,
    out,
    ...Object.values(names),
  )
  return out.length > 1 ? out : out[0]
}

export const uniforms = { amount: 0.5 }

/** Compiles a function twice: translated in a page, and by the plugin. */
export function compileBoth(written) {
  const offset = (0, eval)(`(${written})`)
  const options = written.includes('uniforms') ? { uniforms } : {}
  const inPage = compileWarp(operators(offset), options).code
  const [, text] = /^createWarp\(\w+\((.*)\)\)\nimport .*\n$/s.exec(
    translateModule(`createWarp(${written})`),
  ) ?? [, undefined]
  const byBuild = text
    ? compileWarp(runtime.withOperators(new Function(`return ${text}`)()), options).code
    : inPage
  return [inPage, byBuild]
}

export const callOffset = (offset, options = {}) =>
  compileWarp(operators(offset), /uniforms/.test(offset) ? { uniforms, ...options } : options).code

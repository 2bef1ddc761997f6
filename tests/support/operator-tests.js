// Helpers for tests of operators: functions like p5's, and translation in a page and by the bundler plugin.
import assert from 'node:assert/strict'
import { translateModule } from '../../dist/operators-plugin.js'
import * as runtime from '../../dist/operators-runtime.js'
import { operators } from '../../dist/operators.js'
import { compileWarp } from '../../dist/warpjet.js'

/** Functions with the names of p5's in global mode. Like those, they work only on numbers. */
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
for (const [name, f] of Object.entries(p5Functions)) globalThis[name] = f.bind(null)

/** Translates a module with the plugin, and runs it. Returns the value or values that it pushes to `out`. */
export function runTranslated(code, names = {}) {
  const translated = translateModule(code) ?? code
  const [importLine, operatorsName, withOperatorsName] =
    /\nimport \{ (?:operators as (\w+), )?withOperators as (\w+) \} from .*\n$/.exec(translated)
  const imports = `const ${withOperatorsName} = runtime.withOperators${operatorsName ? `, ${operatorsName} = runtime.operators` : ''}; `
  const body = imports + translated.replace(importLine, '')
  assert.equal(translated.split('\n').length - 2, code.split('\n').length, 'the number of lines')
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

/**
 * Compiles the source of an offset function. Returns the code after a translation in the page, and after a translation by the plugin. Both
 * are the same if the plugin translates nothing.
 */
export function compileBoth(source) {
  const offset = (0, eval)(`(${source})`)
  const options = source.includes('uniforms') ? { uniforms } : {}
  const inPage = compileWarp(operators(offset), options).code
  const [, translated] = /^createWarp\(\w+\((.*)\)\)\nimport .*\n$/s.exec(
    translateModule(`createWarp(${source})`),
  ) ?? [, undefined]
  const byPlugin = translated
    ? compileWarp(runtime.withOperators(new Function(`return ${translated}`)()), options).code
    : inPage
  return [inPage, byPlugin]
}

/** Compiles an offset function that is translated in the page. */
export const callOffset = (offset, options = {}) =>
  compileWarp(operators(offset), /uniforms/.test(offset) ? { uniforms, ...options } : options).code

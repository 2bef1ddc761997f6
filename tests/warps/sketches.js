// The warps of the gallery, extracted from its sketches: each runs with a mock of p5, which only records.
import { readFileSync, readdirSync } from 'node:fs'
import * as deformers from '../../dist/deformers.js'
import * as shaderText from '../../dist/glsl.js'
import * as warpjet from '../../dist/warpjet.js'

const examples = new URL('../../examples/', import.meta.url)

/** A mock for everything that a sketch draws and loads: it can be called, read and written without end. */
const pretended = new Proxy(() => {}, {
  get: (_, key) => (key === 'then' || key === Symbol.toPrimitive ? undefined : pretended),
  set: () => true,
  apply: () => pretended,
  construct: () => pretended,
})

const numbers = { PI: Math.PI, TWO_PI: 2 * Math.PI, HALF_PI: Math.PI / 2 }

/**
 * All warps and GLSL sources of the sketches, in order → [{ name, warp, options }] and [{ name, text }]. The name is the sketch's
 * folder, followed by the variable if there are several; `options` are those of createWarp.
 */
export async function sketchWarps() {
  // Sketches of three.js are modules, for which p5 cannot be mocked; web/tests/gallery.browser.test.js draws them.
  const folders = readdirSync(examples)
    .filter((folder) => !folder.startsWith('three-'))
    .sort()
  const warps = await Promise.all(folders.map(warpsOf))
  return warps.flat()
}

async function warpsOf(folder) {
  const source = readFileSync(new URL(`${folder}/sketch.js`, examples), 'utf8')
  const variables = [...source.matchAll(/(\w+) = (?:createWarp|warpjet\.gen)\(/g)].map(
    (match) => match[1],
  )
  const warps = []
  const name = () =>
    variables.length > 1 ? `${folder}-${variables[warps.length].toLowerCase()}` : folder
  let loads = false
  const known = {
    ...numbers,
    loadStrings(file) {
      loads = true
      return readFileSync(new URL(`${folder}/${file}`, examples), 'utf8').split('\n')
    },
    createWarp(warp, options = {}) {
      // Source that the sketch loads has no oracle here; the tests in tests/glsl cover source of packages.
      if (loads) return pretended
      // The warp does not depend on the shader that it is added to, nor on where normals are computed.
      const { shader, normals, detail, ...others } = options
      const isKnown = (shader || normals || detail) && warps.some((each) => each.warp === warp)
      if (!isKnown) warps.push({ name: name(), warp, options: others })
      return pretended
    },
    warpjet: {
      ...warpjet,
      ...deformers,
      ...shaderText,
      gen(...args) {
        const text = warpjet.gen(...args)
        warps.push({ name: name(), text })
        return text
      },
    },
  }
  const surroundings = new Proxy(known, {
    has: () => true,
    get: (_, key) =>
      key === Symbol.unscopables
        ? undefined
        : (known[key] ?? Math[key] ?? globalThis[key] ?? pretended),
  })
  await new Function('surroundings', `with (surroundings) { ${source}; return setup() }`)(
    surroundings,
  )
  return warps
}

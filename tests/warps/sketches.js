// Extracts the warps of the gallery from its sketches: runs each with a mock of p5, which only records the warps.
import { readFileSync, readdirSync } from 'node:fs'
import * as deformers from '../../dist/deformers.js'
import * as shaderText from '../../dist/glsl.js'
import * as warpjet from '../../dist/warpjet.js'

const examples = new URL('../../examples/', import.meta.url)

/** A mock for everything that a sketch draws and loads: it can be called, read and written without end. */
const mock = new Proxy(() => {}, {
  get: (_, key) => (key === 'then' || key === Symbol.toPrimitive ? undefined : mock),
  set: () => true,
  apply: () => mock,
  construct: () => mock,
})

const numbers = { PI: Math.PI, TWO_PI: 2 * Math.PI, HALF_PI: Math.PI / 2 }

/**
 * Returns all warps, { name, warp, options }, and GLSL sources, { name, text }, of the sketches, in order. The name is the sketch's folder,
 * followed by the variable if there are several; `options` are those of createWarp.
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
  let hasLoaded = false
  const globals = {
    ...numbers,
    loadStrings(file) {
      hasLoaded = true
      return readFileSync(new URL(`${folder}/${file}`, examples), 'utf8').split('\n')
    },
    createWarp(warp, options = {}) {
      // Source that the sketch loads has no oracle here; the tests in tests/glsl cover source of packages.
      if (hasLoaded) return mock
      // A warp does not depend on the shader to which it is added, nor on where its normals are computed, nor on detail.
      const { shader, normals, detail, ...others } = options
      const isRecorded =
        (shader || normals || detail) && warps.some((recorded) => recorded.warp === warp)
      if (!isRecorded) warps.push({ name: name(), warp, options: others })
      return mock
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
  const scope = new Proxy(globals, {
    has: () => true,
    get: (_, key) =>
      key === Symbol.unscopables
        ? undefined
        : (globals[key] ?? Math[key] ?? globalThis[key] ?? mock),
  })
  await new Function('scope', `with (scope) { ${source}; return setup() }`)(scope)
  return warps
}

/** Measures a row: every method on the same mesh and offset, in turns, so that what drifts meets all of them alike. */
import { measureErrors } from './accuracy.js'
import { openClock } from './clock.js'
import { watchMemory } from './memory.js'
import { generate, methods } from './methods.js'
import { fragmentShader, newNumber, vertexShader } from './shaders.js'
import { middle, ratio, shuffled, summary } from './statistics.js'

/** Milliseconds from source text to the first finished frame, and the program. */
function compileAndDraw(scene, { method, parts, h }) {
  const unique = newNumber()
  const vertex = vertexShader(parts, unique)
  const fragment = fragmentShader(method.flat, unique)
  scene.finish()
  const start = performance.now()
  const program = scene.program(vertex, fragment)
  scene.draw(program, { millis: 0, h })
  scene.finish()
  return { program, time: performance.now() - start }
}

/** Of what a method writes, without the shader around it, which all share. */
const charactersOf = ({ parts: { declarations = '', body } }) => declarations.length + body.length

async function trustedClock(scene, cell) {
  const { program } = compileAndDraw(scene, cell)
  const clock = await openClock(scene, () => scene.draw(program, { millis: 0, h: cell.h }))
  scene.gl.deleteProgram(program)
  return clock
}

/** Of generating the warp, in milliseconds, once it has been done before. */
function generationTime(workload, options, runs) {
  generate(workload, options)
  return middle(Array.from({ length: runs }, () => generate(workload, options).generation))
}

const breath = () => new Promise((later) => setTimeout(later))

/**
 * @param settings { rounds, frames, turn?, runs, samples, millis }: rounds of a row; frames of a method in a round, and
 * milliseconds after which it begins no further one; runs of the generator; vertices that are compared; the time of the
 * normals; names of methods
 * @param progress called with a short text
 * @returns { clock, vertices, triangles, memory: { heap, wasm }, results }, where `results` has for each method
 * { method, frame, toPositions, toWarpjet, first, firstToPositions, firstToByHand, characters, charactersToByHand, generation,
 * error: { largest, median, h } }, of which `characters` are those of the method's own text. Times are
 * milliseconds, { median, low, high } with half of the values from low to high; `first` is from source text to the first
 * finished frame; ratios are taken within a round; errors are degrees; `generation` is null where nothing is generated.
 */
export async function measureRow(scene, workload, settings, progress = () => {}) {
  const memory = watchMemory()
  progress('mesh')
  const mesh = workload.mesh()
  scene.load(mesh)

  progress('normals')
  const errors = measureErrors(scene, workload, mesh, settings.millis, settings.samples)
  memory.look()
  const cells = methods.map((method) => {
    const { h } = errors.get(method.name)
    return { method, parts: method.program(workload), h, firsts: [], frames: [], medians: [] }
  })
  const withNormals = generationTime(workload, {}, settings.runs)
  const positionsAlone = generationTime(workload, { normals: false }, settings.runs)
  memory.look()

  const clock = await trustedClock(scene, cells.at(-1))
  for (let round = 0; round < settings.rounds; round++) {
    progress(`round ${round + 1} of ${settings.rounds}`)
    // The same text compiled again can be 7% faster or slower, so each round has programs of its own.
    for (const cell of shuffled(cells)) {
      const { program, time } = compileAndDraw(scene, cell)
      const times = []
      const end = performance.now() + (settings.turn ?? Infinity)
      for (let i = 0; i < 1 || (i < settings.frames && performance.now() < end); i++) {
        const uniforms = { millis: settings.millis, h: cell.h }
        times.push(await clock.time(() => scene.draw(program, uniforms)))
      }
      scene.gl.deleteProgram(program)
      cell.firsts.push(time)
      cell.frames.push(...times)
      cell.medians.push(middle(times))
      await breath()
    }
    memory.look()
  }

  const cellOf = (name) => cells.find(({ method }) => method.name === name)
  const positions = cellOf('positions only')
  const warpjet = cellOf('warpjet')
  const byHand = cellOf('by hand')
  return {
    clock: clock.kind,
    vertices: mesh.positions.length / 3,
    triangles: mesh.indices.length / 3,
    memory: memory.peaks(),
    results: cells.map((cell) => ({
      method: cell.method.name,
      frame: summary(cell.frames),
      toPositions: ratio(cell.medians, positions?.medians),
      toWarpjet: ratio(cell.medians, warpjet?.medians),
      first: summary(cell.firsts),
      firstToPositions: ratio(cell.firsts, positions?.firsts),
      firstToByHand: ratio(cell.firsts, byHand?.firsts),
      characters: charactersOf(cell),
      charactersToByHand: byHand && charactersOf(cell) / charactersOf(byHand),
      generation: generationOf(cell),
      error: errors.get(cell.method.name),
    })),
  }

  function generationOf({ method, parts }) {
    if (parts.generation === undefined) return null
    return method.name === 'warpjet' ? withNormals : positionsAlone
  }
}

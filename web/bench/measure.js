/** Measures a row: every method on the same mesh and offset, interleaved, so that drift affects all of them equally. */
import { measureErrors } from './accuracy.js'
import { openClock } from './clock.js'
import { watchMemory } from './memory.js'
import { generate, methods } from './methods.js'
import { fragmentShader, nextNumber, vertexShader } from './shaders.js'
import { medianRatio, quantile, shuffle, summarize } from './statistics.js'

/** Returns the program and the milliseconds from its source to the first finished frame. */
function compileAndDraw(scene, { method, parts, h }) {
  const unique = nextNumber()
  const vertex = vertexShader(parts, unique)
  const fragment = fragmentShader(method.flat, unique)
  scene.finish()
  const start = performance.now()
  const program = scene.program(vertex, fragment)
  scene.draw(program, { millis: 0, h })
  scene.finish()
  return { program, time: performance.now() - start }
}

/** Counts the characters of a method's source, without the surrounding shader, which all methods share. */
const countCharacters = ({ parts: { declarations = '', body } }) =>
  declarations.length + body.length

async function chooseClock(scene, cell) {
  const { program } = compileAndDraw(scene, cell)
  const clock = await openClock(scene, () => scene.draw(program, { millis: 0, h: cell.h }))
  scene.gl.deleteProgram(program)
  return clock
}

/** Returns the median time in milliseconds to generate the warp, after a warm-up run. */
function timeGeneration(workload, options, runs) {
  generate(workload, options)
  return quantile(Array.from({ length: runs }, () => generate(workload, options).generation))
}

const yieldToPage = () => new Promise((later) => setTimeout(later))

/**
 * @param settings { rounds, frames, turn?, runs, samples, millis }: the number of rounds; max frames per method and round; max milliseconds
 * per method and round (default: no limit); runs of the generator; max number of compared vertices; the time at which the warp is compared
 * and drawn
 * @param progress called with a short message
 * @returns { clock, vertices, triangles, memory: { heap, wasm }, results }. `results` has per method { method, frame, toPositions,
 * toWarpjet, first, firstToPositions, firstToByHand, characters, charactersToByHand, generation, error: { largest, median, h } }.
 * `characters` counts the method's own source. `frame` and `first` are times in milliseconds, { median, low, high }, where half of the
 * values are between `low` and `high`; `first` is the time from source to the first finished frame; ratios are taken within a round; errors
 * are degrees; `generation`, in milliseconds, is null if nothing is generated.
 */
export async function measureRow(scene, workload, settings, progress = () => {}) {
  const memory = watchMemory()
  progress('mesh')
  const mesh = workload.mesh()
  scene.load(mesh)

  progress('normals')
  const errors = measureErrors(scene, workload, mesh, settings.millis, settings.samples)
  memory.record()
  const cells = methods.map((method) => {
    const { h } = errors.get(method.name)
    return { method, parts: method.program(workload), h, firsts: [], frames: [], medians: [] }
  })
  const withNormals = timeGeneration(workload, {}, settings.runs)
  const withoutNormals = timeGeneration(workload, { normals: false }, settings.runs)
  memory.record()

  const clock = await chooseClock(scene, cells.at(-1))
  for (let round = 0; round < settings.rounds; round++) {
    progress(`round ${round + 1} of ${settings.rounds}`)
    // Each round compiles new programs, because recompiling the same source can change the frame time by 7%.
    for (const cell of shuffle(cells)) {
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
      cell.medians.push(quantile(times))
      await yieldToPage()
    }
    memory.record()
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
      frame: summarize(cell.frames),
      toPositions: medianRatio(cell.medians, positions?.medians),
      toWarpjet: medianRatio(cell.medians, warpjet?.medians),
      first: summarize(cell.firsts),
      firstToPositions: medianRatio(cell.firsts, positions?.firsts),
      firstToByHand: medianRatio(cell.firsts, byHand?.firsts),
      characters: countCharacters(cell),
      charactersToByHand: byHand && countCharacters(cell) / countCharacters(byHand),
      generation: medianGeneration(cell),
      error: errors.get(cell.method.name),
    })),
  }

  function medianGeneration({ method, parts }) {
    if (parts.generation === undefined) return null
    return method.name === 'warpjet' ? withNormals : withoutNormals
  }
}

/**
 * Starts the compiler while the page waits for its renderer. The first `exactNormals` of a page takes five times as long as the second one:
 * browsers compile each function of WebAssembly and JavaScript when it is first called. We call most of them for small positions, in
 * steps, while the browser is idle, which it is until the GPU has answered `renderer.init()`.
 */
import { startCompiler } from '../../../compile/hosts.js'
import { startFrontEnd } from '../../../glsl-source/listing.js'
import { readOffset } from '../../../glsl-source/offset.js'
import { untilEnd } from '../../../options/iterations.js'
import { Place } from '../../../options/place.js'
import { functionFor } from '../function.js'
import { tsl, type AnyNode } from '../tsl.js'
import { settingsWith } from './exact-normals.js'
import { ExactWarp, offsetOf } from './exact-warp.js'
import { plainBuilder } from './plain-builder.js'
import { functionName, readPosition } from './read-position.js'

/** Yields positions, each of which needs a few functions more than the previous one: operations, a variable, a loop, hashes, noise. */
function* samplePositions(): Generator<AnyNode, void> {
  const {
    Fn,
    Loop,
    float,
    mx_cell_noise_float,
    mx_noise_float,
    positionLocal,
    sin,
    uniform,
    vec3,
  } = tsl
  const raise = (height: AnyNode) => positionLocal.add(vec3(0, height, 0))
  const sum = (term: (i: AnyNode) => AnyNode) => {
    const height = float(0).toVar()
    Loop(
      { type: 'float', start: float(1), end: uniform(2) as never },
      ({ i }: { i: AnyNode }) => void height.addAssign(term(i)),
    )
    return raise(sin(height))
  }
  yield positionLocal
  yield Fn(() => raise(sin(positionLocal.x).toVar()))()
  yield Fn(() => sum((i) => positionLocal.x.mul(i)))()
  yield raise(mx_cell_noise_float(positionLocal.xz))
  yield Fn(() => sum((i) => mx_noise_float(positionLocal.xz.mul(i))))()
}

const samplesInWgsl = [
  `fn ${functionName}(position : vec3<f32>) -> vec3<f32> { return position; }`,
  `fn noise(at : vec2<f32>) -> f32 {
  var hash : u32 = u32(i32(floor(at.x)));
  hash = (hash << 7u) ^ (hash >> 3u);
  return select(at.x, -at.y, (hash & 1u) == 1u);
}
fn ${functionName}(position : vec3<f32>) -> vec3<f32> {
  var moved : vec3<f32> = position;
  for (var i : f32 = 1.0; i < 3.0; i += 1.0) { moved.y = moved.y + noise(moved.xz * i); }
  return moved;
}`,
]

/** Makes the warps of the samples, in short steps: each calls only a few functions that earlier steps have not called. */
function* warmUp(): Generator<void, void> {
  const method = 'exactNormals'
  startFrontEnd()
  yield
  startCompiler()
  yield
  for (const text of samplesInWgsl) {
    readOffset(new Place(method), 'wgsl', text, {
      function: functionName,
      returns: 'position',
      maxIterations: untilEnd,
    })
    yield
  }
  for (const position of samplePositions()) {
    const source = readPosition(method, plainBuilder(method), position)
    yield
    const settings = settingsWith('auto', untilEnd)
    offsetOf(source, settings)
    yield
    const warp = new ExactWarp(source, settings)
    yield
    functionFor(warp, 'normal', false)
    yield
    functionFor(warp, 'normal of pixel', true)
    yield
  }
}

type Schedule = (work: () => void) => void

/** Safari has no `requestIdleCallback`. Node, where modules are imported to render pages on a server, has no document. */
const { requestIdleCallback, document } = globalThis as {
  requestIdleCallback?: Schedule
  document?: unknown
}
const schedule: Schedule | undefined = document
  ? (requestIdleCallback?.bind(globalThis) ?? ((work) => setTimeout(work, 50)))
  : undefined

let steps: Generator<void, void> | undefined

/** Warms up as soon as the page is idle. */
export function warmUpWhenIdle() {
  steps = warmUp()
  schedule?.(step)
}

/** Stops the warm-up: the first warp of the page has compiled everything. */
export function endWarmUp() {
  steps = undefined
}

function step() {
  try {
    if (steps && !steps.next().done) schedule!(step)
  } catch {
    // An error, such as that of a page that forbids WebAssembly, is reported where a warp is made.
  }
}

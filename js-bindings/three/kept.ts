// An offset function as three.js needs it: called once, then texts for its shaders, and the same warp on the CPU.
import { type FrameUniforms, frameOf } from '../compile/frame.js'
import {
  type KeptWarp,
  type WarpText,
  isOfFrame,
  keepWarp,
  readOptions,
  writeWarp,
} from '../compile/warp-text.js'
import { runOnCpu } from '../compile/compile-warp.js'
import type { Known, Target } from '../core/module/kept-module.js'
import { lazily } from '../core/module/lazily.js'
import { millisUniform, outputs } from '../compile/host-names.js'
import { WarpError } from '../errors/errors.js'
import { checkCallback } from '../options/options.js'
import type { CpuWarp } from '../cpu/cpu-warp.js'
import { withUniforms } from '../core/inputs/declared-uniforms.js'
import { drawInputs } from '../core/inputs/inputs.js'
import { imageShape } from '../core/expression/shapes.js'
import type { Declared } from '../core/module/result.js'
import type { OffsetFunction } from '../core/types/types.js'
import { remembered } from './remembered.js'
import type { Settings } from './settings.js'
import { type Uniform, onCpu, readUniforms } from './uniforms.js'
import { warpProgram } from '../cpu/warp-program.js'

/** What a text turns beside the position. */
export type Turned = 'position' | 'normal' | 'tangent'

export interface Text {
  code: string
  declarations: string
  attributes: Declared[]
  /** Which vec4s of the frame it reads. */
  frame: string[]
}

/** A warp for three.js, whatever it is put on. */
export interface ThreeWarp {
  settings: Settings
  uniforms: readonly Uniform[]
  handles: Record<string, { value: unknown }>
  /** In milliseconds. */
  millis: { value: number }
  /** Whether the turn depends on how normal and uv vary over the surface. */
  varies: boolean
  /** Which attributes decide where a vertex goes: position, normal, uv, color. */
  reads: ReadonlySet<string>
  write: (target: Target, turned: Turned, names: Record<string, string>) => Text
  cpu: CpuWarp
  /** The same, giving offsets in place of positions. */
  offsets: CpuWarp
  /** Whether the CPU can run it: not if it calls a `glsl.fn` or reads an image. */
  runs: boolean
  /** Whether it mirrors all of space, so that the outer side of a triangle is its back; `undefined` if uniforms decide that. */
  mirrors: boolean | undefined
  /** Whether it mirrors with the uniforms of this moment. */
  isMirrored: () => boolean
  /** The numbers that it depends on now. */
  numbers: () => number[]
  /** Those of the frame that the text reads, computed in double and within whole periods: see compile/frame.ts. */
  frame: () => FrameUniforms
  /** What `evaluate` and its companions take as `uniforms`. */
  given: () => { millis: number }
  /** The same for the same text. */
  key: () => string
}

export function keep(offset: OffsetFunction, settings: Settings): ThreeWarp {
  const { method } = settings
  checkCallback(method, offset)
  const { declared, uniforms, labels, handles } = readUniforms(method, settings.uniforms)
  const labelled = withUniforms(method, offset, declared, (name) => labels.get(name)!)
  const names = { millis: millisUniform }
  const warp = keepWarp(
    labelled,
    readOptions(method, offset, {
      target: 'glsl300',
      outputs,
      names,
      tangents: true,
      surfaceVariation: settings.surfaceVariation ?? true,
    }),
  )
  const positionText = writeFor(warp, 'position', 'glsl300')
  refuseOthers(method, writeFor(warp, 'tangent', 'glsl300'), uniforms)
  const millis = { value: 0 }
  const texts = new Map<string, Text>()
  const isRead = (name: string) => positionText.uniforms.some((uniform) => uniform.name === name)
  const numbers = () => [
    ...(isRead('millis') ? [millis.value] : []),
    ...uniforms.filter(({ label }) => isRead(label)).flatMap(({ numbers }) => numbers()),
  ]
  const known = knownTo(warp, uniforms)
  const computed = frameOf(warp, known)
  const byLabel = new Map(uniforms.map((uniform) => [uniform.label, uniform]))
  const frame = remembered(
    numbers,
    () => computed?.(({ name }) => byLabel.get(name)?.numbers() ?? [millis.value]) ?? {},
  )
  const declaredOnCpu = onCpu(uniforms)
  const silent = { ...warp, settings: { ...warp.settings, isAccepted: true } }
  const given = () => ({ millis: millis.value })
  const cpu = runOnCpu(silent, declaredOnCpu, 'position', undefined, known, frame)
  const offsets = runOnCpu(
    { ...silent, settings: { ...silent.settings, normals: false } },
    declaredOnCpu,
    'offset',
    undefined,
    known,
    frame,
  )
  return {
    settings,
    uniforms,
    handles,
    millis,
    varies: warp.varies,
    reads: new Set(positionText.attributes.map(({ name }) => name)),
    write: (target, turned, names) => {
      const key = JSON.stringify([target, turned, names])
      if (!texts.has(key)) texts.set(key, textOf(writeFor(warp, turned, target, names, known)))
      return texts.get(key)!
    },
    cpu,
    offsets,
    runs: cpu[warpProgram].program() !== undefined,
    mirrors: cpu[warpProgram].mirrors(),
    isMirrored: remembered(numbers, () => cpu[warpProgram].isMirrored(method, given())),
    numbers,
    frame,
    given,
    key: lazily(() => {
      const { code, declarations } = writeFor(warp, 'tangent', 'glsl300', {}, known)
      const types = uniforms.map(({ shape }) => shape.join('x'))
      return hash([settings.space, types, code, declarations].join('\n'))
    }),
  }
}

function writeFor(
  warp: KeptWarp,
  turned: Turned,
  target: Target,
  names: Record<string, string> = {},
  known?: Known,
) {
  const settings = {
    ...warp.settings,
    normals: turned !== 'position',
    tangents: turned === 'tangent',
  }
  return writeWarp({ ...warp, settings }, target, { names, known }).text
}

const textOf = ({ code, declarations, attributes, uniforms }: WarpText): Text => ({
  code,
  declarations,
  attributes,
  frame: uniforms.filter(isOfFrame).map(({ name }) => name),
})

/** What is the same for a whole frame: the time, and uniforms but images. */
function knownTo({ inputs }: KeptWarp, uniforms: readonly Uniform[]): Known {
  const labels = new Set(
    uniforms.filter(({ shape }) => shape !== imageShape).map(({ label }) => label),
  )
  return ({ name, number }) => number === inputs.millis || labels.has(name)
}

/** What the shaders of three.js do not have. */
function refuseOthers(
  method: string,
  text: { uniforms: Declared[] },
  uniforms: readonly Uniform[],
) {
  const known = new Set(uniforms.flatMap(({ label }) => [label, `${label}Size`]))
  for (const { name } of text.uniforms) {
    if (name === 'millis' || known.has(name)) continue
    if (name === 'instance')
      throw new WarpError(
        `${method}: the offset reads instance, which three.js does not have; place instances by their matrices, and warp in the space 'world', where each is at a place of its own.`,
      )
    throw new WarpError(
      name in drawInputs
        ? `${method}: the offset reads ${name}, which three.js does not have; declare it, as in { uniforms: { my${name[0]!.toUpperCase()}${name.slice(1)}: ${name === 'pixelDensity' ? 1 : '[0, 0]'} } }.`
        : `${method}: the offset reads "${name}" by glsl.param, which no shader of three.js declares; read it as uniforms.${name}, with the option { uniforms: { ${name}: … } }.`,
    )
  }
}

/** 64 bits, of two hashes that begin and multiply differently. */
function hash(text: string) {
  let [low, high] = [0x811c9dc5, 0x9747b28c]
  for (let i = 0; i < text.length; i++) {
    low = Math.imul(low ^ text.charCodeAt(i), 0x01000193)
    high = Math.imul(high ^ text.charCodeAt(i), 0x5bd1e995)
    high ^= high >>> 13
  }
  return `${(low >>> 0).toString(36)}${(high >>> 0).toString(36)}`
}

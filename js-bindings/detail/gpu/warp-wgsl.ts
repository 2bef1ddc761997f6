// A warp as a function in WGSL for compute passes, and the numbers that it reads.
import type { HostWarp } from '../../compile/host-warp.js'
import type { DrawValues } from '../../compile/offset-warp.js'
import { shaderNames } from '../../compile/shader-names.js'
import { drawInputs } from '../../core/inputs/inputs.js'

/** Numbers that shader code reads by a name. */
export interface NamedNumbers {
  readonly name: string
  readonly type: string
  readonly read: (given: DrawValues) => readonly number[]
}

/** Packs numbers into an array of vec4f, which shader code calls `warpjetInputs`. */
export class PackedNumbers {
  readonly array: Float32Array<ArrayBuffer>
  /** Statements that declare a variable for each name. */
  readonly code: string

  constructor(private readonly all: readonly NamedNumbers[]) {
    let count = 0
    const at = () => `warpjetInputs[${count >> 2}].${'xyzw'[count++ & 3]}`
    this.code = all
      .map(({ name, type }) => {
        const { wgsl, size } = types[type]!
        const numbers = Array.from({ length: size }, at)
        return `let ${name} = ${wgsl}(${numbers.join(', ')});`
      })
      .join('\n')
    this.array = new Float32Array(4 * Math.max(1, Math.ceil(count / 4)))
  }

  update(given: DrawValues) {
    let count = 0
    for (const { type, read } of this.all) {
      this.array.set(read(given), count)
      count += types[type]!.size
    }
  }
}

const types: Record<string, { readonly wgsl: string; readonly size: number }> = {
  float: { wgsl: 'f32', size: 1 },
  vec2: { wgsl: 'vec2f', size: 2 },
  vec3: { wgsl: 'vec3f', size: 3 },
  vec4: { wgsl: 'vec4f', size: 4 },
  mat2: { wgsl: 'mat2x2f', size: 4 },
  mat3: { wgsl: 'mat3x3f', size: 9 },
  mat4: { wgsl: 'mat4x4f', size: 16 },
}

/** Maps an input of a vertex → its name in WGSL. `warp.text` lists the inputs that it reads as `attributes` with these names. */
export const sampleNames = {
  position: 'samplePosition',
  normal: 'sampleNormal',
  uv: 'sampleUv',
  color: 'sampleColor',
}

const drawName = (name: string) => (name === 'millis' ? shaderNames.millis : `warpjetDraw_${name}`)

/** Writes the warp for samples: statements that compute `shaderNames.position`; `undefined` if it reads what samples lack. */
export function warpInWgsl(warp: HostWarp) {
  const names = {
    ...sampleNames,
    ...Object.fromEntries(Object.keys(drawInputs).map((name) => [name, drawName(name)])),
  }
  const { code, declarations, attributes, uniforms, frame, parameters } = warp.text(
    'wgsl',
    ['offset', 'position'],
    { names },
  )
  const uniformsByLabel = new Map(warp.uniforms.inShader.map((uniform) => [uniform.label, uniform]))
  const isKnown =
    attributes.every(({ name }) => name in sampleNames) &&
    parameters.every(({ name }) => uniformsByLabel.has(name) && !uniformsByLabel.get(name)!.image)
  if (!isKnown) return undefined
  const inFrame = new Set(frame)
  const numbers = uniforms.map(({ name, type }): NamedNumbers => {
    const read: NamedNumbers['read'] = inFrame.has(name)
      ? (given) => warp.frame(given)[name]!
      : uniformsByLabel.has(name)
        ? (given) => warp.uniformNumbers(name, given)
        : (given) => [given[name] as number | number[]].flat()
    return { name: name in drawInputs ? drawName(name) : name, type, read }
  })
  return { code, declarations, numbers, result: shaderNames.position }
}

// The shader code of `compileWarp`, and its frame constants.
import { checkUniforms, type Uniforms } from '../core/inputs/vertices.js'
import { targetKind, type Target } from '../core/module/serialized-module.js'
import { noteApproximation } from '../errors/notes.js'
import { Place } from '../options/place.js'
import type { NormalStage, NormalsOption } from './normals-option.js'
import type { OffsetWarp } from './offset-warp.js'
import type { Result } from './recorded-warp.js'
import { textOptions, type RecordOptions, type TextOptions } from './warp-options.js'
import type { HostText, WarpText } from './warp-text.js'

/** The methods of a compiled warp that write more code and compute frame constants. */
export interface Emits {
  /**
   * Writes the same warp in another language, or with other names. The offset function is not called again, so that it is the
   * same warp even if the function uses random numbers. Default: the names of the options of `compileWarp`.
   */
  emit(target: Target, options?: TextOptions): WarpText
  /**
   * Writes the statements for a fragment shader that compute the normal at a pixel, `vec3 warpedNormal`, and with `tangents: true`
   * `vec4 warpedTangent`. Their inputs are the position, normal, uv and color before the warp, and the gradients of
   * `surfaceVariation`, as the vertex shader passes them to pixels: in the space of the offset, interpolated, the normal with its
   * length restored. The statements compute only what the normal needs. Noise fades where a wave covers less than four pixels, unless the
   * option `fadeNoise` is `false` or the language is GLSL ES 1.00. Where the center of a pixel is outside of the mesh, numbers stay in the
   * domain of operations such as `sqrt`, except in GLSL ES 1.00. For these two purposes the code takes screen-space derivatives: insert
   * it outside of branches, and do not declare its varyings `centroid`. Use `highp` in GLSL ES 1.00. Default: the language and the
   * names of the options of `compileWarp`. Throws a `WarpError` for a warp with `normals: false`.
   */
  emitFragment(target?: Target, options?: TextOptions): WarpText
  /** The stage that computes normals: the option `normals`, with `'auto'` resolved for this warp. `false` if normals are left out. */
  readonly normals: NormalStage | false
  /**
   * With the option `perFrame`: returns values for the vec4s `warpjetFrame0`, … among `uniforms`, to be set each frame. `inputs` has
   * the values of the inputs that are constant during a frame, such as `{ millis: performance.now() }`, and values that replace those of
   * the option `uniforms`. Throws a `WarpError` for a missing or wrong value.
   */
  frameUniforms(inputs?: Uniforms): Record<string, number[]>
}

const emitPlace = new Place('emit')
const fragmentPlace = new Place('emitFragment')
const framePlace = new Place('frameUniforms')

function stageOf(warp: OffsetWarp, option: boolean | NormalsOption): NormalStage | false {
  if (option === false) return false
  return option === true ? 'vertex' : warp.stageOfNormals(option)
}

/** Throws if the warp reads the bits of an integer of the host, which GLSL 1.00 cannot do. A warp that is recorded for it reads none. */
function rejectHalves(place: Place, warp: OffsetWarp, target: Target) {
  const integer = target === 'glsl100' && warp.findHalvedInteger()
  if (!integer) return
  const { name, type } = integer
  const others = 'use glsl300 or wgsl'
  throw place.error(
    type.startsWith('u')
      ? `the variable "${name}" is a ${type}, which glsl100 lacks; ${others}.`
      : `the variable "${name}" is an ${type}, and this code reads its bits, which glsl100 cannot do; compile the warp with { target: 'glsl100' }, or ${others}.`,
  )
}

function publicText({ parameters: _, frame: __, ...text }: HostText): WarpText {
  return text
}

export function textsOf(warp: OffsetWarp, options: RecordOptions): WarpText & Emits {
  const { target } = options
  const normals = stageOf(warp, options.normals!)
  const normalResults: Result[] = ['normal', ...(options.tangents ? (['tangent'] as const) : [])]
  const results: Result[] = ['offset', 'position', ...(normals === 'vertex' ? normalResults : [])]
  const text = publicText(warp.text(target!, results))
  if (warp.isApproximate) noteApproximation('compileWarp', 'its option surfaceVariation')
  return {
    ...text,
    normals,
    emit(given, names) {
      const target = targetKind.read(given, emitPlace.part('the target'))
      rejectHalves(emitPlace, warp, target)
      return publicText(warp.text(target, results, textOptions.read(names, emitPlace)))
    },
    emitFragment(given = target!, names) {
      if (!normals)
        throw fragmentPlace.error(
          'the warp was compiled with "normals: false", which leaves normals out; compile it without this option.',
        )
      const target = targetKind.read(given, fragmentPlace.part('the target'))
      rejectHalves(fragmentPlace, warp, target)
      const options = textOptions.read(names, fragmentPlace)
      return publicText(warp.fragmentText(target, normalResults, options))
    },
    frameUniforms(given = {}) {
      checkUniforms(framePlace, given, warp.variableNames())
      const constants = Object.entries(warp.frame(given, framePlace))
      // Copies, which the caller may change.
      return Object.fromEntries(constants.map(([name, values]) => [name, [...values]]))
    },
  }
}

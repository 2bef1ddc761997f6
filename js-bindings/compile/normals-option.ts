// The option that says where normals are computed.
import { boolean, oneOf } from '../options/kinds.js'

/** Where normals are computed. */
export type NormalStage = 'vertex' | 'pixel'

export type NormalsOption = 'auto' | NormalStage

/** The kinds of the options of normals that all hosts have. */
export const normalsKinds = {
  normals: oneOf(['auto', 'vertex', 'pixel'], 'auto'),
  fadeNoise: boolean(true),
}

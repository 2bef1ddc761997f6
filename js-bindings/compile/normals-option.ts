// The option that says where normals are computed.
import { oneOf } from '../options/kinds.js'

/** Where normals are computed. */
export type NormalStage = 'vertex' | 'pixel'

/** The kind of the option `normals` of a host. */
export const normalsKind = oneOf(['auto', 'vertex', 'pixel'], 'auto')
export type NormalsOption = 'auto' | NormalStage

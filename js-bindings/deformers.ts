// 'warpjet/deformers': ready-made offset functions, and functions that combine several into one. Amounts, centres and axes may be
// numbers, expressions, or functions of the inputs of an offset function: `twist({ angle: ({ millis }) => … })`. Lengths are in the
// units of the warp's space, angles in radians.
export type {
  AxisName,
  AxisOption,
  NumberOption,
  OptionInputs,
  OrFunction,
  Triple,
  VectorOption,
} from './deformers/kinds.js'
export { bend, type BendOptions } from './deformers/bend.js'
export { bulge, type BulgeOptions } from './deformers/bulge.js'
export { genie, type GenieOptions } from './deformers/genie.js'
export { inflate, type InflateOptions } from './deformers/inflate.js'
export { melt, type MeltOptions } from './deformers/melt.js'
export { noiseDisplace, type NoiseDisplaceOptions } from './deformers/noise-displace.js'
export { ripple, type RippleOptions } from './deformers/ripple.js'
export { shear, type ShearOptions } from './deformers/shear.js'
export { spherify, type SpherifyOptions } from './deformers/spherify.js'
export { stretch, type StretchOptions } from './deformers/stretch.js'
export { taper, type TaperOptions } from './deformers/taper.js'
export { twist, type TwistOptions } from './deformers/twist.js'
export { wave, type WaveOptions } from './deformers/wave.js'

export { add } from './deformers/add.js'
export { blend } from './deformers/blend.js'
export { chain } from './deformers/chain.js'
export { inSpace, type MatrixOption } from './deformers/in-space.js'
export { mask } from './deformers/mask.js'

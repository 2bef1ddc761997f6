/**
 * The kinds of hooks in p5's shaders. A style has the names by which a warp reads a vertex, and the hooks that pass its results to p5:
 * `struct-hooks.ts` is for p5 2.x, `value-hooks.ts` for p5 1.11, `wgsl-hooks.ts` for p5 2.x on WebGPU. All our names in p5's shaders
 * start with warpjet, so that they cannot clash with names of the sketch.
 */
import type { Declared, HostText, Target } from '../../compile/hosts.js'
import type { Modifications, Shader } from '../host.js'
import type { WarpSpace, WarpType } from '../settings.js'
import type { HookOrder } from './merge-hooks.js'

/** A warp's code, and what a shader needs to contain it. */
export interface WarpCode {
  target: Target
  text: HostText
  /** Present if normals are computed at pixels. */
  pixel?: PixelCode | undefined
  space: WarpSpace
  /** The option `defs`: the sketch's source, to insert above the code. */
  defs: string
  /** When the sketch's own hooks run. */
  hooks: 'first' | 'last'
  /** Uniforms that the shader must declare. */
  uniforms: readonly Declared[]
}

/** The code of the fragment stage that computes the normal at a pixel; see pixel-code.ts. */
export interface PixelCode {
  text: HostText
  /** The inputs that the code reads, as varyings. */
  varyings: readonly Varying[]
  /** Uniforms that the fragment stage must declare. */
  uniforms: readonly Declared[]
}

export interface Varying {
  input: string
  name: string
  type: 'float' | 'vec2' | 'vec3' | 'vec4'
}

/** The material that a shader draws; `own` is a shader of the sketch. */
export type MaterialKind = WarpType | 'own'

export interface HookStyle {
  /** Returns when the sketch's hook runs, for a hook that the style has too. */
  orderOf(name: string, warpCode: WarpCode): HookOrder
  /** Returns whether the sketch's hook of this name runs after the warp, and may change its normals. */
  isAfterWarp(name: string, warpCode: Omit<WarpCode, 'pixel'>): boolean
  /** True if the sketch's hooks can also run after the warp. */
  canRunLast: boolean
  /** Maps inputs of the offset to expressions in the hooks. */
  names: Record<'position' | 'normal' | 'uv' | 'color' | 'instance', string>
  /** Returns the hooks for filled shapes, which run a warp's code and pass its `warpjetPosition` and `warpjetNormal` to p5. */
  hooksForFills(warpCode: WarpCode, type: MaterialKind, base: Shader): Modifications
  /** Makes changes that hooks cannot make. */
  finish?(shader: Shader, warpCode: WarpCode): void
  /**
   * Returns the hooks for lines, from `warpjetPosition` and `warpjetJacobian`, the Jacobian J of the offset: they move both ends of a line
   * and transform its incoming and outgoing tangents t to t + J t.
   */
  hooksForStrokes(warpCode: WarpCode, base: Shader): Modifications
  /** Returns the hooks for points, if points have a shader of their own. */
  hooksForPoints?(warpCode: WarpCode): Modifications
}

/** Returns the language of a renderer's shaders. */
export const targetOf = (renderer: { webglVersion?: string; GL?: unknown }): Target =>
  renderer.GL ? (renderer.webglVersion === 'webgl' ? 'glsl100' : 'glsl300') : 'wgsl'

export const readsInstance = ({ uniforms }: HostText) =>
  uniforms.some(({ name }) => name === 'instance')

/** Returns GLSL declarations to insert above the hooks: `more`, and those that the warp's code needs. */
export const glslDeclarations = (
  { text, defs, uniforms }: WarpCode,
  ...more: (string | false | undefined)[]
) =>
  [
    ...more,
    readsInstance(text) && '#define warpjetInstance float(gl_InstanceID)',
    ...uniforms.map(({ name, type }) => `uniform ${glslType(type)} ${name};`),
    defs,
    text.declarations,
  ]
    .filter(Boolean)
    .join('\n')

/** Returns the type with a precision where it needs one: samplers have low precision by default, which would clip heights. */
export const glslType = (type: Declared['type']) => (type === 'sampler2D' ? 'highp ' : '') + type

/**
 * What p5's shaders are like: each kind of hooks is a style, which says by what names a warp reads a vertex, and which hooks
 * put its results back. All of our names in p5's shaders start with warpjet, so that they meet none of the sketch's. `struct-hooks.ts` is p5 2.x, `value-hooks.ts` p5 1.11, `wgsl-hooks.ts` p5 2.x on WebGPU.
 */
import type { Declared, HostText, Target } from '../../compile/hosts.js'
import type { Turn } from './beside.js'
import type { Modifications, Shader } from '../host.js'
import type { WarpSpace, WarpType } from '../settings.js'

/** A warp's text, to be put into a shader. */
export interface Woven {
  text: HostText
  space: WarpSpace
  /** Text of the sketch for above it. */
  defs: string
  /** When hooks of the sketch's own run. */
  hooks: 'first' | 'last'
  /** What the shader is to declare. */
  uniforms: readonly Declared[]
}

/** What a shader draws; `own` is what the sketch's own shader makes of a surface. */
export type WovenType = WarpType | 'own'

export interface HookStyle {
  /** When a hook of the sketch's runs that the style has too. */
  turnOf(name: string, woven: Woven): Turn
  /** Whether the sketch's hooks can run after the warp. */
  isOrdered: boolean
  names: Record<'position' | 'normal' | 'uv' | 'color' | 'instance', string>
  /** The hooks that run a text and hand its `warpjetPosition` and `warpjetNormal` to p5. */
  fill(woven: Woven, type: WovenType, base: Shader): Modifications
  /** What is beyond hooks. */
  finish?(shader: Shader, woven: Woven): void
  /**
   * The same for lines, of `warpjetPosition` and `warpjetSlope`: each end of a line is moved, and the directions t in which lines
   * come and go are turned, to t + J t.
   */
  stroke(woven: Woven, base: Shader): Modifications
  /** For points, where they have a shader of their own. */
  point?(woven: Woven): Modifications
}

/** The language of a renderer's shaders. */
export const targetOf = (renderer: { webglVersion?: string; GL?: unknown }): Target =>
  renderer.GL ? (renderer.webglVersion === 'webgl' ? 'glsl100' : 'glsl300') : 'wgsl'

export const readsInstance = ({ uniforms }: HostText) =>
  uniforms.some(({ name }) => name === 'instance')

/** GLSL for above the hooks. */
export const glslDeclarations = ({ text, defs, uniforms }: Woven, ...own: (string | false)[]) =>
  [
    ...own,
    readsInstance(text) && '#define warpjetInstance float(gl_InstanceID)',
    ...uniforms.map(({ name, type }) => `uniform ${glslType(type)} ${name};`),
    defs,
    text.declarations,
  ]
    .filter(Boolean)
    .join('\n')

/** Images have low precision unless told otherwise, which cuts heights off. */
export const glslType = (type: Declared['type']) => (type === 'sampler2D' ? 'highp ' : '') + type

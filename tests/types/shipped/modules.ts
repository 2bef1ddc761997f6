// Checks which uses the shipped types allow and reject under every TypeScript from 5.4 on, without p5. Compiled only, never run.
import { type OffsetFunction, type Vec3, WarpError, compile, compileWarp, version } from 'warpjet'
import { type Op, gen } from 'warpjet/autodiff'
import { type TwistOptions, chain, twist } from 'warpjet/deformers'
import { type GlslOffset, differentiate, glslOffset } from 'warpjet/glsl'
import { type Mesh, bakeWarp, loadMesh, subdivide } from 'warpjet/mesh'
import { compileWarp as compileText } from 'warpjet/text'
import warpjet, { type Loading, type WarpModel, createWarp } from 'warpjet/p5'

const turn: TwistOptions = { axis: 'x', angle: ({ millis }) => millis.div(1000) }
const offset: OffsetFunction = chain(twist(turn), ({ position }): Vec3 => position.mult(2))
const warp = compileWarp(offset, { uniforms: { amount: 0.5 } })

export const text: string = warp.code + version
export const shader: string = gen((ad) => {
  const height: Op = ad.param('x').sin()
  height.output('height')
})
export const numbers = compile((glsl) => ({ y: glsl.mix(0, 1, glsl.param('x')) })).evaluate({
  x: 2,
})
export const distort = createWarp({}, ({ uniforms }) => uniforms.by, {
  uniforms: { by: [1, 2, 3] },
})
distort({ by: [3, 2, 1] })

export async function baked(): Promise<Mesh> {
  const mesh = await loadMesh(new Uint8Array(8))
  return bakeWarp(subdivide(mesh, { warp, tolerance: 0.1 }), warp, { uniforms: { millis: 3 } })
}

const waves: GlslOffset = glslOffset('vec3 offset(vec3 p) { return p; }', { maxIterations: 9 })
compileWarp(chain(waves, twist()))
compileText(waves, { target: 'glsl100' })
export const gradient: string = differentiate('float map(vec3 p) { return p.x; }', { by: 'p' })
// @ts-expect-error no such language
differentiate('', { target: 'hlsl' })

// Entries share one class and one type of vector.
export const isOurs = (error: unknown): error is WarpError => error instanceof WarpError
compileWarp(twist(), { target: 'wgsl' })
compileText(twist())

// Works without types of p5.
warpjet(class {})
export const model = (sketch: Loading): Promise<WarpModel> => sketch.loadWarpModel('bunny.glb')

// @ts-expect-error functions for the addon are not shipped
import { varyGeometry } from 'warpjet/mesh'
void varyGeometry

// Checks which uses the shipped types allow and reject under every TypeScript from 5.4 on, without p5. Compiled only, never run.
import { WarpError, compile, compileWarp, version, type OffsetFunction, type Vec3 } from 'warpjet'
import { gen, type Op } from 'warpjet/autodiff'
import { chain, twist, type TwistOptions } from 'warpjet/deformers'
import { createDetail, type DividedMesh } from 'warpjet/detail'
import { differentiate, glslOffset, type GlslOffset } from 'warpjet/glsl'
// @ts-expect-error varyGeometry, which only our addon uses, is not shipped
import { bakeWarp, loadMesh, subdivide, varyGeometry, type Mesh } from 'warpjet/mesh'
import warpjet, { createWarp, type Loading, type WarpModel } from 'warpjet/p5'
import { compileWarp as compileText } from 'warpjet/text'

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

export async function bake(): Promise<Mesh> {
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

// The addon can be used without p5's types.
warpjet(class {})
export const model = (sketch: Loading): Promise<WarpModel> => sketch.loadWarpModel('bunny.glb')

void varyGeometry

const divided: DividedMesh = createDetail({ positions: new Float32Array(9) }, warp)
const view = { matrix: new Float32Array(16), width: 640, height: 480, side: 'front' } as const
export const isChanged: boolean = divided.update([view], { uniforms: { amount: 1 }, tolerance: 2 })
// @ts-expect-error a view has a size
divided.update({ matrix: view.matrix })

// Checks which uses the types of 'warpjet/mesh' allow and reject. Compiled only, never run.
import { MeshoptDecoder } from 'meshoptimizer'
import {
  bakeNormalMap,
  bakeWarp,
  exportGLB,
  loadMesh,
  subdivide,
  surfaceVariation,
  type DracoDecoderModule,
  type Mesh,
  type NormalMapOptions,
  type Resolve,
} from '../../js-bindings/mesh.js'
import { compileWarp } from '../../js-bindings/warpjet.js'

const warp = compileWarp(({ position }) => position)
const resolve: Resolve = (uri) => (uri ? new Uint8Array(1) : undefined)

declare const draco: DracoDecoderModule

export async function use(file: File) {
  const mesh: Mesh = await loadMesh(file)
  await loadMesh('model.gltf', { resolve })
  await loadMesh('packed.glb', { decoders: { meshopt: MeshoptDecoder, draco: async () => draco } })
  // @ts-expect-error a number is no decoder
  await loadMesh('packed.glb', { decoders: { meshopt: 7 } })
  // @ts-expect-error no such decoder
  await loadMesh('packed.glb', { decoders: { basis: MeshoptDecoder } })
  await loadMesh(new URL('https://a.b/c.glb'), { resolve: async () => new ArrayBuffer(1) })
  const [first]: number[] = [...mesh.positions, ...(mesh.uvs ?? []), ...(mesh.indices ?? [])]
  const color: number[] | undefined = mesh.material?.baseColor
  const bytes: Uint8Array = exportGLB(
    bakeWarp(mesh, warp, { uniforms: { millis: 1200, wind: [1, 0] }, detail: 0.01 }),
  )
  const fine: Mesh = subdivide(mesh, { warp, tolerance: 0.01, uniforms: { millis: 0 }, angle: 0.1 })
  const mapped: Mesh = bakeNormalMap(mesh, warp)
  const options: NormalMapOptions = {
    size: 512,
    frames: 'mikktspace',
    uniforms: { millis: 1200 },
  }
  const map: Uint8Array | undefined = bakeNormalMap(mesh, warp, options).material?.normalTexture
    ?.bytes
  exportGLB({ ...mapped, material: { normalTexture: { bytes: map ?? new Uint8Array(1) } } })
  const finer: Mesh = subdivide(fine, { levels: 2, maxTriangles: 1e6 })
  exportGLB({ positions: [0, 0, 0], indices: new Uint16Array(3) })
  warp.evaluate(mesh)
  const variation = surfaceVariation(mesh)
  warp.evaluate({ ...mesh, ...variation })
  const gradients: Float32Array[] = [variation.normalXGradients, variation.normalZGradients]
  // @ts-expect-error a mesh may have no uvs
  gradients.push(variation.uGradients)

  // @ts-expect-error a number is no source
  await loadMesh(7)
  // @ts-expect-error a promise is no mesh
  exportGLB(loadMesh(file))
  // @ts-expect-error no warp
  bakeWarp(mesh, { millis: 1200 })
  // @ts-expect-error a uniform is a number or numbers
  bakeWarp(mesh, warp, { uniforms: { millis: '1200' } })
  // @ts-expect-error no warp
  bakeNormalMap(mesh, { size: 512 })
  // @ts-expect-error the size is a number
  bakeNormalMap(mesh, warp, { size: '512' })
  // @ts-expect-error no such option
  bakeNormalMap(mesh, warp, { width: 512 })
  // @ts-expect-error a tolerance or levels are required
  subdivide(mesh, { warp })
  // @ts-expect-error a mesh has positions
  exportGLB({ normals: [0, 0, 1] })
  return { first, color, bytes, finer }
}

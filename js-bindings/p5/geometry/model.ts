// For the p5 addon: files as what p5's `model()` draws, upright and of a size to be seen. Files have y upwards and linear colours, p5
// has y downwards and sRGB, so both are turned into p5's. It stands here, and not in the addon, because it is of use only with this
// module.
import { WarpError, describe } from '../../errors/errors.js'
import { checkOptions } from '../../options/options.js'
import type { Decoders } from '../../mesh/decoders.js'
import { readModel } from '../../mesh/load.js'
import type { Mesh, Picture } from '../../mesh/mesh-arrays.js'

export interface LoadModelOptions {
  /** Centered, and 200 units at its longest, as p5's `loadModel` does it; true unless given. */
  normalize?: boolean
  /** The file's y upwards on the canvas; true unless given. */
  flipY?: boolean
  /** For compressed glTF files, as `loadMesh` takes them. */
  decoders?: Decoders
}

export interface Vector {
  x: number
  y: number
  z: number
}

/** What is used of a p5.Geometry, and what is added to it. `ModelOf` has all of a p5.Geometry, where the types of p5 are known. */
export interface WarpModel {
  gid: string
  vertices: Vector[]
  vertexNormals: Vector[]
  /** Two numbers a vertex. */
  uvs: number[]
  /** Three vertices each. */
  faces: number[][]
  /** Four numbers a vertex, or none. They go before `fill`; `clearColors()` removes them. */
  vertexColors: number[]
  /** Lines between vertices, two each. */
  edges: number[][]
  normalize(): unknown
  /** The picture of the file's material, a p5.Image for p5's `texture`. */
  texture?: object
  /** What was left out of the file, in sentences. */
  warnings: string[]
}

interface Image {
  drawingContext: CanvasRenderingContext2D
}

/** What of p5 makes things. */
export interface Makers {
  Geometry: new (
    detailX?: number,
    detailY?: number,
    callback?: undefined,
    renderer?: object,
  ) => WarpModel
  Vector: new (x: number, y: number, z: number) => Vector
  Image: new (width: number, height: number) => Image
}

/**
 * Fills the model with what is in the file. For the p5 addon's `loadWarpModel`, not for users.
 * @internal
 */
export async function fillP5Model(
  model: WarpModel,
  p5: Makers,
  url: string | URL,
  options: LoadModelOptions = {},
): Promise<void> {
  if (!((typeof url === 'string' && url) || url instanceof URL))
    throw new WarpError(
      `loadWarpModel: the address of a model such as "bunny.glb" was expected, but ${describe(url)} came.`,
    )
  checkOptions('loadWarpModel', options, ['normalize', 'flipY', 'decoders'])
  const { normalize = true, flipY = true, decoders } = options
  const { mesh, painted } = await readModel(url, { decoders })
  putVertices(model, p5, mesh, flipY)
  model.vertexColors = colorsOf(mesh, painted)
  if (normalize) model.normalize()
  model.warnings.push(...(mesh.warnings ?? []))
  const picture = mesh.material?.baseColorTexture
  if (picture) await putTexture(model, p5, picture)
}

function putVertices(model: WarpModel, { Vector }: Makers, mesh: Mesh, flipY: boolean) {
  const { positions, normals, uvs, indices } = mesh
  const up = flipY ? -1 : 1
  const count = positions.length / 3
  const vectors = (numbers: Float32Array) =>
    Array.from(
      { length: count },
      (_, i) => new Vector(numbers[3 * i]!, up * numbers[3 * i + 1]!, numbers[3 * i + 2]!),
    )
  model.vertices = vectors(positions)
  model.vertexNormals = vectors(normals)
  model.uvs = uvs ? Array.from(uvs) : new Array(2 * count).fill(0)
  const corner = (i: number) => (indices ? indices[i]! : i)
  // A reflection turns triangles inside out.
  const [second, third] = flipY ? [2, 1] : [1, 2]
  model.faces = Array.from({ length: (indices?.length ?? count) / 3 }, (_, i) => [
    corner(3 * i),
    corner(3 * i + second),
    corner(3 * i + third),
  ])
}

/**
 * Vertex colours times the material's; empty if all are white, so that `fill` applies. If the materials of an .obj colour only
 * some vertices, the others get -1, which p5 draws in its fill colour, as with its own `loadModel`.
 */
function colorsOf({ positions, colors, material }: Mesh, painted: Uint8Array): number[] {
  const base = material?.baseColor ?? [1, 1, 1, 1]
  if (!colors && !painted.length && base.every((part) => part === 1)) return []
  return Array.from({ length: (positions.length / 3) * 4 }, (_, i) => {
    if (painted.length && !painted[i >> 2] && !isTinted(colors, i >> 2)) return -1
    const part = base[i % 4]! * (colors ? colors[i]! : 1)
    return i % 4 === 3 ? part : encode(part)
  })
}

/** Returns whether the vertex has a colour other than white. */
const isTinted = (colors: Float32Array | undefined, vertex: number) =>
  !!colors && [0, 1, 2].some((k) => colors[4 * vertex + k] !== 1)

/** Linear to sRGB (IEC 61966-2-1). */
const encode = (part: number) =>
  part <= 0.0031308 ? 12.92 * part : 1.055 * part ** (1 / 2.4) - 0.055

async function putTexture(model: WarpModel, { Image }: Makers, { bytes, mimeType }: Picture) {
  try {
    const bitmap = await createImageBitmap(new Blob([bytes as BlobPart], { type: mimeType }))
    const image = new Image(bitmap.width, bitmap.height)
    image.drawingContext.drawImage(bitmap, 0, 0)
    model.texture = image
  } catch {
    model.warnings.push('The picture of the material cannot be decoded, and is left out.')
  }
}

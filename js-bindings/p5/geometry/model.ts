// Converts model files to a p5.Geometry for p5's `model()`, upright and of visible size. Files have y upwards and linear colours, p5 has
// y downwards and sRGB. This code is part of the mesh module rather than the addon, since only the mesh module needs it.
import { describe } from '../../errors/errors.js'
import { decodersKind, type Decoders } from '../../mesh/decoders.js'
import { readModel } from '../../mesh/load.js'
import type { Mesh, Picture } from '../../mesh/mesh-arrays.js'
import { boolean } from '../../options/kinds.js'
import { Place } from '../../options/place.js'
import { object } from '../../options/schema.js'

export interface LoadModelOptions {
  /**
   * If true, the model is centered and scaled to 200 units along its longest side, as by p5's `loadModel`.
   * @default true
   */
  normalize?: boolean
  /**
   * If true, the file's y axis points upwards on the canvas.
   * @default true
   */
  flipY?: boolean
  /** Decoders of compressed glTF files, as for `loadMesh`. */
  decoders?: Decoders
}

export interface Vector {
  x: number
  y: number
  z: number
}

/** The members of a p5.Geometry that we use, and those that we add. With p5's types, `ModelOf` has all members of a p5.Geometry. */
export interface WarpModel {
  gid: string
  vertices: Vector[]
  vertexNormals: Vector[]
  /** 2 numbers per vertex. */
  uvs: number[]
  /** Triangles: 3 vertices each. */
  faces: number[][]
  /** 4 numbers per vertex, or empty. They override `fill`; `clearColors()` removes them. */
  vertexColors: number[]
  /** Lines: 2 vertices each. */
  edges: number[][]
  normalize(): unknown
  /** The base color texture of the file's material: a p5.Image for p5's `texture`. */
  texture?: object
  /** Messages about parts of the file that were left out. */
  warnings: string[]
}

interface Image {
  drawingContext: CanvasRenderingContext2D
}

/** The p5 constructors that we need. */
export interface P5Constructors {
  Geometry: new (
    detailX?: number,
    detailY?: number,
    callback?: undefined,
    renderer?: object,
  ) => WarpModel
  Vector: new (x: number, y: number, z: number) => Vector
  Image: new (width: number, height: number) => Image
}

const place = new Place('loadWarpModel')
const modelOptions = object({
  normalize: boolean(true),
  flipY: boolean(true),
  decoders: decodersKind,
} satisfies Record<keyof LoadModelOptions, unknown>)

/**
 * Reads a file into the model. For the p5 addon's `loadWarpModel`, not for users.
 * @internal
 */
export async function fillP5Model(
  model: WarpModel,
  p5: P5Constructors,
  url: string | URL,
  options?: LoadModelOptions,
): Promise<void> {
  if (!((typeof url === 'string' && url) || url instanceof URL))
    throw place.expected('the address of a model such as "bunny.glb"', describe(url))
  const { normalize, flipY, decoders } = modelOptions.read(options, place)
  const { mesh, painted } = await readModel(url, { decoders: decoders as Decoders })
  putVertices(model, p5, mesh, flipY)
  model.vertexColors = colorsOf(mesh, painted)
  if (normalize) model.normalize()
  model.warnings.push(...(mesh.warnings ?? []))
  const picture = mesh.material?.baseColorTexture
  if (picture) await putTexture(model, p5, picture)
}

function putVertices(model: WarpModel, { Vector }: P5Constructors, mesh: Mesh, flipY: boolean) {
  const { positions, normals, uvs, indices } = mesh
  const ySign = flipY ? -1 : 1
  const count = positions.length / 3
  const vectors = (numbers: Float32Array) =>
    Array.from(
      { length: count },
      (_, i) => new Vector(numbers[3 * i]!, ySign * numbers[3 * i + 1]!, numbers[3 * i + 2]!),
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
 * Returns vertex colours times the material's colour; empty if all are white, so that `fill` applies. If the materials of an .obj
 * colour only some vertices, the others get -1, which p5 draws in its fill colour, as after its own `loadModel`.
 */
function colorsOf({ positions, colors, material }: Mesh, painted: Uint8Array): number[] {
  const base = material?.baseColor ?? [1, 1, 1, 1]
  if (!colors && !painted.length && base.every((component) => component === 1)) return []
  return Array.from({ length: (positions.length / 3) * 4 }, (_, i) => {
    if (painted.length && !painted[i >> 2] && !isTinted(colors, i >> 2)) return -1
    const component = base[i % 4]! * (colors ? colors[i]! : 1)
    return i % 4 === 3 ? component : encode(component)
  })
}

/** Returns whether the vertex has a colour other than white. */
const isTinted = (colors: Float32Array | undefined, vertex: number) =>
  !!colors && [0, 1, 2].some((k) => colors[4 * vertex + k] !== 1)

/** Converts a linear color component to sRGB (IEC 61966-2-1). */
const encode = (component: number) =>
  component <= 0.0031308 ? 12.92 * component : 1.055 * component ** (1 / 2.4) - 0.055

async function putTexture(
  model: WarpModel,
  { Image }: P5Constructors,
  { bytes, mimeType }: Picture,
) {
  try {
    const bitmap = await createImageBitmap(new Blob([bytes as BlobPart], { type: mimeType }))
    const image = new Image(bitmap.width, bitmap.height)
    image.drawingContext.drawImage(bitmap, 0, 0)
    model.texture = image
  } catch {
    model.warnings.push('The image of the material cannot be decoded, and is ignored.')
  }
}

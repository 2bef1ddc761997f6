// `npx warpjet bake`: writes a warped model to a file.
import { writeFile } from 'node:fs/promises'
import { compileWarp, type CompiledWarp } from '../compile/compile-warp.js'
import type { Uniforms } from '../core/inputs/vertices.js'
import { WarpError, describe } from '../errors/errors.js'
import { bakeWarp } from '../mesh/bake.js'
import { exportGLB } from '../mesh/export.js'
import { loadMesh } from '../mesh/load.js'
import type { Mesh } from '../mesh/mesh-arrays.js'
import { bakeNormalMap, frameKind, sizeRange } from '../mesh/normal-map.js'
import { subdivide } from '../mesh/subdivide.js'
import { optional, positiveNumber, wholeNumber, type Kind } from '../options/kinds.js'
import type { Place } from '../options/place.js'
import { triangleLimit } from '../wasm/mesh-tables.js'
import { areSameFile, withWriteErrors } from './files.js'
import { Progress, count } from './progress.js'
import { numeric, readArguments } from './usage.js'
import { readWarp, sourceFlags, sourceOptionsOf, withFileInErrors } from './warp-file.js'

const triangleCount = wholeNumber({
  min: 1,
  max: triangleLimit,
  maxName: triangleLimit.toLocaleString('en-US'),
})

/** The kind of the option `--set`, with values such as `mouse=10,20`. */
const uniformSettings: Kind<Uniforms, readonly string[]> = {
  read: (values, place) =>
    Object.fromEntries(
      ((values ?? []) as readonly string[]).map((setting) => parseSetting(setting, place)),
    ),
}

function parseSetting(setting: string, place: Place): [name: string, value: number | number[]] {
  const [, name, list] = /^([^=]+)=(.*)$/s.exec(setting) ?? []
  const numbers = list?.split(',').map((text) => (text.trim() === '' ? NaN : Number(text)))
  if (name === undefined || !numbers!.every(Number.isFinite))
    throw place.expected('a name and numbers, as in --set millis=1200,', describe(setting))
  return [name, numbers!.length === 1 ? numbers![0]! : numbers!]
}

export async function bake(args: string[]): Promise<void> {
  const { values, files, usageError } = readArguments(
    'bake',
    args,
    ['a model', 'a warp.js or a file of GLSL or WGSL'],
    {
      output: { type: 'string', short: 'o' },
      ...sourceFlags,
      set: { type: 'string', multiple: true, kind: uniformSettings },
      subdivide: { type: 'string', kind: numeric(optional(positiveNumber())) },
      'max-triangles': { type: 'string', kind: numeric(optional(triangleCount)) },
      'normal-map': { type: 'string', kind: numeric(optional(wholeNumber(sizeRange))) },
      frames: { type: 'string', kind: optional(frameKind) },
      quiet: { type: 'boolean', short: 'q', default: false },
    },
  )
  const [model, file] = files as [string, string]
  const { output } = values
  if (output === undefined) throw usageError('bake needs -o and the name of the file to write.')
  if (!/\.glb$/i.test(output))
    throw usageError(`bake: expected a .glb file for -o, got "${output}".`)
  if (await areSameFile(output, model))
    throw usageError('bake does not overwrite the model itself.')
  const { set: uniforms, subdivide: tolerance, 'max-triangles': maxTriangles } = values
  const { 'normal-map': size, frames } = values
  if (maxTriangles !== undefined && tolerance === undefined)
    throw usageError('--max-triangles needs --subdivide, which is missing.')
  if (frames !== undefined && size === undefined)
    throw usageError('--frames needs --normal-map, which is missing.')

  const progress = new Progress(values.quiet)
  const { offset, uniforms: declared } = await readWarp(file, sourceOptionsOf(values), uniforms)
  // With `surfaceVariation`, normals are exact: bakeWarp and subdivide compute the gradients of normals and uvs themselves.
  const warp = await withFileInErrors(file, () =>
    compileWarp(offset, { uniforms: declared, surfaceVariation: true }),
  )
  rejectMissingUniforms(file, warp, { ...declared, ...uniforms })

  let mesh = removeUnsupportedImage(await loadMesh(model))
  for (const warning of mesh.warnings ?? []) progress.step(`Note: ${warning}`)
  progress.step(`${model}: ${sizeOf(mesh)}`)
  if (tolerance) {
    try {
      mesh = subdivide(mesh, {
        warp: withProgress(warp, progress),
        uniforms,
        tolerance,
        maxTriangles,
      })
    } finally {
      progress.clear()
    }
    for (const warning of mesh.warnings ?? []) progress.step(`Note: ${warning}`)
    progress.step(`Subdivided: ${sizeOf(mesh)}`)
  }
  if (size === undefined) mesh = bakeWarp(mesh, warp, { uniforms })
  else {
    mesh = bakeNormalMap(mesh, warp, { uniforms, size, frames })
    for (const warning of mesh.warnings ?? []) progress.step(`Note: ${warning}`)
    progress.step(`Normal map: ${size} × ${size}`)
  }
  const bytes = exportGLB(mesh)
  await withWriteErrors(output, () => writeFile(output, bytes))
  progress.step(`${output}: ${count(bytes.length, 'byte')}`)
}

/** Removes the mesh's image and adds a warning if a GLB file may not contain images of this format. */
function removeUnsupportedImage(mesh: Mesh): Mesh {
  const { material, warnings = [] } = mesh
  const picture = material?.baseColorTexture
  if (!picture || isPngOrJpeg(picture.bytes)) return mesh
  const warning = `The image of the base colour (${picture.mimeType}) is neither PNG nor JPEG; it is left out.`
  return {
    ...mesh,
    material: { baseColor: material.baseColor },
    warnings: [...warnings, warning],
  }
}

/** Tests the first bytes of a file, like exportGLB. */
const isPngOrJpeg = (bytes: Uint8Array) =>
  [
    [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a],
    [0xff, 0xd8, 0xff],
  ].some((start) => bytes.length > start.length && start.every((byte, i) => bytes[i] === byte))

const sizeOf = ({ positions, indices }: Mesh) =>
  `${count((indices ?? positions).length / (indices ? 3 : 9), 'triangle')}, ${count(positions.length / 3, 'vertex', 'vertices')}`

/** Returns the warp with an `evaluate` that also prints the total number of vertices evaluated. */
function withProgress(warp: CompiledWarp, progress: Progress): CompiledWarp {
  let vertices = 0
  return {
    ...warp,
    evaluate(mesh, options) {
      vertices += mesh.positions.length / 3
      progress.update(`Subdividing: ${count(vertices, 'vertex', 'vertices')} evaluated`)
      return warp.evaluate(mesh, options)
    },
  }
}

function rejectMissingUniforms(file: string, warp: CompiledWarp, uniforms: object) {
  const missing = warp.uniforms.find(({ name }) => !Object.hasOwn(uniforms, name))
  if (!missing) return
  // For a uniform of GLSL source that is no float, the name contains a conversion: `float(n)`, or one for half of its bits.
  const name = /^\w+\(([^ )]+)/.exec(missing.name)?.[1] ?? missing.name
  throw new WarpError(
    `${file} reads ${name}; add --set ${name}=<number>. Warps that read an image can only be evaluated on a GPU.`,
  )
}

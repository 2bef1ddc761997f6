// `npx warpjet info`: describes a model.
import { loadMesh } from '../mesh/load.js'
import type { Mesh } from '../mesh/mesh-arrays.js'
import { printable } from './printable.js'
import { readArguments } from './usage.js'

export async function info(args: string[]): Promise<void> {
  const { files } = readArguments('info', args, ['a model'], {})
  const mesh = await loadMesh(files[0]!)
  const rows = Object.entries(describe(mesh)).map(([name, text]) => `${name.padEnd(11)} ${text}`)
  const notes = (mesh.warnings ?? []).map((warning) => `note        ${warning}`)
  console.log([...rows, ...notes].map(printable).join('\n'))
}

function describe(mesh: Mesh): Record<string, string> {
  const { positions, indices, material } = mesh
  const vertices = positions.length / 3
  const [min, max] = extent(positions)
  const attributes = (['normals', 'uvs', 'colors', 'tangents'] as const).filter(
    (name) => mesh[name]?.length,
  )
  return {
    triangles: formatInteger(indices ? indices.length / 3 : vertices / 3),
    vertices: formatInteger(vertices),
    ...(vertices > 0 && {
      size: max.map((maxCoordinate, i) => formatFloat(maxCoordinate - min[i]!)).join(' × '),
      from: min.map(formatFloat).join(', '),
      to: max.map(formatFloat).join(', '),
    }),
    attributes: ['positions', ...attributes].join(', '),
    ...(material && { 'base color': material.baseColor.map(formatFloat).join(', ') }),
    ...(material?.baseColorTexture && {
      texture: `${material.baseColorTexture.mimeType}, ${formatInteger(material.baseColorTexture.bytes.length)} bytes`,
    }),
  }
}

const formatInteger = (number: number) => number.toLocaleString('en-US')
const formatFloat = (number: number) => String(Number(number.toPrecision(4)))

function extent(positions: Float32Array): [min: number[], max: number[]] {
  const [min, max] = [Array<number>(3).fill(Infinity), Array<number>(3).fill(-Infinity)]
  positions.forEach((value, i) => {
    min[i % 3] = Math.min(min[i % 3]!, value)
    max[i % 3] = Math.max(max[i % 3]!, value)
  })
  return [min, max]
}

// Tests the messages about meshes whose arrays do not fit together.
import { describe, test } from 'node:test'
import { bakeWarp, exportGLB, subdivide } from 'warpjet/mesh'
import { checkMemoryAfterEach, picture, twist } from '../support/mesh-tests.js'
import { grid, triangle } from '../support/meshes.js'
import { throwsWarpError } from '../support/warp-errors.js'

checkMemoryAfterEach()

describe('a mesh whose arrays do not fit together', () => {
  const functions = {
    exportGLB,
    bakeWarp: (mesh) => bakeWarp(mesh, twist),
    subdivide: (mesh) => subdivide(mesh, { levels: 1 }),
  }
  for (const [name, work] of Object.entries(functions))
    test(name, () => {
      const rejectsChange = (change, pattern) =>
        throwsWarpError(
          () => work({ ...grid(3, 3), ...change }),
          new RegExp(`^${name}: ${pattern.source}`),
        )
      for (const mesh of [undefined, null, 7, 'mesh', {}])
        throwsWarpError(
          () => work(mesh),
          new RegExp(`^${name}: expected a mesh such as \\{ positions, normals, indices \\}, got `),
        )
      rejectsChange(
        { positions: undefined },
        /expected a flat array .* for positions, got undefined/,
      )
      rejectsChange({ positions: 7 }, /expected a flat array .* for positions, got the number 7/)
      rejectsChange({ positions: new Float32Array(26) }, /positions must hold 3 numbers a vertex/)
      rejectsChange({ positions: new Float32Array(27).fill(NaN) }, /positions must be finite.*NaN/)
      rejectsChange(
        { positions: Array(27).fill('x') },
        /expected a finite number for positions\[0\], of vertex 0, got the text "x"/,
      )
      for (const odd of ['1', '', null, true, 1n, Symbol('odd'), undefined])
        rejectsChange(
          { colors: [...Array(35).fill(0), odd] },
          /expected a finite number for colors\[35\], of vertex 8, got/,
        )
      rejectsChange(
        { positions: new BigInt64Array(27) },
        /expected a finite number for positions\[0\], of vertex 0/,
      )
      rejectsChange(
        { indices: [0, 1, null] },
        /expected the number of a vertex, counted from 0, for indices\[2\], got /,
      )
      rejectsChange(
        { material: { baseColor: [1, 1, 1, Symbol('odd')] } },
        /expected four finite numbers, .* for material.baseColor, got \[/,
      )
      rejectsChange(
        { material: { baseColorTexture: { bytes: picture, mimeType: Object.create(null) } } },
        /expected a text .* for material.baseColorTexture.mimeType, got /,
      )
      rejectsChange({ normals: new Float32Array(26) }, /normals must hold 3 numbers a vertex/)
      rejectsChange(
        { normals: new Float32Array(27).fill(Infinity) },
        /normals must be finite.*Infinity/,
      )
      rejectsChange({ uvs: [1, 2] }, /uvs must hold 2 numbers a vertex/)
      rejectsChange({ colors: new Float32Array(27) }, /colors must hold 4/)
      rejectsChange({ tangents: new Float32Array(27) }, /tangents must hold 4/)
      rejectsChange({ indices: [0, 1, 9] }, /index 9 has no vertex/)
      rejectsChange({ indices: [0, 1] }, /every three indices make a triangle/)
      rejectsChange(
        { indices: [0, 1, -1] },
        /expected the number of a vertex, counted from 0, for indices\[2\], got /,
      )
      rejectsChange(
        { indices: [0, 1, 0.5] },
        /expected the number of a vertex, counted from 0, for indices\[2\], got /,
      )
      rejectsChange(
        { indices: [0, 1, '2'] },
        /expected the number of a vertex, counted from 0, for indices\[2\], got the text "2"/,
      )
      rejectsChange({ indices: 7 }, /expected a flat array .* for indices, got the number 7/)
      rejectsChange({ material: 7 }, /expected an object .* for material, got the number 7/)
      rejectsChange(
        { material: { baseColor: [1, 1, 1] } },
        /expected four finite numbers, .* for material.baseColor, got \[/,
      )
      rejectsChange(
        { material: { baseColor: [1, 1, 1, NaN] } },
        /expected four finite numbers, .* for material.baseColor, got \[/,
      )
      rejectsChange(
        { material: { baseColor: [NaN, 1, 1, 1] } },
        /expected four finite numbers, .* for material.baseColor, got \[NaN, 1, 1, 1\]\.?$/,
      )
      rejectsChange(
        { material: { baseColorTexture: 'x.png' } },
        /expected \{ bytes, mimeType \} .* for material.baseColorTexture, got /,
      )
      rejectsChange(
        { material: { baseColorTexture: { bytes: [1] } } },
        /expected \{ bytes, mimeType \} .* for material.baseColorTexture, got bytes that are an array of 1/,
      )
    })

  test('exportGLB rejects a mesh without triangles, and an invalid image', () => {
    const emptyMesh = { positions: [], normals: [] }
    throwsWarpError(() => exportGLB(emptyMesh), /^exportGLB: the mesh has no triangles/)
    throwsWarpError(
      () => exportGLB({ ...grid(2, 2), indices: undefined, positions: [], normals: [] }),
      /no triangles/,
    )
    const bytes = new TextEncoder().encode('<svg/>')
    throwsWarpError(
      () => exportGLB({ ...triangle(), material: { baseColorTexture: { bytes } } }),
      /^exportGLB: material.baseColorTexture must be the bytes of a PNG or JPEG/,
    )
  })
})

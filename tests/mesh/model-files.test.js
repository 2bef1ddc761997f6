// Loads model files in every form that loadMesh reads, written by our generators and by the encoders of meshoptimizer and Draco: compares
// the triangles with those of the generator and those that three.js loads. Khronos' validator checks the glTF files.
import assert from 'node:assert/strict'
import { readFileSync, readdirSync } from 'node:fs'
import { after, describe, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import validator from 'gltf-validator'
import { WarpError } from 'warpjet'
import { bakeWarp, exportGLB, loadMesh } from 'warpjet/mesh'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { meshMemoryInUse } from '../../dist/memory.js'
import { broken } from '../support/models/broken.js'
import { extensionVariants } from '../support/models/extension-variants.js'
import { plainVariants } from '../support/models/gltf-variants.js'
import { packedVariants } from '../support/models/packed-variants.js'
import { compareTriangles, shapes, trianglesOf } from '../support/models/shapes.js'
import { textVariants } from '../support/models/text-variants.js'
import { readByThree } from '../support/models/three.js'

const memory = meshMemoryInUse()
after(() => assert.equal(meshMemoryInUse(), memory))

const trianglesIn = ({ positions, indices }) => trianglesOf({ positions, indices })

function assertTriangles(actual, expected, tolerance = 1e-5) {
  const distance = compareTriangles(actual, expected)
  assert.ok(
    distance <= tolerance,
    typeof distance === 'string' ? distance : `a corner is ${distance} away`,
  )
}

const isGltf = (file) => file[0] === 0x67 || file[0] === 0x7b

async function assertValid(file, files = {}) {
  const externalResourceFunction = async (uri) => {
    if (files[uri] ?? files[encodeURIComponent(uri)])
      return files[uri] ?? files[encodeURIComponent(uri)]
    throw new Error('no such file')
  }
  const { issues } = await validator.validateBytes(file, { externalResourceFunction })
  const errors = issues.messages.filter(({ severity }) => severity === 0)
  // Errors for files that are valid here: image data that is never read, and buffers that extensions fill.
  const ignoredCodes = /^(IMAGE_|VALUE_NOT_IN_LIST|BUFFER_|IO_ERROR|MESH_PRIMITIVE_INDEX_SEMANTIC)/
  assert.deepEqual(
    errors.filter(({ code }) => !ignoredCodes.test(code)),
    [],
  )
}

describe('loadMesh reads generated models:', () => {
  let count = 0
  const variants = { ...plainVariants, ...extensionVariants, ...packedVariants, ...textVariants }
  for (const [name, make] of Object.entries(variants))
    for (const [shapeName, shape] of Object.entries(shapes)) {
      // The everyday run has one or two of the four shapes in each variant.
      if (count++ % 3 && !isRun('every shape in every variant')) continue
      test(`${name}: ${shapeName}`, async () => {
        const { file, files = {}, triangles, tolerance } = make(shape)
        if (isGltf(file)) await assertValid(file, files)
        const mesh = await loadMesh(file, { resolve: (uri) => files[uri] })
        assertTriangles(trianglesIn(mesh), triangles, tolerance)
        assert.ok(mesh.normals.every(Number.isFinite))
        const byThree = await readByThree(name, file)
        if (byThree) assertTriangles(trianglesIn(mesh), byThree, tolerance && 2 * tolerance)
        await assertValid(exportGLB(mesh))
      })
    }

  test('there are at least 200 of them', () => assert.ok(count >= 200, `${count}`))
})

describe('loadMesh rejects invalid models:', () => {
  for (const [name, { file, files = {}, decoders, reason }] of Object.entries(broken))
    test(name, async () => {
      await assert.rejects(loadMesh(file, { resolve: (uri) => files[uri], decoders }), (error) => {
        assert.ok(error instanceof WarpError, String(error?.stack))
        assert.match(error.message, reason)
        assert.doesNotMatch(error.message, /\n|undefined|\[object/)
        return true
      })
    })
})

describe('loadMesh reads models of packages from npm:', () => {
  const folder = fileURLToPath(new URL('../../node_modules/stl/test/', import.meta.url))
  for (const kind of ['ascii', 'binary'])
    for (const name of readdirSync(folder + kind))
      test(`stl: ${kind}/${name}`, async () => {
        const file = new Uint8Array(readFileSync(`${folder}${kind}/${name}`))
        const mesh = await loadMesh(`${folder}${kind}/${name}`)
        const byThree = await readByThree('an STL', file)
        assert.deepEqual([...mesh.positions], byThree.flat(2).map(Math.fround))
        for (let i = 0; i < mesh.normals.length; i += 3) {
          const length = Math.hypot(...mesh.normals.slice(i, i + 3))
          assert.ok(
            length === 0 || Math.abs(length - 1) < 1e-5,
            `normal ${i / 3} has length ${length}`,
          )
        }
        await assertValid(exportGLB(mesh))
      })

  test('draco3dgltf: bunny.drc in a glTF', async () => {
    const { bunnyFile } = await import('../support/models/draco-bunny.js')
    const mesh = await loadMesh(bunnyFile())
    // The number of triangles of the Stanford bunny, according to the package.
    assert.equal(mesh.indices.length / 3, 69451)
    assert.ok(mesh.positions.every(Number.isFinite))
  })
})

describe('decoders', () => {
  const meshopt = packedVariants['meshopt, vertices and triangles'](shapes.cube)
  const draco = packedVariants['Draco, sequential encoding'](shapes.cube)

  test('may be passed in every form in which their packages export them', async () => {
    const { MeshoptDecoder } = await import('meshoptimizer')
    const { default: package_ } = await import('draco3dgltf')
    for (const decoder of [MeshoptDecoder, Promise.resolve(MeshoptDecoder)]) {
      const mesh = await loadMesh(meshopt.file, { decoders: { meshopt: decoder } })
      assertTriangles(trianglesIn(mesh), meshopt.triangles)
    }
    const { createDecoderModule } = package_
    const decoderModule = await createDecoderModule({})
    for (const decoder of [
      package_,
      createDecoderModule,
      () => createDecoderModule({}),
      decoderModule,
      Promise.resolve(decoderModule),
    ]) {
      const mesh = await loadMesh(draco.file, { decoders: { draco: decoder } })
      assertTriangles(trianglesIn(mesh), draco.triangles)
    }
  })

  test('come from the option, or else from the global variable', async () => {
    let calls = 0
    const { MeshoptDecoder } = await import('meshoptimizer')
    const counting = {
      ready: MeshoptDecoder.ready,
      decodeGltfBuffer: (...args) => (calls++, MeshoptDecoder.decodeGltfBuffer(...args)),
    }
    await loadMesh(meshopt.file, { decoders: { meshopt: counting } })
    assert.equal(calls, 4)
    globalThis.MeshoptDecoder = counting
    try {
      await loadMesh(meshopt.file)
      assert.equal(calls, 8)
    } finally {
      delete globalThis.MeshoptDecoder
    }
    for (const [decoders, message] of [
      [7, /^loadMesh: expected an object for the option "decoders", got the number 7/],
      [
        { mesh: counting },
        /^loadMesh: there is no option "mesh" in the option "decoders"; did you mean meshopt\? The options are meshopt, draco/,
      ],
      [
        { meshopt: {} },
        /^loadMesh: expected the decoder of the package meshoptimizer for the option "decoders.meshopt", got /,
      ],
    ])
      await assert.rejects(loadMesh(meshopt.file, { decoders }), (error) => {
        assert.ok(error instanceof WarpError)
        assert.match(error.message, message)
        return true
      })
  })

  test('are not needed if the file has an uncompressed fallback', async () => {
    const { file, files, triangles } = packedVariants['meshopt with a fallback'](shapes.sphere)
    const broken = {
      ready: Promise.resolve(),
      decodeGltfBuffer() {
        throw new Error('not here')
      },
    }
    await assert.rejects(
      loadMesh(file, { resolve: (uri) => files[uri], decoders: { meshopt: broken } }),
      /cannot be decoded \(not here\)/,
    )
    const mesh = await loadMesh(file, { resolve: (uri) => files[uri] })
    assertTriangles(trianglesIn(mesh), triangles)
  })
})

test('make models that can be warped and exported', async () => {
  const { file } = packedVariants['Draco, edgebreaker encoding'](shapes.sphere)
  const mesh = await loadMesh(file)
  const lifted = {
    evaluate: ({ positions, normals }) => ({ positions: positions.map((x) => x + 1), normals }),
  }
  await assertValid(exportGLB(bakeWarp(mesh, lifted)))
})

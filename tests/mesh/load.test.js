// Tests loadMesh and exportGLB in JavaScript: round trips, and sources of bytes. C++ tests check the conversion from files to meshes.
import assert from 'node:assert/strict'
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { createServer } from 'node:http'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, describe, test } from 'node:test'
import { pathToFileURL } from 'node:url'
import { exportGLB, loadMesh } from 'warpjet/mesh'
import * as meshModule from 'warpjet/mesh'
import { readGlb } from '../support/glb.js'
import { checkMemoryAfterEach, material, withBuffer } from '../support/mesh-tests.js'
import { grid, sphere, triangle } from '../support/meshes.js'
import { rejectsWithWarpError } from '../support/warp-errors.js'

checkMemoryAfterEach()

describe('a model that is loaded, exported and loaded again', () => {
  for (const [name, mesh] of Object.entries({
    'all attributes, a material and a texture': { ...sphere(), material },
    'no indices, no material': triangle(),
    'a material without a texture': { ...grid(3, 4), material: { baseColor: [0, 1, 0.5, 1] } },
    '70,000 vertices': grid(700, 100),
  }))
    test(`is identical: ${name}`, async () => {
      const first = await loadMesh(exportGLB(mesh))
      const file = exportGLB(first)
      const second = await loadMesh(file)
      assert.deepEqual(second, first)
      assert.deepEqual(exportGLB(second), file)
      for (const array of ['positions', 'normals', 'uvs', 'colors', 'tangents', 'indices'])
        assert.deepEqual(first[array], mesh[array], array)
      assert.deepEqual(first.material, mesh.material)
      assert.equal(first.warnings, undefined)
    })

  test('can be modified by the caller', async () => {
    const mesh = await loadMesh(exportGLB(sphere()))
    for (const array of [mesh.positions, mesh.indices])
      assert.equal(array.buffer.byteLength, array.byteLength)
  })
})

describe('loadMesh', () => {
  const folder = mkdtempSync(join(tmpdir(), 'warpjet mesh '))
  const mesh = triangle()
  const { text, buffer } = withBuffer(mesh, 'a%20b/c.bin')
  let server, origin
  const files = { '/m/model.gltf': text, '/m/a%20b/c.bin': buffer, '/m/model.glb': exportGLB(mesh) }

  before(async () => {
    writeFileSync(join(folder, 'model.glb'), exportGLB(mesh))
    server = createServer(({ url }, response) => {
      if (url === '/broken.glb') {
        response.writeHead(200, { 'Content-Length': 100 }).write('glTF')
        return void setTimeout(() => response.destroy(), 50)
      }
      response.statusCode = files[url] ? 200 : 404
      response.end(files[url])
    })
    await new Promise((resolve) => server.listen(0, '127.0.0.1', resolve))
    origin = `http://127.0.0.1:${server.address().port}`
  })
  after(() => {
    server.close()
    rmSync(folder, { recursive: true })
  })

  const assertLoads = async (source, options) =>
    assert.deepEqual((await loadMesh(source, options)).positions, mesh.positions)

  test('accepts bytes in every form', async () => {
    const bytes = exportGLB(mesh)
    await assertLoads(bytes)
    await assertLoads(bytes.slice().buffer)
    await assertLoads(new DataView(bytes.slice().buffer))
    await assertLoads(new Blob([bytes]))
    await assertLoads(Buffer.from(bytes))
    // Part of a longer buffer.
    const longer = new Uint8Array(bytes.length + 14)
    longer.set(bytes, 7)
    await assertLoads(longer.subarray(7, 7 + bytes.length))
  })

  test('accepts a path, a file URL or a web address', async () => {
    const path = join(folder, 'model.glb')
    await assertLoads(path)
    await assertLoads(pathToFileURL(path))
    await assertLoads(pathToFileURL(path).href)
    await assertLoads(`${origin}/m/model.glb`)
    await assertLoads(new URL(`${origin}/m/model.glb`))
    const previousFolder = process.cwd()
    process.chdir(folder)
    try {
      await assertLoads('model.glb')
    } finally {
      process.chdir(previousFolder)
    }
  })

  test('treats a string as a path in Node, with any characters', async () => {
    const oddFolder = join(folder, 'odd')
    mkdirSync(oddFolder)
    const names = ['a#1.glb', 'q?.glb', 'a%20b.glb', '100%.glb', 'C:m.glb', 'c:\\m\\a.glb']
    // Read as a URL, the string would name another file.
    for (const name of ['a', 'q', 'a b.glb', 'm.glb']) writeFileSync(join(oddFolder, name), 'wrong')
    for (const name of names) writeFileSync(join(oddFolder, name), exportGLB(mesh))
    const previousFolder = process.cwd()
    process.chdir(oddFolder)
    try {
      for (const name of names) {
        await assertLoads(name)
        await assertLoads(join(oddFolder, name))
      }
      await rejectsWithWarpError(
        () => loadMesh('50%.glb'),
        /^loadMesh: the file .*50%\.glb does not exist/,
      )
    } finally {
      process.chdir(previousFolder)
    }
    await assertLoads(
      `data:application/octet-stream;base64,${Buffer.from(exportGLB(mesh)).toString('base64')}`,
    )
  })

  test('reads the buffer of a .gltf from the same folder or from the caller', async () => {
    await assertLoads(`${origin}/m/model.gltf`)
    const requestedUris = []
    const resolve = (uri) => {
      requestedUris.push(uri)
      return Promise.resolve(buffer)
    }
    await assertLoads(text, { resolve })
    assert.deepEqual(requestedUris, ['a%20b/c.bin'])
    await assertLoads(text, { resolve: () => buffer.slice().buffer })
    await assertLoads(text, { resolve: () => new Blob([buffer]) })
  })

  test('rejects a .gltf without its buffer', async () => {
    await rejectsWithWarpError(() => loadMesh(text), /^loadMesh: .*"a%20b\/c\.bin"/)
    await rejectsWithWarpError(
      () => loadMesh(text, { resolve: () => undefined }),
      /"a%20b\/c\.bin"/,
    )
    await rejectsWithWarpError(
      () => loadMesh(text, { resolve: () => 7 }),
      /^loadMesh: resolve\("a%20b\/c\.bin"\): .*the number 7/,
    )
    await assert.rejects(
      loadMesh(text, {
        resolve() {
          throw new TypeError('mine')
        },
      }),
      /^TypeError: mine$/,
    )
  })

  test('warns about a missing image, and throws for a missing buffer', async () => {
    const glbParts = readGlb(exportGLB({ ...sphere(), material }))
    const { images, buffers } = glbParts.json
    delete images[0].bufferView
    buffers[0].uri = 'c.bin'
    const binary = glbParts.chunks[1].bytes
    files['/m/c.bin'] = binary
    writeFileSync(join(folder, 'c.bin'), binary)
    const missingUris = ['no.png', 'http://[', '100%.png']
    for (const uri of missingUris) {
      images[0].uri = uri
      const text = new TextEncoder().encode(JSON.stringify(glbParts.json))
      files['/m/pictured.gltf'] = text
      writeFileSync(join(folder, 'pictured.gltf'), text)
      for (const place of [join(folder, 'pictured.gltf'), `${origin}/m/pictured.gltf`]) {
        const { warnings, material, positions } = await loadMesh(place)
        assert.deepEqual(positions, sphere().positions)
        assert.equal(material.baseColorTexture, undefined)
        assert.match(warnings.join(), /^The base-colour texture .* is missing/)
      }
    }
    for (const uri of ['no.bin', 'http://[', '100%.bin']) {
      files['/m/pictured.gltf'] = withBuffer(mesh, uri).text
      writeFileSync(join(folder, 'pictured.gltf'), files['/m/pictured.gltf'])
      for (const place of [join(folder, 'pictured.gltf'), `${origin}/m/pictured.gltf`])
        await rejectsWithWarpError(() => loadMesh(place), /^loadMesh: the model needs the file "/)
    }
    // A data URL has no folder.
    await rejectsWithWarpError(
      () => loadMesh(`data:model/gltf+json;base64,${Buffer.from(text).toString('base64')}`),
      /^loadMesh: the model needs the file "/,
    )
  })

  test('throws for an interrupted download', async () => {
    const broken = new Blob(['x'])
    broken.arrayBuffer = () => Promise.reject(new DOMException('gone', 'NotReadableError'))
    await rejectsWithWarpError(
      () => loadMesh(broken),
      /^loadMesh: the Blob .* \(NotReadableError\)/,
    )
    await rejectsWithWarpError(
      () => loadMesh(`${origin}/broken.glb`),
      /^loadMesh: .* the connection was interrupted/,
    )
  })

  test('does not read files outside the folder of an untrusted file', async () => {
    writeFileSync(join(folder, 'secret.bin'), buffer)
    for (const uri of ['../secret.bin', pathToFileURL(join(folder, 'secret.bin')).href]) {
      const path = join(mkdtempSync(join(folder, 'sub')), 'model.gltf')
      writeFileSync(path, withBuffer(mesh, uri).text)
      await rejectsWithWarpError(() => loadMesh(path), /^loadMesh: /)
    }
    const inside = mkdtempSync(join(folder, 'sub'))
    writeFileSync(join(inside, 'model.gltf'), withBuffer(mesh, 'linked/scene.bin').text)
    mkdirSync(join(inside, 'real'))
    writeFileSync(join(inside, 'real', 'scene.bin'), buffer)
    symlinkSync('real', join(inside, 'linked'))
    assert.deepEqual((await loadMesh(join(inside, 'model.gltf'))).positions, mesh.positions)
    rmSync(join(inside, 'real', 'scene.bin'))
    symlinkSync(join(folder, 'secret.bin'), join(inside, 'real', 'scene.bin'))
    await rejectsWithWarpError(
      () => loadMesh(join(inside, 'model.gltf')),
      /^loadMesh: the model needs the file "linked\/scene\.bin"/,
    )
  })

  test('throws for missing files and invalid sources', async () => {
    await rejectsWithWarpError(
      () => loadMesh(join(folder, 'no.glb')),
      /^loadMesh: the file .*no\.glb does not exist/,
    )
    await rejectsWithWarpError(() => loadMesh(folder), /^loadMesh: the file .* cannot be read/)
    await rejectsWithWarpError(
      () => loadMesh(`${origin}/no.glb`),
      /^loadMesh: cannot load .*no\.glb; .* 404/,
    )
    const long = `${origin}/${'folder/'.repeat(9)}nope.glb`
    await rejectsWithWarpError(
      () => loadMesh(`${long}?token=1`),
      new RegExp(`^loadMesh: cannot load ${long}; the server answered 404\\.$`),
    )
    await rejectsWithWarpError(
      () => loadMesh('http://127.0.0.1:1/no.glb'),
      /^loadMesh: cannot load /,
    )
    await rejectsWithWarpError(
      () => loadMesh('http://[/'),
      /^loadMesh: expected a URL, got "http:\/\/\[\/"/,
    )
    for (const source of [undefined, null, 7, {}, [1, 2]])
      await rejectsWithWarpError(
        () => loadMesh(source),
        /^loadMesh: expected a URL, or bytes in an ArrayBuffer, a Uint8Array or a Blob, got /,
      )
    await rejectsWithWarpError(
      () => loadMesh(exportGLB(mesh), { resolve: 7 }),
      /"resolve".*the number 7/,
    )
    await rejectsWithWarpError(
      () => loadMesh(exportGLB(mesh), { resolver: () => buffer }),
      /^loadMesh: there is no option "resolver"; did you mean resolve\? The options are resolve, as, decoders\./,
    )
  })
})

test('the module exports exactly the public functions and those for the p5 addon', () => {
  assert.deepEqual(Object.keys(meshModule).sort(), [
    'WarpError',
    'bakeNormalMap',
    'bakeWarp',
    'exportGLB',
    // This export, subdivideP5Model and varyGeometry are for the p5 addon.
    'fillP5Model',
    'loadMesh',
    'subdivide',
    'subdivideP5Model',
    'surfaceVariation',
    'varyGeometry',
  ])
})

// warpjet/mesh in JavaScript: round trips, sources of bytes, errors, hostile files, memory. C++ tests check the conversion from
// files to meshes.
import assert from 'node:assert/strict'
import { createServer } from 'node:http'
import { mkdirSync, mkdtempSync, rmSync, symlinkSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, afterEach, before, describe, test } from 'node:test'
import { pathToFileURL } from 'node:url'
import { WarpError, compileWarp } from 'warpjet'
import { bakeWarp, exportGLB, loadMesh, subdivide } from 'warpjet/mesh'
import { meshMemoryInUse } from '../../dist/memory.js'
import * as addresses from 'warpjet/mesh'
import { readGlb, writeGlb } from '../support/glb.js'
import { grid, sphere, triangle } from '../support/meshes.js'
import { png } from '../support/png.js'

const picture = png(2, 2, (x, y) => [255 * x, 255 * y, 0])
const material = {
  baseColor: [1, 0.5, 0.25, 0.75],
  baseColorTexture: { bytes: picture, mimeType: 'image/png' },
}

const twist = compileWarp(({ glsl, position }) => {
  const angle = position.y().mult(2)
  return glsl.rotateY(angle).mult(position).sub(position)
})
const rise = compileWarp(({ glsl, millis }) => glsl.vec3(0, millis, 0))

const memory = meshMemoryInUse()

// After any test, the wasm module holds nothing, and the next call works.
afterEach(() => {
  assert.equal(exportGLB(triangle()).length % 4, 0)
  assert.equal(meshMemoryInUse(), memory)
})

function isRight(error, pattern) {
  assert.ok(error instanceof WarpError, String(error))
  assert.match(error.message, pattern)
  assert.doesNotMatch(error.message, /\n|: undefined|\[object/)
  return true
}

const refuses = (work, pattern) => assert.throws(work, (error) => isRight(error, pattern))
const rejects = (work, pattern) => assert.rejects(work, (error) => isRight(error, pattern))

/** Returns the mesh as a .gltf text whose buffer has this URI, and the buffer. */
function withBuffer(mesh, uri) {
  const { json, chunks } = readGlb(exportGLB(mesh))
  json.buffers[0].uri = uri
  return { text: new TextEncoder().encode(JSON.stringify(json)), buffer: chunks[1].bytes }
}

describe('load, export, load', () => {
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

  test('a loaded mesh belongs to the caller', async () => {
    const mesh = await loadMesh(exportGLB(sphere()))
    for (const array of [mesh.positions, mesh.indices])
      assert.equal(array.buffer.byteLength, array.byteLength)
  })
})

describe('sources of bytes', () => {
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

  const loads = async (source, options) =>
    assert.deepEqual((await loadMesh(source, options)).positions, mesh.positions)

  test('bytes of every kind', async () => {
    const bytes = exportGLB(mesh)
    await loads(bytes)
    await loads(bytes.slice().buffer)
    await loads(new DataView(bytes.slice().buffer))
    await loads(new Blob([bytes]))
    await loads(Buffer.from(bytes))
    // Part of a longer buffer.
    const longer = new Uint8Array(bytes.length + 14)
    longer.set(bytes, 7)
    await loads(longer.subarray(7, 7 + bytes.length))
  })

  test('a path, a file URL, and the web', async () => {
    const path = join(folder, 'model.glb')
    await loads(path)
    await loads(pathToFileURL(path))
    await loads(pathToFileURL(path).href)
    await loads(`${origin}/m/model.glb`)
    await loads(new URL(`${origin}/m/model.glb`))
    const here = process.cwd()
    process.chdir(folder)
    try {
      await loads('model.glb')
    } finally {
      process.chdir(here)
    }
  })

  test('in Node a string is a path, with any characters', async () => {
    const odd = join(folder, 'odd')
    mkdirSync(odd)
    const names = ['a#1.glb', 'q?.glb', 'a%20b.glb', '100%.glb', 'C:m.glb', 'c:\\m\\a.glb']
    // If the string were read as a URL, it would be another file.
    for (const name of ['a', 'q', 'a b.glb', 'm.glb']) writeFileSync(join(odd, name), 'wrong')
    for (const name of names) writeFileSync(join(odd, name), exportGLB(mesh))
    const here = process.cwd()
    process.chdir(odd)
    try {
      for (const name of names) {
        await loads(name)
        await loads(join(odd, name))
      }
      await rejects(() => loadMesh('50%.glb'), /^loadMesh: the file .*50%\.glb does not exist/)
    } finally {
      process.chdir(here)
    }
    await loads(
      `data:application/octet-stream;base64,${Buffer.from(exportGLB(mesh)).toString('base64')}`,
    )
  })

  test('the buffer of a .gltf in the same folder, or from the caller', async () => {
    await loads(`${origin}/m/model.gltf`)
    const asked = []
    const resolve = (uri) => {
      asked.push(uri)
      return Promise.resolve(buffer)
    }
    await loads(text, { resolve })
    assert.deepEqual(asked, ['a%20b/c.bin'])
    await loads(text, { resolve: () => buffer.slice().buffer })
    await loads(text, { resolve: () => new Blob([buffer]) })
  })

  test('a .gltf without its buffer is rejected', async () => {
    await rejects(() => loadMesh(text), /^loadMesh: .*"a%20b\/c\.bin"/)
    await rejects(() => loadMesh(text, { resolve: () => undefined }), /"a%20b\/c\.bin"/)
    await rejects(
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

  test('a missing image gives a warning, a missing buffer an error, from any source', async () => {
    const without = readGlb(exportGLB({ ...sphere(), material }))
    const { images, buffers } = without.json
    delete images[0].bufferView
    buffers[0].uri = 'c.bin'
    const binary = without.chunks[1].bytes
    files['/m/c.bin'] = binary
    writeFileSync(join(folder, 'c.bin'), binary)
    const odd = ['no.png', 'http://[', '100%.png']
    for (const uri of odd) {
      images[0].uri = uri
      const text = new TextEncoder().encode(JSON.stringify(without.json))
      files['/m/pictured.gltf'] = text
      writeFileSync(join(folder, 'pictured.gltf'), text)
      for (const place of [join(folder, 'pictured.gltf'), `${origin}/m/pictured.gltf`]) {
        const { warnings, material, positions } = await loadMesh(place)
        assert.deepEqual(positions, sphere().positions)
        assert.equal(material.baseColorTexture, undefined)
        assert.match(warnings.join(), /^The picture of the base colour .* is missing/)
      }
    }
    for (const uri of ['no.bin', 'http://[', '100%.bin']) {
      files['/m/pictured.gltf'] = withBuffer(mesh, uri).text
      writeFileSync(join(folder, 'pictured.gltf'), files['/m/pictured.gltf'])
      for (const place of [join(folder, 'pictured.gltf'), `${origin}/m/pictured.gltf`])
        await rejects(() => loadMesh(place), /^loadMesh: the model needs the file "/)
    }
    // These sources have no folder.
    await rejects(
      () => loadMesh(`data:model/gltf+json;base64,${Buffer.from(text).toString('base64')}`),
      /^loadMesh: the model needs the file "/,
    )
  })

  test('an interrupted download', async () => {
    const broken = new Blob(['x'])
    broken.arrayBuffer = () => Promise.reject(new DOMException('gone', 'NotReadableError'))
    await rejects(() => loadMesh(broken), /^loadMesh: the Blob .* \(NotReadableError\)/)
    await rejects(
      () => loadMesh(`${origin}/broken.glb`),
      /^loadMesh: .* the connection was interrupted/,
    )
  })

  test('an untrusted file cannot read files outside its folder', async () => {
    writeFileSync(join(folder, 'secret.bin'), buffer)
    for (const uri of ['../secret.bin', pathToFileURL(join(folder, 'secret.bin')).href]) {
      const path = join(mkdtempSync(join(folder, 'sub')), 'model.gltf')
      writeFileSync(path, withBuffer(mesh, uri).text)
      await rejects(() => loadMesh(path), /^loadMesh: /)
    }
    const inside = mkdtempSync(join(folder, 'sub'))
    writeFileSync(join(inside, 'model.gltf'), withBuffer(mesh, 'linked/scene.bin').text)
    mkdirSync(join(inside, 'real'))
    writeFileSync(join(inside, 'real', 'scene.bin'), buffer)
    symlinkSync('real', join(inside, 'linked'))
    assert.deepEqual((await loadMesh(join(inside, 'model.gltf'))).positions, mesh.positions)
    rmSync(join(inside, 'real', 'scene.bin'))
    symlinkSync(join(folder, 'secret.bin'), join(inside, 'real', 'scene.bin'))
    await rejects(
      () => loadMesh(join(inside, 'model.gltf')),
      /^loadMesh: the model needs the file "linked\/scene\.bin"/,
    )
  })

  test('missing files, and invalid sources', async () => {
    await rejects(
      () => loadMesh(join(folder, 'no.glb')),
      /^loadMesh: the file .*no\.glb does not exist/,
    )
    await rejects(() => loadMesh(folder), /^loadMesh: the file .* cannot be read/)
    await rejects(() => loadMesh(`${origin}/no.glb`), /^loadMesh: cannot load .*no\.glb; .* 404/)
    const long = `${origin}/${'folder/'.repeat(9)}nope.glb`
    await rejects(
      () => loadMesh(`${long}?token=1`),
      new RegExp(`^loadMesh: cannot load ${long}; the server answered 404\\.$`),
    )
    await rejects(() => loadMesh('http://127.0.0.1:1/no.glb'), /^loadMesh: cannot load /)
    await rejects(() => loadMesh('http://[/'), /^loadMesh: expected a URL, got "http:\/\/\[\/"/)
    for (const source of [undefined, null, 7, {}, [1, 2]])
      await rejects(
        () => loadMesh(source),
        /^loadMesh: expected a URL, or bytes in an ArrayBuffer, a Uint8Array or a Blob, got /,
      )
    await rejects(() => loadMesh(exportGLB(mesh), { resolve: 7 }), /"resolve".*the number 7/)
    await rejects(
      () => loadMesh(exportGLB(mesh), { resolver: () => buffer }),
      /^loadMesh: there is no option "resolver"; did you mean resolve\? There are resolve, as, decoders\./,
    )
  })
})

describe('a mesh whose arrays do not fit together', () => {
  const others = {
    exportGLB,
    bakeWarp: (mesh) => bakeWarp(mesh, twist),
    subdivide: (mesh) => subdivide(mesh, { levels: 1 }),
  }
  for (const [name, work] of Object.entries(others))
    test(name, () => {
      const rejectsChange = (change, pattern) =>
        refuses(() => work({ ...grid(3, 3), ...change }), new RegExp(`^${name}: ${pattern.source}`))
      for (const mesh of [undefined, null, 7, 'mesh', {}])
        refuses(
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
        /positions\[0\], of vertex 0: expected a finite number, got the text "x"/,
      )
      for (const odd of ['1', '', null, true, 1n, Symbol('odd'), undefined])
        rejectsChange(
          { colors: [...Array(35).fill(0), odd] },
          /colors\[35\], of vertex 8: expected a finite number, got/,
        )
      rejectsChange(
        { positions: new BigInt64Array(27) },
        /positions\[0\], of vertex 0: expected a finite/,
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
        { material: { baseColorTexture: 'x.png' } },
        /expected \{ bytes, mimeType \} .* for material.baseColorTexture, got /,
      )
      rejectsChange(
        { material: { baseColorTexture: { bytes: [1] } } },
        /expected \{ bytes, mimeType \} .* for material.baseColorTexture, got bytes that are an array of 1/,
      )
    })

  test('exportGLB: no triangles, and an invalid image', () => {
    const none = { positions: [], normals: [] }
    refuses(() => exportGLB(none), /^exportGLB: the mesh has no triangles/)
    refuses(
      () => exportGLB({ ...grid(2, 2), indices: undefined, positions: [], normals: [] }),
      /no triangles/,
    )
    const bytes = new TextEncoder().encode('<svg/>')
    refuses(
      () => exportGLB({ ...triangle(), material: { baseColorTexture: { bytes } } }),
      /^exportGLB: material.baseColorTexture must be the bytes of a PNG or JPEG/,
    )
  })
})

describe('bakeWarp', () => {
  test('warps positions and normals, and keeps the rest', () => {
    const mesh = { ...sphere(), material }
    const before = structuredClone(mesh)
    const baked = bakeWarp(mesh, twist)
    assert.deepEqual(mesh, before, 'what came in is as it was')
    for (const name of ['uvs', 'colors', 'indices', 'material'])
      assert.deepEqual(baked[name], mesh[name], name)
    assert.notEqual(baked.uvs, mesh.uvs)
    // The twist about y, by hand: p' = R(2y) p; its normal by two finite differences of the sphere would do, but at the equator's
    // first vertex (1, 0, 0) the surface is tilted by exactly atan(2): the tangent (0, 1, 0) becomes (0, 1, -2).
    for (let v = 0; v < mesh.positions.length / 3; v++) {
      const [x, y, z] = mesh.positions.subarray(3 * v, 3 * v + 3)
      const [c, s] = [Math.cos(2 * y), Math.sin(2 * y)]
      const expected = [c * x + s * z, y, c * z - s * x]
      expected.forEach((value, i) => assert.ok(Math.abs(baked.positions[3 * v + i] - value) < 1e-6))
    }
    const v = mesh.positions.findIndex(
      (x, i) => i % 3 === 0 && x === 1 && Math.abs(mesh.positions[i + 1]) < 1e-6,
    )
    const normal = baked.normals.subarray(v, v + 3)
    for (const tangent of [
      [0, 1, -2],
      [0, 0, 1],
    ]) {
      const dot = tangent.reduce((sum, x, i) => sum + x * normal[i], 0)
      assert.ok(Math.abs(dot) < 1e-5, `${normal} is at right angles to ${tangent}`)
    }
    assert.equal(baked.tangents.length, mesh.tangents.length)
  })

  test('uniforms', () => {
    const baked = bakeWarp(triangle(), rise, { uniforms: { millis: 5 } })
    assert.deepEqual([...baked.positions], [0, 5, 0, 1, 5, 0, 0, 6, 0])
    refuses(() => bakeWarp(triangle(), rise), /^bakeWarp: the warp reads "millis"/)
    refuses(
      () => bakeWarp(triangle(), rise, { uniforms: { milis: 5 } }),
      /^bakeWarp: the warp has no uniform "milis"/,
    )
  })

  test('missing normals are computed first', () => {
    const { positions } = triangle()
    assert.deepEqual(
      [...bakeWarp({ positions }, rise, { uniforms: { millis: 1 } }).normals],
      [0, 0, 1, 0, 0, 1, 0, 0, 1],
    )
  })

  test('an empty mesh stays empty', () => {
    assert.equal(bakeWarp({ positions: [] }, twist).positions.length, 0)
  })

  test('no finite result', () => {
    const pole = compileWarp(({ glsl, position }) => glsl.vec3(position.x().sub(1).pow(-1), 0, 0))
    refuses(
      () => bakeWarp(triangle(), pole),
      /^bakeWarp: expected a finite position of vertex 1 at \(1, 0, 0\), got Infinity/,
    )
  })

  test('invalid warps', () => {
    for (const warp of [undefined, 7, {}, () => 1])
      refuses(
        () => bakeWarp(triangle(), warp),
        /^bakeWarp: expected a result of compileWarp for the warp, got /,
      )
    const flat = compileWarp(({ position }) => position, { normals: false })
    refuses(
      () => bakeWarp(triangle(), flat),
      /^bakeWarp: the warp was compiled with "normals: false"/,
    )
  })

  test('other programs can read the result', async () => {
    const again = await loadMesh(exportGLB(bakeWarp(sphere(), twist)))
    assert.deepEqual(again.positions, bakeWarp(sphere(), twist).positions)
  })
})

describe('subdivide', () => {
  // The file of the issue: 16,000 coincident triangles took 10 s, and more blocked the page.
  test('a model whose nodes repeat one mesh in place', async () => {
    const { json, chunks } = readGlb(exportGLB(triangle()))
    json.nodes = Array.from({ length: 20_000 }, () => ({ mesh: 0 }))
    json.scenes = [{ nodes: json.nodes.map((_, i) => i) }]
    json.scene = 0
    const mesh = await loadMesh(writeGlb(json, chunks[1].bytes))
    assert.equal(mesh.positions.length, 9 * 20_000)
    const start = process.cpuUsage()
    const fine = subdivide(mesh, { levels: 1 })
    const bent = subdivide(mesh, { warp: twist, tolerance: 0.1, angle: Infinity })
    const { user, system } = process.cpuUsage(start)
    assert.equal(fine.indices.length, 3 * 4 * 20_000)
    assert.equal(bent.indices.length % (3 * 20_000), 0)
    assert.ok(bent.indices.length > 3 * 20_000 && !bent.warnings)
    assert.ok(user + system < 5e6, `${(user + system) / 1e6} s`)
  })

  test('each level splits a triangle into four', () => {
    assert.equal(subdivide(triangle(), { levels: 0 }).indices.length, 3)
    assert.equal(subdivide(triangle(), { levels: 3 }).indices.length, 3 * 64)
  })

  test('triangles that the warp bends are split until the tolerance is met, and no others', () => {
    const bump = compileWarp(({ glsl, position }) =>
      glsl.vec3(0, 0, position.x().mult(position.x()).mult(0.5)),
    )
    const plane = grid(2, 2)
    const worst = (mesh) => {
      // Along x the surface is z = x² / 2: between two vertices it deviates from the chord by the square of their distance / 8.
      let most = 0
      for (let i = 0; i < mesh.indices.length; i += 3) {
        const xs = [...mesh.indices.subarray(i, i + 3)].map((v) => mesh.positions[3 * v])
        most = Math.max(most, (Math.max(...xs) - Math.min(...xs)) ** 2 / 8)
      }
      return most
    }
    assert.equal(worst(plane), 1 / 8)
    const fine = subdivide(plane, { warp: bump, tolerance: 0.01, angle: Infinity })
    assert.ok(worst(fine) <= 0.01, `${worst(fine)}`)
    assert.equal(fine.warnings, undefined)
    assert.ok(fine.indices.length < 3 * 200)
    const still = subdivide(plane, { warp: rise, uniforms: { millis: 3 }, tolerance: 0.01 })
    assert.equal(still.indices.length, plane.indices.length)
  })

  test('maxTriangles is a limit, with a warning', () => {
    const options = { warp: twist, tolerance: 1e-4, maxTriangles: 500 }
    const mesh = subdivide(sphere(), options)
    assert.ok(mesh.indices.length <= 3 * 500)
    assert.equal(mesh.warnings.length, 1)
    const uniform = subdivide(triangle(), { levels: 15, maxTriangles: 100 })
    assert.equal(uniform.indices.length, 3 * 64)
    assert.deepEqual(uniform.warnings, [
      'Of 15 levels only 3 were made, with 64 triangles, for maxTriangles is 100.',
    ])
    assert.equal(subdivide(triangle(), { levels: 3, maxTriangles: 64 }).warnings, undefined)
    assert.equal(subdivide({ positions: [] }, { levels: 15 }).warnings, undefined)
  })

  test('wrong options', () => {
    const rejectsChange = (options, pattern) =>
      refuses(() => subdivide(triangle(), options), pattern)
    rejectsChange(undefined, /^subdivide: expected options such as .*, got undefined/)
    rejectsChange(
      {},
      /^subdivide: expected a result of compileWarp for the option "warp", got undefined/,
    )
    rejectsChange(
      { warp: twist },
      /^subdivide: expected a number above 0 for the option "tolerance", got undefined/,
    )
    rejectsChange(
      { warp: twist, tolerance: 0 },
      /expected a number above 0 for the option "tolerance", got the number 0/,
    )
    rejectsChange(
      { warp: twist, tolerance: 1, angle: -1 },
      /expected a number above 0 for the option "angle", got the number -1/,
    )
    rejectsChange(
      { levels: 1.5 },
      /expected a whole number from 0 to 15 for the option "levels", got the number 1\.5/,
    )
    rejectsChange(
      { levels: 1, maxTriangles: 0 },
      /expected a whole number from 1 to 2\^28 for the option "maxTriangles", got the number 0/,
    )
    rejectsChange(
      { levels: 1, maxTriangles: 2 ** 28 + 1 },
      /from 1 to 2\^28 for the option "maxTriangles", got /,
    )
    rejectsChange(
      { levels: 1, maxTriangle: 1 },
      /^subdivide: there is no option "maxTriangle"; did you mean maxTriangles\? There/,
    )
    rejectsChange(
      { warp: twist, tolerance: 1, angel: 1 },
      /^subdivide: there is no option "angel"; did you mean angle\? There/,
    )
    rejectsChange({ warp: rise, tolerance: 1 }, /^subdivide: the warp reads "millis"/)
  })

  test('results of warps made by hand are checked', () => {
    const of = (evaluate, pattern) => {
      for (const work of [
        () => subdivide(triangle(), { warp: { evaluate }, tolerance: 1 }),
        () => bakeWarp(triangle(), { evaluate }),
      ])
        refuses(work, pattern)
    }
    of(
      () => undefined,
      /expected the warp's evaluate to return \{ positions, normals \}, got undefined/,
    )
    of(() => ({}), /to return positions as an array of \d+ numbers, .*, got undefined/)
    of(
      ({ positions }) => ({ positions: [...positions, 0] }),
      /to return positions as an array of \d+ numbers, .*, got an array of /,
    )
    of(
      ({ positions }) => ({ positions, normals: new BigInt64Array(positions.length) }),
      /expected the warp's evaluate to return a number as normals\[0\], got the bigint 0/,
    )
    of(
      ({ positions }) => ({ positions: [...positions].map(String) }),
      /expected the warp's evaluate to return a number as positions\[0\], got the text "0"/,
    )
    let calls = 0
    const once = ({ positions, normals }) => (calls++ ? { positions } : { positions, normals })
    refuses(
      () => subdivide(sphere(), { warp: { evaluate: once }, tolerance: 0.01 }),
      /^subdivide: expected the warp's evaluate to return normals either always or never/,
    )
  })

  test('an error of the warp is rethrown unchanged', () => {
    const warp = {
      evaluate() {
        throw new TypeError('mine')
      },
    }
    assert.throws(() => subdivide(triangle(), { warp, tolerance: 1 }), /^TypeError: mine$/)
  })
})

describe('failures of the wasm module', () => {
  test('out of memory: a message, and the next call works', () => {
    const tooMany = new Array(3 * 2 ** 29)
    for (const mesh of [
      { positions: tooMany },
      { ...triangle(), indices: new Float64Array(0), uvs: tooMany },
    ])
      refuses(() => exportGLB(mesh), /^exportGLB: there is not enough memory/)
  })

  test('a browser that refuses more memory', () => {
    const { grow } = WebAssembly.Memory.prototype
    const mesh = grid(500, 500)
    WebAssembly.Memory.prototype.grow = () => {
      throw new RangeError('no more')
    }
    try {
      refuses(
        () => subdivide(mesh, { levels: 3, maxTriangles: 2 ** 25 }),
        /^subdivide: there is not enough memory/,
      )
    } finally {
      WebAssembly.Memory.prototype.grow = grow
    }
    assert.ok(exportGLB(mesh).length > 24 * 250000)
  })

  class Liar extends Float32Array {
    get length() {
      return 9
    }
  }

  test('an uncaught C++ exception', () => {
    class Thrower extends Float32Array {
      get length() {
        throw new WebAssembly.Exception(new WebAssembly.Tag({ parameters: [] }), [])
      }
    }
    refuses(() => exportGLB({ positions: new Thrower(9) }), /^exportGLB: the mesh is too large/)
  })

  test('a trap inside a warp ends the outer call too, and does not hide an error of the warp', () => {
    const liar = { positions: new Liar(2 ** 24) }
    const outer = (evaluate) => () => subdivide(triangle(), { warp: { evaluate }, tolerance: 1 })
    const stop = () => refuses(() => exportGLB(liar), /^exportGLB: the mesh is too large/)
    refuses(
      outer(() => exportGLB(liar)),
      /^exportGLB: the mesh is too large/,
    )
    refuses(
      outer((vertices) => {
        stop()
        return twist.evaluate(vertices)
      }),
      /^subdivide: the mesh is too large/,
    )
    assert.throws(
      outer(() => {
        stop()
        throw new TypeError('mine')
      }),
      /^TypeError: mine$/,
    )
  })

  test('a write out of bounds: a message, and a new instance for the next call', () => {
    refuses(() => exportGLB({ positions: new Liar(2 ** 24) }), /^exportGLB: the mesh is too large/)
  })

  test('errors of the warp itself are rethrown, even if they look like a trap', () => {
    for (const error of [
      new WebAssembly.RuntimeError('unreachable'),
      new RangeError('mine'),
      undefined,
    ]) {
      const warp = {
        evaluate() {
          throw error
        },
      }
      let thrown = 'nothing'
      try {
        subdivide(triangle(), { warp, tolerance: 1 })
      } catch (caught) {
        thrown = caught
      }
      assert.equal(thrown, error)
    }
  })

  test('a warp that itself uses meshes', () => {
    const warp = {
      evaluate(vertices) {
        const coarse = { warp: twist, tolerance: 1, angle: 4 }
        assert.equal(subdivide(triangle(), coarse).positions.length, 9)
        return twist.evaluate(vertices)
      },
    }
    const options = { tolerance: 0.1 }
    assert.deepEqual(
      subdivide(sphere(), { ...options, warp }),
      subdivide(sphere(), { ...options, warp: twist }),
    )
  })
})

describe('hostile files', () => {
  const file = exportGLB({ ...sphere(6, 4), material })

  test('every truncation is rejected', async () => {
    for (let length = 0; length < file.length; length += length < 3000 ? 13 : 97)
      await rejects(() => loadMesh(file.slice(0, length)), /^loadMesh: /)
  })

  test('flipped bits give a mesh or a message', async () => {
    let seed = 12345
    const random = (n) => (seed = (Math.imul(seed, 1103515245) + 12345) >>> 0) % n
    let rejectedCount = 0
    for (let i = 0; i < 600; i++) {
      const broken = file.slice()
      for (let k = random(4); k >= 0; k--) broken[random(2200)] ^= 1 << random(8)
      try {
        const { positions } = await loadMesh(broken)
        assert.ok(positions.every(Number.isFinite))
      } catch (error) {
        isRight(error, /^loadMesh: /)
        rejectedCount++
      }
    }
    assert.ok(rejectedCount > 100)
  })

  test('sizes beyond the end of the file', async () => {
    const { json, chunks } = readGlb(file)
    const lie = (change) => {
      const document = structuredClone(json)
      change(document)
      return rejects(() => loadMesh(writeGlb(document, chunks[1].bytes)), /^loadMesh: /)
    }
    await lie(({ accessors }) => (accessors[0].count = 2 ** 32 - 1))
    await lie(({ accessors }) => (accessors[0].count = 2 ** 53))
    await lie(({ accessors }) => (accessors[0].byteOffset = 2 ** 31))
    await lie(({ bufferViews }) => (bufferViews[0].byteLength = 2 ** 32 - 4))
    await lie(({ bufferViews }) => (bufferViews[0].byteStride = 252))
    await lie(({ buffers }) => (buffers[0].byteLength = 4e9))
    await lie(({ nodes }) => nodes.push({ children: [0] }) && (nodes[0].children = [1]))
  })

  test('endless nesting of brackets', async () => {
    const deep = `{"asset":{"version":"2.0"},"extras":${'['.repeat(1e6)}${']'.repeat(1e6)}}`
    await rejects(() => loadMesh(new TextEncoder().encode(deep)), /^loadMesh: /)
    await rejects(() => loadMesh(writeGlb(deep)), /^loadMesh: /)
  })
})

test('all public exports', () => {
  assert.deepEqual(Object.keys(addresses).sort(), [
    'WarpError',
    'bakeWarp',
    'exportGLB',
    // Exports for the p5 addon, such as subdivideP5Model and varyGeometry.
    'fillP5Model',
    'loadMesh',
    'subdivide',
    'subdivideP5Model',
    'surfaceVariation',
    'varyGeometry',
  ])
})

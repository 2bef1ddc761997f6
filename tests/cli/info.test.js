// `npx warpjet info`.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { exportGLB } from 'warpjet/mesh'
import { failsWithError, model, works, write } from '../support/cli-tests.js'
import { readGlb, writeGlb } from '../support/glb.js'
import { packedVariants } from '../support/models/packed-variants.js'
import { shapes } from '../support/models/shapes.js'
import { textVariants } from '../support/models/text-variants.js'

describe('info', () => {
  test('escapes control characters from a model', async () => {
    const { json, chunks } = readGlb(exportGLB(model))
    json.images[0].mimeType = 'image/\x1b[2J\u009b1m\u202egpj\r\nnote'
    write('steering.glb', writeGlb(json, chunks[1].bytes))
    const { stdout } = await works('info', 'steering.glb')
    assert.match(stdout, /^texture +image\/\?\[2J\?1m\?gpj\?\?note, /m)
    const { byteOffset } = json.bufferViews[json.images[0].bufferView]
    chunks[1].bytes.set(new TextEncoder().encode('RIFF1234WEBP'), byteOffset)
    write('steering.glb', writeGlb(json, chunks[1].bytes))
    const { stderr } = await works('bake', 'steering.glb', 'named.js', '-o', 'plain.glb')
    assert.match(stderr, /^Note: The image of the base colour \(image\/\?\[2J\?1m/)
    assert.doesNotMatch(stdout + stderr, /[^\n\P{Cc}]|\p{Cf}/u)
  })

  test('describes a model', async () => {
    const { stdout } = await works('info', 'model.glb')
    assert.match(stdout, /^triangles +168$/m)
    assert.match(stdout, /^vertices +117$/m)
    assert.match(stdout, /^size +2 × 2 × 2$/m)
    assert.match(stdout, /^attributes +positions, normals, uvs, colors, tangents$/m)
    assert.match(stdout, /^base color +1, 0\.5, 0, 1$/m)
    assert.match(stdout, /^texture +image\/png, \d+ bytes$/m)
  })

  test('accepts a path with special characters of URLs', async () => {
    write('a#1?.glb', exportGLB(model))
    assert.match((await works('info', 'a#1?.glb')).stdout, /^triangles +168$/m)
  })

  test('describes models in every format, also compressed ones', async () => {
    const formats = {
      'text.stl': textVariants['a text STL'],
      'binary.stl': textVariants['a binary STL that begins with "solid"'],
      'wide.obj': textVariants['an OBJ in UTF-16, little endian'],
      'meshopt.glb': packedVariants['meshopt, vertices and triangles'],
      'draco.glb': packedVariants['Draco, edgebreaker encoding'],
    }
    for (const [name, make] of Object.entries(formats)) {
      write(name, make(shapes.cube).file)
      assert.match((await works('info', name)).stdout, /^triangles +12$/m)
    }
    await works('bake', 'draco.glb', 'wave.js', '-o', 'unpacked.glb', '--set', 'millis=100')
    assert.match((await works('info', 'unpacked.glb')).stdout, /^triangles +12$/m)
  })

  test('reports invalid files', async () => {
    await failsWithError(['info', 'wave.js'], /loadMesh: /)
    await failsWithError(['info', 'gone.glb'], /does not exist/)
  })
})

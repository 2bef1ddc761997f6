// `npx warpjet bake`.
import assert from 'node:assert/strict'
import { linkSync, mkdirSync, readFileSync, symlinkSync } from 'node:fs'
import { join } from 'node:path'
import { describe, test } from 'node:test'
import validator from 'gltf-validator'
import { compileWarp } from 'warpjet'
import { bakeWarp, exportGLB, loadMesh } from 'warpjet/mesh'
import {
  failsWithError,
  failsWithUsage,
  folder,
  material,
  model,
  works,
  write,
} from '../support/cli-tests.js'
import { readGlb, writeGlb } from '../support/glb.js'
import { readNormalMap } from '../support/normal-map.js'

describe('bake', () => {
  const load = (name) => loadMesh(join(folder, name))

  test('writes the warped model, and progress only to stderr', async () => {
    const { stdout, stderr } = await works(
      'bake',
      'model.glb',
      'wave.js',
      '-o',
      'out.glb',
      '--set',
      'millis=0.5',
    )
    assert.equal(stdout, '')
    assert.match(stderr, /^model\.glb: 168 triangles, 117 vertices\nout\.glb: [\d,]+ bytes\n$/)
    const { issues } = await validator.validateBytes(readFileSync(join(folder, 'out.glb')))
    assert.equal(issues.numErrors + issues.numWarnings, 0)
    const out = await load('out.glb')
    // p' = (x, y + x / 2, z), in float32.
    for (let i = 0; i < model.positions.length; i += 3)
      assert.ok(
        Math.abs(out.positions[i + 1] - model.positions[i + 1] - model.positions[i] / 2) < 1e-6,
      )
    assert.deepEqual(out.uvs, model.uvs)
    assert.deepEqual(out.material, model.material)
  })

  test('reverses triangles if a uniform mirrors the mesh, so that normals agree with their front sides', async () => {
    write(
      'flip.js',
      `export const uniforms = { flip: 1 }
export default ({ glsl, position, uniforms }) =>
  glsl.vec3(position.x().mult(uniforms.flip.sub(1)), 0, 0)`,
    )
    /**
     * Returns the number of triangles whose normals point to their front side, minus the number of those whose normals point to the back.
     */
    const sumOfSides = async (flip) => {
      await works('bake', 'model.glb', 'flip.js', '-o', 'flip.glb', '--set', `flip=${flip}`)
      const { positions, normals, indices } = await load('flip.glb')
      const at = (numbers, i) => [...numbers.slice(3 * i, 3 * i + 3)]
      let sum = 0
      for (let i = 0; i < indices.length; i += 3) {
        const [a, b, c] = [...indices.slice(i, i + 3)].map((k) => at(positions, k))
        const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]))
        const front = [
          u[1] * v[2] - u[2] * v[1],
          u[2] * v[0] - u[0] * v[2],
          u[0] * v[1] - u[1] * v[0],
        ]
        const [x, y, z] = at(normals, indices[i])
        sum += Math.sign(front[0] * x + front[1] * y + front[2] * z)
      }
      return sum
    }
    const before = await sumOfSides(1)
    assert.equal(Math.abs(before), 168)
    assert.equal(await sumOfSides(-1), before)
  })

  test('accepts vectors and negative numbers, and prints nothing with --quiet', async () => {
    const { stderr } = await works(
      'bake',
      'model.glb',
      'mouse.js',
      '-o',
      'moved.glb',
      '--set',
      'mouse=1,-2.5',
      '-q',
    )
    assert.equal(stderr, '')
    const out = await load('moved.glb')
    assert.ok(Math.abs(out.positions[0] - model.positions[0] - 1) < 1e-6)
    assert.ok(Math.abs(out.positions[1] - model.positions[1] + 2.5) < 1e-6)
  })

  test('uses uniforms that warp.js exports, unless --set overrides them', async () => {
    write(
      'uniforms.js',
      `export const uniforms = { center: [1, -2.5, 0], follow: () => [10, 20] }
export default ({ glsl, uniforms: { center, follow } }) => center.add(glsl.vec3(follow, 0))`,
    )
    const bake = (...rest) =>
      works('bake', 'model.glb', 'uniforms.js', '-o', 'moved.glb', '-q', ...rest)
    const firstVertex = async () => {
      const { positions } = await load('moved.glb')
      return [0, 1].map((i) => Math.round((positions[i] - model.positions[i]) * 1000) / 1000)
    }
    await bake()
    assert.deepEqual(await firstVertex(), [11, 17.5])
    await bake('--set', 'follow=0,0', '--subdivide', '0.1')
    assert.deepEqual(await firstVertex(), [1, -2.5])
    const { stdout } = await works('emit', 'uniforms.js')
    assert.match(stdout, /^\/\/ uniforms: (vec3 center, vec2 follow|vec2 follow, vec3 center)\n/)
    await failsWithError(
      ['bake', 'model.glb', 'uniforms.js', '-q', '-o', 'bad.glb', '--set', 'center=1'],
      /expected an array of 3 finite numbers for the uniform "center", got the number 1/,
    )
    write('wrong.js', 'export const uniforms = { a: "red" }\nexport default () => undefined')
    await failsWithError(
      ['emit', 'wrong.js'],
      /expected .* for the uniform "a", got the text "red"/,
    )
  })

  test('subdivides with --subdivide, up to --max-triangles', async () => {
    const args = ['bake', 'model.glb', 'named.js', '-o', 'fine.glb', '--subdivide', '0.001']
    const { stderr } = await works(...args)
    assert.match(stderr, /\nSubdivided: [\d,]+ triangles/)
    assert.ok((await load('fine.glb')).indices.length > 2 * model.indices.length)
    const limited = await works(...args, '--max-triangles', '300')
    assert.match(
      limited.stderr,
      /\nNote: With 300 triangles the warped surface is still up to [\d.]+ away from them, above the tolerance of 0\.001; raise maxTriangles/,
    )
    assert.ok((await load('fine.glb')).indices.length <= 3 * 300)
  })

  test('--normal-map writes a normal map into the file', async () => {
    const { stderr } = await works(
      ...['bake', 'model.glb', 'wave.js', '-o', 'map.glb', '--set', 'millis=0.5'],
      ...['--normal-map', '64', '--subdivide', '0.1'],
    )
    assert.match(stderr, /\nSubdivided: .*\nNormal map: 64 × 64\nmap\.glb: [\d,]+ bytes\n$/)
    const glb = readFileSync(join(folder, 'map.glb'))
    const { issues } = await validator.validateBytes(glb)
    assert.deepEqual(issues.messages, [])
    const { image, TANGENT } = readNormalMap(new Uint8Array(glb))
    assert.equal(image.width, 64)
    assert.ok(TANGENT.length > 0)
    const bake = ['bake', 'model.glb', 'named.js', '-o', 'map.glb']
    await failsWithUsage(
      [...bake, '--normal-map', '0'],
      /expected a whole number from 1 to 8192 .*--normal-map/,
    )
    await failsWithUsage(
      [...bake, '--normal-map', '8', '--frames', 'x'],
      /'normalized' or 'mikktspace'.*--frames/,
    )
    await failsWithUsage([...bake, '--frames', 'mikktspace'], /--frames needs --normal-map/)
    write('bare.glb', exportGLB({ ...model, uvs: undefined, material: undefined }))
    await failsWithError(
      ['bake', 'bare.glb', 'named.js', '-q', '-o', 'map.glb', '--normal-map', '64'],
      /bakeNormalMap: the mesh has no uvs/,
    )
  })

  test('omits an image that a GLB cannot contain, with a warning', async () => {
    const { json, chunks } = readGlb(exportGLB(model))
    json.images[0].mimeType = 'image/webp'
    const { byteOffset } = json.bufferViews[json.images[0].bufferView]
    chunks[1].bytes.set(new TextEncoder().encode('RIFF1234WEBP'), byteOffset)
    write('webp.glb', writeGlb(json, chunks[1].bytes))
    const { stderr } = await works('bake', 'webp.glb', 'named.js', '-o', 'plain.glb')
    assert.match(
      stderr,
      /^Note: The image .*\(image\/webp\) is neither PNG nor JPEG; it is left out/,
    )
    assert.deepEqual((await load('plain.glb')).material, { baseColor: material.baseColor })
  })

  test('never overwrites its input, through any link', async () => {
    const before = readFileSync(join(folder, 'model.glb'))
    symlinkSync('model.glb', join(folder, 'symbolic.glb'))
    linkSync(join(folder, 'model.glb'), join(folder, 'hard.glb'))
    for (const link of ['symbolic.glb', 'hard.glb'])
      await failsWithUsage(
        ['bake', 'model.glb', 'named.js', '-o', link],
        /does not overwrite the model/,
      )
    assert.deepEqual(readFileSync(join(folder, 'model.glb')), before)
    symlinkSync('named.js', join(folder, 'linked.js'))
    await failsWithUsage(['emit', 'named.js', '-o', 'linked.js'], /does not overwrite the warp/)
  })

  test('reports invalid files and warps', async () => {
    write('text.glb', 'no model')
    write(
      'pole.js',
      'export default ({ glsl, position }) => glsl.vec3(glsl.div(1, position.x()), 0, 0)',
    )
    mkdirSync(join(folder, 'folder.glb'))
    const bakeArguments = (model, warp, ...rest) => [
      'bake',
      model,
      warp,
      '-q',
      '-o',
      'bad.glb',
      ...rest,
    ]
    await failsWithError(
      bakeArguments('model.glb', 'wave.js'),
      /wave\.js reads millis; add --set millis=<number>\. Warps that read an image can only be evaluated on a GPU\./,
    )
    await failsWithError(
      bakeArguments('model.glb', 'wave.js', '--set', 'millis=1', '--set', 'milis=1'),
      /no uniform "milis"/,
    )
    await failsWithError(
      bakeArguments('model.glb', 'mouse.js', '--set', 'mouse=1'),
      /expected an array of 2 finite numbers for the uniform "mouse"/,
    )
    await failsWithError(
      bakeArguments('gone.glb', 'named.js'),
      /loadMesh: the file .*gone\.glb does not exist/,
    )
    await failsWithError(
      bakeArguments('model.glb', 'pole.js'),
      /bakeWarp: expected a finite position of vertex 0 at \(0, 1, 0\), got/,
    )
    await failsWithError(bakeArguments('text.glb', 'named.js'), /loadMesh: /)
    await failsWithError(bakeArguments('model.glb', 'gone.js'), /gone\.js does not exist/)
    await failsWithError(
      ['bake', 'model.glb', 'named.js', '-q', '-o', 'folder.glb'],
      /folder\.glb cannot be written/,
    )
    assert.throws(() => readFileSync(join(folder, 'bad.glb')), /ENOENT/)
  })
})

test('bakes an offset along the normal with the gradients of the normal; emit --surface-variation declares them as attributes', async () => {
  const { stderr } = await works('bake', 'model.glb', 'bumps.js', '-o', 'bumps.glb')
  assert.doesNotMatch(stderr, /constant/)
  const { default: bumps } = await import(join(folder, 'bumps.js'))
  const warp = compileWarp(bumps, { surfaceVariation: true })
  const loaded = await loadMesh(join(folder, 'model.glb'))
  const baked = await loadMesh(join(folder, 'bumps.glb'))
  assert.deepEqual(baked.normals, (await loadMesh(exportGLB(bakeWarp(loaded, warp)))).normals)
  const { stdout } = await works('emit', 'bumps.js', '--surface-variation')
  assert.match(
    stdout,
    /attributes: vec3 position, vec3 normal, vec3 normalXGradient, vec3 normalYGradient, vec3 normalZGradient/,
  )
})

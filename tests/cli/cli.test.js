// `npx warpjet`, started like from a shell.
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import {
  existsSync,
  linkSync,
  mkdirSync,
  mkdtempSync,
  openSync,
  readFileSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, describe, test } from 'node:test'
import { fileURLToPath } from 'node:url'
import validator from 'gltf-validator'
import { compileWarp, targets, version } from 'warpjet'
import { differentiate } from 'warpjet/glsl'
import { bakeWarp, exportGLB, loadMesh } from 'warpjet/mesh'
import { packedVariants } from '../support/models/packed-variants.js'
import { shapes } from '../support/models/shapes.js'
import { textVariants } from '../support/models/text-variants.js'
import { readGlb, writeGlb } from '../support/glb.js'
import { sphere } from '../support/meshes.js'
import { png } from '../support/png.js'

const program = fileURLToPath(new URL('../../dist/cli.js', import.meta.url))
const folder = mkdtempSync(join(tmpdir(), 'warpjet cli '))
after(() => rmSync(folder, { recursive: true }))

const write = (name, contents) => writeFileSync(join(folder, name), contents)
write('package.json', '{ "type": "module" }')
write(
  'wave.js',
  'export default ({ glsl, position, millis }) => glsl.vec3(0, position.x().mult(millis), 0)',
)
write(
  'named.js',
  'export const speed = 2\nexport function bend({ glsl, position }) { return glsl.vec3(position.y().sin(), 0, 0) }',
)
write(
  'bumps.js',
  'export default ({ normal, position }) => normal.mult(position.x().mult(5).sin().mult(0.1))',
)
write('mouse.js', 'export default ({ glsl, mouse }) => glsl.vec3(mouse, 0)')
const material = {
  baseColor: [1, 0.5, 0, 1],
  baseColorTexture: { bytes: png(2, 2, () => [9, 9, 9]), mimeType: 'image/png' },
}
const model = { ...sphere(), material }
write('model.glb', exportGLB(model))

/** Starts the program in the folder; returns its exit code and output. */
function warpjet(...args) {
  const child = spawn(process.execPath, [program, ...args], { cwd: folder })
  const result = { stdout: '', stderr: '' }
  for (const stream of ['stdout', 'stderr'])
    child[stream].setEncoding('utf8').on('data', (text) => (result[stream] += text))
  return new Promise((resolve) => child.on('close', (code) => resolve({ code, ...result })))
}

/** Checks the exit code, an empty stdout, and one message on stderr. */
async function fails(code, args, pattern) {
  const result = await warpjet(...args)
  assert.equal(result.stdout, '')
  assert.match(result.stderr, pattern)
  assert.equal(result.stderr.trim().split('\n').length, 1, result.stderr)
  assert.match(result.stderr, /^warpjet: /)
  assert.equal(result.code, code, result.stderr)
}

const usage = (args, pattern) => fails(2, args, pattern)
const refuses = (args, pattern) => fails(1, args, pattern)

async function works(...args) {
  const result = await warpjet(...args)
  assert.equal(result.code, 0, result.stderr)
  return result
}

describe('the program', () => {
  test('--version and --help', async () => {
    assert.equal((await works('--version')).stdout, `${version}\n`)
    const { stdout } = await works('--help')
    for (const command of ['emit', 'bake', 'info'])
      assert.match(stdout, new RegExp(`npx warpjet ${command} `))
    for (const command of ['emit', 'bake', 'info'])
      assert.match((await works(command, '--help')).stdout, new RegExp(`^npx warpjet ${command} <`))
    for (const option of ['--output', '--set', '--subdivide', '--max-triangles', '--quiet'])
      assert.match((await works('bake', '-h')).stdout, new RegExp(option))
  })

  test('wrong usage exits with 2', async () => {
    await usage([], /A command is missing\. `npx warpjet --help` shows how/)
    await usage(['bend'], /no command "bend"/)
    await usage(['toString'], /no command "toString"/)
    await usage(['emit'], /emit needs a warp\.js or a file of GLSL\. `npx warpjet emit --help`/)
    await usage(['emit', 'wave.js', 'named.js'], /nothing more, got "named\.js"/)
    await usage(
      ['emit', 'wave.js', '--target', 'hlsl'],
      /emit: expected 'glsl300', 'glsl100' or 'wgsl' for --target, got the text "hlsl"/,
    )
    await usage(['emit', 'wave.js', '--speed', '2'], /emit: Unknown option '--speed'/)
    await usage(['info'], /info needs a model/)
    await usage(['bake', 'model.glb'], /bake needs a warp\.js/)
    await usage(['bake', 'model.glb', 'wave.js'], /bake needs -o/)
    await usage(
      ['bake', 'model.glb', 'wave.js', '-o', 'out.obj'],
      /bake: expected a \.glb file for -o, got "out\.obj"/,
    )
    await usage(
      ['bake', 'model.glb', 'wave.js', '-o', './model.glb'],
      /does not overwrite the model/,
    )
    for (const setting of ['millis', 'millis=', 'millis=x', '=1', 'mouse=1,'])
      await usage(
        ['bake', 'model.glb', 'wave.js', '-o', 'o.glb', '--set', setting],
        /bake: expected a name and numbers, as in --set millis=1200, for --set, got the text /,
      )
    for (const tolerance of ['0', 'x', '', 'Infinity'])
      await usage(
        ['bake', 'model.glb', 'wave.js', '-o', 'o.glb', '--subdivide', tolerance],
        /bake: expected a number above 0 for --subdivide, got /,
      )
    const bakeWithLimit = (most) => [...bakeArguments, '--subdivide', '1', '--max-triangles', most]
    const bakeArguments = ['bake', 'model.glb', 'named.js', '-o', 'o.glb']
    for (const most of ['1.5', String(2 ** 28 + 1), '1e20'])
      await usage(
        bakeWithLimit(most),
        /bake: expected a whole number from 1 to 268,435,456 for --max-triangles, got /,
      )
    for (const most of ['0', '-1', 'x'])
      await usage(
        bakeWithLimit(most),
        /expected a whole number from 1 to .* for --max-triangles, got |ambiguous/,
      )
    await usage([...bakeArguments, '--max-triangles', '9'], /--max-triangles needs --subdivide/)
  })
})

describe('how it exits', () => {
  /** Returns whether it exits by itself, soon. */
  async function exitsBySelf(args, prepare = () => {}) {
    const child = spawn(process.execPath, args, { cwd: folder, timeout: 20_000 })
    let stderr = ''
    child.stderr.setEncoding('utf8').on('data', (text) => (stderr += text))
    prepare(child)
    const [code, signal] = await new Promise((resolve) =>
      child.on('close', (...ends) => resolve(ends)),
    )
    assert.equal(signal, null)
    return { code, stderr }
  }

  test('a reader may close its output', async () => {
    const leave = ({ stdout }) => stdout.destroy()
    assert.deepEqual(await exitsBySelf([program, 'emit', 'named.js'], leave), {
      code: 0,
      stderr: '',
    })
  })

  test('it does not wait for a timer of warp.js', async () => {
    write('timer.js', 'setInterval(() => {}, 1000)\nexport { bend } from "./named.js"')
    const { code } = await exitsBySelf([program, 'emit', 'timer.js'], ({ stdout }) =>
      stdout.resume(),
    )
    assert.equal(code, 0)
  })

  const full = '/dev/full'
  test('a full disk gives one message', { skip: !existsSync(full) }, async () => {
    const stdio = ['ignore', openSync(full, 'w'), 'pipe']
    const child = spawn(process.execPath, [program, 'emit', 'named.js'], { cwd: folder, stdio })
    let stderr = ''
    child.stderr.setEncoding('utf8').on('data', (text) => (stderr += text))
    const code = await new Promise((resolve) => child.on('close', resolve))
    assert.equal(stderr, 'warpjet: the output cannot be written: the disk is full.\n')
    assert.equal(code, 1)
  })

  test('a warp.js that never resolves gives one message', async () => {
    write('waits.js', 'await new Promise(() => {})\nexport { bend } from "./named.js"')
    await refuses(['emit', 'waits.js'], /waits\.js never finishes loading: its top-level await/)
  })

  test('an error clears the unfinished line', async () => {
    const terminal = 'data:text/javascript,process.stderr.isTTY = true'
    const { code, stderr } = await exitsBySelf([
      ...['--import', terminal, program, 'bake', 'model.glb', 'named.js'],
      ...['-o', 'o.glb', '--subdivide', '0.1', '--set', 'speed=1'],
    ])
    assert.equal(code, 1)
    assert.match(stderr, /Subdividing: [^\n]*tried\r\x1b\[Kwarpjet: .*no uniform "speed"[^\n]*\n$/)
  })
})

describe('emit', () => {
  test('prints the result of compileWarp, in every language', async () => {
    const { default: offset } = await import(join(folder, 'wave.js'))
    for (const target of targets) {
      const { stdout, stderr } = await works('emit', 'wave.js', '--target', target)
      assert.equal(stderr, '')
      const lines = stdout.split('\n')
      assert.deepEqual(lines.slice(0, 2), [
        '// uniforms: float millis',
        '// attributes: vec3 position, vec3 normal',
      ])
      assert.equal(lines.slice(2).join('\n').trim(), compileWarp(offset, { target }).code.trim())
    }
  })

  test('glsl300 by default; the only exported function of a file; into a file', async () => {
    const { bend } = await import(join(folder, 'named.js'))
    const { stdout } = await works('emit', 'named.js')
    assert.ok(stdout.includes(compileWarp(bend).code.trim()))
    assert.equal((await works('emit', 'named.js', '-o', 'named.glsl')).stdout, '')
    assert.equal(readFileSync(join(folder, 'named.glsl'), 'utf8'), stdout)
    assert.match((await works('emit', 'named.js', '--tangents')).stdout, /warpedTangent/)
  })

  test('invalid warps', async () => {
    write('none.js', 'export const x = 1')
    write('two.js', 'export const a = () => 1, b = () => 2')
    write('broken.js', 'export default ({ glsl }) => {')
    write('throws.js', 'throw new Error("no\\nway")')
    write('undefined.js', 'export default () => undefined')
    write(
      'typo.js',
      'export default ({ glsl, position }) =>\n  glsl.vec3(position.x().sine(), 0, 0)',
    )
    write('imports.js', 'import "./gone.js"\nexport default () => 1')
    await refuses(['emit', 'gone.js'], /The file gone\.js does not exist/)
    await refuses(['emit', 'none.js'], /none\.js exports no function/)
    await refuses(['emit', 'two.js'], /two\.js exports 2 functions/)
    await refuses(['emit', 'broken.js'], /broken\.js cannot be run: SyntaxError/)
    await refuses(['emit', 'throws.js'], /throws\.js cannot be run: Error: no/)
    await refuses(['emit', 'undefined.js'], /must return a vec3/)
    await refuses(['emit', 'typo.js'], /sine: .*did you mean sin\? \(typo\.js, line 2\)/)
    write('own.js', 'export default () =>\n  nothing.at.all')
    await refuses(['emit', 'own.js'], /own\.js: ReferenceError: nothing .* \(line 2\)/)
    write('null.js', 'throw null')
    write('text.js', 'export default () => { throw "no" }')
    await refuses(['emit', 'null.js'], /null\.js cannot be run: it throws null\./)
    await refuses(['emit', 'text.js'], /text\.js throws the text "no"\./)
    await refuses(['emit', 'imports.js'], /imports\.js cannot be run: .*gone\.js/)
    await refuses(
      ['emit', 'wave.js', '-o', 'no/such/folder.glsl'],
      /cannot be written: the folder does not exist/,
    )
  })
})

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

  test('a mirror, by a uniform: reverses triangles too, so that normals agree with their fronts', async () => {
    write(
      'flip.js',
      `export const uniforms = { flip: 1 }
export default ({ glsl, position, uniforms }) =>
  glsl.vec3(position.x().mult(uniforms.flip.sub(1)), 0, 0)`,
    )
    const countAgreeing = async (flip) => {
      await works('bake', 'model.glb', 'flip.js', '-o', 'flip.glb', '--set', `flip=${flip}`)
      const { positions, normals, indices } = await load('flip.glb')
      const at = (numbers, i) => [...numbers.slice(3 * i, 3 * i + 3)]
      let count = 0
      for (let i = 0; i < indices.length; i += 3) {
        const [a, b, c] = [...indices.slice(i, i + 3)].map((k) => at(positions, k))
        const [u, v] = [b, c].map((p) => p.map((x, k) => x - a[k]))
        const front = [
          u[1] * v[2] - u[2] * v[1],
          u[2] * v[0] - u[0] * v[2],
          u[0] * v[1] - u[1] * v[0],
        ]
        const [x, y, z] = at(normals, indices[i])
        count += Math.sign(front[0] * x + front[1] * y + front[2] * z)
      }
      return count
    }
    const before = await countAgreeing(1)
    assert.equal(Math.abs(before), 168)
    assert.equal(await countAgreeing(-1), before)
  })

  test('vectors, negative numbers; --quiet', async () => {
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

  test('uniforms that warp.js exports, overridden by --set', async () => {
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
    await refuses(
      ['bake', 'model.glb', 'uniforms.js', '-q', '-o', 'bad.glb', '--set', 'center=1'],
      /expected an array of 3 finite numbers for the uniform "center", got the number 1/,
    )
    write('wrong.js', 'export const uniforms = { a: "red" }\nexport default () => undefined')
    await refuses(['emit', 'wrong.js'], /expected .* for the uniform "a", got the text "red"/)
  })

  test('--subdivide makes more triangles, up to --max-triangles', async () => {
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

  test('an image that a GLB may not have is left out, with a warning', async () => {
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
      await usage(['bake', 'model.glb', 'named.js', '-o', link], /does not overwrite the model/)
    assert.deepEqual(readFileSync(join(folder, 'model.glb')), before)
    symlinkSync('named.js', join(folder, 'linked.js'))
    await usage(['emit', 'named.js', '-o', 'linked.js'], /does not overwrite the warp/)
  })

  test('mistakes in files and warps', async () => {
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
    await refuses(
      bakeArguments('model.glb', 'wave.js'),
      /wave\.js reads millis; add --set millis=<number>; if it is an image, only a GPU can run this warp\./,
    )
    await refuses(
      bakeArguments('model.glb', 'wave.js', '--set', 'millis=1', '--set', 'milis=1'),
      /no uniform "milis"/,
    )
    await refuses(
      bakeArguments('model.glb', 'mouse.js', '--set', 'mouse=1'),
      /expected an array of 2 finite numbers for the uniform "mouse"/,
    )
    await refuses(
      bakeArguments('gone.glb', 'named.js'),
      /loadMesh: the file .*gone\.glb does not exist/,
    )
    await refuses(
      bakeArguments('model.glb', 'pole.js'),
      /bakeWarp: expected a finite position of vertex 0 at \(0, 1, 0\), got/,
    )
    await refuses(bakeArguments('text.glb', 'named.js'), /loadMesh: /)
    await refuses(bakeArguments('model.glb', 'gone.js'), /gone\.js does not exist/)
    await refuses(
      ['bake', 'model.glb', 'named.js', '-q', '-o', 'folder.glb'],
      /folder\.glb cannot be written/,
    )
    assert.throws(() => readFileSync(join(folder, 'bad.glb')), /ENOENT/)
  })
})

describe('info', () => {
  test('shows nothing of a model that could control a terminal', async () => {
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

  test('a path with special characters of URLs', async () => {
    write('a#1?.glb', exportGLB(model))
    assert.match((await works('info', 'a#1?.glb')).stdout, /^triangles +168$/m)
  })

  test('models in every format, also compressed', async () => {
    const formats = {
      'text.stl': textVariants['a text STL'],
      'binary.stl': textVariants['a binary STL that begins with "solid"'],
      'wide.obj': textVariants['an OBJ in UTF-16, little endian'],
      'meshopt.glb': packedVariants['meshopt, vertices and triangles'],
      'draco.glb': packedVariants['Draco, edge breaker'],
    }
    for (const [name, make] of Object.entries(formats)) {
      write(name, make(shapes.cube).file)
      assert.match((await works('info', name)).stdout, /^triangles +12$/m)
    }
    await works('bake', 'draco.glb', 'wave.js', '-o', 'unpacked.glb', '--set', 'millis=100')
    assert.match((await works('info', 'unpacked.glb')).stdout, /^triangles +12$/m)
  })

  test('invalid files', async () => {
    await refuses(['info', 'wave.js'], /loadMesh: /)
    await refuses(['info', 'gone.glb'], /does not exist/)
  })
})

test('a warp along the normal is baked with the gradients of the normal, and its code reads these on request', async () => {
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

describe('GLSL on the command line', () => {
  write(
    'waves.glsl',
    `uniform float height;
vec3 offset(vec3 position) { return vec3(0.0, height * sin(position.x), 0.0); }
vec3 up(vec3 p) { return p + vec3(0.0, 1.0, 0.0); }
float map(vec3 p) { return dot(p, p); }
`,
  )
  write(
    'uniforms.glsl',
    `#version 300 es
struct Wave { float length; };
uniform float height, heights[2];
uniform vec3 way;
uniform int many;
uniform uint bits;
uniform bool isOn;
uniform mat2 turn;
uniform Wave waves[1];
vec3 offset(vec3 position, float millis) {
  vec3 p = vec3(height * sin(position.x * waves[0].length), heights[1] * position.y, float(bits & 4u));
  return p + way + vec3(turn * position.xy, 0.0) + vec3(0, many / 2, isOn ? millis / 1000.0 : 0.0) + vec3(0, 0, 10);
}
`,
  )
  write(
    'spiral.glsl',
    `vec2 spiral(vec2 p, float t, int n, bool isOn) {
  vec2 q = p;
  for (int i = 0; i < n; i++) q += sin(q.yx * t);
  return isOn ? q : p * t;
}
`,
  )
  write('bad.frag', 'vec3 offset(vec3 p) {\n  return q;\n}\n')

  test('emit accepts it instead of a warp.js', async () => {
    const { code, stdout } = await warpjet('emit', 'waves.glsl', '--target', 'wgsl')
    assert.equal(code, 0)
    assert.match(stdout, /uniforms: float height/)
    assert.match(stdout, /offset = vec3f\(0\.0f, height \* sin\(position\.x\), 0\.0f\);/)
  })

  test('bake too, with any of its functions', async () => {
    const args = ['--function', 'up', '--returns', 'position', '-o', 'up.glb']
    const { code, stderr } = await warpjet('bake', 'model.glb', 'waves.glsl', ...args)
    assert.equal(code, 0, stderr)
    const [before, after] = await Promise.all(
      ['model.glb', 'up.glb'].map((file) => loadMesh(join(folder, file))),
    )
    assert.ok(Math.abs(after.positions[1] - before.positions[1] - 1) < 1e-6)
    assert.equal(after.positions[0], before.positions[0])
    const missing = await warpjet(
      'bake',
      'model.glb',
      'waves.glsl',
      '-o',
      'up.glb',
      '--function',
      'offset',
    )
    assert.equal(missing.code, 1)
    assert.match(missing.stderr, /reads height; add --set height=/)
  })

  test('bake moves positions by the uniforms of --set, of every type', async () => {
    const settings = ['height=0.25', 'way=1,2,3', 'many=-3', 'bits=5', 'isOn=1', 'turn=0,1,-1,0']
    const others = ['heights[1]=0.5', 'waves[0].length=2', 'millis=2000']
    const all = [...settings, ...others]
    const setting = (list) => list.flatMap((each) => ['--set', each])
    const set = setting(all)
    const result = await works('bake', 'model.glb', 'uniforms.glsl', ...set, '-o', 'set.glb')
    assert.equal(result.code, 0, result.stderr)
    const [before, after] = await Promise.all(
      ['model.glb', 'set.glb'].map((file) => loadMesh(join(folder, file))),
    )
    for (let i = 0; i < before.positions.length; i += 3) {
      const [x, y, z] = before.positions.subarray(i, i + 3)
      // By a quarter turn, (x, y) maps to (-y, x).
      const expected = [
        x + 0.25 * Math.sin(x * 2) + 1 - y,
        y + 0.5 * y + 2 + x - 1,
        z + 3 + (5 & 4) + 2 + 10,
      ]
      expected.forEach((number, k) =>
        assert.ok(Math.abs(after.positions[i + k] - number) < 1e-5, `${number} at ${i}`),
      )
    }
    const missing = await warpjet('bake', 'model.glb', 'uniforms.glsl', '-o', 'set.glb')
    assert.match(missing.stderr, /uniforms\.glsl reads \w+; add --set \w+=<number>/)
    const rest = setting(all.filter((each) => !each.startsWith('many')))
    const whole = await warpjet('bake', 'model.glb', 'uniforms.glsl', ...rest, '-o', 'set.glb')
    assert.match(whole.stderr, /uniforms\.glsl reads many; add --set many=/)
    const wrong = await warpjet(
      'bake',
      'model.glb',
      'uniforms.glsl',
      ...set,
      '--set',
      'way=1',
      '-o',
      'set.glb',
    )
    assert.match(
      wrong.stderr,
      /the uniform way: expected a vec3, as declared in the source, got a single number/,
    )
  })

  test('derive prints a function with its gradient', async () => {
    const { code, stdout } = await warpjet('derive', 'waves.glsl', '--function', 'map', '--by', 'p')
    assert.equal(code, 0)
    assert.match(stdout, /^vec4 mapGradient\(vec3 p\) \{/)
  })

  test('derive prints the result of differentiate, with each of its options, or writes it', async () => {
    const source = readFileSync(join(folder, 'spiral.glsl'), 'utf8')
    const expected = differentiate(source, {
      function: 'spiral',
      by: 't',
      target: 'wgsl',
      name: 'along',
      maxIterations: 5,
    })
    const args = ['--function', 'spiral', '--by', 't', '--target', 'wgsl', '--name', 'along']
    const { stdout } = await works('derive', 'spiral.glsl', ...args, '--max-iterations', '5')
    assert.equal(stdout, expected)
    assert.match(stdout, /^fn along\(p: vec2f, t: f32, n: i32, isOn: bool\) -> vec2f \{/)
    const written = await works(
      'derive',
      'spiral.glsl',
      '--max-iterations',
      '5',
      '-o',
      'jacobian.glsl',
    )
    assert.equal(written.stdout, '')
    assert.equal(
      readFileSync(join(folder, 'jacobian.glsl'), 'utf8'),
      differentiate(source, { maxIterations: 5 }),
    )
    const wrong = await warpjet('derive', 'spiral.glsl', '--by', 'q')
    assert.equal(wrong.code, 1)
    assert.match(
      wrong.stderr,
      /expected a parameter of spiral, one of p, t, n, isOn, for --by, got the text "q"/,
    )
  })

  test('mistakes in it are reported with the line', async () => {
    const { code, stderr } = await warpjet('emit', 'bad.frag')
    assert.equal(code, 1)
    assert.match(stderr, /line 2, column 10: "q" is not declared/)
    assert.equal((await warpjet('emit', 'none.glsl')).code, 1)
    assert.equal((await warpjet('derive', 'waves.glsl', '--target', 'msl')).code, 2)
  })
})

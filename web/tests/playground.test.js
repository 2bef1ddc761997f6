// Tests the parts of the playground that need no browser.
import assert from 'node:assert/strict'
import { describe, test } from 'node:test'
import { compileWarp } from '../../dist/warpjet.js'
import { convert } from '../playground/convert.js'
import { escapeForScript } from '../playground/document.js'
import { guardLoops } from '../playground/guard.js'
import { fragmentOf, holdsSketch, sketchOf } from '../playground/link.js'
import { evaluatedOf, maskOf, readMessage, shapesOf } from '../playground/messages.js'
import { modulesAsData } from '../playground/modules.js'
import { completeSketch } from '../playground/offset.js'
import { removeOrigins, withOrigins } from '../playground/origins.js'
import { columns, normalErrors, rows, spherePoints } from '../playground/sphere.js'
import { namesOfFiles, quote, replaceFileNames, stringsIn } from '../playground/strings.js'
import { zip } from '../playground/zip.js'

describe('a sketch converted for another p5', () => {
  const sketch = `let hand, warp

async function setup() {
  createCanvas(640, 480, WEBGL)
  hand = await loadModel('hand.obj')
  warp = createWarp(() => 0)
}

function draw() {}
`
  test('awaits its canvas on WEBGPU', () => {
    const plain = 'function setup() {\n  createCanvas(9, 9, WEBGL)\n}\n'
    const converted = convert(plain, 'p5-webgpu')
    assert.equal(converted, 'async function setup() {\n  await createCanvas(9, 9, WEBGPU)\n}\n')
    assert.equal(convert(converted, 'p5'), plain)
  })

  test('loads in preload in p5 1.11, and converts back', () => {
    const converted = convert(sketch, 'p5-1')
    assert.match(converted, /function preload\(\) \{\n  hand = loadModel\('hand\.obj'\)\n\}/)
    assert.match(converted, /\nfunction setup\(\) \{\n  createCanvas/)
    assert.doesNotMatch(converted, /await/)
    const back = convert(converted, 'p5')
    assert.match(back, /async function setup\(\) \{\n  hand = await loadModel\('hand\.obj'\)\n/)
    assert.doesNotMatch(back, /preload/)
  })

  test('declares local variables of setup as globals if preload needs them', () => {
    const converted = convert(sketch.replace('hand = await', 'const font = await'), 'p5-1')
    assert.match(converted, /^let font\nfunction preload\(\) \{\n  font = /m)
  })

  test('is unchanged if there is nothing to convert', () => {
    for (const host of ['p5', 'p5-1', 'p5-webgpu']) assert.equal(convert('let x', host), 'let x')
  })
})

describe('a link', () => {
  test('restores the sketch, with any characters', async () => {
    const sketch = { text: `sphere(${'9'.repeat(999)}) // ä ≠ 🌸 “”`, host: 'p5', chosen: ['glsl'] }
    const fragment = await fragmentOf(sketch)
    assert.match(fragment, /^#sketch=[\w-]+$/)
    assert.ok(fragment.length < 300)
    assert.ok(holdsSketch(fragment))
    assert.deepEqual(await sketchOf(fragment), sketch)
  })

  test('that would fill the memory is rejected', async () => {
    const bomb = await fragmentOf({ text: ' '.repeat(300_000_000) })
    assert.ok(bomb.length < 500_000)
    const before = process.memoryUsage().arrayBuffers
    await assert.rejects(sketchOf(bomb), /too large: expected at most 1 MB/)
    assert.ok(process.memoryUsage().arrayBuffers - before < 50_000_000)
    await assert.rejects(sketchOf(`#sketch=${'A'.repeat(3_000_000)}`), /too large/)
  })

  test('keeps only values of the expected type', async () => {
    const odd = { text: 'a', host: 7, chosen: 'glsl', model: {}, values: 3, more: 1 }
    assert.deepEqual(await sketchOf(await fragmentOf(odd)), { text: 'a' })
  })

  test('that is cut off or contains something else gives a message', async () => {
    const fragment = await fragmentOf({ text: 'sphere()' })
    for (const broken of [fragment.slice(0, -4), '#sketch=%%%', '#sketch='])
      await assert.rejects(sketchOf(broken), /damaged: copy the whole link once more\.$/)
    const other = await fragmentOf([1])
    await assert.rejects(sketchOf(other), /no sketch in this link/)
  })
})

describe('a loop in a sketch', () => {
  const countIterations = (text) => {
    const playground = {
      count: 0,
      checkLoop() {
        if (++this.count === 50) throw new Error('stopped')
      },
    }
    new Function('playground', guardLoops({ text }))(playground)
    return playground.count
  }

  test('that never ends is stopped, however it is written', () => {
    for (const text of [
      'while (true) {}',
      'for (;;);',
      'do ; while (1)',
      'let i = 0; while (1) i++',
      'for (;;) if (0) 1; else 2',
      'const run = () => { for (;;) {} }\nrun()',
    ])
      assert.throws(() => countIterations(text), /stopped/, text)
  })

  test('that ends works as before', () => {
    const text =
      'let sum = 0; for (let i = 0; i < 4; i++) if (i % 2) sum += i; else for (const j of [1, 2]) sum += j'
    assert.equal(countIterations(`${text}; if (sum !== 10) throw new Error(sum)`), 8)
  })

  test('stays on its line, and is unchanged in functions that warpjet or p5.strands may parse', () => {
    const text = 'while (a) {\n  b()\n}\nfor (;;) c()\n'
    assert.equal(guardLoops({ text }).split('\n').length, text.split('\n').length)
    for (const unchanged of ['createWarp(() => { for (;;) {} })', 'while (', 'for (;;'])
      assert.equal(guardLoops({ text: unchanged }), unchanged)
    assert.equal(guardLoops({ text, chosen: ['operators'] }), text)
  })
})

test('text in a script tag cannot end it', () => {
  const text = "const a = '</script><!-- <script>', b = 1 < 2"
  const inside = escapeForScript(text)
  assert.doesNotMatch(inside, /<\/script|<!--|<script/i)
  assert.equal(new Function(`${inside}; return a`)(), new Function(`${text}; return a`)())
})

test('text in a script tag keeps its meaning, in strings and outside of strings', () => {
  for (const [text, isModule] of [
    ['const scripts = [1, 2]; let a = 0; while (a<scripts.length) a++; return a'],
    [
      "const a = '\\</script>', b = `<!-- ${'</script'}`, c = /<\\/script>|[</script]/.test('<'); return a + b + c",
    ],
    ['const script = /x/; return 1</script/.test("x")'],
    ['const b = 0; return 1<!--b', true],
    ['/* </script> <!-- */ return 1 // </script>'],
    ['return String.raw`</script>\\n<!--`'],
    ['return 1 + 1 <!-- </script> the rest of the line is a comment\n'],
  ]) {
    const inside = escapeForScript(text, { isModule })
    assert.doesNotMatch(inside, /<\/script|<!--/i)
    // `new Function` makes classic scripts, where `<!--` begins a comment.
    const equivalent = isModule ? text.replace('<!--', '< !--') : text
    const run = (body) => new Function(isModule ? body.replace('const', 'let') : body)()
    assert.equal(run(inside), run(equivalent), text)
  }
})

describe('the strings of a sketch', () => {
  const nasty = `Bob's "cat" \\ </script> --> 100% \u2028 \n ä🌸.glb`

  test('are parsed as in JavaScript', () => {
    const text = `f('a\\'b.obj', "\\x41\\u0042\\u{43}.obj", \`d.obj\`, \`\${e}.obj\`) // 'g.obj'`
    assert.deepEqual(
      stringsIn(text).map(({ value }) => value),
      ["a'b.obj", 'ABC.obj', 'd.obj'],
    )
    assert.deepEqual(namesOfFiles(text), ["a'b.obj", 'ABC.obj', 'd.obj'])
  })

  test('can contain any file name', () => {
    assert.equal(new Function(`return ${quote(nasty)}`)(), nasty)
    assert.deepEqual(
      stringsIn(`f(${quote(nasty)})`).map(({ value }) => value),
      [nasty],
    )
    const { text } = completeSketch({ text: 'function offset() {}', host: 'offset', model: nasty })
    assert.ok(stringsIn(text).some(({ value }) => value === nasty))
    new Function(text)
  })

  test('are replaced where they name files', () => {
    const text = 'load("a.obj", "b.obj", "c")'
    assert.equal(
      replaceFileNames(text, (name) => name.replace('b.', "it's.")),
      `load("a.obj", 'it\\'s.obj', "c")`,
    )
  })
})

describe('a message of a sketch’s frame', () => {
  test('is read if it is of a known kind and shape', () => {
    for (const message of [
      { kind: 'drawn', milliseconds: 5 },
      { kind: 'state', frames: 3, millis: 4 },
      { kind: 'printed', level: 'warn', text: 'a' },
      { kind: 'wanted', id: 0, address: 'a' },
    ])
      assert.deepEqual(readMessage(message), message)
    assert.deepEqual(readMessage({ kind: 'error', message: 'a', line: 1e300, column: -1 }), {
      kind: 'error',
      message: 'a',
      line: undefined,
      column: undefined,
    })
  })

  test('is dropped otherwise', () => {
    const text = { code: 'a' }
    const warp = {
      maker: 'a',
      own: text,
      texts: { glsl300: text, glsl100: text, wgsl: text },
      reads: [],
    }
    const made = { kind: 'made', warps: [warp], uniforms: [{ name: 'a', value: [1, 2] }] }
    assert.ok(readMessage(made))
    for (const message of [
      null,
      'drawn',
      { kind: 'constructor' },
      { kind: '__proto__' },
      { kind: 'drawn', milliseconds: NaN },
      { kind: 'state', frames: -1, millis: 0 },
      { kind: 'printed', level: 'log" onclick="', text: 'a' },
      { kind: 'made', warps: [{}], uniforms: [] },
      { ...made, warps: [{ ...warp, maker: {} }] },
      { ...made, warps: Array(1000).fill(warp) },
      { ...made, uniforms: [{ name: 'a', value: 'red' }] },
      { ...made, uniforms: [{ name: 'a'.repeat(1000), value: 1 }] },
    ])
      assert.equal(readMessage(message), undefined)
  })

  test('with an answer is an error unless its arrays have the requested lengths', () => {
    const mesh = { positions: new Float32Array(6), normals: new Float32Array(6) }
    assert.equal(evaluatedOf(mesh, mesh), mesh)
    for (const wrong of [null, {}, { positions: mesh.positions }, { ...mesh, normals: [1] }])
      assert.throws(() => evaluatedOf(wrong, mesh), /unexpected answer/)
    assert.throws(() => maskOf({ mask: new Uint8Array(3) }, 2), /unexpected answer/)
    const shape = { ...mesh, indices: new Uint32Array([0, 1, 0]), matrix: Array(16).fill(0) }
    assert.deepEqual(shapesOf([shape]), [shape])
    for (const wrong of [{ indices: new Uint32Array([9]) }, { matrix: [1] }, { positions: [1] }])
      assert.throws(() => shapesOf([{ ...shape, ...wrong }]), /unexpected answer/)
  })
})

test('modules as data: addresses import each other by name', async () => {
  const files = {
    '../../a/one.js': 'import { two } from "./b/two.js"; export const one = two + 1',
    '../../a/b/two.js': "import { far } from 'far/away.js'\nexport const two = far",
    '../../c/away.js': 'export const far = 5',
  }
  const read = async (path) => files[path] ?? assert.fail(path)
  const modules = { one: '../../a/one.js', 'far/': '../../c/' }
  const imports = await modulesAsData("import { one } from 'one'", modules, read)
  assert.deepEqual(Object.keys(imports).sort(), ['data/a/b/two.js', 'far/away.js', 'one'].sort())
  const text = decodeURIComponent(imports['data/a/b/two.js'].split(',')[1])
  assert.match(text, /from 'far\/away\.js'/)
  assert.match(decodeURIComponent(imports.one), /from "data\/a\/b\/two\.js"/)
})

describe('the check of normals', () => {
  const maxOf = (errors) => Math.max(...[...errors].filter((error) => !Number.isNaN(error)))
  const bumps = ({ normal, uv, position }) =>
    normal.mult(
      position
        .y()
        .mult(3)
        .sin()
        .add(
          uv
            .x()
            .mult(4 * Math.PI)
            .sin(),
        )
        .mult(0.1),
    )

  test('accepts the normals of a warp, also if its offset depends on the normal and on uv', () => {
    const { evaluate } = compileWarp(bumps, { surfaceVariation: true })
    const errors = normalErrors(evaluate(spherePoints(1)))
    assert.equal(errors.length, columns * rows)
    assert.ok(maxOf(errors) < 1e-3, `${maxOf(errors)}`)
  })

  test('reports wrong normals as wrong', () => {
    const points = spherePoints(1)
    const { evaluate } = compileWarp(bumps, { surfaceVariation: true })
    const { positions } = evaluate(points)
    // Use the normals of the unwarped sphere.
    assert.ok(maxOf(normalErrors({ positions, normals: points.normals })) > 0.2)
  })
})

test('an archive has the checksums and sizes that unpackers require', () => {
  const bytes = Buffer.concat(zip({ 'a.txt': '123456789', 'ä.bin': new Uint8Array([0, 255]) }))
  // The checksum of these nine digits is the test value in every description of CRC-32.
  assert.equal(bytes.readUInt32LE(14), 0xcbf43926)
  assert.deepEqual([bytes.readUInt32LE(18), bytes.readUInt32LE(22)], [9, 9])
  assert.equal(bytes.subarray(30, 44).toString(), 'a.txt123456789')
  const directory = bytes.readUInt32LE(bytes.length - 6)
  assert.equal(bytes.readUInt32LE(directory), 0x02014b50)
  assert.equal(bytes.readUInt32LE(directory + 42), 0)
  assert.equal(bytes.readUInt16LE(bytes.length - 12), 2)
})

test('an archive has no name that leads out of its folder', () => {
  const names = ['../a', 'a/../../b', '/a', '..\\a', 'c:a', 'a//b', './a', 'a\nb', '..', '']
  for (const name of names) assert.throws(() => zip({ [name]: 'a' }), /cannot be packed/, name)
  zip({ 'public/a..b.obj': 'a', 'ä 100%.obj': 'b' })
})

test('origins give each line its source line, and removing them restores the code', () => {
  const code = 'vec3 a;\n  // From line 7\n  // From line 2\n  // From line 7\n  a = b;\n}'
  assert.deepEqual(withOrigins(code), [
    { text: 'vec3 a;', from: [] },
    { text: '  a = b;', from: [7, 2] },
    { text: '}', from: [] },
  ])
  assert.equal(removeOrigins(code), 'vec3 a;\n  a = b;\n}')
})

test('debug names the line of the offset in each statement, also of derivatives', () => {
  const offset = ({ glsl, position }) => {
    const a = position.y().mult(3).sin()
    return glsl.vec3(a, 0, 0)
  }
  const { code } = compileWarp(offset, { debug: true })
  const statement = (part) =>
    code
      .slice(0, code.indexOf(part))
      .split(';')
      .at(-1)
      .match(/playground\.test\.js:\d+/g)
  assert.equal(new Set([...statement('sin('), ...statement('cos(')]).size, 1)
  assert.equal(code.replaceAll(/^ *\/\/ .*\n/gm, ''), compileWarp(offset).code)
})

describe('an offset function alone', () => {
  const text = 'function offset({ position }) {\n  return position\n}\n'
  test('becomes a p5 sketch that begins with its own lines', () => {
    const sketch = completeSketch({ text, host: 'offset', chosen: ['glsl'], model: 'hand.obj' })
    assert.ok(sketch.text.startsWith(text))
    assert.match(sketch.text, /shape = await loadModel\('hand\.obj'/)
    assert.equal(sketch.host, 'p5')
    assert.deepEqual(sketch.chosen, ['glsl'])
    new Function(sketch.text)
  })
  test('escapes the name of a file, and leaves other sketches unchanged', () => {
    const name = "a'); alert('b.obj"
    const { text: made } = completeSketch({ text, host: 'offset', model: name })
    assert.ok(stringsIn(made).some(({ value }) => value === name))
    new Function(made)
    assert.deepEqual(completeSketch({ text, host: 'p5', model: 'box' }), { text, host: 'p5' })
  })
})

// Mistakes in sketches: checks each message and, for common mistakes in first sketches, the line that it names. The mistakes are in tables
// in the folder mistakes.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { leavePage } from '../support/browser/browser.js'
import { openP5Hosts } from '../support/browser/p5-hosts.js'
import { checkMistakes } from '../support/browser/p5-mistakes.js'
import { calls, offsets, onWebGPU, uncaught } from './mistakes/first-sketches.js'
import shapes from './mistakes/shapes.js'
import uniforms from './mistakes/uniforms.js'

const hosts = await openP5Hosts()

for (const host of hosts)
  for (const { title, isOn = () => true, table } of [...uniforms, ...shapes])
    if (isOn(host))
      test(`${host.name}, ${title}: a WarpError reports each mistake, and the sketch continues to draw`, () =>
        checkMistakes(host, table(host)))

for (const { name, canvas, open } of hosts)
  test(`${name}: a warp made in every frame warns once, and a message names a missing script`, async () => {
    const { page, messages } = await open(
      `let scriptError
    try { const { twist } = warpjet } catch (error) { scriptError = [error.name, error.message.replace(/ \\(\\S+, line \\d+\\)$/, '')] }
    async function setup() { ${canvas(20, 20)}; noStroke(); isReady = true }
    function draw() {
      if (!window.isReady) return
      createWarp(({ glsl }) => glsl.vec3(1, 0, 0))()
      if (frameCount === 8) { noLoop(); window.done = true }
    }`,
    )
    assert.deepEqual(await page.evaluate('scriptError'), [
      'WarpError',
      'warpjet.twist: no script of this page has it; add the script warpjet.deformers.min.js after p5.warpjet.min.js.',
    ])
    await leavePage(page)
    assert.deepEqual(messages, [
      'createWarp: each call makes a new shader, which is slow in every frame; call it once, in setup(), and in draw() call the function that it returned.',
    ])
  })

/** Returns the body of a function: a block as it is, an expression with `return`. */
const toBody = (code) => (code.startsWith('{') ? code : `return ${code}`)

for (const { name, isWebGPU, canvas, open } of hosts)
  test(`${name}: each mistake has its message, with the line of the sketch`, async () => {
    const expected = { ...offsets, ...calls, ...(isWebGPU && onWebGPU) }
    // Leaves out cases that are null.
    const codesWithMessage = (all) => Object.keys(all).filter((code) => expected[code])
    const works = [
      ...codesWithMessage(offsets).map(
        (code) =>
          `createWarp((inputs) => { const { glsl, position, millis } = inputs; ${toBody(code)} })`,
      ),
      ...codesWithMessage(calls),
    ]
    const { page, messages } = await open(
      `let warp, flat
const still = ({ glsl }) => glsl.vec3(0, 0, 0)
const errorOf = (work) => { try { work(); return ['nothing'] } catch ({ name, message }) { return [name, message] } }
const works = [
${works.map((work) => `() => ${work},`).join('\n')}
]
async function setup() {
  window.early = errorOf(() => createWarp(still))
  ${canvas(100, 100)}
  flat = createGraphics(10, 10)
  warp = createWarp(still)
  window.said = works.map(errorOf)
  // Functions that were replaced while the offset ran are restored.
  window.after = [sin(0), Math.max(1, 2), constrain(5, 0, 1)]
  noLoop()
  done = true
}`,
    )
    const said = await page.evaluate('said')
    const early = await page.evaluate('early')
    const after = await page.evaluate('window.after')
    const source = await page.evaluate('document.documentElement.outerHTML')
    await leavePage(page)
    // p5's own friendly errors also report some of these calls.
    assert.deepEqual(
      messages.filter((text) => !/p5\.js says/.test(text)),
      [],
    )
    assert.match(early.join(), /^WarpError,.*needs a 3D canvas/)
    assert.deepEqual(after, [0, 2, 1])
    const lines = source.split('\n')
    const first = lines.findIndex((line) => line.startsWith('const works')) + 1
    const expectedMessages = [...codesWithMessage(offsets), ...codesWithMessage(calls)].map(
      (code) => expected[code],
    )
    const number = /, line (\d+)\)$/
    const shift = number.exec(said[0][1])[1] - first
    said.forEach(([name, message], i) => {
      assert.equal(name, 'WarpError', works[i])
      assert.equal(message.replace(/ \(\S+, line \d+\)$/, ''), expectedMessages[i], works[i])
      assert.match(message, number, works[i])
      assert.equal(number.exec(message)[1] - first, shift + i, `${works[i]}: ${message}`)
    })
  })

for (const { name, isV1, canvas, open } of hosts)
  test(`${name}: p5's friendly errors show uncaught errors`, async () => {
    const all = {
      ...uncaught,
      // p5 2 has a function of this name for p5.strands.
      'createWarp(({ position }) => vec3(position.x, 0, 0))': isV1
        ? 'vec3 is not defined: write glsl.vec3.'
        : "p5's vec3 works on numbers, not on expressions of a warp; write glsl.vec3(x, y, z).",
    }
    const works = Object.keys(all)
    const { page } = await open(
      `let said = []
const still = ({ glsl }) => glsl.vec3(0, 0, 0)
p5._friendlyError = (message) => said.push(message)
const works = [
${works.map((work) => `() => ${work},`).join('\n')}
]
async function setup() { ${canvas(20, 20)}
  noLoop()
  for (const work of works) setTimeout(work)
  setTimeout(async () => { await null; createWarp() })
  setTimeout(() => setTimeout(() => (window.over = true)))
}`,
    )
    await page.waitForFunction('window.over')
    const said = await page.evaluate('said.filter((text) => /\\(\\S+, line \\d+\\)$/.test(text))')
    await leavePage(page)
    const messages = said.map((text) => text.replace(/ \(\S+, line \d+\)$/, ''))
    for (const message of [
      ...Object.values(all),
      'createWarp: expected a function, got undefined.',
    ])
      assert.ok(messages.includes(message), `${message}\n${messages.join('\n')}`)
  })

test('a printed expression describes itself', async () => {
  const { page, messages } = await hosts[0].open(
    `function setup() {
  createCanvas(20, 20, WEBGL)
  noLoop()
  createWarp(({ position }) => {
    console.log(position.mult(2))
    console.log(\`x is \${position.x()}\`)
    console.log(String(position.x), [position.x()].join())
    // Chrome prints the source of functions.
    console.log(position.x)
    print(position.xy)
    return position
  })
  done = true
}`,
  )
  await leavePage(page)
  const description = 'an expression of warpjet'
  assert.deepEqual(messages.slice(0, 3), [
    'Expression',
    `x is ${description}`,
    `${description} ${description}`,
  ])
  const components = messages.slice(3)
  assert.equal(components.length, 2)
  for (const text of components) assert.match(text, /^["'`]an expression of warpjet["'`]\(.{1,60}$/)
})

test('an unused condition causes a warning with its line', async () => {
  const { page, messages } = await hosts[0].open(
    `function setup() {
  createCanvas(20, 20, WEBGL)
  noLoop()
  createWarp(({ glsl, position }) => {
    if (position.y.gt(0)) return glsl.vec3(1, 0, 0)
    return glsl.vec3(0, 0, 0)
  })
  createWarp(({ glsl, position }) => glsl.vec3(position.x.lt(0) ? 1 : 2, !position.y.lt(0) ? 3 : 4, 0))
  done = true
}`,
  )
  await leavePage(page)
  const warning = `A condition is not used (line): JavaScript's if, ?:, && and ! treat every condition of a warp as true; write condition.ifElse(yes, no), a.and(b), condition.not().`
  assert.deepEqual(messages.map(withoutLine), [warning, warning])
  const numbers = messages.map((text) => +/line (\d+)\)/.exec(text)[1])
  assert.equal(numbers[1] - numbers[0], 3)
})

const withoutLine = (text) => text.replace(/ \(\S+, line \d+\)/, ' (line)')

test('operators that mean something else on expressions than in JavaScript cause a warning', async () => {
  const { page, messages } = await hosts[0].open(
    `let list = []
let wave
const methods = (offset) => createWarp((inputs) => offset(inputs), { scope: { offset } })
function setup() {
  createCanvas(20, 20, WEBGL)
  noLoop()
  methods(({ glsl }) => glsl.vec3(0, millis(), 0))
  methods(({ glsl, millis, position }) => glsl.vec3(position.x.gt(0).ifElse(millis(), position().y), 0, 0))
  createWarp(({ position }) => {
    let x = 0
    if (position.y > 0) { x = 1; list.push(x) }
    return [x, 0, 0]
  })
  try { createWarp(({ position }) => { if (position.y > 0) return position }) } catch ({ message }) { window.said = message }
  done = true
}`,
    [...hosts[0].scripts, '/dist/warpjet.operators.min.js'],
  )
  const said = await page.evaluate('window.said')
  await leavePage(page)
  assert.deepEqual(messages.map(withoutLine), [
    "createWarp: p5's millis() is constant in a warp; use the millis that the offset function gets, as in ({ glsl, millis }) => ….",
    'list.push(x) is in an if that the GPU decides for each vertex, so it is always called once, while the warp is made; set a variable there, or let JavaScript decide the if by numbers.',
  ])
  assert.equal(
    withoutLine(said),
    'An if that is decided for each vertex returns a value in only one of its branches; let the other branch return a value too, such as return [0, 0, 0] at the end. (line)',
  )
})

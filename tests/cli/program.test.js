// Starts `npx warpjet` as a shell does, and checks its usage message and exit status.
import assert from 'node:assert/strict'
import { spawn } from 'node:child_process'
import { existsSync, openSync } from 'node:fs'
import { describe, test } from 'node:test'
import { version } from 'warpjet'
import {
  failsWithError,
  failsWithUsage,
  folder,
  program,
  works,
  write,
} from '../support/cli-tests.js'

describe('the program', () => {
  test('prints its version and its help', async () => {
    assert.equal((await works('--version')).stdout, `${version}\n`)
    const { stdout } = await works('--help')
    for (const command of ['emit', 'bake', 'info'])
      assert.match(stdout, new RegExp(`npx warpjet ${command} `))
    for (const command of ['emit', 'bake', 'info'])
      assert.match((await works(command, '--help')).stdout, new RegExp(`^npx warpjet ${command} <`))
    for (const option of ['--output', '--set', '--subdivide', '--max-triangles', '--quiet'])
      assert.match((await works('bake', '-h')).stdout, new RegExp(option))
  })

  test('exits with 2 after wrong usage', async () => {
    await failsWithUsage([], /A command is missing\. `npx warpjet --help` shows how/)
    await failsWithUsage(['bend'], /no command "bend"/)
    await failsWithUsage(['toString'], /no command "toString"/)
    await failsWithUsage(
      ['emit'],
      /emit needs a warp\.js or a file of GLSL or WGSL\. `npx warpjet emit --help`/,
    )
    await failsWithUsage(['emit', 'wave.js', 'named.js'], /nothing more, got "named\.js"/)
    await failsWithUsage(
      ['emit', 'wave.js', '--target', 'hlsl'],
      /emit: expected 'glsl300', 'glsl100' or 'wgsl' for --target, got the text "hlsl"/,
    )
    await failsWithUsage(['emit', 'wave.js', '--speed', '2'], /emit: Unknown option '--speed'/)
    await failsWithUsage(['info'], /info needs a model/)
    await failsWithUsage(['bake', 'model.glb'], /bake needs a warp\.js/)
    await failsWithUsage(['bake', 'model.glb', 'wave.js'], /bake needs -o/)
    await failsWithUsage(
      ['bake', 'model.glb', 'wave.js', '-o', 'out.obj'],
      /bake: expected a \.glb file for -o, got "out\.obj"/,
    )
    await failsWithUsage(
      ['bake', 'model.glb', 'wave.js', '-o', './model.glb'],
      /does not overwrite the model/,
    )
    for (const setting of ['millis', 'millis=', 'millis=x', '=1', 'mouse=1,'])
      await failsWithUsage(
        ['bake', 'model.glb', 'wave.js', '-o', 'o.glb', '--set', setting],
        /bake: expected a name and numbers, as in --set millis=1200, for --set, got the text /,
      )
    for (const tolerance of ['0', 'x', '', 'Infinity'])
      await failsWithUsage(
        ['bake', 'model.glb', 'wave.js', '-o', 'o.glb', '--subdivide', tolerance],
        /bake: expected a number above 0 for --subdivide, got /,
      )
    const bakeWithLimit = (max) => [...bakeArguments, '--subdivide', '1', '--max-triangles', max]
    const bakeArguments = ['bake', 'model.glb', 'named.js', '-o', 'o.glb']
    for (const max of ['1.5', String(2 ** 28 + 1), '1e20'])
      await failsWithUsage(
        bakeWithLimit(max),
        /bake: expected a whole number from 1 to 268,435,456 for --max-triangles, got /,
      )
    for (const max of ['0', '-1', 'x'])
      await failsWithUsage(
        bakeWithLimit(max),
        /expected a whole number from 1 to .* for --max-triangles, got |ambiguous/,
      )
    await failsWithUsage(
      [...bakeArguments, '--max-triangles', '9'],
      /--max-triangles needs --subdivide/,
    )
  })
})

describe('how it exits', () => {
  /** Runs the program, which must exit within 20 s by itself. Returns its exit status and its stderr. */
  async function runUntilExit(args, prepare = () => {}) {
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

  test('exits if the reader closes its output', async () => {
    const leave = ({ stdout }) => stdout.destroy()
    assert.deepEqual(await runUntilExit([program, 'emit', 'named.js'], leave), {
      code: 0,
      stderr: '',
    })
  })

  test('does not wait for a timer of warp.js', async () => {
    write('timer.js', 'setInterval(() => {}, 1000)\nexport { bend } from "./named.js"')
    const { code } = await runUntilExit([program, 'emit', 'timer.js'], ({ stdout }) =>
      stdout.resume(),
    )
    assert.equal(code, 0)
  })

  const full = '/dev/full'
  test('prints one message if the disk is full', { skip: !existsSync(full) }, async () => {
    const stdio = ['ignore', openSync(full, 'w'), 'pipe']
    const child = spawn(process.execPath, [program, 'emit', 'named.js'], { cwd: folder, stdio })
    let stderr = ''
    child.stderr.setEncoding('utf8').on('data', (text) => (stderr += text))
    const code = await new Promise((resolve) => child.on('close', resolve))
    assert.equal(stderr, 'warpjet: the output cannot be written: the disk is full.\n')
    assert.equal(code, 1)
  })

  test('prints one message if warp.js never resolves', async () => {
    write('waits.js', 'await new Promise(() => {})\nexport { bend } from "./named.js"')
    await failsWithError(
      ['emit', 'waits.js'],
      /waits\.js never finishes loading: its top-level await/,
    )
  })

  test('clears the progress line before an error', async () => {
    const terminal = 'data:text/javascript,process.stderr.isTTY = true'
    const { code, stderr } = await runUntilExit([
      ...['--import', terminal, program, 'bake', 'model.glb', 'named.js'],
      ...['-o', 'o.glb', '--subdivide', '0.1', '--set', 'speed=1'],
    ])
    assert.equal(code, 1)
    assert.match(
      stderr,
      /Subdividing: [^\n]*evaluated\r\x1b\[Kwarpjet: .*no uniform "speed"[^\n]*\n$/,
    )
  })
})

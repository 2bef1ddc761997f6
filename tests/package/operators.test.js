// The plugin for operators in each supported bundler: its output must run in Node. Without the plugin, the operators throw an error.
import assert from 'node:assert/strict'
import { before, test } from 'node:test'
import { rolldown } from 'rolldown'
import * as vite from 'vite'
import { load, project, runIn } from './support/project.js'

const entry = `${project}/with-operators.mjs`

let operators
before(async () => ({ operators } = await load('warpjet/operators/plugin')))

/** Asserts that a bundle prints the expected position. */
function assertWorks(program) {
  const { output, status } = runIn(process.execPath, [program])
  assert.equal(output, 'moved 3,1,3\n')
  assert.equal(status, 0)
}

test('without the plugin, a message says what to add', () => {
  const { output, status } = runIn(process.execPath, ['with-operators.mjs'])
  assert.match(output, /WarpError: JavaScript's own \+ - \* .* import 'warpjet\/operators'/)
  assert.equal(status, 1)
})

test('Vite translates operators', async () => {
  const outDir = 'out/operators-vite'
  await vite.build({
    configFile: false,
    logLevel: 'error',
    root: project,
    plugins: [operators()],
    ssr: { noExternal: true },
    build: { ssr: entry, outDir, emptyOutDir: true },
  })
  assertWorks(`${outDir}/with-operators.js`)
})

const makeNodeResolve = async () => {
  const { default: nodeResolve } = await load('@rollup/plugin-node-resolve')
  return nodeResolve({ exportConditions: ['node'] })
}

/** Builds with Rollup or rolldown, which have the same options here, and runs the output. */
async function bundleAndRun(bundler, dir, ...plugins) {
  const warnings = []
  const onwarn = ({ message }) => warnings.push(message)
  const bundle = await bundler({ input: entry, platform: 'node', onwarn, plugins })
  await bundle.write({ dir: `${project}/${dir}`, entryFileNames: '[name].mjs', format: 'es' })
  await bundle.close()
  assert.deepEqual(warnings, [])
  assertWorks(`${dir}/with-operators.mjs`)
}

test('Rollup translates operators', async () => {
  const { rollup } = await load('rollup')
  const rollupWithoutPlatform = ({ platform: _, ...options }) => rollup(options)
  await bundleAndRun(
    rollupWithoutPlatform,
    'out/operators-rollup',
    operators(),
    await makeNodeResolve(),
  )
})

test('rolldown translates operators', () =>
  bundleAndRun(rolldown, 'out/operators-rolldown', operators()))

test('webpack translates operators with the loader', async () => {
  const { default: webpack } = await load('webpack')
  const stats = await new Promise((resolve, reject) =>
    webpack(
      {
        mode: 'development',
        devtool: false,
        target: 'node',
        context: project,
        entry,
        module: { rules: [{ test: /with-operators\.mjs$/, use: 'warpjet/operators/plugin' }] },
        output: { path: `${project}/out/operators-webpack`, filename: 'main.cjs' },
      },
      (error, found) => (error ? reject(error) : resolve(found)),
    ),
  )
  const { errors, warnings } = stats.toJson({ all: false, errors: true, warnings: true })
  assert.deepEqual([...errors, ...warnings], [])
  assertWorks('out/operators-webpack/main.cjs')
})

// Runs Node programs that use the package: on the minimum versions that package.json names and on the version that runs this test, with
// import and with require, bundled and unbundled.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { load, project, runIn } from './support/project.js'

/** Asserts that a program uses the package successfully; returns its output. */
const assertWorks = (node, args) => {
  const { output, status } = runIn(node, args)
  assert.match(output, /moved 1,0,0 function/)
  assert.equal(status, 0)
  return output
}

/** Maps a title → a Node binary. The minimum versions are installed only on Linux for x64. */
const binaries = { [`the current Node ${process.versions.node}`]: process.execPath }
if (process.platform === 'linux' && process.arch === 'x64')
  for (const version of [20, 22])
    binaries[`the minimum version of Node ${version}`] =
      `${project}/node_modules/node-${version}-linux-x64/bin/node`

for (const [name, node] of Object.entries(binaries)) {
  test(`${name} imports every entry`, () => assertWorks(node, ['main.mjs']))
  test(`${name} requires every entry`, () => assertWorks(node, ['main.cjs']))
  test(`${name} runs the command line tool`, () => {
    const { output, status } = runIn(node, [
      'node_modules/warpjet/dist/cli.js',
      'info',
      'triangle.obj',
    ])
    assert.match(output, /3 vertices|vertices\s+3/)
    assert.equal(status, 0)
  })
}

test('a bundle by webpack runs in Node', async () => {
  const { default: webpack } = await load('webpack')
  const stats = await new Promise((resolve, reject) =>
    webpack(
      {
        mode: 'development',
        devtool: false,
        target: 'node',
        context: project,
        entry: './main.mjs',
        output: { path: `${project}/out/webpack-node`, filename: 'main.cjs' },
      },
      (error, found) => (error ? reject(error) : resolve(found)),
    ),
  )
  const { errors, warnings } = stats.toJson({ all: false, errors: true, warnings: true })
  assert.deepEqual([...errors, ...warnings], [])
  assertWorks(process.execPath, ['out/webpack-node/main.cjs'])
})

test('a bundle by esbuild runs in Node', async () => {
  const { build } = await load('esbuild')
  const { warnings } = await build({
    absWorkingDir: project,
    entryPoints: ['main.mjs'],
    bundle: true,
    platform: 'node',
    format: 'esm',
    outfile: 'out/esbuild-node.mjs',
    logLevel: 'silent',
  })
  assert.deepEqual(warnings, [])
  assertWorks(process.execPath, ['out/esbuild-node.mjs'])
})

test('a bundle by Rollup runs in Node', async () => {
  const { rollup } = await load('rollup')
  const { default: nodeResolve } = await load('@rollup/plugin-node-resolve')
  const warnings = []
  const bundle = await rollup({
    input: `${project}/main.mjs`,
    plugins: [nodeResolve({ exportConditions: ['node'] })],
    onwarn: ({ message }) => warnings.push(message),
  })
  await bundle.write({ dir: `${project}/out/rollup-node`, entryFileNames: '[name].mjs' })
  await bundle.close()
  assert.deepEqual(warnings, [])
  assertWorks(process.execPath, ['out/rollup-node/main.mjs'])
})

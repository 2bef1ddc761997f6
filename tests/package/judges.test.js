// Checks the tarball with publint and attw, and its types with TypeScript.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { load, project, runIn, tarball } from './support/project.js'

test('publint accepts the tarball', async () => {
  const { publint } = await load('publint')
  const { messages } = await publint({ pkgDir: `${project}/node_modules/warpjet`, strict: true })
  assert.deepEqual(messages, [])
})

test('attw accepts the types of the tarball', () => {
  const { output, status } = runIn(process.execPath, [
    'node_modules/@arethetypeswrong/cli/dist/index.js',
    tarball(),
    '--profile=esm-only',
    '--no-color',
    '--format=ascii',
  ])
  assert.equal(status, 0, output)
})

const tsc = fileURLToPath(new URL('../../node_modules/typescript-7/bin/tsc', import.meta.url))

for (const [module, moduleResolution] of [
  ['esnext', 'bundler'],
  ['node16', 'node16'],
  ['nodenext', 'nodenext'],
])
  test(`TypeScript resolves the types with moduleResolution ${moduleResolution}`, () => {
    const { output, status } = runIn(process.execPath, [
      tsc,
      '--noEmit',
      '--strict',
      '--ignoreConfig',
      '--target',
      'es2022',
      '--module',
      module,
      '--moduleResolution',
      moduleResolution,
      'types/modules.ts',
    ])
    assert.equal(output, '')
    assert.equal(status, 0)
  })

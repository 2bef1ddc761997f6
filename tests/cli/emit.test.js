// `npx warpjet emit`.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { join } from 'node:path'
import { describe, test } from 'node:test'
import { compileWarp, targets } from 'warpjet'
import { failsWithError, folder, works, write } from '../support/cli-tests.js'

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

  test('emits glsl300 by default, uses the only exported function of a file, and can write into a file', async () => {
    const { bend } = await import(join(folder, 'named.js'))
    const { stdout } = await works('emit', 'named.js')
    assert.ok(stdout.includes(compileWarp(bend).code.trim()))
    assert.equal((await works('emit', 'named.js', '-o', 'named.glsl')).stdout, '')
    assert.equal(readFileSync(join(folder, 'named.glsl'), 'utf8'), stdout)
    assert.match((await works('emit', 'named.js', '--tangents')).stdout, /warpedTangent/)
  })

  test('reports invalid warps', async () => {
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
    await failsWithError(['emit', 'gone.js'], /The file gone\.js does not exist/)
    await failsWithError(['emit', 'none.js'], /none\.js exports no function/)
    await failsWithError(['emit', 'two.js'], /two\.js exports 2 functions/)
    await failsWithError(['emit', 'broken.js'], /broken\.js cannot be run: SyntaxError/)
    await failsWithError(['emit', 'throws.js'], /throws\.js cannot be run: Error: no/)
    await failsWithError(['emit', 'undefined.js'], /must return a vec3/)
    await failsWithError(['emit', 'typo.js'], /sine: .*did you mean sin\? \(typo\.js, line 2\)/)
    write('own.js', 'export default () =>\n  nothing.at.all')
    await failsWithError(['emit', 'own.js'], /own\.js: ReferenceError: nothing .* \(line 2\)/)
    write('null.js', 'throw null')
    write('text.js', 'export default () => { throw "no" }')
    await failsWithError(['emit', 'null.js'], /null\.js cannot be run: it throws null\./)
    await failsWithError(['emit', 'text.js'], /text\.js throws the text "no"\./)
    await failsWithError(['emit', 'imports.js'], /imports\.js cannot be run: .*gone\.js/)
    await failsWithError(
      ['emit', 'wave.js', '-o', 'no/such/folder.glsl'],
      /cannot be written: the folder does not exist/,
    )
  })
})

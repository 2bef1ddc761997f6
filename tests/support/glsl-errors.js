// Checks that invalid GLSL is rejected with line, column and a caret.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { WarpError, compileWarp } from 'warpjet'
import { glslOffset } from 'warpjet/glsl'

/** Returns the source of an offset function in GLSL whose body is `statements`. */
export const body = (statements) => `vec3 offset(vec3 p) {\n  ${statements}\n}`
export const nest = (open, inner, close, count) => open.repeat(count) + inner + close.repeat(count)

/** Defines a test for each row: [source, line of the mistake, part of the message]. */
export function rejects(rows) {
  for (const [source, line, piece] of rows)
    test(`reports an error in line ${line}: ${piece}`, () => {
      assert.throws(
        () => compileWarp(glslOffset(source)),
        (error) => {
          assert.ok(error instanceof WarpError, error.stack)
          const [first, ...rest] = error.message.split('\n')
          assert.match(first, new RegExp(`^glslOffset: line ${line}, column [0-9]+: .*[.?]$`))
          assert.ok(first.includes(piece), first)
          assert.equal(rest.length, 2)
          assert.match(rest[1], /^\s*\^$/)
          assert.ok(error.message.length < 600)
          return true
        },
      )
    })
}

// Tests the TypeScript declarations that the build generates from the bindings of a wasm module.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { embindTypes } from '../../.scripts/lib/embind-types.mjs'

const file = (name) => fileURLToPath(new URL(`../../.build/wasm/${name}`, import.meta.url))
const types = (name) =>
  embindTypes(readFileSync(file(`${name}.mjs`), 'utf8'), readFileSync(file(`${name}.wasm`)))

test('declares classes, records, lists, enumerations and plain exports', () => {
  const core = types('core')
  for (const line of [
    'export type Shape = readonly [number, number]',
    'export interface Variable { name: string; shape: Shape; number: number }',
    '  addFunction(a: string, b: readonly HostText[], c: number): number',
    '  finish(): Uint32Array',
    '  results(): Variable[]',
    '  Wrap: { clamp: Wrap; repeat: Wrap; mirror: Wrap; host: Wrap; sampler: Wrap }',
    '  Session: new () => Session',
    '  Module: new (a: ArrayLike<number>) => Module',
    '  _push(a: number, b: number): void',
    '  _constant(a: number, b: number): number',
  ])
    assert.ok(core.split('\n').includes(line), `${line} is not in\n${core}`)
})

test('declares SIMD vectors as never, since JavaScript cannot represent them', () => {
  assert.match(types('evaluation'), /^  _lanes_pow\(a: never, b: never\): never$/m)
})

// Tests the TypeScript declarations that the build generates from the bindings of a wasm module.
import assert from 'node:assert/strict'
import { readFileSync } from 'node:fs'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { embindTypes } from '../../.scripts/lib/embind-types.mjs'
import { wasmSignatures } from '../../.scripts/lib/wasm-signatures.mjs'

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

test('reads signatures, also of imported functions', () => {
  // (module (import "a" "f" (func $f (param f64 i64) (result i32))) (func $g (param v128)) (export "f" (func $f)) (export "g" (func $g)))
  const bytes = Uint8Array.of(
    ...[0, 0x61, 0x73, 0x6d, 1, 0, 0, 0],
    ...[1, 11, 2, 0x60, 2, 0x7c, 0x7e, 1, 0x7f, 0x60, 1, 0x7b, 0],
    ...[2, 7, 1, 1, 0x61, 1, 0x66, 0, 0],
    ...[3, 2, 1, 1],
    ...[7, 9, 2, 1, 0x66, 0, 0, 1, 0x67, 0, 1],
    ...[10, 4, 1, 2, 0, 0x0b],
  )
  assert.ok(WebAssembly.validate(bytes))
  assert.deepEqual(Object.fromEntries(wasmSignatures(bytes)), {
    f: { parameters: ['number', 'bigint'], result: 'number' },
    g: { parameters: ['never'], result: 'void' },
  })
})

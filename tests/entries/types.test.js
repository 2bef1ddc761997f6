// Tests the shipped types in a project that has installed the package, with the oldest supported TypeScript and with the newest.
import assert from 'node:assert/strict'
import { spawnSync } from 'node:child_process'
import {
  cpSync,
  mkdirSync,
  readFileSync,
  readdirSync,
  rmSync,
  symlinkSync,
  writeFileSync,
} from 'node:fs'
import { test } from 'node:test'
import { fileURLToPath } from 'node:url'
import { runInThisContext } from 'node:vm'
import ts from 'typescript'
import { isRun } from '../../.scripts/lib/tiers.mjs'

const root = fileURLToPath(new URL('../../', import.meta.url))
const project = `${root}.build/consumer`
rmSync(project, { recursive: true, force: true })
mkdirSync(`${project}/node_modules`, { recursive: true })
symlinkSync(root, `${project}/node_modules/warpjet`, 'junction')
cpSync(`${root}tests/types/shipped`, project, { recursive: true })

const modules = ['modules.ts']
const sketches = ['p5-module.ts', 'p5-global.ts']

/** Returns compiler options. For sketches, they ignore errors in p5's own types. */
const optionsFor = (files, moduleResolution) => ({
  strict: true,
  noEmit: true,
  module: moduleResolution === 'bundler' ? 'esnext' : moduleResolution,
  moduleResolution,
  target: 'es2022',
  lib: ['es2022', 'dom', 'dom.iterable'],
  types: [],
  skipLibCheck: files === sketches,
})

for (const [compiler, files, moduleResolution] of [
  ['typescript-7', modules, 'nodenext'],
  ['typescript-7', sketches, 'bundler'],
  ...(isRun('every TypeScript')
    ? [
        ['typescript-5.4', modules, 'nodenext'],
        ['typescript-7', modules, 'bundler'],
        ['typescript-7', modules, 'node16'],
        ['typescript-5.4', sketches, 'bundler'],
      ]
    : []),
])
  test(`${files.join(' and ')}, ${compiler}, ${moduleResolution}`, () => {
    const config = `${project}/tsconfig.json`
    const compilerOptions = optionsFor(files, moduleResolution)
    writeFileSync(config, JSON.stringify({ compilerOptions, files }))
    const tsc = `${root}node_modules/${compiler}/bin/tsc`
    const { stdout, status } = spawnSync(process.execPath, [tsc, '-p', config], {
      encoding: 'utf8',
    })
    assert.equal(stdout, '')
    assert.equal(status, 0)
  })

test('each entry has one file of types, and two more files are shared', () => {
  const { exports } = JSON.parse(readFileSync(`${root}package.json`, 'utf8'))
  const declared = Object.values(exports).flatMap(({ types }) => types ?? [])
  assert.deepEqual(
    readdirSync(`${root}dist/types`).map((name) => `./dist/types/${name}`),
    [
      ...new Set([
        ...declared,
        './dist/types/shared.d.ts',
        // This file needs the types of three.js.
        './dist/types/three.shared.d.ts',
      ]),
    ].sort(),
  )
})

/** Returns the hints that an editor shows for the names in `code` that are followed by #. */
function getHints(code) {
  const name = `${project}/hover.ts`
  const text = code.replaceAll('#', '')
  const { options } = ts.convertCompilerOptionsFromJson(optionsFor(modules, 'bundler'), project)
  const host = {
    getCompilationSettings: () => options,
    getScriptFileNames: () => [name],
    getScriptVersion: () => '1',
    getScriptSnapshot: (file) => {
      const content = file === name ? text : ts.sys.readFile(file)
      return content === undefined ? undefined : ts.ScriptSnapshot.fromString(content)
    },
    getCurrentDirectory: () => project,
    getDefaultLibFileName: ts.getDefaultLibFilePath,
    fileExists: (file) => file === name || ts.sys.fileExists(file),
    readFile: ts.sys.readFile,
    realpath: ts.sys.realpath,
    directoryExists: ts.sys.directoryExists,
  }
  const service = ts.createLanguageService(host)
  assert.deepEqual(
    service.getSemanticDiagnostics(name).map(({ messageText }) => messageText),
    [],
  )
  const places = [...code.matchAll(/#/g)].map(({ index }, i) => index - i - 1)
  return places.map((place) =>
    ts.displayPartsToString(service.getQuickInfoAtPosition(name, place)?.documentation),
  )
}

test('editors show a hint for each operation', () => {
  const descriptions = getHints(`
    import { compileWarp } from 'warpjet'
    compileWarp(({ glsl, position, millis }) => {
      const x = millis.mix#(1, 0.5).div#(2).smoothstep#(0, position.x()).lt#(1).ifElse#(1, 0)
      const wind = glsl.vec2Param#('wind').mult#(x.mult#(2))
      const m = glsl.mat3#(position, position, position).mult#(glsl.mat3Rows#(1).div#(2))
      const height = position.noise#().add#(position.curl#().x(), wind.worley#().x())
      const tilt = glsl.fbm#(position).add(glsl.sin#(x), glsl.mix#(0, height, 1), glsl.div#(x, 2))
      return m.mult(glsl.vec3#(tilt, glsl.val#(2), 0))
    })`)
  assert.equal(descriptions.length, 22)
  for (const description of descriptions) assert.match(description, /\w.* .*\w/)
})

test('all members of expressions and of the builder have a hint', () => {
  const program = ts.createProgram(
    [`${root}dist/types/warpjet.d.ts`],
    ts.convertCompilerOptionsFromJson(optionsFor(modules, 'bundler'), project).options,
  )
  const checker = program.getTypeChecker()
  const source = program.getSourceFile(`${root}dist/types/warpjet.d.ts`)
  const exported = checker.getExportsOfModule(checker.getSymbolAtLocation(source))
  const undocumented = ['Scalar', 'Vec2', 'Vec3', 'Vec4', 'Mat2', 'Mat3', 'Mat4', 'Glsl'].flatMap(
    (name) => {
      const symbol = exported.find((other) => other.name === name)
      const target = symbol.flags & ts.SymbolFlags.Alias ? checker.getAliasedSymbol(symbol) : symbol
      const members = checker
        .getDeclaredTypeOfSymbol(target)
        .getProperties()
        .filter((member) => !/^([xyzw]+|[rgba]+|[stpq]+|[uv]+|__@.*)$/.test(member.name))
      assert.ok(members.length > 10, name)
      return members
        .filter((member) =>
          checker
            .getTypeOfSymbol(member)
            .getCallSignatures()
            .some((signature) => !signature.getDocumentationComment(checker).length),
        )
        .map((member) => `${name}.${member.name}`)
    },
  )
  assert.deepEqual(undocumented, [])
})

test('the types of the scripts declare the same names as the scripts', () => {
  for (const script of [
    'p5.warpjet',
    ...['deformers', 'glsl', 'operators'].map((s) => `warpjet.${s}`),
  ])
    runInThisContext(readFileSync(`${root}dist/${script}.min.js`, 'utf8'))
  const file = `${project}/names.ts`
  writeFileSync(file, '/// <reference types="warpjet/globals" />\nexport const names = warpjet\n')
  const program = ts.createProgram(
    [file],
    ts.convertCompilerOptionsFromJson(optionsFor(modules, 'bundler'), project).options,
  )
  const checker = program.getTypeChecker()
  const [names] = checker.getExportsOfModule(
    checker.getSymbolAtLocation(program.getSourceFile(file)),
  )
  const typed = checker
    .getTypeOfSymbol(names)
    .getProperties()
    .map(({ name }) => name)
  assert.deepEqual(typed.sort(), Object.keys(globalThis.warpjet).sort())
})

// Tests that a checkout that was copied or moved together with its .build builds its own sources, not those of the previous folder.
import assert from 'node:assert/strict'
import { execFileSync } from 'node:child_process'
import { cpSync, mkdirSync, mkdtempSync, renameSync, rmSync, writeFileSync } from 'node:fs'
import { tmpdir } from 'node:os'
import { join } from 'node:path'
import { after, before, test } from 'node:test'
import { fileURLToPath } from 'node:url'

const root = fileURLToPath(new URL('../../', import.meta.url))

let folder
before(() => {
  folder = mkdtempSync(join(tmpdir(), 'warpjet-moved-'))
  const first = join(folder, 'first')
  mkdirSync(join(first, '.scripts'), { recursive: true })
  cpSync(join(root, '.scripts/lib'), join(first, '.scripts/lib'), { recursive: true })
  writeFileSync(join(first, 'package.json'), '{ "type": "module" }')
  const preset = { name: 'native', binaryDir: '${sourceDir}/.build/native' }
  const presets = {
    version: 3,
    configurePresets: [preset],
    buildPresets: [{ name: 'native', configurePreset: 'native' }],
  }
  writeFileSync(join(first, 'CMakePresets.json'), JSON.stringify(presets))
  writeFileSync(
    join(first, 'CMakeLists.txt'),
    'cmake_minimum_required(VERSION 3.21)\nproject(moved CXX)\nadd_executable(say say.cpp)\n',
  )
  writeProgram('first')
})
after(() => rmSync(folder, { recursive: true }))

/** Writes the program of a checkout, which prints the name of the checkout. */
function writeProgram(name) {
  const text = `#include <cstdio>\nint main() { std::puts("${name}"); }\n`
  writeFileSync(join(folder, name, 'say.cpp'), text)
}

/** Builds a checkout as its scripts do, and returns the output of its program. */
function buildAndRun(name) {
  const code = "import { cmakeBuild } from './.scripts/lib/cmake.mjs'; await cmakeBuild('native')"
  const cwd = join(folder, name)
  execFileSync(process.execPath, ['--input-type=module', '--eval', code], { cwd, stdio: 'pipe' })
  return execFileSync(join(cwd, '.build/native/say'), { encoding: 'utf8' }).trim()
}

test('a checkout that was copied together with its .build builds its own sources', () => {
  assert.equal(buildAndRun('first'), 'first')
  cpSync(join(folder, 'first'), join(folder, 'copied'), { recursive: true })
  writeProgram('copied')
  assert.equal(buildAndRun('copied'), 'copied')
  assert.equal(buildAndRun('first'), 'first')
})

test('a moved checkout also builds its own sources', () => {
  renameSync(join(folder, 'first'), join(folder, 'moved'))
  writeProgram('moved')
  assert.equal(buildAndRun('moved'), 'moved')
})

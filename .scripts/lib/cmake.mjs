// Configures and builds one preset of CMakePresets.json, incrementally, in .build/<preset>.
import { existsSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { delimiter } from 'node:path'
import { path } from './files.mjs'
import { run } from './run.mjs'
import { onPath } from './which.mjs'

// Debian's emcc finds its JavaScript parser (package node-acorn) only when Debian's own node runs it.
const debianModules = '/usr/share/nodejs'
export const emscriptenEnv = existsSync(`${debianModules}/acorn`)
  ? { NODE_PATH: [process.env.NODE_PATH, debianModules].filter(Boolean).join(delimiter) }
  : {}

export async function cmakeBuild(preset) {
  const env = preset === 'wasm' ? { ...emscriptenEnv } : {}
  if (!existsSync(path('.build', preset, 'CMakeCache.txt'))) {
    if (onPath('ninja') && !process.env.CMAKE_GENERATOR) env.CMAKE_GENERATOR = 'Ninja'
    const [command, ...first] = preset === 'wasm' ? ['emcmake', 'cmake'] : ['cmake']
    await run(command, [...first, '--preset', preset], { env })
  }
  await run('cmake', ['--build', '--preset', preset, '--parallel', `${availableParallelism()}`], {
    env,
  })
}

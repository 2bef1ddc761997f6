// Configures and builds one preset of CMakePresets.json, all of it or only some targets, incrementally, in .build/<preset>.
import { existsSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { path } from './files.mjs'
import { run } from './run.mjs'
import { onPath } from './which.mjs'

export async function cmakeBuild(preset, ...targets) {
  if (!existsSync(path('.build', preset, 'CMakeCache.txt'))) {
    const env = onPath('ninja') && !process.env.CMAKE_GENERATOR ? { CMAKE_GENERATOR: 'Ninja' } : {}
    const [command, ...first] = preset === 'wasm' ? ['emcmake', 'cmake'] : ['cmake']
    await run(command, [...first, '--preset', preset], { env })
  }
  const only = targets.length ? ['--target', ...targets] : []
  const parallel = ['--parallel', `${availableParallelism()}`]
  await run('cmake', ['--build', '--preset', preset, ...parallel, ...only])
}

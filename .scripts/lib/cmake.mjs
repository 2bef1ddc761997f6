// Configures and builds one preset of CMakePresets.json, all of it or only some targets, incrementally, in .build/<preset>.
import { copyFileSync, existsSync, readFileSync, realpathSync, rmSync } from 'node:fs'
import { availableParallelism } from 'node:os'
import { path } from './files.mjs'
import { run } from './run.mjs'
import { onPath } from './which.mjs'

const presets = path('CMakePresets.json')

/** Returns whether CMake's cache was written for this checkout. In a checkout that was copied or moved, the cache still names the old folder. */
function isOfThisCheckout(cache) {
  const [, home] = /^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$/m.exec(readFileSync(cache, 'utf8')) ?? []
  return home && existsSync(home) && realpathSync(home) === realpathSync(path())
}

/** Returns whether the folder was configured with the current presets. CMake itself does not notice that a preset names a new compiler. */
function isConfigured(folder) {
  const [cache, usedPresets] = ['CMakeCache.txt', 'CMakePresets.json'].map((name) =>
    path(folder, name),
  )
  return (
    existsSync(cache) &&
    isOfThisCheckout(cache) &&
    existsSync(usedPresets) &&
    readFileSync(usedPresets, 'utf8') === readFileSync(presets, 'utf8')
  )
}

/** Builds the targets, or all targets if none is named. */
export async function cmakeBuild(preset, ...targets) {
  const folder = `.build/${preset}`
  if (!isConfigured(folder)) {
    for (const stale of ['CMakeCache.txt', 'CMakeFiles'])
      rmSync(path(folder, stale), { recursive: true, force: true })
    const env = onPath('ninja') && !process.env.CMAKE_GENERATOR ? { CMAKE_GENERATOR: 'Ninja' } : {}
    const [command, ...prefix] = preset === 'wasm' ? ['emcmake', 'cmake'] : ['cmake']
    await run(command, [...prefix, '--preset', preset], { env })
    copyFileSync(presets, path(folder, 'CMakePresets.json'))
  }
  const only = targets.length ? ['--target', ...targets] : []
  const parallel = ['--parallel', `${availableParallelism()}`]
  await run('cmake', ['--build', '--preset', preset, ...parallel, ...only])
}

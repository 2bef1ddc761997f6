// Allows one build at a time: two would mix the glue of one with the wasm of the other.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { setTimeout } from 'node:timers/promises'
import { path } from './files.mjs'

const file = '.build/lock'

function holder() {
  try {
    const pid = Number(readFileSync(path(file), 'utf8'))
    process.kill(pid, 0)
    return pid
  } catch {
    return undefined
  }
}

/** Does `work` while no other process works under this lock. */
export async function withLock(work) {
  mkdirSync(path('.build'), { recursive: true })
  for (let hasSaid = false; ; await setTimeout(500)) {
    try {
      writeFileSync(path(file), String(process.pid), { flag: 'wx' })
      break
    } catch (error) {
      if (error.code !== 'EEXIST') throw error
      if (holder() === undefined) rmSync(path(file), { force: true })
      else if (!hasSaid) console.log('Waiting for another build to end …')
      hasSaid = true
    }
  }
  try {
    return await work()
  } finally {
    rmSync(path(file), { force: true })
  }
}

// Allows one build at a time: two would mix the glue of one with the wasm of the other.
import { mkdirSync, readFileSync, rmSync, writeFileSync } from 'node:fs'
import { setTimeout } from 'node:timers/promises'
import { path } from './files.mjs'
import { say } from './terminal.mjs'

const file = path('.build/lock')

/** Returns whether the process that wrote the lock still runs. */
function isHeld() {
  try {
    // Signal 0 only checks whether the process exists.
    return process.kill(Number(readFileSync(file, 'utf8')), 0)
  } catch {
    return false
  }
}

/** Does `work` while no other process works under this lock. */
export async function withLock(work) {
  mkdirSync(path('.build'), { recursive: true })
  for (let hasReported = false; ; await setTimeout(500)) {
    try {
      writeFileSync(file, String(process.pid), { flag: 'wx' })
      break
    } catch (error) {
      if (error.code !== 'EEXIST') throw error
      if (!isHeld()) rmSync(file, { force: true })
      else if (!hasReported) say('Waiting for another build to finish …')
      hasReported = true
    }
  }
  try {
    return await work()
  } finally {
    rmSync(file, { force: true })
  }
}

// Lists files, and runs build steps only if their files have changed.
import { createHash } from 'node:crypto'
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { good, heading, root, say, seconds } from './terminal.mjs'

/** Returns the absolute path of a path in the repository. */
export const path = (...parts) => join(fileURLToPath(root), ...parts)

/** Returns all files below `folder` (relative to the repository) whose name matches `pattern`, sorted, with '/' on every system. */
export function walk(folder, pattern = /./) {
  if (!existsSync(path(folder))) return []
  return readdirSync(path(folder), { withFileTypes: true })
    .flatMap((entry) => {
      const name = `${folder}/${entry.name}`
      if (entry.isDirectory()) return walk(name, pattern)
      return pattern.test(entry.name) ? [name] : []
    })
    .sort()
}

/** Replaces each folder by the files in it. */
const expandFolders = (inputs) =>
  inputs.flatMap((input) =>
    existsSync(path(input)) && statSync(path(input)).isDirectory() ? walk(input) : [input],
  )

function computeHash(inputs) {
  const hash = createHash('sha256')
  for (const file of expandFolders(inputs)) {
    hash.update(`${file}\0`)
    if (existsSync(path(file))) hash.update(readFileSync(path(file)))
  }
  return hash.digest('hex')
}

/**
 * Does `work`, unless it was already done for the same inputs and its outputs still exist. The stamp, a file with the hash of the inputs, is
 * written last, so that a failed step runs again.
 */
export async function step(title, { inputs, outputs, work }) {
  const stamp = path('.build/stamps', title.replace(/\W+/g, '-'))
  const hash = computeHash(inputs)
  const previousHash = existsSync(stamp) && readFileSync(stamp, 'utf8')
  if (previousHash === hash && outputs.every((file) => existsSync(path(file)))) {
    good(`${title}: up to date`)
    return
  }
  heading(title)
  const start = performance.now()
  await work()
  mkdirSync(path('.build/stamps'), { recursive: true })
  writeFileSync(stamp, hash)
  good(`${title}: ${seconds(start)}`)
  say()
}

// Lists files, and skips build steps whose files have not changed.
import { createHash } from 'node:crypto'
import { existsSync, mkdirSync, readFileSync, readdirSync, statSync, writeFileSync } from 'node:fs'
import { join } from 'node:path'
import { fileURLToPath } from 'node:url'
import { good, heading, root, say, seconds } from './terminal.mjs'

export const path = (...parts) => join(fileURLToPath(root), ...parts)

/** Returns all files below `folder` (relative to the repository) whose name matches, sorted, with '/' on every system. */
export function walk(folder, matches = /./) {
  if (!existsSync(path(folder))) return []
  return readdirSync(path(folder), { withFileTypes: true })
    .flatMap((entry) => {
      const name = `${folder}/${entry.name}`
      if (entry.isDirectory()) return walk(name, matches)
      return matches.test(entry.name) ? [name] : []
    })
    .sort()
}

/** Replaces each folder by the files in it. */
const expand = (inputs) =>
  inputs.flatMap((input) =>
    existsSync(path(input)) && statSync(path(input)).isDirectory() ? walk(input) : [input],
  )

function computeHash(inputs) {
  const hash = createHash('sha256')
  for (const file of expand(inputs)) {
    hash.update(`${file}\0`)
    if (existsSync(path(file))) hash.update(readFileSync(path(file)))
  }
  return hash.digest('hex')
}

/**
 * Does `work` unless it was done for the same inputs and its outputs still exist. The stamp is written last, so that a failed step runs
 * again.
 */
export async function step(title, { inputs, outputs, work }) {
  const stamp = path('.build/stamps', title.replace(/\W+/g, '-'))
  const current = computeHash(inputs)
  const previous = existsSync(stamp) && readFileSync(stamp, 'utf8')
  if (previous === current && outputs.every((file) => existsSync(path(file)))) {
    good(`${title}: up to date`)
    return
  }
  heading(title)
  const start = performance.now()
  await work()
  mkdirSync(path('.build/stamps'), { recursive: true })
  writeFileSync(stamp, current)
  good(`${title}: ${seconds(start)}`)
  say()
}

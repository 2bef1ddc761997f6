/** Finds the modules that modules of dist import, statically or dynamically. */
import { readFile } from 'node:fs/promises'
import { join } from 'node:path/posix'

const root = new URL('../../', import.meta.url)

/** Matches relative specifiers as a bundler writes them. */
const specifiers = /(?:\bfrom|\bimport)\s*\(?\s*["'](\.[^"']+)["']/g

/** Returns the paths of all modules that the files import, directly or indirectly, in the order of discovery. */
export async function importsOf(files) {
  const found = new Set(files)
  for (const file of found) {
    const text = await readFile(new URL(file, root), 'utf8')
    for (const [, specifier] of text.matchAll(specifiers)) found.add(join(file, '..', specifier))
  }
  return [...found].filter((file) => !files.includes(file))
}

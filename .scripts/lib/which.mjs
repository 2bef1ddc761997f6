// Finds programs and C++ headers.
import { accessSync, constants, existsSync, statSync } from 'node:fs'
import { delimiter, join } from 'node:path'

export function isProgram(file) {
  try {
    accessSync(file, constants.X_OK)
    return statSync(file).isFile()
  } catch {
    return false
  }
}

const listPaths = (name) => (process.env[name] ?? '').split(delimiter).filter(Boolean)
const findIn = (folders, names, isFound) =>
  names.flatMap((name) => folders.map((folder) => join(folder, name))).find(isFound)

/** Returns the full path of the first of `names` that is a program on PATH; `undefined` if none is. */
export const onPath = (...names) => findIn(listPaths('PATH'), names, isProgram)

const headerFolders = ['/usr', '/usr/local', '/opt/homebrew', '/opt/local'].map((prefix) =>
  join(prefix, 'include'),
)

/** Returns the path of the first of `names` that is a header in the compiler's folders; `undefined` if none is. */
export const findHeader = (...names) =>
  findIn(
    [...listPaths('CPATH'), ...listPaths('CPLUS_INCLUDE_PATH'), ...headerFolders],
    names,
    existsSync,
  )

import { accessSync, constants, statSync } from 'node:fs'
import { delimiter, isAbsolute, join } from 'node:path'

const endings = process.platform === 'win32' ? ['.exe', '.bat', '.cmd', ''] : ['']

export function isProgram(file) {
  try {
    accessSync(file, constants.X_OK)
    return statSync(file).isFile()
  } catch {
    return false
  }
}

/** Returns the full path of the first of `names` on PATH, or null. */
export function onPath(...names) {
  for (const name of names) {
    if (isAbsolute(name) && isProgram(name)) return name
    for (const folder of (process.env.PATH ?? '').split(delimiter))
      for (const ending of endings) {
        const file = join(folder, name + ending)
        if (folder && isProgram(file)) return file
      }
  }
  return null
}

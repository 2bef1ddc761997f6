// Warnings about variables that change while a sketch runs, but that an offset function reads only once.
import type { Place } from '../options/place.js'
import { globalExists, valueOfGlobal } from './globals.js'
import { noteReadOnce } from './messages.js'
import type { References } from './resolve.js'
import { assignedIn, walk } from './scopes.js'
import type { Surroundings } from './surroundings.js'
import type { Tree } from './tree.js'
import { isVectorLike, p5Prototype } from './values.js'

/** Returns whether `name` is a variable of p5 that changes between frames. */
export const isChanging = (name: string): boolean =>
  /^(p?(win)?mouse[XY]|moved[XY]|frameCount|deltaTime|(mouse|key)IsPressed|keyCode|p?(rotation|acceleration)[XYZ])$/.test(
    name,
  )

/** Returns whether a uniform can hold the value. */
const isUniformValue = (value: unknown) =>
  typeof value === 'number' ||
  typeof value === 'boolean' ||
  isVectorLike(value) ||
  (Array.isArray(value) && value.length > 1 && value.every((each) => typeof each === 'number'))

/** Warns about changing variables that a function reads. `passed` are the variables whose values are passed to the translated function. */
export function noteChanging(
  references: References,
  passed: ReadonlyMap<string, unknown>,
  surroundings: Surroundings,
  place: Place,
) {
  for (const [name, nodes] of references) {
    for (const { member } of nodes)
      if (isChanging(member ?? '') && member in p5Prototype())
        noteReadOnce(place, `${name}.${member}`)
    if (passed.has(name) || !globalExists(name)) continue
    const isRead = isChanging(name) || isUniformValue(valueOfGlobal(name))
    if (isRead && (isChanging(name) || isSetLater(name, surroundings.programs(name))))
      noteReadOnce(place, name)
  }
}

/** Returns whether the sketch sets a variable after `setup`, as far as its scripts are readable. */
function isSetLater(name: string, programs: readonly Tree[]): boolean {
  if (!programs.length) return isSettable(name)
  return programs.some((program) => setsLater(program, name))
}

/** Returns whether a global can be set at all, which is all that we know if no script is readable. */
function isSettable(name: string): boolean {
  const property = Object.getOwnPropertyDescriptor(globalThis, name)
  if (property) return !!property.writable
  try {
    new Function(`${name} = ${name}`)()
    return true
  } catch {
    return false
  }
}

/** Returns whether a function of a script sets a global. `setup` and `preload` do not count: they run before any warp is used. */
export function setsLater(program: Tree, name: string): boolean {
  let found = false
  walk(program, (node, parent) => {
    if (!/Function/.test(node.type)) return !found
    const runsFirst = /^(setup|preload)$/.test(
      node.id?.name ?? parent?.id?.name ?? parent?.left?.property?.name ?? '',
    )
    if (runsFirst) return true
    found ||= assignedIn([node]).has(name)
    return false
  })
  return found
}

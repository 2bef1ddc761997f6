/**
 * Maps a name to a model of the gallery. Each function makes a new mesh (see mesh.js) whose longest
 * side is 200 units.
 */

import { airplane } from './airplane.js'
import { bunny } from './bunny.js'
import { hand } from './hand.js'
import { spoon } from './spoon.js'
import { teapot } from './teapot.js'

export { toOBJ } from './obj.js'

export const models = { airplane, spoon, hand, bunny, teapot }

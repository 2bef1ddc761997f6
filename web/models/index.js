/**
 * The gallery's models by name. Each function makes a fresh mesh (see mesh.js), 200 units at its
 * longest.
 */

import { airplane } from './airplane.js'
import { bunny } from './bunny.js'
import { hand } from './hand.js'
import { spoon } from './spoon.js'
import { teapot } from './teapot.js'

export { toOBJ } from './obj.js'

export const models = { airplane, spoon, hand, bunny, teapot }

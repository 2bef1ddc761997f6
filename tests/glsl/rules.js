// Sources that obey or break a rule of GLSL ES 1.00 or 3.00. A browser decides in the tests which of them are valid.
import { builtIns } from './rules/built-ins.js'
import { declarations } from './rules/declarations.js'
import { expressions } from './rules/expressions.js'
import { globals } from './rules/globals.js'
import { literals } from './rules/literals.js'
import { longNames } from './rules/names.js'
import { preprocessor } from './rules/preprocessor.js'
import { qualifierOrders, typeUses } from './rules/qualifiers.js'
import { statements } from './rules/statements.js'

export { rulesOfFragments } from './rules/fragments.js'
export { declarers, reserved } from './rules/names.js'

/** Maps the title of a case → its source. */
export const rules = Object.fromEntries([
  ...preprocessor,
  ...literals,
  ...expressions,
  ...globals,
  ...declarations,
  ...statements,
  ...qualifierOrders,
  ...typeUses,
  ...longNames,
  ...builtIns,
])

/** The script of operators, which stands beside the one that holds the compiler. */
import * as all from './operators.js'

const globals = globalThis as { warpjet?: object }
Object.assign(globals.warpjet!, { operators: all.operators })

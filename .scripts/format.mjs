// npm run format: rewrites every source file in the house style.
import { format } from './lib/checks.mjs'
import { main } from './lib/terminal.mjs'

await main(format)

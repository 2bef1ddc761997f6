import { tryAll } from './program.js'

console.log(await tryAll())

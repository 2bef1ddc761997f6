// Compares sketches of p5 that use compute passes with sketches that use only the CPU.
import { approach, divide, redrawOften, refine, resemble } from './against-cpu.js'
import { compareAround } from './all-sides.js'
import { begin, leave, life } from './takeover.js'

globalThis.compute = {
  ...{ approach, divide, redrawOften, refine, resemble },
  compareAround,
  ...{ begin, leave, life },
}

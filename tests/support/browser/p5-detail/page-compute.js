// Measures compute passes in p5: sketches that use them, beside sketches that leave all to the CPU.
import { approach, divide, redrawOften, refine, resemble } from './against-cpu.js'
import { compareAround } from './all-sides.js'
import { begin, leave, life } from './takeover.js'

globalThis.compute = {
  ...{ approach, divide, redrawOften, refine, resemble },
  compareAround,
  ...{ begin, leave, life },
}

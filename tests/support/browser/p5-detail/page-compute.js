// Measures compute passes in p5: sketches that use them, beside sketches that leave all to the CPU.
import * as againstCpu from './against-cpu.js'
import * as allSides from './all-sides.js'
import * as takeover from './takeover.js'

globalThis.compute = { ...againstCpu, ...allSides, ...takeover }

// Replaces 'warpjet' in the frame of a three.js sketch, and records the shader code that the sketch makes.
import * as warpjet from 'warpjet/itself'

export * from 'warpjet/itself'
export const { compile, compileWarp, gen } = window.playground.recordAll(warpjet)

// In the frame of a sketch with three.js in the place of 'warpjet': what the sketch makes is kept.
import * as warpjet from 'warpjet/itself'

export * from 'warpjet/itself'
export const { compile, compileWarp, gen } = window.playground.keeping(warpjet)

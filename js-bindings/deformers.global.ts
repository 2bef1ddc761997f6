/** The deformers for a <script> tag after the one of p5.warpjet.min.js: adds their names to the global `warpjet`. */
import * as deformers from './deformers.js'

Object.assign((globalThis as unknown as { warpjet: object }).warpjet, deformers)

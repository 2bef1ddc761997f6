// The compiler's functions, as JavaScript calls them.
import inlined from '../generated/core-wasm.js'
import { startWithTexts } from './texts.js'

/** Of core.cpp. */
const givesText = new Set([
  'operationNames',
  'problem',
  'readingProblem',
  'code',
  'declarations',
  'inputLines',
  'allInputLines',
  'readInputLines',
  'outputLines',
])

/** `giveUp` is called when the instance has run out of memory. */
export const startCore = <Core>(giveUp: () => void): Core =>
  startWithTexts<Core>(inlined, givesText, 'warp', giveUp)

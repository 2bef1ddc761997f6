// Sources that obey or break a rule of WGSL, each complete, with a function `offset`. A browser decides in the tests which of them are
// valid.
import { calls } from './rules/calls.js'
import { globals } from './rules/globals.js'
import { operators, unary } from './rules/operators.js'
import { makeCases, withBody, withTop } from './rules/sources.js'
import { statements } from './rules/statements.js'

/** Keywords, reserved words, words of other languages, and valid names. */
export const words = `
  alias break case const const_assert continue continuing default diagnostic discard else enable false fn for if let loop override
  requires return struct switch true var while NULL Self abstract active as asm attribute auto class common compile const_cast do
  enum export extern filter final from get goto highp import inline interface layout lowp macro match mediump meta mod module move
  mut new nil null of operator package pass patch precise precision private public ref regardless resource self set shared smooth
  static std subroutine super target template this try type typedef typeof union unsafe use using varying virtual void volatile
  wgsl where with yield _ __own _own own_ own1 sin vec3 vec3f f32 array sampler texture_2d time color position noise value
  vertex fragment function storage uniform workgroup read write bitcast select ptr atomic texture
`
  .trim()
  .split(/\s+/)

export const declarers = {
  local: (word) => withBody(`var ${word} = p.x; ${word} += 1;`),
  global: (word) => withTop(`var<private> ${word}: f32;`),
  constant: (word) => withTop(`const ${word} = 1;`),
  parameter: (word) => withTop(`fn f(${word}: f32) -> f32 { return ${word}; }`),
  field: (word) => withTop(`struct S { ${word}: f32 }`),
  structure: (word) => withTop(`struct ${word} { x: f32 }`),
  function: (word) => withTop(`fn ${word}(x: i32, y: bool, z: f32) -> f32 { return z; }`),
}
export const rules = Object.fromEntries([
  ...makeCases('statement', statements, (piece) => withBody(piece)),
  ...makeCases('global declaration', globals, withTop),
  ...makeCases('call', calls, (piece) => withBody(`_ = ${piece};`)),
  ...operators,
  ...unary,
])

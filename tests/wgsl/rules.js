// Sources that obey or break a rule of WGSL, each complete, with a function `offset`. The tests ask a browser which of them are valid.
import { calls } from './rules/calls.js'
import { globals } from './rules/globals.js'
import { operators, unary } from './rules/operators.js'
import { above, body, each } from './rules/sources.js'
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

export const declaring = {
  local: (word) => body(`var ${word} = p.x; ${word} += 1;`),
  global: (word) => above(`var<private> ${word}: f32;`),
  constant: (word) => above(`const ${word} = 1;`),
  parameter: (word) => above(`fn f(${word}: f32) -> f32 { return ${word}; }`),
  field: (word) => above(`struct S { ${word}: f32 }`),
  structure: (word) => above(`struct ${word} { x: f32 }`),
  function: (word) => above(`fn ${word}(x: i32, y: bool, z: f32) -> f32 { return z; }`),
}
export const rules = Object.fromEntries([
  ...each('statement', statements, (piece) => body(piece)),
  ...each('above', globals, above),
  ...each('call', calls, (piece) => body(`_ = ${piece};`)),
  ...operators,
  ...unary,
])

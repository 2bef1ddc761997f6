/** Calls of p5 that take a shader, or draw with one of their own, where a sketch has a warp. */
import { WarpError } from '../../errors/errors.js'
import { isWarped } from '../create-warp.js'
import type { Canvas } from '../host.js'
import { madeWarpOf } from '../made-warps.js'
import { located } from './places.js'

/** Maps a method to the advice in its message. */
const instead: Record<string, string> = {
  imageShader: 'a warp is on images too; write warp() before image(…)',
  strokeShader:
    'a warp moves lines with the fill; give createWarp the option { stroke: true }, and write warp() before the shape',
  filter:
    'a warp moves vertices, and a filter changes pixels; write warp() before the shape that it is to move',
  modify: 'createWarp puts a warp on a shader; write createWarp(offset, { shader: myShader })',
}

type Method = (this: unknown, ...given: unknown[]) => unknown
type Methods = Partial<Record<string, Method>>

interface P5 {
  prototype: object
  Shader?: { prototype: object }
  /** On 2.x, by what its first sketch will change methods; friendly errors are among them. */
  readonly decorations?: Map<unknown, unknown>
  registerDecorator?(path: string, decorate: (own: Method) => Method): void
}

/** Lets p5's methods know the function that createWarp returned: `shader(warp)` calls it, others throw a `WarpError`. */
export function watchShaderCalls(p5: P5, methods: object) {
  for (const name of ['imageShader', 'strokeShader', 'filter'])
    replace(p5, methods, name, refusing(name))
  replace(p5, methods, 'shader', callingWarps)
  replace(p5, methods, 'text', notingText)
  // `buildMaterialShader()` and the like call it too.
  if (p5.Shader && methods === p5.prototype)
    replace(p5, p5.Shader.prototype, 'modify', refusing('modify'))
}

/** Around all that p5 itself has put around the method, or friendly errors would complain of the warp. */
function replace(p5: P5, object: object, name: string, make: (own: Method) => Method) {
  const methods = object as Methods
  const own = methods[name]
  if (!own) return
  if (methods === p5.prototype && p5.decorations?.size && p5.registerDecorator)
    p5.registerDecorator(`p5.prototype.${name}`, make)
  else methods[name] = make(own)
}

const refusing =
  (name: string) =>
  (own: Method): Method =>
    function (this: unknown, ...given) {
      if (madeWarpOf(given[0])) located(() => refuseWarp(name))
      return own.apply(this, given)
    }

function refuseWarp(name: string): never {
  throw new WarpError(
    `${name}: expected a shader, got the function that createWarp returned; ${instead[name]}.`,
  )
}

const callingWarps = (own: Method): Method =>
  function (this: unknown, ...given) {
    const made = madeWarpOf(given[0])
    if (!made) return own.apply(this, given)
    if (made.canvas !== this) located(refuseOther)
    ;(given[0] as () => void)()
    return this
  }

const notingText = (own: Method): Method =>
  function (this: unknown, ...given) {
    if (isWarped(this as Canvas)) noteText()
    return own.apply(this, given)
  }

function refuseOther(): never {
  throw new WarpError(
    'shader: this warp was made for another canvas; make one by createWarp of the canvas that it is to draw on, as in graphics.createWarp(…).',
  )
}

let isNoted = false

/** Said once. */
function noteText() {
  if (isNoted) return
  isNoted = true
  console.warn(
    'text: no warp moves it, since p5 draws letters with a shader of its own; draw model(font.textToModel("…", x, y)) in p5 2, or text() in a createGraphics(…) that is the texture() of a plane with many squares.',
  )
}

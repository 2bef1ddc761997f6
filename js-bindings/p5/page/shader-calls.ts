/** Watches p5's methods that take a shader or draw with a shader of their own, since sketches pass warps to them. */
import { WarpError } from '../../errors/errors.js'
import { isWarped } from '../create-warp.js'
import type { Canvas } from '../host.js'
import { madeWarpOf } from '../made-warps.js'
import { withSketchLine } from './places.js'

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
  /** Wrappers that 2.x puts around methods when its first sketch starts, such as friendly errors. */
  readonly decorations?: Map<unknown, unknown>
  registerDecorator?(path: string, decorate: (original: Method) => Method): void
}

/**
 * Makes p5's methods recognize a function that createWarp returned: `shader(warp)` calls it; the other methods that take a shader throw a
 * `WarpError`. `text()` warns if a warp is in use.
 */
export function watchShaderCalls(p5: P5, methods: object) {
  for (const name of ['imageShader', 'strokeShader', 'filter'])
    replace(p5, methods, name, rejectWarps(name))
  replace(p5, methods, 'shader', callWarps)
  replace(p5, methods, 'text', warnOnText)
  // `buildMaterialShader()` and similar functions call `modify` too.
  if (p5.Shader && methods === p5.prototype)
    replace(p5, p5.Shader.prototype, 'modify', rejectWarps('modify'))
}

/** Wraps a method around p5's own wrappers, since p5's friendly errors would reject the warp. */
function replace(p5: P5, object: object, name: string, make: (original: Method) => Method) {
  const methods = object as Methods
  const original = methods[name]
  if (!original) return
  if (methods === p5.prototype && p5.decorations?.size && p5.registerDecorator)
    p5.registerDecorator(`p5.prototype.${name}`, make)
  else methods[name] = make(original)
}

const rejectWarps =
  (name: string) =>
  (original: Method): Method =>
    function (this: unknown, ...given) {
      if (madeWarpOf(given[0])) withSketchLine(() => throwShaderExpected(name))
      return original.apply(this, given)
    }

function throwShaderExpected(name: string): never {
  throw new WarpError(
    `${name}: expected a shader, got the function that createWarp returned; ${instead[name]}.`,
  )
}

const callWarps = (original: Method): Method =>
  function (this: unknown, ...given) {
    const made = madeWarpOf(given[0])
    if (!made) return original.apply(this, given)
    if (made.canvas !== this) withSketchLine(throwOtherCanvas)
    ;(given[0] as () => void)()
    return this
  }

const warnOnText = (original: Method): Method =>
  function (this: unknown, ...given) {
    if (isWarped(this as Canvas)) warnAboutText()
    return original.apply(this, given)
  }

function throwOtherCanvas(): never {
  throw new WarpError(
    'shader: this warp was made for another canvas; make one by createWarp of the canvas that it is to draw on, as in graphics.createWarp(…).',
  )
}

let hasWarned = false

/** Warns on the first call only. */
function warnAboutText() {
  if (hasWarned) return
  hasWarned = true
  console.warn(
    'text: a warp cannot move text, since p5 draws letters with its own shader; draw model(font.textToModel("…", x, y)) in p5 2, or text() in a createGraphics(…) that is the texture() of a plane with many squares.',
  )
}

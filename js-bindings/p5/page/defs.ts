/** Reports mistakes in the option `defs`, before p5 prints the whole source of a broken shader. */
import { shorten } from '../../errors/describe.js'
import { WarpError } from '../../errors/errors.js'
import type { Renderer, Shader } from '../host.js'
import { placeOf } from './places.js'

/** The members of a WebGL context that we use. */
interface Gl {
  VERTEX_SHADER: number
  COMPILE_STATUS: number
  createShader(type: number): object | null
  shaderSource(shader: object, text: string): void
  compileShader(shader: object): void
  getShaderParameter(shader: object, name: number): unknown
  getShaderInfoLog(shader: object): string | null
  deleteShader(shader: object): void
}

interface Device {
  createShaderModule(description: { code: string }): {
    getCompilationInfo(): Promise<{
      messages: { type: string; lineNum: number; message: string }[]
    }>
  }
}

/** A line number of the shader, from 1, and the compiler's message about it. */
type Complaint = readonly [line: number, why: string]

function complaintsOf(gl: Gl, text: string): Complaint[] {
  const shader = gl.createShader(gl.VERTEX_SHADER)
  if (!shader) return []
  gl.shaderSource(shader, text)
  gl.compileShader(shader)
  const log = gl.getShaderParameter(shader, gl.COMPILE_STATUS) ? '' : gl.getShaderInfoLog(shader)
  gl.deleteShader(shader)
  const found = (log ?? '').matchAll(/^ERROR: \d+:(\d+): (.*)$/gm)
  return Array.from(found, ([, line, why]) => [+line!, why!])
}

/**
 * Returns a message with the first complaint about `defs`; `undefined` if there is none. The line after `defs` counts too: there
 * compilers report a token that is missing at the end of `defs`.
 */
function messageFor(text: string, defs: string, complaints: readonly Complaint[]) {
  const lines = defs.split('\n')
  // The number of the line of the shader at which `defs` starts.
  const first = text.slice(0, text.indexOf(defs)).split('\n').length
  const [line, why] = complaints.find(([at]) => at >= first && at <= first + lines.length) ?? []
  if (!line) return undefined
  const index = Math.min(line - first, lines.length - 1)
  return `createWarp: the option "defs" has a mistake in its line ${index + 1}, "${shorten(lines[index]!.trim())}": ${why}.`
}

/** Throws a `WarpError` if `defs` does not compile; on WebGPU asynchronously, since WebGPU compiles asynchronously. */
export function checkDefs(shader: Shader, defs: string, { GL, device }: Renderer) {
  const text = shader.vertSrc()
  if (GL) {
    const failure = messageFor(text, defs, complaintsOf(GL as unknown as Gl, text))
    if (failure) throw new WarpError(failure)
    return
  }
  const place = placeOf(new Error())
  const compiled = (device as Device).createShaderModule({ code: text }).getCompilationInfo()
  void compiled.then(({ messages }) => {
    const errors = messages.filter(({ type }) => type === 'error')
    const failure = messageFor(
      text,
      defs,
      errors.map(({ lineNum, message }) => [lineNum, message]),
    )
    if (failure) throw new WarpError(failure + place)
  })
}

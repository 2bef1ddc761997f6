/**
 * Adds a warp to vertex shaders that have no `transformed`, such as those of a ShaderMaterial or a RawShaderMaterial: instead of the
 * attributes `position` and `normal` they read warped values.
 */
import { renameMain, splitAtMain } from './shader-source.js'
import type { ThreeWarp } from './three-warp.js'
import { WarpCode } from './warp-code.js'
import type { WeaveOptions } from './weave-options.js'

export const readsPosition = (main: string) => /(?<!\.)\bposition\b/.test(main)

/** Matches declarations of attributes, and structures, whose members may have the same names. */
const declarations =
  /\b(?:attribute|in)\s+(?:(?:high|medium|low)p\s+)?vec[234]\s+\w+\s*;|\bstruct\s+\w+\s*\{[^}]*\}/g

/** Tests whether a source reads the attribute `normal`. */
export const readsNormal = (source: string) =>
  /(?<!\.)\bnormal\b/.test(source.replace(declarations, ''))

export function weaveAttributes(source: string, warp: ThreeWarp, options: WeaveOptions): string {
  const code = new WarpCode(warp, {
    isLit: readsNormal(source),
    mayHaveTangents: false,
    hasColors: options.hasColors,
    target: options.isGlsl100 ? 'glsl100' : 'glsl300',
  })
  return wrapMain(source, code, ['position', 'normal'], options)
}

/**
 * Wraps `main`, so that it reads the warped attributes from globals. The globals are declared first, since functions may read them, too.
 */
export function wrapMain(
  source: string,
  code: WarpCode,
  attributes: readonly string[],
  { isRaw }: { isRaw: boolean },
): string {
  const { isLit } = code.options
  const renamed = renameAttributes(source, attributes)
  const { top, main } = splitAtMain(renamed)!
  const results = code.evaluate('vec3( position )', { normal: 'vec3( normal )', tangent: '' })
  const assign = (name: string, value: string) =>
    attributes.includes(name) && (name !== 'normal' || isLit)
      ? `${globals[name as 'position']} = ${value};\n`
      : ''
  const statements = `{
${code.preparation}${code.guard(`${results.code}
${assign('position', results.position)}${assign('normal', results.normal)}`)}
}`
  const needed = `${code.declarations}\n${statements}`
  const [extensions, rest] = splitExtensions(top)
  return `${extensions}${attributes.map((name) => `vec3 ${globals[name as 'position']};`).join('\n')}
${rest}
${isRaw ? declareMissing(source, needed) : ''}${code.declarations}
${renameMain(main, 'warpjetMain')}
void main() {
${assign('position', 'vec3( position )')}${assign('normal', 'vec3( normal )')}${statements}
warpjetMain();
}
`
}

const globals = { position: 'warpjetInputPosition', normal: 'warpjetInputNormal' }

function renameAttributes(source: string, attributes: readonly string[]) {
  const either = new RegExp(`${declarations.source}|(?<![.\\w])(${attributes.join('|')})\\b`, 'g')
  return source.replace(either, (found, name?: 'position') => (name ? globals[name] : found))
}

/** Splits a source after its extensions, which must come before anything else. */
function splitExtensions(top: string): [string, string] {
  const end = top.lastIndexOf('#extension')
  if (end < 0) return ['', top]
  const line = top.indexOf('\n', end) + 1
  return [top.slice(0, line), top.slice(line)]
}

/** Returns declarations of variables that the code `needed` reads and a RawShaderMaterial lacks: it declares only what it reads itself. */
function declareMissing(source: string, needed: string): string {
  const qualifier = /\battribute\s/.test(source) ? 'attribute' : 'in'
  const inputs = {
    normal: `${qualifier} vec3 normal;`,
    uv: `${qualifier} vec2 uv;`,
    modelMatrix: 'uniform mat4 modelMatrix;',
  }
  return Object.entries(inputs)
    .filter(([name]) => {
      const word = new RegExp(`\\b${name}\\b`)
      return (
        word.test(needed) &&
        !new RegExp(`\\b(?:attribute|in|uniform)[^;]*\\b${name}\\s*;`).test(source)
      )
    })
    .map(([, declaration]) => `${declaration}\n`)
    .join('')
}

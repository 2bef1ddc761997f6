/**
 * Adds exact normals to vertex shaders that compute varyings from the attribute `normal`, such as those of a ShaderMaterial. Statements
 * on which the position depends keep reading the attribute, since vertices may move along it; all others read the transformed normal.
 */
import { WarpError } from '../../errors/errors.js'
import type { Place } from '../../options/place.js'
import { resolveIncludes, splitAtMain } from '../shader-source.js'
import { WarpCode } from '../warp-code.js'
import type { WeaveOptions } from '../weave-options.js'
import type { Displacement } from './displacement.js'
import { withoutComments } from './plain-source.js'
import { declaredBy, effectsOf, localTypes, statementsOf, type Statement } from './statements.js'
import { uniforms } from './vertex-source.js'

const newNormal = 'warpjetAttributeNormal'

/** Returns the shader with exact normals. Throws a `WarpError` if its varyings cannot be separated from its position. */
export function weaveAttribute(
  vertexShader: string,
  { warp }: Displacement,
  options: WeaveOptions,
  place: Place,
): string {
  const { top, main } = splitAtMain(withoutComments(resolveIncludes(vertexShader)))!
  const open = main.indexOf('{')
  const close = main.lastIndexOf('}')
  const code = new WarpCode(warp, {
    isLit: true,
    mayHaveTangents: false,
    hasColors: options.hasColors,
    target: options.isGlsl100 ? 'glsl100' : 'glsl300',
  })
  const { code: statements, normal } = code.evaluate('vec3( position )', {
    normal: 'vec3( normal )',
    tangent: '',
  })
  const body = withNewNormals(main.slice(open + 1, close), top, (statement, problem) =>
    place.error(
      `${lineOf(vertexShader, statement)}the statement "${short(statement)}" ${problem}.`,
    ),
  )
  return `${top}
${options.isRaw ? declareMissing(top, statements) : ''}${code.declarations}
${main.slice(0, open + 1)}
vec3 ${newNormal} = vec3( normal );
{
${code.preparation}${statements}
if ( ${normal} != vec3( 0.0 ) ) ${newNormal} = ${normal};
}
${body}
}
${main.slice(close + 1)}`
}

/**
 * Returns declarations of the matrices that `statements` read and a RawShaderMaterial does not declare, since it does not read them itself.
 */
const declareMissing = (top: string, statements: string) =>
  Object.entries(uniforms)
    .filter(
      ([name]) =>
        new RegExp(`\\b${name}\\b`).test(statements) &&
        !new RegExp(`\\buniform\\b[^;]*\\b${name}\\s*[;,]`).test(top),
    )
    .map(([name, type]) => `uniform ${type} ${name};\n`)
    .join('')

const varyingTypes = (top: string) =>
  new Map(
    [...top.matchAll(/\b(?:varying|out)\s+(?:(?:high|medium|low)p\s+)?(\w+)\s+([^;]+);/g)].flatMap(
      ([, type, names]) => names!.split(',').map((name) => [name.trim(), type!] as const),
    ),
  )

const globalsOf = (top: string) =>
  new Set(
    [
      ...top.matchAll(
        /(?:^|[;}])\s*(?:(?:uniform|attribute|varying|in|out|const|flat)\s+)*(?:(?:high|medium|low)p\s+)?\w+\s+(\w+)\s*(?:=[^;]*|\[[^\]]*\])?;/g,
      ),
    ].map(([, name]) => name!),
  )

const short = (statement: string) => statement.trim().replace(/\s+/g, ' ').slice(0, 80)

/** Returns line and column of a statement in the form of messages about GLSL; empty if the statement comes from a chunk. */
function lineOf(vertexShader: string, statement: string): string {
  const start = withoutComments(vertexShader).indexOf(statement.trim())
  if (start < 0) return ''
  const lines = vertexShader.slice(0, start).split('\n')
  return `line ${lines.length}, column ${lines.at(-1)!.length + 1}: `
}

/** Returns the body of `main` in which all statements read the new normal, except those on which the position depends. */
function withNewNormals(
  body: string,
  top: string,
  error: (statement: string, problem: string) => Error,
): string {
  const varyings = varyingTypes(top)
  const globals = new Set([...globalsOf(top), ...varyings.keys(), 'normal', 'position'])
  const effects = effectsOf(top, globals)
  const statements = statementsOf(body, effects)
  /** For each statement, whether the position may depend on it. */
  const isMoving = sliceOf(statements, 'gl_Position')
  const fail = ({ text }: Statement, problem: string) => error(text, problem)
  /** Maps variables that both the position and the light depend on, and that depend on no position → their copies for the light. */
  const copies = new Map<string, string>()
  /** Variables that depend on the normal, among those on which the position does not depend. */
  const normalVariables = new Set<string>()
  /** Variables that depend on the position before the displacement, among those on which the final position does not depend. */
  const positionVariables = new Set<string>()
  const movingPositions = new Set(['position'])
  const movingCalls = new Set(
    statements.filter((_, i) => isMoving[i]).flatMap(({ calls }) => [...calls]),
  )
  const some = (names: ReadonlySet<string>, test: (name: string) => boolean) =>
    [...names].some(test)
  const rename = (text: string) =>
    text.replace(/(?<![.\w])[A-Za-z_]\w*/g, (word) =>
      word === 'normal' ? newNormal : (copies.get(word) ?? word),
    )
  const locals = localTypes(statements)
  const copiesToVaryings: string[] = []
  let hasNormals = false
  const lines = statements.map((statement, i) => {
    const { text, isBlock, isDirective, reads, writes, calls } = statement
    if (isDirective) return text
    const readsNormal =
      reads.has('normal') || some(reads, (name) => copies.has(name) || normalVariables.has(name))
    if (isMoving[i]) {
      const dependsOnPosition = some(reads, (name) => movingPositions.has(name))
      if (dependsOnPosition) for (const name of writes) movingPositions.add(name)
      const writtenVaryings = [...writes].filter((name) => varyings.has(name))
      if (!readsNormal || dependsOnPosition) {
        if (isBlock && readsNormal && writtenVaryings.length)
          throw fail(
            statement,
            'moves the vertex and makes a varying of the normal; write these as two',
          )
        return text
      }
      if (isBlock || [...calls].some((name) => effects.get(name)?.reads.has('normal')))
        throw fail(statement, 'reads the normal for the position and for light; write these as two')
      // A number that moves the vertex and is shown, such as a height, is no normal.
      if ([...writes].every((name) => varyings.has(name) && !isVector(varyings.get(name)!)))
        return text
      const copy = [...writes].map((name) => {
        const copied = `warpjetCopy_${name}`
        const isDeclared = copies.has(name) || declaredBy(text) === name
        copies.set(name, copied)
        if (varyings.has(name)) hasNormals = true
        if (isDeclared) return ''
        if (varyings.has(name)) copiesToVaryings.push(`${name} = ${copied};`)
        const type = varyings.get(name) ?? locals.get(name)
        if (!type)
          throw fail(
            statement,
            'reads the normal for the position and for light; write these as two',
          )
        return `${type} ${copied} = ${name};\n`
      })
      return `${copy.join('')}${text}\n${rename(text)}`
    }
    const readsPosition = some(reads, (name) => name === 'position' || positionVariables.has(name))
    if (readsNormal) {
      if (readsPosition || some(calls, (name) => movingCalls.has(name)))
        throw fail(
          statement,
          'makes something of normal and position together, which looks like a normal by hand; leave that out and write vNormal = normalMatrix * normal',
        )
      if (some(calls, (name) => effects.get(name)?.reads.has('normal') ?? false))
        throw fail(
          statement,
          'calls a function that reads the attribute normal; pass the normal to it as an argument',
        )
      for (const name of writes) normalVariables.add(name)
      if (some(writes, (name) => varyings.has(name))) hasNormals = true
    }
    if (readsPosition) for (const name of writes) positionVariables.add(name)
    return rename(text)
  })
  if (!hasNormals)
    throw new WarpError(
      'the vertex shader makes no varying of the attribute normal; write vNormal = normalMatrix * normal, and leave out normals by hand.',
    )
  return [...lines, ...copiesToVaryings].join('\n')
}

const isVector = (type: string) => /^vec[34]$/.test(type)

/** Tests for each statement whether `name` may depend on it. */
function sliceOf(statements: readonly Statement[], name: string): boolean[] {
  const needed = new Set([name])
  return statements
    .map(({ reads, writes }, i) => ({ reads, writes, i }))
    .reverse()
    .map(({ reads, writes }) => {
      if (![...writes].some((each) => needed.has(each))) return false
      for (const each of reads) needed.add(each)
      return true
    })
    .reverse()
}

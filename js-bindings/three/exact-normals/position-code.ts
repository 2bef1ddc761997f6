/**
 * Finds how a vertex shader computes the position of a vertex: the statements up to the finished position, and the matrices that are
 * applied to it after that.
 */
import { WarpError } from '../../errors/errors.js'
import { chunkSource } from '../shader-source.js'
import { anchor } from '../weave.js'
import { assignmentsTo, countOf, isAssigned, plainLines, removeComments } from './plain-source.js'

/** The name of the function that we make of `main`, and read. */
export const movedFunction = 'warpjetMoved'

/** The statements of a shader that compute the position of a vertex, and the expression for that position in the space of the geometry. */
export interface PositionCode {
  body: string
  result: string
  /** Matrices that are replaced by the identity: `result` is the position before they are applied. */
  identityMatrices: readonly string[]
  /** The message about statements that are ignored, if there are any. */
  note?: string
}

/** Reads `main`, which follows the declarations `top`. `isInstancing` is true for a shader of an InstancedMesh. */
export function readPositionCode(main: string, top: string, isInstancing: boolean): PositionCode {
  const user = removeProjection(main)
  const moved = extractPosition(
    main.replace(
      afterProjection,
      (statement) => `${statement.slice(0, -1).replace(/[^\n]/g, ' ')};`,
    ),
    user.replace(afterProjection, ';'),
    top,
    isInstancing,
  )
  return user.search(afterProjection) < 0
    ? moved
    : {
        ...moved,
        note: 'changes gl_Position after projectionMatrix, which its normals ignore.',
      }
}

/** Matches statements that change `gl_Position` after it was set. */
const afterProjection =
  /(?<![.\w])gl_Position\s*(?:\.\w+\s*[-+*/]?=(?!=)|[-+*/]=|=(?!=)[^;]*\bgl_Position\b)[^;]*;/g

/** Reads `main`. `user` is `main` without the lines by which three.js' chunks apply matrices. */
function extractPosition(
  main: string,
  user: string,
  top: string,
  isInstancing: boolean,
): PositionCode {
  const end = anchor.exec(main)?.index
  const open = (text: string) =>
    text.replace(/\bvoid\s+main\s*\([^)]*\)/, `vec3 ${movedFunction}()`)
  if (end !== undefined && !isAssigned(user, 'gl_Position') && !isAssigned(user, 'mvPosition'))
    return { body: open(main.slice(0, end)), result: 'vec3( transformed )', identityMatrices: [] }
  rejectOtherProjections(`${top}\n${user}`)
  // Three's own lines apply the matrices of instances to normals, whatever happens to the position.
  const isInstanced = /\btransformedNormal\b/.test(main)
    ? isInstancing
    : countOf(user, 'instanceMatrix') > 0
  return { body: open(main).replace(/\}\s*$/, ''), ...findLastMatrix(user, top, isInstanced) }
}

/** Throws for a position that is moved after the projection, and for a shader that uses `projectionMatrix` in another way. */
function rejectOtherProjections(text: string) {
  const reads = text.match(/(?<![.\w])projectionMatrix\b(?!\s*\*)/)
  if (reads)
    throw new WarpError(
      'the vertex shader reads projectionMatrix without multiplying it by the position, so exactNormals cannot find the position; write gl_Position = projectionMatrix * position.',
    )
  for (const [, name] of text.matchAll(/\bvec4\s+(\w+)\s*=\s*[^;]*\bprojectionMatrix\s*\*/g))
    if ([...text.matchAll(assignmentsTo(name!))].length > 1)
      throw new WarpError(
        `the vertex shader changes ${name} after projectionMatrix; move the vertex before that.`,
      )
}

/** Chunks of three.js that read matrices, or compute `gl_Position` from `transformed`. */
const projectionChunks = [
  'project_vertex',
  'logdepthbuf_vertex',
  'defaultnormal_vertex',
  'worldpos_vertex',
  'shadowmap_vertex',
  'envmap_vertex',
].map((name) => plainLines(removeComments(chunkSource(name))))

export const removeProjection = (main: string) =>
  projectionChunks.reduce(
    (text, chunk) => (chunk ? text.replaceAll(chunk, '') : text),
    plainLines(main),
  )

/**
 * Finds the last matrix that is applied to the finished position, and the expression for the position before it. Earlier matrices stay in
 * the computation, since the shader may move vertices between them.
 */
function findLastMatrix(
  user: string,
  top: string,
  isInstanced: boolean,
): Omit<PositionCode, 'body'> {
  const text = `${top}\n${user}`
  const isLast = (matrix: string, others: readonly string[]) =>
    countOf(text, matrix) === 1 &&
    countOf(text, 'projectionMatrix') === 1 &&
    others.every((name) => countOf(text, name) === 0) &&
    isAppliedAtEnd(user, matrix)
  if (isLast('modelViewMatrix', ['viewMatrix'])) {
    const hidesInstance =
      isInstanced &&
      countOf(text, 'instanceMatrix') === 1 &&
      /\bmodelViewMatrix\s*\*\s*instanceMatrix\s*\*\s*vec4\s*\(/.test(user)
    return hidesInstance
      ? {
          result: 'warpjetClip.xyz',
          identityMatrices: ['projectionMatrix', 'modelViewMatrix', 'instanceMatrix'],
        }
      : {
          result: isInstanced
            ? '( inverse( instanceMatrix ) * warpjetClip ).xyz'
            : 'warpjetClip.xyz',
          identityMatrices: ['projectionMatrix', 'modelViewMatrix'],
        }
  }
  const toObject = (matrix: string) =>
    `( inverse( ${matrix}${isInstanced ? ' * instanceMatrix' : ''} ) * warpjetClip ).xyz`
  if (isLast('viewMatrix', ['modelViewMatrix']))
    return { result: toObject('modelMatrix'), identityMatrices: ['projectionMatrix', 'viewMatrix'] }
  return {
    result: toObject('( viewMatrix * modelMatrix )'),
    identityMatrices: ['projectionMatrix'],
  }
}

/** Tests whether nothing changes the product of a matrix and a position before it reaches `gl_Position`. */
function isAppliedAtEnd(user: string, matrix: string): boolean {
  if (user.match(/(?<![.\w])gl_Position\b/g)?.length !== 1) return false
  if (
    new RegExp(`gl_Position\\s*=\\s*projectionMatrix\\s*\\*\\s*\\(?\\s*${matrix}\\s*\\*`).test(user)
  )
    return true
  const [, name] = new RegExp(`\\bvec4\\s+(\\w+)\\s*=\\s*\\(?\\s*${matrix}\\s*\\*`).exec(user) ?? []
  if (!name) return false
  const assignments = user.match(assignmentsTo(name))
  return (
    assignments?.length === 1 &&
    new RegExp(`gl_Position\\s*=\\s*projectionMatrix\\s*\\*\\s*${name}\\s*;`).test(user)
  )
}

// Determines whether a displacement is applied before or after the pose, which is morph targets and bones.
import type { Place } from '../../options/place.js'
import type { WarpSpace } from '../settings.js'
import { chunkSource, resolveIncludes } from '../shader-source.js'
import { anchor, splitAtAnchor } from '../weave.js'
import { removeProjection } from './position-code.js'
import type { ExactShader } from './shader.js'

const assignment = /(?<![.\w])transformed\s*(?:\.\w+\s*)?[-+*/]?=(?!=)/

/** Matches a change of `mvPosition`, three.js' position in view space. */
const viewAssignment = /(?<![.\w])(?<!\bvec4\s+)mvPosition\s*(?:\.\w+\s*)?[-+*/]?=(?!=)/

/** Returns the space of the displacement. Throws a `WarpError` if the shader moves vertices both before and after the pose. */
export function findSpace(shader: ExactShader, place: Place): WarpSpace {
  if (!shader.skinning && !shader.morphTargets) return 'rest'
  const { main = '' } = splitAtAnchor(resolveIncludes(shader.vertexShader)) ?? {}
  const [before = '', after] = main
    .slice(0, anchor.exec(main)?.index)
    .split(chunkSource('skinning_vertex'))
  if (after === undefined)
    throw place.error(
      'expected the chunk skinning_vertex of three.js, got a vertex shader without it. warpjet needs it to separate the displacement from bones and morph targets.',
    )
  if (viewAssignment.test(removeProjection(main)))
    throw place.error(
      'the vertex shader moves mvPosition on a mesh with bones or morph targets; change `transformed` instead, after #include <skinning_vertex>.',
    )
  const userCode = removeChunks(after, ['displacementmap_vertex'])
  if (!assignment.test(userCode)) return 'rest'
  if (assignment.test(removeChunks(before, ['begin_vertex', 'morphtarget_vertex'])))
    throw place.error(
      'the vertex shader moves vertices before morph targets and bones, and again after them; write both in one place.',
    )
  if (/(?<![.\w])position\b/.test(userCode))
    throw place.error(
      'the vertex shader moves vertices after morph targets and bones, but reads the attribute `position`, which they have not changed; read `transformed` instead.',
    )
  return 'local'
}

const removeChunks = (text: string, chunks: readonly string[]) =>
  chunks.reduce((rest, name) => rest.replace(chunkSource(name), ''), text)

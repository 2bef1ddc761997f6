// Determines whether a displacement is applied before or after morph targets and bones.
import type { Place } from '../../options/place.js'
import type { WarpSpace } from '../settings.js'
import { chunkSource, resolveIncludes } from '../shader-source.js'
import { anchor, splitAtAnchor } from '../weave.js'
import { withoutProjection } from './moved-body.js'
import type { ExactShader } from './shader.js'

const assignment = /(?<![.\w])transformed\s*(?:\.\w+\s*)?[-+*/]?=(?!=)/

/** Matches a change of `mvPosition`, three.js' position in view space. */
const viewAssignment = /(?<![.\w])(?<!\bvec4\s+)mvPosition\s*(?:\.\w+\s*)?[-+*/]?=(?!=)/

/** Returns the space of the displacement. Throws a `WarpError` if the shader moves vertices both before and after the pose. */
export function spaceOf(shader: ExactShader, place: Place): WarpSpace {
  if (!shader.skinning && !shader.morphTargets) return 'rest'
  const { main = '' } = splitAtAnchor(resolveIncludes(shader.vertexShader)) ?? {}
  const [before = '', after] = main
    .slice(0, anchor.exec(main)?.index)
    .split(chunkSource('skinning_vertex'))
  if (after === undefined)
    throw place.error(
      'expected the chunk skinning_vertex of three.js, got a vertex shader without it, in which the displacement cannot be separated from bones and morph targets.',
    )
  if (viewAssignment.test(withoutProjection(main)))
    throw place.error(
      'the vertex shader moves mvPosition on a mesh with bones or morph targets; move transformed, behind #include <skinning_vertex>.',
    )
  const userCode = without(after, ['displacementmap_vertex'])
  if (!assignment.test(userCode)) return 'rest'
  if (assignment.test(without(before, ['begin_vertex', 'morphtarget_vertex'])))
    throw place.error(
      'the vertex shader moves vertices before morph targets and bones, and again after them; write both in one place.',
    )
  if (/(?<![.\w])position\b/.test(userCode))
    throw place.error(
      'the vertex shader moves vertices after morph targets and bones by the attribute position, which is from before them; read transformed.',
    )
  return 'local'
}

const without = (text: string, chunks: readonly string[]) =>
  chunks.reduce((rest, name) => rest.replace(chunkSource(name), ''), text)

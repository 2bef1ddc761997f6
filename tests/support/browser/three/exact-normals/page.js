// A page that compares the normals that `exactNormals` computes for displacements with finite differences in double precision.
import * as THREE from 'three'
import { addSurfaceVariation, exactNormals } from 'warpjet/three'
import { chunks, customShaderMaterials, objects, shaderMaterials, unsupported } from './cases.js'
import { longLoops, manyStates } from './glsl-loops.js'
import { habits, measureHabit } from './habits.js'
import { measure } from './measure.js'
import * as meshes from './meshes.js'

const tables = { chunks, objects, customShaderMaterials, shaderMaterials, longLoops, unsupported }

globalThis.THREE = THREE
globalThis.exact = {
  exactNormals,
  addSurfaceVariation,
  names: Object.fromEntries(
    Object.entries(tables).map(([table, rows]) => [table, Object.keys(rows)]),
  ),
  /** Measures the differences from the oracle. `normals` is the option of `exactNormals`; if it is missing, the material is not changed. */
  measure: (table, name, normals) =>
    measure(tables[table][name], normals, table !== 'shaderMaterials'),
  /** Measures a loop that cannot stay a loop, against a loop of that many iterations. */
  measureManyStates({ iterations, ...options }) {
    const { movedBy, material, ...row } = manyStates
    return measure({ ...row, moved: movedBy(iterations), material }, options, true)
  },
  /** Returns the expected message, and whether the material has the same normals as without `exactNormals`. */
  async unsupported(name) {
    const { material, message, kind } = unsupported[name]
    const shown = []
    for (const candidate of [material(), exactNormals(material())])
      shown.push(
        await measure({ material: () => candidate, shape: 'plane', kind }, undefined, false, true),
      )
    return {
      message: message.source,
      isSame: shown[0].every((number, i) => Object.is(number, shown[1][i])),
    }
  },
}
Object.assign(exact, meshes, { measureHabit })
exact.names.habits = Object.keys(habits)
document.title = 'ready'

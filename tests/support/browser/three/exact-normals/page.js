// A page that measures exact normals of displacements against differences in double precision.
import * as THREE from 'three'
import { addSurfaceVariation, exactNormals } from 'warpjet/three'
import { chunks, objects, ofCustomShaderMaterial, ofShaderMaterial, unsupported } from './cases.js'
import { habits, measureHabit } from './habits.js'
import { measure } from './measure.js'
import * as meshes from './meshes.js'

const tables = { chunks, objects, ofCustomShaderMaterial, ofShaderMaterial, unsupported }

globalThis.THREE = THREE
globalThis.exact = {
  exactNormals,
  addSurfaceVariation,
  names: Object.fromEntries(
    Object.entries(tables).map(([table, rows]) => [table, Object.keys(rows)]),
  ),
  /** Returns the largest differences from the oracle. `normals` is the option; without it, the material is not changed. */
  measure: (table, name, normals) =>
    measure(tables[table][name], normals, table !== 'ofShaderMaterial'),
  /** Returns the expected message, and whether the material looks the same as without `exactNormals`. */
  async unsupported(name) {
    const { material, message, kind } = unsupported[name]
    const shown = []
    for (const each of [material(), exactNormals(material())])
      shown.push(
        await measure({ material: () => each, shape: 'plane', kind }, undefined, false, true),
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

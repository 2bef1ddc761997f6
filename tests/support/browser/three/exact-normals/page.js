// A page that measures exact normals of displacements against differences in double precision.
import * as THREE from 'three'
import { addSurfaceVariation, exactNormals } from 'warpjet/three'
import { chunks, ofCustomShaderMaterial, ofShaderMaterial, refused } from './cases.js'
import { measure } from './measure.js'

const tables = { chunks, ofCustomShaderMaterial, ofShaderMaterial, refused }

globalThis.THREE = THREE
globalThis.exact = {
  exactNormals,
  addSurfaceVariation,
  names: Object.fromEntries(
    Object.entries(tables).map(([table, rows]) => [table, Object.keys(rows)]),
  ),
  /** → the largest differences from the oracle. `normals` is the option; without it the material stays as it is. */
  measure: (table, name, normals) =>
    measure(tables[table][name], normals, table === 'chunks' || table === 'ofCustomShaderMaterial'),
  refused(name) {
    const { material, message } = refused[name]
    const pictures = [material(), exactNormals(material())].map((each) =>
      measure({ material: () => each, shape: 'plane' }, undefined, false, true),
    )
    return {
      message: message.source,
      isSame: pictures[0].every(
        (number, i) =>
          number === pictures[1][i] || (Number.isNaN(number) && Number.isNaN(pictures[1][i])),
      ),
    }
  },
}
document.title = 'ready'

// Loads model files with three.js' own loaders, and returns the triangles of the scene.
import { MeshoptDecoder } from 'meshoptimizer'
import { LoadingManager, Matrix4, Vector3 } from 'three'
import { GLTFLoader } from 'three/examples/jsm/loaders/GLTFLoader.js'
import { OBJLoader } from 'three/examples/jsm/loaders/OBJLoader.js'
import { STLLoader } from 'three/examples/jsm/loaders/STLLoader.js'

// The loader reads `navigator.userAgent` to detect Safari.
globalThis.navigator ??= { userAgent: '' }
globalThis.self ??= globalThis
globalThis.ProgressEvent ??= class {}

/** Matches names of variants that three.js does not load, or loads differently. Textures would need a page, Draco would need workers. */
const unsupported =
  /texture|Draco|external|fallback|UTF-16|mark|"solid"|none|specular|CR$|KHR meshopt|hidden/

/** Returns the triangles of a file; `undefined` if three.js does not load it in the same way. */
export async function readByThree(name, file) {
  if (unsupported.test(name)) return undefined
  const buffer = file.slice().buffer
  const text = () => new TextDecoder().decode(file)
  if (name.includes('STL')) return trianglesOfGeometry(new STLLoader().parse(buffer))
  if (name.includes('OBJ')) return trianglesOfScene(new OBJLoader().parse(text()))
  const loader = new GLTFLoader(new LoadingManager()).setMeshoptDecoder(MeshoptDecoder)
  const { scene } = await loader.parseAsync(buffer, '')
  return trianglesOfScene(scene)
}

const cornersOf = ({ index, attributes }) =>
  index ? [...index.array] : [...Array(attributes.position.count).keys()]

function trianglesOfGeometry(geometry) {
  const { position } = geometry.attributes
  return groupByThree(
    cornersOf(geometry).map((i) => new Vector3().fromBufferAttribute(position, i).toArray()),
  )
}

const groupByThree = (points) =>
  Array.from({ length: points.length / 3 }, (_, i) => points.slice(3 * i, 3 * i + 3))

function trianglesOfScene(scene) {
  scene.updateMatrixWorld(true)
  const triangles = []
  scene.traverseVisible((object) => {
    if (!object.isMesh) return
    object.skeleton?.update()
    for (const instance of instancesOf(object)) {
      const toWorld = object.matrixWorld.clone().multiply(instance)
      const points = cornersOf(object.geometry).map((i) =>
        object.getVertexPosition(i, new Vector3()).applyMatrix4(toWorld).toArray(),
      )
      const isMirrored = toWorld.determinant() < 0
      triangles.push(
        ...groupByThree(points).map(([a, b, c]) => (isMirrored ? [a, c, b] : [a, b, c])),
      )
    }
  })
  return triangles
}

function instancesOf(object) {
  if (!object.isInstancedMesh) return [new Matrix4()]
  return Array.from({ length: object.count }, (_, i) => {
    const matrix = new Matrix4()
    object.getMatrixAt(i, matrix)
    return matrix
  })
}

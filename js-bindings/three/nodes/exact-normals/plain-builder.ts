// A builder of three.js without a renderer, for nodes whose code no shader needs: on the CPU, or in any host.
import { BufferAttribute, BufferGeometry, Mesh } from 'three'
import { GLSLNodeBuilder, MeshBasicNodeMaterial, PerspectiveCamera, Scene } from 'three/webgpu'
import { WarpError } from '../../../errors/errors.js'
import { knownAttributes, type ReadingBuilder } from './reading-builder.js'

/** The part of a renderer that a builder reads while it writes the code of a node. */
const renderer = {
  backend: { isWebGLBackend: true, hasFeature: () => true, extensions: { has: () => true } },
  debug: { diagnostics: { keywords: false } },
  contextNode: undefined,
  library: {},
  shadowMap: {},
  coordinateSystem: 2000,
  hasFeature: () => true,
  hasCompatibility: () => true,
  getRenderTarget: () => null,
  getMRT: () => null,
}

/** A geometry with the attributes that an offset function knows. */
function geometryOfInputs(): BufferGeometry {
  const made = new BufferGeometry()
  for (const [name, size] of [
    ['position', 3],
    ['normal', 3],
    ['uv', 2],
  ] as const)
    made.setAttribute(name, new BufferAttribute(new Float32Array(3 * size), size))
  return made
}

/** Makes a builder that writes GLSL. `place` begins messages. */
export function plainBuilder(place: string): ReadingBuilder {
  const material = new MeshBasicNodeMaterial()
  const object = new Mesh(geometryOfInputs(), material)
  const made = new GLSLNodeBuilder(object, renderer as never) as unknown as ReadingBuilder
  Object.assign(made, {
    material,
    scene: new Scene(),
    camera: new PerspectiveCamera(),
    // Three.js writes zeros for an attribute that the geometry lacks.
    hasGeometryAttribute(name: string) {
      if (knownAttributes.has(name)) return true
      throw new WarpError(
        `${place}: the function reads the attribute "${name}", which an offset has not; expected a function of position, normalLocal, uv(), time, uniform() and texture().`,
      )
    },
  })
  return made
}

// A node builder of three.js without a renderer, to read nodes for the CPU and for other hosts.
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
  const geometry = new BufferGeometry()
  for (const [name, size] of [
    ['position', 3],
    ['normal', 3],
    ['uv', 2],
  ] as const)
    geometry.setAttribute(name, new BufferAttribute(new Float32Array(3 * size), size))
  return geometry
}

/** Makes a builder that writes GLSL. `place` begins messages. */
export function plainBuilder(place: string): ReadingBuilder {
  const material = new MeshBasicNodeMaterial()
  const object = new Mesh(geometryOfInputs(), material)
  const builder = new GLSLNodeBuilder(object, renderer as never) as unknown as ReadingBuilder
  Object.assign(builder, {
    material,
    scene: new Scene(),
    camera: new PerspectiveCamera(),
    // Three.js writes zeros for an attribute that the geometry lacks.
    hasGeometryAttribute(name: string) {
      if (knownAttributes.has(name)) return true
      throw new WarpError(
        `${place}: the function reads the attribute "${name}", which an offset function does not have; expected a function of position, normalLocal, uv(), time, uniform() and texture().`,
      )
    },
  })
  return builder
}

// The displacement of a mesh, read from the shader that was compiled last. Before the first compilation it is read from a new shader.
import type { IUniform, Material, Mesh } from 'three'
import { definesFor } from './defines.js'
import type { Displacement } from './displacement.js'
import { exactMaterialOf, messageOf, type ExactMaterial } from './exact-material.js'
import type { ExactShader } from './shader.js'
import { createShader, parametersOf } from './uncompiled-shader.js'

export class MeshDisplacement {
  private uncompiled:
    { state: string; userCompile: unknown; shader: ExactShader | undefined } | undefined
  private readonly cache = new Map<
    string,
    { source: string; displacement: Displacement | undefined }
  >()

  constructor(readonly mesh: Mesh) {}

  get exact(): ExactMaterial | undefined {
    return exactMaterialOf(this.mesh.material as Material)
  }

  /** Reads the displacement for the CPU, where the matrix of the mesh is known. */
  readForCpu(): Displacement | undefined {
    return this.read('cpu', { modelMatrix: () => this.mesh.matrixWorld })
  }

  /** Reads the displacement for a shader of another material, such as that of shadows. */
  readForGpu(): Displacement | undefined {
    return this.read('gpu')
  }

  /** Returns `undefined` if the material has no exact normals or no shader; warns and returns `undefined` if the shader cannot be read. */
  private read(key: string, values?: Record<string, () => unknown>): Displacement | undefined {
    const { exact } = this
    const shader = exact && this.shaderOf(exact)
    if (!shader) return undefined
    const complete = this.forMesh(exact, shader)
    const source = [exact.material.id, definesFor(complete), complete.vertexShader].join('\n')
    const cached = this.cache.get(key)
    if (cached?.source === source) return cached.displacement
    let displacement: Displacement | undefined
    try {
      displacement = exact.read(complete, values)
    } catch (error) {
      exact.warn(
        `cannot be read for shadows, culling and raycasts, which ignore its displacement: ${messageOf(error)}`,
      )
    }
    this.cache.set(key, { source, displacement })
    return displacement
  }

  private shaderOf(exact: ExactMaterial): ExactShader | undefined {
    return exact.compiled ?? this.makeUncompiledShader(exact)
  }

  /** Calls the material's own `onBeforeCompile` with a new shader, once for each state of the material. */
  private makeUncompiledShader({
    material,
    userCompile,
    state,
  }: ExactMaterial): ExactShader | undefined {
    if (this.uncompiled?.state === state && this.uncompiled.userCompile === userCompile)
      return this.uncompiled.shader
    let shader = createShader(material, this.mesh)
    try {
      if (shader) userCompile.call(material, shader as never, undefined as never)
    } catch {
      // `onBeforeCompile` may need the renderer.
      shader = undefined
    }
    this.uncompiled = { state, userCompile, shader }
    return shader
  }

  /** Returns a copy of the shader with the parameters of this mesh; its uniforms are those that were compiled last. */
  private forMesh(exact: ExactMaterial, shader: ExactShader): ExactShader {
    const newest = () => this.shaderOf(exact)?.uniforms ?? shader.uniforms
    const uniforms = new Proxy({} as Record<string, IUniform>, {
      get: (_, name) => newest()[name as string],
    })
    return { ...shader, ...parametersOf(exact.material, this.mesh), uniforms }
  }
}

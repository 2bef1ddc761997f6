// The displacement of a mesh, read from the shader that was compiled last or, before that, from one that is made for it.
import type { IUniform, Material, Mesh } from 'three'
import { definesFor } from './defines.js'
import { exactMaterialOf, messageOf, type ExactMaterial } from './exact-material.js'
import { parametersOf, plainShader } from './plain-shader.js'
import type { Reading } from './reading.js'
import type { ExactShader } from './shader.js'

export class MeshReading {
  private plain:
    { state: string; userCompile: unknown; shader: ExactShader | undefined } | undefined
  private readonly readings = new Map<string, { source: string; reading: Reading | undefined }>()

  constructor(readonly mesh: Mesh) {}

  get exact(): ExactMaterial | undefined {
    return exactMaterialOf(this.mesh.material as Material)
  }

  /** Returns the displacement for the CPU, which knows the matrix of the mesh. */
  onCpu(): Reading | undefined {
    return this.read('cpu', { modelMatrix: () => this.mesh.matrixWorld })
  }

  /** Returns the displacement for another shader. */
  onGpu(): Reading | undefined {
    return this.read('gpu')
  }

  /** Returns `undefined` if the material moves no vertices, or cannot be read, which it says itself. */
  private read(key: string, values?: Record<string, () => unknown>): Reading | undefined {
    const { exact } = this
    const shader = exact && this.shaderOf(exact)
    if (!shader) return undefined
    const complete = this.forMesh(exact, shader)
    const source = [exact.material.id, definesFor(complete), complete.vertexShader].join('\n')
    const known = this.readings.get(key)
    if (known?.source === source) return known.reading
    let reading: Reading | undefined
    try {
      reading = exact.read(complete, values)
    } catch (error) {
      exact.warn(
        `cannot be read for shadows, culling and rays, which ignore its displacement: ${messageOf(error)}`,
      )
    }
    this.readings.set(key, { source, reading })
    return reading
  }

  private shaderOf(exact: ExactMaterial): ExactShader | undefined {
    return exact.compiled ?? this.plainShader(exact)
  }

  /** Calls the material's own `onBeforeCompile` with a new shader, once for each state of the material. */
  private plainShader({ material, userCompile, state }: ExactMaterial): ExactShader | undefined {
    if (this.plain?.state === state && this.plain.userCompile === userCompile)
      return this.plain.shader
    let shader = plainShader(material, this.mesh)
    try {
      if (shader) userCompile.call(material, shader as never, undefined as never)
    } catch {
      // It may need the renderer.
      shader = undefined
    }
    this.plain = { state, userCompile, shader }
    return shader
  }

  /** Returns the same shader with the parameters of this mesh and the uniforms that were compiled last. */
  private forMesh(exact: ExactMaterial, shader: ExactShader): ExactShader {
    const newest = () => this.shaderOf(exact)?.uniforms ?? shader.uniforms
    const uniforms = new Proxy({} as Record<string, IUniform>, {
      get: (_, name) => newest()[name as string],
    })
    return { ...shader, ...parametersOf(exact.material, this.mesh), uniforms }
  }
}

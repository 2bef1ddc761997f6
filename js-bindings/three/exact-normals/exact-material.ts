// Makes the normals of a material exact when three.js compiles its shaders.
import type { Material, Object3D, RawShaderMaterial, WebGLRenderer } from 'three'
import { Place } from '../../options/place.js'
import { nameOfMaterial } from '../describe.js'
import { orientFaces } from '../faces.js'
import type { PixelNormals } from '../pixel-normals.js'
import { pixelNormalsFor } from '../pixel-stage.js'
import { wrapMethod } from '../properties.js'
import { uniformsFor } from '../shader-weaver.js'
import { weavePixelNormals, weaveVertexNormals } from '../weave-fragment.js'
import type { WeaveOptions } from '../weave-options.js'
import { areNormalsAtVertices } from './at-vertices.js'
import { noteConstants } from './constants.js'
import { readDisplacement, type Displacement, type ExactSettings } from './displacement.js'
import { withExactFunctions, withExactNames, withNamesOfShader } from './exact-names.js'
import { declareParameters, obstacleInParameters } from './parameters.js'
import { findSpace } from './pose-space.js'
import type { ExactShader } from './shader.js'
import { weaveAttribute } from './weave-attribute.js'
import { makesNormal, obstacleInChunks, weaveChunks } from './weave-chunks.js'

const exactMaterials = new WeakMap<Material, ExactMaterial>()

export const exactMaterialOf = (material: Material) => exactMaterials.get(material)

/** Makes the normals of a material exact. A second call changes the options. */
export function exactMaterial(material: Material, settings: ExactSettings): ExactMaterial {
  let exact = exactMaterials.get(material)
  if (exact) exact.settings = settings
  else exactMaterials.set(material, (exact = new ExactMaterial(material, settings)))
  material.needsUpdate = true
  return exact
}

export class ExactMaterial {
  /** The shader that was compiled last, as it was before exact normals were added, and the key of its source. */
  private last: { shader: ExactShader; key: string } | undefined
  private compilations = 0
  private lastKey: { version: number; key: string } | undefined
  private userKey!: () => string
  /** The material's `onBeforeCompile` without exact normals. */
  userCompile!: Material['onBeforeCompile']
  /** The object that was drawn last with the material. */
  private lastObject: Object3D | undefined
  private readonly warned = new Set<string>()

  constructor(
    readonly material: Material,
    public settings: ExactSettings,
  ) {
    this.wrapCompile()
    this.wrapKey()
    const recordObject = (object: Object3D) => void (this.lastObject = object)
    wrapMethod<Material['onBeforeRender']>(material, 'onBeforeRender', (original) => {
      return function (this: Material, ...values) {
        recordObject(values[4] as never)
        original?.apply(this, values)
      }
    })
  }

  get place() {
    return new Place(this.settings.method)
  }

  /** Returns the shader that was compiled last, unless the source has changed after that. */
  get compiled(): ExactShader | undefined {
    return this.last?.key === this.sourceKey ? this.last.shader : undefined
  }

  /** A key that changes with each change of the source and with each compilation. */
  get state(): string {
    return `${this.compilations} ${this.sourceKey}`
  }

  /** A key of everything on which the source of the vertex shader depends. It may change when `needsUpdate` is set. */
  private get sourceKey(): string {
    const { id, version, defines, vertexShader } = this.material as Material & {
      defines?: object
      vertexShader?: string
    }
    if (this.lastKey?.version !== version)
      this.lastKey = {
        version,
        key: [id, JSON.stringify(defines), vertexShader, this.userKey()].join('\n'),
      }
    return this.lastKey.key
  }

  /** Warns on the console; prints each message only once. */
  warn(message: string) {
    const text = `${this.settings.method}: ${nameOfMaterial(this.material)} ${message}`
    if (this.warned.has(text)) return
    this.warned.add(text)
    console.warn(text)
  }

  /** Reads the displacement of a shader. Throws a `WarpError` if that is impossible. */
  read(shader: ExactShader, values?: Record<string, () => unknown>): Displacement {
    return readDisplacement(
      shader,
      this.settings,
      findSpace(shader, this.place),
      values,
      this.material,
    )
  }

  private wrapCompile() {
    const compile = this.compile.bind(this)
    let depth = 0
    wrapMethod<Material['onBeforeCompile']>(this.material, 'onBeforeCompile', (original) => {
      this.userCompile = original
      return function (this: Material, shader, renderer) {
        // A method that was assigned later may call this one.
        depth++
        try {
          original.call(this, shader, renderer)
        } finally {
          depth--
        }
        if (depth === 0) compile(shader as unknown as ExactShader, renderer)
      }
    })
  }

  private wrapKey() {
    const { material } = this
    const key = () => {
      const { normals, surfaceVariation, maxIterations } = this.settings
      return `exactNormals ${normals} ${surfaceVariation} ${maxIterations} ${areNormalsAtVertices()} ${this.userKey()}`
    }
    wrapMethod<Material['customProgramCacheKey']>(material, 'customProgramCacheKey', (original) => {
      // The default key is the text of the method onBeforeCompile, so `original` must see the material's own method, not our wrapper.
      this.userKey = () =>
        original.call(
          Object.create(material, { onBeforeCompile: { value: this.userCompile } }) as Material,
        )
      return key
    })
  }

  /** Adds exact normals to a shader. An error would be thrown by `render()`, so we print it as a warning and leave the shader unchanged. */
  private compile(shader: ExactShader, renderer: WebGLRenderer) {
    this.last = { shader: { ...shader }, key: this.sourceKey }
    this.compilations++
    const { isShaderMaterial } = this.material as Partial<RawShaderMaterial>
    const usesChunks = makesNormal(shader.vertexShader)
    // Materials without light have no normals.
    if (!usesChunks && !isShaderMaterial) return
    try {
      const displacement = this.read(shader)
      const { warp, note, cutOff } = displacement
      if (note) this.warn(note)
      if (warp.isRigid) return
      if (cutOff) this.warn(cutOff)
      const woven = usesChunks
        ? this.weaveChunks(shader, renderer, displacement)
        : this.weaveAttribute(shader, displacement)
      this.replaceSources(shader, displacement, woven)
      noteConstants(this, displacement, this.lastObject)
    } catch (error) {
      this.warn(`keeps its own normals: ${messageOf(error)}`)
    }
  }

  private weaveChunks(shader: ExactShader, renderer: WebGLRenderer, displacement: Displacement) {
    const { warp } = displacement
    const pixel = this.pixelFor(shader, renderer, displacement)
    const vertexShader = weaveChunks(
      shader.vertexShader,
      displacement,
      this.weaveOptions(shader),
      pixel,
    )
    if (areNormalsAtVertices()) return { vertexShader, fragmentShader: shader.fragmentShader }
    const fragmentShader = pixel
      ? weavePixelNormals(
          declareParameters(shader.fragmentShader, displacement),
          pixel,
          String(shader.precision),
        )
      : weaveVertexNormals(shader.fragmentShader)
    return { vertexShader, fragmentShader: orientFaces(fragmentShader, warp) }
  }

  private pixelFor(
    shader: ExactShader,
    renderer: WebGLRenderer,
    displacement: Displacement,
  ): PixelNormals | undefined {
    if (areNormalsAtVertices()) return undefined
    return pixelNormalsFor(
      shader as never,
      this.material,
      renderer,
      displacement.warp,
      nameOfMaterial(this.material),
      (vertexShader) => obstacleInParameters(displacement) ?? obstacleInChunks(vertexShader),
    )
  }

  private weaveAttribute(shader: ExactShader, displacement: Displacement) {
    if (this.settings.normals === 'pixel')
      this.warn(
        "has its normals computed at vertices, although the option normals is 'pixel': its vertex shader lacks the chunks beginnormal_vertex and defaultnormal_vertex of three.js.",
      )
    return {
      vertexShader: weaveAttribute(
        shader.vertexShader,
        displacement,
        this.weaveOptions(shader),
        this.place,
      ),
      fragmentShader: shader.fragmentShader,
    }
  }

  private weaveOptions({ vertexTangents = true }: ExactShader): WeaveOptions {
    const { isRawShaderMaterial, isShaderMaterial, glslVersion } = this
      .material as Partial<RawShaderMaterial>
    return {
      mayHaveTangents: vertexTangents,
      hasColors: false,
      isShaderMaterial: isShaderMaterial === true,
      isRaw: isRawShaderMaterial === true,
      isGlsl100: isRawShaderMaterial === true && glslVersion !== '300 es',
    }
  }

  private replaceSources(
    shader: ExactShader,
    { warp }: Displacement,
    { vertexShader, fragmentShader }: Pick<ExactShader, 'vertexShader' | 'fragmentShader'>,
  ) {
    // The uniforms of a ShaderMaterial are the user's object.
    if ((this.material as Partial<RawShaderMaterial>).isShaderMaterial)
      shader.uniforms = Object.create(shader.uniforms) as ExactShader['uniforms']
    Object.assign(shader.uniforms, renameUniforms(uniformsFor(warp, this.material)))
    shader.vertexShader = withExactNames(withExactFunctions(vertexShader))
    shader.fragmentShader = withExactNames(withExactFunctions(fragmentShader))
  }
}

export const renameUniforms = (uniforms: object) =>
  Object.fromEntries(
    Object.entries(uniforms).map(([name, uniform]) => [withExactNames(name), uniform as never]),
  )

export const messageOf = (error: unknown) =>
  withNamesOfShader((error as Error).message.replace(/^exactNormals: /, ''))

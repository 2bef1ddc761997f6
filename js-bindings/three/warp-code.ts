// The GLSL of a warp for WebGLRenderer: declarations, and statements that warp one vertex.
import {
  shaderNames,
  variationAttribute,
  variationNames,
  type HostText,
  type Target,
} from '../compile/hosts.js'
import { declareOrientation } from './faces.js'
import { choosePartByTangent, uniformsInGlsl } from './glsl.js'
import type { ThreeWarp, VertexStage } from './three-warp.js'

/** A normal and a tangent in the space of the object, before the warp. */
export interface Surface {
  normal: string
  tangent: string
}

/** The results of `WarpCode.evaluate`, in the space of the object. */
export interface Evaluation {
  /** Statements, to be put into a block of their own. */
  code: string
  position: string
  normal: string
  tangent: string
}

interface CodeOptions {
  /** True if the shader has normals. If false, only the position is computed. */
  isLit: boolean
  /** True if the shader may draw geometries with tangents that the material reads. */
  mayHaveTangents: boolean
  /** `true` if the geometries have colors. */
  hasColors: boolean
  target?: Target
}

export class WarpCode {
  readonly isWorld: boolean
  /** The code that computes tangents and normals, and that for geometries without tangents; or one that computes only the position. */
  private readonly texts: readonly HostText[]

  constructor(
    readonly warp: ThreeWarp,
    readonly options: CodeOptions,
  ) {
    this.isWorld = warp.settings.space === 'world'
    this.texts = stagesFor(options).map((stage) => this.textFor(stage))
  }

  /** True if the warped position of a vertex depends on its normal. */
  get movesByNormal() {
    return this.warp.reads('normal')
  }

  /** Declares what the statements read. The attributes position, normal and uv and the matrices are declared already. */
  get declarations(): string {
    const { warp, texts } = this
    const variation = variationNames.filter((name) => this.reads(name))
    const [millis, ...uniforms] = uniformsInGlsl(warp, texts)
    return [
      millis,
      'uniform highp vec4 warpjetFill;',
      ...uniforms,
      ...declareOrientation(warp),
      ...variation.map((name) => `attribute vec3 ${variationAttribute(name)};`),
      ...(this.options.hasColors ? [declareColor] : []),
      choosePartByTangent(texts, ({ declarations }) => declarations),
    ].join('\n')
  }

  /** Statements to insert before all evaluations. */
  get preparation(): string {
    const color = this.reads('color') ? colorOfVertex(this.options.hasColors) : ''
    return `${color}${this.isWorld ? toWorld : ''}`
  }

  /**
   * Makes statements, to be inserted after `preparation`, skip instances that are scaled to zero: such an instance has a matrix without
   * inverse, and is invisible.
   */
  guard(statements: string): string {
    return this.isWorld
      ? `if ( determinant( warpjetLinear ) != 0.0 ) {\n${statements}\n}`
      : statements
  }

  /** Warps the position `from` together with a normal and a tangent. */
  evaluate(from: string, { normal, tangent }: Surface): Evaluation {
    const { isLit } = this.options
    const position = this.isWorld ? `( warpjetToWorld * vec4( ${from}, 1.0 ) ).xyz` : from
    const takesNormal = isLit || this.movesByNormal
    return {
      code: [
        `vec3 warpjetRestPosition = ${position};`,
        takesNormal ? this.restNormal(normal) : '',
        this.isWorld ? this.variationInWorld(takesNormal) : '',
        this.texts.length > 1 ? this.restTangent(tangent) : '',
        choosePartByTangent(this.texts, ({ code }) => code),
      ]
        .filter(Boolean)
        .join('\n'),
      ...(this.isWorld ? backFromWorld : results),
    }
  }

  private restNormal(normal: string) {
    if (!this.isWorld) return `vec3 warpjetRestNormal = ${normal};`
    // The offset reads normals of length 1. Their gradients are adapted to that length in `gradientsInWorld`.
    return `vec3 warpjetRestNormal = warpjetCovariant * ( ${normal} );
float warpjetLength = length( warpjetRestNormal );
if ( warpjetLength > 0.0 ) warpjetRestNormal /= warpjetLength;`
  }

  private restTangent(tangent: string) {
    const rest = this.isWorld ? `warpjetLinear * ( ${tangent} )` : tangent
    return `#ifdef USE_TANGENT\nvec4 warpjetRestTangent = vec4( ${rest}, tangent.w );\n#endif`
  }

  private variationInWorld(takesNormal: boolean) {
    const read = variationNames.filter((name) => this.reads(name))
    const ofUv = read.filter((name) => !name.startsWith('normal'))
    const hasGradients = takesNormal && ofUv.length < read.length
    return [
      ...(hasGradients ? [gradientsInWorld] : []),
      ...ofUv.map(
        (name) => `vec3 warpjet_${name} = warpjetCovariant * ${variationAttribute(name)};`,
      ),
    ].join('\n')
  }

  private reads(input: string) {
    return this.texts.some(({ attributes }) => attributes.some(({ name }) => name === input))
  }

  private textFor(stage: VertexStage): HostText {
    return this.warp.textFor(this.options.target ?? 'glsl300', stage, this.names)
  }

  /** Maps an input → its expression in the statements. */
  get names(): Record<string, string> {
    const variation = variationNames.map((name) => [
      name,
      this.isWorld ? `warpjet_${name}` : variationAttribute(name),
    ])
    return {
      position: 'warpjetRestPosition',
      normal: 'warpjetRestNormal',
      tangent: 'warpjetRestTangent',
      uv: 'uv',
      color: 'warpjetColor',
      ...Object.fromEntries(variation),
    }
  }
}

function stagesFor({ isLit, mayHaveTangents }: CodeOptions): VertexStage[] {
  if (!isLit) return ['position']
  return mayHaveTangents ? ['tangent', 'normal'] : ['normal']
}

const declareColor = `#if ! defined( USE_COLOR ) && ! defined( USE_COLOR_ALPHA )
attribute vec4 color;
#endif`

const colorOfVertex = (hasColors: boolean) => `#if defined( USE_COLOR_ALPHA )
vec4 warpjetColor = color;
#elif defined( USE_COLOR )
vec4 warpjetColor = vec4( color, 1.0 );
#else
vec4 warpjetColor = ${hasColors ? 'color' : 'warpjetFill'};
#endif
`

const results = {
  position: shaderNames.position,
  normal: shaderNames.normal,
  tangent: `${shaderNames.tangent}.xyz`,
}

/** Transforms the results from world space to the object's, which the rest of the shader expects. */
const backFromWorld = {
  position: `( inverse( warpjetToWorld ) * vec4( ${shaderNames.position}, 1.0 ) ).xyz`,
  normal: `${shaderNames.normal} * warpjetLinear`,
  tangent: `warpjetInverse * ${shaderNames.tangent}.xyz`,
}

const toWorld = `mat4 warpjetToWorld = modelMatrix;
#ifdef USE_BATCHING
warpjetToWorld = warpjetToWorld * batchingMatrix;
#endif
#if defined( USE_INSTANCING ) || defined( USE_INSTANCING_INDIRECT )
warpjetToWorld = warpjetToWorld * instanceMatrix;
#endif
mat3 warpjetLinear = mat3( warpjetToWorld );
mat3 warpjetInverse = inverse( warpjetLinear );
mat3 warpjetCovariant = transpose( warpjetInverse );
`

const [nx, ny, nz] = variationNames.map(variationAttribute)

/** Computes the rows of the derivative of the normal in world space, without the part that would change the normal's length. */
const gradientsInWorld = `mat3 warpjetGradients = warpjetCovariant * mat3( ${nx}, ${ny}, ${nz} ) * warpjetInverse;
if ( warpjetLength > 0.0 ) warpjetGradients = ( warpjetGradients - outerProduct( warpjetGradients * warpjetRestNormal, warpjetRestNormal ) ) / warpjetLength;
vec3 warpjet_${variationNames[0]} = warpjetGradients[ 0 ];
vec3 warpjet_${variationNames[1]} = warpjetGradients[ 1 ];
vec3 warpjet_${variationNames[2]} = warpjetGradients[ 2 ];`

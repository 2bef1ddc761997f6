/**
 * Normals at each pixel, for WebGLRenderer. The vertex shader passes the inputs of the warp, in the space of the offset, as varyings.
 * The fragment shader runs the same warp on their interpolated values, but computes only the normal, and the tangent if the geometry
 * has any.
 */
import {
  restoreLength,
  shaderNames,
  variationNames,
  withLength,
  type HostText,
} from '../compile/hosts.js'
import { choosePartByTangent, uniformsInGlsl } from './glsl.js'
import { chunkSource } from './shader-source.js'
import type { ThreeWarp } from './three-warp.js'

/**
 * The way in which pixels get the matrix that transforms normals from the space of the offset to view space. `'uniform'`: from the matrix
 * of the object or, for a warp in the space `'world'`, of the camera. `'flat'`: as a varying that is constant in each instance. `'smooth'`:
 * as an interpolated varying, since the matrices of bones vary.
 */
export type Matrices = 'uniform' | 'flat' | 'smooth'

export interface PixelOptions {
  matrices: Matrices
  /** True if the shader may draw geometries with tangents that the material reads. */
  mayHaveTangents: boolean
}

/** Maps an input to the name of its variable in the fragment shader. */
const names = Object.fromEntries(
  ['position', 'normal', 'tangent', 'uv', 'color', ...variationNames].map((input) => [
    input,
    `warpjetPixel_${input}`,
  ]),
)

/** The varying for the normal and its length. Interpolation shortens the normal, so its length is interpolated separately. */
const normalVarying = 'warpjetPixel_normalAndLength'
const toViewVarying = 'warpjetPixelToView'
const viewPositionVarying = 'warpjetPixelViewPosition'

export class PixelNormals {
  /** The code for geometries with tangents and that for those without, or only the latter. */
  private readonly texts: readonly HostText[]
  private readonly isWorld: boolean

  constructor(
    private readonly warp: ThreeWarp,
    readonly options: PixelOptions,
  ) {
    this.isWorld = warp.settings.space === 'world'
    const stages = options.mayHaveTangents
      ? (['tangent of pixel', 'normal of pixel'] as const)
      : (['normal of pixel'] as const)
    this.texts = stages.map((stage) => warp.textFor('glsl300', stage, names))
  }

  /** The number of vectors that this code passes to pixels. */
  get varyingCount(): number {
    const { matrices, mayHaveTangents } = this.options
    return this.inputs.size + Number(mayHaveTangents) + (matrices === 'uniform' ? 0 : 3) + 1
  }

  /** Declares the varyings, in both stages. */
  get varyings(): string {
    const { matrices } = this.options
    return [
      ...[...this.inputs].map(([input, type]) => `varying highp ${type} ${varyingOf(input)};`),
      '#ifdef USE_TANGENT',
      `varying highp vec4 ${names.tangent};`,
      '#endif',
      ...(matrices === 'uniform'
        ? []
        : [`${matrices === 'flat' ? 'flat ' : ''}varying highp mat3 ${toViewVarying};`]),
      declareViewPosition,
    ].join('\n')
  }

  /** Returns statements that pass the inputs. `expressions` maps an input → its expression in the vertex shader. */
  pass(expressions: Readonly<Record<string, string>>): string {
    const tangent = expressions.tangent
    return [
      ...[...this.inputs].map(([input]) => {
        const value = expressions[input]!
        return input === 'normal'
          ? `${normalVarying} = ${withLength(value, 'vec4')};`
          : `${varyingOf(input)} = ${value};`
      }),
      ...(this.options.mayHaveTangents
        ? ['#ifdef USE_TANGENT', `${names.tangent} = ${tangent};`, '#endif']
        : []),
    ].join('\n')
  }

  /**
   * Returns statements that set the varyings to zero, where a warp in world space is not evaluated. Pixels there get the normal of the flat
   * triangle.
   */
  get clear(): string {
    return [...this.inputs]
      .map(([input, type]) => `${varyingOf(input)} = ${type}( 0.0 );`)
      .join('\n')
  }

  /** Returns statements that pass the matrices, after bones and instances: they apply three.js' own lines for normals to each axis. */
  get passMatrices(): string {
    const { matrices } = this.options
    if (matrices === 'uniform') return ''
    return `for ( int warpjetAxis = 0; warpjetAxis < 3; warpjetAxis ++ ) {
vec3 objectNormal = vec3( 0.0 );
objectNormal[ warpjetAxis ] = 1.0;
#ifdef USE_TANGENT
vec3 objectTangent = vec3( 0.0 );
#endif
${matrices === 'smooth' ? chunkSource('skinnormal_vertex') : ''}
${chunkSource('defaultnormal_vertex')}
${toViewVarying}[ warpjetAxis ] = transformedNormal;
}`
  }

  /** Declares what the fragment shader needs: the function `warpjetNormalOfPixel`, and the tangents that it computes. */
  declarations(precision: string, isMatrixDeclared: boolean): string {
    const isHigh = precision === 'highp'
    return [
      ...(isMatrixDeclared || this.isWorld || this.options.matrices !== 'uniform'
        ? []
        : ['#ifndef USE_NORMALMAP_OBJECTSPACE', 'uniform mat3 normalMatrix;', '#endif']),
      'precision highp float;',
      'precision highp int;',
      this.varyings,
      ...uniformsInGlsl(this.warp, this.texts),
      choosePartByTangent(this.texts, ({ declarations }) => declarations),
      declareFacing,
      this.normalFunction,
      ...(isHigh ? [] : [`precision ${precision} float;`, `precision ${precision} int;`]),
    ].join('\n')
  }

  /** Maps each input on which the normal depends, except the tangent → type. */
  private get inputs(): ReadonlyMap<string, string> {
    const attributes = this.texts.flatMap(({ attributes }) => attributes)
    return new Map(
      attributes
        .filter(({ name }) => name !== 'tangent')
        .map(({ name, type }) => [name, name === 'normal' ? 'vec4' : type]),
    )
  }

  private get normalFunction(): string {
    const { mayHaveTangents, matrices } = this.options
    const toView = this.isWorld
      ? 'mat3( viewMatrix )'
      : matrices === 'uniform'
        ? 'normalMatrix'
        : `warpjetFlip * ${toViewVarying}`
    const { normal } = names
    return `${mayHaveTangents ? '#ifdef USE_TANGENT\nvec3 warpjetTangentOfPixel;\nvec3 warpjetBitangentOfPixel;\n#endif\n' : ''}
vec3 warpjetNormalOfPixel() {
vec3 warpjetFacingNormal = warpjetFacing();
${this.inputs.has('normal') ? `vec3 ${normal} = ${restoreLength(normalVarying)};` : ''}
${choosePartByTangent(this.texts, ({ code }) => code)}
#ifdef FLIP_SIDED
float warpjetFlip = -1.0;
#else
float warpjetFlip = 1.0;
#endif
mat3 warpjetToView = ${toView};
vec3 warpjetViewNormal = warpjetToView * ${shaderNames.normal};
${mayHaveTangents ? `#ifdef USE_TANGENT\n${this.tangents}\n#endif` : ''}
return warpjetNormalized( warpjetFlip * warpjetViewNormal, warpjetFacingNormal );
}`
  }

  /** Returns statements for the tangents. The matrix for tangents is, up to scale, the cofactor matrix of the matrix for normals. */
  private get tangents(): string {
    const { warp } = this
    const orientation = warp.mirrors === false ? '1.0' : shaderNames.orientation
    const flip = doesFlipTangents() ? 'warpjetFlip * ' : ''
    const { tangent } = shaderNames
    return `vec3 warpjetX = warpjetToView[ 0 ], warpjetY = warpjetToView[ 1 ], warpjetZ = warpjetToView[ 2 ];
mat3 warpjetCofactors = mat3( cross( warpjetY, warpjetZ ), cross( warpjetZ, warpjetX ), cross( warpjetX, warpjetY ) );
vec3 warpjetViewTangent = sign( dot( warpjetX, warpjetCofactors[ 0 ] ) ) * ( warpjetCofactors * ${tangent}.xyz );
vec3 warpjetViewBitangent = cross( warpjetViewNormal, warpjetViewTangent ) * ( ${names.tangent}.w * ${orientation} );
warpjetTangentOfPixel = warpjetNormalized( ${flip}warpjetViewTangent, normalize( vTangent ) );
warpjetBitangentOfPixel = warpjetNormalized( warpjetViewBitangent, normalize( vBitangent ) );`
  }
}

const varyingOf = (input: string) => (input === 'normal' ? normalVarying : names[input]!)

/** Tests whether this version of three.js flips the tangents of a material that shows its back. */
const doesFlipTangents = () =>
  /transformedTangent\s*=\s*-\s*transformedTangent/.test(chunkSource('defaultnormal_vertex'))

/** Declares a varying for the position in view space, for those shaders of three.js that do not pass that position. */
const declareViewPosition = `#ifndef WARPJET_VIEW_POSITION
varying highp vec3 ${viewPositionVarying};
#define WARPJET_VIEW_POSITION ${viewPositionVarying}
#define WARPJET_OWN_VIEW_POSITION
#endif`

export const passViewPosition = `#ifdef WARPJET_OWN_VIEW_POSITION
${viewPositionVarying} = - mvPosition.xyz;
#endif`

/** Lets the preprocessor know which shaders pass the position in view space. */
export const markViewPosition = (source: string) =>
  source.replace(
    /\b(?:varying|in|out)\s+(?:highp\s+)?vec3\s+vViewPosition\s*;/g,
    '$&\n#define WARPJET_VIEW_POSITION vViewPosition',
  )

/**
 * Declares functions for where a warp collapses the surface. `warpjetFacing` returns the geometric normal of the drawn triangle,
 * before three.js negates normals of back faces. `warpjetFacing` is called outside of branches, where screen-space derivatives are defined.
 * `warpjetNormalized` returns `other` for a vector that is zero or not finite.
 */
export const declareFacing = `vec3 warpjetFacing() {
vec3 warpjetCross = cross( dFdx( WARPJET_VIEW_POSITION ), dFdy( WARPJET_VIEW_POSITION ) );
vec3 warpjetSide = warpjetCross == vec3( 0.0 ) ? vec3( 0.0, 0.0, 1.0 ) : normalize( warpjetCross );
#ifdef DOUBLE_SIDED
return gl_FrontFacing ? warpjetSide : - warpjetSide;
#else
return warpjetSide;
#endif
}
vec3 warpjetNormalized( vec3 vector, vec3 other ) {
float size = abs( vector.x ) + abs( vector.y ) + abs( vector.z );
return size > 0.0 && size < 3e38 ? normalize( vector / size ) : other;
}`

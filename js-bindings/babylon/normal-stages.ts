/** Decides for each mesh of a material whether its normals are computed at pixels. */
import type { Effect } from '@babylonjs/core/Materials/effect.js'
import type { MaterialDefines } from '@babylonjs/core/Materials/materialDefines.js'
import type { NormalStage, NormalsOption } from '../compile/hosts.js'
import { marker } from './fragment-normals.js'
import { normalDefines } from './names.js'
import { countVaryings, type PixelTexts } from './pixel-normals.js'

type Defines = Readonly<Record<string, unknown>>

export class NormalStages {
  /** The reason for computing normals at vertices; `undefined` if no shader has had to fall back to that yet. */
  private obstacle: string | undefined
  private readonly checkedEffects = new WeakSet<Effect>()

  constructor(
    private readonly option: NormalsOption,
    private readonly texts: PixelTexts | undefined,
  ) {}

  /**
   * The stage of the normals. It is `'vertex'` from the moment when one shader had to fall back; the shaders of other meshes may still
   * compute normals at pixels.
   */
  get stage(): NormalStage {
    return this.texts && !this.obstacle ? 'pixel' : 'vertex'
  }

  /** Sets the defines of normals for a mesh, after Babylon.js has set its own. */
  prepare(materialDefines: MaterialDefines, maxVaryings: number) {
    const defines = materialDefines as unknown as Record<string, unknown>
    const hasNormals = !!defines['WARPJET'] && !!defines['NORMAL']
    const hasFrame =
      hasNormals && !!defines['TANGENT'] && frameDefines.some((name) => defines[name])
    defines[normalDefines.frame] = hasFrame
    const hasPixels = hasNormals && this.fits(defines, maxVaryings)
    defines[normalDefines.pixel] = hasPixels
    // With this define, a PBRMaterial would compute the diffuse light of its environment from the normals at vertices.
    if (hasPixels && defines['USESPHERICALINVERTEX']) defines['USESPHERICALINVERTEX'] = false
  }

  /** Checks that the shader contains the warp's code: Babylon.js ignores code for a line that it does not find. */
  check(effect: Effect | null) {
    if (
      !this.texts ||
      !effect?.defines.includes(normalDefines.pixel) ||
      this.checkedEffects.has(effect)
    )
      return
    this.checkedEffects.add(effect)
    if (!effect.fragmentSourceCodeBeforeMigration.includes(marker))
      this.fallBack('its fragment shader does not compute the normal as Babylon.js does')
  }

  /** Returns whether the engine has enough varyings for normals at pixels. */
  private fits(defines: Defines, maxVaryings: number): boolean {
    if (!this.texts) return false
    const needed = countVaryings(
      defines[normalDefines.frame] ? this.texts.frame : this.texts.normal,
    )
    const free = maxVaryings - countMaterialVaryings(defines)
    if (needed <= free) return true
    this.fallBack(`it passes ${needed} vectors to pixels, of which this engine has ${free} left`)
    return false
  }

  /** Falls back to normals at vertices, with a warning if the user has chosen `'pixel'`. */
  private fallBack(obstacle: string) {
    if (this.option === 'pixel' && !this.obstacle)
      console.warn(
        `BabylonWarp: the normals of this warp are computed at vertices, although its option "normals" is 'pixel': ${obstacle}.`,
      )
    this.obstacle = obstacle
  }
}

/** Materials with one of these defines use the tangent frame. */
const frameDefines = [
  'BUMP',
  'BENTNORMAL',
  'CLEARCOAT_BUMP',
  'ANISOTROPIC',
  'GEOMETRY_NORMAL',
  'GEOMETRY_COAT_NORMAL',
  'FUZZ',
]

/** Maps patterns of defines → the number of vectors that Babylon.js passes to pixels for each such define. */
const varyingDefines: [RegExp, number | ((defines: Defines, name: string) => number)][] = [
  [/^(VERTEXCOLOR|INSTANCESCOLOR|MAINUV\d|CLIPPLANE\d?|FOG|LOGARITHMICDEPTH)$/, 1],
  [/^REFLECTIONMAP_(SKYBOX|(MIRRORED)?EQUIRECTANGULAR_FIXED)$/, 1],
  [/^WARPJET_FRAME$/, 3],
  [/^PREPASS_(LOCAL_POSITION|DEPTH|NORMALIZED_VIEW_DEPTH)$/, 1],
  [/^PREPASS_VELOCITY(_LINEAR)?$/, 2],
  [/^SHADOW\d+$/, (defines, name) => countShadowVaryings(defines, name.replace('SHADOW', ''))],
]

function countShadowVaryings(defines: Defines, light: string) {
  if (defines[`SHADOWCUBE${light}`]) return 0
  return defines[`SHADOWCSM${light}`] ? 2 * Number(defines[`SHADOWCSMNUM_CASCADES${light}`]) + 1 : 2
}

/** Counts the vectors that Babylon.js itself passes to pixels: position and normal, and those for its defines. */
function countMaterialVaryings(defines: Defines): number {
  let count = 2
  for (const [name, value] of Object.entries(defines)) {
    const [map] = /^.+(?=DIRECTUV$)/.exec(name) ?? []
    // If this define is 0, the texture has a matrix, and so its own texture coordinates.
    if (map && value === 0 && defines[map]) count++
    if (!value) continue
    const [, size = 0] = varyingDefines.find(([pattern]) => pattern.test(name)) ?? []
    count += typeof size === 'number' ? size : size(defines, name)
  }
  return count
}

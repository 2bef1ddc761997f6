/** Decides for each mesh of a material whether its normals are computed at pixels. */
import type { Effect } from '@babylonjs/core/Materials/effect.js'
import type { MaterialDefines } from '@babylonjs/core/Materials/materialDefines.js'
import type { NormalStage, NormalsOption } from '../compile/hosts.js'
import { marker } from './fragment-normals.js'
import { normalDefines } from './names.js'
import { varyingsOf, type PixelTexts } from './pixel-normals.js'

type Defines = Readonly<Record<string, unknown>>

export class NormalStages {
  private obstacle: string | undefined
  private readonly known = new WeakSet<Effect>()

  constructor(
    private readonly option: NormalsOption,
    private readonly texts: PixelTexts | undefined,
  ) {}

  /** `'vertex'` once the shader of a mesh could not compute them at pixels, although those of other meshes may. */
  get stage(): NormalStage {
    return this.texts && !this.obstacle ? 'pixel' : 'vertex'
  }

  /** Sets our defines for a mesh, after those of Babylon.js. */
  prepare(defines: MaterialDefines, maxVaryings: number) {
    const given = defines as unknown as Record<string, unknown>
    const hasNormals = !!given['WARPJET'] && !!given['NORMAL']
    const hasFrame = hasNormals && !!given['TANGENT'] && mapDefines.some((name) => given[name])
    given[normalDefines.frame] = hasFrame
    const hasPixels = hasNormals && this.fits(given, maxVaryings)
    given[normalDefines.pixel] = hasPixels
    // Otherwise a PBRMaterial computes the diffuse light of its environment at vertices.
    if (hasPixels && given['USESPHERICALINVERTEX']) given['USESPHERICALINVERTEX'] = false
  }

  /** Checks that the shader contains our code: Babylon.js ignores code for a place that it does not find. */
  check(effect: Effect | null) {
    if (!this.texts || !effect?.defines.includes(normalDefines.pixel) || this.known.has(effect))
      return
    this.known.add(effect)
    if (!effect.fragmentSourceCodeBeforeMigration.includes(marker))
      this.fallBack('its fragment shader does not compute the normal as Babylon.js does')
  }

  private fits(defines: Defines, maxVaryings: number): boolean {
    if (!this.texts) return false
    const own = varyingsOf(defines[normalDefines.frame] ? this.texts.frame : this.texts.normal)
    const free = maxVaryings - varyingsOfMaterial(defines)
    if (own <= free) return true
    this.fallBack(`it passes ${own} vectors to pixels, of which this engine has ${free} left`)
    return false
  }

  private fallBack(obstacle: string) {
    if (this.option === 'pixel' && !this.obstacle)
      console.warn(
        `BabylonWarp: the normals of this warp are computed at vertices, although its option "normals" is 'pixel': ${obstacle}.`,
      )
    this.obstacle = obstacle
  }
}

/** Defines with which materials use the frame of a tangent. */
const mapDefines = [
  'BUMP',
  'BENTNORMAL',
  'CLEARCOAT_BUMP',
  'ANISOTROPIC',
  'GEOMETRY_NORMAL',
  'GEOMETRY_COAT_NORMAL',
  'FUZZ',
]

/** Maps patterns of defines → the vectors that Babylon.js passes to pixels for each. */
const varyingDefines: [RegExp, number | ((defines: Defines, index: string) => number)][] = [
  [/^(VERTEXCOLOR|INSTANCESCOLOR|MAINUV\d|CLIPPLANE\d?|FOG|LOGARITHMICDEPTH)$/, 1],
  [/^REFLECTIONMAP_(SKYBOX|(MIRRORED)?EQUIRECTANGULAR_FIXED)$/, 1],
  [/^WARPJET_FRAME$/, 3],
  [/^PREPASS_(LOCAL_POSITION|DEPTH|NORMALIZED_VIEW_DEPTH)$/, 1],
  [/^PREPASS_VELOCITY(_LINEAR)?$/, 2],
  [/^SHADOW\d+$/, (defines, name) => varyingsOfShadow(defines, name.replace('SHADOW', ''))],
]

function varyingsOfShadow(defines: Defines, light: string) {
  if (defines[`SHADOWCUBE${light}`]) return 0
  return defines[`SHADOWCSM${light}`] ? 2 * Number(defines[`SHADOWCSMNUM_CASCADES${light}`]) + 1 : 2
}

/** Returns the number of vectors that Babylon.js itself passes to pixels: position and normal, and those of its defines. */
function varyingsOfMaterial(defines: Defines): number {
  let count = 2
  for (const [name, value] of Object.entries(defines)) {
    const [map] = /^.+(?=DIRECTUV$)/.exec(name) ?? []
    // 0: it has a matrix, and so its own texture coordinates.
    if (map && value === 0 && defines[map]) count++
    if (!value) continue
    const [, size = 0] = varyingDefines.find(([pattern]) => pattern.test(name)) ?? []
    count += typeof size === 'number' ? size : size(defines, name)
  }
  return count
}

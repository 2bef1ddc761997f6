/** Decides where the normals of a warp are computed: for each mesh, as Babylon.js has its shader. */
import type { Effect } from '@babylonjs/core/Materials/effect.js'
import type { MaterialDefines } from '@babylonjs/core/Materials/materialDefines.js'
import type { NormalStage, NormalsOption } from '../compile/hosts.js'
import { marker } from './fragment-normals.js'
import { normalDefines } from './names.js'
import { type PixelTexts, varyingsOf } from './pixel-normals.js'

type Defines = Readonly<Record<string, unknown>>

export class NormalStages {
  private obstacle: string | undefined
  private readonly known = new WeakSet<Effect>()

  constructor(
    private readonly option: NormalsOption,
    private readonly texts: PixelTexts | undefined,
  ) {}

  /** `'vertex'` as soon as a shader cannot compute them at pixels. */
  get stage(): NormalStage {
    return this.texts && !this.obstacle ? 'pixel' : 'vertex'
  }

  /** Sets the defines of a mesh whose others are set. */
  prepare(defines: MaterialDefines, maxVaryings: number) {
    const given = defines as unknown as Record<string, unknown>
    const hasFrame =
      !!given['NORMAL'] && !!given['TANGENT'] && mapDefines.some((name) => given[name])
    const hasPixels = this.fits(given, hasFrame, maxVaryings)
    given[normalDefines.frame] = hasFrame
    given[normalDefines.pixel] = hasPixels
    // The diffuse light of the surroundings follows.
    if (hasPixels && given['USESPHERICALINVERTEX']) given['USESPHERICALINVERTEX'] = false
  }

  /** Looks into the shader of a mesh: Babylon.js says nothing if it has not found the place for the code. */
  check(effect: Effect | null) {
    if (!this.texts || !effect?.defines.includes(normalDefines.pixel) || this.known.has(effect))
      return
    this.known.add(effect)
    if (!effect.fragmentSourceCodeBeforeMigration.includes(marker))
      this.fallBack('its fragment shader does not compute the normal as Babylon.js does')
  }

  private fits(defines: Defines, hasFrame: boolean, maxVaryings: number): boolean {
    if (!this.texts || !defines['NORMAL'] || !defines['WARPJET']) return false
    const own = varyingsOf(hasFrame ? this.texts.frame : this.texts.normal)
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
  [/^(WARPJET_FRAME)$/, 3],
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

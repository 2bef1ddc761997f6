// The `#define` lines that three.js puts above a vertex shader.
import type { ExactShader } from './shader.js'

/** Maps a parameter of a program → the macro that three.js defines if it is true. */
const macros: Record<string, string> = {
  instancing: 'USE_INSTANCING',
  instancingColor: 'USE_INSTANCING_COLOR',
  fog: 'USE_FOG',
  fogExp2: 'FOG_EXP2',
  envMap: 'USE_ENVMAP',
  alphaHash: 'USE_ALPHAHASH',
  anisotropy: 'USE_ANISOTROPY',
  transmission: 'USE_TRANSMISSION',
  normalMapObjectSpace: 'USE_NORMALMAP_OBJECTSPACE',
  normalMapTangentSpace: 'USE_NORMALMAP_TANGENTSPACE',
  vertexNormals: 'HAS_NORMAL',
  vertexColors: 'USE_COLOR',
  vertexAlphas: 'USE_COLOR_ALPHA',
  vertexUv1s: 'USE_UV1',
  vertexUv2s: 'USE_UV2',
  vertexUv3s: 'USE_UV3',
  pointsUvs: 'USE_POINTS_UV',
  flatShading: 'FLAT_SHADED',
  doubleSided: 'DOUBLE_SIDED',
  flipSided: 'FLIP_SIDED',
  sizeAttenuation: 'USE_SIZEATTENUATION',
}

/** Maps a texture of a material → its name in macros, such as `USE_LIGHTMAP` and `LIGHTMAP_UV`. */
const maps: Record<string, string> = {
  map: 'MAP',
  lightMap: 'LIGHTMAP',
  aoMap: 'AOMAP',
  bumpMap: 'BUMPMAP',
  normalMap: 'NORMALMAP',
  displacementMap: 'DISPLACEMENTMAP',
  emissiveMap: 'EMISSIVEMAP',
  anisotropyMap: 'ANISOTROPYMAP',
  clearcoatMap: 'CLEARCOATMAP',
  clearcoatRoughnessMap: 'CLEARCOAT_ROUGHNESSMAP',
  clearcoatNormalMap: 'CLEARCOAT_NORMALMAP',
  iridescenceMap: 'IRIDESCENCEMAP',
  iridescenceThicknessMap: 'IRIDESCENCE_THICKNESSMAP',
  specularMap: 'SPECULARMAP',
  specularColorMap: 'SPECULAR_COLORMAP',
  specularIntensityMap: 'SPECULAR_INTENSITYMAP',
  roughnessMap: 'ROUGHNESSMAP',
  metalnessMap: 'METALNESSMAP',
  alphaMap: 'ALPHAMAP',
  transmissionMap: 'TRANSMISSIONMAP',
  thicknessMap: 'THICKNESSMAP',
  sheenColorMap: 'SHEEN_COLORMAP',
  sheenRoughnessMap: 'SHEEN_ROUGHNESSMAP',
}

/** Counts that three.js writes into its chunks as numbers. None of them changes where a vertex is, so we define all as 0. */
const counts = [
  'NUM_DIR_LIGHTS',
  'NUM_SPOT_LIGHTS',
  'NUM_SPOT_LIGHT_MAPS',
  'NUM_SPOT_LIGHT_COORDS',
  'NUM_RECT_AREA_LIGHTS',
  'NUM_POINT_LIGHTS',
  'NUM_HEMI_LIGHTS',
  'NUM_DIR_LIGHT_SHADOWS',
  'NUM_SPOT_LIGHT_SHADOWS',
  'NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS',
  'NUM_POINT_LIGHT_SHADOWS',
  'NUM_CLIPPING_PLANES',
  'UNION_CLIPPING_PLANES',
]

/**
 * Returns the `#define` lines, except those for morph targets, bones, batches, shadows and logarithmic depth: we read the position before
 * three.js' own lines apply these.
 */
export function definesFor(shader: ExactShader): string {
  const parameters = shader as unknown as Record<string, unknown>
  const materialDefines = Object.entries(shader.defines ?? {}).filter(
    ([, value]) => value !== false,
  )
  return [
    'attribute in',
    'varying out',
    'texture2D texture',
    'HIGH_PRECISION',
    ...(parameters.vertexTangents && !parameters.flatShading ? ['USE_TANGENT'] : []),
    ...counts.map((name) => `${name} 0`),
    ...Object.entries(macros).flatMap(([name, macro]) => (parameters[name] ? [macro] : [])),
    ...Object.entries(maps).flatMap(([name, macro]) => [
      ...(parameters[name] ? [`USE_${macro}`] : []),
      ...(parameters[`${name}Uv`] ? [`${macro}_UV ${String(parameters[`${name}Uv`])}`] : []),
    ]),
    ...materialDefines.map(([name, value]) => `${name} ${String(value)}`),
  ]
    .map((define) => `#define ${define}`)
    .join('\n')
}

// Writes js-bindings/wasm/tables.ts and mesh-tables.ts: the enumerations of the C++ in the order of their numbers, and its limits.

const head =
  '// Written by `npm run reference` from the C++: enumerations in the order of their numbers, and limits.'

const list = (names) => `[${names.map((name) => `'${name}'`).join(', ')}] as const`

/** Each with its number. */
const numbers = (entries) => `{${entries.map(([name, number]) => `${name}: ${number}`).join(', ')}}`

/** The text of the compiler's, not yet formatted. */
export const numberedText = (table) => {
  const { languages, noises, filters, wraps, warpOperands, warpResults, turnedResults } = table
  return `${head}

/** Shading languages, the one first that counts unless another is asked for, each with what \`glsl.fn\` calls its sources. */
export const languages = {${languages.map(({ name, source }) => `${name}: '${source}'`).join(', ')}} as const

/** Kinds of noise, each with what it takes: others are made of bases, and a fractal has octaves. */
export const noises = {${noises.map(({ name, use }) => `${name}: '${use}'`).join(', ')}} as const

/** Of \`glsl.texture\`. */
export const filters = ${list(filters)}
export const wraps = ${list(wraps)}

export const mostSeed = ${table.mostSeed}
export const mostOctaves = ${table.mostOctaves}

/** In the place of a handle: why, the session says; or derivatives of calls are to be given first. */
export const failed = ${table.failed}
export const needsPartials = ${table.needsPartials}

/** What a warp is made of besides its offset. */
export const warpOperands = ${list(warpOperands)}

/** The results of a warp. The last ${turnedResults}, which turn, come again, as they are where normal and uv vary over the surface. */
export const warpResults = ${numbers(warpResults.map((name, i) => [name, i]))}
export const turnedResults = ${turnedResults}
`
}

/** The text of the one of meshes. */
export const meshNumberedText = ({ meshArrays, mostTriangles, usualTriangles }) => {
  const of = (wanted) =>
    meshArrays
      .filter(({ kind }) => kind === wanted)
      .map(({ name }) => `'${name}'`)
      .join(' | ')
  return `// Written by \`npm run reference\` from the C++: the arrays of a mesh's job by element type, and limits.

export type FloatArray = ${of('float')}
export type IndexArray = ${of('index')}
export type ByteArray = ${of('byte')}

export const mostTriangles = ${mostTriangles}
/** Unless another limit is given. */
export const usualTriangles = ${usualTriangles}
`
}

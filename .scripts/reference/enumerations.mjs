// Writes js-bindings/wasm/tables.ts and js-bindings/wasm/mesh-tables.ts: the enumerations and limits of the C++, with the
// enumerators ordered by value.

const header =
  '// Written by `npm run reference` from the C++: its enumerations, ordered by value, and its limits.'

const writeList = (names) => `[${names.map((name) => `'${name}'`).join(', ')}] as const`

/** Writes an object that maps names → numbers. */
const writeObject = (entries) =>
  `{${entries.map(([name, number]) => `${name}: ${number}`).join(', ')}}`

/** Returns the source of tables.ts, not yet formatted. */
export const tablesText = (table) => {
  const { languages, noises, filters, wraps, warpOperands, warpResults, variantCount } = table
  return `${header}

/** Maps a shading language → the name of its sources in \`glsl.fn\`. The first one is the default. */
export const languages = {${languages.map(({ name, source }) => `${name}: '${source}'`).join(', ')}} as const

/** Maps a noise → the kind of its options: 'made' and 'fractal' noises are composed from a 'base'; fractals have octaves. */
export const noises = {${noises.map(({ name, use }) => `${name}: '${use}'`).join(', ')}} as const

/** Options of \`glsl.texture\`. */
export const filters = ${writeList(filters)}
export const wraps = ${writeList(wraps)}

export const maxSeed = ${table.maxSeed}
export const maxOctaves = ${table.maxOctaves}

/** Returned in place of a handle: the session's \`problem()\` says why. */
export const failed = ${table.failed}
/** Returned in place of a handle: partial derivatives of calls are needed first. */
export const needsPartials = ${table.needsPartials}

/** The operands of a warp, after its offset. */
export const warpOperands = ${writeList(warpOperands)}

/** The results of a warp. The last ${variantCount} are followed by variants that take into account how normal and uv vary over the surface. */
export const warpResults = ${writeObject(warpResults.map((name, i) => [name, i]))}
export const variantCount = ${variantCount}
`
}

/** Returns the source of mesh-tables.ts, not yet formatted. */
export const meshTablesText = ({ meshArrays, triangleLimit, defaultTriangles }) => {
  const namesOfKind = (wanted) =>
    meshArrays
      .filter(({ kind }) => kind === wanted)
      .map(({ name }) => `'${name}'`)
      .join(' | ')
  return `// Written by \`npm run reference\` from the C++: the names of the arrays that are passed to the mesh module, by type, and limits.

export type FloatArray = ${namesOfKind('float')}
export type IndexArray = ${namesOfKind('index')}
export type ByteArray = ${namesOfKind('byte')}

export const triangleLimit = ${triangleLimit}
/** The default of the option \`maxTriangles\`. */
export const defaultTriangles = ${defaultTriangles}
`
}

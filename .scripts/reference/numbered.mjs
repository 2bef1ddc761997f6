// js-bindings/tables.ts: what has a number in the C++, in the order of its numbers, and what is limited there.

const list = (names) => `[${names.map((name) => `'${name}'`).join(', ')}] as const`

/** The text of the file, not yet formatted. */
export const numberedText = ({ languages, noises, filters, wraps, mostSeed, mostOctaves }) =>
  `// Written by \`npm run reference\` from the C++: what has a number there, in the order of its numbers, and what is limited.

/** Shading languages, the one first that counts unless another is asked for, each with what \`glsl.fn\` calls its sources. */
export const languages = {${languages.map(({ name, source }) => `${name}: '${source}'`).join(', ')}} as const

/** Kinds of noise, each with what it takes: others are made of bases, and a fractal has octaves. */
export const noises = {${noises.map(({ name, use }) => `${name}: '${use}'`).join(', ')}} as const

/** Of \`glsl.texture\`. */
export const filters = ${list(filters)}
export const wraps = ${list(wraps)}

export const mostSeed = ${mostSeed}
export const mostOctaves = ${mostOctaves}
`

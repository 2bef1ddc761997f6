// The types that a sketch sees.
export type * from './expressions.js'
export type * from './glsl.js'
export type * from './offset.js'

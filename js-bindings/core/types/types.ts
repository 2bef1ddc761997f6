// The types of offset functions and expressions, for users.
export type * from './expressions.js'
export type * from './glsl.js'
export type * from './offset.js'

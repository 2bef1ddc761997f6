/** Where what reads shader text, 'warpjet/glsl', says that it is there, so that every copy of warpjet on a page finds it. */
export const frontEndKey = Symbol.for('warpjet.glsl')

/** The global under which the front end for GLSL, 'warpjet/glsl', registers itself, so that every copy of warpjet on a page finds it. */
export const frontEndKey = Symbol.for('warpjet.glsl')

// The shapes of values: float and bool, vec and bvec of 2 to 4, mat of 2 to 4. A value is a flat list of numbers; matrices are
// column-major, conditions are 1 and 0.

export const vectorShapes = ['vec2', 'vec3', 'vec4']
export const matrixShapes = ['mat2', 'mat3', 'mat4']

/** Returns the number at the end of a shape's name; 1 for float and bool. */
export const dimension = (shape) => Number(/\d$/.exec(shape) ?? 1)

export const isMatrix = (shape) => shape.startsWith('mat')
export const isCondition = (shape) => /^b/.test(shape)

/** Returns the number of components of a value. */
export const sizeOf = (shape) => dimension(shape) ** (isMatrix(shape) ? 2 : 1)

/** Returns the shape of one component. */
export const componentShape = (shape) => (isCondition(shape) ? 'bool' : 'float')

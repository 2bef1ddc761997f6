// The shapes of values: float and bool, vec and bvec of 2 to 4, mat of 2 to 4. A value is a flat list of numbers;
// matrices go column by column, conditions are 1 and 0.

export const vectorShapes = ['vec2', 'vec3', 'vec4']
export const matrixShapes = ['mat2', 'mat3', 'mat4']

/** The number at the end of a shape's name; 1 for float and bool. */
export const dimension = (shape) => Number(/\d$/.exec(shape) ?? 1)

export const isMatrix = (shape) => shape.startsWith('mat')
export const isCondition = (shape) => /^b/.test(shape)

/** How many numbers a value has. */
export const sizeOf = (shape) => dimension(shape) ** (isMatrix(shape) ? 2 : 1)

/** The shape of one component. */
export const componentShape = (shape) => (isCondition(shape) ? 'bool' : 'float')

// Names that people know from three's TSL, p5.strands, p5 and GLSL.

/** Maps an alias → the name of the same operation. */
export const operationOfAlias = {
  mul: 'mult',
  multiply: 'mult',
  times: 'mult',
  plus: 'add',
  minus: 'sub',
  subtract: 'sub',
  divide: 'div',
  negate: 'neg',
  modulo: 'mod',
  power: 'pow',
  inverseSqrt: 'inversesqrt',
  lerp: 'mix',
  constrain: 'clamp',
  mag: 'length',
  magnitude: 'length',
  normalized: 'normalize',
  fraction: 'fract',
  atan2: 'atan',
  lessThan: 'lt',
  lessThanEqual: 'le',
  lessEqual: 'le',
  greaterThan: 'gt',
  greaterThanEqual: 'ge',
  greaterEqual: 'ge',
  equal: 'eq',
  equals: 'eq',
  equalTo: 'eq',
  notEqual: 'ne',
  select: 'ifElse',
  perlin: 'noise',
}

/** Maps a composition of operations → the same function in plain JavaScript. The functions of three numbers are for a vec3. */
export const compositions = {
  oneMinus: (x) => 1 - x,
  saturate: (x) => Math.min(Math.max(x, 0), 1),
  reciprocal: (x) => 1 / x,
  pow2: (x) => x * x,
  pow3: (x) => x ** 3,
  magSq: (x, y, z) => x * x + y * y + z * z,
  lengthSq: (x, y, z) => x * x + y * y + z * z,
}

/** Methods of p5.Vector, whose values tests/core/vectors.test.js compares with p5's own. */
export const vectorMethods = ['copy', 'rem', 'limit', 'setMag', 'heading', 'angleBetween', 'array']

// Shader code for the three pipelines: composes values from floats and decomposes them, in GLSL and WGSL. Shapes of values are 1 for a
// number, 2 to 4 for vectors, 'mat2' to 'mat4', 'bool', and 'bvec2' to 'bvec4'.

const isBoolean = (shape) => /^b/.test(shape)
const isMatrix = (shape) => /^mat/.test(shape)
/** Returns the size of a vector, or of each column of a matrix. */
const lengthOf = (shape) => (shape === 'bool' ? 1 : Number(`${shape}`.at(-1)))

const languages = {
  glsl: {
    type: (shape) => (shape === 1 ? 'float' : typeof shape === 'number' ? `vec${shape}` : shape),
    local: (type, name, value) => `${type} ${name} = ${value};`,
    toFloat: (condition) => `(${condition} ? 1.0 : 0.0)`,
  },
  wgsl: {
    type(shape) {
      if (shape === 1) return 'f32'
      if (typeof shape === 'number') return `vec${shape}f`
      if (shape === 'bool') return shape
      return isBoolean(shape) ? `vec${lengthOf(shape)}<bool>` : `${shape}x${lengthOf(shape)}f`
    },
    local: (type, name, value) => `let ${name}: ${type} = ${value};`,
    toFloat: (condition) => `select(0.0, 1.0, ${condition})`,
  },
}

/** Returns the number of floats of a shape. Those of a matrix are in column-major order. */
export const sizeOf = (shape) => lengthOf(shape) ** (isMatrix(shape) ? 2 : 1)

export const totalSize = (variables) =>
  variables.reduce((size, { shape }) => size + sizeOf(shape), 0)

/** Returns statements that declare the inputs. `floatAt(i)` returns code that reads float number i. */
export function declareInputs(language, inputs, floatAt) {
  const { type, local } = languages[language]
  let next = 0
  return inputs
    .map(({ name, shape }) => {
      const floats = Array.from({ length: sizeOf(shape) }, () => floatAt(next++))
      const components = isBoolean(shape) ? floats.map((float) => `${float} > 0.5`) : floats
      return local(type(shape), name, `${type(shape)}(${components.join(', ')})`)
    })
    .join('\n')
}

/** Returns the outputs as a list of expressions, each a float. */
const outputFloats = (language, outputs) =>
  outputs.flatMap(({ name, shape }) => {
    const length = lengthOf(shape)
    const columns = isMatrix(shape) ? [...'0123'.slice(0, length)].map((i) => `[${i}]`) : ['']
    const rows = length > 1 ? [...'xyzw'.slice(0, length)].map((letter) => `.${letter}`) : ['']
    const components = columns.flatMap((column) => rows.map((row) => `${name}${column}${row}`))
    return isBoolean(shape) ? components.map(languages[language].toFloat) : components
  })

/** Returns expressions of `type`, a vector of four floats, with all outputs. The last vector is padded with zeros. */
export function outputVectors(language, outputs, type) {
  const floats = outputFloats(language, outputs)
  return Array.from({ length: Math.ceil(floats.length / 4) }, (_, i) => {
    const four = [0, 1, 2, 3].map((k) => floats[4 * i + k] ?? '0.0')
    return `${type}(${four.join(', ')})`
  })
}

/** The differences between GLSL and WGSL in shaders of Babylon.js, so that code can be written once for both languages. */

type Type = 'float' | 'vec2' | 'vec3' | 'vec4' | 'mat3'

export interface Language {
  type: (type: Type) => string
  /** Returns the head of a function. */
  fn: (result: Type, name: string, parameters: Readonly<Record<string, Type>>) => string
  /** Declares a variable. */
  local: (type: Type, name: string, value: string) => string
  isZero: (vector: string) => string
  choose: (condition: string, value: string, otherwise: string) => string
  declareVarying: (type: Type, name: string) => string
  /** Returns the vertex stage's expression for a varying. */
  output: (name: string) => string
  /** Returns the fragment stage's expression for a varying. */
  input: (name: string) => string
  /** Returns the expression for the upper left 3 × 3 part of a mat4. */
  linear: (matrix: string) => string
  /** The functions for the screen-space derivatives along x and y. */
  derivatives: readonly [string, string]
  frontFacing: string
  /** The expression for Babylon.js' varying with the tangent frame. */
  frame: string
  /** Assignments that make this varying zero. */
  clearFrame: string
}

export const glsl: Language = {
  type: (type) => type,
  fn: (result, name, parameters) =>
    `${result} ${name}(${Object.entries(parameters).map(([parameter, type]) => `${type} ${parameter}`)})`,
  local: (type, name, value) => `${type} ${name} = ${value};`,
  isZero: (vector) => `(${vector} == vec3(0.0))`,
  choose: (condition, value, otherwise) => `(${condition} ? ${value} : ${otherwise})`,
  declareVarying: (type, name) => `varying ${type} ${name};`,
  output: (name) => name,
  input: (name) => name,
  linear: (matrix) => `mat3(${matrix})`,
  derivatives: ['dFdx', 'dFdy'],
  frontFacing: 'gl_FrontFacing',
  frame: 'vTBN',
  clearFrame: 'vTBN = mat3(0.0);',
}

const wgslTypes: Record<Type, string> = {
  float: 'f32',
  vec2: 'vec2f',
  vec3: 'vec3f',
  vec4: 'vec4f',
  mat3: 'mat3x3f',
}

const columns = [0, 1, 2]

export const wgsl: Language = {
  type: (type) => wgslTypes[type],
  fn: (result, name, parameters) =>
    `fn ${name}(${Object.entries(parameters).map(([parameter, type]) => `${parameter}: ${wgslTypes[type]}`)}) -> ${wgslTypes[result]}`,
  local: (type, name, value) => `var ${name}: ${wgslTypes[type]} = ${value};`,
  isZero: (vector) => `all(${vector} == vec3f(0.0))`,
  choose: (condition, value, otherwise) => `select(${otherwise}, ${value}, ${condition})`,
  declareVarying: (type, name) => `varying ${name}: ${wgslTypes[type]};`,
  output: (name) => `vertexOutputs.${name}`,
  input: (name) => `fragmentInputs.${name}`,
  linear: (matrix) => `mat3x3f(${columns.map((i) => `${matrix}[${i}].xyz`)})`,
  derivatives: ['dpdx', 'dpdy'],
  frontFacing: 'fragmentInputs.frontFacing',
  frame: `mat3x3f(${columns.map((i) => `fragmentInputs.vTBN${i}`)})`,
  clearFrame: columns.map((i) => `vertexOutputs.vTBN${i} = vec3f(0.0);`).join(' '),
}

export const languageOf = (isWGSL: boolean) => (isWGSL ? wgsl : glsl)

export const ifDefined = (define: string, code: string, otherwise = '') =>
  `#ifdef ${define}\n${code}\n${otherwise && `#else\n${otherwise}\n`}#endif`

export const ifNotDefined = (define: string, code: string) => `#ifndef ${define}\n${code}\n#endif`

// Generates random GLSL functions, each with its equivalent in JavaScript. They have control flow, structures, assigned swizzles and
// integers. Values stay below about 100, so that float32 is precise enough.
import { ExpressionGenerator, library } from './generate-expressions.js'

export { randomOf } from './generate-expressions.js'

class Generator extends ExpressionGenerator {
  /**
   * Generates a block of statements with its own scope. `inLoop` is 'switch' in a switch within a loop, where break would not leave the
   * loop.
   */
  block(count, inLoop) {
    this.scopes.push([])
    this.depth++
    const lines = Array.from({ length: count }, () => this.statement(inLoop))
    this.depth--
    this.scopes.pop()
    const join = (language) => `{\n${lines.map((line) => line[language]).join('\n')}\n}`
    return { glsl: join('glsl'), js: join('js') }
  }

  statement(inLoop) {
    const kinds = ['declare', 'declare', 'assign', 'assign', 'swizzle', 'field', 'integer']
    if (this.depth < 3) kinds.push('if', 'if', 'loop', 'switch', 'while')
    if (this.depth > 0) kinds.push('return')
    if (inLoop) kinds.push('leave')
    return this[`make_${this.pick(kinds)}`](inLoop)
  }

  make_declare() {
    const type = this.pick(['float', 'float', 'vec2', 'vec3'])
    const value = this.expression(type)
    const name = this.name()
    this.scopes.at(-1).push({ name, type })
    return { glsl: `${type} ${name} = ${value.glsl};`, js: `let ${name} = ${value.js};` }
  }

  make_integer() {
    const value = this.integer(3)
    const name = this.name()
    this.scopes.at(-1).push({ name, type: 'int', isFixed: true })
    return { glsl: `int ${name} = ${value.glsl};`, js: `let ${name} = ${value.js};` }
  }

  make_assign() {
    const type = this.pick(['float', 'vec2', 'vec3'])
    const candidates = this.variables(type, true)
    if (!candidates.length) return this.make_declare()
    const { name } = this.pick(candidates)
    const value = this.expression(type)
    const op = this.pick(['', '+', '-'])
    return {
      glsl: `${name} ${op}= ${value.glsl};`,
      js: op
        ? `${name} = perComponent((a, b) => a ${op} b, ${name}, ${value.js});`
        : `${name} = ${value.js};`,
    }
  }

  make_swizzle() {
    const candidates = this.variables('vec3', true)
    if (!candidates.length) return this.make_declare()
    const { name } = this.pick(candidates)
    const letters = this.pick(['x', 'z', 'xy', 'zx', 'yz', 'zyx', 'yxz'])
    const type = ['float', 'vec2', 'vec3'][letters.length - 1]
    const value = this.expression(type)
    const isSum = this.random() < 0.5
    return {
      glsl: `${name}.${letters} ${isSum ? '+=' : '='} ${value.glsl};`,
      js: `${name} = put(${name}, '${letters}', ${isSum ? `perComponent((a, b) => a + b, pick(${name}, '${letters}'), ${value.js})` : value.js});`,
    }
  }

  make_field() {
    const value = this.expression('vec2')
    return this.random() < 0.5
      ? {
          glsl: `wave.way = ${value.glsl}; wave.height += wave.way.x * 0.1;`,
          js: `wave.way = ${value.js}; wave.height += wave.way[0] * 0.1;`,
        }
      : {
          glsl: `bump(wave, ${value.glsl}.y);`,
          js: `bump(wave, ${value.js}[1]);`,
        }
  }

  make_if(inLoop) {
    const test = this.condition(2)
    const yes = this.block(1 + this.int(2), inLoop)
    const no = this.random() < 0.5 ? this.block(1, inLoop) : undefined
    const text = (language) =>
      `if (${test[language]}) ${yes[language]}${no ? ` else ${no[language]}` : ''}`
    return { glsl: text('glsl'), js: text('js') }
  }

  make_loop() {
    const name = this.name()
    const count = 1 + this.int(4)
    this.scopes.push([{ name, type: 'int', isFixed: true }])
    const body = this.block(1 + this.int(2), true)
    this.scopes.pop()
    return {
      glsl: `for (int ${name} = 0; ${name} < ${count}; ${name}++) ${body.glsl}`,
      js: `for (let ${name} = 0; ${name} < ${count}; ${name}++) ${body.js}`,
    }
  }

  make_while() {
    const name = this.name()
    this.scopes.push([{ name, type: 'int', isFixed: true }])
    const body = this.block(1, true)
    this.scopes.pop()
    const count = 1 + this.int(3)
    return {
      glsl: `int ${name} = ${count}; while (${name}-- > 0) ${body.glsl}`,
      js: `let ${name} = ${count}; while (${name}-- > 0) ${body.js}`,
    }
  }

  make_switch(inLoop) {
    const value = this.integer(3)
    const cases = [0, 1, 2].map((label) => ({
      label,
      body: this.block(1, inLoop && 'switch'),
      ends: this.random() < 0.7,
    }))
    const text = (language) =>
      `switch (${value[language]}) {\n${cases
        .map(
          ({ label, body, ends }) =>
            `${label === 2 ? 'default' : `case ${label}`}: ${body[language]}${ends || label === 2 ? ' break;' : ''}`,
        )
        .join('\n')}\n}`
    return { glsl: text('glsl'), js: text('js') }
  }

  make_return() {
    const test = this.condition(2)
    const value = this.expression('vec3', 2)
    return {
      glsl: `if (${test.glsl}) return ${value.glsl};`,
      js: `if (${test.js}) return ${value.js};`,
    }
  }

  make_leave(inLoop) {
    const test = this.condition(2)
    const word = inLoop === 'switch' ? 'continue' : this.pick(['break', 'continue'])
    return { glsl: `if (${test.glsl}) ${word};`, js: `if (${test.js}) ${word};` }
  }
}

/** Returns { seed, glsl, js }: `glsl` is the source of `vec3 random<seed>(vec3 p)`, `js` the same function of an array of three numbers. */
export function randomFunction(seed) {
  const generator = new Generator(seed)
  generator.scopes[0].push({ name: 'p', type: 'vec3' })
  const lines = Array.from({ length: 3 + generator.int(4) }, () => generator.statement(false))
  const result = generator.expression('vec3')
  const table = [0.3, -0.7, 1.1, 0.5]
  const glsl = `vec3 random${seed}(vec3 p) {
Wave wave = Wave(p.x, p.yz);
${lines.map((line) => line.glsl).join('\n')}
return ${result.glsl};
}
`
  const js = new Function(
    ...Object.keys(library),
    `const table = ${JSON.stringify(table)}
const helper = (x, y) => { if (x > 0.4) return Math.sin(x) + y[0]; return x * y[1] }
const bump = (wave, by) => { wave.height += Math.sin(by); wave.way = perComponent((a) => a * 0.5, wave.way) }
return (p) => {
const wave = { height: p[0], way: [p[1], p[2]] }
${lines.map((line) => line.js).join('\n')}
return ${result.js}
}`,
  )(...Object.values(library))
  return { seed, glsl, js }
}

/** Declarations that all random functions need above them. */
export const sharedDeclarations = `struct Wave { float height; vec2 way; };
const float table[4] = float[4](0.3, -0.7, 1.1, 0.5);
float helper(float x, vec2 y) { if (x > 0.4) return sin(x) + y.x; return x * y.y; }
void bump(inout Wave wave, float by) { wave.height += sin(by); wave.way *= 0.5; }
`

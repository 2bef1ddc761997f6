// Sketches whose offset function reads variables of enclosing functions, or variables named like globals.
export const sketches = {
  'a parameter named height, without operators': {
    top: `function makeWave(height) {
      return createWarp(({ glsl, position }) => glsl.vec3(0, position.x.mult(5).sin().mult(height), 0))
    }`,
    setup: `wave = makeWave(0.3)`,
    twin: ({ glsl, position }) => glsl.vec3(0, position.x.mult(5).sin().mult(0.3), 0),
  },
  'a parameter named height, with operators': {
    top: `function makeWave(height) {
      return createWarp(({ position }) => [0, sin(position.x * 5) * height, 0])
    }`,
    setup: `wave = makeWave(0.3)`,
    error:
      /cannot access "height" of the enclosing scope, where it is a local variable, not the global one; add the option \{ scope: \{ height \} \}/,
  },
  'a parameter named height, with the option scope': {
    top: `function makeWave(height) {
      return createWarp(({ position }) => [0, sin(position.x * 5) * height, 0], { scope: { height } })
    }`,
    setup: `wave = makeWave(0.3)`,
    twin: ({ glsl, position }) => glsl.vec3(0, position.x.mult(5).sin().mult(0.3), 0),
  },
  'operators on plain numbers in arguments of methods': {
    top: `function makeWave(width, key) {
      const half = width / 2
      return createWarp(({ glsl, position }) => glsl.vec3(position.y.mult(half * 8 + key).sin().mult(0.2), 0, 0))
    }`,
    setup: `wave = makeWave(1, 2)`,
    twin: ({ glsl, position }) => glsl.vec3(position.y.mult(6).sin().mult(0.2), 0, 0),
  },
  'a local variable of setup': {
    setup: `const amount = random([0.3, 0.3])
    wave = createWarp(({ position }) => [0, position.x * amount, 0])`,
    error:
      /cannot access "amount" of the enclosing scope; make it global, or add the option \{ scope: \{ amount \} \}/,
  },
  'a global variable': {
    top: `const amount = 0.3`,
    setup: `wave = createWarp(({ position }) => [0, position.x * amount, 0])`,
    twin: ({ glsl, position }) => glsl.vec3(0, position.x.mult(0.3), 0),
  },
  'a top-level arrow function with a parameter named length': {
    top: `const makeWave = (length) => createWarp(({ position }) => position * length)`,
    setup: `wave = makeWave(0.4)`,
    error: /cannot access "length" .* scope: \{ length \}/,
  },
  'a global variable, and a local one with the same name in another function': {
    top: `const size = 0.25
    function other(size) { return size * 2 }`,
    setup: `wave = createWarp(({ position }) => position * size)`,
    twin: ({ position }) => position.mult(0.25),
  },
  'the variable of an enclosing loop': {
    setup: `for (let i = 1; i < 3; i++) wave = createWarp(({ position }) => position * (i / 10))`,
    error: /cannot access "i" .* scope: \{ i \}/,
  },
  'a class that creates its warp': {
    top: `class Blob {
      constructor(amount) {
        this.amount = amount
        this.warp = createWarp(({ position }) => [sin(position.y * 4) * this.amount, 0, 0])
      }
    }`,
    setup: `wave = new Blob(0.3).warp`,
    error:
      /cannot access "this" of the enclosing object; write amount in place of this.amount, and add the option \{ scope: \{ amount: this.amount \} \}/,
  },
  'a class that creates its warp, with the option scope': {
    top: `class Blob {
      constructor(amount) {
        this.warp = createWarp(({ position }) => [sin(position.y * 4) * amount, 0, 0], { scope: { amount } })
      }
    }`,
    setup: `wave = new Blob(0.3).warp`,
    twin: ({ glsl, position }) => glsl.vec3(position.y.mult(4).sin().mult(0.3), 0, 0),
  },
  'names of p5 as parameters of inner functions': {
    setup: `wave = createWarp(({ position }) => {
      const shape = (width, height) => sin(width * 4) * height
      return [0, shape(position.x, 0.2), 0]
    })`,
    twin: ({ glsl, position }) => glsl.vec3(0, position.x.mult(4).sin().mult(0.2), 0),
  },
}

// Sketches that call their own functions, methods and classes.
export const sketches = {
  'a helper function': {
    top: `function ripple(d) {
      return sin(d * 8) * 0.2
    }`,
    setup: `wave = createWarp(({ position }) => [ripple(position.y), 0, 0])`,
    twin: ({ glsl, position }) => glsl.vec3(position.y.mult(8).sin().mult(0.2), 0, 0),
  },
  'a helper that calls another one, both arrow functions': {
    top: `const frequency = 6
    const swing = (x) => sin(x * frequency)
    const both = (x, y) => (swing(x) + swing(y)) / 8`,
    setup: `wave = createWarp(({ position: { x, y } }) => [0, 0, both(x, y)])`,
    twin: ({ glsl, position: { x, y } }) =>
      glsl.vec3(0, 0, x.mult(6).sin().add(y.mult(6).sin()).div(8)),
  },
  'a helper in setup': {
    setup: `const bump = (d) => { if (d > 0) return d * 0.5; return d }
    wave = createWarp(({ position }) => [0, bump(position.x), 0])`,
    twin: ({ glsl, position: { x } }) => glsl.vec3(0, x.gt(0).ifElse(x.mult(0.5), x), 0),
  },
  'a class with numbers': {
    top: `class Wave {
      constructor(frequency, amplitude) {
        this.frequency = frequency
        this.amplitude = amplitude
      }
      heightAt(x) {
        return sin(x * this.frequency) * this.amplitude
      }
    }
    let swell`,
    setup: `swell = new Wave(5, 0.25)
    wave = createWarp(({ position }) => [0, swell.heightAt(position.x), 0])`,
    twin: ({ glsl, position }) => glsl.vec3(0, position.x.mult(5).sin().mult(0.25), 0),
  },
  'a list of waves': {
    top: `class Wave {
      constructor(k) { this.k = k }
      at(p) { return sin(p.x * this.k) / this.k }
    }
    let waves = []`,
    setup: `for (let i = 1; i < 5; i++) waves.push(new Wave(i * 2))
    wave = createWarp(({ position }) => {
      let sum = 0
      for (const each of waves) sum += each.at(position)
      return [0, 0, sum]
    })`,
    twin: ({ glsl, position: { x } }) =>
      glsl.vec3(
        0,
        0,
        [2, 4, 6, 8].map((k) => x.mult(k).sin().div(k)).reduce((a, b) => a.add(b)),
      ),
  },
  'map and reduce over a list': {
    top: `const bumps = [{ x: -0.5, h: 0.3 }, { x: 0.5, h: 0.2 }]`,
    setup: `wave = createWarp(({ position }) => {
      const heights = bumps.map((bump) => bump.h * exp(-sq(position.x - bump.x) * 8))
      return [0, 0, heights.reduce((a, b) => a + b)]
    })`,
    twin: ({ glsl, position: { x } }) => {
      const bumpAt = (c, h) => x.sub(c).mult(x.sub(c)).mult(-8).exp().mult(h)
      return glsl.vec3(0, 0, bumpAt(-0.5, 0.3).add(bumpAt(0.5, 0.2)))
    },
  },
  'a vector class of the sketch': {
    top: `class V {
      constructor(x, y, z) { this.x = x; this.y = y; this.z = z }
      plus(o) { return new V(this.x + o.x, this.y + o.y, this.z + o.z) }
      times(k) { return new V(this.x * k, this.y * k, this.z * k) }
    }`,
    setup: `wave = createWarp(({ position: { x, y, z } }) => {
      const v = new V(sin(y * 5), 0, 0).plus(new V(0, x, z)).times(0.2)
      return [v.x, v.y, v.z]
    })`,
    twin: ({ glsl, position: { x, y, z } }) => glsl.vec3(y.mult(5).sin(), x, z).mult(0.2),
  },
  'an object of functions': {
    top: `const shapes = {
      soft(x) { return x * x * 0.2 },
      hard: (x) => abs(x) * 0.3,
    }`,
    setup: `wave = createWarp(({ position }) => [shapes.soft(position.y), 0, shapes.hard(position.x)])`,
    twin: ({ glsl, position: { x, y } }) => glsl.vec3(y.mult(y).mult(0.2), 0, x.abs().mult(0.3)),
  },
  recursion: {
    top: `function octaves(x, n) {
      if (n === 0) return 0
      return sin(x) / n + octaves(x * 2, n - 1) * 0.5
    }`,
    setup: `wave = createWarp(({ position }) => [octaves(position.y * 3, 3) * 0.4, 0, 0])`,
    twin: ({ glsl, position: { y } }) => {
      const a = y.mult(3)
      const octaves = (x, n) =>
        n
          ? x
              .sin()
              .div(n)
              .add(glsl.mult(octaves(x.mult(2), n - 1), 0.5))
          : 0
      return glsl.vec3(octaves(a, 3).mult(0.4), 0, 0)
    },
  },
  'a function that takes a function': {
    top: `function twice(f, x) { return f(f(x)) }`,
    setup: `wave = createWarp(({ position }) => [twice((x) => x * 0.5 + 0.1, position.y), 0, 0])`,
    twin: ({ glsl, position: { y } }) => glsl.vec3(y.mult(0.5).add(0.1).mult(0.5).add(0.1), 0, 0),
  },
  'a named offset function': {
    top: `function offset({ position, millis }) {
      const t = millis / 1000
      return [0, sin(position.x * 4 + t) * 0.2, 0]
    }`,
    setup: `wave = createWarp(offset)`,
    twin: ({ glsl, position, millis }) =>
      glsl.vec3(0, position.x.mult(4).add(millis.div(1000)).sin().mult(0.2), 0),
  },
  'a method as the offset function': {
    top: `class Sea {
      static move({ position }) { return [0, cos(position.z * 6) * 0.2, 0] }
    }`,
    setup: `wave = createWarp(Sea.move)`,
    twin: ({ glsl, position }) => glsl.vec3(0, position.z.mult(6).cos().mult(0.2), 0),
  },
}

// Sketches that use no operators and must not change, sketches that read changing variables, and sketches in instance mode.
const draw = `p.draw = () => { p.background(0); p.lights(); p.noStroke(); p.fill('coral'); wave(); p.sphere(40); done = true }`

export const sketches = {
  'only methods': {
    setup: `let count = 0
    wave = createWarp(({ glsl, position }) => { count++; return glsl.vec3(position.y.mult(4 * count).sin().mult(0.2), 0, 0) })`,
    twin: ({ glsl, position }) => glsl.vec3(position.y.mult(4).sin().mult(0.2), 0, 0),
  },
  'a sum that starts with 0': {
    setup: `const speeds = [2, 4]
    wave = createWarp(({ glsl, position }) => {
      let sum
      for (const speed of speeds) {
        const next = position.y.mult(speed * 2).sin().div(speed)
        sum = sum ? sum.add(next) : next
      }
      return glsl.vec3(sum.mult(0.4), 0, 0)
    })`,
    twin: ({ glsl, position: { y } }) =>
      glsl.vec3(y.mult(4).sin().div(2).add(y.mult(8).sin().div(4)).mult(0.4), 0, 0),
  },
  'a helper that uses methods, in a closure': {
    setup: `const amount = 0.2 + 0.1
    const bump = (x) => x.mult(5).sin().mult(amount)
    wave = createWarp(({ glsl, position }) => glsl.vec3(bump(position.y), 0, 0))`,
    twin: ({ glsl, position }) => glsl.vec3(position.y.mult(5).sin().mult(0.3), 0, 0),
  },
  'a uniform': {
    setup: `wave = createWarp(({ glsl, position, uniforms }) => position.mult(uniforms.amount), { uniforms: { amount: 0.3 } })`,
    twin: ({ position }) => position.mult(0.3),
  },
  'a method that uses this': {
    top: `const sea = { amount: 0.3, offset({ glsl, position }) { return position.mult(this.amount) } }`,
    setup: `wave = createWarp((inputs) => sea.offset(inputs))`,
    twin: ({ position }) => position.mult(0.3),
  },
  mouseX: {
    setup: `wave = createWarp(({ position }) => [position.y * (0.3 + mouseX / 1000), 0, 0])`,
    twin: ({ glsl, position: { y } }) => glsl.vec3(y.mult(0.3), 0, 0),
    warning:
      /reads mouseX once, .* write uniforms.mouseX in its place, with the option \{ uniforms: \{ mouseX: \(\) => mouseX \} \}/,
  },
  frameCount: {
    setup: `wave = createWarp(({ position }) => [position.y * (0.3 + frameCount / 1000), 0, 0])`,
    twin: ({ glsl, position: { y } }) => glsl.vec3(y.mult(0.3), 0, 0),
    warning: /reads frameCount once, .* uniforms: \{ frameCount: \(\) => frameCount \}/,
  },
  'a level that the sketch changes': {
    top: `let level = 0.3
    function mouseMoved() { level = map(mouseX, 0, width, 0, 0.5) }`,
    setup: `wave = createWarp(({ position }) => [position.y * level, 0, 0])`,
    twin: ({ glsl, position: { y } }) => glsl.vec3(y.mult(0.3), 0, 0),
    warning:
      /reads level once, .* write uniforms.level in its place, with the option \{ uniforms: \{ level: \(\) => level \} \}/,
  },
  'a level passed as a uniform, as the message advises': {
    top: `let level = 0.3
    function mouseMoved() { level = map(mouseX, 0, width, 0, 0.5) }`,
    setup: `wave = createWarp(({ position, uniforms }) => [position.y * uniforms.level, 0, 0], { uniforms: { level: () => level } })`,
    twin: ({ glsl, position: { y } }) => glsl.vec3(y.mult(0.3), 0, 0),
  },
  'bounds of compileWarp': {
    setup: `const { max } = warpjet.compileWarp(({ position }) => position * 0.5).bounds({ min: [-1, -1, -1], max: [1, 1, 1] })
    const far = max[0] / 5
    wave = createWarp(({ position }) => position * far, { scope: { far } })`,
    twin: ({ position }) => position.mult(0.3),
  },
  'instance mode': {
    source: `new p5((p) => {
      let wave
      p.setup = () => {
        p.createCanvas(100, 100, p.WEBGL)
        p.noLoop()
        wave = p.createWarp(({ position, millis }) => [p.sin(position.y * 4 + millis / 1000) * 0.2, p.map(position.x, 0, 1, 0, 0.2), 0])
      }
      ${draw}
    })`,
    twin: ({ glsl, position: { x, y }, millis }) =>
      glsl.vec3(y.mult(4).add(millis.div(1000)).sin().mult(0.2), x.mult(0.2), 0),
  },
  'instance mode, with a named sketch function and helpers': {
    source: `const sketch = (p) => {
      let wave
      const bump = (x) => p.cos(x * 5) * 0.2
      function both(x, y) { return bump(x) + bump(y) }
      p.setup = function () {
        p.createCanvas(100, 100, p.WEBGL)
        p.noLoop()
        wave = p.createWarp(({ position: { x, y } }) => [0, 0, both(x, y)])
      }
      ${draw}
    }
    const running = new p5(sketch)`,
    twin: ({ glsl, position: { x, y } }) =>
      glsl.vec3(0, 0, x.mult(5).cos().mult(0.2).add(y.mult(5).cos().mult(0.2))),
  },
  'instance mode, with a variable of the sketch': {
    source: `new p5((p) => {
      let wave
      let amount = 0.2
      p.setup = () => {
        p.createCanvas(100, 100, p.WEBGL)
        wave = p.createWarp(({ position }) => position * amount)
      }
      ${draw}
    })`,
    error: /cannot access "amount" of the enclosing scope; .* scope: \{ amount \}/,
  },
}

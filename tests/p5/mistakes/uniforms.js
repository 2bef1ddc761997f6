// Mistakes with uniforms and images.
const noNumber = (name, got) => new RegExp(`a finite number for the uniform "${name}", got ${got}`)
const noImage = (got) => new RegExp(`expected an image, .* for the uniform "heights", got ${got}`)

export default [
  {
    title: 'the option uniforms',
    table: () => ({
      head: `let now = [1, 2]
        const offset = ({ glsl, uniforms }) => glsl.vec3(uniforms.amount, uniforms.at)
        let distort, plain`,
      setup: `
        distort = createWarp(offset, { uniforms: { amount: 0.5, at: () => now, unread: 1 } })
        plain = createWarp(({ position }) => position)`,
      drawing: `
        plain()
        sphere(5)
        distort({ unread: 3 })
        sphere(20)`,
      cases: {
        'createWarp(offset)':
          /^createWarp: the offset reads uniforms\.amount, which nothing declares/,
        'createWarp(offset, { uniforms: { amont: 1, at: [1, 2] } })':
          /declares no "amount"; it declares amont, at\./,
        'createWarp(offset, { uniforms: 3 })':
          /expected an object, .* for the option "uniforms", got the number 3/,
        'createWarp(offset, { uniforms: { amount: "a" } })':
          /^createWarp: expected a number, .* for the uniform "amount", got the text "a"/,
        'createWarp(offset, { uniforms: { mouse: [1, 2] } })': /"mouse" has the name of an input/,
        'createWarp(offset, { uniforms: { amount: 1, at: [1, 2] }, defs: "uniform float x, amount;" })':
          /"amount" is in both options "uniforms" and "defs"/,
        'createWarp(({ glsl }) => glsl.vec3(glsl.param("amount")), { uniforms: { amount: 1 } })':
          /reads "amount" by glsl\.param; .* is read as uniforms\.amount/,
        'createWarp(3, { uniforms: { amount: 1 } })': /expected a function, got the number 3/,
        'distort({ amont: 2 })': /no uniform "amont"; it has amount, at, unread\./,
        'distort({ amount: [1, 2] })': noNumber('amount', 'an array of 2'),
        'distort({ amount: undefined })': noNumber('amount', 'undefined'),
        'distort({ amount: NaN })': /for the uniform "amount", got NaN/,
        'distort({ at: 3 })':
          /expected an array of 2 finite numbers for the uniform "at", got the number 3/,
        'distort({ unread: "x" })': /for the uniform "unread", got the text "x"/,
        'plain({ amount: 2 })':
          /no uniform "amount"; createWarp's option "uniforms" must declare it: \{ uniforms: \{ amount: 0\.5 \} \}/,
        'now = [1, 2, 3]; try { distort() } finally { now = [1, 2] }':
          /for the uniform "at", got an array of 3; its function must always return a value of the same type/,
      },
    }),
  },
  {
    title: 'images',
    table: ({ isWebGPU }) => ({
      head: `const warp = ({ glsl, position }) =>
        glsl.vec3(0, 0, glsl.texture('heights', position.xy()).r())`,
      setup: `
        distort = createWarp(warp, { defs: 'uniform sampler2D heights;' })
        inUniforms = createWarp(
          ({ glsl, position, uniforms }) =>
            glsl.vec3(0, 0, glsl.texture(uniforms.heights, position.xy()).r()),
          { uniforms: { heights: createImage(2, 2) } },
        )`,
      drawing: `
        distort({ heights: createImage(2, 2) })
        sphere(20)`,
      cases: {
        'createWarp(warp)': isWebGPU
          ? /reads "heights", which nothing declares; give it a value by the option/
          : /reads "heights", .* "uniform highp sampler2D heights;"/,
        'inUniforms({ heights: 5 })': noImage('the number 5'),
        // On WEBGPU, p5 itself fails if the value of a texture in defs is no image.
        ...(!isWebGPU && {
          'distort({ heights: 5 })':
            /expected an image, such as one of loadImage or createGraphics, for the uniform "heights", got the number 5/,
          'distort({ heights: null })': noImage('null'),
          'distort({ heights: "a.png" })': /expected an image, .* got the text "a.png"/,
          'distort({ heights: Promise.resolve() })': /expected an image, .* got a promise/,
        }),
      },
    }),
  },
  {
    title: 'uniforms of defs, options and canvases',
    isOn: ({ isWebGPU }) => !isWebGPU,
    table: () => ({
      head: `const warp = ({ glsl }) =>
        glsl.mat3Param('turn').mult(glsl.vec3Param('shift')).add(glsl.param('amount'))`,
      setup: `
        const defs = 'uniform vec3 shift; uniform float amount, unused; uniform mat3 turn;'
        distort = createWarp(warp, { defs })
        layer = createGraphics(10, 10, WEBGL)
        inLayer = layer.createWarp(warp, { defs })`,
      drawing: `
        inLayer()
        layer.sphere(5)
        distort({ unused: 1 })
        sphere(20)`,
      isRemoved: true,
      cases: {
        'createWarp(warp, { defs: 3 })':
          /expected a string of GLSL such as "uniform float size;" for the option "defs"/,
        'createWarp(warp)': /reads "turn", which nothing declares; add .* "uniform mat3 turn;"/,
        'createWarp(({ glsl }) => glsl.vec3Param("shift"))':
          /reads "shift", .* "uniform vec3 shift;"/,
        'distort([3])': /expected an object of uniforms/,
        'distort({ speed: 3 })': /no uniform "speed"/,
        'distort({ amount: undefined })': /uniform "amount": expected a number, got undefined/,
        'distort({ amount: NaN })': /uniform "amount": expected a number/,
        'distort({ amount: "a" })': /uniform "amount": expected a number, got the text "a"/,
        'distort({ shift: 3 })': /uniform "shift": expected an array of numbers/,
        'distort({ turn: [1, 2, 3, 4] })':
          /uniform "turn": expected an array of 9 numbers, column by column, got an array of 4/,
        'layer.remove(); inLayer()': /canvas that this warp was made for is gone/,
        'remove(); distort()': /canvas that this warp was made for is gone/,
      },
    }),
  },
  {
    title: 'WGSL',
    isOn: ({ isWebGPU }) => isWebGPU,
    table: () => ({
      head: `p5.disableFriendlyErrors = true
        const still = ({ glsl }) => glsl.vec3(0, 0, 0)`,
      cases: {
        'createGraphics(50, 50, WEBGPU).createWarp(still)':
          /createGraphics\(width, height, WEBGL\)/,
        'createWarp(({ normal, uv }) => normal.mult(uv.x.mult(uv.y).sin()), {})()':
          /on WEBGPU an offset that depends on both normal and uv/,
        [`createWarp(still, { defs: 'uniform float size[3];' })`]:
          /defs.*uniforms: \{ size: 0\.5 \}/,
        "createWarp(({ glsl }) => glsl.vec3(glsl.vec2Param('v'), 0), { defs: 'uniform vec2 v;' })({ v: 1 })":
          /"v": expected an array of numbers/,
        "createWarp(({ glsl }) => glsl.vec3(glsl.vec2Param('v'), 0), { defs: 'uniform vec2 v;' })({ v: [1] })":
          /"v": expected an array of 2 numbers/,
        "createWarp(still, { shader: baseMaterialShader().modify({ 'Vertex getObjectInputs': '(Vertex inputs) { return inputs; }' }) })":
          /hook getObjectInputs in GLSL; on a WEBGPU canvas write it in WGSL/,
        'createWarp(({ glsl }) => glsl.vec3(glsl.param("size"), 0, 0))': /uniforms/,
      },
    }),
  },
]

// Mistakes with shapes, and with functions that take a shader.
import { setup } from '../scenes/build.js'

const takesNoWarp =
  /: expected a shader, got the function that createWarp returned; .*(warp\(\)|createWarp\(offset)/

const unbuildable = {
  'buildGeometry() with a warp in camera space': {
    warp: "createWarp(({ glsl, position }) => glsl.vec3(position.z, 0, 0), { space: 'camera' })",
    message: /^buildGeometry: .*space: 'camera'.*call the warp before model/,
  },
  'buildGeometry() with an image': {
    warp: `createWarp(({ glsl, uv, uniforms }) =>
      glsl.texture(uniforms.image, uv).xyz, { uniforms: { image: createImage(2, 2) } })`,
    message: /^buildGeometry: .*only the GPU can do\. Call it before model/,
  },
}

export default [
  {
    title: 'the option shader',
    table: ({ isV1 }) => ({
      head: 'const still = ({ glsl }) => glsl.vec3(0, 0, 0)',
      cases: {
        'createWarp(still, { shader: 3 })':
          /"shader": expected a shader that modify\(\) or buildMaterialShader\(\) made, got the number 3/,
        'createWarp(still, { shader: baseStrokeShader() })':
          /expected a shader of shapes, .* got one without hooks for the vertices of shapes/,
        "createWarp(still, { shader: baseMaterialShader(), type: 'normal' })":
          /"type" and "shader" exclude each other/,
        "createWarp(still, { shader: baseMaterialShader(), hooks: 'middle' })":
          /expected 'first' or 'last' for the option "hooks", got the text "middle"/,
        ...(isV1 && {
          "createWarp(still, { shader: baseMaterialShader(), hooks: 'last' })":
            /on p5 1.11 the hooks of the shader always run first/,
        }),
      },
    }),
  },
  {
    title: 'functions that take a shader, called with a warp',
    table: ({ isV1 }) => ({
      head: 'const warps = {}',
      setup,
      cases: {
        'filter(warps.wave)': takesNoWarp,
        'baseMaterialShader().modify(warps.wave)': takesNoWarp,
        'createGraphics(20, 20, WEBGL).shader(warps.wave)': /^shader: .*graphics\.createWarp/,
        ...(!isV1 && {
          'imageShader(warps.wave)': takesNoWarp,
          'strokeShader(warps.wave)': takesNoWarp,
          'buildMaterialShader(warps.wave)': takesNoWarp,
        }),
      },
    }),
  },
  // One case each: after an error, p5 is still inside of buildGeometry().
  ...Object.entries(unbuildable).map(([title, { warp, message }]) => ({
    title,
    table: () => ({
      setup: `warp = ${warp}`,
      cases: { 'buildGeometry(() => { warp(); sphere(10) })': message },
    }),
  })),
  {
    title: 'subdivide and warpBox',
    table: () => ({
      head: 'let shape, wave',
      setup: `
        noStroke()
        shape = buildGeometry(() => box(100))
        wave = createWarp(({ glsl, position, uniforms }) =>
          glsl.vec3(position.y.sin().mult(uniforms.deep), 0, 0), { uniforms: { deep: 1 } })`,
      cases: {
        'await subdivide(shape, { warp: wave, tolerance: 0.5, uniforms: { high: 2 } })':
          /^subdivide: the warp has no uniform "high"; it has .*\bdeep\.$/,
        'await subdivide(shape, { warp: wave })':
          /^subdivide: expected a number above 0 for the option "tolerance"/,
        'await subdivide(shape, { warp: setup, tolerance: 1 })':
          /^subdivide: expected a result of createWarp or compileWarp for the option "warp", got a function/,
        'await subdivide(3, 2)':
          /^subdivide: expected a p5.Geometry with triangles, .* got the number 3/,
        'await subdivide(shape, 1.5)':
          /^subdivide: expected a whole number from 0 to 15 for the option "levels"/,
        'await subdivide(shape)': /^subdivide: expected options such as .*, got undefined/,
        'warpBox(100, 100, 100, 0)': /^warpBox: detail, .* expected a whole number from 1 to 200/,
        'warpBox("a")': /^warpBox: width: expected a number, got the text "a"/,
      },
    }),
  },
]

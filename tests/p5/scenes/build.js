// Warps that are called while p5 builds a geometry must look as they do on the GPU. shader(warp) must look like a call of the warp.
export const setup = `
  noStroke()
  warps.wave = createWarp(({ glsl, position }) => glsl.vec3(0, position.x.mult(5).sin().mult(0.2), 0))
  warps.bumps = createWarp(({ position, normal, uv, uniforms }) =>
    normal.mult(position.y.mult(6).sin().add(uv.x.mult(6.2831853).cos()).mult(uniforms.height)),
    { uniforms: { height: 0.05 } })
  warps.sway = createWarp(({ glsl, position }) => glsl.vec3(position.y.mult(0.05).sin().mult(20), 0, 0),
    { space: 'world' })
  warps.bend = createWarp(({ normal, position }) => normal.normalize().mult(position.x.mult(0.08).sin().mult(8)),
    { space: 'world' })
`

/**
 * Maps a name to [warp, shape, view]. Scenes in world space have no view, since a rotation by p5 applies before the warp if it is drawn,
 * but after it in a built shape.
 */
const shapes = {
  'local space': ['warps.wave()', 'sphere(60, 40, 30)', 'rotateX(0.3)'],
  'with normal and uv': [
    'warps.bumps({ height: 0.12 })',
    'ellipsoid(60, 50, 40, 60, 40)',
    'rotateX(0.3)',
  ],
  'world space': ['warps.sway()', 'push(); rotateZ(0.5); torus(40, 15, 40, 30); pop()', ''],
  'with normal, in world space': [
    'warps.bend()',
    'push(); scale(1.5, 1, 1); sphere(40, 60, 40); pop()',
    '',
  ],
  'between vertices': ['warps.sway()', 'plane(90, 90, 1, 20)', ''],
}
const entries = Object.entries(shapes)
const light =
  "noStroke(); ambientLight(40); directionalLight(255, 255, 255, 0.4, 0.6, -1); fill('coral')"
const red = "lights(); noStroke(); fill('red')"

export default [
  {
    title: 'a warp in buildGeometry() looks as on the GPU, with its uniforms and under lights',
    table: () => ({
      setup: `${setup}
        warps.built = [${entries.map(([, [warp, shape]]) => `buildGeometry(() => { ${warp}; ${shape} }).clearColors()`)}]
        warps.plain = [${entries.map(([, [, shape]]) => `buildGeometry(() => { ${shape} }).clearColors()`)}]`,
      pairs: Object.fromEntries(
        entries.map(([name, [warp, shape, view]], i) => [
          name,
          [`model(warps.built[${i}])`, `${warp}; ${shape}`, `model(warps.plain[${i}])`].map(
            (code) => `${light}; ${view}; ${code}`,
          ),
        ]),
      ),
      ...{ lit: 2000, tolerance: 4, differing: 0.01, different: [0.1, 8] },
    }),
  },
  {
    title: 'shader(warp) applies the warp',
    table: () => ({
      setup,
      pairs: {
        'shader(warp)': ['shader(warps.wave)', 'warps.wave()', ''].map(
          (code) => `${red}; ${code}; sphere(60)`,
        ),
      },
      ...{ lit: 2000, tolerance: 0, differing: 0, different: [1000, 8] },
    }),
  },
]

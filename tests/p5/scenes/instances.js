// model(shape, count) with a warp that differs between instances. Compares the light with that of shapes that p5 itself shears.
const light = `noStroke(); directionalLight(255, 255, 255, 0.6, 0.3, -1); fill('red')`
const drawEach = (code) =>
  `${light}; for (const which of [-1, 0, 1]) { push(); translate(50 * which, 0, 0); ${code}; pop() }`

export default [
  {
    title: 'each instance has its own normals, like those transformed by p5',
    isOn: ({ isV1 }) => !isV1,
    table: () => ({
      setup: `
        shape = buildGeometry(() => sphere(22))
        warps.sheared = createWarp(({ glsl, instance, position }) => {
          const which = instance.sub(1)
          return glsl.vec3(which.mult(50), 0, position.x.mult(which))
        }, { space: 'world' })`,
      pairs: {
        sheared: [
          `${light}; warps.sheared(); model(shape, 3)`,
          drawEach('applyMatrix(1, 0, which, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1); model(shape)'),
          drawEach('model(shape)'),
        ],
      },
      ...{ lit: 2000, tolerance: 6, differing: 0.004, different: [1000, 6], withinEdges: 'both' },
    }),
  },
]

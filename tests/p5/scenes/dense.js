// Shapes with enough vertices to bend: compares warpBox() with p5's box(), and with a subdivided box.
const turned = 'rotateX(0.5); rotateY(0.7)'
const lit = `noStroke(); ambientLight(60); directionalLight(200, 200, 200, 0.5, 1, -1); ${turned}`
const outlines = `noFill(); stroke(255); strokeWeight(4); ${turned}`

const checks = `
  checks = createImage(8, 8)
  for (let y = 0; y < 8; y++)
    for (let x = 0; x < 8; x++) checks.set(x, y, color(30 * x, 30 * y, (x + y) % 2 * 200))
  checks.updatePixels()`

export default [
  {
    title: "warpBox looks like p5's box",
    table: () => ({
      setup: checks,
      pairs: Object.fromEntries(
        Object.entries({
          texture: [`${lit}; texture(checks)`, '60, 100, 80'],
          outlines: [outlines, '60, 100, 80'],
          'a cube': [lit, '70'],
        }).map(([name, [look, size]]) => [
          name,
          ['warpBox', 'box'].map((box) => `${look}; ${box}(${size})`),
        ]),
      ),
      // Antialiased lines differ where they are split into pieces. One missing line of twelve would be 8%.
      ...{ lit: 1500, tolerance: 6, differing: (name) => (name === 'outlines' ? 0.03 : 0.01) },
    }),
  },
  {
    title: 'warpBox bends, and so does a subdivided shape',
    table: ({ isV1 }) => ({
      // p5 1.11 does not wait for an async setup.
      setup: `
        ${isV1 ? '' : 'warps.dense = await subdivide(buildGeometry(() => box(60, 100, 80)), 3)'}
        warps.bend = createWarp(({ glsl, position }) =>
          glsl.vec3(position.y.div(25).sin().mult(20), 0, 0), { space: 'world' })`,
      pairs: {
        bent: [
          'warpBox(60, 100, 80, 16)',
          isV1 ? 'warpBox(60, 100, 80, 16)' : 'model(warps.dense)',
          'box(60, 100, 80)',
        ].map((code) => `${lit}; warps.bend(); ${code}`),
      },
      ...{ lit: 1500, tolerance: 12, differing: 0.02, different: [500, 30] },
    }),
  },
]

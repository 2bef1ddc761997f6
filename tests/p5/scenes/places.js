// Compares warps with p5's translate(): in a framebuffer, with shapes of several sources, and under an image light and before a panorama.
import { isRun } from '../../../.scripts/lib/tiers.mjs'

const shapes = {
  'in a framebuffer': (move) =>
    `target.begin(); clear(); ${move}; fill('red'); sphere(30); target.end(); resetShader(); image(target, -100, -100)`,
  'built by buildGeometry': (move) => `lights(); ${move}; fill('red'); model(built)`,
  'made by createModel': (move) => `lights(); ${move}; fill('red'); scale(30); model(made)`,
  ...(isRun('unusual p5 pages') && {
    'under an imageLight': (move) =>
      `imageLight(sky); ${move}; specularMaterial(200); shininess(90); sphere(30)`,
    // p5 draws this shape with a separate shader.
    'before a panorama': (move) => `panorama(sky); lights(); ${move}; fill('red'); sphere(30)`,
  }),
  'made of vertex() calls': (move) =>
    `${move}; fill('red'); beginShape(); vertex(-20, -20); vertex(20, -20); vertex(0, 20); endShape(CLOSE)`,
}

/** A parallel projection, so that a shape looks the same after it moves. */
const look = 'ortho(); noStroke()'

export default [
  {
    title:
      'a warp moves drawings in a framebuffer, shapes of several sources, and shapes under an image light',
    table: () => ({
      setup: `
        right = createWarp(({ glsl }) => glsl.vec3(40, 0, 0), { space: 'world' })
        target = createFramebuffer({ width: 200, height: 200, density: 1 })
        built = buildGeometry(() => { translate(0, 20, 0); sphere(30) })
        built.normalize && (built.gid = 'built')
        made = createModel('v -1 -1 0\\nv 1 -1 0\\nv 0 1 0\\nvn 0 0 1\\nvt 0 0\\nf 1/1/1 2/1/1 3/1/1\\n', '.obj')
        sky = createImage(32, 16)
        for (let y = 0; y < 16; y++)
          for (let x = 0; x < 32; x++) sky.set(x, y, color(8 * x, 200 - 9 * y, 90))
        sky.updatePixels()`,
      // The third picture, without a motion, must differ.
      pairs: Object.fromEntries(
        Object.entries(shapes).map(([name, shape]) => [
          name,
          ['right()', 'translate(40, 0, 0)', ''].map((move) => `${look}; ${shape(move)}`),
        ]),
      ),
      ...{ lit: 300, tolerance: 8, differing: 39, different: [300, 30] },
    }),
  },
]

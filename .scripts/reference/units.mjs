// What `position` is on the shapes of p5, for the pictures of web/docs/units.md. tests/p5/units.browser.test.js reads the numbers off what
// p5 draws.

/** How far the eye is in front of the canvas, unless a sketch says otherwise. */
export const eye = 800

/**
 * `call`, drawn without a translation, and `title` where that is shorter; `local` and `world`, from where to where x, y and z go;
 * `outline`, as drawn in a frame of 90 by 70 around the origin.
 */
export const shapes = [
  {
    call: 'plane(600, 400)',
    local: [[-0.5, 0.5], [-0.5, 0.5], [0, 0]], // prettier-ignore
    world: [[-300, 300], [-200, 200], [0, 0]], // prettier-ignore
    outline: 'M-42 -28H42V28H-42Z',
  },
  {
    call: 'box(100, 200, 50)',
    local: [[-0.5, 0.5], [-0.5, 0.5], [-0.5, 0.5]], // prettier-ignore
    world: [[-50, 50], [-100, 100], [-25, 25]], // prettier-ignore
    outline: 'M-20 -28H14V34H-20ZM-20 -28L-10 -35H24L14 -28M24 -35V27L14 34',
  },
  {
    call: 'sphere(100)',
    local: [[-1, 1], [-1, 1], [-1, 1]], // prettier-ignore
    world: [[-100, 100], [-100, 100], [-100, 100]], // prettier-ignore
    outline: 'M-34 0a34 34 0 1 0 68 0a34 34 0 1 0 -68 0a34 10 0 0 0 68 0',
  },
  {
    call: 'cylinder(50, 200)',
    local: [[-1, 1], [-0.5, 0.5], [-1, 1]], // prettier-ignore
    world: [[-50, 50], [-100, 100], [-50, 50]], // prettier-ignore
    outline: 'M-20 -28a20 6 0 1 0 40 0a20 6 0 1 0 -40 0V28a20 6 0 0 0 40 0V-28',
  },
  {
    call: 'torus(100, 25)',
    local: [[-1.25, 1.25], [-1.25, 1.25], [-0.25, 0.25]], // prettier-ignore
    world: [[-125, 125], [-125, 125], [-25, 25]], // prettier-ignore
    outline: 'M-35 0a35 35 0 1 0 70 0a35 35 0 1 0 -70 0M-21 0a21 21 0 1 0 42 0a21 21 0 1 0 -42 0',
  },
  {
    call: 'rect(0, 0, 90, 60)',
    local: [[0, 1], [0, 1], [0, 0]], // prettier-ignore
    world: [[0, 90], [0, 60], [0, 0]], // prettier-ignore
    outline: 'M0 0H45V30H0Z',
  },
  {
    call: 'circle(0, 0, 200)',
    local: [[0, 1], [0, 1], [0, 0]], // prettier-ignore
    world: [[-100, 100], [-100, 100], [0, 0]], // prettier-ignore
    outline: 'M-30 0a30 30 0 1 0 60 0a30 30 0 1 0 -60 0',
  },
  {
    call: 'triangle(0, -90, 80, 60, -80, 60)',
    title: 'triangle(…)',
    local: [[0, 1], [0, 1], [0, 0]], // prettier-ignore
    world: [[-80, 80], [-90, 60], [0, 0]], // prettier-ignore
    outline: 'M0 -34L32 24H-32Z',
  },
  {
    call: 'quad(-90, -70, 90, -40, 90, 70, -90, 40)',
    title: 'quad(…)',
    local: [[-90, 90], [-70, 70], [0, 0]], // prettier-ignore
    world: [[-90, 90], [-70, 70], [0, 0]], // prettier-ignore
    outline: 'M-36 -28L36 -16V28L-36 16Z',
  },
  {
    call: 'beginShape(); vertex(-60, -45, 10); vertex(60, 0, -10); vertex(-60, 45, 10); endShape()',
    title: 'beginShape()',
    local: [[-60, 60], [-45, 45], [-10, 10]], // prettier-ignore
    world: [[-60, 60], [-45, 45], [-10, 10]], // prettier-ignore
    outline: 'M-34 -26L34 0L-34 26Z',
  },
  {
    call: 'model(buildGeometry(() => box(80, 60, 40)))',
    title: 'buildGeometry(…)',
    local: [[-40, 40], [-30, 30], [-20, 20]], // prettier-ignore
    world: [[-40, 40], [-30, 30], [-20, 20]], // prettier-ignore
    outline: 'M-32 -18H22V28H-32ZM-32 -18L-20 -28H34L22 -18M34 -28V18L22 28',
  },
  {
    call: "model(createModel('v -3 -4 -5\\nv 3 -4 5\\nv 0 4 0\\nf 1 2 3', '.obj'))",
    title: 'loadModel(…)',
    local: [[-3, 3], [-4, 4], [-5, 5]], // prettier-ignore
    world: [[-3, 3], [-4, 4], [-5, 5]], // prettier-ignore
    outline: 'M-30 24c-20 -40 10 -66 32 -52c10 -26 24 -22 12 2c28 8 36 32 16 50z',
  },
]

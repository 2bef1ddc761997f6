// The ranges of `position` on p5's shapes, which the pictures web/docs/units-….svg show.

/** The distance from the eye to the canvas in p5, by default. */
export const eye = 800

/**
 * `call` is code that draws the shape without a translation; `title`, if present, is a shorter form for the picture. `local` and `world`
 * are the ranges of x, y and z in local and in world space.
 */
export const shapes = [
  {
    call: 'plane(600, 400)',
    local: [[-0.5, 0.5], [-0.5, 0.5], [0, 0]], // prettier-ignore
    world: [[-300, 300], [-200, 200], [0, 0]], // prettier-ignore
  },
  {
    call: 'box(100, 200, 50)',
    local: [[-0.5, 0.5], [-0.5, 0.5], [-0.5, 0.5]], // prettier-ignore
    world: [[-50, 50], [-100, 100], [-25, 25]], // prettier-ignore
  },
  {
    call: 'sphere(100)',
    local: [[-1, 1], [-1, 1], [-1, 1]], // prettier-ignore
    world: [[-100, 100], [-100, 100], [-100, 100]], // prettier-ignore
  },
  {
    call: 'cylinder(50, 200)',
    local: [[-1, 1], [-0.5, 0.5], [-1, 1]], // prettier-ignore
    world: [[-50, 50], [-100, 100], [-50, 50]], // prettier-ignore
  },
  {
    call: 'torus(100, 25)',
    local: [[-1.25, 1.25], [-1.25, 1.25], [-0.25, 0.25]], // prettier-ignore
    world: [[-125, 125], [-125, 125], [-25, 25]], // prettier-ignore
  },
  {
    call: 'rect(0, 0, 90, 60)',
    local: [[0, 1], [0, 1], [0, 0]], // prettier-ignore
    world: [[0, 90], [0, 60], [0, 0]], // prettier-ignore
  },
  {
    call: 'circle(0, 0, 200)',
    local: [[0, 1], [0, 1], [0, 0]], // prettier-ignore
    world: [[-100, 100], [-100, 100], [0, 0]], // prettier-ignore
  },
  {
    call: 'triangle(0, -90, 80, 60, -80, 60)',
    title: 'triangle(…)',
    local: [[0, 1], [0, 1], [0, 0]], // prettier-ignore
    world: [[-80, 80], [-90, 60], [0, 0]], // prettier-ignore
  },
  {
    call: 'quad(-90, -70, 90, -40, 90, 70, -90, 40)',
    title: 'quad(…)',
    local: [[-90, 90], [-70, 70], [0, 0]], // prettier-ignore
    world: [[-90, 90], [-70, 70], [0, 0]], // prettier-ignore
  },
  {
    call: 'beginShape(); vertex(-60, -45, 10); vertex(60, 0, -10); vertex(-60, 45, 10); endShape()',
    title: 'beginShape()',
    local: [[-60, 60], [-45, 45], [-10, 10]], // prettier-ignore
    world: [[-60, 60], [-45, 45], [-10, 10]], // prettier-ignore
  },
  {
    call: 'model(buildGeometry(() => box(80, 60, 40)))',
    title: 'buildGeometry(…)',
    local: [[-40, 40], [-30, 30], [-20, 20]], // prettier-ignore
    world: [[-40, 40], [-30, 30], [-20, 20]], // prettier-ignore
  },
  {
    call: "model(createModel('v -3 -4 -5\\nv 3 -4 5\\nv 0 4 0\\nf 1 2 3', '.obj'))",
    title: 'loadModel(…)',
    local: [[-3, 3], [-4, 4], [-5, 5]], // prettier-ignore
    world: [[-3, 3], [-4, 4], [-5, 5]], // prettier-ignore
  },
]

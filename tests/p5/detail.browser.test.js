// The option `detail`: coarse shapes look like dense ones.
import assert from 'node:assert/strict'
import { test } from 'node:test'
import { isRun } from '../../.scripts/lib/tiers.mjs'
import { watchHoles } from '../support/browser/p5-holes.js'
import { openP5Hosts } from '../support/browser/p5-hosts.js'
import { differingPixels } from '../support/browser/pixels.js'

const hosts = await openP5Hosts()

const offsets = {
  twist: `({ glsl, position }) => {
    const angle = position.y().mult(1.8)
    const [c, s] = [angle.cos(), angle.sin()]
    const [x, y, z] = [position.x(), position.y(), position.z()]
    return glsl.vec3(x.mult(c).sub(z.mult(s)), y, x.mult(s).add(z.mult(c))).sub(position)
  }`,
  flag: `({ glsl, uv }) => glsl.vec3(0, 0, uv.x().mult(9).sin().mult(uv.x()).mult(30))`,
  bend: `({ glsl, position }) => glsl.vec3(0, position.x().mult(0.03).cos().mult(40), 0)`,
}

const setup = Object.entries(offsets)
  .map(([name, offset]) => {
    return `warps.${name} = createWarp(${offset}, { normals: 'pixel' })
      warps.${name}Fine = createWarp(${offset}, { normals: 'pixel', detail: 1 })`
  })
  .join('\n')

const look =
  'background(220); noStroke(); lights(); fill(255, 127, 80); rotateX(-0.4); rotateY(0.5);'

/** Maps a name → [warp, code of the coarse shape, code of the dense one]. */
const shapes = {
  'a box that is twisted': ['twist', 'box(120)', 'warpBox(120, 120, 120, 48)'],
  'a plane of two triangles that waves by uv': [
    'flag',
    'plane(170, 170, 1, 1)',
    'plane(170, 170, 120, 120)',
  ],
}

for (const host of hosts) {
  test(`${host.name}: coarse shapes with detail look like dense ones`, async () => {
    const scenes = {}
    for (const [name, [warp, coarse, dense]] of Object.entries(shapes)) {
      scenes[`${name}, coarse`] = `${look} warps.${warp}(); ${coarse}`
      scenes[`${name}, fine`] = `${look} warps.${warp}Fine(); ${coarse}`
      scenes[`${name}, dense`] = `${look} warps.${warp}(); ${dense}`
    }
    const images = await host.draw({ size: 240, setup, scenes })
    for (const name of Object.keys(shapes)) {
      const expected = images[`${name}, dense`]
      const before = differingPixels(images[`${name}, coarse`], expected, 24)
      const after = differingPixels(images[`${name}, fine`], expected, 24)
      assert.ok(before > 1000, `${name}: the coarse shape differs at ${before} pixels`)
      // Pixels at edges and silhouettes may differ.
      assert.ok(after < 250, `${name}: the divided shape differs at ${after} pixels`)
    }
  })

  test(`${host.name}: curved triangles round the outline of a coarse sphere`, async () => {
    const scenes = Object.fromEntries(
      Object.entries({
        coarse: ['still', 'sphere(90, 16, 12)'],
        curved: ['stillCurved', 'sphere(90, 16, 12)'],
        dense: ['still', 'sphere(90, 160, 120)'],
      }).map(([name, [warp, shape]]) => [name, `${look} warps.${warp}(); ${shape}`]),
    )
    const still = `({ glsl }) => glsl.vec3(0, 0, 0)`
    const images = await host.draw({
      size: 240,
      setup: `warps.still = createWarp(${still}, { normals: 'pixel' })
      warps.stillCurved = createWarp(${still}, { normals: 'pixel', detail: { tolerance: 0.25, curved: true } })`,
      scenes,
    })
    const before = differingPixels(images.coarse, images.dense, 24)
    const after = differingPixels(images.curved, images.dense, 24)
    assert.ok(after < 250, `the curved one differs at ${after} pixels`)
    assert.ok(before > 2 * after, `the coarse one differs at ${before} pixels`)
  })

  test(`${host.name}: the same shape several times in a frame, in each space`, async () => {
    const spaces = ['local', 'world', 'camera']
    const bends = spaces
      .map(
        (space) => `warps.${space} = createWarp(${offsets.bend}, { space: '${space}' })
        warps.${space}Fine = createWarp(${offsets.bend}, { space: '${space}', detail: 1 })`,
      )
      .join('\n')
    const boxes = (draw) => `translate(-60, 40, 0); ${draw}
      translate(120, 0, -100); rotateZ(0.6); ${draw}
      translate(-60, -90, 50); scale(0.5); ${draw}`
    const scenes = {}
    for (const space of spaces) {
      scenes[`${space}, fine`] = `${look} warps.${space}Fine(); ${boxes('box(80)')}`
      scenes[`${space}, dense`] = `${look} warps.${space}(); ${boxes('warpBox(80, 80, 80, 48)')}`
    }
    const images = await host.draw({ size: 240, setup: bends, scenes })
    for (const space of spaces) {
      const differing = differingPixels(images[`${space}, fine`], images[`${space}, dense`], 24)
      assert.ok(differing < 250, `${space}: ${differing} pixels differ`)
    }
  })

  // On p5 1.11, the same code divides, and shaders are the same as on 2.x.
  const frames = isRun('300 moving frames') && !host.isV1 ? 300 : 60
  test(`${host.name}: closed shapes have no holes in ${frames} moving frames`, async (t) => {
    const found = await watchHoles(host, { frames })
    t.diagnostic(JSON.stringify(found))
    assert.equal(found.holes, 0)
    assert.ok(found.least > 1500, `${found.least} pixels are covered`)
    assert.ok(found.indexUploads > frames, `${found.indexUploads} uploads of indices`)
    // With a tolerance of one pixel, most gaps of a broken edge would be narrower than a pixel.
    const broken = await watchHoles(host, { frames: 40, isBroken: true, tolerance: 6 })
    t.diagnostic(`broken: ${JSON.stringify(broken)}`)
    assert.ok(broken.framesWithHoles > 0, 'a broken edge is not noticed')
  })

  test(`${host.name}: warns once about a shape that is not divided`, async () => {
    const triangle = 'beginShape(); vertex(0, 0); vertex(30, 0); vertex(0, 30); endShape(CLOSE)'
    const onlyLines =
      /: lines, and shapes between beginShape\(\) and endShape\(\), are not divided\./
    /** Maps a name → [offset function, code, message if there is one]. */
    const cases = {
      'a box': [offsets.bend, 'box(50); push(); stroke(0); box(40); pop()'],
      'a shape of vertices': [offsets.bend, triangle, onlyLines],
      'a line': [offsets.bend, 'stroke(0); warp(); line(0, 0, 30, 30)', onlyLines],
      'a line that the warp does not move': [
        offsets.flag,
        'box(50); resetShader(); stroke(0); line(0, 0, 9, 9)',
      ],
      'a hundred boxes': [offsets.bend, 'for (let i = 0; i < 50; i++) box(5)'],
      'more boxes': [
        offsets.bend,
        'for (let i = 0; i < 51; i++) box(5)',
        /: only the first 100 draws of a shape in a frame are divided\./,
      ],
      'only on the GPU': [
        `({ glsl, position }) => {
          const glslText = 'float mine(float x) { return x; }'
          const wgslText = 'fn mine(x: f32) -> f32 { return x; }'
          return glsl.fn({ name: 'mine', source: { glsl: glslText, wgsl: wgslText }, arity: 1, derivatives: [1] })(position)
        }`,
        'box(50)',
        /each shape .*: the offset calls a glsl\.fn or reads an image/,
      ],
      // On WEBGPU, p5 throws for such shapes.
      ...(!host.isWebGPU && {
        'no uvs': [offsets.flag, 'model(bare)', /: it has no uvs, which the offset reads\./],
      }),
      ...(!host.isV1 && {
        instances: [offsets.bend, 'model(shape, 2)', /: instances are not divided\./],
      }),
    }
    const draws = Object.entries(cases).map(
      ([name, [offset, code]]) => `'${name}': [${offset}, (warp) => { ${code} }]`,
    )
    const { result } = await host.run(`
      const warnings = []
      console.warn = (message) => warnings.push(message)
      async function setup() {
        ${host.canvas(100, 100)}
        const shape = buildGeometry(() => box(20))
        const bare = new p5.Geometry(1, 1, function () {
          this.gid = 'bare'
          this.vertices = [createVector(0, 0), createVector(9, 0), createVector(0, 9)]
          this.faces = [[0, 1, 2]]
        })
        window.result = {}
        for (const [name, [offset, draw]] of Object.entries({ ${draws} })) {
          const warp = createWarp(offset, { detail: 1 })
          // Draws twice in one frame; the warning must not repeat.
          for (let i = 0; i < 2; i++) {
            push()
            noStroke()
            warp()
            draw(warp)
            pop()
          }
          window.result[name] = warnings.splice(0)
        }
        window.done = true
      }`)
    for (const [name, [, , message]] of Object.entries(cases)) {
      assert.equal(result[name].length, message ? 1 : 0, `${name}: ${result[name]}`)
      if (message) assert.match(result[name][0], message)
    }
  })

  test(`${host.name}: strokes lie on the surface`, async () => {
    // The edges of a box, each of 64 pieces.
    const dense = `warps.dense = new p5.Geometry(1, 1, function () {
      this.gid = 'dense edges'
      for (const axis of [0, 1, 2])
        for (const [u, v] of [[-1, -1], [-1, 1], [1, -1], [1, 1]])
          for (let i = 0; i <= 64; i++) {
            const place = []
            place[axis] = i / 64 - 0.5
            place[(axis + 1) % 3] = u / 2
            place[(axis + 2) % 3] = v / 2
            if (i > 0) this.edges.push([this.vertices.length - 1, this.vertices.length])
            this.vertices.push(createVector(...place))
          }
    })`
    const lines = 'stroke(0, 0, 200); strokeWeight(3);'
    const other = `stroke(0, 0, 200); strokeWeight(3); rotateZ(0.4); scale(0.7);`
    const scenes = {
      coarse: `${look} noFill(); ${lines} warps.twist(); box(120)`,
      fine: `${look} noFill(); ${lines} warps.twistFine(); box(120)`,
      dense: `${look} noFill(); ${lines} warps.twist(); scale(120); model(warps.dense)`,
      'filled coarse': `${look} ${lines} warps.twist(); box(120)`,
      'filled fine': `${look} ${lines} warps.twistFine(); box(120)`,
      'filled dense': `${look} push(); warps.twist(); warpBox(120, 120, 120, 48); pop();
        noFill(); ${lines} warps.twist(); scale(120); model(warps.dense)`,
      // The first box has no stroke. Its division must not be reused for the strokes of the second one, which has another matrix.
      'twice fine': `${look} warps.twistFine(); box(120); noFill(); ${other} warps.twistFine(); box(120)`,
      'twice dense': `${look} push(); warps.twist(); warpBox(120, 120, 120, 48); pop();
        noFill(); ${other} warps.twist(); scale(120); model(warps.dense)`,
    }
    const images = await host.draw({ size: 240, setup: `${setup}\n${dense}`, scenes })
    for (const kind of ['', 'filled ', 'twice ']) {
      const expected = images[`${kind}dense`]
      // Lines that are half a pixel off differ by half their color.
      const after = differingPixels(images[`${kind}fine`], expected, 128)
      assert.ok(after < 150, `${kind}: the fine one differs at ${after} pixels`)
      if (kind === 'twice ') continue
      const before = differingPixels(images[`${kind}coarse`], expected, 128)
      assert.ok(before > 1000, `${kind}: the coarse one differs at ${before} pixels`)
    }
  })
}

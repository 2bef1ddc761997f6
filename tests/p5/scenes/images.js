// Images that displace a plane: all ways to pass an image must look the same, and each wrap mode must look like that of p5.
import {
  planeHeight as height,
  heightOffset as offset,
  setupOfImages,
  planeSide as side,
  imageSources as sources,
} from '../../support/browser/p5-images.js'

const plane = `plane(${side}, ${side}, 160, 160)`

export default [
  {
    title: 'an image uniform can be a value or a function, and can be overridden in a call',
    table: (host) => ({
      setup: `${setupOfImages(host, sources.image, sources.graphics)}
        const flat = createImage(1, 1)
        const uniforms = (heights) => ({ type: 'normal', uniforms: { amount: ${height}, heights } })
        warps.value = createWarp(${offset('uniforms.heights', 'uniforms.amount')}, uniforms(warps.image))
        warps.follow = createWarp(${offset('uniforms.heights', 'uniforms.amount')}, uniforms(() => warps.graphics))
        warps.other = createWarp(${offset('uniforms.heights', 'uniforms.amount')}, uniforms(flat))
        warps.byName = createWarp(${offset(`'heights'`, height)}, { type: 'normal', defs: 'uniform sampler2D heights;' })`,
      pairs: Object.fromEntries(
        ['value()', 'follow()', 'other({ heights: warps.image })'].map((call) => [
          call,
          [call, 'byName({ heights: warps.image })', 'other()'].map(
            (code) => `warps.${code}; ${plane}`,
          ),
        ]),
      ),
      ...{ lit: 20_000, tolerance: 1, differing: 0, different: [5000, 30] },
    }),
  },
  {
    title: 'by default, an image uses the wrap mode of textureWrap() and its own filter',
    table(host) {
      const makeWarp = (name, options) =>
        `warps.${name} = createWarp(({ glsl, position, uniforms }) => glsl.vec3(0, 0, glsl
          .texture(uniforms.heights, position.xy().mult(2.6)${options}).r().mult(${height})),
          { type: 'normal', uniforms: { heights: warps.image } })`
      const withOption = (wrap) => `textureWrap(CLAMP); warps.${wrap}(); ${plane}`
      // Maps a wrap mode to another one, with which the third picture must look different.
      const others = { clamp: 'repeat', repeat: 'mirror', mirror: 'repeat' }
      return {
        setup: [
          setupOfImages(host, sources.image),
          makeWarp('host', ''),
          ...Object.keys(others).map((wrap) =>
            makeWarp(wrap, `, { wrap: '${wrap}', filter: 'bilinear' }`),
          ),
        ].join('\n'),
        pairs: Object.fromEntries(
          Object.entries(others).map(([wrap, other]) => [
            wrap,
            [
              `textureWrap(${wrap.toUpperCase()}); warps.host(); ${plane}`,
              withOption(wrap),
              withOption(other),
            ],
          ]),
        ),
        ...{ lit: 20_000, tolerance: 1, differing: 0, different: [3000, 30] },
      }
    },
  },
  {
    // plane(160, 160) is a plane of 1 by 1 that is scaled in two directions, but not in the third.
    title: 'a displaced plane is lit the same whether plane() or scale() sets its size',
    table(host) {
      const light = 'ambientLight(60); directionalLight(255, 255, 255, 0.8, 0.2, -0.5); fill(200);'
      const warp = (amount) =>
        `createWarp(${offset('uniforms.heights', amount)}, { uniforms: { heights: warps.image } })`
      return {
        // On p5 1.11 the first picture under lights shows no relief, unless the image was drawn before.
        setup: `${setupOfImages(host, sources.image, sources.drawn)}
          warps.flat = ${warp(height)}
          warps.even = ${warp(height / side)}`,
        pairs: {
          scaled: [
            `${light} warps.flat(); plane(${side}, ${side}, 60, 60)`,
            `${light} scale(${side}); warps.even(); plane(1, 1, 60, 60)`,
          ],
        },
        ...{ lit: 20_000, tolerance: 3, differing: 39 },
      }
    },
  },
]

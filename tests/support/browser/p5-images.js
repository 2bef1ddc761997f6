// An image of random bytes that displaces a plane, for tests of glsl.texture in p5 sketches.
import { randomImage } from '../../operations/textures.js'

export const heightImage = randomImage(7, 5, 4)
// All texels are opaque, since p5 stores images with premultiplied alpha.
heightImage.data = heightImage.data.map((byte, i) => (i % 4 === 3 ? 255 : byte))

const { width, height, data } = heightImage

/** The side of the plane, and how far white texels displace it, in pixels. */
export const [planeSide, planeHeight] = [160, 30]

/** Maps a p5 pixel container → code that creates the image in it. */
export const imageSources = {
  image: `warps.image = createImage(${width}, ${height})
    fillPixels(warps.image)`,
  graphics: `warps.graphics = createGraphics(${width}, ${height})
    warps.graphics.pixelDensity(1)
    fillPixels(warps.graphics)`,
  framebuffer: `warps.framebuffer = createFramebuffer({
      width: ${width}, height: ${height}, density: 1, format: UNSIGNED_BYTE, depth: false, antialias: false,
    })
    fillPixels(warps.framebuffer)`,
  drawn: `warps.drawn = createFramebuffer({
      width: ${width}, height: ${height}, density: 1,
    })
    warps.drawn.begin()
    noStroke()
    image(warps.image, ${-width / 2}, ${-height / 2})
    warps.drawn.end()`,
}

/** Returns code that creates some of the sources, and views the plane from the front. */
export const setupOfImages = ({ isWebGPU }, ...sources) => `
  const fillPixels = (target) => {
    target.loadPixels()
    const bytes = ${JSON.stringify(data)}
    bytes.forEach((byte, i) => (target.pixels[i] = byte))
    target.updatePixels()
  }
  ${sources.join('\n')}
  noStroke()
  ${isWebGPU ? '// p5 2.3 cuts off the front half of ortho() on WEBGPU.\n  ortho(-100, 100, -100, 100, -1000, 1000)' : 'ortho()'}`

/** Returns the source of an offset that displaces a plane by an image, sampled by a B-spline. */
export const heightOffset = (
  image,
  amount,
) => `({ glsl, position, uniforms }) => glsl.vec3(0, 0, glsl
  .texture(${image}, position.xy().add(0.5), { filter: 'bspline' }).r().mult(${amount}))`

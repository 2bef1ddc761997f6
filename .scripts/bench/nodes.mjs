// npm run bench -- nodes: compares frames, and the first one, of two of three's showcases with normals by hand and by exactNormals.
import { webgpuFlags } from '../../tests/support/browser/browser.js'
import { threePages } from '../../tests/support/browser/three/open.js'

/** The side of the picture in pixels, and the number of frames of each kind in each of four rounds. */
const [side, frames] = [400, 6]

export async function measure() {
  const pages = await threePages(webgpuFlags)
  try {
    const { page } = await pages.open('three', 'exact-normals/page-bench.js')
    for (const name of ['sea', 'terrain'])
      for (const backend of ['webgl', 'webgpu']) {
        console.log(`${name}, ${backend}, milliseconds`)
        console.table(
          await page.evaluate((given) => bench.measure(...given), [name, backend, side, frames]),
        )
      }
  } finally {
    await pages.close()
  }
}

// Scenes that must look the same whether a warp or p5 itself moves the shapes, on each host. The files of the folder scenes have tables of
// them.
import { describe, test } from 'node:test'
import { openP5Hosts } from '../support/browser/p5-hosts.js'
import { comparePictures } from '../support/browser/same-pictures.js'
import build from './scenes/build.js'
import dense from './scenes/dense.js'
import images from './scenes/images.js'
import instances from './scenes/instances.js'
import materials from './scenes/materials.js'
import mirror from './scenes/mirror.js'
import places from './scenes/places.js'
import shader from './scenes/shader.js'
import strokes from './scenes/strokes.js'

const tables = [
  ...[build, dense, images, instances, materials, mirror, places, shader, strokes],
].flat()

for (const host of await openP5Hosts())
  describe(host.name, () => {
    for (const { title, isOn = () => true, table } of tables)
      if (isOn(host)) test(title, async () => comparePictures(host, await table(host)))
  })

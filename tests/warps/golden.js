import { readFileSync, readdirSync } from 'node:fs'
import { warps } from './index.js'

export const goldenFolder = new URL('../golden/', import.meta.url)

/** The texts to keep, by file name: those of the gallery, and of the stress test but for its hundreds of sines. */
export const goldenTexts = () =>
  Object.fromEntries(
    warps
      .filter(({ kept }) => kept)
      .map(({ name, text, compile }) => [
        `${name.replaceAll(' ', '-')}.glsl`,
        text ?? compile('glsl300').code,
      ]),
  )

/** The texts as they were kept. */
export const keptTexts = () =>
  Object.fromEntries(
    readdirSync(goldenFolder).map((file) => [
      file,
      readFileSync(new URL(file, goldenFolder), 'utf8'),
    ]),
  )

import { readFileSync, readdirSync } from 'node:fs'
import { warps } from './index.js'
import { languageTexts } from './languages.js'

export const goldenFolder = new URL('../golden/', import.meta.url)

const warpTexts = () =>
  Object.fromEntries(
    warps
      .filter(({ kept }) => kept)
      .map(({ name, text, compile }) => [
        `${name.replaceAll(' ', '-')}.glsl`,
        text ?? compile('glsl300').code,
      ]),
  )

/**
 * The texts to keep, by file name: those of the gallery, of the stress test but for its hundreds of sines, and what the
 * languages write differently.
 */
export const goldenTexts = () => ({ ...warpTexts(), ...languageTexts() })

/** The texts as they were kept. */
export const keptTexts = () =>
  Object.fromEntries(
    readdirSync(goldenFolder).map((file) => [
      file,
      readFileSync(new URL(file, goldenFolder), 'utf8'),
    ]),
  )

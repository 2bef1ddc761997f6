import { readFileSync, readdirSync } from 'node:fs'
import { warps } from './index.js'
import { languageTexts } from './languages.js'

export const goldenFolder = new URL('../golden/', import.meta.url)

const warpTexts = () =>
  Object.fromEntries(
    warps
      .filter(({ isGolden }) => isGolden)
      .map(({ name, text, compile }) => [
        `${name.replaceAll(' ', '-')}.glsl`,
        text ?? compile('glsl300').code,
      ]),
  )

/**
 * Generates the golden files; returns the code by file name: that of the gallery, of the stress test without its stacked sines, and of the
 * differences between languages.
 */
export const goldenTexts = () => ({ ...warpTexts(), ...languageTexts() })

/** Reads the stored golden files; returns the code by file name. */
export const readGoldenTexts = () =>
  Object.fromEntries(
    readdirSync(goldenFolder).map((file) => [
      file,
      readFileSync(new URL(file, goldenFolder), 'utf8'),
    ]),
  )

// Reads command lines with numbers.
import { parseArgs } from 'node:util'
import { Stop } from './terminal.mjs'

/**
 * Returns the options on the command line `args`. `numbers` describes the options that are whole numbers of at least 1: it maps the name of
 * each option → its default, or undefined. `others` describes the other options as parseArgs does.
 */
export function parseOptions(args, numbers, others = {}) {
  const names = Object.keys(numbers)
  const texts = names.map((name) => [name, { type: 'string', default: numbers[name]?.toString() }])
  const { values } = parseArgs({ args, options: { ...Object.fromEntries(texts), ...others } })
  for (const name of names.filter((name) => values[name] !== undefined)) {
    if (!/^[1-9]\d*$/.test(values[name]))
      throw new Stop(`Expected --${name} to be a whole number of at least 1, got ${values[name]}.`)
    values[name] = Number(values[name])
  }
  return { ...values }
}

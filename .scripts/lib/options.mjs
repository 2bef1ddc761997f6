// Reads command lines with numbers.
import { parseArgs } from 'node:util'
import { Stop } from './terminal.mjs'

/**
 * Returns the options on the command line `args`. `numbers` maps the name of each option that is a whole number from 1 → its default, or
 * undefined; `others` describes the other options as parseArgs does.
 */
export function parseOptions(args, numbers, others = {}) {
  const names = Object.keys(numbers)
  const texts = names.map((name) => [name, { type: 'string', default: numbers[name]?.toString() }])
  const { values } = parseArgs({ args, options: { ...Object.fromEntries(texts), ...others } })
  for (const name of names.filter((name) => values[name] !== undefined)) {
    if (!/^[1-9]\d*$/.test(values[name]))
      throw new Stop(`Expected a whole number of --${name} from 1, got ${values[name]}.`)
    values[name] = Number(values[name])
  }
  return { ...values }
}

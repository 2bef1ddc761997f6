// The table at the end of `npm test`: what each step took, and all of it beside the limit.
import { bad, good, say } from './terminal.mjs'

const clock = (milliseconds) => {
  const seconds = Math.round(milliseconds / 1000)
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, '0')}`
}

/** `results` are [{ title, passed, time }] in milliseconds; `limit`, in minutes, is null where only a part was run. */
export function printTimes(results, total, limit) {
  const width = Math.max(...results.map(({ title }) => title.length))
  const line = (title, time) => `${title.padEnd(width)} ${clock(time).padStart(6)}`
  for (const { title, passed, time } of results) (passed ? good : bad)(line(title, time))
  say(`  ${line('Total', total)}${limit ? ` of ${limit}:00 on two quiet cores` : ''}`)
}

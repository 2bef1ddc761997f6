// The table at the end of `npm test`: the time of each step, and the total beside the limit.
import { bad, good, say } from './terminal.mjs'

const clock = (milliseconds) => {
  const seconds = Math.round(milliseconds / 1000)
  return `${Math.floor(seconds / 60)}:${String(seconds % 60).padStart(2, '0')}`
}

/** `results` are [{ title, passed, notRun, time }] in milliseconds; `limit` is in minutes, or null if only some groups ran. */
export function printTimes(results, total, limit) {
  const width = Math.max(...results.map(({ title }) => title.length))
  const line = (title, time) => `${title.padEnd(width)} ${clock(time).padStart(6)}`
  for (const { title, passed, notRun, time } of results)
    if (notRun) say(`- ${line(title, time)}  NOT RUN: ${notRun}`)
    else (passed ? good : bad)(line(title, time))
  say(`  ${line('Total', total)}${limit ? ` of ${limit}:00 on two quiet cores` : ''}`)
}

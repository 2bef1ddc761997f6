// Checks and error messages for output files.
import { stat } from 'node:fs/promises'
import { WarpError } from '../errors/errors.js'

/** Runs `work`, which writes `file`. Throws a `WarpError` with the reason if the file cannot be written. */
export async function withWriteErrors(file: string, work: () => Promise<void>): Promise<void> {
  try {
    await work()
  } catch (error) {
    const { code } = error as { code?: string }
    throw new WarpError(`${file} cannot be written: ${reasonOf(code)}.`)
  }
}

/** Returns the reason that the code of a system error stands for, as the end of a message. */
export function reasonOf(code: string | undefined): string {
  if (code === 'ENOENT') return 'the folder does not exist'
  if (code === 'ENOSPC') return 'the disk is full'
  return `the system reports ${code}`
}

/** Returns whether both names refer to the same file, directly or through links. */
export async function areSameFile(a: string, b: string): Promise<boolean> {
  const [first, second] = await Promise.all([identityOf(a), identityOf(b)])
  return first !== undefined && first === second
}

/** Returns a string that is unique for a file; `undefined` if it does not exist. */
async function identityOf(file: string): Promise<string | undefined> {
  try {
    const { dev, ino } = await stat(file, { bigint: true })
    return `${dev} ${ino}`
  } catch {
    return undefined
  }
}

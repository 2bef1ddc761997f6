// Files that are written: where they may not be, and what can go wrong with them.
import { stat } from 'node:fs/promises'
import { WarpError } from '../errors/errors.js'

export async function writing(file: string, work: () => Promise<void>): Promise<void> {
  try {
    await work()
  } catch (error) {
    const { code } = error as { code?: string }
    throw new WarpError(`${file} cannot be written: ${reasonOf(code)}.`)
  }
}

export function reasonOf(code: string | undefined): string {
  if (code === 'ENOENT') return 'there is no such folder'
  if (code === 'ENOSPC') return 'there is no room left'
  return `the system says ${code}`
}

/** Whether both names lead to one file, by whatever links. */
export async function areOneFile(a: string, b: string): Promise<boolean> {
  const [first, second] = await Promise.all([identityOf(a), identityOf(b)])
  return first !== undefined && first === second
}

async function identityOf(file: string): Promise<string | undefined> {
  try {
    const { dev, ino } = await stat(file, { bigint: true })
    return `${dev} ${ino}`
  } catch {
    return undefined
  }
}

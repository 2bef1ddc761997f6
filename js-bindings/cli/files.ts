// What can go wrong with a file that is written.
import { WarpError } from '../errors.js'

export async function writing(file: string, work: () => Promise<void>): Promise<void> {
  try {
    await work()
  } catch (error) {
    const { code } = error as { code?: string }
    const reason = code === 'ENOENT' ? 'there is no such folder' : `the system says ${code}`
    throw new WarpError(`${file} cannot be written: ${reason}.`)
  }
}

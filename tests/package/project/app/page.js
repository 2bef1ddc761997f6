import { tryAll } from '../program.js'
import { Sketch } from './sketch.js'

export default async function Page() {
  return (
    <main>
      <p>{await tryAll()}</p>
      <Sketch />
    </main>
  )
}

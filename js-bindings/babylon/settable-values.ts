// The property `values` of a warp: by name the value of each uniform, which may be set.
import type { HostWarp } from '../compile/hosts.js'

/** Throws a `WarpError` for a name that is none, and for what cannot be such a value. */
export const settableValues = (uniforms: HostWarp['uniforms']): Record<string, unknown> =>
  new Proxy(
    Object.defineProperties(
      {},
      Object.fromEntries(
        uniforms.names.map((name) => [
          name,
          {
            enumerable: true,
            get: () => uniforms.given(name),
            set: (value: unknown) => uniforms.set(name, value),
          },
        ]),
      ),
    ),
    {
      set(_, name, value) {
        uniforms.set(String(name), value)
        return true
      },
    },
  )

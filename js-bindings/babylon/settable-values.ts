// Makes the property `values` of a warp, an object that maps the names of uniforms → their values, and whose properties can be assigned.
import type { HostWarp, UniformOverrides } from '../compile/hosts.js'

export type SettableValues<Uniforms> = {
  -readonly [Name in keyof Uniforms]:
    Required<UniformOverrides<Uniforms>>[Name] | (() => Required<UniformOverrides<Uniforms>>[Name])
}

/** Makes the object. An assignment throws a `WarpError` for an unknown name and for a value of another type. */
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

// Makes the property `values` of a warp: it maps the names of uniforms → their values, which can be assigned.
import type { HostWarp, UniformOverrides } from '../compile/hosts.js'

export type SettableValues<Uniforms> = {
  -readonly [Name in keyof Uniforms]:
    Required<UniformOverrides<Uniforms>>[Name] | (() => Required<UniformOverrides<Uniforms>>[Name])
}

/** Setting throws a `WarpError` for an unknown name and for a value of another type. */
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

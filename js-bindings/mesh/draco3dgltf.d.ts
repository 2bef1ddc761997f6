// The package has no types of its own.
declare module 'draco3dgltf' {
  export function createDecoderModule(options?: object): Promise<unknown>
}

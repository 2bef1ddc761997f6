// Attributes of geometries of three.js.
import type { BufferAttribute, InterleavedBufferAttribute } from 'three'

export type Attribute = BufferAttribute | InterleavedBufferAttribute

/** Returns a number that changes with the values; -1 for a missing attribute. */
export const versionOf = (attribute: Attribute | undefined) =>
  attribute ? ('data' in attribute ? attribute.data.version : attribute.version) : -1

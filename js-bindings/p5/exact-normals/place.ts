import { Place } from '../../options/place.js'

/** The call that messages are about. */
export const place = new Place('exactNormals')

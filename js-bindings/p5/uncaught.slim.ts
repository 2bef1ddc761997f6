/** `uncaught.ts` for the slim script, which leaves it out. */
export const tellWhatIsUncaught = () => {}

/** Lines of the command palette that are shown at most. */
export const LINES = 60;
